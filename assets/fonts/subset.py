#!/usr/bin/env python3
"""Makes the page's fonts from Inter's; the build runs it (wasm/CMakeLists.txt), with fonttools:

    subset.py page FOLDER OUTPUT
    subset.py letters FOLDER OUTPUT

FOLDER holds Inter-Regular.otf and Inter-SemiBold.otf, the results go to OUTPUT: the same fonts give the same bytes. For the
page, under the same names, they are small, and part of the program; letters-regular.otf and letters-semibold.otf have the
letters of European languages and mathematics, too, and the page fetches them when a text needs them.
Figures are the tabular ones (Dear ImGui knows no OpenType features), so that a number that changes does not make
the text beside it dance; for the same reason kerning stays out.
"""
import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter, save_font
from fontTools.ttLib import TTFont
from fontTools.ttLib.scaleUpem import ScalerVisitor

# What the page itself writes.
CHARACTERS = [chr(c) for c in range(0x20, 0x7F)] + list(
    "\u00a0\u2009\u202f"  # spaces that do not break or are thin, for numbers and their units
    "°²·×–’“”…−≈≤≥→"
)

# What people write in lessons and file names.
LETTERS = CHARACTERS + [chr(c) for first, last in (
    (0xA0, 0x24F), (0x2B0, 0x2FF), (0x300, 0x36F),  # Latin, and accents
    (0x370, 0x3FF), (0x400, 0x52F),  # Greek, Cyrillic
    (0x1E00, 0x1EFF), (0x2000, 0x206F), (0x2070, 0x209F), (0x20A0, 0x20BF), (0x2100, 0x214F),
    (0x2150, 0x218F), (0x2190, 0x22FF),  # arrows and mathematics
) for c in range(first, last + 1)]


class Scaler(ScalerVisitor):
    """As scale_upem(), which takes four times as long, since it then looks at every number of the scaled outlines."""

    def visitAttr(self, obj, attr, value):
        if attr != "cff":
            super().visitAttr(obj, attr, value)


def tabular_figures(font):
    """Maps 0 to 9 to the figures of one width, which the font offers as its feature `tnum`."""
    gsub = font["GSUB"].table
    lookups = {i for record in gsub.FeatureList.FeatureRecord if record.FeatureTag == "tnum"
               for i in record.Feature.LookupListIndex}
    substitutes = {}
    for index in sorted(lookups):
        for subtable in gsub.LookupList.Lookup[index].SubTable:
            substitutes.update(getattr(getattr(subtable, "ExtSubTable", subtable), "mapping", {}))
    for table in font["cmap"].tables:  # tables may share one mapping, hence get()
        for code in range(ord("0"), ord("9") + 1):
            if code in table.cmap:
                table.cmap[code] = substitutes.get(table.cmap[code], table.cmap[code])


def main(wanted, folder, output):
    for style in ("Regular", "SemiBold"):
        name = f"Inter-{style}.otf"
        result = name if wanted == "page" else f"letters-{style.lower()}.otf"
        font = TTFont(Path(folder) / name, recalcTimestamp=False)  # the date of the build is not in it
        tabular_figures(font)
        options = Options()
        options.layout_features = []
        options.desubroutinize = True
        options.hinting = False
        options.name_IDs = [0, 1, 2, 13, 14]
        subsetter = Subsetter(options)
        subsetter.populate(text="".join(CHARACTERS if wanted == "page" else LETTERS))
        subsetter.subset(font)
        for table in ("GPOS", "GSUB", "GDEF", "STAT", "DSIG", "kern"):
            if table in font:
                del font[table]
        # At the page's sizes a quarter of Inter's grid is finer than a pixel's shades, and a seventh smaller.
        units = font["head"].unitsPerEm
        Scaler(units // 4 / units).visit(font)
        save_font(font, Path(output) / result, options)


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in ("page", "letters"):
        sys.exit(__doc__)
    main(*sys.argv[1:])
