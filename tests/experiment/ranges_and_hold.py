"""Measures the effect of positions anywhere in the range and of the goal to hold, and how far the greedy choice is from
the best.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/experiment/ranges_and_hold.py FOLDER...

Prints the tables of docs/experiments.md, for each folder: the share of all its polygons that is held with clearance,
in percent, and the mean coverage. If fewer teams find a place, these count.
"""

import json
import math
import os
import pathlib
import subprocess
import sys

program = os.environ.get("EVENLIFT_PROGRAM", "build/bin/evenlift")
ways = [("best places, to cover", []),
        ("best places, to hold", ["--goal", "hold"]),
        ("in ranges, to cover", ["--positions", "range"]),
        ("in ranges, to hold", ["--positions", "range", "--goal", "hold"])]


def asked(*arguments):
    result = subprocess.run([program, *map(str, arguments), "--json"], capture_output=True, text=True, check=True)
    return json.loads(result.stdout)


def polygons(folder):
    return sorted(f for f in pathlib.Path(folder).glob("*.txt") if f.stem != "index")


def mean(values):
    return 100 * sum(values) / len(values)


def is_held(result):
    """In form closure by contacts that are at least 0.02 R from every corner."""
    clearance, centre = result["closure"]["clearance"], result["centre_of_mass"]
    radius = max(math.dist(vertex, centre) for vertex in result["polygon"])
    return result["closure"]["form_closure"] and (clearance is None or clearance >= (0.02 - 1e-9) * radius)


def print_ways(files):
    print("| held, % / coverage, % | 2 teams | 3 | 4 |\n| --- | --- | --- | --- |")
    for name, options in ways:
        cells = []
        for teams in (2, 3, 4):
            results = [asked("place", f, "--teams", teams, *options) for f in files]
            cells.append(f"{mean([is_held(r) for r in results]):.1f} / "
                         f"{mean([r['coverage'] for r in results]):.1f}")
        print(f"| {name} | {' | '.join(cells)} |")


def print_optimum(files):
    print("| coverage, % | 2 teams | 3 | 4 |\n| --- | --- | --- | --- |")
    results = {t: [asked("optimum", f, "--teams", t, "--time-limit", 60) for f in files] for t in (2, 3, 4)}
    for name, value in (("greedy, by area", lambda r: r["greedy"]["coverage"]),
                        ("the best found", lambda r: r["optimum"]["coverage"]),
                        ("no choice covers more than", lambda r: r["optimum"]["bound"])):
        print(f"| {name} | {' | '.join(f'{mean([value(r) for r in rs]):.1f}' for rs in results.values())} |")
    proved = [f"{sum(r['optimum']['proved'] for r in rs)} of {len(rs)}" for rs in results.values()]
    print(f"| proved to be the best | {' | '.join(proved)} |")


for folder in sys.argv[1:]:
    files = polygons(folder)
    print(f"{folder}: {len(files)} polygons\n")
    print_ways(files)
    print()
    print_optimum(files)
    print()
