"""When memory is too low, the C library and the Python package say so, keep nothing, and go on working.

    LD_PRELOAD=build/native/tests/libfailing_new.so EVENLIFT_LIBRARY=build/native/c/libevenlift.so python3 check_no_memory.py

The allocations of each request fail in turn: each of the first two hundred, then one for every hundredth part more, until a
request needs no more; with --each, all of them, which takes seven minutes.
"""

import ctypes
import json
import os
import pathlib
import shutil
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
library = pathlib.Path(os.environ["EVENLIFT_LIBRARY"]).resolve()
memory = ctypes.CDLL(None)
memory.fail_at.argtypes = [ctypes.c_long]
memory.count_alive.restype = memory.count_calls.restype = ctypes.c_long

plate = [[0, 0], [160, 0], [160, 90], [90, 90], [90, 60], [0, 60]]
hole = [[[100, 20], [130, 20], [130, 40], [100, 40]]]
cargo = [{"at": [120, 70], "weight": 5, "name": "motor"}]
requests = [
    {"command": "version"},
    {"polygon": plate, "settings": {"teams": 2}},
    {"polygon": plate, "holes": hole, "failures": True, "candidates": True, "require": "held, max<=60",
     "settings": {"teams": 2, "cargo": cargo, "capacity": 40, "com_radius": 2, "slope": "4%", "com_height": 10}},
    {"polygon": plate, "settings": {"metric": "balanced", "robots": 4}},
    {"polygon": plate, "settings": {"metric": "random", "teams": 2, "robot": "r=3,reach=1", "no_go": "2"}},
    {"polygon": plate, "settings": {"supports": [[10, 0], [150, 0], [100, 90]]}},
    {"polygon": plate, "settings": {"teams": 2, "positions": "range", "goal": "hold"}},
    {"command": "svg", "polygon": plate, "settings": {"teams": 2}},
    {"command": "poses", "polygon": plate, "settings": {"teams": 1}, "format": "yaml"},
    {"command": "candidates", "polygon": plate},
    {"command": "link", "polygon": plate},
    {"command": "experiment", "polygons": [{"polygon": plate}], "settings": {"samples": 1, "max_teams": 2, "max_balanced": 2}},
    {"text": "POLYGON ((0 0, 4 0, 4 3, 0 0))"},
    {"text": '{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 0]]]}'},
    {"polygon": [[0, 0], [4, 4], [4, 0], [0, 4]]},
]  # fmt: skip


def fails_in_turn(what, call, is_refused):
    """Calls until no allocation fails. Returns how many failed."""
    call()
    call()  # what is computed once is there now
    expected = call()
    failed, number = 0, 1
    while True:
        before = memory.count_alive()
        memory.fail_at(number)
        answer = call()
        was_last = memory.count_calls() < number
        memory.fail_at(0)
        if memory.count_alive() != before:
            sys.exit(f"{what}: {memory.count_alive() - before} allocations are left after number {number} failed")
        if was_last:
            return failed
        if answer != expected and not is_refused(answer):  # sorting goes on with less memory
            sys.exit(f"{what}: the answer is {answer!r:.200} after number {number} failed")
        failed += 1
        number += 1 if "--each" in sys.argv else max(1, number // 100)


def check_c():
    shared = ctypes.CDLL(str(library))
    shared.evenlift_run.argtypes, shared.evenlift_run.restype = [ctypes.c_char_p], ctypes.c_void_p
    shared.evenlift_free.argtypes = [ctypes.c_void_p]

    def run(request):
        at = shared.evenlift_run(request)
        answer = ctypes.string_at(at)
        shared.evenlift_free(at)
        return answer

    total = 0
    for request in requests:
        text = json.dumps(request).encode()
        total += fails_in_turn(text[:60], lambda text=text: run(text), lambda answer: json.loads(answer)["error"]["code"] == "no_memory")
    return total


def check_python():
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(root / "python/src/evenlift", pathlib.Path(folder) / "evenlift", ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copy(library, pathlib.Path(folder) / "evenlift/libevenlift.so")
        sys.path.insert(0, folder)
        import evenlift

        def coverage():
            try:
                return evenlift.place(plate, teams=2)["coverage"]
            except MemoryError:
                return None

        return fails_in_turn("place() in Python", coverage, lambda answer: answer is None)


print(f"{check_c()} allocations failed in C and {check_python()} in Python, and nothing was left")
