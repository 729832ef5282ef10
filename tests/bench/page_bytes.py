#!/usr/bin/env python3
"""The bytes of the page's program by folders of the source: what its gzip -9 loses without their functions' bodies.

  page_bytes.py [BUILD]   BUILD is the folder of the WebAssembly build, else build/wasm

The program is linked once more, with the names of its functions, into a temporary folder. A function belongs to the
folder whose sources define a function of its name; names that several folders define, and those of templates of the
library, belong to where the first of them is, so the table is for finding causes, not for adding up.
"""
import gzip
import re
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

root = Path(__file__).resolve().parents[2]
build = Path(sys.argv[1] if len(sys.argv) > 1 else root / "build/wasm").resolve()


def linked(folder):
    """(the program's bytes, the names of its functions by index)"""
    commands = subprocess.run(["ninja", "-C", str(build), "-t", "commands", "evenlift_page"], capture_output=True, text=True, check=True)
    line = next(line for line in commands.stdout.splitlines() if re.search(r"-o \S+/evenlift\.js ", line))
    command = line.split("&&")[1].strip()
    command = re.sub(r"-o \S+/evenlift\.js", f"-o {folder}/evenlift.js --emit-symbol-map", command)
    subprocess.run(command, shell=True, cwd=build, check=True)
    names = {}
    for line in (folder / "evenlift.js.symbols").read_text().splitlines():
        index, _, name = line.partition(":")
        names[int(index)] = re.sub(r"\\(..)", lambda m: chr(int(m[1], 16)), name)
    return (folder / "evenlift.wasm").read_bytes(), names


def number(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if not byte & 0x80:
            return value, at


def leb(value):
    out = bytearray()
    while True:
        byte = value & 0x7F
        value >>= 7
        out.append(byte | (0x80 if value else 0))
        if not value:
            return bytes(out)


def sections(data):
    at = 8
    while at < len(data):
        size, start = number(data, at + 1)
        yield data[at], start, start + size
        at = start + size


def imported(data, start):
    """The number of imported functions."""
    count, at = number(data, start)
    functions = 0
    for _ in range(count):
        for _ in range(2):
            size, at = number(data, at)
            at += size
        kind = data[at]
        at += 1
        if kind == 0:
            functions += 1
            _, at = number(data, at)
        elif kind == 3:
            at += 2
        else:
            if kind == 1:
                at += 1
            flags = data[at]
            at += 1
            for _ in range(2 if flags & 1 else 1):
                _, at = number(data, at)
    return functions


def bodies(data):
    """(section's start and end, the functions' [start, end) by index)"""
    before = 0
    for kind, start, end in sections(data):
        if kind == 2:
            before = imported(data, start)
        if kind == 10:
            count, at = number(data, start)
            found = {}
            for i in range(count):
                size, at = number(data, at)
                found[before + i] = (at, at + size)
                at += size
            return start, end, found
    raise ValueError("the program has no code")


def definitions():
    """Folder by the last name of a function."""
    folders = defaultdict(Counter)
    for base in ("core/src", "core/include", "wasm"):
        for path in sorted((root / base).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            folder = str(path.relative_to(root).parent)
            weight = 3 if path.suffix == ".cpp" else 1
            for name in re.findall(r"^[\w:<>,&* ]*?\b(\w+)\((?!\*)[^;]*?$", path.read_text(encoding="utf-8"), re.MULTILINE):
                folders[name][folder] += weight
    return {name: found.most_common(1)[0][0] for name, found in folders.items()}


def folder_of(name, folders):
    plain = re.sub(r"<[^<>]*>", "", re.sub(r"<[^<>]*>", "", re.sub(r"<[^<>]*>", "", name)))
    plain = plain.replace("(anonymous namespace)", "anonymous")
    last = re.split(r"\(", plain)[0].split("::")[-1].split(" ")[-1].split("\\")[0]
    if "evenlift" in name and not name.startswith("std::"):
        for word in reversed(re.findall(r"\w+", plain.split("(")[0])):
            if word in folders:
                return folders[word]
        return "evenlift, other"
    if name.startswith("Im") or "ImGui" in name or "stb" in name or "imgui" in name.lower():
        return "Dear ImGui"
    if name.startswith(("SDL_", "Emscripten_", "SDL", "Emscripten")):
        return "SDL"
    if "std::" in name:
        for word in re.findall(r"evenlift::(?:view::)?(?:anonymous::)?(\w+)", name.replace("(anonymous namespace)", "anonymous")):
            if word in folders:
                return folders[word] + " (templates)"
        return "library of C++"
    if name in folders or last in folders:
        return folders.get(name, folders.get(last))
    return "library of C, and other"


def without(data, start, end, emptied):
    out, (count, at) = bytearray(), number(data, start)
    out += leb(count)
    for _ in range(count):
        size, begin = number(data, at)
        body = b"\x00\x00\x0b" if begin in emptied else data[begin:begin + size]
        out += leb(len(body)) + body
        at = begin + size
    return data[:start] + bytes(out) + data[end:]


def main():
    with tempfile.TemporaryDirectory() as folder:
        data, names = linked(Path(folder))
    start, end, found = bodies(data)
    folders = definitions()
    whole = len(gzip.compress(data, 9, mtime=0))
    groups, raw = defaultdict(set), Counter()
    for index, (begin, finish) in found.items():
        group = folder_of(names.get(index, "?"), folders)
        groups[group].add(begin)
        raw[group] += finish - begin
    print(f"{whole:>9,}  {len(data):>9,}  all; gzip -9, and raw")
    rows = sorted(((whole - len(gzip.compress(without(data, start, end, group), 9, mtime=0)), raw[name], len(group), name)
                   for name, group in groups.items()), reverse=True)
    for packed, size, count, name in rows:
        print(f"{packed:>9,}  {size:>9,}  {name} ({count} functions)")
    rest = without(data, start, end, {begin for begin, _ in found.values()})
    print(f"{len(gzip.compress(rest, 9, mtime=0)):>9,}  {len(rest):>9,}  data, types and tables without any function")


main()
