#!/usr/bin/env python3
"""Writes the table of docs/experiments.md anew, as `evenlift experiment` makes it of both sets.

    python3 tests/experiment/update_manual.py [build/bin/evenlift]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "bin" / "evenlift")

with tempfile.TemporaryDirectory() as folder:
    subprocess.run([PROGRAM, "experiment", "assets/polygons", "assets/thesis-like", "--out", folder], cwd=ROOT, check=True)
    table = (pathlib.Path(folder) / "thesis.md").read_text(encoding="utf-8")
manual = ROOT / "docs" / "experiments.md"
text, replaced = re.subn(r"^\| section \| what \|.*?\n(?!\|)", lambda _: table, manual.read_text(encoding="utf-8"), flags=re.M | re.S)
if replaced != 1:
    sys.exit("docs/experiments.md has no table that begins with | section | what |")
manual.write_text(text, encoding="utf-8")
