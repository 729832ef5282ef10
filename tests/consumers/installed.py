"""Shared by the tests of installed packages: installing into a separate folder, and running commands there."""

import os
import pathlib
import shutil
import subprocess
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
build = pathlib.Path(os.environ["EVENLIFT_BUILD"]).resolve()
program = pathlib.Path(os.environ["EVENLIFT_PROGRAM"]).resolve()
samples = [path for path in sorted((root / "assets/polygons").glob("*.txt")) if path.name != "index.txt"]
# Nothing from the build's environment may reach its users.
clean_environment = {name: value for name, value in os.environ.items() if not name.startswith(("CMAKE_PREFIX", "PKG_CONFIG"))}


class Failed(Exception):
    pass


def run(*command, cwd=None, expect=0, **environment):
    """The command's standard output. Any unexpected status is a failure."""
    done = subprocess.run(
        [str(part) for part in command],
        cwd=cwd,
        env={**clean_environment, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=False,
    )
    if done.returncode != expect:
        shown = " ".join(map(str, command))[:200]
        raise Failed(f"{shown}: status {done.returncode}\n{done.stdout.decode()}{done.stderr.decode()}")
    return done.stdout.decode()


def expect(true, what):
    if not true:
        raise Failed(what)


def version():
    """The program's version, which all packages must also report."""
    return run(program, "--version").split()[1]


def compiler():
    """The compilers of the build: anything linked with it must use them, for instance because of a sanitizer."""
    cache = (build / "CMakeCache.txt").read_text()
    entries = dict(line.split("=", 1) for line in cache.splitlines() if "=" in line and not line.startswith(("#", "//")))
    named = {name.split(":")[0]: value for name, value in entries.items()}
    return named["CMAKE_CXX_COMPILER"], named.get("CMAKE_CXX_FLAGS", "").split()


def installed_into(folder):
    """Installs, and then moves the installed files: none of them may contain the place where it was made."""
    run("cmake", "--install", build, "--prefix", folder / "first")
    shutil.move(folder / "first", folder / "installed")
    return folder / "installed"


def library_folder(prefix):
    """lib, lib64 or lib/x86_64-linux-gnu, depending on the system."""
    return next(prefix.glob("**/pkgconfig")).parent


def main(check):
    with tempfile.TemporaryDirectory() as folder:
        try:
            print(check(pathlib.Path(folder)))
        except Failed as failure:
            print(failure)
            return 1
    return 0
