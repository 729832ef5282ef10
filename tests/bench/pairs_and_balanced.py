"""Compares balanced robots with teams of two, measured over all samples: the share of sets in which any one robot may
fail so that the others carry the object, and so that the centre of mass also stays `clear` inside their lifting base
(steady).

    python3 tests/bench/pairs_and_balanced.py    EVENLIFT_PROGRAM names the program, build/bin/evenlift if it is not
    given
"""

import json
import os
import pathlib
import subprocess

root = pathlib.Path(__file__).resolve().parent.parent.parent
program = os.environ.get("EVENLIFT_PROGRAM", root / "build/bin/evenlift")
samples = sorted(file for file in (root / "assets/polygons").glob("*.txt") if file.name != "index.txt")

ways = [
    ("4 robots: pairs by area", 4, ["--teams", "2"]),
    ("4 robots: balanced", 4, ["--metric", "balanced", "--robots", "4"]),
    ("6 robots: pairs by area", 6, ["--teams", "3"]),
    ("6 robots: distributed", 6, ["--metric", "distributed", "--teams", "3"]),
    ("6 robots: balanced", 6, ["--metric", "balanced", "--robots", "6"]),
]


def placed(sample, options):
    return json.loads(subprocess.run([program, "place", sample, "--json", *options], capture_output=True, check=True).stdout)


def mean(values):
    return sum(values) / len(values)


def survivors(results, key):
    """The share of the results in which any one robot may fail."""
    return mean([100 * (result["robustness"][key] >= 1) for result in results])


print("| | objects | coverage | held | greatest − least load of 100 kg | carried after any one failure | steady after any one failure |")
print("| --- | --- | --- | --- | --- | --- | --- |")
for name, robots, options in ways:
    results = [placed(sample, options) for sample in samples]
    whole = [r for r in results if sum(len(team["ends"]) for team in r["teams"]) == robots]
    print(
        f"| {name} | {len(whole)} | {mean([100 * r['coverage'] for r in whole]):.0f} % "
        f"| {mean([100 * r['closure']['form_closure'] for r in whole]):.0f} % "
        f"| {mean([r['loads']['spread'] for r in whole]):.1f} kg "
        f"| {survivors(whole, 'failures_carried'):.0f} % | {survivors(whole, 'failures_clear'):.0f} % |"
    )
