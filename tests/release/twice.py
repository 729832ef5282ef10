#!/usr/bin/env python3
"""Makes the release of the current commit twice, in two fresh clones with different paths, and compares all bytes:

    python3 tests/release/twice.py [FILE...]

FILEs, such as *-page.zip, are patterns of the files to compare; by default all. It takes as long as two builds of
everything.
"""
import fnmatch
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(__file__).resolve().parent.parent.parent


def sums_of(clone):
    subprocess.run(["git", "clone", "--quiet", str(root), str(clone)], check=True)
    subprocess.run(["./dev", "release"], cwd=clone, check=True)
    lines = (clone / "build/release/SHA256SUMS").read_text().splitlines()
    return {name: hashed for hashed, name in (line.split("  ", 1) for line in lines)}


def main(patterns):
    with tempfile.TemporaryDirectory(prefix="evenlift-") as folder:
        first = sums_of(Path(folder) / "one")
        second = sums_of(Path(folder) / "another" / "of-two")
    wanted = [name for name in sorted({*first, *second}) if not patterns or any(fnmatch.fnmatch(name, p) for p in patterns)]
    differing = [name for name in wanted if first.get(name) != second.get(name)]
    for name in wanted:
        print("differs " if name in differing else "the same", name)
    return 1 if differing or not wanted else 0


sys.exit(main(sys.argv[1:]))
