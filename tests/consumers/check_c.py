"""Installs the C library, checks its exported names, and uses it from plain C.

    EVENLIFT_BUILD=build/native EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/consumers/check_c.py
"""

import json
import re
import shutil
import subprocess
import sys

from installed import Failed, compiler, expect, installed_into, library_folder, main, program, root, run, samples, version

words = (root / "tests/consumers/c/consumer.c").resolve()


def c_compiler():
    """The C compiler that belongs to the build's C++ compiler."""
    cxx, flags = compiler()
    name = cxx.rsplit("/", 1)[-1]
    c = {"c++": "cc"}.get(name, name.replace("clang++", "clang").replace("g++", "gcc"))
    return c, [flag for flag in flags if flag.startswith("-f")]


def check_symbols(library):
    """The library exports only the two functions, so no other name can conflict with a program's own."""
    shown = run("nm", "--dynamic", "--defined-only", "--extern-only", library).splitlines()
    names = sorted(line.split()[-1] for line in shown)
    expect(names == ["evenlift_free", "evenlift_run"], f"the library shows {names}")


def check_needs(library):
    """It depends only on the languages' own libraries."""
    needed = re.findall(r"NEEDED\s+(\S+)", run("objdump", "-p", library))
    own = re.compile(r"lib(stdc\+\+|c\+\+|c\+\+abi|m|gcc_s|c|asan|ubsan|pthread)\.so|ld-linux")
    expect(all(own.match(name) for name in needed), f"the library needs {needed}")


def compiled(prefix, folder):
    c, flags = c_compiler()
    use = run("pkg-config", "--cflags", "--libs", "evenlift-c", PKG_CONFIG_PATH=str(library_folder(prefix) / "pkgconfig")).split()
    header = folder / "header.c"
    header.write_text("#include <evenlift/evenlift.h>\n#include <evenlift/evenlift.h>\nint main(void) { return 0; }\n")
    for standard in ("c89", "c17"):
        run(c, f"-std={standard}", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", header, *use)
    consumer = folder / "consumer"
    run(c, "-std=gnu99", "-Wall", "-Wextra", "-Werror", *flags, words, "-pthread", "-o", consumer, *use, f"-Wl,-rpath,{library_folder(prefix)}")
    return consumer


def answers(consumer, *requests):
    done = subprocess.run([consumer, *requests], stdout=subprocess.PIPE, check=False)
    expect(done.returncode == 0, f"the consumer ended with {done.returncode}")
    return done.stdout.decode()


def check_answers(consumer):
    """The answers to `place` equal the program's output, for all options."""
    ways = [
        ({}, []),
        ({"settings": {"metric": "balanced", "robots": 5}, "failures": True}, ["--metric", "balanced", "--robots", "5", "--failures"]),
        ({"settings": {"teams": "max", "min_ratio": 0.9}, "candidates": True}, ["--teams", "max", "--min-ratio", "0.9", "--candidates"]),
        ({"settings": {"metric": "random", "seed": 18446744073709551615}}, ["--metric", "random", "--seed", "18446744073709551615"]),
        ({"settings": {"capacity": 12.5, "com_radius": 0.25}}, ["--capacity", "12.5", "--com-radius", "0.25"]),
        ({"settings": {"unit": "mm", "weight_unit": "lb", "weight": 1e3}}, ["--unit", "mm", "--weight-unit", "lb", "--weight", "1e3"]),
    ]
    for i, sample in enumerate(samples):
        asked, options = ways[i % len(ways)]
        request = json.dumps({"text": sample.read_text(), **asked})
        expect(
            answers(consumer, request) == run(program, "place", sample, "--json", *options),
            f"{sample.name}: the answer is not what the program prints with {options}",
        )


def check_weighing(consumer):
    """Readings, factors and cases are those of the program."""
    slab = root / "assets/polygons/stone-slab.txt"
    asked = {"supports": "330,20 1000,300 520,790 0,420", "readings": [30, 25, 20, 25], "reading_error": "1%", "dynamic": 1.2,
             "weight_doubt": 0.05, "capacity": 60}
    options = ["--supports", asked["supports"], "--readings", "30 25 20 25", "--reading-error", "1%", "--dynamic", "1.2",
               "--weight-doubt", "5%", "--capacity", "60", "--cases"]
    request = json.dumps({"text": slab.read_text(), "settings": asked, "cases": True})
    expect(answers(consumer, request) == run(program, "place", slab, "--json", *options), "the weighing is not the program's")


def check_errors(consumer):
    bad = {
        '{"polygon": [[0, 0], [4, 4], [4, 0], [0, 4]]}': ("edges_cross", "Edges 1 and 3 cross, touch or overlap", {"edges": [0, 2]}),
        '{"polygon": [[0, 0], [4, 0], [4, 3]], "settings": {"teams": 0}}': (
            "bad_setting", "The number of teams must be a whole number from 1 to 1048576, or max", {"setting": "teams"}),
        '{"polygon": [[0, 0], [4, 0], [4, 3]], "setings": {}}': (
            "bad_setting", 'There is no setting "setings"; did you mean "settings"?', {"setting": "setings"}),
        '{"command": "fly"}': (
            "unsupported", "The command must be place, candidates, svg, poses, link, optimum, trace, shapes, parts, experiment or version", {"setting": "command"}),
    }  # fmt: skip
    for request, (code, message, place) in bad.items():
        path = place.get("setting", "polygon[0]")
        error = {"code": code, "message": message, "place": place, "path": path}
        expect(json.loads(answers(consumer, request)) == {"error": error}, answers(consumer, request))


def check_memory(consumer):
    """With too little memory it reports an error and does not end the program."""
    points = [[i, i % 2 + 10 * (i // 100000)] for i in range(100000)]
    request = json.dumps({"polygon": points})
    file = consumer.parent / "limited.py"
    file.write_text(
        "import ctypes, json, resource, sys\n"
        "run = ctypes.CDLL(sys.argv[1]).evenlift_run\n"
        "run.restype, run.argtypes = ctypes.c_char_p, [ctypes.c_char_p]\n"
        "request = sys.stdin.buffer.read()\n"
        "used = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
        "resource.setrlimit(resource.RLIMIT_AS, (used + 4000000, used + 4000000))\n"
        "sys.stdout.write(json.loads(run(request))['error']['code'])\n"
    )
    library = next(library_folder(consumer.parent / "installed").glob("libevenlift.so"))
    done = subprocess.run([sys.executable, file, library], input=request.encode(), stdout=subprocess.PIPE, check=False)
    expect((done.returncode, done.stdout) == (0, b"no_memory"), f"without memory: {done.returncode}, {done.stdout}")


def check(folder):
    prefix = installed_into(folder)
    library = (library_folder(prefix) / "libevenlift.so").resolve()
    check_symbols(library)
    check_needs(library)
    consumer = compiled(prefix, folder)
    expect(answers(consumer) == "well\n", "the consumer is not well")
    expect(json.loads(answers(consumer, '{"command": "version"}')) == {"version": version()}, "another version")
    check_answers(consumer)
    check_weighing(consumer)
    check_errors(consumer)
    _, flags = c_compiler()
    if not any("sanitize" in flag for flag in flags):
        check_memory(consumer)
    return f"{len(samples)} samples"


sys.exit(main(check))
