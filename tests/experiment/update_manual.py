#!/usr/bin/env python3
"""Rewrites the tables of docs/experiments.md from the results of `evenlift experiment` on both sets, and prints the
numbers of the README.

    python3 tests/experiment/update_manual.py [build/bin/evenlift [FOLDER]]

FOLDER holds the results of `evenlift experiment assets/polygons assets/thesis-like --out FOLDER`, if they exist
already.
"""

import contextlib
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import results  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "bin" / "evenlift")


@contextlib.contextmanager
def measured():
    if len(sys.argv) > 2:
        yield pathlib.Path(sys.argv[2])
        return
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAM, "experiment", "assets/polygons", "assets/thesis-like", "--out", folder], cwd=ROOT, check=True)
        yield pathlib.Path(folder)


def replace_table(file, table):
    """Replaces the table with the same heads."""
    heads = table.splitlines()[0]
    text, replaced = re.subn(rf"^{re.escape(heads)}\n(\|.*\n)*", lambda _: table, file.read_text(encoding="utf-8"), flags=re.M)
    if replaced != 1:
        sys.exit(f"{file} has no table that begins with {heads}")
    file.write_text(text, encoding="utf-8")


with measured() as made:
    manual = ROOT / "docs" / "experiments.md"
    for table in results.manual_tables(made):
        replace_table(manual, table)
    print("README.md: loads differ by %s at random and by %s in pairs" % tuple(results.readme_spreads(made)))
