#!/usr/bin/env python3
"""Makes the polygons of this folder: a set for experiments like the one that section 5.2 of the thesis describes.

    python3 assets/thesis-like/generate.py [--program build/bin/evenlift] [--out FOLDER]

The same program gives the same files, byte for byte, on every platform: outlines and centroids come from evenlift itself,
and what is drawn here by chance needs no function that differs between systems. assets/README.md describes the set.
"""

import argparse
import json
import pathlib
import random
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

# How far a centre of mass is moved: parts of the way from the centroid to a place on the convex hull's boundary.
NEAR = (0.05, 0.25)
MIDDLE = (0.2, 0.5)
FAR = (0.7, 0.95)

# How far a vertex of a convex outline is moved towards the centroid to make it non-convex: parts of the way.
NOTCH = (0.3, 0.7)

CLASSES = [
    # name, family of `evenlift generate`, title, numbers of vertices, those with a third centre, which is moved far
    ("regular", "regular", "Regular", (3, 4, 5, 6, 8, 9, 10, 12, 15, 20, 30, 40), None),
    ("convex", "convex", "Irregular convex", (3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 20, 40), (4, 6, 8, 12)),
    ("notched", "convex", "Notched", (4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 20, 36), (5, 7, 9, 12)),
    ("star", "star", "Star-shaped", (5, 6, 8, 10, 13, 20, 30, 45), (6, 10)),
]


def points(text):
    """The vertices of a text in the thesis's format, which is what `evenlift generate` writes."""
    return [tuple(map(float, line.strip("()").split(","))) for line in text.splitlines()]


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def convex_hull(vertices):
    """Its corners counter-clockwise: Andrew's two chains."""
    chains = []
    for ordered in (sorted(vertices), sorted(vertices, reverse=True)):
        chain = []
        for p in ordered:
            while len(chain) >= 2 and cross(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains += chain[:-1]
    return chains


def moved_centre(vertices, centroid, how_far, rng):
    """A centre of mass, in whole numbers: part of the way to a place anywhere on a random side of the hull."""
    hull = convex_hull(vertices)
    side = int(rng.random() * len(hull))
    a, b = hull[side], hull[(side + 1) % len(hull)]
    along = rng.random()
    part = how_far[0] + (how_far[1] - how_far[0]) * rng.random()
    target = [a[axis] + along * (b[axis] - a[axis]) for axis in (0, 1)]
    return tuple(round(centroid[axis] + part * (target[axis] - centroid[axis])) for axis in (0, 1))


def notched(vertices, centroid, rng):
    """The outline with every third vertex moved towards the centroid, in whole numbers: still seen from there as a whole."""
    moved = []
    for i, vertex in enumerate(vertices):
        part = NOTCH[0] + (NOTCH[1] - NOTCH[0]) * rng.random() if i % 3 == 1 else 0
        moved.append(tuple(round(v + part * (c - v)) if part else v for v, c in zip(vertex, centroid)))
    return "".join(f"({x:g},{y:g})\n" if isinstance(x, int) else f"({x!r},{y!r})\n" for x, y in moved)


class Program:
    def __init__(self, path):
        self.path = str(path)

    def run(self, *arguments, text=None):
        return subprocess.run([self.path, *map(str, arguments)], input=text, capture_output=True, text=True, check=True).stdout

    def outline(self, family, vertices, seed):
        return self.run("generate", family, "--n", vertices, "--seed", seed)

    def centroid(self, text):
        return json.loads(self.run("place", "-", "--teams", 1, "--json", text=text))["centre_of_mass"]


def make(program):
    """All files by name, and the lines of the index."""
    files, index = {}, []
    for name, family, title, sizes, moved_far in CLASSES:
        index.append(f"\n# {title}")
        for vertices in sizes:
            stem = f"{name}-{vertices}"
            rng = random.Random(stem)  # of its own: a class that changes changes no other
            outline = program.outline(family, vertices, vertices)
            if name == "notched":
                outline = notched(points(outline), program.centroid(outline), rng)
            files[stem] = outline
            words = f"{title}, {vertices} {'sides' if family == 'regular' else 'vertices'}"
            index.append(f"{stem:<20} {words}")
            if moved_far is None:
                continue
            for number, how_far in enumerate((NEAR, MIDDLE, FAR) if vertices in moved_far else (NEAR, MIDDLE), 1):
                x, y = moved_centre(points(outline), program.centroid(outline), how_far, rng)
                files[f"{stem}-moved-{number}"] = f"CoM:({x},{y})\n{outline}"
                index.append(f"{stem + f'-moved-{number}':<20} {words}, centre moved ({number})")
    return files, index


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build" / "bin" / "evenlift", help="evenlift (default build/bin/evenlift)")
    parser.add_argument("--out", type=pathlib.Path, default=HERE, help="the folder to write to (default this script's)")
    given = parser.parse_args()
    files, index = make(Program(given.program))
    given.out.mkdir(parents=True, exist_ok=True)
    for old in given.out.glob("*.txt"):
        old.unlink()
    for name, text in files.items():
        (given.out / f"{name}.txt").write_text(text, encoding="utf-8", newline="\n")
    heading = "# Made by generate.py: a file's name without .txt, then its title.\n"
    (given.out / "index.txt").write_text(heading + "\n".join(index) + "\n", encoding="utf-8", newline="\n")
    print(f"{len(files)} polygons in {given.out}")


if __name__ == "__main__":
    main()
