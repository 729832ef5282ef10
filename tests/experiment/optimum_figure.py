#!/usr/bin/env python3
"""Draws how far the greedy choice is from the best one, from the table in docs/experiments.md.

    python3 tests/experiment/optimum_figure.py --update     writes docs/pictures/optimum.svg
    python3 tests/experiment/optimum_figure.py              fails if the picture is not the table's

tests/experiment/ranges_and_hold.py measures the numbers of the table.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs" / "pictures" / "optimum.svg"
TEAMS = (2, 3, 4)
SETS = ("polygons", "thesis-like")
BARS = {"greedy, by area": "#2F6FDE", "the best found": "#1F7A4E"}
GREATEST = 80  # percent, at the upper end of the axis


def read_table():
    """The coverage in percent, by row, set and number of teams."""
    text = (ROOT / "docs" / "experiments.md").read_text(encoding="utf-8")
    found = {}
    for row in BARS:
        line = re.search(rf"^\| {re.escape(row)} \|(.*)\|$", text, re.M)
        values = [float(cell) for cell in line.group(1).split("|")]
        columns = [(name, teams) for name in SETS for teams in TEAMS]
        found.update({(row, name, teams): value for (name, teams), value in zip(columns, values, strict=True)})
    return found


def panel(found, name, left, top, width, height):
    parts = [f'<text x="{left}" y="24" font-weight="600">{name}</text>']
    for percent in range(0, GREATEST + 1, 20):
        y = top + height * (1 - percent / GREATEST)
        parts.append(f'<path d="M{left} {y:g}h{width}" stroke="#D5DBE1"/>'
                     f'<text x="{left - 6}" y="{y + 4:g}" text-anchor="end" fill="#55616D">{percent}</text>')
    for i, teams in enumerate(TEAMS):
        middle = left + width * (i + 0.5) / len(TEAMS)
        for k, (row, colour) in enumerate(BARS.items()):
            value = found[row, name, teams]
            x, size = middle - 38 + 38 * k, height * value / GREATEST
            parts.append(f'<rect x="{x + 1:g}" y="{top + height - size:.1f}" width="36" height="{size:.1f}" fill="{colour}"/>'
                         f'<text x="{x + 19:g}" y="{top + height - size - 5:.1f}" text-anchor="middle" font-size="12">{value:.1f}</text>')
        parts.append(f'<text x="{middle:g}" y="{top + height + 18}" text-anchor="middle" fill="#55616D">{teams} teams</text>')
    return parts


def figure(found):
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="760" height="310" viewBox="0 0 760 310" font-family="Inter, Helvetica, Arial, sans-serif" font-size="13">',
             "<title>Mean coverage in percent of the greedy choice of two to four teams, and of the best choice that was found</title>",
             '<rect width="760" height="310" fill="#FFFFFF"/>']
    for number, name in enumerate(SETS):
        parts += panel(found, name, 52 + 370 * number, 40, 300, 200)
    for i, (row, colour) in enumerate(BARS.items()):
        parts.append(f'<rect x="{52 + 170 * i}" y="282" width="14" height="14" fill="{colour}"/><text x="{72 + 170 * i}" y="294">{row}</text>')
    parts.append('<text x="712" y="294" text-anchor="end" fill="#55616D">mean coverage, %</text>')
    return "\n".join(parts) + "\n</svg>\n"


drawn = figure(read_table())
if "--update" in sys.argv[1:]:
    PICTURE.write_text(drawn, encoding="utf-8")
elif not PICTURE.exists() or PICTURE.read_text(encoding="utf-8") != drawn:
    sys.exit(f"{PICTURE} is not the picture of the table: run {__file__} --update")
