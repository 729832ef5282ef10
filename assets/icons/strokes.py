#!/usr/bin/env python3
"""Makes the canvas's icons from the page's; the build runs it (wasm/CMakeLists.txt), with fonttools:

    strokes.py ICONS OUTPUT

ICONS is web/kit/icons.js, which holds every icon as the path data of SVG. OUTPUT becomes the tables that
wasm/ui/icons.cpp includes: all points in hundredths of a unit, the strokes as runs of points, and the icons, without
those of the windows alone, as runs of strokes.
"""
import re
import sys
from pathlib import Path

from fontTools.pens.basePen import BasePen
from fontTools.svgLib.path import parse_path

PIECES = 8  # of a curve: at most a quarter of a circle, a few pixels wide


class Strokes(BasePen):
    """Collects the strokes of a path, each as its points and whether it is closed."""

    def __init__(self):
        super().__init__()
        self.strokes = []

    def _moveTo(self, point):
        self.strokes.append(([point], False))

    def _lineTo(self, point):
        self.strokes[-1][0].append(point)

    def _curveToOne(self, b, c, d):
        a = self._getCurrentPoint()
        for i in range(1, PIECES + 1):
            t, u = i / PIECES, 1 - i / PIECES
            self._lineTo(tuple(u**3 * a[k] + 3 * u * u * t * b[k] + 3 * u * t * t * c[k] + t**3 * d[k] for k in (0, 1)))

    def _closePath(self):
        points, _ = self.strokes[-1]
        if len(points) > 1 and points[-1] == points[0]:
            points.pop()
        self.strokes[-1] = (points, len(points) > 1)


def main(icons, output):
    text = re.sub(r"export const ofWindows = \{.*?\};", "", Path(icons).read_text(encoding="utf-8"), flags=re.DOTALL)
    points, strokes, rows = [], [], []
    for name, path in re.findall(r'^  (\w+):\s+"([^"]+)",$', text, re.MULTILINE):
        pen = Strokes()
        parse_path(path, pen)
        first = len(strokes)
        for stroke, closed in pen.strokes:
            strokes.append(f"{{{len(points)}, {len(stroke)}, {str(closed).lower()}}}")
            points += [f"{{{round(100 * x)}, {round(100 * y)}}}" for x, y in stroke]
        rows.append(f"{{Icon::{name}, {first}, {len(strokes) - first}}}")
    Path(output).write_text(
        f"constexpr Point points[] = {{{', '.join(points)}}};\n"
        f"constexpr Stroke strokes[] = {{{', '.join(strokes)}}};\n"
        f"constexpr Strokes icons[] = {{{', '.join(rows)}}};\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
