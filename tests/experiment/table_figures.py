#!/usr/bin/env python3
"""Draws the figures of tables in docs/experiments.md: the effect of ranges and of the goal to hold, and how far the
greedy choice is from the best one.

    python3 tests/experiment/table_figures.py --update     writes docs/pictures/hold.svg and
    docs/pictures/optimum.svg
    python3 tests/experiment/table_figures.py              fails if a picture does not match its table

tests/experiment/ranges_and_hold.py measures the numbers of the tables.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = (ROOT / "docs" / "experiments.md").read_text(encoding="utf-8")
TEAMS = (2, 3, 4)
SETS = ("polygons", "thesis-like")
CHOICES = {"greedy, by area": "#2F6FDE", "the best found": "#1F7A4E"}
PLACES = {"best places, to cover": "#A9C4F5", "best places, to hold": "#2F6FDE",
          "in ranges, to cover": "#A5D3BB", "in ranges, to hold": "#1F7A4E"}  # fmt: skip


def rows_of(label):
    """The cells of each row with this label, one row for each occurrence in a table."""
    return [
        [cell.strip() for cell in line.split("|")]
        for line in re.findall(rf"^\| {re.escape(label)} \|(.*)\|$", TABLES, re.M)
    ]


def coverages():
    """The cells of each row, by set and number of teams: one table for both sets, side by side."""
    columns = [(name, teams) for name in SETS for teams in TEAMS]
    return {
        (label, *column): float(cell)
        for label in CHOICES
        for column, cell in zip(columns, rows_of(label)[0], strict=True)
    }


def held():
    """The held share, from cells "held / coverage": a table for each set."""
    return {
        (label, name, teams): float(cell.split("/")[0])
        for label in PLACES
        for name, cells in zip(SETS, rows_of(label), strict=True)
        for teams, cell in zip(TEAMS, cells, strict=True)
    }


def panel(bars, found, name, left, greatest):
    """Bars of one set, for each number of teams."""
    top, width, height = 40, 300, 200
    step = 88 / len(bars)
    parts = [f'<text x="{left}" y="24" font-weight="600">{name}</text>']
    for percent in range(0, greatest + 1, 20):
        y = top + height * (1 - percent / greatest)
        parts.append(
            f'<path d="M{left} {y:g}h{width}" stroke="#D5DBE1"/>'
            f'<text x="{left - 6}" y="{y + 4:g}" text-anchor="end" fill="#55616D">{percent}</text>'
        )
    for i, teams in enumerate(TEAMS):
        middle = left + width * (i + 0.5) / len(TEAMS)
        for k, (label, colour) in enumerate(bars.items()):
            value = found[label, name, teams]
            x, size = middle - 44 + step * k, height * value / greatest
            said = f"{value:.1f}" if step > 30 else f"{value:.0f}"
            parts.append(
                f'<rect x="{x + 1:g}" y="{top + height - size:.1f}" width="{step - 2:g}" height="{size:.1f}" fill="{colour}"/>'
                f'<text x="{x + step / 2:g}" y="{top + height - size - 5:.1f}" text-anchor="middle" font-size="12">{said}</text>'
            )
        parts.append(f'<text x="{middle:g}" y="{top + height + 18}" text-anchor="middle" fill="#55616D">{teams} teams</text>')
    return parts


def figure(title, measure, bars, found, greatest):
    parts = [
        '<svg xmlns="http://www.w3.org/2000/svg" width="760" height="310" viewBox="0 0 760 310" font-family="Inter, Helvetica, Arial, sans-serif" font-size="13">',
        f"<title>{title}</title>",
        '<rect width="760" height="310" fill="#FFFFFF"/>',
    ]
    for number, name in enumerate(SETS):
        parts += panel(bars, found, name, 52 + 370 * number, greatest)
    for i, (label, colour) in enumerate(bars.items()):
        x = 52 + (170 if len(bars) == 2 else 155) * i
        parts.append(f'<rect x="{x}" y="282" width="14" height="14" fill="{colour}"/><text x="{x + 20}" y="294">{label}</text>')
    parts.append(f'<text x="712" y="24" text-anchor="end" fill="#55616D">{measure}</text>')
    return "\n".join(parts) + "\n</svg>\n"


FIGURES = {
    "hold.svg": figure(
        "How many polygons two to four teams hold in form closure, in percent: at the best places or in ranges, chosen to cover or to hold",
        "held, % of the polygons", PLACES, held(), 100,
    ),
    "optimum.svg": figure(
        "Mean coverage in percent of the greedy choice of two to four teams, and of the best choice that was found",
        "mean coverage, %", CHOICES, coverages(), 80,
    ),
}  # fmt: skip

for file, drawn in FIGURES.items():
    picture = ROOT / "docs" / "pictures" / file
    if "--update" in sys.argv[1:]:
        picture.write_text(drawn, encoding="utf-8")
    elif not picture.exists() or picture.read_text(encoding="utf-8") != drawn:
        sys.exit(f"{picture} is not the picture of its table: run {__file__} --update")
