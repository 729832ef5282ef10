"""Runs mypy and pyright on the Python package, on correct uses of it, and on wrong ones.

    EVENLIFT_MYPY=mypy EVENLIFT_PYRIGHT=tests/page/node_modules/.bin/pyright python3
    tests/consumers/python/check_types.py

Nothing of it is built or run. The Python that runs this file must have NumPy, because its types are also looked up.
"""

import ast
import builtins
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
root = here.parents[2]
sources = root / "python/src"
mypy = os.environ.get("EVENLIFT_MYPY") or "mypy"
pyright = os.environ.get("EVENLIFT_PYRIGHT") or str(root / "tests/page/node_modules/.bin/pyright")


class Failed(Exception):
    pass


def output_of(*command, cwd):
    """The output of a checker, which ends with status 1 if it found something."""
    done = subprocess.run(
        [*map(str, command)], cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False
    )
    if done.returncode not in (0, 1):
        raise Failed(f"{command[0]}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


# Each returns the complaints about a folder's files, as {(file's name, line): message}.


def mypy_complaints(folder):
    # Before mypy 1.7, `Unpack` was unfinished but sufficient.
    shown = ["--no-error-summary", "--hide-error-context", "--no-pretty", "--config-file=", f"--cache-dir={folder.parent / 'cache'}"]
    options = ["--strict", "--enable-incomplete-feature=Unpack", f"--python-executable={sys.executable}"]
    printed = output_of(mypy, *options, *shown, ".", cwd=folder)
    found = [re.fullmatch(r"(.+?):(\d+): error: (.*)", line) for line in printed.splitlines()]
    return {(pathlib.Path(each[1]).name, int(each[2])): each[3] for each in found if each}


def pyright_complaints(folder):
    # Strict, except for values that wrong_usage.py does not use and for consequences of its mistakes.
    unknown = {f"reportUnknown{what}Type": False for what in ("Argument", "Member", "Variable")}
    project = {"include": ["."], "typeCheckingMode": "strict", "reportUnusedExpression": False, **unknown}
    (folder / "pyrightconfig.json").write_text(json.dumps(project))
    found = json.loads(output_of(pyright, "--outputjson", "--pythonpath", sys.executable, "-p", folder, cwd=folder))
    if found["summary"]["filesAnalyzed"] < len(list(folder.rglob("*.py*"))):
        raise Failed(f"pyright looked at {found['summary']['filesAnalyzed']} files")
    return {(pathlib.Path(each["file"]).name, each["range"]["start"]["line"] + 1): each["message"] for each in found["generalDiagnostics"]}


def members_file():
    """A program that checks each member of a result against its type in the TypedDict: the types of _members.pyi are written separately."""
    tree = ast.parse((sources / "evenlift/types.py").read_text(encoding="utf-8"))
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    lines, used = [], set()
    for result, names in (("Placement", ["_PlacementDict", "PlacementDict"]), ("Experiment", ["ExperimentDict"])):
        lines.append(f"def of_{result}(it: evenlift.{result}) -> None:")
        members = [member for name in names for member in classes[name].body if isinstance(member, ast.AnnAssign)]
        if len(members) < 8:
            raise Failed(f"types.py tells {len(members)} members of {result}")
        for member in members:
            used |= {node.id for node in ast.walk(member.annotation) if isinstance(node, ast.Name)}
            name, hint = member.target.id, ast.unparse(member.annotation)
            lines += [f"    assert_type(it[{name!r}], {hint})", f"    assert_type(it.get({name!r}), Optional[{hint}])"]
    general = used & {"Literal", "Union"} | {"Optional"}
    imports = ["import evenlift", f"from typing import {', '.join(sorted(general))}", "from typing_extensions import assert_type"]
    imports += [f"from evenlift.types import {name}" for name in sorted(used - general - set(dir(builtins)))]
    return "\n".join(["from __future__ import annotations", *imports, *lines]) + "\n"


def wrong_lines(file):
    return {(file.name, number) for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1) if line.endswith("# wrong")}


def lay_out(folder):
    """The package, its users, and the program that checks each member."""
    shutil.copytree(sources / "evenlift", folder / "evenlift", ignore=shutil.ignore_patterns("__pycache__", "*.so", "*.dylib", "*.dll"))
    for name in ("typed_usage.py", "wrong_usage.py"):
        shutil.copyfile(here / name, folder / name)
    (folder / "members.py").write_text(members_file())


def check(name, complaints):
    expected = wrong_lines(here / "wrong_usage.py")
    if not expected:
        raise Failed("wrong_usage.py has no wrong lines")
    too_many = {place: complaints[place] for place in complaints.keys() - expected}
    missing = expected - complaints.keys()
    if too_many or missing:
        raise Failed(f"{name} complains of {too_many}, and not of {missing}")


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve() / "project"
        lay_out(folder)
        check("mypy", mypy_complaints(folder))
        check("pyright", pyright_complaints(folder))
    print("mypy and pyright find what is wrong, and nothing else")


if __name__ == "__main__":
    try:
        main()
    except Failed as failure:
        sys.exit(f"FAILED: {failure}")
