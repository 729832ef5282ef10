#!/usr/bin/env python3
"""Packs a release of the built files twice, in two folders, and inspects it. Uses EVENLIFT_PAGE, EVENLIFT_BIN,
EVENLIFT_NPM and EVENLIFT_LIBRARY, or build/page, build/bin, build/npm and build/native/c/libevenlift.so. The sources
are a copy committed to git, so that uncommitted changes have no effect."""
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path

root = Path(__file__).resolve().parent.parent.parent
folders = {name: Path(os.environ.get(f"EVENLIFT_{name.upper()}", root / "build" / name)) for name in ("page", "bin", "npm")}
library = Path(os.environ.get("EVENLIFT_LIBRARY", root / "build/native/c/libevenlift.so"))
version = re.search(r"^project\(evenlift VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


def git(folder, *args):
    who = {"GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b",
           "GIT_AUTHOR_DATE": "1700000000 +0000", "GIT_COMMITTER_DATE": "1700000000 +0000"}
    subprocess.run(["git", *args], cwd=folder, check=True, env={**os.environ, **who}, stdout=subprocess.DEVNULL)


def sources(folder):
    """The parts of the sources that a release reads, committed."""
    folder.mkdir(parents=True)
    for name in ("CMakeLists.txt", "CHANGELOG.md", "CITATION.cff", "LICENSE", "README.md", "cmake/release.py", "docs/cli.md"):
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(root / name, folder / name)
    shutil.copytree(root / "python", folder / "python", ignore=shutil.ignore_patterns("__pycache__", "*.so", "*.egg-info"))
    git(folder, "init", "--quiet")
    git(folder, "add", "-A")
    git(folder, "commit", "--quiet", "-m", "As it is")


def pack(copy, built=None, expect=0):
    built = built or folders
    done = subprocess.run(["python3", "cmake/release.py", "out", f"--library={library}",
                           *(f"--{name}={path}" for name, path in built.items())], cwd=copy,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert done.returncode == expect, done.stderr
    return done.stderr if expect else {file.name: file.read_bytes() for file in (copy / "out").iterdir()}


class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        work = Path(cls.work.name)
        for name in ("one", "folder/of/another"):
            sources(work / name)
        cls.copy = work / "one"
        cls.files = pack(work / "one")
        # The built files are also copied: their times and place must not matter.
        built = {name: work / "built" / name for name in folders}
        for name, path in built.items():
            shutil.copytree(folders[name], path, copy_function=shutil.copyfile)
            for file in path.iterdir():
                file.chmod((folders[name] / file.name).stat().st_mode)
        cls.again = pack(work / "folder/of/another", built)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def test_the_same_bytes_twice(self):
        self.assertEqual(self.files.keys(), self.again.keys())
        for name, data in self.files.items():
            self.assertEqual(data, self.again[name], name)

    def test_what_is_in_it(self):
        kinds = ["-node.tar.gz", "-page.zip", ".tar.gz", ".tgz"]
        for kind in kinds:
            self.assertIn(f"evenlift-{version}{kind}", self.files)
        lines = self.files["SHA256SUMS"].decode().splitlines()
        self.assertEqual([line.split("  ")[1] for line in lines], sorted(self.files.keys() - {"SHA256SUMS"}))
        for line in lines:
            hashed, name = line.split("  ")
            self.assertEqual(hashlib.sha256(self.files[name]).hexdigest(), hashed)

    def test_the_page_is_whole(self):
        archive = zipfile.ZipFile(io.BytesIO(self.files[f"evenlift-{version}-page.zip"]))
        names = {name.removeprefix("evenlift/") for name in archive.namelist()}
        worker = archive.read("evenlift/service_worker.js").decode()
        listed = json.loads(re.match(r"const build = (\{.*\});\n", worker)[1])["files"]
        self.assertEqual(names, {*listed, "service_worker.js"})
        self.assertIn("index.html", names)
        for name, hashed in listed.items():
            self.assertEqual(hashlib.sha256(archive.read(f"evenlift/{name}")).hexdigest(), hashed)

    def test_the_program_runs(self):
        name = next(name for name in self.files if re.fullmatch(r"evenlift-[\d.]+-(linux|darwin)-\w+\.tar\.gz", name))
        with tempfile.TemporaryDirectory() as folder:
            with tarfile.open(fileobj=io.BytesIO(self.files[name])) as archive:
                archive.extractall(folder)
            program = next(Path(folder).glob("*/bin/evenlift"))
            said = subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True, text=True).stdout
            self.assertEqual(said, f"evenlift {version}\n")

    def test_the_package_is_of_this_version(self):
        with tarfile.open(fileobj=io.BytesIO(self.files[f"evenlift-{version}.tgz"])) as archive:
            self.assertEqual(json.load(archive.extractfile("package/package.json"))["version"], version)

    def test_the_wheel_has_the_library(self):
        name = next(name for name in self.files if re.fullmatch(rf"evenlift-{re.escape(version)}-py3-none-\w+\.whl", name))
        archive = zipfile.ZipFile(io.BytesIO(self.files[name]))
        self.assertEqual(archive.read(f"evenlift/{library.name}"), library.read_bytes())

    def test_changes_that_are_not_committed_are_refused(self):
        readme = self.copy / "README.md"
        before = readme.read_text()
        readme.write_text(before + "\n")
        self.assertIn("not committed", pack(self.copy, expect=1))
        readme.write_text(before)

    def test_a_page_that_is_not_what_it_lists_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page"
            shutil.copytree(folders["page"], page)
            (page / "version.json").write_text("{}")
            self.assertIn("version.json", pack(self.copy, {**folders, "page": page}, expect=1))


if __name__ == "__main__":
    unittest.main()
