"""Writes sheet.dxf: 200 parts on a sheet of 3 m x 2 m, in millimetres, each with its number as a text.

    python3 examples/sheet/make_sheet.py > examples/sheet/sheet.dxf

Parts are rectangles, rectangles with a corner cut off, brackets, triangles and discs, some with a hole, in 20 columns and
10 rows. All outlines are on the layer PARTS, as nesting programs write them, and the texts on the layer NUMBERS.
"""

import math
import random

random.seed(200)
columns, rows, width, height = 20, 10, 150, 200


def group(code, value):
    return f"{code}\n{value}\n"


def polyline(points):
    text = group(0, "LWPOLYLINE") + group(8, "PARTS") + group(90, len(points)) + group(70, 1)
    return text + "".join(group(10, f"{x:g}") + group(20, f"{y:g}") for x, y in points)


def circle(x, y, radius):
    return group(0, "CIRCLE") + group(8, "PARTS") + group(10, f"{x:g}") + group(20, f"{y:g}") + group(40, f"{radius:g}")


def text(x, y, words):
    return group(0, "TEXT") + group(8, "NUMBERS") + group(10, f"{x:g}") + group(20, f"{y:g}") + group(40, 8) + group(1, words)


def part(kind, x, y, w, h):
    """The outline, and whether a hole fits beside the number."""
    if kind == "bracket":
        return polyline([(x, y), (x + w, y), (x + w, y + h / 3), (x + w / 3, y + h / 3), (x + w / 3, y + h), (x, y + h)]), False
    if kind == "corner":
        return polyline([(x, y), (x + w, y), (x + w, y + 2 * h / 3), (x + 2 * w / 3, y + h), (x, y + h)]), True
    if kind == "triangle":
        return polyline([(x, y), (x + w, y), (x + w / 3, y + h)]), False
    if kind == "disc":
        return circle(x + w / 2, y + h / 2, w / 2), False
    return polyline([(x, y), (x + w, y), (x + w, y + h), (x, y + h)]), True


entities = ""
for number in range(columns * rows):
    column, row = number % columns, rows - 1 - number // columns
    kind = random.choice(["plate", "plate", "corner", "bracket", "triangle", "disc"])
    w, h = random.randrange(90, width - 20, 5), random.randrange(110, height - 20, 5)
    x, y = column * width + 10, row * height + 10
    outline, has_room = part(kind, x, y, w, h)
    entities += outline
    if has_room and random.random() < 0.5:
        entities += circle(x + w / 2, y + h / 2 + 15, math.floor(w / 8))
    entities += text(x + w / 6, y + h / 12, f"P{number + 1:03}")

print(group(0, "SECTION") + group(2, "HEADER") + group(9, "$INSUNITS") + group(70, 4) + group(0, "ENDSEC"), end="")
print(group(0, "SECTION") + group(2, "ENTITIES") + entities + group(0, "ENDSEC") + group(0, "EOF"), end="")
