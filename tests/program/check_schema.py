"""Validates what goes in and comes out against `evenlift --schema`, with an ordinary validator (python3-jsonschema).

    python3 tests/program/check_schema.py PROGRAM LIBRARY
"""

import copy
import ctypes
import json
import pathlib
import re
import subprocess
import sys

import jsonschema

program, library = sys.argv[1:]
root = pathlib.Path(__file__).resolve().parents[2]
square = [[0, 0], [4, 0], [4, 3], [0, 3]]

loaded = ctypes.CDLL(library)
loaded.evenlift_run.argtypes, loaded.evenlift_run.restype = [ctypes.c_char_p], ctypes.c_char_p


def answer(request):
    return json.loads(loaded.evenlift_run(json.dumps(request).encode()))


def printed(*arguments):
    done = subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


schema = json.loads(subprocess.run([program, "--schema"], stdout=subprocess.PIPE, check=True).stdout)
validator = jsonschema.Draft202012Validator
validator.check_schema(schema)


def faults(value, name):
    of = validator({**schema, "$ref": f"#/$defs/{name}"})
    return [f"{'.'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in of.iter_errors(value)]


problems = []


def check(value, name, what):
    problems.extend(f"{what} is no {name}: {each}" for each in faults(value, name))


def check_placements():
    samples = sorted((root / "assets/polygons").glob("*.txt"))
    ways = [
        [],
        ["--failures", "--candidates", "--capacity", 20, "--com-radius", 5],
        ["--metric", "balanced", "--robots", 5, "--require", "held, max<=20"],
        ["--positions", "range", "--goal", "hold", "--clear", 1],
        ["--robot", "r=3,reach=2", "--no-go", "1:0.25-0.75", "--teams", 2],
        ["--com-height", 9, "--slope", "8%", "--acceleration", 0.1, "--give", 3, "--uneven", 1, "--extra", 20, "--failures"],
        ["--unit", "mm", "--weight-unit", "lb", "--cargo", "8,8:24:motor", "--accuracy", 0.1],
        ["--metric", "random", "--seed", 2**64 - 1, "--teams", "1"],
    ]
    names = [name for name in samples if name.name != "index.txt"]
    for i, sample in enumerate(names):
        check(printed("place", sample, "--json", *ways[i % len(ways)]), "Placement", f"{sample.stem} {ways[i % len(ways)]}")
    for file in sorted((root / "tests/expected").glob("*.json")):
        check(json.loads(file.read_text()), "Placement", file.name)
    supports = ["--supports", "0,0@30 1000,0 900,1000 0,1000", "--even-out", "--json"]
    check(printed("place", root / "assets/polygons/square.txt", *supports), "Placement", "supports")
    check(printed("place", root / "assets/polygons/square.txt", "--supports", "0,0 0,10", "--json"), "Placement", "falling")


def check_other_answers():
    for request, name in [
        ({"command": "optimum", "polygon": square, "goal": "hold", "positions": "range"}, "Optimum"),
        ({"command": "shapes", "text": "POLYGON((0 0,1 0,1 1,0 0))"}, "Shapes"),
        ({"command": "experiment", "polygons": [{"polygon": square}], "settings": {"samples": 1, "max_teams": 2, "max_balanced": 3}}, "Experiment"),
        ({"polygon": [*square, [0, 0]], "even_out": False}, "Placement"),
    ]:
        check(answer(request), name, str(request)[:60])
    for bad in [{"polygon": [[0, 0], [1]]}, {"text": "("}, {"polygon": square, "teams": 0}, {"text": "1.x"}, {}, {"polygon": square[:2] * 2}]:
        check(answer(bad)["error"], "Error", f"the error of {bad}")


def check_requests():
    """Those of the manual, and each setting's text and number as requests take them."""
    manual = (root / "docs/requests.md").read_text(encoding="utf-8")
    found = [json.loads(block) for block in re.findall(r"```json\n(.*?)```", manual, re.DOTALL)]
    found = [each for each in found if "polygon" in each]
    if not found:
        problems.append("docs/requests.md has no request")
    found += [
        {"polygon": square, "settings": {"cargo": [{"at": [1, 1], "weight": 3}, [[1, 1], 2, "a"]], "supports": [[0, 0], {"at": [4, 0], "capacity": 3}]}},
        {"text": "x", "teams": "max", "overlays": ["hull"], "no_go": [1, "2:0-0.5"], "robot": {"radius": 0, "reach": 0, "depth": 0, "width": 0, "gap": 1}},
        {"document": {}, "command": "svg", "candidates": True, "holes": False, "centre_of_mass": None, "capacity": None, "slope": "8%"},
    ]
    for request in found:
        check(request, "Request", str(request)[:80])


def check_faults():
    """The schema refuses what is wrong."""
    good = printed("place", root / "assets/polygons/square.txt", "--json")
    for change in (
        lambda it: it.pop("hull"),
        lambda it: it.update(news=1),
        lambda it: it["loads"].pop("max"),
        lambda it: it["verdict"].update(kind="fine"),
        lambda it: it["polygon"].append([1, 2, 3]),
        lambda it: it["robots"][0].update(team=0.5),
    ):
        bad = copy.deepcopy(good)
        change(bad)
        if not faults(bad, "Placement"):
            problems.append("the schema does not see a fault")
    for bad in ({"polygon": square, "tems": 3}, {"polygon": [[0]]}, {"polygon": square, "teams": True}, {"polygon": square, "weight": [5]}):
        if not faults(bad, "Request"):
            problems.append(f"the schema takes {bad}")


check_placements()
check_other_answers()
check_requests()
check_faults()
for problem in problems[:20]:
    print(problem)
sys.exit(1 if problems else print("the schema describes all that goes in and comes out"))
