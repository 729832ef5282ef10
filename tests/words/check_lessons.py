#!/usr/bin/env python3
"""A lesson in another language asks and shows the same: its settings, its steps and its numbers are the English lesson's.

    python3 tests/words/check_lessons.py
"""

import collections
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent.parent / "assets/lessons"
number = re.compile(r"\d+(?:[.,]\d+)?")  # in German with a comma


def parts(text):
    """The lines before the first part, without title and comments; and each part's heading with its numbers."""
    head, *rest = re.split(r"^(\[[^\]\n]+\])$", text, flags=re.MULTILINE)
    settings = [line for line in head.splitlines() if line.strip() and not line.startswith(("#", "title:"))]
    words = ["\n".join(line for line in part.splitlines() if not line.startswith("#")) for part in rest[1::2]]
    return settings, [(name, collections.Counter(each.replace(",", ".") for each in number.findall(text))) for name, text in zip(rest[::2], words)]


problems = []
for english in sorted(root.glob("*.txt")):
    if english.name == "index.txt":
        continue
    for folder in sorted(p for p in root.iterdir() if p.is_dir()):
        other = folder / english.name
        if not other.exists():
            problems.append(f"{other.relative_to(root)} is missing")
            continue
        (settings, steps), (their_settings, their_steps) = (parts(p.read_text(encoding="utf-8")) for p in (english, other))
        if settings != their_settings:
            problems.append(f"{other.relative_to(root)}: other settings than {english.name}")
        if [name for name, _ in steps] != [name for name, _ in their_steps]:
            problems.append(f"{other.relative_to(root)}: other parts than {english.name}")
        for (name, numbers), (_, theirs) in zip(steps, their_steps):
            if numbers != theirs:
                only = list((numbers - theirs).elements()), list((theirs - numbers).elements())
                problems.append(f"{other.relative_to(root)}, {name}: the English part has {only[0]}, this one {only[1]}")
for problem in problems:
    print(problem)
sys.exit(bool(problems))
