"""Looks for words and habits that evenlift has given up (CONTRIBUTING.md, "The words" and "How we write") in what people read.

    python3 tests/folders/check_words.py

That is the prose of the documents, the comments of public headers, the lessons, and the texts in the code: string literals
with a space in them. Names in backticks, code blocks and links are not prose.
"""

import io
import pathlib
import re
import sys
import tokenize

root = pathlib.Path(__file__).resolve().parent.parent.parent

# With what to write instead.
given_up = {
    r"bears?|borne": "carry",
    r"lets go": "goes slack, fails",
    r"exchang(e|es|ed|ing)": "swap",
    r"halo": "tipping distance",
    r"doubts?": "C uncertainty",
    r"perfectly even": "even",
    r"even enough": "meets the minimum ratio",
    r"evenly spread": "equal angles",
    r"rooms": "folders",
    r"before a room": "presentation mode",
    r"edge-pairs?": "edge pair",
    r"somebody|nobody|whoever|whomever": "you, the caller, or no person",
    r"so (many|much)": "the number of",
    r"anew": "again",
    r"once more": "again",
    r"likewise": "also",
    r"besides": "also, next to",
    r"(?<!there )(is|are) none (?:of|that)": "is unknown, is not",
}
pattern = re.compile(r"\b(?:" + "|".join(f"(?P<w{i}>{word})" for i, word in enumerate(given_up)) + r")\b", re.IGNORECASE)

# Where they are right.
allowed = [
    ("core/src/document/settings.cpp", "halo"),  # the names of overlays
]


def prose_of_markdown(text):
    """The text with spaces in place of code, links' targets and headings' anchors."""
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])  # noqa: E731
    for code in (r"(?ms)^```.*?^```", r"`[^`\n]*`", r"\[[^\]\n]*\.md\]\([^)]*\)", r"\]\([^)]*\)", r"<[^>\n]*>"):
        text = re.sub(code, blank, text)
    return text


def comments(text):
    return "\n".join(line[line.find("//") :] if "//" in line else "" for line in text.splitlines())


literal = re.compile(r'"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`' r"|'((?:[^'\\\n]|\\.)*)'")


def literals(text):
    """The string literals that have a space, at their lines."""
    text = re.sub(r"//[^\n]*|\]\([^)\n]*\)", "", text)  # nor links' targets
    lines = [""] * (text.count("\n") + 1)
    for found in literal.finditer(text):
        words = re.sub(r"\$\{[^}]*\}", " ", next(group for group in found.groups() if group is not None))
        if " " in words.strip():
            lines[text.count("\n", 0, found.start())] += words + " "
    return "\n".join(lines)


def literals_of_python(text):
    lines = [""] * (text.count("\n") + 2)
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.STRING and " " in token.string:
            lines[token.start[0] - 1] += token.string.replace("\n", " ")
    return "\n".join(lines)


def files():
    """Each file with what a person reads of it."""
    skipped = {"node_modules", "build", ".git", "expected", "CHANGELOG.md", "THIRD_PARTY.md"}
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root)
        if skipped & set(name.parts) or not path.is_file():
            continue
        top = name.parts[0]
        if path.suffix == ".md":
            text = path.read_text(encoding="utf-8")
            if name.name == "CONTRIBUTING.md":  # it lists what is given up
                text = re.sub(r"(?ms)^## (The words|How we write)$.*?(?=^## )", lambda found: "\n" * found[0].count("\n"), text)
            yield name, prose_of_markdown(text)
        elif path.suffix == ".txt" and name.parts[:2] == ("assets", "lessons"):
            # Lines such as "[exchange]" name steps, and index.txt names files.
            text = path.read_text(encoding="utf-8")
            yield name, re.sub(r"(?m)^\[.*\]", "", text) if path.stem != "index" else ""
        elif path.suffix == ".h" and name.parts[:2] == ("core", "include"):
            yield name, prose_of_markdown(comments(path.read_text(encoding="utf-8")))
        elif path.suffix in (".cpp", ".h") and top in ("core", "native", "wasm", "c"):
            yield name, literals(path.read_text(encoding="utf-8"))
        elif path.suffix in (".js", ".mjs") and top in ("web", "npm"):
            yield name, literals(path.read_text(encoding="utf-8"))
        elif path.suffix == ".html" and top in ("web", "native"):
            yield name, re.sub(r"(?s)<(style|script)\b.*?</\1>", lambda found: "\n" * found[0].count("\n"), path.read_text(encoding="utf-8"))
        elif path.suffix == ".py" and top == "python":
            yield name, literals_of_python(path.read_text(encoding="utf-8"))


def problems():
    for name, text in files():
        for found in pattern.finditer(text):
            if any(name.as_posix() == file and word in found[0].lower() for file, word in allowed):
                continue
            instead = list(given_up.values())[int(found.lastgroup[1:])]
            line = text.count("\n", 0, found.start()) + 1
            yield f"{name}:{line}: “{found[0]}” is given up; write {instead}"


def check_itself():
    assert literals('a("one two"); // "three four"\nb(\'five\', `six ${x} seven`)') == "one two \nsix   seven ", literals('a("one two")')
    assert pattern.search("They Bear it") and not pattern.search("bearing, forbear")
    assert "x" not in prose_of_markdown("`x` [a](x) \n```\nx\n```\n")


check_itself()
found = list(problems())
print("\n".join(found) if found else "no word that was given up")
sys.exit(1 if found else 0)
