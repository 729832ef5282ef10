#!/usr/bin/env python3
"""Packs the build results for publishing; `./dev release` builds them and calls this script:

    release.py OUT [--page FOLDER] [--bin FOLDER] [--npm FOLDER] [--library FILE]

The defaults are the folders build/page, build/bin and build/npm, and the library build/native/c/libevenlift.so. OUT is replaced by

    evenlift-VERSION.tar.gz            the sources at git's HEAD
    evenlift-VERSION-page.zip          the page, for any static host
    evenlift-VERSION-SYSTEM.tar.gz     the program for this system, such as linux-x86_64
    evenlift-VERSION-node.tar.gz       the program for Node, in WebAssembly
    evenlift-VERSION.tgz               the package for npm
    evenlift-VERSION-….whl             the package for Python, with the library
    SHA256SUMS                         the hashes of all these files

The version is in CMakeLists.txt. The same sources and compilers give the same bytes: entries are sorted, have no owner, and have the
time of the commit.
"""
import argparse
import gzip
import hashlib
import io
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import zipfile
from pathlib import Path

root = Path(__file__).resolve().parent.parent


def run(*command, **options):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, **options).stdout


def version_of_project():
    return re.search(r"^project\(evenlift VERSION (\d+\.\d+\.\d+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


def check_papers(version):
    if not re.search(rf"^## {re.escape(version)}\b", (root / "CHANGELOG.md").read_text(), re.MULTILINE):
        sys.exit(f"release.py: CHANGELOG.md has no section for {version}")
    if f"\nversion: {version}\n" not in (root / "CITATION.cff").read_text():
        sys.exit(f"release.py: CITATION.cff has another version than {version}")


def commit_time():
    return int(run("git", "log", "-1", "--format=%ct", cwd=root))


# --- Archives -----------------------------------------------------------------------------------------------------------


def write_gzip(path, data):
    with open(path, "wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=0) as packed:
        packed.write(data)


def write_tar(path, folder, files, when):
    """`files` contains (name, path) pairs; executable files stay executable."""
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for name, source in sorted(files):
            entry = tarfile.TarInfo(f"{folder}/{name}")
            entry.size, entry.mtime = source.stat().st_size, when
            entry.mode = 0o755 if os.access(source, os.X_OK) and source.suffix in ("", ".sh") else 0o644
            with open(source, "rb") as file:
                tar.addfile(entry, file)
    write_gzip(path, data.getvalue())


def write_zip(path, folder, files, when):
    moment = time.gmtime(max(when, 315619200))[:6]  # zip cannot store times before 1980
    with zipfile.ZipFile(path, "w") as archive:
        for name, source in sorted(files):
            entry = zipfile.ZipInfo(f"{folder}/{name}", moment)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            entry.create_system = 3
            archive.writestr(entry, source.read_bytes(), compresslevel=9)


# --- Published files ----------------------------------------------------------------------------------------------------


def page_files(page):
    """The service worker and the files that it lists, with the listed contents; no remains of an earlier build."""
    first = (page / "service_worker.js").read_text(encoding="utf-8").split("\n", 1)[0]
    listed = json.loads(re.fullmatch(r"const build = (\{.*\});", first)[1])["files"]
    for name, wanted in listed.items():
        if hashlib.sha256((page / name).read_bytes()).hexdigest() != wanted:
            sys.exit(f"release.py: {page / name} is not the file that the service worker lists; build the page again")
    return [(name, page / name) for name in [*listed, "service_worker.js"]]


def pack_sources(out, name):
    if run("git", "status", "--porcelain", "--untracked-files=no", cwd=root):
        sys.exit("release.py: there are changes that are not committed; a release is of a commit")
    write_gzip(out / f"{name}.tar.gz", run("git", "archive", "--format=tar", f"--prefix={name}/", "HEAD", cwd=root))


def pack_programs(out, name, programs, when):
    papers = [(paper, root / paper) for paper in ("LICENSE", "README.md", "CHANGELOG.md", "docs/cli.md")]
    system = f"{platform.system().lower()}-{platform.machine()}"
    for kind, files in [(system, ["evenlift"]), ("node", ["evenlift.js", "evenlift.wasm"])]:
        packed = [(f"bin/{file}", programs / file) for file in files]
        write_tar(out / f"{name}-{kind}.tar.gz", f"{name}-{kind}", packed + papers, when)


def pack_npm(out, package):
    run("npm", "pack", "--silent", "--pack-destination", str(out), str(package))


def python_with_setuptools():
    """The first Python that can build the package."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import setuptools, wheel"], stderr=subprocess.DEVNULL).returncode == 0:
            return python
    sys.exit("release.py: no Python here has setuptools and wheel, which build the package for Python")


def pack_wheel(out, library, when):
    """Builds the package in a copy, so that nothing is left among the sources, with the library that is already built."""
    if not (root / "python/pyproject.toml").exists():
        return
    if not library.exists():
        sys.exit(f"release.py: {library} is missing; build it first")
    with tempfile.TemporaryDirectory() as folder:
        sources = run("git", "archive", "--format=tar", "HEAD", cwd=root)
        with tarfile.open(fileobj=io.BytesIO(sources)) as tar:
            tar.extractall(folder)
        build = "import sys; from setuptools import build_meta; build_meta.build_wheel(sys.argv[1])"
        environment = {**os.environ, "SOURCE_DATE_EPOCH": str(when), "EVENLIFT_LIBRARY": str(library)}
        run(python_with_setuptools(), "-c", build, str(out), cwd=Path(folder) / "python", env=environment)


def write_sums(out):
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in sorted(out.iterdir())]
    (out / "SHA256SUMS").write_text("".join(lines))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    for name in ("page", "bin", "npm"):
        parser.add_argument(f"--{name}", type=Path, default=root / "build" / name)
    parser.add_argument("--library", type=Path, default=root / "build/native/c/libevenlift.so")
    given = parser.parse_args()
    version, when = version_of_project(), commit_time()
    check_papers(version)
    name = f"evenlift-{version}"
    shutil.rmtree(given.out, ignore_errors=True)
    given.out.mkdir(parents=True)
    out = given.out.resolve()
    pack_sources(out, name)
    write_zip(out / f"{name}-page.zip", "evenlift", page_files(given.page), when)
    pack_programs(out, name, given.bin, when)
    pack_npm(out, given.npm.resolve())
    pack_wheel(out, given.library.resolve(), when)
    print("".join(write_sums(out)), end="")


if __name__ == "__main__":
    main()
