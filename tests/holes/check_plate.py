#!/usr/bin/env python3
"""Laser-cut plates with twelve holes and a motor, read from DXF drawings, against an independent computation.

    python3 tests/holes/check_plate.py build/bin/evenlift [--cases N] [--seed S]

The plate has round corners, eleven round holes and a slot. Areas and centres of mass are compared with the exact values
of the circles that the drawing has, within what flattening them costs; and with the exact values of the polygon that
the program prints, within rounding. Its coverage is compared with exact clipping.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "supports"))

from check_supports import convex_hull, cross, minus, twice_area  # noqa: E402


def line(a, b):
    return f"0\nLINE\n8\ncut\n10\n{a[0]}\n20\n{a[1]}\n11\n{b[0]}\n21\n{b[1]}\n"


def arc(centre, radius, start, end):
    return f"0\nARC\n8\ncut\n10\n{centre[0]}\n20\n{centre[1]}\n40\n{radius}\n50\n{start}\n51\n{end}\n"


def circle(centre, radius):
    return f"0\nCIRCLE\n8\ncut\n10\n{centre[0]}\n20\n{centre[1]}\n40\n{radius}\n"


class Plate:
    """A drawing, with its exact area and first moments as floats."""

    def __init__(self, rng):
        w, h, r = rng.randint(800, 1600), rng.randint(500, 700), rng.randint(10, 60)
        self.size = (w, h)
        cuts = [line((r, 0), (w - r, 0)), line((w, r), (w, h - r)), line((w - r, h), (r, h)), line((0, h - r), (0, r))]
        cuts += [
            arc(c, r, start, start + 90)
            for c, start in (((w - r, r), 270), ((w - r, h - r), 0), ((r, h - r), 90), ((r, r), 180))
        ]
        # Each round corner takes a square less a quarter circle, symmetrically.
        area = w * h - (4 - math.pi) * r * r
        pieces = [(area, w / 2, h / 2)]
        for i in range(11):  # in a grid of 4 x 3, whose last cell has the slot
            cell = (w * (i % 4 + 0.5) / 4, h * (i // 4 + 0.5) / 3)
            radius = rng.randint(5, 60)
            centre = tuple(round(c + rng.uniform(-8, 8), 2) for c in cell)
            cuts.append(circle(centre, radius))
            pieces.append((-math.pi * radius**2, *centre))
        x, y, long, half = round(w * 3.5 / 4, 1), round(h * 2.5 / 3, 1), rng.randint(20, 60), rng.randint(5, 20)
        cuts += [line((x - long, y - half), (x + long, y - half)), line((x + long, y + half), (x - long, y + half))]
        cuts += [arc((x + long, y), half, 270, 90), arc((x - long, y), half, 90, 270)]
        pieces.append((-(4 * long * half + math.pi * half**2), x, y))
        self.area = sum(a for a, _, _ in pieces)
        self.centroid = tuple(sum(piece[0] * piece[k] for piece in pieces) / self.area for k in (1, 2))
        rng.shuffle(cuts)
        self.drawing = "0\nSECTION\n2\nENTITIES\n" + "".join(cuts) + "0\nENDSEC\n0\nEOF\n"


def exact(points):
    """A counter-clockwise ring."""
    ring = [tuple(Fraction(x) for x in p) for p in points]
    return ring if twice_area(ring) > 0 else ring[::-1]


def moments(ring):
    """Twice the area, and six times the first moments, of a counter-clockwise ring."""
    pairs = list(zip(ring, ring[1:] + ring[:1]))
    crosses = [a[0] * b[1] - a[1] * b[0] for a, b in pairs]
    return [sum(crosses)] + [sum(c * (a[k] + b[k]) for c, (a, b) in zip(crosses, pairs)) for k in (0, 1)]


def clipped(ring, hull):
    """The part of a ring within a convex counter-clockwise polygon."""
    for a, b in zip(hull, hull[1:] + hull[:1]):
        side = [cross(minus(b, a), minus(p, a)) for p in ring]
        kept = []
        for i, p in enumerate(ring):
            q, at_p, at_q = ring[(i + 1) % len(ring)], side[i], side[(i + 1) % len(ring)]
            if at_p >= 0:
                kept.append(p)
            if (at_p > 0) != (at_q > 0) and at_p != 0 and at_q != 0:
                t = at_p / (at_p - at_q)
                kept.append(tuple(u + t * (v - u) for u, v in zip(p, q)))
        ring = kept
    return abs(twice_area(ring)) if len(ring) > 2 else Fraction(0)


def near(name, found, expected, allowed):
    if abs(Fraction(found) - Fraction(expected)) > allowed:
        sys.exit(f"{name} is {float(found)!r}, and should be {float(expected)!r}")


def check(program, rng, folder):
    plate = Plate(rng)
    drawing = folder / "plate.dxf"
    drawing.write_text(plate.drawing, encoding="ascii")
    weight, motor = rng.randint(20, 90), round(rng.uniform(5, 40), 2)
    at = [round(s * rng.uniform(0.1, 1.1), 1) for s in plate.size]  # it may overhang
    run = subprocess.run(
        [program, "place", drawing, "--weight", str(weight), "--cargo", f"{at[0]},{at[1]}:{motor}:motor", "--json"],
        capture_output=True, text=True, encoding="utf-8",
    )  # fmt: skip
    if run.returncode and "is not inside the convex hull" in run.stderr:
        return False
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    result = json.loads(run.stdout)
    outline, holes = exact(result["polygon"]), [exact(hole) for hole in result["holes"]]
    if len(holes) != 12:
        sys.exit(f"the plate has {len(holes)} holes, and should have 12")

    cut_away = [moments(hole) for hole in holes]
    whole, *first = [m - sum(cut[k] for cut in cut_away) for k, m in enumerate(moments(outline))]
    own = [m / (3 * whole) for m in first]
    # Curves stay within a thousandth of the plate's longer side of their chords.
    off = max(plate.size) / 1000
    near("the area of the drawing", whole / 2, plate.area, Fraction(off) * sum(plate.size) / 4)
    for k in (0, 1):
        near("the centroid of the drawing", own[k], plate.centroid[k], Fraction(off) / 4)
        near("the object's own centre of mass", result["own_centre_of_mass"][k], own[k], Fraction(1, 10**9))
    total = Fraction(weight) + Fraction(motor)
    near("the weight", result["total_weight"], total, total / 10**12)
    centre = [(weight * own[k] + Fraction(motor) * Fraction(at[k])) / total for k in (0, 1)]
    for k in (0, 1):
        near("the centre of mass", result["centre_of_mass"][k], centre[k], Fraction(1, 10**9))
    loads = [Fraction(robot["load"]) for robot in result["robots"]]
    near("the sum of loads", sum(loads), total, total / 10**9)
    hull = exact(convex_hull(exact(robot["at"] for robot in result["robots"])))
    covered = clipped(outline, hull) - sum(clipped(hole, hull) for hole in holes)
    near("the coverage", result["coverage"], covered / whole, Fraction(1, 10**9))
    return True


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("program")
    options.add_argument("--cases", type=int, default=40)
    options.add_argument("--seed", type=int, default=1)
    asked = options.parse_args()
    rng = random.Random(asked.seed)
    with tempfile.TemporaryDirectory() as folder:
        placed = sum(check(asked.program, rng, pathlib.Path(folder)) for _ in range(asked.cases))
    if placed < asked.cases / 2:
        sys.exit(f"only {placed} of {asked.cases} plates could be lifted")
    print(f"{placed} plates agree")


main()
