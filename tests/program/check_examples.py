"""Runs the examples of README.md, docs and examples, and compares their output with the text that follows each example.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/program/check_examples.py [--update]

An example is a block of shell commands immediately followed by a block of text. A line of the text that is only "…"
represents any number of lines. --update writes the present output, except where there is such a line.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
program = pathlib.Path(os.environ["EVENLIFT_PROGRAM"]).resolve()
example = re.compile(r"```sh\n(?P<commands>[^`]*)```\n\n```text\n(?P<printed>[^`]*)```\n")


def printed_by(commands, folder):
    """The output of the commands; files that they write go into the folder."""
    commands = commands.replace("build/bin/", f"{shlex.quote(str(program.parent))}/")
    for tree in ("assets", "examples"):
        commands = commands.replace(f" {tree}/", f" '{root}'/{tree}/")
    done = subprocess.run(["bash", "-c", commands], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.stdout.decode()


def agrees(shown, printed):
    pattern = "".join("(?:.*\n)*?" if line == "…\n" else re.escape(line) for line in shown.splitlines(keepends=True))
    return re.fullmatch(pattern, printed) is not None


def main():
    update = sys.argv[1:] == ["--update"]
    compared = differing = 0
    for path in [root / "README.md", *sorted((root / "docs").glob("*.md")), root / "examples/README.md"]:
        text = path.read_text()
        for found in reversed(list(example.finditer(text))):
            with tempfile.TemporaryDirectory() as folder:
                printed = printed_by(found["commands"], folder)
            compared += 1
            if agrees(found["printed"], printed):
                continue
            if update and "…\n" not in found["printed"]:
                text = text[: found.start("printed")] + printed + text[found.end("printed") :]
                continue
            differing += 1
            line = text.count("\n", 0, found.start()) + 1
            print(f"{path.relative_to(root)}:{line}: these commands print something else now:\n{found['commands']}\n{printed}")
        if update:
            path.write_text(text)
    print(f"{compared} examples, {differing} differ")
    return 1 if differing or compared < 5 else 0


sys.exit(main())
