"""Builds a wheel of the Python package, installs it into a separate folder, and uses it from there.

    EVENLIFT_BUILD=build/native EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/consumers/check_python.py
    [--compile]

The library inside is the build's own; with --compile, pip compiles it, as it does for users.
"""

import re
import sys
import zipfile

from installed import build, expect, main, program, root, run, samples, version

usage = (root / "tests/consumers/python/usage.py").resolve()


def check_wheel(wheel):
    """It is for this platform and any Python 3, contains all needed files, and no path of the build."""
    expect(re.fullmatch(rf"evenlift-{re.escape(version())}-py3-none-\w+\.whl", wheel.name), f"it is called {wheel.name}")
    names = set(zipfile.ZipFile(wheel).namelist())
    sources = {path.name for path in (root / "python/src/evenlift").iterdir() if path.suffix in (".py", ".pyi", ".typed")}
    wanted = {f"evenlift/{name}" for name in sources | {"libevenlift.so"}}
    expect({"__init__.py", "types.py", "_members.pyi", "py.typed"} <= sources, f"the sources are {sources}")
    inside = {name for name in names if not name.startswith(f"evenlift-{version()}.dist-info/")}
    expect(inside == wanted, f"it holds {inside}")


def check(folder):
    sources = set((root / "python").rglob("*"))
    prebuilt = {} if "--compile" in sys.argv else {"EVENLIFT_LIBRARY": str(build / "c/libevenlift.so")}
    run(
        sys.executable, "-m", "pip", "wheel", root / "python", "--no-deps", "--no-build-isolation", "--no-index",
        "--wheel-dir", folder / "wheels", **prebuilt,
    )  # fmt: skip
    wheels = list((folder / "wheels").iterdir())
    expect(len(wheels) == 1, f"there are {len(wheels)} wheels")
    check_wheel(wheels[0])
    run(sys.executable, "-m", "pip", "install", "--no-index", "--no-deps", "--target", folder / "site", wheels[0])
    print(run(sys.executable, "-B", usage, program, *samples, cwd=folder, PYTHONPATH=str(folder / "site")), end="")
    # Everything except arrays works without NumPy.
    (folder / "without").mkdir()
    (folder / "without/numpy.py").write_text("raise ImportError('there is no NumPy here')\n")
    path = f"{folder / 'without'}:{folder / 'site'}"
    code = (
        "import evenlift; p = evenlift.place([(0, 0), (4, 0), (4, 3)]); assert p._repr_svg_().startswith('<svg')\n"
        "try: p.arrays()\nexcept ImportError: print('well')"
    )
    expect(run(sys.executable, "-B", "-c", code, cwd=folder, PYTHONPATH=path) == "well\n", "it needs NumPy")
    left = set((root / "python").rglob("*")) - sources
    expect(not left, f"the build left something in the sources: {left}")
    return f"{len(samples)} samples"


sys.exit(main(check))
