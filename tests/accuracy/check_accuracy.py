#!/usr/bin/env python3
"""Robots that are a little off, against what is promised of them; shares no code with evenlift.

    python3 tests/accuracy/check_accuracy.py build/bin/evenlift assets/polygons [--every N] [--seed S] [--seconds T]

Places robots on the samples in several ways, and reads how far each promise says that robots may be off: `accuracy` of
the JSON. Then moves all robots along the outline at random, and all in one sense, by a millionth and a thousandth of
the radius and by all that is allowed, and checks by its own geometry that the robots still fit, that the object still
stands and is held, and that no robot carries more than its capacity. Holds without a bend near are lost just beyond
their limit, if all robots are off in the worst sense. Places that are typed back from the printed table, with its few
digits, keep their verdict. With --seconds the samples and generated polygons are drawn at random, with an accuracy that
searches have to keep; otherwise each sample, or every Nth, has its turn.
"""

import argparse
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

SAFE = 4e-9  # of the object's size: a robot nearer to a corner counts as standing at it


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1])


def plus(a, b, k=1.0):
    return (a[0] + k * b[0], a[1] + k * b[1])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def size(a):
    return math.hypot(*a)


def unit(a):
    return (a[0] / size(a), a[1] / size(a))


def to_segment(a, b, p):
    d = minus(b, a)
    if d == (0, 0):
        return size(minus(p, a))
    t = min(1.0, max(0.0, dot(minus(p, a), d) / dot(d, d)))
    return size(minus(p, plus(a, d, t)))


def cross_each_other(a, b, c, d):
    return cross(minus(b, a), minus(c, a)) * cross(minus(b, a), minus(d, a)) < 0 and cross(
        minus(d, c), minus(a, c)) * cross(minus(d, c), minus(b, c)) < 0


def between(a, b, c, d):
    if cross_each_other(a, b, c, d):
        return 0.0
    return min(to_segment(a, b, c), to_segment(a, b, d), to_segment(c, d, a), to_segment(c, d, b))


class Outline:
    """Counter-clockwise."""

    def __init__(self, vertices):
        n = len(vertices)
        area = sum(cross(vertices[i], vertices[(i + 1) % n]) for i in range(n))
        self.at = [tuple(v) for v in (vertices if area > 0 else vertices[::-1])]
        self.n = n
        self.along = [unit(minus(self.at[(i + 1) % n], self.at[i])) for i in range(n)]
        self.long = [size(minus(self.at[(i + 1) % n], self.at[i])) for i in range(n)]
        self.scale = max(size(minus(a, b)) for a in self.at for b in self.at) if n <= 200 else max(
            size(minus(self.at[0], b)) for b in self.at)
        self.near = 3e-9 * self.scale

    def turn(self, v):
        """The sine of the turn, positive if convex; and whether it is more than 15 degrees."""
        a, b = self.along[v - 1], self.along[v]
        return cross(a, b), dot(a, b) < math.cos(math.radians(15))

    def edge_of(self, p):
        return min(range(self.n), key=lambda e: to_segment(self.at[e], self.at[(e + 1) % self.n], p))

    def inward(self, e):
        return (-self.along[e][1], self.along[e][0])

    def notch_at(self, p):
        for v in range(self.n):
            if size(minus(p, self.at[v])) <= self.near and self.turn(v)[0] < 0 and self.turn(v)[1]:
                return v
        return None

    def moved(self, e, p, way):
        """Along the outline, past all its vertices."""
        t = dot(minus(p, self.at[e]), self.along[e]) + way
        while t > self.long[e]:
            t -= self.long[e]
            e = (e + 1) % self.n
        while t < 0:
            e = (e - 1) % self.n
            t += self.long[e]
        return e, plus(self.at[e], self.along[e], t)

    def contacts(self, e, p):
        """The inward normals at a place. Of a curve's bends, a robot touches one side or the other."""
        for v in (e, (e + 1) % self.n):
            if size(minus(p, self.at[v])) <= self.near:
                sine, is_sharp = self.turn(v)
                if abs(sine) <= 1e-9 or (sine > 0 and not is_sharp):
                    return [self.inward(e)]
                return [] if sine > 0 else [self.inward(v), self.inward(v - 1)]
        return [self.inward(e)]

    def contains(self, p):
        inside = False
        for i in range(self.n):
            a, b = self.at[i], self.at[(i + 1) % self.n]
            if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]):
                inside = not inside
        return inside


def held(wrenches):
    """Whether the origin is strictly inside the wrenches' hull: on both sides of every plane through it and two."""
    def cross3(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    some = False
    for a, b in itertools.combinations(wrenches, 2):
        n = cross3(a, b)
        length = math.sqrt(sum(x * x for x in n))
        if length < 1e-12:
            continue
        some = True
        sides = [sum(x * y for x, y in zip(n, w)) / length for w in wrenches]
        if max(sides) < 1e-13 or min(sides) > -1e-13:
            return False
    return some


def hull(points):
    points = sorted(set(points))
    if len(points) < 3:
        return points
    halves = []
    for order in (points, points[::-1]):
        half = []
        for p in order:
            while len(half) > 1 and cross(minus(half[-1], half[-2]), minus(p, half[-2])) <= 0:
                half.pop()
            half.append(p)
        halves += half[:-1]
    return halves


def depth(points, c):
    """The distance of C from the lines of the hull's edges, negative outside."""
    corners = hull(points)
    if len(corners) < 3:
        return 0.0
    return min(cross(minus(b, a), minus(c, a)) / size(minus(b, a)) for a, b in zip(corners, corners[1:] + corners[:1]))


def by_least_squares(points, c, weights, total):
    """The loads nearest to `weights` that are in equilibrium, all of one sign or not."""
    m = len(points)
    mean = (sum(p[0] for p in points) / m, sum(p[1] for p in points) / m)
    arms = [minus(p, mean) for p in points]
    xx, xy, yy = (sum(a[i] * a[j] for a in arms) for i, j in ((0, 0), (0, 1), (1, 1)))
    det = xx * yy - xy * xy
    missing = [total * (c[k] - mean[k]) - sum(w * a[k] for w, a in zip(weights, arms)) for k in (0, 1)]
    pull = ((yy * missing[0] - xy * missing[1]) / det, (xx * missing[1] - xy * missing[0]) / det)
    return [w + dot(a, pull) for w, a in zip(weights, arms)]


def springs(points, c, total):
    """Equally stiff robots that cannot pull."""
    bearing = list(range(len(points)))
    for _ in range(4 * len(points)):
        loads = by_least_squares([points[i] for i in bearing], c, [total / len(bearing)] * len(bearing), total)
        if min(loads) >= -1e-12 * total:
            break
        bearing = [i for i, f in zip(bearing, loads) if f > 0]
    result = [0.0] * len(points)
    for i, f in zip(bearing, loads):
        result[i] = f
    return result


class Result:
    def __init__(self, found, robot=None):
        self.found = found
        self.outline = Outline(found["polygon"])
        self.c = tuple(found["centre_of_mass"])
        self.radius = max(size(minus(v, self.c)) for v in self.outline.at)
        self.robot = robot or {}
        self.places = []  # edge, contact, whether it is free to move; no edge beneath
        for each in found["robots"]:
            contact = each["contact"]
            if contact is None:
                self.places.append((None, tuple(each["at"]), True))
                continue
            contact = tuple(contact)
            notch = self.outline.notch_at(contact)
            self.places.append((self.outline.edge_of(contact) if notch is None else notch, contact, notch is None))
        self.loads = [each["load"] for each in found["robots"]]
        self.accuracy = found["accuracy"]

    def bends_near(self, within):
        """Whether some robot may pass a vertex."""
        o = self.outline
        for e, p, free in self.places:
            if not free or e is None:
                continue
            t = dot(minus(p, o.at[e]), o.along[e])
            for v, d in ((e, t), ((e + 1) % o.n, o.long[e] - t)):
                if d <= within * 1.002 and abs(o.turn(v)[0]) > 1e-9:
                    return True
        return False

    def moved(self, ways, rng):
        places = []
        for (e, p, free), way in zip(self.places, ways):
            if not free:
                places.append((e, p))
            elif e is None:
                angle = rng.uniform(0, 2 * math.pi)
                places.append((None, plus(p, (math.cos(angle), math.sin(angle)), way)))
            else:
                places.append(self.outline.moved(e, p, way))
        return places

    def wrenches(self, places):
        found = []
        for e, p in places:
            for n in self.outline.contacts(e, p) if e is not None else []:
                found.append((n[0], n[1], cross(minus(p, self.c), n) / self.radius))
        return found

    def lifting(self, places):
        depth_of_hand = self.robot.get("depth", 0)
        return [p if e is None else plus(p, self.outline.inward(e), depth_of_hand) for e, p in places]

    def fits(self, places):
        r, reach, deep, wide, gap = (self.robot.get(k, 0) for k in ("r", "reach", "depth", "width", "gap"))
        o, slack = self.outline, 1e-8 * self.outline.scale
        stands = [plus(p, o.inward(e), -(r + reach)) for e, p in places]
        for (e, p), s in zip(places, stands):
            if o.contains(s) or any(to_segment(o.at[i], o.at[(i + 1) % o.n], s) < r - slack for i in range(o.n)):
                return "body"
            n, along = o.inward(e), o.along[e]
            if reach and any(cross_each_other(plus(p, n, -1e-6 * o.scale), s, o.at[i], o.at[(i + 1) % o.n])
                             for i in range(o.n)):
                return "arm"
            if deep:
                for k in (-0.5, 0.0, 0.5):
                    for part in (0.5, 1.0):
                        if not o.contains(plus(plus(p, along, k * max(0.0, wide - 2 * slack)), n, part * (deep - slack))):
                            return "hand"
        for i, j in itertools.combinations(range(len(places)), 2):
            a, b = places[i][1], places[j][1]
            if size(minus(stands[i], stands[j])) < 2 * r + gap - slack:
                return "bodies"
            if reach and (min(to_segment(a, stands[i], stands[j]), to_segment(b, stands[j], stands[i])) < r + gap - slack
                          or cross_each_other(a, stands[i], b, stands[j])):
                return "arms"
            lift = self.lifting([places[i], places[j]])
            if wide and between(a, lift[0], b, lift[1]) < wide - slack:
                return "hands"
        return None

    def carried(self, places, planned):
        points = self.lifting(places)
        total = self.found["total_weight"]
        return by_least_squares(points, self.c, self.loads, total) if planned else springs(points, self.c, total)


class Check:
    def __init__(self, program, rng):
        self.program, self.rng = program, rng
        self.results = self.moves = self.beyond = self.typed = self.passed_over = 0
        self.failures = []

    def run(self, arguments, is_json=True):
        done = subprocess.run([self.program, "place", *arguments, *(["--json"] if is_json else [])],
                              capture_output=True, text=True, timeout=120, check=False)
        if done.returncode != 0:
            return None
        return json.loads(done.stdout) if is_json else done.stdout

    def fail(self, what, arguments):
        self.failures.append(f"{what}\n    {self.program} place {' '.join(map(repr, arguments))}")

    def promises(self, arguments, robot=None, capacity=None, moves=4):
        found = self.run(arguments)
        if found is None or not found["teams"] or found["accuracy"]["limited_by"] is None:
            self.passed_over += 1
            return None
        self.results += 1
        result = Result(found, robot)
        within = result.accuracy
        planned = found["metric"] != "given"
        asked, near = within["asked"], SAFE * result.outline.scale
        if asked > 0:
            fits, holds = within["fits_within"], within["hold_within"]
            if robot and fits is not None and fits < asked - near:
                self.fail(f"robots fit within {fits!r} only, not within the accuracy", arguments)
            if found["goal"] == "hold" and found["goal_reached"] and holds is not None and holds < asked - near:
                self.fail(f"they hold within {holds!r} only, not within the accuracy", arguments)
        checks = {
            "fits": lambda places: result.fits(places) is None,
            "stands": lambda places: depth(result.lifting(places), result.c) >= -1e-12 * result.radius,
            "hold": lambda places: held(result.wrenches(places)),
            # About right: to first order in the loads, within 1 % of the limit of a load.
            "capacity": lambda places: (worst := max(result.carried(places, planned)) / capacity) <= 1.01 or print("over by", worst),
        }
        for kind, holds in checks.items():
            limit = within[f"{kind}_within"]
            if limit is None or limit <= 1e-7 * result.radius or (kind == "capacity" and capacity is None):
                continue
            most = limit - SAFE * result.outline.scale
            if kind == "capacity":  # what falls carries nothing
                most = min(most, (within["stands_within"] or 0) - SAFE * result.outline.scale)
                if most <= 0:
                    continue
            for amount in sorted({min(1e-6 * result.radius, most), min(1e-3 * result.radius, most), most}):
                for k in range(moves):
                    signs = [self.rng.choice((-1, 1)) for _ in result.places]
                    ways = [amount * s for s in signs] if k == 0 else [
                        amount * (1 if k == 1 else -1)] * len(signs) if k < 3 else [
                        self.rng.uniform(-amount, amount) for _ in signs]
                    self.moves += 1
                    if not holds(result.moved(ways, self.rng)):
                        self.fail(f"{kind} within {limit!r} is not kept for robots off by {ways}", arguments)
                        break
        limit = within["hold_within"]
        if limit is not None and limit > 1e-6 * result.radius and not result.bends_near(limit):
            self.beyond += 1
            way = limit * 1.001
            if all(checks["hold"](result.moved([sense * way] * len(result.places), self.rng)) for sense in (1, -1)):
                self.fail(f"hold within {limit!r} is kept by robots that are farther off", arguments)
        return found

    def survives(self, arguments):
        """Whichever robots may fail, C stays inside the hull of the others, though they are off by the accuracy."""
        found = self.run(arguments)
        may_fail = found["robustness"]["failures_clear"] if found and found["teams"] else 0
        if may_fail <= 0:
            self.passed_over += 1
            return
        self.results += 1
        result = Result(found)
        most = found["accuracy"]["asked"] - SAFE * result.outline.scale
        for k in range(4):
            ways = [self.rng.uniform(-most, most) if k > 1 else self.rng.choice((-most, most)) for _ in result.places]
            self.moves += 1
            places = result.moved(ways, self.rng)
            lifting = result.lifting(places)
            for failed in itertools.combinations(range(len(lifting)), min(may_fail, 2)):
                others = [p for i, p in enumerate(lifting) if i not in failed]
                if depth(others, result.c) < -1e-12 * result.radius:
                    self.fail(f"it falls if robots {failed} fail, and robots are off by {ways}", arguments)
                    return

    def typed_back(self, arguments, found, options=()):
        """The places as the table prints them, given as supports."""
        text = self.run([*arguments, *options], is_json=False)
        places = re.findall(r"^ +\d+ +\((-?[\d.,]+), (-?[\d.,]+)\)", text, re.M)
        if len(places) != len(found["robots"]):
            return
        self.typed += 1
        supports = " ".join(f"{x},{y}" for x, y in places)
        again = self.run([arguments[0], "--supports", supports, *options])
        if again is None:
            self.fail("places typed back are refused", [arguments[0], "--supports", supports])
        elif (told := self.told(again)) != self.told(found):
            self.fail(f"places typed back: {told}, not {self.told(found)}", [arguments[0], "--supports", supports])

    @staticmethod
    def told(found):
        return found["stands"], found["closure"]["form_closure"], found["verdict"]["kind"], found["verdict"]["reasons"]


def check_sample(check, path, number):
    file = str(path)
    for robots in (4 + number % 3, 7):
        arguments = [file, "--metric", "balanced", "--robots", str(robots)]
        found = check.promises(arguments)
        if found:
            check.typed_back(arguments, found)
    teams = [file, "--teams", str(2 + number % 3), "--goal", "hold", "--positions", "range"]
    found = check.promises(teams)
    if found:
        check.typed_back(teams, found)
    found = check.promises([file, "--teams", "3"])
    if not found:
        return
    most = found["loads"]["max"]
    limit = round(1.05 * most + 0.05, 2)
    check.promises([file, "--teams", "3", "--capacity", str(limit)], capacity=limit)
    places = " ".join(f"{x!r},{y!r}" for x, y in (each["at"] for each in found["robots"]))
    limit = round(1.1 * max(found["loads"]["models"]["springs"]) + 0.05, 2)
    check.promises([file, "--supports", places, "--capacity", str(limit)], capacity=limit)
    r = round(0.03 * Result(found).radius, 3)
    sizes = {"r": r, "reach": round(0.3 * r, 3), "depth": round(0.3 * r, 3), "width": round(0.5 * r, 3), "gap": round(0.3 * r, 3)}
    option = ",".join(f"{k}={v}" for k, v in sizes.items())
    check.promises([file, "--metric", "balanced", "--robots", "5", "--robot", option], robot=sizes)
    check.promises([file, "--teams", "3", "--robot", option], robot=sizes)
    # Bodies without hands: their lifting points, which the table prints, are at the outline.
    option = f"r={r},gap={sizes['gap']}"
    for way in (["--metric", "balanced", "--robots", "5"], ["--teams", "3"]):
        found = check.promises([file, *way, "--robot", option], robot={"r": r, "gap": sizes["gap"]})
        if found:
            check.typed_back([file, *way], found, ("--robot", option))
    for survive in (1, 2):
        check.survives([file, "--metric", "balanced", "--robots", str(5 + 2 * survive), "--survive", str(survive),
                        "--accuracy", str(round(0.05 * Result(check.run([file])).radius, 3))])


def check_random(check, file, rng):
    """A sample or a generated polygon, in one random way."""
    radius = Result(check.run([file])).radius
    exact = ["--accuracy", repr(rng.choice((0.002, 0.01, 0.03)) * radius)] if rng.random() < 0.7 else []
    kind = rng.randrange(4)
    if kind == 0:
        return check.promises([file, "--metric", "balanced", "--robots", str(rng.randint(3, 8)), *exact])
    if kind == 1:
        return check.promises([file, "--teams", str(rng.randint(2, 4)), "--metric", rng.choice(("area", "circle", "distance")),
                               "--goal", rng.choice(("hold", "cover")), "--positions", rng.choice(("best", "range")), *exact])
    r = round(rng.uniform(0.01, 0.06) * radius, 4)
    sizes = {"r": r, "reach": rng.choice((0, 0.3 * r)), "depth": rng.choice((0, 0.3 * r)), "width": rng.choice((0, 0.5 * r)),
             "gap": rng.choice((0, 0.3 * r))}
    option = ",".join(f"{k}={v!r}" for k, v in sizes.items())
    way = ["--metric", "balanced", "--robots", str(rng.randint(3, 7))] if kind == 2 else ["--teams", "3"]
    return check.promises([file, *way, "--robot", option, *exact], robot=sizes)


def soak(check, paths, rng, seconds):
    end = time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as folder:
        generated = pathlib.Path(folder) / "generated.txt"
        while time.monotonic() < end:
            file = str(rng.choice(paths))
            if rng.random() < 0.6:
                file = str(generated)
                family = rng.choice(("regular", "convex", "star", "comb", "random"))
                made = subprocess.run([check.program, "generate", family, "--n", str(rng.randint(4, 40)), "--seed",
                                       str(rng.randrange(10**6))], capture_output=True, text=True, check=False)
                if made.returncode != 0:
                    continue
                generated.write_text(made.stdout, encoding="utf-8")
            before = len(check.failures)
            check_random(check, file, rng)
            if len(check.failures) > before and file == str(generated):
                check.failures.append(f"where {file} is\n{made.stdout}")
    for failure in check.failures[:40]:
        print(failure)
    print(f"tried {check.results}, passed over {check.passed_over}, failed {len(check.failures)}")
    sys.exit(1 if check.failures else 0)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("samples", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float)
    asked = parser.parse_args()
    check = Check(asked.program, random.Random(asked.seed))
    paths = sorted(p for p in asked.samples.glob("*.txt") if p.stem != "index" and p.stat().st_size < 4000)
    if asked.seconds:
        soak(check, paths, check.rng, asked.seconds)
    for number, path in enumerate(paths[:: asked.every]):
        check_sample(check, path, number)
    print(f"{check.results} results, {check.moves} placements moved, {check.beyond} holds moved beyond their limit, "
          f"{check.typed} tables typed back")
    for failure in check.failures[:40]:
        print(failure)
    if check.failures:
        sys.exit(f"{len(check.failures)} broken promises")


if __name__ == "__main__":
    main()
