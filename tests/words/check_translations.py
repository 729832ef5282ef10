#!/usr/bin/env python3
"""Each text that people read on the page has an entry in assets/words/de.json, and each entry is needed.

    python3 tests/words/check_translations.py            says what is missing
    python3 tests/words/check_translations.py --missing  prints it as JSON, to be translated

A text is a literal in C++ or JavaScript that reads as words: it has a space between words, or begins with a capital.
What reads so and is no text of the page is listed in tests/words/not_translated.txt, with its reason.
"""

import collections
import json
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent.parent
# The words of the program (native) and of the experiments' report stay English.
trees = ["wasm", "web", *(f"core/src/{folder}" for folder in (
    "balanced", "candidates", "chords", "document", "errors", "experiment/measure", "experiment/thesis", "formats", "generate", "import", "lesson", "link",
    "numbers", "output/poses", "output/svg", "output/trace_words", "output/verdict", "output/words", "parts", "placement", "polygon", "stands", "supports", "swaps", "trace", "wording"))]  # fmt: skip
literal = re.compile(
    r"""//[^\n]*|/\*.*?\*/|\#include[^\n]*|R"\((?P<raw>.*?)\)"|(?P<text>"(?:[^"\\\n]|\\.)*"(?:\s*(?:\+\s*)?"(?:[^"\\\n]|\\.)*")*)"""
    r"""|(?P<quoted>'(?:[^'\\\n]|\\.)*')|(?P<template>`(?:[^`\\]|\\.)*`)""",
    re.DOTALL,
)
place = re.compile(r"\{(\w+)\}")


def unescaped(written):
    pieces = re.findall(r'"((?:[^"\\\n]|\\.)*)"', written)
    text = "".join(pieces)
    simple = {"n": "\n", "t": "\t", "0": "\0"}
    return re.sub(
        r"\\(?:u([0-9A-Fa-f]{4})|x([0-9A-Fa-f]{2})|(.))",
        lambda m: chr(int(m[1] or m[2], 16)) if m[1] or m[2] else simple.get(m[3], m[3]),
        text,
    )


def is_message_to_developers(source, at):
    """Of an assertion."""
    return bool(re.search(r"(&&|static_assert\([^;]*,)\s*$", source[max(0, at - 200) : at]))


def is_help(source, at):
    """Of the program's options, which stay English (core/src/document/settings.cpp)."""
    return bool(re.search(r"\.option\s*=\s*\{[^}]*$", source[max(0, at - 600) : at]))


def reads_as_words(text):
    if re.search(r'</?\w+|="|\{"|;\n|: \{', text):  # markup
        return False
    bare = place.sub("", text)
    return bool(re.search(r"[A-Za-z]{2}", bare)) and bool(re.search(r"[A-Za-z,.:;] [A-Za-z{(]|^[A-Z][a-z]|\w [{]|[}] \w", text))


def sources():
    for tree in trees:
        for path in sorted((root / tree).rglob("*")):
            if path.suffix in (".cpp", ".h", ".js") and "node_modules" not in path.parts:
                yield path


def texts_in(source, is_script):
    """The literals of a source, those within the values of JavaScript's templates as well; and the templates themselves
    that join words and values."""
    for found in literal.finditer(source):
        if found["text"]:
            # Lines of the algorithm are looked up without indent.
            is_list = source.startswith("_words", found.end())  # of words that files have
            if not is_list and not is_message_to_developers(source, found.start()) and not is_help(source, found.start()):
                text = unescaped(found["text"])
                yield text.lstrip(" ") if text.startswith("  ") else text, False
        elif found["raw"]:
            yield found["raw"], False
        elif found["quoted"] and is_script:
            yield unescaped('"' + found["quoted"][1:-1] + '"'), False
        elif found["template"]:
            values = re.findall(r"\$\{((?:[^{}]|\{[^{}]*\})*)\}", found["template"])
            for value in values:
                yield from texts_in(value, is_script)
            said = re.sub(r"\$\{((?:[^{}]|\{[^{}]*\})*)\}", "{}", found["template"][1:-1])
            if not values:
                yield said, False
            elif re.search(r"[A-Za-z]{2,} [A-Za-z]{2,}", said):
                yield found["template"], True


def texts_of_sources():
    """Every literal, with the files that have it; and the templates that join words and values."""
    texts, joined = collections.defaultdict(set), []
    for path in sources():
        name = path.relative_to(root).as_posix()
        for text, joins in texts_in(path.read_text(encoding="utf-8"), path.suffix == ".js"):
            if joins:
                joined.append((name, text))
            else:
                texts[text].add(name)
    return texts, joined


def texts_of_assets():
    """Titles of samples and lessons, and the words of index.html."""
    for folder in ("polygons", "thesis-like", "lessons"):
        for line in (root / "assets" / folder / "index.txt").read_text(encoding="utf-8").splitlines():
            yield from (line.lstrip("# "), line.partition(" ")[2].strip())
    for path in (root / "assets/lessons").glob("*.txt"):
        yield from re.findall(r"^(?:title|about): (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    page = (root / "web/page/index.html").read_text(encoding="utf-8")
    yield from (text.strip() for text in re.findall(r">([^<]+)<", page))
    yield from re.findall(r'aria-label="([^"]+)"', page)


def main():
    words = json.loads((root / "assets/words/de.json").read_text(encoding="utf-8"))
    excused = set()
    for line in (root / "tests/words/not_translated.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith('"'):
            excused.add(json.loads(line))
    texts, joined = texts_of_sources()
    missing = {t: f for t, f in texts.items() if reads_as_words(t) and t not in words and t not in excused}
    if "--missing" in sys.argv:
        print(json.dumps({t: sorted(f)[0] for t, f in missing.items()}, ensure_ascii=False, indent=1))
        return
    problems = [f'{sorted(files)[0]}: no entry for "{text}"' for text, files in missing.items()]
    known = set(texts) | set(texts_of_assets())
    problems += [f'assets/words/de.json: no text needs "{text}"' for text in words if text not in known | excused]
    problems += [f"tests/words/not_translated.txt: {json.dumps(t, ensure_ascii=False)} is no text" for t in excused - set(texts) - set(words) - {template for _, template in joined}]
    for text, other in words.items():
        if set(place.findall(text)) != set(place.findall(other)):
            problems.append(f'assets/words/de.json: the {{names}} of "{text}" and "{other}" differ')
    problems += [f"{name}: {template} joins words and values; use say()" for name, template in joined if template not in excused]
    for problem in problems:
        print(problem)
    sys.exit(bool(problems))


main()
