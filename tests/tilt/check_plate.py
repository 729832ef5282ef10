#!/usr/bin/env python3
"""Slopes, starts, uneven ground and failures, against a rigid plate on springs that cannot pull.

    python3 tests/tilt/check_plate.py build/bin/evenlift [--cases N] [--seed S]

The plate is written from mechanics, not from the definition: it lies on springs that were set, on the slope where it
is, to the planned loads with C as assumed; given supports are level springs. Then it is disturbed at random, to the
ends of what the settings allow and within them: C moves, the plate is braked, the heights of the springs are off,
which also tilts the plate and so moves the weight sideways. Newton's method finds the forces. No force may be outside
the range that the program says, no plate may tip that "stays", and after a failure no force may be above the greatest
that is said.

A slope k1 leaves 1 / sqrt(1 + k1^2) of the weight across it. Tilts by uneven heights are small, so slopes are added.
Where uneven heights lift a robot off, a plate with a height of C can tilt by more than the definition counts; the
program says so in words, and what such plates do is only counted here.
"""

import argparse
import json
import math
import random
import subprocess
import sys

SLACK = 1e-7  # in parts of the weight


# The plate.


class Tips(Exception):
    """No forces balance the plate."""


class OnTheEdge(Exception):
    """The weight acts within rounding of the edge of what the springs can balance."""


class TiltsFarther(Exception):
    """A robot is lifted off by uneven heights, which tilts the plate by more than was counted."""


def solved(rows, right):
    """The solution of three linear equations, by Cramer's rule; None if they are singular."""

    def determinant(m):
        return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))  # fmt: skip

    whole = determinant(rows)
    size = max(abs(x) for row in rows for x in row)
    if abs(whole) <= 1e-13 * size**3:
        return None
    return [determinant([[right[i] if k == j else rows[i][k] for k in range(3)] for i in range(3)]) / whole for j in range(3)]


def inside(places, at):
    """The least distance of a place from the lines of the edges of the hull; negative outside."""
    room = math.inf
    for p in places:
        for q in places:
            if p == q:
                continue
            off = [(q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) for r in (*places, at)]
            if min(off[:-1]) >= -1e-15:  # p to q is an edge
                room = min(room, off[-1] / math.dist(p, q))
    return -math.inf if room == math.inf else room


class Plate:
    """A rigid plate of weight 1 on springs at these places, with C at the origin and lengths in its size."""

    def __init__(self, places, loads, stiffness):
        self.places, self.loads, self.stiffness = places, loads, stiffness

    def forces(self, heights, down, at):
        """The forces if a weight `down` acts at a place, and the plate's displacement (down, slopes in x and y).

        Displacements are in units of force: times the stiffness.
        """
        room = inside(self.places, at)
        if abs(room) < 1e-6:
            raise OnTheEdge
        if room < 0:
            raise Tips
        pushed_by = [down * f + self.stiffness * h for f, h in zip(self.loads, heights)]
        scale, moved = max(1.0, *map(abs, pushed_by)), [0.0, 0.0, 0.0]

        def free(moved):
            return [f + moved[0] + moved[1] * x + moved[2] * y for f, (x, y) in zip(pushed_by, self.places)]

        def lack_at(moved):
            lack = [down, down * at[0], down * at[1]]
            for f, (x, y) in zip(free(moved), self.places):
                for i, p in enumerate((1.0, x, y)):
                    lack[i] -= max(0.0, f) * p
            return lack

        def stride(step, slope):
            """How much of the step about halves the slope of the energy along it."""
            low, high, part = 0.0, math.inf, 1.0
            for _ in range(60):
                here = sum(s * g for s, g in zip(step, lack_at([m + part * s for m, s in zip(moved, step)])))
                if here > slope / 2:
                    low = part
                elif here < -slope / 2:
                    high = part
                else:
                    break
                part = 2 * part if high == math.inf else (low + high) / 2
            return part

        for _ in range(1000):
            pushed = free(moved)
            lack = lack_at(moved)
            rows = [[0.0] * 3 for _ in range(3)]
            for f, (x, y) in zip(pushed, self.places):
                if f <= 0:
                    continue
                for i, p in enumerate((1.0, x, y)):
                    for j, q in enumerate((1.0, x, y)):
                        rows[i][j] += p * q
            if max(map(abs, lack)) < 1e-12 * scale:
                return [max(0.0, f) for f in pushed], [m / self.stiffness for m in moved]
            step = solved(rows, lack)
            if step is None:  # too few springs touch: sink where force is lacking
                for i in range(3):
                    rows[i][i] += 1e-3
                step = solved(rows, lack)
            part = stride(step, sum(s * g for s, g in zip(step, lack)))
            moved = [m + part * s for m, s in zip(moved, step)]
        raise AssertionError("no forces were found")


def turned(length, angle):
    return length * math.cos(angle), length * math.sin(angle)


class Disturbance:
    """One way in which the settings' doubts come true, in units of the size."""

    def __init__(self, rng, settings, count):
        def up_to(most):
            return most * rng.choice([1.0, 1.0, rng.random()])

        angle = rng.random() * 2 * math.pi
        self.off = turned(up_to(settings["com_radius"]), rng.choice([angle, rng.random() * 2 * math.pi]))
        self.slope = turned(up_to(settings["slope"]), rng.choice([angle, rng.random() * 2 * math.pi]))
        self.braked = turned(up_to(settings["acceleration"]), rng.choice([angle, rng.random() * 2 * math.pi]))
        uneven = settings["uneven"]
        self.heights = [uneven * rng.choice([-1.0, 1.0, rng.uniform(-1, 1)]) for _ in range(count)]
        if rng.random() < 0.3:  # as a plane would have it
            way = turned(1.0, rng.choice([angle, rng.random() * 2 * math.pi]))
            self.along = way
        else:
            self.along = None
        self.uneven, self.height = uneven, settings["com_height"]

    def heights_at(self, places):
        if not self.along:
            return self.heights
        mean = [sum(p[i] for p in places) / len(places) for i in (0, 1)]
        return [math.copysign(self.uneven, (x - mean[0]) * self.along[0] + (y - mean[1]) * self.along[1]) for x, y in places]

    def forces_on(self, plate):
        """The forces, and how much of the weight acts across the plate."""
        heights, tilt = self.heights_at(plate.places), (0.0, 0.0)
        for _ in range(4):  # the tilt moves the weight, which hardly changes the tilt
            k1 = (self.slope[0] + tilt[0], self.slope[1] + tilt[1])
            across = math.sqrt(1 + k1[0] ** 2 + k1[1] ** 2)
            at = tuple(e + self.height * (k + a * across) for e, k, a in zip(self.off, k1, self.braked))
            down = 1 / across
            forces, moved = plate.forces(heights, down, at)
            if not (self.height > 0 and self.uneven > 0):
                break
            if min(forces) == 0:
                raise TiltsFarther
            _, level = plate.forces([0.0] * len(heights), down, at)
            tilt = (moved[1] - level[1], moved[2] - level[2])
        return forces


# What the program says.


def asked(program, polygon, options):
    text = "\n".join(f"({x},{y})" for x, y in polygon)
    line = [program, "place", "-", *options, "--failures", "--json"]
    run = subprocess.run(line, input=text, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return None, f"exit status {run.returncode}: {run.stderr}"
    again = " ".join(f"'{o}'" if " " in o else o for o in line[2:])
    return json.loads(run.stdout), f"printf '{text}' | {program} place {again}".replace("\n", "\\n")


def star(rng):
    count = rng.randint(3, 9)
    angles = sorted(rng.random() * 2 * math.pi for _ in range(count))
    if max((b - a) % (2 * math.pi) for a, b in zip(angles, angles[1:] + angles[:1])) > 2.6:
        return star(rng)
    size = rng.choice([1.0, 30.0, 1000.0])
    return [tuple(float(f"{size * (1.2 + v):.5g}") for v in turned(rng.uniform(0.5, 1), a)) for a in angles]


def random_settings(rng, size):
    """The lengths are in units of the size; about half of the doubts are given."""
    settings = dict.fromkeys(("com_radius", "com_height", "slope", "acceleration", "uneven"), 0.0)
    if rng.random() < 0.8:
        settings["com_height"] = rng.uniform(0.02, 0.5)
    for name, most in (("com_radius", 0.08), ("slope", 0.3), ("acceleration", 0.3), ("uneven", 0.02)):
        if rng.random() < 0.55:
            settings[name] = rng.uniform(0, most) * rng.choice([0.2, 1.0])
    give = rng.uniform(0.002, 0.1) if rng.random() < 0.85 else None
    return settings, give


def options_of(settings, give, size):
    lengths = ("com_radius", "com_height", "uneven")
    options = []
    for name, value in settings.items():
        if value:
            options += [f"--{name.replace('_', '-')}", repr(value * size if name in lengths else value)]
    return options + (["--give", repr(give * size)] if give is not None else [])


def supports_of(rng, polygon):
    """Corners, places on edges and places between."""
    places = []
    for _ in range(rng.randint(3, 8)):
        i = rng.randrange(len(polygon))
        a, b = polygon[i], polygon[(i + 1) % len(polygon)]
        t = rng.choice([0.0, rng.random()])
        places.append(tuple(float(f"{u + t * (v - u):.7g}") for u, v in zip(a, b)))
    return places


def case_of(rng, program):
    polygon = star(rng)
    size = max(math.dist(p, q) for p in polygon for q in polygon)
    settings, give = random_settings(rng, size)
    options = options_of(settings, give, size) + ["--weight", "1"]
    if rng.random() < 0.6:
        options += ["--supports", " ".join(f"{x!r},{y!r}" for x, y in supports_of(rng, polygon)), "--snap", repr(1e-4 * size)]
    elif rng.random() < 0.5:
        options += ["--teams", str(rng.randint(2, 4)), "--min-ratio", str(rng.choice([0.8, 0.5, 0.0]))]
    else:
        options += ["--metric", "distributed", "--teams", str(rng.randint(2, 4))]
    return polygon, size, settings, give, options


def check_forces(rng, settings, plate_of, ends, stays, disturbances, places, what, counts):
    """Returns the problems, at most one."""
    problems = []
    for _ in range(disturbances):
        disturbance, plate = Disturbance(rng, settings, len(places)), plate_of()
        try:
            forces = disturbance.forces_on(plate)
            counts["disturbances"] += 1
        except OnTheEdge:
            continue
        except TiltsFarther:
            counts["tilt farther"] += 1
            continue
        except Tips:
            if stays:
                problems.append(f"{what}: it tips, though it stays")
            continue
        if not stays:
            continue
        for i, (force, (least, greatest)) in enumerate(zip(forces, ends)):
            if force > greatest + SLACK or force < least - SLACK:
                problems.append(f"{what}: robot {i} carries {force}, not {least} to {greatest}")
    return problems[:1]


def check(rng, program, disturbances, counts):
    polygon, size, settings, give, options = case_of(rng, program)
    result, line = asked(program, polygon, options)
    if result is None:
        counts["refused"] += 1
        return None
    if not result["stands"] or not result.get("robots"):
        counts["falls"] += 1
        return None
    centre = result["centre_of_mass"]
    places = [tuple((p - c) / size for p, c in zip(robot["at"], centre)) for robot in result["robots"]]
    loads = [0.0 if "--supports" in options else robot["load"] for robot in result["robots"]]
    count = len(places)

    def plates(places, loads):
        def plate():
            length = give if give is not None else 10 ** rng.uniform(-5, -1)
            return Plate(places, loads, 1 / (count * length))  # as stiff as before a failure

        return plate

    tilt = result["tilt"]
    reach_alone = settings["com_radius"] <= result["robustness"]["com_margin"] / size
    stays = tilt["stays"] if tilt else reach_alone
    counts["stays" if stays else "tips"] += 1
    ranges = result["loads"].get("ranges") or [(robot["load"], robot["load"]) for robot in result["robots"]]
    counts["may let go"] += bool(result["loads"].get("may_let_go"))
    problems = check_forces(rng, settings, plates(places, loads), ranges, stays, disturbances, places, "all robots", counts)
    for failure in result["failures"]:
        if not failure["carried"] or not failure.get("stays", True):
            continue
        i = failure["robot"]
        rest = places[:i] + places[i + 1 :]
        if len(rest) < 3:
            continue
        most = failure.get("greatest_end", failure["springs_max"])
        counts["failures"] += 1
        problems += check_forces(rng, settings, plates(rest, [0.0] * len(rest)), [(0.0, most)] * len(rest), True,
                                 max(1, disturbances // 4), rest, f"robot {i} fails", counts)  # fmt: skip
    return f"{problems[0]}\n    {line}" if problems else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=120)
    parser.add_argument("--disturbances", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    wanted = parser.parse_args()
    names = ("stays", "tips", "may let go", "failures", "disturbances", "tilt farther", "falls", "refused")
    counts, found = dict.fromkeys(names, 0), 0
    for number in range(wanted.cases):
        problem = check(random.Random(f"{wanted.seed} {number}"), wanted.program, wanted.disturbances, counts)
        if problem:
            found += 1
            print(f"case {number}: {problem}\n")
    print(", ".join(f"{value} {name}" for name, value in counts.items()))
    if counts["stays"] < wanted.cases / 5 or counts["failures"] < wanted.cases / 5:
        print("too few cases stay")
        return 1
    print(f"{found} disagreements")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
