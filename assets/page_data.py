#!/usr/bin/env python3
"""The polygons and lessons of this folder as the JSON files that the page fetches.

  page_data.py samples FOLDER samples.json [opening_sample.inc]
  page_data.py lessons FOLDER POLYGONS lessons.json polygons.json
  page_data.py translated-lessons FOLDER POLYGONS LANGUAGE lessons-LANGUAGE.json

FOLDER/index.txt lists its files by name and title; headings, after the comment at its top, are groups.
opening_sample.inc is the first polygon as a C++ string literal: the page opens on it.
"""
import json
import re
import sys
from pathlib import Path


def read(path):
    return path.read_text(encoding="utf-8").replace("\r", "")


def listed(folder):
    """(name, title, group) for each file of the index, in its order."""
    group, after_top = "", False
    for line in read(folder / "index.txt").splitlines():
        if line.startswith("#"):
            group = line.lstrip("# ") if after_top else ""
            continue
        after_top = True
        if line.strip():
            name, title = line.split(maxsplit=1)
            yield name, title, group


def write_lines(path, brackets, entries):
    """One entry on a line: a change of one polygon is a change of one line."""
    path.write_text(f"{brackets[0]}\n" + ",\n".join(f"  {entry}" for entry in entries) + f"\n{brackets[1]}\n",
                    encoding="utf-8")


def text_of(value):
    return json.dumps(value, ensure_ascii=False)


def samples(folder, target, opening=None):
    entries = [{"name": name, "group": group, "title": title, "text": read(folder / f"{name}.txt")}
               for name, title, group in listed(folder)]
    write_lines(target, "[]", map(text_of, entries))
    if opening:
        opening.write_text(f'R"polygon({entries[0]["text"]})polygon"\n', encoding="utf-8")


def minutes(english):
    """Approximate, and the same in every language: for reading the words, a look at each step and its caption, and trying the task."""
    words = " ".join(line for line in english.splitlines() if not re.match(r"#|\[|[a-z-]+:", line)).split()
    stops = len(re.findall(r"^\[(?!(?:task|question|answer)\])", english, re.MULTILINE))
    task = re.search(r"^\[task\]", english, re.MULTILINE)
    return max(1, int(len(words) / 150 + stops * 0.25 + (3 if task else 0) + 0.5))


def lesson(polygons, name, title, group, text, english):
    polygon = re.search(r"^polygon:\s*([a-z0-9-]+)", text, re.MULTILINE)
    return {"name": name, "title": title, "session": group, "minutes": minutes(english), "text": text,
            "polygon": read(polygons / f"{polygon[1]}.txt") if polygon else ""}


def lessons(folder, polygons, target, polygons_target):
    texts = {name: read(folder / f"{name}.txt") for name, *_ in listed(folder)}
    write_lines(target, "[]", (text_of(lesson(polygons, *entry, texts[entry[0]], texts[entry[0]])) for entry in listed(folder)))
    # All samples by name, for lessons that come from elsewhere.
    files = sorted(file for file in polygons.glob("*.txt") if file.name != "index.txt")
    write_lines(polygons_target, "{}", (f"{text_of(file.stem)}: {text_of(read(file))}" for file in files))


def translated_lessons(folder, polygons, language, target):
    """The same lessons in the same order; the texts of FOLDER/LANGUAGE have their own titles."""
    entries = []
    for name, _, group in listed(folder):
        text = read(folder / language / f"{name}.txt")
        title = re.search(r"^title:\s*(.*)$", text, re.MULTILINE)[1]
        entries.append(text_of(lesson(polygons, name, title, group, text, read(folder / f"{name}.txt"))))
    write_lines(target, "[]", entries)


if __name__ == "__main__":
    commands = {"samples": samples, "lessons": lessons, "translated-lessons": translated_lessons}
    commands[sys.argv[1]](*map(Path, sys.argv[2:]))
