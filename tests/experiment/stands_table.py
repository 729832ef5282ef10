#!/usr/bin/env python3
"""The number of placements that robots of a radius can carry out: the table and the figure of docs/experiments.md.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/experiment/stands_table.py [--jobs N] [--update]

A placement of points can be carried out if a disc of the radius can touch each lifting point from outside, along the
inward normal (at a vertex the middle one), without overlapping the object, and no two of these discs overlap. This
file computes that, not the program. "Made to fit" is a placement by area with --robot r=R, at the best positions or
in ranges: it counts if the program places all teams. --update writes a part of the printed table into
docs/experiments.md, and the figure to docs/pictures/stands.svg.
"""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("EVENLIFT_PROGRAM", str(ROOT / "build" / "bin" / "evenlift"))
SETS = ["polygons", "thesis-like"]
PERCENT = [0, 1, 2, 3, 4, 5]  # of the diagonal of the bounding box
ROBOTS = [4, 6, 8]
MADE_TO_FIT = {"area, made to fit": "best", "area, made to fit in ranges": "range"}  # with their positions
ROWS = ["area", "circle", "distance", "distributed", "balanced", "area, made to fit", "area, made to fit in ranges"]
MANUAL_ROWS = [row for row in ROWS if row not in ("circle", "distance")]  # which come close to area
MANUAL_SETS = SETS[:1]
MANUAL_ROBOTS = [4, 8]
MANUAL_PERCENT = [1, 3, 5]


def placed(path, *options):
    done = subprocess.run([PROGRAM, "place", str(path), "--json", *options], capture_output=True, text=True, check=False)
    if done.returncode == 2 and "no edge has room" in done.stderr:
        return None
    if done.returncode:
        raise SystemExit(done.stderr)
    return json.loads(done.stdout)


def to_segment(s, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    part = ((s[0] - a[0]) * dx + (s[1] - a[1]) * dy) / (dx * dx + dy * dy)
    part = min(1, max(0, part))
    return math.hypot(s[0] - a[0] - part * dx, s[1] - a[1] - part * dy)


def can_be_carried_out(vertices, robots, radius, size):
    if radius == 0:
        return True
    near = 1e-7 * size
    edges = list(zip(vertices, vertices[1:] + vertices[:1]))
    discs = []
    for robot in robots:
        heading = math.radians(robot["heading"])
        s = (robot["at"][0] - radius * math.cos(heading), robot["at"][1] - radius * math.sin(heading))
        if any(to_segment(s, a, b) < radius - near for a, b in edges):
            return False
        if any(math.dist(s, other) < 2 * radius - near for other in discs):
            return False
        discs.append(s)
    return True


def measure(path):
    """For each row, number of robots and radius: 1 or 0, or nothing if this number cannot be placed even as points."""
    found = {}
    first = placed(path, "--teams", "4")
    vertices = first["polygon"]
    xs, ys = zip(*vertices)
    size = math.hypot(max(xs) - min(xs), max(ys) - min(ys))

    def add(row, count, robots):
        for percent in PERCENT:
            found[row, count, percent] = can_be_carried_out(vertices, robots, percent / 100 * size, size)

    for metric in ["area", "circle", "distance"]:
        result = first if metric == "area" else placed(path, "--teams", "4", "--metric", metric)
        for count in ROBOTS:
            if len(result["robots"] if result["teams"] else []) >= count:
                add(metric, count, result["robots"][:count])  # t teams are the first t of all
    for count in ROBOTS:
        result = placed(path, "--teams", str(count // 2), "--metric", "distributed")
        if result["teams"]:
            add("distributed", count, result["robots"])
        if len(vertices) <= 130:
            result = placed(path, "--metric", "balanced", "--robots", str(count))
            if result["teams"]:
                add("balanced", count, result["robots"])
    for percent in PERCENT:
        options = ["--robot", f"r={percent / 100 * size!r}"] if percent else []
        for row, positions in MADE_TO_FIT.items():
            result = placed(path, "--teams", "4", "--positions", positions, *options)
            for count in ROBOTS:
                if ("area", count, 0) in found:
                    found[row, count, percent] = result is not None and 2 * len(result["teams"]) >= count
    return found


def table(means, sets=SETS, rows=ROWS, counts=ROBOTS, percents=PERCENT):
    lines = []
    for name in sets:
        lines += [f"| {name}, % | robots | " + " | ".join(f"r = {p} %" for p in percents) + " | polygons |",
                  "| --- | --- |" + " --- |" * (len(percents) + 1)]
        for row in rows:
            for count in counts:
                values = [means[name, row, count, p] for p in percents]
                lines.append(f"| {row} | {count} | " + " | ".join(f"{100 * v:.0f}" for v, _ in values) + f" | {values[0][1]} |")
        lines.append("")
    return "\n".join(lines)


COLOURS = {"area": "#2F6FDE", "distributed": "#B0572B", "balanced": "#8A3FA0", "area, made to fit": "#1F7A4E",
           "area, made to fit in ranges": "#C28A00"}


def figure(means, count=8):
    """Two panels, one for each set: the share that can be carried out against the radius."""
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="760" height="330" viewBox="0 0 760 330" font-family="Inter, Helvetica, Arial, sans-serif" font-size="13">',
             f"<title>Placements of {count} robots that can be carried out, against their radius</title>",
             '<rect width="760" height="330" fill="#FFFFFF"/>']
    for panel, name in enumerate(SETS):
        left, top, width, height = 52 + 370 * panel, 40, 300, 200
        at = lambda p, v: (left + width * p / PERCENT[-1], top + height * (1 - v))  # noqa: E731
        parts.append(f'<text x="{left}" y="24" font-weight="600">{name}</text>')
        for share in (0, 0.25, 0.5, 0.75, 1):
            y = at(0, share)[1]
            parts.append(f'<path d="M{left} {y}h{width}" stroke="#D5DBE1"/><text x="{left - 6}" y="{y + 4}" text-anchor="end" fill="#55616D">{100 * share:.0f}</text>')
        for p in PERCENT:
            parts.append(f'<text x="{at(p, 0)[0]}" y="{top + height + 18}" text-anchor="middle" fill="#55616D">{p}</text>')
        parts.append(f'<text x="{left + width / 2}" y="{top + height + 38}" text-anchor="middle" fill="#55616D">radius, % of the diagonal</text>')
        for row, colour in COLOURS.items():
            points = " ".join("{:.1f},{:.1f}".format(*at(p, means[name, row, count, p][0])) for p in PERCENT)
            parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>')
    x = 52
    for row, colour in COLOURS.items():
        parts.append(f'<path d="M{x} 306h22" stroke="{colour}" stroke-width="3"/><text x="{x + 28}" y="310">{row}</text>')
        x += 52 + 7 * len(row)
    return "\n".join(parts) + "\n</svg>\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    means = {}
    for name in SETS:
        paths = sorted(p for p in (ROOT / "assets" / name).glob("*.txt") if p.stem != "index")
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            found = list(pool.map(measure, paths))
        for row in ROWS:
            for count in ROBOTS:
                for percent in PERCENT:
                    values = [f[row, count, percent] for f in found if (row, count, percent) in f]
                    means[name, row, count, percent] = (sum(values) / max(len(values), 1), len(values))
    print(table(means))
    if not arguments.update:
        return
    page = ROOT / "docs/experiments.md"
    begin, end = "<!-- stands_table.py -->\n", "<!-- end of stands_table.py -->"
    before, rest = page.read_text().split(begin)
    page.write_text(before + begin + table(means, MANUAL_SETS, MANUAL_ROWS, MANUAL_ROBOTS, MANUAL_PERCENT) + end + rest.split(end)[1])
    (ROOT / "docs/pictures/stands.svg").write_text(figure(means))


sys.exit(main())
