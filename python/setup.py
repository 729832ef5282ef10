"""Builds evenlift's C library with CMake and puts it into the package. The rest is in pyproject.toml.

EVENLIFT_LIBRARY names a library that has already been built; CMAKE_ARGS contains options for CMake.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

here = pathlib.Path(__file__).resolve().parent
project = here.parent
library_name = {"win32": "evenlift.dll", "darwin": "libevenlift.dylib"}.get(sys.platform, "libevenlift.so")


def version():
    """The version of the whole project, from its CMakeLists.txt."""
    cmake = project / "CMakeLists.txt"
    if not cmake.exists():
        raise SystemExit(f"evenlift is built from its whole repository: {cmake} is missing")
    return re.search(r"^project\(evenlift VERSION (\S+)", cmake.read_text(encoding="utf-8"), re.MULTILINE)[1]


def built_library(folder):
    """Compiles the library in the folder and returns its path."""
    if os.environ.get("EVENLIFT_LIBRARY"):
        return pathlib.Path(os.environ["EVENLIFT_LIBRARY"])
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DEVENLIFT_PROGRAM=OFF", "-DEVENLIFT_TESTS=OFF", "-DEVENLIFT_VIEW=OFF"]
    if shutil.which("ninja"):
        options += ["-G", "Ninja"]
    options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
    subprocess.run(["cmake", "-S", project, "-B", folder, *options], check=True)
    subprocess.run(["cmake", "--build", folder, "--config", "Release", "--target", "evenlift_c", "--parallel"], check=True)
    return next(path for path in pathlib.Path(folder).glob(f"c/**/{library_name}"))


class BuildPy(build_py):
    def run(self):
        super().run()
        editable = getattr(self, "editable_mode", False)
        target = here / "src/evenlift" if editable else pathlib.Path(self.build_lib) / "evenlift"
        library = built_library(pathlib.Path(self.get_finalized_command("build").build_temp).resolve() / "cmake")
        target.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(library.resolve(), target / library_name)


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return True  # so that the wheel is specific to this platform


class Wheel(bdist_wheel):
    """For this platform, but for any Python: the library does not depend on Python."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


# Intermediate files go beside the repository's other builds.
made = project / "build/python"
release = version()
made.mkdir(parents=True, exist_ok=True)
setup(
    version=release,
    distclass=WithLibrary,
    cmdclass={"build_py": BuildPy, "bdist_wheel": Wheel},
    options={"build": {"build_base": str(made)}, "egg_info": {"egg_base": str(made)}},
)
