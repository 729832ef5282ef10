"""Uses the installed package `evenlift`, and compares it with the program. check_python.py runs it.

    python3 usage.py PROGRAM SAMPLE...
"""

import csv
import inspect
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import threading

import bad_input
import contract
import evenlift
import numpy

program, *files = sys.argv[1:]
samples = [pathlib.Path(file) for file in files]
l_shape = [(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 3), (0, 3)]


def printed(*arguments):
    return subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, check=True).stdout.decode()


def check_bytes():
    """The same bytes as the program, for every sample, by several methods."""
    ways = [
        ({}, []),
        ({"metric": "balanced", "robots": 5}, ["--metric", "balanced", "--robots", 5]),
        ({"metric": "distributed", "teams": 4, "weight": 30.5}, ["--metric", "distributed", "--teams", 4, "--weight", 30.5]),
        ({"teams": "max", "unit": "mm"}, ["--teams", "max", "--unit", "mm"]),
    ]
    for i, sample in enumerate(samples):
        settings, options = ways[i % len(ways)]
        text = sample.read_text()
        placement = evenlift.place(text, **settings)
        assert placement.json == printed("place", sample, "--json", *options), sample.name
        assert placement == json.loads(placement.json) and isinstance(placement, dict)
        # The same polygon as points, with the text's centre of mass.
        named = [line for line in text.splitlines() if line.startswith("CoM:")]
        centre = placement["centre_of_mass"] if named else None
        assert evenlift.place(numpy.array(placement["polygon"]), centre_of_mass=centre, **settings).json == placement.json, sample.name
        if i % 4 == 0:
            listed = printed("place", sample, "--json", "--candidates", *options)
            assert evenlift.candidates(text, **settings) == json.loads(listed)["candidates"], sample.name
            assert evenlift.place(text, candidates=True, **settings).json == listed


def check_files():
    """Pictures, poses and links are those of the program."""
    with tempfile.TemporaryDirectory() as folder:
        for sample in samples[::10]:
            text = sample.read_text()
            for ending in ("svg", "csv", "json", "yaml"):
                option = "--svg" if ending == "svg" else "--poses"
                file = pathlib.Path(folder) / f"out.{ending}"
                printed("place", sample, option, file)
                made = evenlift.svg(text) if ending == "svg" else evenlift.poses(text, format=ending)
                assert made == file.read_text(), f"{sample.name}: {ending}"
            assert evenlift.place(text)._repr_svg_() == (pathlib.Path(folder) / "out.svg").read_text()
            assert evenlift.link(text) + "\n" == printed("link", "encode", sample)


def check_arrays():
    placement = evenlift.place(l_shape, teams=3, weight=30)
    arrays = placement.arrays()
    assert arrays["at"].shape == (6, 2) and arrays["polygon"].shape == (6, 2)
    assert arrays["load"].dtype == float and math.isclose(arrays["load"].sum(), 30)
    # The robots carry the weight without turning the object.
    centre = numpy.array(placement["centre_of_mass"])
    assert numpy.allclose((arrays["load"][:, None] * (arrays["at"] - centre)).sum(axis=0), 0)
    assert arrays["team"].tolist() == [0, 0, 1, 1, 2, 2]
    weighed = evenlift.place("0,0 1,0 1,1 0,1".replace(" ", "\n"), supports="0,0 1,0 1,1 0,1", readings=[10, 20, 30, 40])
    assert weighed["weighing"]["centre_of_mass"] == [0.5, 0.7] and weighed["total_weight"] == 100
    chords = evenlift.candidates(l_shape)
    assert chords.arrays()["ends"].shape == (len(chords), 2, 2)
    assert (chords.arrays()["ratio"] >= 0.8 - 1e-9).all()


def check_experiment():
    """The tables that the program writes, byte for byte."""
    names = ["square", "thesis-sample", "arrow"]
    chosen = {sample.stem: sample for sample in samples if sample.stem in names}
    assert len(chosen) == 3
    options = {"samples": 5, "max_teams": 3, "max_balanced": 4}
    with tempfile.TemporaryDirectory() as folder:
        polygons = pathlib.Path(folder) / "polygons"
        polygons.mkdir()
        for name, sample in chosen.items():
            (polygons / f"{name}.txt").write_text(sample.read_text())
        printed("experiment", polygons, "--out", f"{folder}/out", "--samples", 5, "--max-teams", 3, "--max-balanced", 4)
        result = evenlift.experiment({name: sample.read_text() for name, sample in chosen.items()}, **options)
        for table in ("measurements", "aggregates", "polygons"):
            assert result.csv(table) == (pathlib.Path(folder) / f"out/{table}.csv").read_bytes().decode(), table
            assert len(result[table]) == len(list(csv.DictReader(io.StringIO(result.csv(table)))))
        columns = result.arrays()
        assert len(columns["coverage"]) == len(result["measurements"]) and 0 <= columns["coverage"].min()
        assert result["measurements"][0]["robots"] == 2
    bad = evenlift.experiment([l_shape, "POLYGON ("], samples=1, max_teams=1, max_balanced=2)
    assert [each["polygon"] for each in bad["refused"]] == ["polygon 2"]


def check_threads():
    expected = evenlift.place(l_shape).json
    answers = []
    threads = [threading.Thread(target=lambda: answers.append(evenlift.place(l_shape).json)) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert answers == [expected] * 8


def main():
    assert f"evenlift {evenlift.__version__}\n" == printed("--version")
    assert inspect.getdoc(evenlift.place)
    bad_input.check()
    contract.check(samples)
    check_bytes()
    check_files()
    check_arrays()
    check_experiment()
    check_threads()
    print("the package agrees with the program")


if __name__ == "__main__":  # not in processes of pools, which also read this file
    main()
