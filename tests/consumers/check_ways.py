"""Runs the lines of docs/packages.md, "In five lines each", on a copy of what they use, and checks the results.

    EVENLIFT_BUILD=build/native EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/consumers/check_ways.py [--compile]

They begin after `./dev build`, so the copy has its build folder. pip takes the build's own library, unless --compile is given, and
works without a network. The page and the package for npm, which `./dev build` alone does not build here, have tests of their own.
"""

import re
import subprocess
import sys

from installed import build, clean_environment, expect, main, program, root

block = re.compile(r"\*\*(?P<way>[^*]+)\*\*[^`]*(?:`[^`\n]+`[^`]*)*```sh\n(?P<lines>[^`]*)```")
ours = ["The program", "C++", "Python"]


def section():
    text = (root / "docs/packages.md").read_text()
    return re.search(r"^## In five lines each\n(.*?)^## ", text, re.MULTILINE | re.DOTALL)[1]


def copy_of_repository(folder):
    """The repository's folders by links, and a separate build folder."""
    folder.mkdir()
    for path in root.iterdir():
        if path.name not in ("build", ".git"):
            (folder / path.name).symlink_to(path)
    (folder / "build").mkdir()
    (folder / "build/native").symlink_to(build)
    (folder / "build/bin").symlink_to(program.parent)
    return folder


def run_lines(lines, folder):
    offline = {"PIP_NO_INDEX": "1", "PIP_NO_BUILD_ISOLATION": "0", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    if "--compile" not in sys.argv:
        offline["EVENLIFT_LIBRARY"] = str(build / "c/libevenlift.so")
    path = {"PATH": f"{sys.prefix}/bin:{clean_environment['PATH']}"}
    done = subprocess.run(
        ["sh", "-e", "-c", lines], cwd=folder, env={**clean_environment, **offline, **path}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )
    expect(done.returncode == 0, f"these lines failed:\n{lines}\n{done.stdout.decode()}")
    return done.stdout.decode()


def check(folder):
    ways = {found["way"]: found["lines"] for found in block.finditer(section())}
    expect(set(ours) <= set(ways), f"docs/packages.md has the ways {sorted(ways)}")
    folder = copy_of_repository(folder / "evenlift")
    printed = {way: run_lines(ways[way], folder) for way in ours}
    for way in ours:
        expect(len(ways[way].strip().splitlines()) <= 5, f"{way} takes more than five lines")
    expect("6 robots carry" in printed["The program"], printed["The program"])
    expect((folder / "build/piano.svg").read_text().startswith("<svg"), "there is no picture")
    expect("frame_id" in (folder / "build/piano.yaml").read_text(), "there is no message")
    expect(printed["C++"].endswith("coverage 66 %, form closure\n"), printed["C++"])
    expect("'load': 25" in printed["Python"], printed["Python"])
    return f"{len(ours)} ways"


sys.exit(main(check))
