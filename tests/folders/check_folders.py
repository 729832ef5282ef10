"""Checks that the folders of the code match their READMEs, and that no two use each other in a circle.

    python3 tests/folders/check_folders.py

The README.md of a folder of sources describes its input and output, and ends with these lines:

    Public headers: polygon.h, hull.h.     of core/include/evenlift, in folders of the core that have any
    May use: exact, errors.                the folders whose files it includes or imports, or "no other folder"
    May load later: windows.               the folders from which it loads files with import(), in web only

These folders are in core/src, native, wasm and web, and docs/architecture.md has the plan of them: each is below, or
to the right of, all folders that it uses. Folders that are loaded later may be anywhere. The folders of tests must
also be free of circles, and so must the files: no headers include each other in a circle, and no scripts import each
other in one.

What writes or draws results includes evenlift/report.h, and no header that computes a fact about a placement.

The state of the view (state_sources in wasm/CMakeLists.txt) is built without Dear ImGui, so none of its files may
use a file that belongs to the view.
"""

import pathlib
import posixpath
import re
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
most_files = 24
include = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
imported = re.compile(r'(?:\bfrom|^import) "(\.\.?/[^"]+)"', re.MULTILINE)
loaded_later = re.compile(r'\bimport\("(\./[^"]+)"\)')
problems = []


def sources(folder):
    return [f for f in folder.iterdir() if f.suffix in (".h", ".cpp", ".js", ".mjs") and f.is_file()]


def folders_of(tree):
    """The folders with sources, by their path within the tree."""
    folders = [p for p in sorted(tree.rglob("*")) if p.is_dir() and "node_modules" not in p.parts and sources(p)]
    return {folder.relative_to(tree).as_posix(): folder for folder in folders}


def line_of(readme, heading):
    found = re.search(rf"^{heading}: (.*)\.$", readme, re.MULTILINE)
    return found[1].split(", ") if found and found[1] != "no other folder" else []


def paths_in(file):
    text = file.read_text(encoding="utf-8")
    return include.findall(text) + imported.findall(text)


def uses_of(files, name, target_of):
    """The other folders that these files use."""
    used = set()
    for file in files:
        for path in paths_in(file):
            target = target_of(file, path)
            if target is not None and target != name:
                used.add(target)
    return used


def loads_of(folder, name, folders):
    """The other folders from which a file is loaded later. Such a file has no folder in its path: the page is one flat folder."""
    paths = {path for file in sources(folder) for path in loaded_later.findall(file.read_text())}
    return {other_name for other_name, other in folders.items() if other_name != name and any((other / path).is_file() for path in paths)}


def planned(tree, folders):
    """The folders in the order of the plan: line by line, each from the left."""
    block = re.search(r"## The plan\n.*?```\n(.*?)```", (root / "docs/architecture.md").read_text(), re.DOTALL)[1]
    order, now = [], ""
    for line in block.splitlines():
        head = re.match(r"\S+", line)
        now = head[0] if head else now
        cells = re.split(r"\s{2,}", line[head.end() if head else 0 :].strip())
        order += [cell for cell in cells if cell in folders] if now == tree else []
    return order


def check_plan(tree, graph):
    order = planned(tree, graph)
    for name in graph:
        if order.count(name) != 1:
            problems.append(f"docs/architecture.md names {tree}/{name} {order.count(name)} times in its plan")
            continue
        for used in sorted(graph[name] & set(order[order.index(name) :])):
            problems.append(f"{tree}/{name} uses {used}, which comes after it in the plan of docs/architecture.md")


def circles(graph):
    """Circles of names, in which each uses the next, and the last the first. Each name is in at most one circle."""
    left = {name: set(used) for name, used in graph.items()}
    while left:
        gone = [name for name, used in left.items() if not used & left.keys()]
        if not gone:
            walk = [min(left)]
            while (following := min(left[walk[-1]] & left.keys())) not in walk:
                walk.append(following)
            gone = walk[walk.index(following) :]
            yield gone
        for name in gone:
            del left[name]


def check_circles(tree, graph, kind):
    for circle in circles(graph):
        first, *others = circle
        problems.append(f"{kind} of {tree} make a circle: {first} uses {', which uses '.join([*others, first])}")


def uses_of_files(tree):
    """For the headers and scripts of a tree, the files that each uses, by their paths within the tree."""
    files = {f.relative_to(tree).as_posix(): f for folder in [tree, *folders_of(tree).values()] for f in sources(folder)}

    def target_of(name, path):
        folders = [posixpath.dirname(name), "", "src", "include"]  # in the compiler's order
        places = [posixpath.normpath(posixpath.join(folder, path)) for folder in folders]
        return next((place for place in places if place in files), None)

    return {name: {target_of(name, path) for path in paths_in(f)} for name, f in files.items() if f.suffix != ".cpp"}


def check_files():
    for tree in ["core", "c", "wasm", "native", "npm", "web", "tests"]:
        check_circles(tree, uses_of_files(root / tree), "files")


def check_readme(tree, name, folder, used, loaded=frozenset()):
    path = folder / "README.md"
    if not path.exists():
        problems.append(f"{tree}/{name} has no README.md")
        return
    for heading, verb, found in [("May use", "use", used), ("May load later", "load", loaded)]:
        said = set(line_of(path.read_text(), heading))
        for other in sorted(found - said):
            problems.append(f"{tree}/{name} {verb}s {other}, which its README does not say")
        for other in sorted(said - found):
            problems.append(f"{tree}/{name} does not {verb} {other}, as its README says")


def check_size(tree, name, folder):
    count = len(sources(folder))
    if count > most_files:
        problems.append(f"{tree}/{name} has {count} files: split it")


def check_core():
    tree = root / "core/src"
    public = root / "core/include/evenlift"
    folders = folders_of(tree)
    owner = {}
    for name, folder in folders.items():
        readme = folder / "README.md"
        for header in line_of(readme.read_text(), "Public headers") if readme.exists() else []:
            if header in owner:
                problems.append(f"{header} belongs to core/src/{owner[header]} and to core/src/{name}")
            owner[header] = name
    headers = {h.relative_to(public).as_posix(): h for h in public.rglob("*.h")}
    for header in sorted(headers.keys() - owner.keys()):
        problems.append(f"core/include/evenlift/{header} belongs to no folder of core/src")
    for header in sorted(owner.keys() - headers.keys()):
        problems.append(f"core/src/{owner[header]}/README.md names {header}, which is not a public header")

    def target_of(_, path):
        if path.startswith("evenlift/"):
            return owner.get(path[len("evenlift/") :])
        return pathlib.PurePosixPath(path).parent.as_posix()

    graph = {}
    for name, folder in folders.items():
        own = [headers[h] for h, of in owner.items() if of == name and h in headers]
        graph[name] = uses_of(sources(folder) + own, name, target_of)
        check_readme("core/src", name, folder, graph[name])
        check_size("core/src", name, folder)
    check_circles("core/src", graph, "folders")
    check_plan("core/src", graph)


def check_tree(tree, with_readmes):
    folders = folders_of(root / tree)

    def target_of(file, path):
        if path.startswith("."):
            at = (file.parent / path).resolve().parent
            return at.relative_to(root / tree).as_posix() if at.is_relative_to(root / tree) and at != root / tree else None
        parent = pathlib.PurePosixPath(path).parent.as_posix()
        return parent if parent in folders else None

    graph = {}
    for name, folder in folders.items():
        graph[name] = uses_of(sources(folder), name, target_of)
        check_size(tree, name, folder)
        if with_readmes:
            check_readme(tree, name, folder, graph[name], loads_of(folder, name, folders))
    check_circles(tree, graph, "folders")
    if with_readmes:
        check_plan(tree, graph)


def check_state():
    tree = root / "wasm"
    state = re.search(r"set\(state_sources\n(.*?)\)", (tree / "CMakeLists.txt").read_text(), re.DOTALL)[1].split()
    for name in state:
        reached, waiting = set(), [name]
        while waiting:
            path = waiting.pop()
            if path in reached:
                continue
            reached.add(path)
            waiting += [used for used in include.findall((tree / path).read_text()) if (tree / used).is_file()]
        for used in sorted(reached):
            source = used.removesuffix(".h") + ".cpp"
            if (tree / source).is_file() and source not in state:
                problems.append(f"wasm/{name} is built without Dear ImGui, but uses {used}, whose source is not")


def check_facts():
    """Facts about a placement come from its report: what writes or draws them computes none."""
    computes = {f"evenlift/{name}.h" for name in ["accuracy", "capacity", "equilibrium", "extra_load", "failures", "load_models",
                                                  "placed_robots", "placement", "tilt", "uncertainty"]}
    for tree in ["core/include/evenlift/output", "core/src/output", "native/print", "wasm/marks", "wasm/panels", "wasm/picture"]:
        for file in sorted((root / tree).rglob("*.[ch]*")):
            for path in sorted(computes & set(paths_in(file))):
                problems.append(f"{file.relative_to(root)} includes {path}: it must read report.h")


def check_itself():
    texts = {
        "a.h": '#include <map>\n#include "folder/b.h"',
        "a.cpp": '#include "a.h"',
        "include/tree/a.h": '#include "b.h"',
        "include/tree/b.h": "",
        "folder/b.h": '#include "c.h"',
        "folder/c.h": '#include "folder/d.h"\n#include "tree/a.h"',
        "folder/d.h": '#include "folder/b.h"',
        "page/a.js": 'import {\n  b,\n} from "./b.mjs";\nconst later = () => import("./d.js");',
        "page/b.mjs": 'import "../parts/c.js";',
        "page/d.js": 'import { a } from "./a.js";',
        "parts/c.js": 'export { a } from "../page/a.js";',
    }
    with tempfile.TemporaryDirectory() as folder:
        for name, text in texts.items():
            file = pathlib.Path(folder, name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        found = list(circles(uses_of_files(pathlib.Path(folder))))
    assert found == [["folder/b.h", "folder/c.h", "folder/d.h"], ["page/a.js", "page/b.mjs", "parts/c.js"]], found


check_itself()
check_facts()
check_core()
check_state()
check_files()
check_tree("native", with_readmes=True)
check_tree("wasm", with_readmes=True)
check_tree("web", with_readmes=True)
check_tree("tests", with_readmes=False)
for problem in problems:
    print(problem)
print("the folders match their READMEs" if not problems else f"{len(problems)} problems")
sys.exit(1 if problems else 0)
