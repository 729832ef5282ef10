#!/usr/bin/env python3
"""The recipe of docs/experiments.md for several machines, over ssh, with one that dies while it works.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/experiment/test_machines.py

Two ssh servers on two addresses of this computer stand for the machines.
"""

import getpass
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import results  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.path.abspath(os.environ.get("EVENLIFT_PROGRAM", ROOT / "build" / "bin" / "evenlift"))
SERVER = shutil.which("sshd") or shutil.which("sshd", path="/usr/sbin")
SOME = ["thesis-sample", "square", "star", "star-moved", "hammer", "letter-e", "gear", "island"]


def free_port(address):
    with socket.socket() as taken:
        taken.bind((address, 0))
        return taken.getsockname()[1]


def answers(address, port):
    with socket.socket() as asking:
        return asking.connect_ex((address, port)) == 0


def children():
    """By process, the processes that it started, and the names of all."""
    started, names = {}, {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            process, name, rest = re.fullmatch(r"(\d+) \((.*)\) (.*)", stat.read_text(errors="replace").strip(), re.S).groups()
        except (OSError, AttributeError):
            continue  # it ended meanwhile
        started.setdefault(int(rest.split()[1]), []).append(int(process))
        names[int(process)] = name
    return started, names


class Machine:
    """An ssh server at an address of this computer."""

    def __init__(self, folder, name, address, path):
        self.name, self.address, self.port = name, address, free_port(address)
        own = folder / name
        own.mkdir()
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", own / "host"], check=True)
        (own / "config").write_text(
            f"ListenAddress {address}\nPort {self.port}\nHostKey {own}/host\nPidFile none\nAuthorizedKeysFile {folder}/key.pub\n"
            f"StrictModes no\nUsePAM no\nPasswordAuthentication no\nPermitRootLogin yes\nMaxStartups 100\nSetEnv PATH={path}\n"
        )
        self.log = (own / "log").open("w+")
        self.server = subprocess.Popen([SERVER, "-D", "-e", "-f", own / "config"], stderr=self.log)
        while not answers(address, self.port):
            if self.server.poll() is not None:
                self.log.seek(0)
                raise RuntimeError(self.log.read())
            time.sleep(0.01)

    def processes(self):
        started, names = children()
        found, todo = [], [self.server.pid]
        while todo:
            found.append(todo.pop())
            todo += started.get(found[-1], [])
        return [(each, names.get(each, "")) for each in found]

    def works(self):
        return any(name == "evenlift" for _, name in self.processes())

    def die(self):
        """All its processes at once, as when its power fails."""
        for process, _ in self.processes():
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.server.wait()
        self.log.close()


@unittest.skipUnless(SERVER and shutil.which("parallel") and shutil.which("ssh-keygen"), "GNU parallel or OpenSSH is not installed")
class Machines(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="evenlift-machines-"))
        self.addCleanup(shutil.rmtree, self.folder, True)
        bin_folder = self.folder / "bin"
        bin_folder.mkdir()
        (bin_folder / "evenlift").symlink_to(PROGRAM)
        self.path = f"{bin_folder}:/usr/local/bin:/usr/bin:/bin"
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", self.folder / "key"], check=True)
        if os.geteuid() == 0:
            os.makedirs("/run/sshd", exist_ok=True)
        self.machines = [Machine(self.folder, name, address, self.path) for name, address in (("first", "127.0.0.1"), ("second", "127.0.0.2"))]
        for machine in self.machines:
            self.addCleanup(machine.die)
        (self.folder / "ssh").write_text(
            "".join(f"Host {m.name}\n  HostName {m.address}\n  Port {m.port}\n" for m in self.machines)
            + f"Host *\n  User {getpass.getuser()}\n  IdentityFile {self.folder}/key\n  StrictHostKeyChecking no\n"
            "  UserKnownHostsFile /dev/null\n  LogLevel ERROR\n"
        )
        (self.folder / "machines").write_text("".join(f"{m.name}\n" for m in self.machines))

    def test_nothing_is_lost_and_nothing_counts_twice_if_a_machine_dies(self):
        """The lines of docs/experiments.md, unchanged."""
        text = (ROOT / "docs" / "experiments.md").read_text(encoding="utf-8")
        recipe = re.search(r"```sh\n(parallel --sshloginfile .*?)```", text, re.S).group(1)
        polygons = self.folder / "assets" / "polygons"
        polygons.mkdir(parents=True)
        for name in SOME:
            shutil.copy(ROOT / "assets" / "polygons" / f"{name}.txt", polygons)
        environment = {**os.environ, "PATH": f"{self.path}:{os.environ['PATH']}", "PARALLEL_SSH": f"ssh -F {self.folder}/ssh", "PARALLEL_HOME": f"{self.folder}/.parallel"}
        run = subprocess.Popen(["sh", "-c", recipe], cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        first = self.machines[0]
        parts = self.folder / "report" / "parts"
        while run.poll() is None and not (first.works() and any(parts.glob("polygon-*"))):
            time.sleep(0.01)
        if run.poll() is not None:
            self.fail(f"it ended before a machine could die: {run.communicate()[0]}")
        first.die()
        said = run.communicate(timeout=1200)[0]
        self.assertEqual(run.returncode, 0, said)
        whole = subprocess.run([PROGRAM, "experiment", "assets/polygons", "--out", "whole"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(whole.returncode, 0, whole.stderr)
        expected = results.contents(self.folder / "whole")
        for name, content in results.contents(self.folder / "report").items():
            self.assertTrue(content == expected[name], f"{name} differs")
        kept = [file.name for file in parts.glob("polygon-*")]
        self.assertEqual(len(kept), len(SOME), kept)


if __name__ == "__main__":
    unittest.main()
