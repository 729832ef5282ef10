#!/usr/bin/env python3
"""The terminal's display during a long computation.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/program/test_waiting.py
"""

import os
import pathlib
import pty
import subprocess
import tempfile
import unittest

PROGRAM = os.path.abspath(os.environ.get("EVENLIFT_PROGRAM", "build/bin/evenlift"))
ERASE = rb"\r\x1b\[K"


def run(*arguments, errors=subprocess.PIPE):
    return subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=errors, env={**os.environ, "TERM": "xterm"})


def run_on_terminal(*arguments):
    """The output, and the standard error as a terminal shows it."""
    master, slave = pty.openpty()
    with run(*arguments, errors=slave) as process, os.fdopen(master, "rb", buffering=0) as terminal:
        os.close(slave)
        seen = b""
        try:
            while chunk := terminal.read(4096):
                seen += chunk
        except OSError:
            pass  # Linux's sign that no writer is left
        return process.stdout.read(), seen


class Waiting(unittest.TestCase):
    def shape(self, family):
        folder = tempfile.TemporaryDirectory(prefix="evenlift-waiting-")
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / family
        with run("generate", family, "--n", "500") as process:
            file.write_bytes(process.stdout.read())
        return str(file)

    def assert_shown_and_erased(self, what, seen):
        self.assertRegex(seen, rb"\A(" + ERASE + what + rb": \d+\.\d s)+" + ERASE + rb"\Z")

    def assert_begins_with(self, what, seen):
        """Other work may follow."""
        self.assertRegex(seen, rb"\A(" + ERASE + what + rb": \d+\.\d s)+(" + ERASE + rb"[a-z ]+: \d+\.\d s)*" + ERASE + rb"\Z")

    def test_a_terminal_sees_how_long_robots_are_being_placed_and_nothing_else_does(self):
        arguments = ["place", self.shape("comb"), "--metric", "balanced", "--robots", "4"]
        output, seen = run_on_terminal(*arguments)
        self.assert_begins_with(b"placing the robots", seen)
        with run(*arguments) as process:
            self.assertEqual(process.communicate(), (output, b""))

    def test_a_terminal_sees_which_shape_is_being_placed(self):
        shape = self.shape("comb")
        points = [line.strip("()") for line in pathlib.Path(shape).read_text().splitlines() if line.startswith("(")]
        pathlib.Path(shape).write_text("\n".join([*points, "", "0,0", "1,0", "0,1", ""]))
        output, seen = run_on_terminal("place", shape, "--shape", "all", "--jobs", "1", "--metric", "balanced", "--robots", "4")
        self.assertIn(b"\r\x1b[Kplacing the robots, shape 1 of 2: ", seen)

    def test_a_terminal_sees_how_long_choices_are_being_compared(self):
        # Without the limit this takes several seconds.
        output, seen = run_on_terminal("optimum", self.shape("star"), "--teams", "60", "--time-limit", "1")
        self.assertTrue(output.startswith(b"60 teams among "), output)
        self.assert_shown_and_erased(b"comparing choices of teams", seen)


if __name__ == "__main__":
    unittest.main()
