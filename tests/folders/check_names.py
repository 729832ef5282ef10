"""Checks that no two files define different types of one name.

    python3 tests/folders/check_names.py

Within a program a type may have only one definition. If two source files each define a type of the same name,
neither the compiler nor the linker reports an error. The linker then merges functions that do not belong together:
memory is corrupted, perhaps with one compiler only. A type that only one file uses belongs in an unnamed namespace.
"""

import collections
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent.parent
# Comments and literals.
ignored = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
preprocessor = re.compile(r"^[ \t]*#(?:[^\n\\]|\\\n|\\.)*", re.MULTILINE)
named_namespace = re.compile(r"\bnamespace\s+([\w:]+)\s*$")
type_definition = re.compile(r"\b(?:struct|class|union|enum(?:\s+class)?)\s+(?:alignas\([^)]*\)\s*)?(\w+)\s*(?:final\s*)?(?::(?!:)[^;{}]*)?$")


def types_of(text):
    """The types that the text defines at the level of a named namespace, with their namespaces."""
    text = preprocessor.sub("", ignored.sub(" ", text))
    scopes = []  # for each open brace its namespace, or None
    found = []
    begin = 0
    for brace in re.finditer(r"[{};]", text):
        before = text[begin:brace.start()]
        begin = brace.end()
        if brace[0] == "}":
            scopes.pop()
        elif brace[0] == "{":
            namespace, definition = named_namespace.search(before), type_definition.search(before)
            if namespace:
                scopes.append(namespace[1])
                continue
            if definition and not before.lstrip().startswith("template <>") and None not in scopes:
                found.append("::".join([*scopes, definition[1]]))
            scopes.append(None)
    return found


def repeated(folders):
    definitions = collections.defaultdict(list)
    for folder in folders:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp") or "node_modules" in file.parts:
                continue
            for name in types_of(file.read_text(encoding="utf-8")):
                definitions[name].append(file.relative_to(root).as_posix())
    return [f"{name} is defined in {' and in '.join(files)}" for name, files in sorted(definitions.items()) if len(files) > 1]


def check_itself():
    text = "namespace a { struct B { struct Inner {}; }; namespace { struct C {}; } enum class D : int { e }; void f() { struct G {}; } struct B::H {}; }"
    assert types_of(text) == ["a::B", "a::D"], types_of(text)


check_itself()
problems = repeated(["core", "wasm", "native"])
for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
