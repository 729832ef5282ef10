#!/usr/bin/env python3
"""The reader written from docs/link-format.md reads the links of tests/data as the program does.

    python3 check_link_reader.py
"""

import json
import pathlib
import struct
import sys

tests = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(tests.parent / "docs"))
sys.dont_write_bytecode = True
import link_reader  # noqa: E402


def rows(name):
    for line in (tests / "data" / name).read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            yield line.split("\t")


def exact(value):
    """The value with its numbers as the bytes of doubles; integers of settings stay."""
    if isinstance(value, list):
        return [exact(item) for item in value]
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return struct.pack("<d", value)
    return value


def comparable(content):
    settings = dict(content["settings"])
    for name in ("min_ratio", "weight", "min_margin", "apart", "clear", "snap", "com_radius", "capacity"):
        if name in settings:
            settings[name] = exact(settings[name])
    return exact(content["vertices"]), exact(content["centre_of_mass"]), settings


count = 0
for link, held in [*rows("links_version_1.txt"), *rows("links_version_2.txt")]:
    if comparable(link_reader.read_link(link)) != comparable(json.loads(held)):
        sys.exit(f"the readers differ: {link}")
    count += 1

for link, text in rows("lesson_links.txt"):
    if link_reader.read_lesson_link(link).decode("utf-8") != json.loads(text):
        sys.exit(f"the readers of lessons differ: {link}")
    count += 1

# It must detect damage, but not every form that no writer makes.
for code, link, why in rows("hostile_links.txt"):
    if code == "bad_link":
        continue
    try:
        link_reader.read_link(json.loads(link).strip())
    except link_reader.LinkError:
        continue
    sys.exit(f"read, though {why}: {link}")

if count == 0:
    sys.exit("no links")
print(f"{count} links alike")
