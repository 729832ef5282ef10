#!/usr/bin/env python3
"""Draws the page's mark as PNGs, for systems that install the page; the build runs it (wasm/CMakeLists.txt):

    app_icons.py ICON FOLDER

ICON is web/page/icon.svg, the mark of a centre of mass: a disc whose quadrants are dark and light in turn, and its rim. Its
numbers and colours are read, and a drawing of other parts is refused. FOLDER gets icon-192.png and icon-512.png, on a
transparent ground, and icon-maskable-512.png, which a system may cut to any form: its ground fills the square, and the mark
stays within the circle of 80 % that is always seen.
"""
import math
import re
import struct
import sys
import zlib
from pathlib import Path

GROUND = (0xEE, 0xF1, 0xF4)  # the page's own, in light colours


class Mark:
    """The mark in the units of the drawing, whose middle is (middle, middle)."""

    def __init__(self, svg):
        shape = re.fullmatch(
            r'<svg xmlns="[^"]+" viewBox="0 0 (\d+) \1">\s*'
            r'<circle cx="(\d+)" cy="\2" r="(\d+)" fill="#fff"/>\s*'
            r'<path d="M\2 \2V(\d+)a\3 \3 0 0 1 \3 \3zM\2 \2v\3A\3 \3 0 0 1 \4 \2z" fill="#(\w{6})"/>\s*'
            r'<circle cx="\2" cy="\2" r="\3" fill="none" stroke="#\5" stroke-width="([\d.]+)"/>\s*</svg>\s*', svg)
        if not shape:
            sys.exit("app_icons.py: icon.svg has other parts than the mark: change what draws it here, too")
        self.side, self.middle, self.radius = int(shape[1]), int(shape[2]), int(shape[3])
        self.dark = bytes.fromhex(shape[5])
        self.rim = float(shape[6]) / 2

    def colour(self, x, y):
        """The colour at a point from the middle, y downwards; None outside of the mark."""
        distance = math.hypot(x, y)
        if distance > self.radius + self.rim:
            return None
        dark = distance > self.radius - self.rim or (x > 0) != (y > 0)
        return self.dark if dark else (255, 255, 255)

    def is_even(self, x, y, reach):
        """Whether no line of the drawing is nearer to a point than `reach`."""
        distance = math.hypot(x, y)
        lines = [distance - self.radius - self.rim, distance - self.radius + self.rim]
        if distance < self.radius:
            lines += [x, y]
        return all(abs(line) > reach for line in lines)


SAMPLES = [(i + 0.5) / 8 - 0.5 for i in range(8)]  # of a pixel, both ways, where lines go through it


def pixel(mark, x, y, unit, ground):
    """(r, g, b, a) of the pixel whose middle this is; `unit` is its width."""
    at = [(x, y)] if mark.is_even(x, y, unit) else [(x + dx * unit, y + dy * unit) for dy in SAMPLES for dx in SAMPLES]
    seen = [mark.colour(*point) or ground for point in at]
    covered = [colour for colour in seen if colour]
    if not covered:
        return bytes(4)
    return bytes([*(round(sum(colour[k] for colour in covered) / len(covered)) for k in range(3)),
                  round(255 * len(covered) / len(at))])


def picture(mark, size, scale, ground):
    """The rows of a square picture; the whole drawing takes `scale` of its side."""
    unit = mark.side / (size * scale)
    offsets = [(i + 0.5 - size / 2) * unit for i in range(size)]
    return [b"".join(pixel(mark, x, y, unit, ground) for x in offsets) for y in offsets]


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(rows):
    header = struct.pack(">IIBBBBB", len(rows), len(rows), 8, 6, 0, 0, 0)  # 8 bits of red, green, blue and opacity
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)) + chunk(b"IEND", b""))


def main(icon, folder):
    mark = Mark(Path(icon).read_text(encoding="utf-8"))
    for name, size, scale, ground in [("icon-192", 192, 1, None), ("icon-512", 512, 1, None),
                                      ("icon-maskable-512", 512, 0.72, GROUND)]:
        (Path(folder) / f"{name}.png").write_bytes(png(picture(mark, size, scale, ground)))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
