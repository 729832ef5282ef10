#!/usr/bin/env python3
"""Slopes, starts, uneven ground and a load anywhere, against exact rational arithmetic written from the definition.

    python3 tests/tilt/check_tilt.py build/bin/evenlift [--cases N] [--seed S]

Given supports with --com-radius, --com-height, --slope, --acceleration, --give, --uneven, --extra and --capacity: what
the results say in `tilt`, `loads.ranges`, `extra` and `failures`. Loads by springs and regions are exact, and square
roots have 60 digits. Greatest loads over a disc are bounded from both sides by the duality of linear programs.
Some numbers are also checked without any oracle, by runs with C moved or with the weight as cargo. Every coordinate
is a double and is taken as exact. A case that lies within a few tolerances of a decision is drawn again.
"""

import collections
import dataclasses
import functools
import itertools
import math
import pathlib
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "supports"))

from check_supports import (  # noqa: E402
    LOADS, TAU, Ambiguous, Polygon, Run, along, as_doubles, check_all, convex_hull, convex_polygon, cross, decimal,
    distance, dot, edges_of, expect, expect_near, grid_point, minus, nearest_on_segment, pairs_of,
    random_polygon, standing_of, star_polygon, steps_polygon, strictly_inside_hull, support, twice_area)  # fmt: skip

NEAR = 1e-7  # a nearer decision draws the case again; in parts of the weight or the size
TILT = {"height", "reach", "stays", "slope", "degrees", "acceleration", "acceleration_left", "slope_left"}
UNBOUNDED = Fraction(10**12)  # of the weight: a change of load without a bound


# What the definition says, in fractions.


def square_root(value):
    """Rounded down, to 60 digits."""
    return Fraction(math.isqrt(value.numerator * value.denominator << 400), value.denominator << 200)


def length(vector):
    return square_root(dot(vector, vector))


class Springs:
    """Robots that all carry something: their loads are affine in C."""

    def __init__(self, points):
        self.points, self.count = points, len(points)
        self.mean = tuple(sum(p[k] for p in points) / self.count for k in (0, 1))
        arms = [minus(p, self.mean) for p in points]
        xx, xy, yy = (sum(a[i] * a[j] for a in arms) for i, j in ((0, 0), (0, 1), (1, 1)))
        det = xx * yy - xy * xy
        if det <= Fraction(1, 10**8) * (xx + yy) ** 2:  # almost on one line
            raise Ambiguous
        self.pulls = [((yy * a[0] - xy * a[1]) / det, (xx * a[1] - xy * a[0]) / det) for a in arms]
        self.arms = arms

    def share(self, i, place):
        """The part of a weight at this place that robot i carries."""
        return Fraction(1, self.count) + dot(self.pulls[i], minus(place, self.mean))

    def loads(self, centre, weight):
        return [weight * self.share(i, centre) for i in range(self.count)]

    def skew(self, i):
        """The sum of |P_ij|."""
        shares = [Fraction(1, self.count) + dot(self.pulls[i], arm) for arm in self.arms]
        return sum(abs((i == j) - share) for j, share in enumerate(shares))

    def halves(self, weight, reach, uneven, mean_load=None):
        """Half the widths of the ranges; `uneven` is a part of what robots give way under the mean load, or None if
        that is not known."""
        mean_load = weight / self.count if mean_load is None else mean_load
        skews = [0 if uneven == 0 else self.skew(i) for i in range(self.count)]
        changes = [UNBOUNDED * weight * (skew > 0) if uneven is None else mean_load * uneven * skew for skew in skews]
        return [weight * reach * length(pull) + change for pull, change in zip(self.pulls, changes)]

    def tilt(self):
        """The slope by which heights that are off by up to 1 tilt the object: the greatest sum of |v . pull|.

        It is a corner of the sums of pulls with signs, and its direction v is across some pull.
        """
        greatest = Fraction(0)
        for pull in self.pulls:
            for own in (1, -1):
                signs = [own if cross(pull, q) == 0 and dot(pull, q) > 0 else -own if cross(pull, q) == 0 else 1 if cross(pull, q) > 0 else -1
                         for q in self.pulls]  # fmt: skip
                total = tuple(sum(s * q[k] for s, q in zip(signs, self.pulls)) for k in (0, 1))
                greatest = max(greatest, dot(total, total))
        return square_root(greatest)


def share_of_three(points, i, place):
    """The greatest part of the weight that robot i can carry with C at this place; None if it falls.

    At most three robots carry something where a load is greatest: a vertex of the linear program.
    """
    scale = math.lcm(*(x.denominator for p in (*points, place) for x in p))
    ends = [tuple(int(scale * x) for x in minus(p, points[i])) for p in points]
    c, best = tuple(int(scale * x) for x in minus(place, points[i])), None
    for a, b in itertools.combinations(ends, 2):
        area = cross(a, b)
        if area == 0:
            continue
        u, v, area = (cross(c, b), cross(a, c), area) if area > 0 else (-cross(c, b), -cross(a, c), -area)
        if u >= 0 and v >= 0 and u + v <= area:
            share = Fraction(area - u - v, area)
            best = share if best is None else max(best, share)
    return best


def functions_about(points, i, centre):
    """Affine functions that are at least 0 at every robot: pairs of the value at C and the gradient.

    Those of the first list are 1 at robot i, those of the second 0.
    """
    ones, zeros = [(Fraction(1), (Fraction(0), Fraction(0)))], []
    for a, b in edges_of(convex_hull(points)):
        d = minus(b, a)
        gradient, at = (-d[1], d[0]), cross(d, minus(points[i], a))
        if at > 0:
            ones.append((cross(d, minus(centre, a)) / at, tuple(x / at for x in gradient)))
        else:
            zeros.append((cross(d, minus(centre, a)), gradient))
    return ones, zeros


def least_over_line(start, way, reach):
    """The s at which the greatest value of start + s way over the disc is least, in doubles; infinite if none is."""
    (_, g), (slope, d) = start, way
    squared = d[0] * d[0] + d[1] * d[1]
    if squared == 0:
        return -math.copysign(math.inf, slope)
    steep = reach * reach * squared - slope * slope
    if steep <= 0:
        return -math.copysign(math.inf, slope)
    return -(g[0] * d[0] + g[1] * d[1]) / squared - slope * abs(g[0] * d[1] - g[1] * d[0]) / squared / math.sqrt(steep)


def plus(function, way, s):
    """An affine function and s times another one."""
    return function[0] + s * way[0], tuple(g + s * d for g, d in zip(function[1], way[1]))


def certificate(ones, zeros, reach):
    """The function, at least 1 at the robot and at least 0 at the others, with the least greatest value over the disc.

    It is one of the functions, or lies between two; only where it lies is found in doubles.
    """
    functions = ones + zeros
    ways = {(j, k): functions[k] if k >= len(ones) else plus(functions[k], functions[j], -1)
            for j in range(len(ones)) for k in range(j + 1, len(functions))}  # fmt: skip

    def in_doubles(function):
        return float(function[0]), tuple(map(float, function[1]))

    best, radius = (math.inf, None, None, None), float(reach)
    for j, first in enumerate(map(in_doubles, ones)):
        best = min(best, (first[0] + radius * math.hypot(*first[1]), j, j, 0.0))
        for k in range(j + 1, len(functions)):
            way = in_doubles(ways[j, k])
            s = max(0.0, least_over_line(first, way, radius))
            s = s if k >= len(ones) else min(1.0, s)
            if math.isfinite(s):
                value, gradient = plus(first, way, s)
                best = min(best, (value + radius * math.hypot(*gradient), j, k, s))
    _, j, k, s = best
    return ones[j] if j == k else plus(ones[j], ways[j, k], Fraction(s))


def bounds_over_disc(points, i, centre, reach):
    """Bounds of the greatest part of the weight that robot i can carry with C anywhere within the reach and the base.

    C is a mean of the robots' places, and the parts are its weights. So an affine function that is at least 1 at robot
    i and at least 0 at the others is at C no less than the part of robot i: its greatest value over the disc is an
    upper bound. A place of C in the disc, with loads in balance there, gives a lower one. Both hold however they were
    found.
    """
    if distance_squared(points[i], centre) <= reach * reach:
        return Fraction(1), Fraction(1)
    value, gradient = certificate(*functions_about(points, i, centre), reach)
    upper = min(Fraction(1), value + reach * length(gradient))
    lower = share_of_three(points, i, centre) or Fraction(0)
    if reach > 0 and gradient != (0, 0):
        outward = tuple(x / length(gradient) for x in gradient)
        inward = minus(tuple(sum(p[k] for p in points) / len(points) for k in (0, 1)), centre)
        inward = tuple(x / (length(inward) or 1) for x in inward)
        for less in (Fraction(1, 10**e) for e in (14, 13, 12, 11)):  # a hair inside the disc and the base
            way = [reach * ((1 - less) * x + less / 2 * y) for x, y in zip(outward, inward)]
            place = as_doubles(c + x for c, x in zip(centre, way))
            if distance_squared(place, centre) <= reach * reach:
                lower = max(lower, share_of_three(points, i, place) or Fraction(0))
    if upper - lower > 1e-10:
        raise AssertionError(f"the bounds of a greatest load are {float(lower)} and {float(upper)}")
    return lower, upper


def distance_squared(p, q):
    return dot(minus(p, q), minus(p, q))


def clipped(ring, affine):
    """The part of a ring in which an affine function, a value at the origin and a gradient, is not negative."""
    cut, side = [], [affine[0] + dot(affine[1], p) for p in ring]
    for i, p in enumerate(ring):
        if side[i - 1] * side[i] < 0:
            cut.append(along(ring[i - 1], p, side[i - 1] / (side[i - 1] - side[i])))
        if side[i] >= 0:
            cut.append(p)
    return cut


def within(ring, affines):
    return functools.reduce(clipped, affines, ring)


# Cases.


@dataclasses.dataclass(frozen=True)
class Case:
    """An object, its supports and the settings: names of options without dashes, each with a fraction or a text."""

    program: str
    polygon: Polygon
    supports: list
    settings: dict = dataclasses.field(default_factory=dict)
    weight: Fraction = Fraction(100)
    own_centre: tuple | None = None  # from --com
    cargo: list = dataclasses.field(default_factory=list)  # pairs of place and weight
    holes: list = dataclasses.field(default_factory=list)
    own_capacities: list | None = None
    more: tuple = ()

    def run(self):
        return TiltRun(self)

    def result(self):
        """The result of one more run, which must succeed."""
        answer = self.run().answer()
        expect(answer.status == 0, f"exit status {answer.status}: {answer.error} of {self.run()}")
        return answer.result

    def changed(self, **changes):
        """Without what it prints besides loads and standing."""
        return dataclasses.replace(self, **{"settings": {}, "own_capacities": None, "more": (), **changes})

    def setting(self, name):
        return self.settings.get(name, Fraction(0))

    @functools.cached_property
    def rings(self):
        """The outline and the holes, with the sign of their areas."""
        return [(self.polygon.vertices, 1), *((hole, -1) for hole in self.holes)]

    def area(self, affines=()):
        """Twice the area, or that of a part; double edges that remain after cutting add no area."""
        return sum(sign * abs(twice_area(within(ring, affines))) for ring, sign in self.rings)

    @functools.cached_property
    def own_mass_centre(self):
        if self.own_centre:
            return self.own_centre
        sums = [Fraction(0), Fraction(0)]
        for ring, sign in self.rings:
            sign *= 1 if twice_area(ring) > 0 else -1
            for a, b in edges_of(ring):
                for k in (0, 1):
                    sums[k] += sign * cross(a, b) * (a[k] + b[k])
        return tuple(x / (3 * self.area()) for x in sums)

    @functools.cached_property
    def total(self):
        return self.weight + sum(w for _, w in self.cargo)

    @functools.cached_property
    def centre(self):
        own, weight = self.own_mass_centre, self.weight
        return tuple((weight * own[k] + sum(w * q[k] for q, w in self.cargo)) / self.total for k in (0, 1))

    def slope_of(self, springs):
        """The slope of the object on these robots: uneven heights tilt it, too, which counts with a height of C."""
        tilts = self.setting("com-height") > 0 and self.setting("uneven") > 0
        return self.setting("slope") + (self.setting("uneven") * springs.tilt() if tilts else 0)

    def reach_of(self, springs):
        """How far from C the resultant meets the plane of the robots."""
        slope, braked = self.slope_of(springs), self.setting("acceleration")
        return self.setting("com-radius") + self.setting("com-height") * (slope + braked * square_root(1 + slope * slope))

    def load_reach_of(self, springs):
        return self.setting("com-radius") + self.setting("com-height") * (self.slope_of(springs) + self.setting("acceleration"))

    def kept_of(self, springs):
        return 1 / square_root(1 + self.slope_of(springs) ** 2)

    @functools.cached_property
    def reach(self):
        return self.reach_of(self.springs)

    @functools.cached_property
    def load_reach(self):
        return self.load_reach_of(self.springs)

    @functools.cached_property
    def kept(self):
        return self.kept_of(self.springs)

    @functools.cached_property
    def uneven(self):
        """The unevenness as a part of what robots give way under the mean load; None if that is not known."""
        if not self.setting("uneven"):
            return Fraction(0)
        return self.setting("uneven") / self.setting("give") if self.setting("give") else None

    @functools.cached_property
    def is_uncertain(self):
        return self.reach > 0 or self.uneven != 0 or self.setting("slope") > 0

    @functools.cached_property
    def limits(self):
        common = self.settings.get("capacity")
        own = self.own_capacities or [None] * len(self.supports)
        return [common if k is None else k for k in own]

    @functools.cached_property
    def springs(self):
        return Springs(self.supports)

    @functools.cached_property
    def loads(self):
        return self.springs.loads(self.centre, self.total)

    @functools.cached_property
    def halves(self):
        return self.springs.halves(self.total, self.load_reach, self.uneven)

    @functools.cached_property
    def standing(self):
        return standing_of(self.polygon, self.supports, self.centre)

    @functools.cached_property
    def box(self):
        (left, right), (low, high) = ([f(v[k] for v in self.polygon.vertices) for f in (min, max)] for k in (0, 1))
        return [(left, low), (right, low), (right, high), (left, high)]

    def conditions(self, spare=Fraction(0)):
        """The affine functions of the extra weight's place that are at least 0 in its region, which `spare` widens."""
        extra, conditions = self.settings["extra"], []
        for i, limit in enumerate(self.limits):
            pull = self.springs.pulls[i]
            level = self.loads[i] + extra * self.springs.share(i, (0, 0))
            gradient = tuple(extra * x for x in pull)
            conditions.append((level - self.halves[i] / self.kept + spare, gradient))
            if limit is not None:
                conditions.append((limit - level - self.halves[i] + spare, tuple(-x for x in gradient)))
        return conditions


class TiltRun(Run):
    """One call of the program, with the thesis's text, since the object may have holes."""

    def __init__(self, case):
        lines = [f"({pair})" for pair in pairs_of(case.polygon.vertices)]
        for hole in case.holes:
            lines += ["Hole:", *(f"({pair})" for pair in pairs_of(hole))]
        self.text, self.program = "\n".join(lines) + "\n", case.program
        own = case.own_capacities or [None] * len(case.supports)
        told = [p if k is None else f"{p}@{decimal(k)}" for p, k in zip(pairs_of(case.supports), own)]
        self.arguments = ["place", "-", "--supports", " ".join(told), "--weight", decimal(case.weight)]
        if case.own_centre:
            self.arguments += ["--com", *pairs_of([case.own_centre])]
        if case.cargo:
            places = pairs_of(q for q, _ in case.cargo)
            self.arguments += ["--cargo", " ".join(f"{p}:{decimal(w)}" for p, (_, w) in zip(places, case.cargo))]
        for name, value in case.settings.items():
            self.arguments += [f"--{name}", value if isinstance(value, str) else decimal(value)]
        self.arguments += [*case.more, "--json"]


def rounded(value):
    """A double with three digits."""
    return Fraction(float(f"{float(value):.3g}"))


def random_hole(rng, polygon):
    """A small square or triangle strictly inside a convex polygon."""
    for _ in range(50):
        (x, y), side = grid_point(rng, polygon, 64), Fraction(polygon.size) * Fraction(rng.randint(2, 12), 64)
        x, y, side = (Fraction(float(f"{float(v):.5g}")) for v in (x, y, side))
        ring = [as_doubles(p) for p in ((x, y), (x + side, y), (x + side, y + side), (x, y + side))]
        ring = ring[: rng.choice([3, 4])][:: rng.choice([1, -1])]
        off = min(abs(distance(p, nearest_on_segment(p, a, b))) for p in ring for a, b in polygon.edges)
        if all(strictly_inside_hull(p, polygon.hull) for p in ring) and off > 1e-3 * polygon.size:
            return ring
    raise Ambiguous


def is_beside(p, ring, margin):
    inside = strictly_inside_hull(p, convex_hull(ring))
    return inside or min(distance(p, nearest_on_segment(p, a, b)) for a, b in edges_of(ring)) < margin


def random_case(rng, program, count=None, falls=0.0, slack=0.0):
    """An object with its supports, of which none is slack but for a few cases."""
    polygon = random_polygon(rng, (convex_polygon, convex_polygon, star_polygon, steps_polygon))
    holes = []
    is_convex = all(polygon.turn_at(i) >= 0 for i in range(len(polygon.vertices)))
    if is_convex and rng.random() < 0.25:
        holes = [random_hole(rng, polygon)]
    kinds = rng.choice([["vertex"], ["edge"], ["vertex", "edge"], ["vertex", "edge", "edge", "inside"]])
    count = count or rng.choice([3, 3, 4, 4, 4, 5, 5, 6, 6, 7, 8])
    supports = [support(rng, polygon, rng.choice(kinds)) for _ in range(count)]
    if len(set(supports)) < 3 or any(is_beside(p, hole, 1e-3 * polygon.size) for p in supports for hole in holes):
        raise Ambiguous
    weight, cargo = Fraction(rng.choice([100, 100, 1, 7250])), []
    for _ in range(rng.choice([0, 0, 0, 1, 2])):
        cargo.append((as_doubles(grid_point(rng, polygon, 64)), rounded(weight * Fraction(rng.uniform(0.02, 0.5)))))
    own_centre = as_doubles(grid_point(rng, polygon, 64)) if rng.random() < 0.4 else None
    case = Case(program, polygon, supports, weight=weight, own_centre=own_centre, cargo=cargo, holes=holes)
    off = min(distance(case.centre, nearest_on_segment(case.centre, a, b)) for a, b in edges_of(polygon.hull))
    if not strictly_inside_hull(case.centre, polygon.hull) or off < 1e-3 * polygon.size:
        raise Ambiguous
    least = min(case.loads) / case.total  # refuses robots that are almost on one line
    if strictly_inside_hull(case.centre, convex_hull(supports)):
        if -1e-9 < least < 1e-3 or (least < 0 and rng.random() >= slack) or case.standing.margin < 1e-3 * polygon.size:
            raise Ambiguous
    elif rng.random() >= falls or case.standing.margin > -1e-3 * polygon.size:
        raise Ambiguous
    return case


def slack_reach(case):
    """How far C may be off before a robot goes slack."""
    pulls = [length(pull) for pull in case.springs.pulls]
    return min(float(f / (case.total * pull)) for f, pull in zip(case.loads, pulls) if pull)


def random_settings(rng, case, far=0.35, kinds=("com-radius", "slope", "acceleration")):
    """Settings with which C can be off by less or by more than what the robots allow."""
    size = case.polygon.size
    within_base = slack_reach(case) if min(case.loads) > 0 else abs(case.standing.margin)
    target = within_base * rng.uniform(0.02, 0.97)
    if rng.random() < far:
        target = max(case.standing.margin, 0.05 * size) * rng.uniform(0.5, 1.5)
    settings, chosen = {}, [kind for kind in kinds if rng.random() < 0.5]
    height = rounded(size * rng.choice([rng.uniform(0.02, 0.2), rng.uniform(0.2, 1.5)]))
    if rng.random() < 0.75 or set(chosen) - {"com-radius"}:
        settings["com-height"] = height
    if rng.random() < 0.05:
        settings.pop("com-height", None)
    for kind in chosen:
        part = target / len(chosen)
        settings[kind] = rounded(part if kind == "com-radius" else part / float(height))
    if settings.get("slope", 0) > 1:  # steeper than the program takes
        settings["acceleration"] = settings.pop("slope")
    if settings.get("acceleration", 0) > 10:  # more than it takes
        raise Ambiguous
    if rng.random() < 0.4:
        settings["give"] = rounded(size * rng.uniform(0.001, 0.2))
        room = float(min(f / case.total for f in case.loads)) * len(case.supports) if min(case.loads) > 0 else 0.1
        part = rng.choice([rng.uniform(0.02, 0.5), rng.uniform(0.3, 2)])
        settings["uneven"] = rounded(float(settings["give"]) * room * part)
        if rng.random() < 0.1:
            settings.pop("give")
    return settings


def with_settings(case, settings, **more):
    case = dataclasses.replace(case, settings=settings, **more)
    if abs(float(case.reach) - case.standing.margin) < NEAR * case.polygon.size:
        raise Ambiguous
    if case.standing.margin > 0 and float(case.reach) > 1.6 * case.standing.margin:
        raise Ambiguous  # bounds_over_disc() is exact where the disc crosses one edge of the base
    if any(abs(case.kept * f - half) < NEAR * case.total for f, half in zip(case.loads, case.halves)):
        raise Ambiguous
    return case


def has_slack(case):
    return min(case.loads) < 0


# Checks of one result.


def check_basics(case, result):
    size, weight = case.polygon.size, float(case.total)
    expect(distance(tuple(map(Fraction, result["centre_of_mass"])), case.centre) <= 1e-12 * size, "centre_of_mass")
    expect_near(result["total_weight"], case.total, 1e-12 * weight, "total_weight")
    for robot, p in zip(result["robots"], case.supports):
        expect(distance(tuple(map(Fraction, robot["at"])), p) <= 1e-12 * size, f"a robot is at {robot['at']}")
    expect(result["stands"] is case.standing.stands, f"stands is {result['stands']}")
    expect_near(result["robustness"]["com_margin"], case.standing.margin, 1e-9 * size, "com_margin")


def check_tilt(case, result):
    height, tilt, size = case.setting("com-height"), result["tilt"], case.polygon.size
    if height == 0:
        expect(tilt is None, f"tilt is {tilt} without a height")
        return
    expect(set(tilt) == TILT, f"the members of tilt are {list(tilt)}")
    slope = max(0.0, (case.standing.margin - float(case.setting("com-radius"))) / float(height))
    tolerance = 1e-9 * (1 + size / float(height))
    expect_near(tilt["height"], height, 1e-12 * float(height), "tilt.height")
    expect_near(tilt["reach"], case.reach, 1e-12 * float(case.reach), "tilt.reach")
    expect_near(tilt["slope"], slope, tolerance, "tilt.slope")
    expect_near(tilt["acceleration"], slope, tolerance, "tilt.acceleration")
    expect_near(tilt["degrees"], math.degrees(math.atan(slope)), 60 * tolerance, "tilt.degrees")
    stays = case.standing.stands and float(case.reach) <= case.standing.margin + TAU * size
    expect(tilt["stays"] is stays, f"tilt.stays is {tilt['stays']}")
    k1, k2 = float(case.slope_of(case.springs)), float(case.setting("acceleration"))
    left = {"acceleration_left": (case.setting("slope"), max(0.0, (slope - k1) / math.sqrt(1 + k1 * k1)))}
    # The slope at which k1 + k2 sqrt(1 + k1^2) is the slope that tips, by halving.
    low, high = 0.0, slope
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if middle + k2 * math.sqrt(1 + middle * middle) < slope else (low, middle)
    left["slope_left"] = (k2, max(0.0, low - (k1 - float(case.setting("slope")))))
    for name, (given, right) in left.items():
        if not given:
            expect(tilt[name] is None, f"tilt.{name} is {tilt[name]}")
        else:
            expect_near(tilt[name], right, 10 * tolerance, f"tilt.{name}")


def expect_worst(got, points, i, centre, reach, weight, what):
    """The greatest load of robot i with C anywhere within the reach."""
    lower, upper = (float(weight * bound) for bound in bounds_over_disc(points, i, centre, reach))
    tolerance = LOADS * float(weight)
    near = got is not None and lower - tolerance <= got <= upper + tolerance
    expect(near, f"{what}: the program says {got}, the definition {upper!r}")


def least_share(points, i, centre, reach):
    """The least part of the weight that robot i can carry with C anywhere within the reach, in doubles, by halving.

    The rest of the weight acts at a point of the hull of the others.
    """
    p = tuple(float(x) for x in minus(points[i], centre))
    hull = [tuple(float(x) for x in minus(q, centre)) for q in convex_hull(points[:i] + points[i + 1 :])]

    def off(t):  # convex in t
        ring = [tuple(t * a + (1 - t) * b for a, b in zip(p, q)) for q in hull]
        sides = edges_of(ring)
        if len(ring) > 2 and all(cross(minus(b, a), (-a[0], -a[1])) >= 0 for a, b in sides):
            return 0.0
        return min(distance((0.0, 0.0), nearest_on_segment((0.0, 0.0), a, b)) for a, b in sides)

    if off(0.0) <= reach:
        return 0.0
    low, high = 0.0, 1.0
    for _ in range(200):  # to where C is nearest
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (low, b) if off(a) <= off(b) else (a, high)
    low = 0.0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if off(middle) <= reach else (middle, high)
    return high


def check_ranges(case, result):
    """Returns what the ranges are, in a word or two."""
    loads = result["loads"]
    if not case.standing.stands:
        expect(loads is None, "loads, though it falls")
        return "falls"
    if not case.is_uncertain:
        expect(loads.get("ranges") is None, "loads.ranges, though nothing is uncertain")
        return "no ranges"
    ranges = loads["ranges"]
    expect(len(ranges) == len(case.supports), f"{len(ranges)} ranges of {len(case.supports)} robots")
    expect(isinstance(loads["may_let_go"], bool), f"may_let_go is {loads['may_let_go']}")
    if has_slack(case):
        return "slack already"
    may_let_go = any(case.kept * f < half for f, half in zip(case.loads, case.halves))
    expect(loads["may_let_go"] is may_let_go, f"loads.may_let_go is {loads['may_let_go']}")
    for i, (f, half) in enumerate(zip(case.loads, case.halves)):
        tolerance, what = LOADS * float(case.total + half), f"loads.ranges[{i}]"
        if may_let_go:
            least = float(case.kept * case.total) * least_share(case.supports, i, case.centre, float(case.reach))
            expect_near(ranges[i][0], least, 1e-8 * float(case.total), f"{what}[0]")
            expect_worst(ranges[i][1], case.supports, i, case.centre, case.load_reach, case.total, f"{what}[1]")
        else:
            expect_near(ranges[i][0], max(Fraction(0), f * case.kept - half), tolerance, f"{what}[0]")
            expect_near(ranges[i][1], f + half, tolerance, f"{what}[1]")
    return "may go slack" if may_let_go else "all carry"


def check_overloaded(case, result):
    """Those whose greatest end is above their limit, or, as the command line's contract has it, whose planned load is.

    Returns whether the two differ and which it is.
    """
    if not any(limit is not None for limit in case.limits) or not case.standing.stands or has_slack(case):
        return None
    ends = [Fraction(end) for _, end in result["loads"]["ranges"]] if case.is_uncertain else case.loads
    limited, near = [i for i, k in enumerate(case.limits) if k is not None], NEAR * case.total
    if any(abs(x[i] - case.limits[i]) < near for x in (ends, case.loads) for i in limited):
        return None
    by_end, planned = ([i for i in limited if x[i] > case.limits[i]] for x in (ends, case.loads))
    told = result["capacity"]["overloaded"]
    expect(told in (by_end, planned), f"capacity.overloaded is {told}, not {by_end}")
    return None if by_end == planned else "overloaded by ends" if told == by_end else "overloaded as planned"


def region_to_compare(case):
    """The exact region, which has no area or enough of it."""
    box, spare = case.box, Fraction(NEAR) * (case.total + case.settings["extra"])
    region = within(box, case.conditions())
    area = twice_area(region)
    if area <= 0:
        if twice_area(within(box, case.conditions(spare))) > 0:
            raise Ambiguous
        return []
    if area < Fraction(1, 10**5) * twice_area(box) or twice_area(within(box, case.conditions(-spare))) <= 0:
        raise Ambiguous
    return region


def greatest_anywhere(case):
    """The interval of the weights that may stand anywhere on the object; to None if any may, to 0 if none may."""
    low, high = Fraction(0), None
    for i, limit in enumerate(case.limits):
        for share in {case.springs.share(i, v) for v in case.polygon.vertices}:
            if 0 < abs(share) < 1e-6:
                raise Ambiguous
            rows = [(case.loads[i] - case.halves[i] / case.kept, share)]
            rows += [(limit - case.loads[i] - case.halves[i], -share)] if limit is not None else []
            for level, rate in rows:  # level + rate w >= 0
                if abs(level) < NEAR * case.total:
                    raise Ambiguous
                if rate < 0:
                    high = level / -rate if high is None else min(high, level / -rate)
                elif level < 0:
                    if rate == 0:
                        return Fraction(0), Fraction(0)
                    low = max(low, -level / rate)
    return (Fraction(0), Fraction(0)) if high is not None and high < low else (low, high)


def expect_same_ring(got, right, tolerance, area_tolerance, what):
    """Convex rings, counter-clockwise, perhaps with corners that nearly agree."""
    expect(len(got) > 2, f"{what} has the corners {got}")
    area = float(twice_area(got))  # positive if counter-clockwise
    expect_near(area, twice_area(right), area_tolerance, f"twice the area of {what}")
    for corners, others, whose in ((right, got, "the definition's"), (got, right, "the program's")):
        for p in corners:
            off = min(distance(p, nearest_on_segment(p, a, b)) for a, b in edges_of(others))
            expect(off <= tolerance, f"{what}: {whose} corner {tuple(map(float, p))} is {off:g} off")
    for (a, b), (_, c) in zip(edges_of(got), edges_of(got[1:] + got[:1])):
        expect(cross(minus(b, a), minus(c, b)) >= -area_tolerance, f"{what} is not convex")


def check_extra(case, result):
    """Returns what the region is, in a word or two."""
    extra = result.get("extra")
    if "extra" not in case.settings:
        expect(extra is None, "extra, though there is no extra weight")
        return None
    if not case.standing.stands or has_slack(case):
        return None
    expect_near(extra["weight"], case.settings["extra"], 0, "extra.weight")
    right, got = region_to_compare(case), [tuple(map(Fraction, p)) for p in extra["region"]]
    share = case.area(case.conditions()) / case.area()
    expect_near(extra["share"], share, 1e-8, "extra.share")
    low, high = greatest_anywhere(case)
    if low > 0 and extra["anywhere"] == 0:
        pass  # without the weight, a robot may be slack or overloaded
    elif high is None:
        expect(extra["anywhere"] is None, f"extra.anywhere is {extra['anywhere']}, but any weight may stand anywhere")
    else:
        expect_near(extra["anywhere"], high, 1e-8 * float(high + case.total), "extra.anywhere")
    if not right:
        expect(extra["region"] == [], f"extra.region is {extra['region']}, but there is none")
        return "no region"
    size = case.polygon.size
    expect_same_ring(got, right, 1e-8 * size, 1e-8 * size * size, "extra.region")
    return "all of it" if share == 1 else "a part of it"


def check_failures(case, result):
    """Returns the number of failures whose greatest end was checked."""
    if "--failures" not in case.more or not case.is_uncertain or not case.standing.stands:
        return 0
    size, checked = case.polygon.size, 0
    for i, failure in enumerate(result["failures"]):
        rest, what = case.supports[:i] + case.supports[i + 1 :], f"failures[{i}]"
        try:
            standing = standing_of(case.polygon, rest, case.centre)
        except Ambiguous:
            continue
        expect(failure["carried"] is standing.stands, f"{what}.carried is {failure['carried']}")
        if not standing.stands:
            expect(failure["stays"] is failure["greatest_end"] is None, f"{what} is not carried, and yet {failure}")
            continue
        try:
            reach = float(case.reach_of(Springs(rest)))
        except (Ambiguous, ZeroDivisionError):
            continue
        if abs(reach - standing.margin) <= NEAR * size:
            continue
        expect(failure["stays"] is (reach <= standing.margin), f"{what}.stays is {failure['stays']}")
        if not failure["stays"]:  # what tips carries nothing
            expect(failure["greatest_end"] is None, f"{what} tips, and yet {failure}")
            continue
        try:
            checked += check_greatest_end(case, rest, failure["greatest_end"], f"{what}.greatest_end")
        except Ambiguous:
            continue
    return checked


def check_greatest_end(case, rest, got, what):
    """The definition leaves open whether a robot gives way as it did before the failure, so both are right."""
    if len(rest) < 3:
        raise Ambiguous
    springs = Springs(rest)
    loads, problems = springs.loads(case.centre, case.total), []
    if min(loads) < NEAR * case.total:
        raise Ambiguous
    expect(got is not None, f"{what} is missing")
    reach, kept = case.load_reach_of(springs), case.kept_of(springs)
    for count in {len(rest), len(case.supports)} if case.uneven else {len(rest)}:
        halves = springs.halves(case.total, reach, case.uneven, case.total / count)
        if any(abs(kept * f - half) < NEAR * case.total for f, half in zip(loads, halves)):
            raise Ambiguous
        if all(kept * f > half for f, half in zip(loads, halves)):
            right = 2 * (max(f + half for f, half in zip(loads, halves)),)
        else:
            bounds = [bounds_over_disc(rest, i, case.centre, reach) for i in range(len(rest))]
            right = tuple(case.total * max(bound[k] for bound in bounds) for k in (0, 1))
        tolerance = LOADS * float(case.total + right[1])
        if float(right[0]) - tolerance <= got <= float(right[1]) + tolerance:
            return 1
        problems.append(repr(float(right[1])))
    expect(False, f"{what}: the program says {got}, the definition {' or '.join(problems)}")
    return 0


def check_required(case, result, answer):
    """With --require "tip>=degrees"."""
    if "--require" not in case.more:
        expect(answer.status == 0, f"exit status {answer.status}")
        return
    condition = case.more[case.more.index("--require") + 1]
    degrees = result["tilt"]["degrees"]
    kept = degrees >= float(condition.removeprefix("tip>="))
    expect(answer.status == (0 if kept else 3), f"exit status {answer.status}, and {condition} of {degrees}")
    (told,) = result["requirements"]
    expect(told["condition"] == condition and told["kept"] is kept, f"requirements: {told}")
    expect_near(told["value"], degrees, 1e-9, "the value of tip")


def check_result(case, answer):
    """Names what the case was."""
    expect(answer.result is not None, f"exit status {answer.status}: {answer.error}")
    result = answer.result
    check_required(case, result, answer)
    check_basics(case, result)
    check_tilt(case, result)
    yield check_ranges(case, result)
    if (overloaded := check_overloaded(case, result)) is not None:
        yield overloaded
    if (region := check_extra(case, result)) is not None:
        yield region
    yield from check_failures(case, result) * ["greatest ends after a failure"]


# Kinds of cases. Each draws a case, and returns its run and a function that checks the answer and names the case.


def judged(rng, program):
    """Everything of one result."""
    case = random_case(rng, program, falls=0.02, slack=0.03)
    settings, more, own = random_settings(rng, case), [], None
    if rng.random() < 0.55:
        settings["extra"] = rounded(case.total * Fraction(rng.choice([rng.uniform(0.02, 0.6), rng.uniform(0.3, 4)])))
    if rng.random() < 0.5:
        greatest = float(max(case.loads)) + float(settings.get("extra", 0)) * rng.uniform(0, 1)
        limits = [rounded(greatest * rng.choice([rng.uniform(0.7, 1.2), rng.uniform(1, 3)])) for _ in case.supports]
        if rng.random() < 0.6:
            settings["capacity"] = limits[0]
        if rng.random() < 0.5:
            own = [rng.choice([None, limit]) for limit in limits]
            own = own if any(own) else None
    case = with_settings(case, settings, own_capacities=own)
    if rng.random() < 0.3:
        more.append("--failures")
    if settings.get("com-height") and case.standing.stands and rng.random() < 0.2:
        room = case.standing.margin - float(case.setting("com-radius"))
        degrees = math.degrees(math.atan(room / float(settings["com-height"])))
        if degrees > 1e-3:
            more += ["--require", f"tip>={degrees * rng.choice([0.7, 0.99, 1.01, 1.5]):.4g}"]
    case = dataclasses.replace(case, more=tuple(more))
    if "extra" in settings and case.standing.stands and not has_slack(case):
        region_to_compare(case), greatest_anywhere(case)
    return case.run(), lambda answer: check_result(case, answer)


def moved(case, way):
    """The case with C moved, by moving the object's own: its cargo stays where it is."""
    own, part = case.own_mass_centre, case.total / case.weight
    return case.changed(own_centre=as_doubles(own[k] + part * Fraction(way[k]) for k in (0, 1)))


def lines_of(case):
    """The distances of C from the lines of the base's edges, and the outward unit normals, in doubles."""
    for a, b in edges_of(convex_hull(case.supports)):
        n = tuple(float(x) / distance(a, b) for x in (b[1] - a[1], a[0] - b[0]))
        yield float(cross(minus(b, a), minus(case.centre, a))) / distance(a, b), n


def sampled_directions(rng, program):
    """C moved by the reach in 64 directions: it never tips before the slope that is said, and loads are in range."""
    case = random_case(rng, program, count=rng.choice([3, 4, 5, 6]))
    size, margin, settings = case.polygon.size, case.standing.margin, {}
    settings["com-height"] = rounded(size * rng.uniform(0.05, 1))
    if rng.random() < 0.5:
        settings["com-radius"] = rounded(margin * rng.uniform(0.1, 0.7))
    part = Fraction(rng.choice([rng.uniform(0.05, 0.9), 1 - 1e-6, 1 - 1e-6]))
    # Together, slope and braking reach farther than their sum.
    share = Fraction(rng.choice([0, 0.5, 1] if part < 0.9 else [0, 1]))
    turns = [(j + rng.random()) / 64 for j in range(64)]
    case = dataclasses.replace(case, settings=settings)

    def at_slope(slope, share=Fraction(1)):
        if slope > 1:  # steeper than the program takes
            share = Fraction(0)
        slopes = {"slope": Fraction(float(slope * share)), "acceleration": Fraction(float(slope * (1 - share)))}
        return dataclasses.replace(case, settings={**settings, **{k: v for k, v in slopes.items() if v}})

    def check(answer):
        check_tilt(case, answer.result)
        told = Fraction(answer.result["tilt"]["slope"])
        within_it, beyond = at_slope(told * part, share), at_slope(told * Fraction(1 + 1e-6))
        expect(beyond.result()["tilt"]["stays"] is False, f"it stays on a slope of more than {float(told)}")
        result = within_it.result()
        expect(result["tilt"]["stays"] is True, f"it does not stay on a slope of less than {float(told)}")
        ranges, may_let_go = result["loads"]["ranges"], result["loads"]["may_let_go"]
        reach, tolerance = float(within_it.reach), LOADS * float(case.total)
        kept = float(within_it.kept)  # less of the weight acts on the robots
        for turn in turns:
            way = (reach * math.cos(2 * math.pi * turn), reach * math.sin(2 * math.pi * turn))
            other, where = moved(case, way).result(), f"with C moved by {way}"
            expect(other["stands"] is True, f"it tips {where}")
            models = other["loads"]["models"]
            for i, (least, greatest) in enumerate(ranges):
                f, worst = kept * models["springs"][i], kept * models["worst"][i]
                expect(f <= greatest + tolerance, f"robot {i} carries {f}, more than {greatest}, {where}")
                expect(f >= least - tolerance, f"robot {i} carries {f}, less than {least}, {where}")
                expect(not may_let_go or worst <= greatest + tolerance, f"robot {i} may carry {worst} {where}")
        off, n = min(lines_of(case))
        outward = tuple(off * (1 + 1e-5) * x for x in n)
        over = moved(case, outward).run().answer()
        expect(over.status == 2 or over.result["stands"] is False, "it stands though C is moved over the nearest edge")
        return ["may go slack" if may_let_go else "all carry"]

    return case.run(), check


def worst_points(rng, program):
    """C moved by the reach along the gradient of a robot's load gives the ends of its range."""
    case = random_case(rng, program, count=rng.choice([3, 4, 5, 6]))
    kinds = rng.choice([("com-radius", "acceleration"), ("com-radius", "acceleration"), ("com-radius", "slope")])
    settings = random_settings(rng, case, far=0, kinds=kinds)
    settings.pop("give", None), settings.pop("uneven", None)
    case = with_settings(case, settings)
    if case.reach == 0 or any(case.kept * f < half for f, half in zip(case.loads, case.halves)):
        raise Ambiguous

    def check(answer):
        list(check_result(case, answer))
        for i, pull in enumerate(case.springs.pulls):
            if not any(pull):
                continue
            along_it = tuple(case.reach * x / length(pull) for x in pull)
            for sign, end, name in ((1, 1, "greatest"), (-1, 0, "least")):
                if end == 0 and case.setting("slope") > 0:  # the weight across the plane is less
                    continue
                other = moved(case, tuple(sign * x for x in along_it)).result()
                told, found = answer.result["loads"]["ranges"][i][end], other["loads"]["models"]["springs"][i]
                expect_near(told, found, 10 * LOADS * float(case.total), f"the {name} load of robot {i}, by hand")
        return ["with a slope" if case.setting("slope") > 0 else "without a slope"]

    return case.run(), check


def is_fine(case, loads):
    """Whether with these loads, in their ranges, no robot is slack or overloaded; None if that is near."""
    spare = [f - float(half / case.kept) for f, half in zip(loads, case.halves)]
    spare += [float(k) - f - float(half) for f, half, k in zip(loads, case.halves, case.limits) if k is not None]
    near = 1e-8 * float(case.total)
    return None if abs(min(spare)) <= near else min(spare) > 0


def expect_fine(case, place, weight, fine, what):
    """Adds the weight as cargo."""
    other = case.changed(cargo=[*case.cargo, (place, weight)]).run().answer()
    loads = other.result["loads"]["models"]["springs"] if other.result and other.result["stands"] else None
    found = loads is not None and is_fine(case, loads)
    slack = loads is not None and min(loads) <= LOADS * float(case.total)
    at = tuple(map(float, place))
    if fine:
        expect(found is not False, f"{what} at {at} is said to be fine, but the loads are {loads}")
    else:
        expect(not found or slack, f"{what} at {at} is said not to be fine, but the loads are {loads}")


def places_of_the_weight(rng, program):
    """The extra weight as cargo at places inside its region and outside, and the weight that may stand anywhere."""
    case = random_case(rng, program)
    settings = random_settings(rng, case, far=0.1) if rng.random() < 0.4 else {}
    settings["extra"] = rounded(case.total * Fraction(rng.choice([rng.uniform(0.1, 1), rng.uniform(0.5, 3)])))
    if rng.random() < 0.5:
        with_it = max(case.loads) + settings["extra"] / len(case.supports)
        settings["capacity"] = rounded(with_it * Fraction(rng.uniform(1, 2)))
    case = with_settings(case, settings)
    region_to_compare(case), greatest_anywhere(case)

    def check(answer):
        list(check_result(case, answer))
        extra, size = answer.result["extra"], case.polygon.size
        region, weight = [tuple(map(Fraction, p)) for p in extra["region"]], case.settings["extra"]
        places = [as_doubles(grid_point(rng, case.polygon)) for _ in range(8)]
        for _ in range(8 if region else 0):  # beside the region's edges
            a, b = rng.choice(edges_of(region))
            middle, n = along(a, b, Fraction(rng.uniform(0.05, 0.95))), (b[1] - a[1], a[0] - b[0])
            way = Fraction(rng.choice([1, -1]) * 1e-3 * size / distance(a, b))
            places.append(as_doubles(middle[k] + way * n[k] for k in (0, 1)))
        names = collections.Counter()
        (left, low), (right, high) = case.box[0], case.box[2]
        for place in places:
            off = min((distance(place, nearest_on_segment(place, a, b)) for a, b in edges_of(region)), default=size)
            if off < 1e-6 * size or not (left <= place[0] <= right and low <= place[1] <= high):
                continue
            inside = bool(region) and all(cross(minus(b, a), minus(place, a)) > 0 for a, b in edges_of(region))
            expect_fine(case, place, weight, inside, "the extra weight")
            names["places inside" if inside else "places outside"] += 1
        anywhere = extra["anywhere"]
        if anywhere is not None and anywhere > 1e-6 * float(case.total):
            vertices, (less, more) = case.polygon.vertices, as_doubles(anywhere * part for part in (1 - 1e-6, 1 + 1e-6))
            for v in rng.sample(vertices, min(4, len(vertices))):
                expect_fine(case, v, less, True, f"a weight of {float(less)}")
            tight = min(vertices, key=lambda v: room_at(case, v, more))
            expect_fine(case, tight, more, False, f"a weight of {float(more)}")
            names["weights anywhere"] += 1
        return names.elements()

    return case.run(), check


def room_at(case, place, weight):
    """The least room that any robot has left, with a weight at this place."""
    room = []
    for i, (f, half, limit) in enumerate(zip(case.loads, case.halves, case.limits)):
        with_it = f + weight * case.springs.share(i, place)
        room += [with_it - half / case.kept, *([] if limit is None else [limit - with_it - half])]
    return min(room)


def one_answer(rng, program):
    """The same object mirrored, scaled, read from another vertex, and with the robots in another order."""
    case = random_case(rng, program)
    settings = random_settings(rng, case)
    settings["extra"] = rounded(case.total * Fraction(rng.uniform(0.1, 2)))
    if rng.random() < 0.5:
        settings["capacity"] = rounded(max(case.loads) * Fraction(rng.uniform(1, 2.5)))
    case = with_settings(case, settings, more=("--failures",))
    region_to_compare(case), greatest_anywhere(case)
    scale, heavier = Fraction(2) ** rng.randint(-6, 6), Fraction(2) ** rng.randint(-3, 3)
    flip, order = rng.choice([1, -1]), rng.sample(range(len(case.supports)), len(case.supports))

    def image(p):
        return (flip * scale * p[1], scale * p[0])

    ring = [image(p) for p in case.polygon.vertices]
    start = rng.randrange(len(ring))
    ring = (ring[start:] + ring[:start])[:: rng.choice([1, -1])]
    lengths, weights = ("com-radius", "com-height", "give", "uneven"), ("extra", "capacity")
    factors = {**dict.fromkeys(lengths, scale), **dict.fromkeys(weights, heavier)}
    other = dataclasses.replace(
        case, polygon=Polygon(ring), supports=[image(case.supports[i]) for i in order], weight=heavier * case.weight,
        own_centre=case.own_centre and image(case.own_centre), cargo=[(image(q), heavier * w) for q, w in case.cargo],
        holes=[[image(p) for p in hole] for hole in case.holes],
        settings={name: value * factors.get(name, 1) for name, value in case.settings.items()})  # fmt: skip

    def expect_same(first, second, factor, tolerance, what):
        expect((first is None) == (second is None), f"{what} is {first}, and of the image {second}")
        if first is not None:
            expect_near(second / float(factor), first, tolerance * (first + float(case.total)), f"{what} of the image")

    def check(answer):
        one, two, size = answer.result, other.result(), case.polygon.size
        if case.is_uncertain:
            expect(one["loads"]["may_let_go"] is two["loads"]["may_let_go"], "may_let_go differs")
            for i, j in enumerate(order):
                for end in (0, 1):
                    ranges = [r["loads"]["ranges"][at][end] for r, at in ((one, j), (two, i))]
                    expect_same(*ranges, heavier, LOADS, f"loads.ranges[{j}][{end}]")
                if not is_failure_near(case, j):
                    failures = [r["failures"][at] for r, at in ((one, j), (two, i))]
                    expect(failures[0]["stays"] == failures[1]["stays"], f"failures[{j}].stays differs")
                    ends = [failure["greatest_end"] for failure in failures]
                    expect_same(*ends, heavier, 10 * LOADS, f"failures[{j}].greatest_end")
        if case.setting("com-height"):
            expect_near(two["tilt"]["slope"], one["tilt"]["slope"], 1e-9 * (1 + one["tilt"]["slope"]), "tilt.slope")
            expect(two["tilt"]["stays"] is one["tilt"]["stays"], "tilt.stays differs")
        expect_near(two["extra"]["share"], one["extra"]["share"], 1e-8, "extra.share of the image")
        expect_same(one["extra"]["anywhere"], two["extra"]["anywhere"], heavier, 1e-8, "extra.anywhere")
        areas = [float(twice_area([tuple(map(Fraction, p)) for p in r["extra"]["region"]])) for r in (one, two)]
        expect_near(areas[1] / float(scale) ** 2, areas[0], 1e-8 * size * size, "twice the area of the image's region")
        return ["one answer"]

    return case.run(), check


def is_failure_near(case, failed):
    """Whether what is said of a failure lies near a decision, or has no definition by springs alone."""
    rest = case.supports[:failed] + case.supports[failed + 1 :]
    try:
        margin, springs = standing_of(case.polygon, rest, case.centre).margin, Springs(rest)
    except (Ambiguous, ZeroDivisionError):
        return True
    loads, near = springs.loads(case.centre, case.total), NEAR * case.total
    if margin > 0 and (min(loads) < near or abs(margin - float(case.reach_of(springs))) < NEAR * case.polygon.size):
        return True
    counts, reach, kept = (len(rest), len(case.supports)), case.load_reach_of(springs), case.kept_of(springs)
    halves = [springs.halves(case.total, reach, case.uneven, case.total / count) for count in counts]
    return any(abs(kept * f - half) < near for each in halves for f, half in zip(loads, each))


# The examples of the definition, and some more.


def examples(program):
    square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    corners, third = square.vertices, 100 / 3

    def example(checks, polygon=square, supports=None, more=(), **settings):
        options = {name.replace("_", "-"): v if isinstance(v, str) else Fraction(v) for name, v in settings.items()}
        return Case(program, polygon, supports or polygon.vertices, options, more=more).run(), checks

    def expect_ranges(r, ranges, may_let_go=False):
        expect(r["loads"]["may_let_go"] is may_let_go, f"may_let_go is {r['loads']['may_let_go']}")
        for i, right in enumerate(ranges):
            for end in (0, 1):
                expect_near(r["loads"]["ranges"][i][end], right[end], 1e-7, f"loads.ranges[{i}][{end}]")

    def expect_region(r, corners, share, anywhere):
        got, right = ([tuple(map(Fraction, p)) for p in ring] for ring in (r["extra"]["region"], corners))
        expect_same_ring(got, right, 1e-9, 1e-9, "extra.region")
        expect_near(r["extra"]["share"], share, 1e-9, "extra.share")
        expect_near(r["extra"]["anywhere"], anywhere, 1e-7, "extra.anywhere")

    def tips(r):
        right = {"height": 1, "reach": 0, "slope": 0.5, "acceleration": 0.5, "degrees": 26.56505117707799}
        expect(r["tilt"]["acceleration_left"] is r["tilt"]["slope_left"] is None, "nothing is left where nothing is set")
        expect(set(r["tilt"]) == TILT, f"tilt is {r['tilt']}")
        for name, value in right.items():
            expect_near(r["tilt"][name], value, 1e-9, f"tilt.{name}")
        expect(r["tilt"]["stays"] is True and r["loads"].get("ranges") is None, "it stays, and nothing is uncertain")

    def on_a_slope(r):
        half = 100 * 0.2 * math.sqrt(0.5)
        expect_ranges(r, [(25 / math.sqrt(1.04) - half, 25 + half)] * 4)
        expect_near(half, 14.142, 5e-4, "the table")
        expect(r["tilt"]["stays"] is True, "it stays")

    def slope_without_height(r):
        expect(r["tilt"] is None, "tilt without a height")
        expect_ranges(r, [(25 / math.sqrt(1.04), 25)] * 4)

    def uneven_square(r):
        expect(r["tilt"] is None, "tilt without a height")
        expect_ranges(r, [(18.75, 31.25)] * 4)

    def diamond(r):
        expect_region(r, [(0.5, 0), (1, 0.5), (0.5, 1), (0, 0.5)], 0.5, third)

    def whole_square(r):
        expect_region(r, [(0, 0), (1, 0), (1, 1), (0, 1)], 1, 100)

    def uneven_hexagon(r):
        expect_ranges(r, [(100 / 6 / 3, 100 / 6 * 5 / 3)] * 6)

    def slack_hexagon(r):  # 4/3 of the mean load is more than it, so the upper end is that of `worst`
        expect_ranges(r, [(0, 50)] * 6, may_let_go=True)

    def lets_go(r):
        expect_ranges(r, [(0, 50)] * 4, may_let_go=True)

    def tilts(value, stays):
        def check(r):
            expect_near(r["tilt"]["reach"], value, 5e-5, "tilt.reach")
            expect(r["tilt"]["stays"] is stays, f"tilt.stays is {r['tilt']['stays']}")

        return check

    def left(name, value):
        return lambda r: expect_near(r["tilt"][name], value, 5e-5, f"tilt.{name}")

    def anywhere(value):
        return lambda r: expect_near(r["extra"]["anywhere"], value, 0.05, "extra.anywhere")

    def least(robot, value):
        return lambda r: expect_near(r["loads"]["ranges"][robot][0], value, 5e-4, f"loads.ranges[{robot}][0]")

    def uneven_three(r):  # three robots touch any ground
        expect_ranges(r, [(25, 25), (25, 25), (50, 50)])

    def any_weight(r):
        expect_near(r["extra"]["share"], 1, 1e-9, "extra.share")
        expect(r["extra"]["anywhere"] is None, f"extra.anywhere is {r['extra']['anywhere']}, though any weight may")

    def no_region(r):
        expect(r["extra"]["region"] == [] and r["extra"]["share"] == 0, f"extra is {r['extra']}")
        expect_near(r["extra"]["anywhere"], 0, 1e-9, "extra.anywhere")

    def at_the_limit(r):
        expect(r["tilt"]["stays"] is True, "a slope of 0.5 is just kept")
        expect_ranges(r, [(0, 50 + 50 * math.sqrt(0.5))] * 4, may_let_go=True)  # C at half a side towards the corner

    def beyond_the_limit(r):
        expect(r["tilt"]["stays"] is False, "a slope of 0.6 is not kept")

    def reach(value):
        def check(r):
            expect_near(r["tilt"]["reach"], value, 1e-12, "tilt.reach")
            expect_near(r["tilt"]["slope"], 0.25, 1e-12, "tilt.slope")

        return check

    def falling(r):
        expect(r["stands"] is False and r["loads"] is None, "it falls")
        expect(r["tilt"]["slope"] == r["tilt"]["acceleration"] == r["tilt"]["degrees"] == 0, f"tilt is {r['tilt']}")
        expect(r["tilt"]["stays"] is False, "it stays, though it falls")

    def segment(r):
        expect(r["stands"] is True and r["tilt"]["slope"] == 0 and r["tilt"]["stays"] is False, f"tilt is {r['tilt']}")

    def nothing_set(r):
        new = (r["tilt"], r["loads"].get("ranges"), r.get("extra"))
        expect(new == (None, None, None), f"without any setting there is {new}")

    def failing(r):  # C is on the edge of what remains of the base
        for i, failure in enumerate(r["failures"]):
            expect(failure["carried"] is True and failure["stays"] is False, f"failures[{i}] is {failure}")

    hexagon = Polygon([(math.cos(math.pi * k / 3), math.sin(math.pi * k / 3)) for k in range(6)])
    triangle = Polygon([(0.1, 0.7), (3.3, 0.2), (1.9, 4.7)])
    quarter, half = Fraction(1, 4), Fraction(1, 2)

    yield example(tips, com_height=1)
    yield example(on_a_slope, com_height=1, slope=0.2)
    yield example(slope_without_height, slope=0.2)
    yield example(uneven_square, give=4, uneven=1)
    yield example(diamond, extra=50, capacity=50)
    yield example(whole_square, extra=50)
    yield example(uneven_hexagon, hexagon, give=2, uneven=1)
    yield example(slack_hexagon, hexagon, give=1, uneven=1)
    yield example(uneven_three, supports=[(0, 0), (1, 0), (half, Fraction(1))], give=1, uneven=3)
    yield example(any_weight, triangle, extra=50)
    yield example(any_weight, triangle, extra=5000)
    yield example(no_region, extra=50, capacity=20)
    yield example(at_the_limit, com_height=1, slope=0.5)
    yield example(at_the_limit, com_height=2, acceleration=0.25)
    yield example(beyond_the_limit, com_height=1, slope=0.6)
    yield example(reach(0.16), com_height=2, slope="8%")
    yield example(reach(2 * math.tan(math.radians(4.6))), com_height=2, slope="4.6deg")
    yield example(reach(2 * (0.05 + 0.1 * math.sqrt(1.0025))), com_height=2, slope=0.05, acceleration=0.1)
    yield example(tilts(0.4979, True), com_height=1.24, slope=0.1, acceleration=0.3)
    yield example(tilts(0.5189, False), com_height=0.49, slope=0.5, acceleration=0.5)
    yield example(tilts(0.2, True), com_height=1, give=1, uneven=0.1)  # heights tilt it by 2 uneven / side
    yield example(left("acceleration_left", 0.0928), com_height=1, slope=0.4)
    yield example(left("slope_left", 0.1944), com_height=1, acceleration=0.3)
    yield example(lets_go, slope=0.5, give=1, uneven=0.95)
    yield example(lets_go, uneven=5)
    yield example(anywhere(44.1), slope=0.5, give=1, uneven=0.5, extra=10)
    yield example(least(4, 0), supports=[*corners, (half, half)], com_radius=0.45)
    yield example(least(0, 14.487), com_height=0.3, slope=0.3, acceleration=0.5, more=("--com", "0.25,0.25"))
    yield example(falling, supports=[(0, 0), (0.25, 0), (0, 0.25)], com_height=1, slope=0.1)
    yield example(segment, supports=[(quarter, 0), (1 - quarter, 1)], com_height=1, slope=0.1)
    yield example(nothing_set)
    yield example(failing, com_height=1, slope=0.1, more=("--failures",))


# Everything together.

SHARES = [(judged, 80), (sampled_directions, 1.5), (worst_points, 5), (places_of_the_weight, 5), (one_answer, 8)]


if __name__ == "__main__":
    check_all(__doc__, examples, SHARES, 120)
