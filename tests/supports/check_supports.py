#!/usr/bin/env python3
"""The method `given` against exact rational arithmetic, which was written from the definition and not from the code.

    python3 tests/supports/check_supports.py build/bin/evenlift [--cases N] [--seed S]

Robots that stand where the user puts them: places, loads, falling, closure, coverage, --even-out and --require. Each case runs
the program once. Every coordinate is a double and is taken as exact. A case that lies within a few tolerances of a decision is
drawn again.
"""

import argparse
import collections
import itertools
import json
import math
import random
import re
import subprocess
import sys
import time
from fractions import Fraction

TAU = 1e-9  # the definition's tolerance; for lengths, times the polygon's size
LOADS = 1e-9  # for loads, times the weight
MOTIONS = ("clockwise", "counterclockwise", "translation")


class Ambiguous(Exception):
    """The case lies too near to a decision."""


class Disagreement(Exception):
    """The program does not do what the definition says."""


def expect(condition, what):
    if not condition:
        raise Disagreement(what)


def expect_near(got, expected, tolerance, what):
    near = got is not None and abs(got - float(expected)) <= tolerance
    expect(near, f"{what}: the program says {got}, the definition {float(expected)!r}")


# Plane geometry. Points are pairs of fractions.


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1])


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def along(a, b, t):
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def mirrored(p, middle):
    return (2 * middle[0] - p[0], 2 * middle[1] - p[1])


def distance(p, q):
    return math.sqrt(dot(minus(p, q), minus(p, q)))


def nearest_on_segment(p, a, b):
    d = minus(b, a)
    if d == (0, 0):
        return a
    return along(a, b, min(Fraction(1), max(Fraction(0), dot(minus(p, a), d) / dot(d, d))))


def distance_to_line(p, a, b):
    """Positive on the left of the line."""
    d = minus(b, a)
    return float(cross(d, minus(p, a))) / math.sqrt(dot(d, d))


def edges_of(ring):
    return list(zip(ring, ring[1:] + ring[:1]))


def twice_area(ring):
    return sum(cross(a, b) for a, b in edges_of(ring))


def convex_hull(points):
    """The corners only, counter-clockwise; one or two points if the hull has no area."""
    points = sorted(set(points))
    if len(points) < 3:
        return points
    hull = []
    for chain in (points, points[::-1]):
        start = len(hull)
        for p in chain:
            while len(hull) - start >= 2 and cross(minus(hull[-1], hull[-2]), minus(p, hull[-1])) <= 0:
                hull.pop()
            hull.append(p)
        hull.pop()
    return hull


def strictly_inside_hull(p, hull):
    return len(hull) > 2 and all(cross(minus(b, a), minus(p, a)) > 0 for a, b in edges_of(hull))


def nearest_in_hull(p, hull):
    if len(hull) > 2 and all(cross(minus(b, a), minus(p, a)) >= 0 for a, b in edges_of(hull)):
        return p
    return min((nearest_on_segment(p, a, b) for a, b in edges_of(hull)), key=lambda q: dot(minus(p, q), minus(p, q)))


class Polygon:
    def __init__(self, vertices):
        self.vertices = [(Fraction(x), Fraction(y)) for x, y in vertices]
        self.edges = edges_of(self.vertices)
        self.double_area = twice_area(self.vertices)
        self.turn = 1 if self.double_area > 0 else -1
        self.hull = convex_hull(self.vertices)
        self.size = max(distance(p, q) for p in self.hull for q in self.hull)

    def centroid(self):
        terms = [(cross(a, b), a, b) for a, b in self.edges]
        return tuple(sum(c * (a[k] + b[k]) for c, a, b in terms) / (3 * self.double_area) for k in (0, 1))

    def contains(self, p):
        """Points of the outline do not matter: the caller treats them first."""
        inside = False
        for a, b in self.edges:
            if (a[1] > p[1]) != (b[1] > p[1]):
                inside ^= (cross(minus(b, a), minus(p, a)) > 0) == (b[1] > a[1])
        return inside

    def inward(self, edge):
        a, b = self.edges[edge]
        return (self.turn * (a[1] - b[1]), self.turn * (b[0] - a[0]))

    def turn_at(self, vertex):
        """Positive at a convex vertex, zero at a straight one, negative at a reflex one."""
        return self.turn * cross(minus(*self.edges[vertex - 1][::-1]), minus(*self.edges[vertex][::-1]))


# Where a support stands, and what it touches.

Place = collections.namedtuple("Place", "kind point edge vertex")


def is_within(value, bound, ambiguous=0.5):
    if bound * (1 - ambiguous) < value < bound * (1 + 2 * ambiguous):
        raise Ambiguous
    return value <= bound


def is_notch(polygon, vertex):
    """Reflex, and turning by more than 15 degrees."""
    if polygon.turn_at(vertex) >= 0:
        return False
    u, v = minus(*polygon.edges[vertex - 1][::-1]), minus(*polygon.edges[vertex][::-1])
    cosine = float(dot(u, v)) / math.sqrt(float(dot(u, u)) * float(dot(v, v)))
    return cosine < math.cos(math.radians(15))


def place_of(polygon, p, snap):
    """The place of a support; of the kind "outside" with its distance in place of the edge."""
    near = TAU * polygon.size
    points = [nearest_on_segment(p, a, b) for a, b in polygon.edges]
    distances = [distance(p, q) for q in points]
    least = min(distances)
    if not is_within(least, snap, 0.01):
        return Place("beneath", p, None, None) if polygon.contains(p) else Place("outside", p, least, None)
    if least > 2.0**-50 * max(map(abs, p)):
        notches = [i for i in range(len(polygon.vertices)) if is_notch(polygon, i)]
        near_notches = [i for i in notches if is_within(distance(polygon.vertices[i], p), snap, 0.01)]
        if len(near_notches) > 1:
            raise Ambiguous
        if near_notches:
            return Place("edge", polygon.vertices[near_notches[0]], None, near_notches[0])
    edge = next(i for i, d in enumerate(distances) if is_within(d - least, near))
    corners = [i for i, v in enumerate(polygon.vertices) if is_within(distance(points[edge], v), near)]
    if corners:
        return Place("edge", polygon.vertices[corners[0]], None, corners[0])
    return Place("edge", points[edge], edge, None)


def contacts_of(polygon, place):
    """Pairs of a point and an inward normal of any length."""
    if place.kind == "beneath":
        return []
    if place.vertex is None:
        return [(place.point, polygon.inward(place.edge))]
    turn, before = polygon.turn_at(place.vertex), (place.vertex or len(polygon.vertices)) - 1
    normals = [polygon.inward(before), polygon.inward(place.vertex)]
    return [(place.point, n) for n in normals[: 0 if turn > 0 else 1 if turn == 0 else 2]]


# Loads.


def solution(rows):
    """Any solution of linear equations, each a row of coefficients and a right side; None if there is none."""
    rows, columns, pivots = [list(row) for row in rows], len(rows[0]) - 1, []
    for column in range(columns):
        at = next((r for r in range(len(pivots), len(rows)) if rows[r][column] != 0), None)
        if at is None:
            continue
        top = len(pivots)
        rows[top], rows[at] = rows[at], rows[top]
        rows[top] = [value / rows[top][column] for value in rows[top]]
        for r in range(len(rows)):
            if r != top and rows[r][column] != 0:
                factor = rows[r][column]
                rows[r] = [value - factor * above for value, above in zip(rows[r], rows[top])]
        pivots.append(column)
    if any(row[-1] != 0 for row in rows[len(pivots) :]):
        return None
    found = [Fraction(0)] * columns
    for row, column in zip(rows, pivots):
        found[column] = row[-1]
    return found


def plane_of(points, centre, weight):
    """The least squares without f >= 0: a plane whose heights at the points are the loads; None if there are none."""
    lifted = [(Fraction(1), *minus(p, centre)) for p in points]
    rows = [[sum(u[i] * u[j] for u in lifted) for j in range(3)] + [weight if i == 0 else Fraction(0)] for i in range(3)]
    return solution(rows)


def height(plane, p, centre):
    d = minus(p, centre)
    return plane[0] + plane[1] * d[0] + plane[2] * d[1]


def springs_by_subsets(points, centre, weight):
    """The loads that are positive are the least squares of their robots alone, so one of all subsets is the answer."""
    best = None
    for count in range(len(points), 0, -1):
        for chosen in itertools.combinations(range(len(points)), count):
            plane = plane_of([points[i] for i in chosen], centre, weight)
            if plane is None:
                continue
            loads = [Fraction(0)] * len(points)
            for i in chosen:
                loads[i] = height(plane, points[i], centre)
            if min(loads) >= 0 and (best is None or sum(f * f for f in loads) < sum(f * f for f in best)):
                best = loads
        if best is not None and count == len(points):
            break  # all robots' least squares need no bound
    return best


def springs_by_rounds(points, centre, weight):
    """Drops robots that pull and adds robots that are pressed. Where it repeats, its loads satisfy the optimality conditions."""
    chosen = set(range(len(points)))
    for _ in range(4 * len(points)):
        plane = plane_of([points[i] for i in sorted(chosen)], centre, weight)
        if plane is None:
            break
        heights = [height(plane, p, centre) for p in points]
        pressed = {i for i, h in enumerate(heights) if h > 0}
        if pressed == chosen or all(heights[i] == 0 for i in pressed ^ chosen):
            return [max(Fraction(0), h) for h in heights]
        chosen = pressed
    raise Ambiguous


def springs_of(points, centre, weight):
    return (springs_by_subsets if len(points) <= 7 else springs_by_rounds)(points, centre, weight)


def best_of(points, centre, weight):
    """The least possible greatest load. On one line the functions g are zero at one robot each."""
    hull, best = convex_hull(points), weight / len(points)
    if len(hull) == 1:
        return best
    if len(hull) == 2:
        d = minus(hull[1], hull[0])
        functions = [lambda q, p=p, s=s: s * dot(d, minus(q, p)) for p in points for s in (1, -1)]
    else:
        pairs = itertools.permutations(points, 2)
        functions = [lambda q, a=a, b=b: cross(minus(b, a), minus(q, a)) for a, b in pairs]
    for g in functions:
        below = sum(max(0, g(p)) for p in points)
        if below > 0:
            best = max(best, weight * g(centre) / below)
    return best


def worst_of(points, centre, weight):
    """The lever about the edge of the hull through which the ray from the robot through the centre of mass leaves."""
    hull, loads = convex_hull(points), []
    for p in points:
        d = minus(centre, p)
        if d == (0, 0):
            loads.append(weight)
            continue
        if len(hull) == 2:
            t = max(dot(d, minus(q, p)) for q in hull) / dot(d, d)
        else:
            crossed = [(cross(minus(b, a), minus(p, a)), cross(minus(b, a), d)) for a, b in edges_of(hull)]
            t = min(inside / -speed for inside, speed in crossed if speed < 0)
        loads.append(weight * max(Fraction(0), t - 1) / t)
    return loads


# Falling.

Standing = collections.namedtuple("Standing", "stands margin beyond")  # beyond: how far C is beyond an edge's line


def standing_of(polygon, points, centre):
    """Whether it stands, the tipping distance, and how far C is beyond the line of an edge of a lifting base with an area."""
    near, hull = TAU * polygon.size, convex_hull(points)
    off = distance(centre, nearest_in_hull(centre, hull))
    widths = [max(abs(distance_to_line(p, a, b)) for p in hull) for a, b in edges_of(hull)] if len(hull) > 2 else []
    if len(hull) > 1 and min(widths or [distance(*hull)]) < 10 * near:  # almost a segment or a point
        raise Ambiguous
    if is_within(off, near):
        return Standing(True, min(abs(distance_to_line(centre, a, b)) for a, b in edges_of(hull)) if len(hull) > 2 else 0, 0)
    return Standing(False, -off, max(-distance_to_line(centre, a, b) for a, b in edges_of(hull)) if len(hull) > 2 else 0)


def tips_over(polygon, points, centre, beyond, told):
    """Whether it tips over these points: both ends of an edge of the lifting base, of those that C is beyond the farthest."""
    near, hull = TAU * polygon.size, convex_hull(points)
    if len(hull) < 3:
        end = min(hull, key=lambda p: distance(p, centre))
        on_line = len(hull) == 1 or is_within(abs(distance_to_line(centre, *hull)), near)
        ends = [end] if on_line else hull
        return len(told) == len(ends) and any(all(distance(p, q) <= near for p, q in zip(told, order)) for order in (ends, ends[::-1]))

    def is_edge(p, q):
        heights = [distance_to_line(x, p, q) for x in points]
        at = [float(dot(minus(x, p), minus(q, p))) / distance(p, q) for x, h in zip(points, heights) if h <= near]
        ends_it = min(at) >= -near and max(at) <= distance(p, q) + near
        return min(heights) >= -near and ends_it and -distance_to_line(centre, p, q) >= beyond - near

    return len(told) == 2 and told[0] != told[1] and (is_edge(*told) or is_edge(*told[::-1]))


def coverage_of(polygon, hull):
    """The polygon is cut by the line of each edge of the hull. Double edges that remain add no area."""
    if len(hull) < 3:
        return Fraction(0)
    ring = polygon.vertices
    for a, b in edges_of(hull):
        cut, side = [], [cross(minus(b, a), minus(p, a)) for p in ring]
        for i, p in enumerate(ring):
            if side[i - 1] * side[i] < 0:
                cut.append(along(ring[i - 1], p, side[i - 1] / (side[i - 1] - side[i])))
            if side[i] >= 0:
                cut.append(p)
        ring = cut
        if not ring:
            return Fraction(0)
    return twice_area(ring) / polygon.double_area


# Closure.


def closes_by_wrenches(contacts, centre):
    """Whether the wrenches positively span all three dimensions: no plane through the origin has all of them on one side."""
    wrenches = [(*n, cross(minus(p, centre), n)) for p, n in contacts]

    def normal(u, v):
        return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])

    planes = [normal(u, v) for u, v in itertools.combinations(wrenches, 2)]
    planes = [plane for plane in planes if any(plane)]
    sides = [[sum(a * b for a, b in zip(plane, w)) for w in wrenches] for plane in planes]
    spans = any(any(side) for side in sides)
    return spans and all(min(side) < 0 < max(side) for side in sides)


def translation_is_free(contacts):
    directions = [(s * n[1], -s * n[0]) for _, n in contacts for s in (1, -1)]
    return not contacts or any(all(dot(n, d) >= 0 for _, n in contacts) for d in directions)


def half_planes(contacts, sense, wider=Fraction(0)):
    """The centres c with a . c >= b about which a rotation is free, counter-clockwise for the sense 1."""
    rows = []
    for p, n in contacts:
        a = (-sense * n[1], sense * n[0])
        rows.append((a, dot(a, p) - wider * Fraction(math.sqrt(dot(n, n)))))
    return rows


def is_empty(rows):
    """A region that is not the whole plane has a point on one of its lines."""
    for a, b in rows:
        start, d = (a[0] * b / dot(a, a), a[1] * b / dot(a, a)), (-a[1], a[0])
        low = high = None
        for other, bound in rows:
            speed, need = dot(other, d), bound - dot(other, start)
            if speed == 0:
                if need > 0:
                    break
            elif speed > 0:
                low = need / speed if low is None else max(low, need / speed)
            else:
                high = need / speed if high is None else min(high, need / speed)
        else:
            if low is None or high is None or low <= high:
                return False
    return bool(rows)


def corners_of(rows):
    """The corners of a bounded region."""
    found = set()
    for (a, b), (c, d) in itertools.combinations(rows, 2):
        if cross(a, c) != 0:
            p = ((b * c[1] - d * a[1]) / cross(a, c), (a[0] * d - c[0] * b) / cross(a, c))
            if all(dot(n, p) >= bound for n, bound in rows):
                found.add(p)
    return sorted(found)


def is_ruled_out(contacts, c):
    """Whether weights balance the contacts whose normals pass through c, with a positive sum of their distances to c."""
    through = [(n, dot(n, minus(c, p))) for p, n in contacts if cross(n, minus(c, p)) == 0]
    for (n, d), (m, e) in itertools.combinations(through, 2):
        if cross(n, m) == 0 and dot(n, m) < 0 and dot(m, m) * d - dot(n, m) * e > 0:
            return True
    for (n, d), (m, e), (k, f) in itertools.combinations(through, 3):
        weights = (cross(m, k), cross(k, n), cross(n, m))
        if max(weights) < 0:
            weights = tuple(-w for w in weights)
        if min(weights) > 0 and weights[0] * d + weights[1] * e + weights[2] * f > 0:
            return True
    return False


Closure = collections.namedtuple("Closure", "free closed second_order")


def closure_of(polygon, contacts, centre):
    if not contacts:
        return Closure(set(MOTIONS), False, False)
    free, second, near = set(), True, Fraction(TAU * polygon.size)
    slides = translation_is_free(contacts)
    if slides:
        free.add("translation")
    for name, sense in (("counterclockwise", 1), ("clockwise", -1)):
        rows = half_planes(contacts, sense)
        if is_empty(rows):
            if not is_empty(half_planes(contacts, sense, 4 * near)):
                raise Ambiguous
            continue
        free.add(name)
        if slides:
            continue
        corners = corners_of(rows)
        if len(convex_hull(corners)) > 2:
            if is_empty(half_planes(contacts, sense, -4 * near)):
                raise Ambiguous
            second = False
        else:
            second = second and is_ruled_out(contacts, along(corners[0], corners[-1], Fraction(1, 2)))
    closed = closes_by_wrenches(contacts, centre)
    if closed != (not free):
        raise AssertionError("half-planes and wrenches differ")
    return Closure(free, closed, bool(free) and not slides and second)


def margin_of(polygon, contacts, centre):
    """The radius of the ball about the origin inside the hull of the wrenches, for contacts in form closure."""
    radius, wrenches = max(distance(v, centre) for v in polygon.vertices), []
    for p, n in contacts:
        length = math.sqrt(dot(n, n))
        wrenches.append((float(n[0]) / length, float(n[1]) / length, float(cross(minus(p, centre), n)) / length / radius))
    least = math.inf
    for u, v, w in itertools.combinations(wrenches, 3):
        a, b = [y - x for x, y in zip(u, v)], [y - x for x, y in zip(u, w)]
        normal = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        length = math.hypot(*normal)
        if length < 1e-9:
            continue
        height_of = [sum(x * y for x, y in zip(normal, each)) / length for each in wrenches]
        offset = sum(x * y for x, y in zip(normal, u)) / length
        if max(height_of) <= offset + 1e-10 or min(height_of) >= offset - 1e-10:
            least = min(least, abs(offset))
    return least


# Even chords and --even-out.


def even_chords(polygon_edges, vertices, middle):
    """The even candidates about a point: crossings of the outline with its mirror image, and middles of common parts."""
    ends = []
    usable = [(a, b) for a, b in polygon_edges if cross(minus(b, a), minus(middle, a)) != 0]
    for (a, b), (c, d) in itertools.combinations(usable, 2):
        c, d = mirrored(c, middle), mirrored(d, middle)
        u, v, w = minus(b, a), minus(d, c), minus(c, a)
        area = cross(u, v)
        if area != 0:
            if 0 <= cross(w, v) / area <= 1 and 0 <= cross(w, u) / area <= 1:
                ends.append(along(a, b, cross(w, v) / area))
        elif cross(u, w) == 0:
            s, t = sorted(dot(minus(q, a), u) / dot(u, u) for q in (c, d))
            if max(0, s) <= min(1, t):
                ends.append(along(a, b, (max(0, s) + min(1, t)) / 2))
    ends += [v for v, w in itertools.combinations(vertices, 2) if w == mirrored(v, middle)]
    return [(p, mirrored(p, middle)) for p in ends]


def ways(points, i, j, chord):
    """The sum of the squares of the two ways, for the shorter of both assignments."""
    return min(sum(dot(minus(q, points[k]), minus(q, points[k])) for k, q in zip(order, chord)) for order in ((i, j), (j, i)))


def middle_of(points, centre, moved, *more):
    rest = [p for k, p in enumerate(points) if k not in moved] + list(more)
    return tuple((len(points) * centre[k] - sum(p[k] for p in rest)) / 2 for k in (0, 1))


def nearest_pair_move(polygon, points, centre):
    """The least sum of squared ways with two robots moved; None if no two robots will do."""
    best = None
    for i, j in itertools.combinations(range(len(points)), 2):
        middle = middle_of(points, centre, (i, j))
        if strictly_inside_hull(middle, polygon.hull):
            for chord in even_chords(polygon.edges, polygon.vertices, middle):
                way = ways(points, i, j, chord)
                best = way if best is None else min(best, way)
    return best


def trial_points(polygon, centre):
    """64 points of the outline, from the vertex farthest from C counter-clockwise, and the reflex vertices; in doubles."""
    vertices = [(float(x), float(y)) for x, y in polygon.vertices][:: polygon.turn]
    far = max(distance(v, centre) for v in vertices)
    start = vertices.index(min(v for v in vertices if distance(v, centre) >= far - TAU * polygon.size))
    edges = edges_of(vertices[start:] + vertices[:start])
    lengths = [math.dist(a, b) for a, b in edges]
    points = []
    for j in range(64):
        rest, at = (j + 0.5) / 64 * sum(lengths), 0
        while rest > lengths[at]:
            rest, at = rest - lengths[at], at + 1
        points.append(along(*edges[at], rest / lengths[at]))
    reflex = [v for i, v in enumerate(polygon.vertices) if polygon.turn_at(i) < 0]
    return points + [(float(x), float(y)) for x, y in reflex if len(reflex) <= 64]


def nearest_triple_move(polygon, points, centre):
    """The least sum of squared ways with three robots moved, one of them to a trial point; in doubles."""
    edges = [tuple((float(x), float(y)) for x, y in edge) for edge in polygon.edges]
    vertices, hull = [a for a, _ in edges], [(float(x), float(y)) for x, y in polygon.hull]
    robots, c = [(float(x), float(y)) for x, y in points], (float(centre[0]), float(centre[1]))
    best = None
    for third in trial_points(polygon, centre):
        for moved in itertools.combinations(range(len(robots)), 3):
            middle = middle_of(robots, c, moved, third)
            if not strictly_inside_hull(middle, hull):
                continue
            chords = even_chords(edges, vertices, middle)
            for k, chord in itertools.product(moved, chords):
                i, j = (each for each in moved if each != k)
                way = ways(robots, i, j, chord) + math.dist(robots[k], third) ** 2
                best = way if best is None else min(best, way)
    return best


# The program.

Answer = collections.namedtuple("Answer", "status result error")


def decimal(value):
    number = float(value)
    if Fraction(number) != value:
        raise AssertionError(f"{value} is not a double")
    return repr(number)[:-2] if repr(number).endswith(".0") else repr(number)


def pairs_of(points):
    return [f"{decimal(x)},{decimal(y)}" for x, y in points]


class Run:
    """One call of the program, and the command line that repeats it."""

    def __init__(self, program, polygon, supports, *options, capacities=None):
        self.text = "\n".join(pairs_of(polygon.vertices)) + "\n"
        told = [p if k is None else f"{p}@{k}" for p, k in zip(pairs_of(supports), capacities or [None] * len(supports))]
        self.arguments = ["place", "-", "--supports", " ".join(told), *options]
        self.program = program

    def __str__(self):
        quoted = [f"'{a}'" if re.search(r"[^\w./-]", a) else a for a in self.arguments]
        return "printf '%s' | %s %s" % (self.text.replace("\n", "\\n"), self.program, " ".join(quoted))

    def answer(self):
        done = subprocess.run([self.program, *self.arguments], input=self.text, capture_output=True, text=True, timeout=60, check=False)
        expect(done.returncode in (0, 2, 3), f"exit status {done.returncode}")
        if done.returncode == 2:
            expect(done.stdout == "" and done.stderr.startswith("evenlift: ") and done.stderr.count("\n") == 1,
                   f"an error is one line on standard error, not {done.stderr!r}")
            return Answer(2, None, done.stderr)
        # What the snap distance did is told, and which load is outside.
        told = all(line.startswith(("evenlift: --supports: ", "evenlift: --cargo: the load at ")) for line in done.stderr.splitlines())
        expect(told, f"a message without an error: {done.stderr!r}")
        return Answer(done.returncode, json.loads(done.stdout), "")


# Random cases.


def convex_polygon(rng):
    while True:
        hull = convex_hull([(rng.randint(0, 40), rng.randint(0, 40)) for _ in range(rng.randint(3, 14))])
        if len(hull) > 2:
            return hull


def star_polygon(rng):
    """Vertices in the order of their directions from a point in the middle, less than half a turn from each to the next."""
    while True:
        directions = {}
        for _ in range(rng.randint(4, 12)):
            p = (rng.randint(-20, 20), rng.randint(-20, 20))
            if p != (0, 0):
                divisor = math.gcd(*p)
                directions.setdefault((p[0] // divisor, p[1] // divisor), p)
        ring = sorted(directions.values(), key=lambda p: math.atan2(p[1], p[0]))
        if len(ring) > 2 and all(cross(a, b) > 0 for a, b in edges_of(ring)):
            return ring


def steps_polygon(rng):
    """Columns of different heights above a line, perhaps also below it: notches, and edges along the axes."""
    def profile(sign):
        x, ring = 0, []
        for width in widths:
            y = sign * rng.randint(1, 10)
            ring += [(x, y), (x + width, y)]
            x += width
        return ring

    widths = [rng.randint(1, 8) for _ in range(rng.randint(1, 4))]
    lower = profile(-1) if rng.random() < 0.5 else [(0, 0), (sum(widths), 0)]
    ring = lower + profile(1)[::-1]
    return [p for p, q in edges_of(ring) if p != q]


def pocket_polygon(rng):
    """A rectangle with a pocket that is wider than its mouth: robots inside can hold it by pushing apart."""
    (left, mouth, _, right), (floor, ceiling) = sorted(rng.sample(range(1, 20), 4)), sorted(rng.sample(range(1, 12), 2))
    pocket = [(mouth + 1, ceiling), (right, ceiling), (right, floor), (left, floor), (left, ceiling), (mouth, ceiling)]
    return [(0, 0), (20, 0), (20, 12), (mouth + 1, 12), *pocket, (mouth, 12), (0, 12)]


def random_polygon(rng, shapes=(convex_polygon, star_polygon, steps_polygon, pocket_polygon)):
    """Eighths of edges are integers before it is moved and scaled by a power of two."""
    ring = rng.choice(shapes)(rng)
    ring = [(8 * x, 8 * y) for x, y in ring]
    if rng.random() < 0.4:  # straight vertices
        ring = [p for a, b in edges_of(ring) for p in ([a, along(a, b, Fraction(rng.randint(1, 7), 8))] if rng.random() < 0.4 else [a])]
    if rng.random() < 0.5:
        ring = ring[::-1]
    start = rng.randrange(len(ring))
    scale = Fraction(2) ** rng.choice([0, 0, 0, 0, -3, -12, 5])
    move = (rng.randint(-300, 300), rng.randint(-300, 300)) if rng.random() < 0.5 else (0, 0)
    return Polygon([((x + move[0]) * scale, (y + move[1]) * scale) for x, y in ring[start:] + ring[:start]])


def grid_point(rng, polygon, parts=1024):
    """A point of a fine grid over the box of the polygon, whose coordinates are doubles."""
    box = [(min(v[k] for v in polygon.vertices), max(v[k] for v in polygon.vertices)) for k in (0, 1)]
    return tuple(low + (high - low) * Fraction(rng.randint(0, parts), parts) for low, high in box)


def as_doubles(p):
    return tuple(Fraction(float(x)) for x in p)


def beside(polygon, edge, p, way):
    """The point moved inward from the edge by this distance, rounded."""
    n = polygon.inward(edge)
    length = math.sqrt(dot(n, n))
    return as_doubles(p[k] + Fraction(way) * n[k] / Fraction(length) for k in (0, 1))


def support(rng, polygon, kind):
    edge = rng.randrange(len(polygon.edges))
    a, b = polygon.edges[edge]
    on_edge = along(a, b, Fraction(rng.randint(1, 7), 8))
    size, snap = polygon.size, 1e-4 * polygon.size
    if kind == "vertex":
        return a
    if kind == "edge":
        return on_edge
    if kind == "inside":
        for _ in range(100):  # a sliver has few of these points
            p = grid_point(rng, polygon)
            if polygon.contains(p) and min(distance(p, nearest_on_segment(p, *e)) for e in polygon.edges) > 10 * snap:
                return p
        raise Ambiguous
    if kind == "beside":
        return beside(polygon, edge, on_edge, 1e-3 * size)
    if kind == "hair":
        return beside(polygon, edge, on_edge, rng.choice([1e-9, -1e-9, 0.7e-4, -0.7e-4, 1.5e-4, 6e-4]) * size)
    if kind == "at vertex":
        return as_doubles(x + Fraction(rng.uniform(-1, 1) * 1e-10 * size) for x in a)
    if kind == "near vertex":
        part = rng.choice([2e-8, 1e-7, 4e-7]) * size / distance(a, b)
        return beside(polygon, edge, along(a, b, Fraction(part)), rng.choice([0, 1e-8]) * size)
    # As near to one edge as to the other if they follow the axes.
    return as_doubles(x + rng.choice([1, -1]) * Fraction(2e-7 * size) for x in a)


KINDS = ["vertex", "edge", "edge", "edge", "inside", "beside", "hair", "at vertex", "near vertex", "corner"]


def random_centre(rng, polygon):
    """None for the centroid, or a point strictly inside the convex hull."""
    if rng.random() < 0.5:
        return None
    for _ in range(100):
        p = grid_point(rng, polygon, 64)
        if strictly_inside_hull(p, polygon.hull):
            return p
    raise Ambiguous


def options_of(centre, weight=None):
    return [*([] if centre is None else ["--com", pairs_of([centre])[0]]), *([] if weight is None else ["--weight", decimal(weight)])]


# Checks of one result.


def check_basics(polygon, supports, places, centre, result):
    expect(result["metric"] == "given", "metric")
    expect(result["supports"] == [[float(x), float(y)] for x, y in supports], "supports are not as asked for")
    expect(len(result["teams"]) == 1 and len(result["robots"]) == len(supports), "not one team of all robots")
    got = tuple(Fraction(x) for x in result["centre_of_mass"])
    off = distance(got, centre or polygon.centroid())
    expect(off <= (0 if centre else 1e-12 * polygon.size), f"centre of mass {result['centre_of_mass']}")
    for i, (robot, place) in enumerate(zip(result["robots"], places)):
        expect(robot["place"] == place.kind, f"robots[{i}].place is {robot['place']}, not {place.kind}")
        off = distance(tuple(map(Fraction, robot["at"])), place.point)
        expect(off <= 1e-12 * polygon.size, f"robots[{i}].at is {robot['at']}, {off:g} from {tuple(map(float, place.point))}")
    return got


def check_standing(polygon, points, centre, result):
    """Returns whether it stands."""
    right, size = standing_of(polygon, points, centre), polygon.size
    expect(result["stands"] is right.stands, f"stands is {result['stands']}")
    on_edge = right.stands and right.margin <= TAU * size  # C counts as on the line
    expect_near(result["robustness"]["com_margin"], right.margin, (TAU if on_edge else 1e-11) * size, "com_margin")
    over = result.get("tips_over")
    if right.stands:
        expect(over is None, f"tips_over is {over}, though it stands")
        return True
    expect(result["loads"] is None, "loads, though it falls")
    expect(all(robot["load"] is None for robot in result["robots"]), "a robot has a load, though it falls")
    expect(all(load is None for load in result["teams"][0]["loads"]), "a team has loads, though it falls")
    expect(result["verdict"]["kind"] == "bad", f"verdict {result['verdict']['kind']}, though it falls")
    expect(isinstance(over, list) and all(isinstance(i, int) and 0 <= i < len(points) for i in over), f"tips_over is {over}")
    told = [points[i] for i in over]
    expect(tips_over(polygon, points, centre, right.beyond, told), f"tips_over is {over}")
    return False


def carried_centre(polygon, points, centre):
    """C, moved into the lifting base if only rounding puts it outside."""
    inside = nearest_in_hull(centre, convex_hull(points))
    if distance(inside, centre) > 1e-14 * polygon.size:
        raise Ambiguous
    return inside


def check_loads(polygon, points, centre, weight, result):
    """Returns the exact loads by springs."""
    centre, tolerance = carried_centre(polygon, points, centre), LOADS * float(weight)
    right = springs_of(points, centre, weight)
    if sum(right) != weight or any(sum(f * (p[k] - centre[k]) for f, p in zip(right, points)) != 0 for k in (0, 1)):
        raise AssertionError("the loads of the oracle are not in balance")
    loads = result["loads"]
    for i, f in enumerate(right):
        expect_near(loads["models"]["springs"][i], f, tolerance, f"loads.models.springs[{i}]")
        expect_near(result["robots"][i]["load"], f, tolerance, f"robots[{i}].load")
        expect_near(result["teams"][0]["loads"][i], f, tolerance, f"teams[0].loads[{i}]")
    shown = {"min": min(right), "max": max(right), "mean": weight / len(right), "spread": max(right) - min(right)}
    for name, value in shown.items():
        expect_near(loads[name], value, 2 * tolerance, f"loads.{name}")
    expect_near(loads["max_share"], max(right) / weight, 2 * LOADS, "loads.max_share")
    if len(points) <= 12:  # O(m^3)
        expect_near(loads["models"]["best"], best_of(points, centre, weight), tolerance, "loads.models.best")
    for i, f in enumerate(worst_of(points, centre, weight)):
        expect_near(loads["models"]["worst"][i], f, tolerance, f"loads.models.worst[{i}]")
    return right


def check_base(polygon, points, result):
    """Returns the exact coverage."""
    hull, got = convex_hull(points), [tuple(map(Fraction, p)) for p in result["hull"]]
    for corners, others, whose in ((hull, got, "the definition's"), (got, hull, "the program's")):
        for p in corners:
            off = min(distance(p, nearest_on_segment(p, a, b)) for a, b in edges_of(others))
            expect(off <= TAU * polygon.size, f"hull: {whose} corner {tuple(map(float, p))} is {off:g} off")
    coverage = coverage_of(polygon, hull)
    expect_near(result["coverage"], coverage, 1e-9, "coverage")
    return coverage


def check_closure(polygon, places, centre, result):
    contacts = [contact for place in places for contact in contacts_of(polygon, place)]
    right, got = closure_of(polygon, contacts, centre), result["closure"]
    expect(set(got["free"]) == right.free, f"closure.free is {got['free']}, not {sorted(right.free)}")
    expect(got["form_closure"] is right.closed, f"closure.form_closure is {got['form_closure']}")
    expect(got["second_order"] is right.second_order, f"closure.second_order is {got['second_order']}")
    if not contacts:
        expect(got["margin"] is None, f"closure.margin is {got['margin']} without contacts")
    elif right.closed:
        expect_near(got["margin"], margin_of(polygon, contacts, centre), 1e-8, "closure.margin")
    else:
        expect(got["margin"] <= TAU, f"closure.margin is {got['margin']} without form closure")
    return right


Checked = collections.namedtuple("Checked", "stands loads coverage closure")


def check_result(polygon, supports, places, centre, weight, result, capacities=None):
    centre = check_basics(polygon, supports, places, centre, result)
    points = [place.point for place in places]
    stands = check_standing(polygon, points, centre, result)
    loads = check_loads(polygon, points, centre, weight, result) if stands else None
    expect(result.get("support_capacities") == capacities, f"support_capacities is {result.get('support_capacities')}")
    if capacities:
        over = [i for i, k in enumerate(capacities) if stands and k is not None and loads[i] > k]
        expect(result["capacity"]["overloaded"] == over, f"capacity.overloaded is {result['capacity']['overloaded']}, not {over}")
    return Checked(stands, loads, check_base(polygon, points, result), check_closure(polygon, places, centre, result))


# Kinds of cases. Each draws a case, and returns its run and a function that checks the answer and names the case.


def placed_case(polygon, supports, snap, centre, weight, more=()):
    """The places of supports, none outside; checks first that no decision is near."""
    places = [place_of(polygon, p, snap) for p in supports]
    if any(place.kind == "outside" for place in places):
        raise Ambiguous
    points, exact = [place.point for place in places], centre or as_doubles(polygon.centroid())
    if standing_of(polygon, points, exact).stands:
        springs_of(points, carried_centre(polygon, points, exact), weight)
    closure_of(polygon, [contact for place in places for contact in contacts_of(polygon, place)], exact)
    return places, [*options_of(centre, weight), *more, "--json"]


def names_of(polygon, places, checked):
    yield "stands" if checked.stands else "falls"
    if checked.stands and min(checked.loads) == 0:
        yield "a robot is slack"
    yield "form closure" if checked.closure.closed else "second order" if checked.closure.second_order else "not held"
    for place in places:
        if place.vertex is not None:
            turn = polygon.turn_at(place.vertex)
            yield f"robots at {'convex' if turn > 0 else 'straight' if turn == 0 else 'reflex'} vertices"
        else:
            yield "robots beneath" if place.kind == "beneath" else "robots inside edges"


def normals_through(rng, polygon, apart=False):
    """Supports on edges whose normals all pass through one point, where only the second order can decide."""
    c, found = grid_point(rng, polygon, 64), []
    for a, b in polygon.edges:
        t = dot(minus(c, a), minus(b, a)) / dot(minus(b, a), minus(b, a))
        if 0 < t < 1 and as_doubles(along(a, b, t)) == along(a, b, t):
            outward = dot(polygon.inward(polygon.edges.index((a, b))), minus(c, a)) < 0
            if outward or not apart:
                found.append(along(a, b, t))
    return rng.sample(found, rng.randint(3, len(found))) if len(found) > 2 else None


def any_supports(rng, program):
    """Supports of all kinds on any polygon, or on edges alone, which hold the object more often."""
    polygon, weight = random_polygon(rng), Fraction(rng.choice([100, 100, 1, 7250]))
    centre = random_centre(rng, polygon)
    kinds = rng.choice([KINDS, ["edge"], ["vertex", "edge"], ["edge", "hair", "corner"]])
    count = rng.choice([1, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 9, 12, 24])
    supports = [support(rng, polygon, rng.choice(kinds)) for _ in range(count)]
    if rng.random() < 0.1:
        supports.append(rng.choice(supports))
    if rng.random() < 0.2:
        supports = normals_through(rng, polygon) or supports
    snap, more, capacities = 1e-4 * polygon.size, [], None
    if rng.random() < 0.15:
        snap = float(Fraction(polygon.size / 300))
        more = ["--snap", repr(snap)]
    if rng.random() < 0.15:
        capacities = [rng.choice([None, round(float(weight) * rng.uniform(0.05, 0.6), 3)]) for _ in supports]
        capacities = capacities if any(capacities) else None
    places, options = placed_case(polygon, supports, snap, centre, weight, more)

    def check(answer):
        expect(answer.status == 0, f"exit status {answer.status}: {answer.error}")
        return names_of(polygon, places, check_result(polygon, supports, places, centre, weight, answer.result, capacities))

    return Run(program, polygon, supports, *options, capacities=capacities), check


def deciding_vertex(rng, program):
    """A support at a convex, straight or reflex vertex, where another number of contacts would give another closure."""
    polygon = random_polygon(rng)
    centre = random_centre(rng, polygon)
    exact, turn = centre or as_doubles(polygon.centroid()), rng.choice([1, 0, -1, -1, -1])
    vertices = [i for i in range(len(polygon.vertices)) if (polygon.turn_at(i) > 0) - (polygon.turn_at(i) < 0) == turn]
    if not vertices:
        raise Ambiguous
    vertex = rng.choice(vertices)
    before = vertex - 1 if vertex else len(polygon.vertices) - 1
    both = [(polygon.vertices[vertex], polygon.inward(edge)) for edge in (before, vertex)]
    right, rest = both[: 0 if turn > 0 else 1 if turn == 0 else 2], []
    for _ in range(rng.randint(1 if turn < 0 else 2, 4)):
        edge = rng.randrange(len(polygon.edges))
        rest.append((along(*polygon.edges[edge], Fraction(rng.randint(1, 7), 8)), polygon.inward(edge)))
    wrong = [touch for touch in ([], both[:1], both[1:], both) if touch != right and (turn != 0 or not touch)]
    if any(closure_of(polygon, touch + rest, exact) == closure_of(polygon, right + rest, exact) for touch in wrong):
        raise Ambiguous
    supports = [polygon.vertices[vertex], *(p for p, _ in rest)]
    places, options = placed_case(polygon, supports, 1e-4 * polygon.size, centre, Fraction(100))

    def check(answer):
        expect(answer.status == 0, f"exit status {answer.status}: {answer.error}")
        check_result(polygon, supports, places, centre, Fraction(100), answer.result)
        return ["convex" if turn > 0 else "straight" if turn == 0 else "reflex"]

    return Run(program, polygon, supports, *options), check


def second_order(rng, program):
    """Normals that all pass through one point: the second order decides, perhaps with one more contact."""
    apart = rng.random() < 0.4  # a pocket's robots push apart, which a turn makes easier
    polygon = random_polygon(rng, (pocket_polygon,)) if apart else random_polygon(rng)
    centre, supports = random_centre(rng, polygon), normals_through(rng, polygon, apart)
    if supports is None:
        raise Ambiguous
    if rng.random() < 0.3:
        supports.append(support(rng, polygon, "edge"))
    places, options = placed_case(polygon, supports, 1e-4 * polygon.size, centre, Fraction(100))
    contacts = [contact for place in places for contact in contacts_of(polygon, place)]
    if translation_is_free(contacts):
        raise Ambiguous

    def check(answer):
        expect(answer.status == 0, f"exit status {answer.status}: {answer.error}")
        closure = check_result(polygon, supports, places, centre, Fraction(100), answer.result).closure
        return ["form closure" if closure.closed else "held" if closure.second_order else "not held"]

    return Run(program, polygon, supports, *options), check


def line_through_centre(rng, program):
    """Robots on one line, perhaps at one place: C on the line between them or beyond them, or beside the line."""
    polygon = random_polygon(rng)
    unit = Fraction(2) ** math.floor(math.log2(polygon.size / 64))
    direction = (rng.randint(-3, 3) * unit, rng.randint(1, 3) * unit)
    centre = grid_point(rng, polygon, 64)
    if not strictly_inside_hull(centre, polygon.hull):
        raise Ambiguous
    origin = centre if rng.random() < 0.7 else (centre[0] + unit, centre[1])
    reach = rng.choice([range(-8, 9), range(1, 9), range(2, 3), range(0, 1)])
    on_line = [along(origin, (origin[0] + direction[0], origin[1] + direction[1]), Fraction(k)) for k in reach]
    on_line = [p for p in on_line if place_of(polygon, p, 1e-4 * polygon.size).kind != "outside"]
    if not on_line:
        raise Ambiguous
    supports = [rng.choice(on_line) for _ in range(rng.randint(1, 5))]
    places, options = placed_case(polygon, supports, 1e-4 * polygon.size, centre, Fraction(100))

    def check(answer):
        expect(answer.status == 0, f"exit status {answer.status}: {answer.error}")
        checked = check_result(polygon, supports, places, centre, Fraction(100), answer.result)
        if checked.stands:
            return ["stands"]
        return ["falls over one robot" if len(answer.result["tips_over"]) == 1 else "falls over two robots"]

    return Run(program, polygon, supports, *options), check


def edge_through_centre(rng, program):
    """C on an edge of the lifting base: exactly, or 1e-10 or 1e-7 of the size inside or outside."""
    polygon = random_polygon(rng)
    a, b, c = (support(rng, polygon, rng.choice(["edge", "vertex", "inside"])) for _ in range(3))
    longest = max(distance(a, b), distance(b, c), distance(c, a))
    if abs(cross(minus(b, a), minus(c, a))) <= longest * polygon.size / 64:  # too flat
        raise Ambiguous
    middle, off = along(a, b, Fraction(1, 2)), rng.choice([0, 1e-10, 1e-7])
    way = Fraction(rng.choice([1, -1]) * off * polygon.size / distance(middle, c))
    centre = as_doubles(along(middle, c, way))
    if not strictly_inside_hull(centre, polygon.hull):
        raise Ambiguous
    supports, snap = [a, b, c], 1e-4 * polygon.size
    places = [place_of(polygon, p, snap) for p in supports]
    points = [place.point for place in places]
    closure_of(polygon, [contact for place in places for contact in contacts_of(polygon, place)], centre)

    def check(answer):
        expect(answer.status == 0, f"exit status {answer.status}: {answer.error}")
        exact = check_basics(polygon, supports, places, centre, answer.result)
        stands = check_standing(polygon, points, exact, answer.result)
        if stands:  # the loads of the lifting base's nearest point, to the tolerance of C
            right = springs_of(points, nearest_in_hull(exact, convex_hull(points)), Fraction(100))
            for i, f in enumerate(right):
                expect_near(answer.result["robots"][i]["load"], f, 1e-9 * 100 if off == 0 else 1e-4, f"robots[{i}].load")
        check_closure(polygon, places, exact, answer.result)
        return [f"C is {off:g} off, {'stands' if stands else 'falls'}"]

    return Run(program, polygon, supports, *options_of(centre), "--json"), check


def outside_support(rng, program):
    """One support is outside by more than the snap distance, barely or clearly."""
    polygon = random_polygon(rng)
    supports = [support(rng, polygon, rng.choice(["edge", "vertex", "inside"])) for _ in range(rng.randint(0, 5))]
    edge = rng.randrange(len(polygon.edges))
    way = rng.choice([1.2e-6, 1e-5, 1e-3, 0.1, 2]) * polygon.size
    p = beside(polygon, edge, along(*polygon.edges[edge], Fraction(rng.randint(0, 8), 8)), -way)
    at = rng.randint(0, len(supports))
    supports.insert(at, p)
    place = place_of(polygon, p, 1e-4 * polygon.size)
    if place.kind != "outside":
        raise Ambiguous

    def check(answer):
        expect(answer.status == 2, f"exit status {answer.status}, though supports[{at}] is outside")
        told = re.search(r"--supports: robot (\d+): \((\S+), (\S+)\) is (\S+) outside the object(?:; --snap \S+ puts it at the edge)?(?:; \(\S+, \S+\) would be inside: y points up here)?\n$", answer.error)
        expect(told is not None, f"the sentence is {answer.error!r}")
        expect(int(told[1]) == at + 1, f"it names robot {told[1]}, not robot {at + 1}")
        for k in (0, 1):
            expect_near(float(told[k + 2].replace("−", "-")), p[k], 1e-2 * polygon.size, "a coordinate in the sentence")
        expect_near(float(told[4]), place.edge, 0.06 * place.edge, "the distance in the sentence")
        return ["refused"]

    return Run(program, polygon, supports, "--json"), check


def evened_out(rng, program, hard=False):
    """The set with equal loads that is nearest."""
    polygon = random_polygon(rng)
    centre = random_centre(rng, polygon)
    exact, count = centre or as_doubles(polygon.centroid()), rng.choice([2, 3, 3, 4, 4, 5, 6])
    supports = [support(rng, polygon, rng.choice(["edge", "edge", "vertex", "inside"])) for _ in range(count)]
    chords = even_chords(polygon.edges, polygon.vertices, exact) if rng.random() < 0.15 else []
    if chords:  # already even
        supports = [as_doubles(p) for chord in rng.sample(chords, rng.randint(1, min(3, len(chords)))) for p in chord]
        count = len(supports)
    points = [place_of(polygon, p, 1e-4 * polygon.size).point for p in supports]
    middles = [middle_of(points, exact, pair) for pair in itertools.combinations(range(count), 2)]
    if hard and any(strictly_inside_hull(middle, polygon.hull) for middle in middles):
        raise Ambiguous
    if count > 2 and not (strictly_inside_hull(exact, convex_hull(points)) and standing_of(polygon, points, exact).stands):
        raise Ambiguous

    def check(answer):
        size = polygon.size
        found = exact if answer.result is None else tuple(map(Fraction, answer.result["centre_of_mass"]))
        pair = nearest_pair_move(polygon, points, found)
        if answer.status == 2:
            expect(pair is None and answer.error.startswith("evenlift: --even-out: "), f"{answer.error!r}, but two robots can move")
            expect(nearest_triple_move(polygon, points, found) is None, f"{answer.error!r}, but three robots can move")
            return ["none in reach"]
        result, weight = answer.result, 100
        expect(answer.status == 0, f"exit status {answer.status}")
        moved = [tuple(map(Fraction, robot["at"])) for robot in result["robots"]]
        for i, load in enumerate(result["loads"]["models"]["springs"]):
            expect_near(load, weight / count, LOADS * weight, f"loads.models.springs[{i}]")
            expect_near(result["robots"][i]["load"], weight / count, LOADS * weight, f"robots[{i}].load")
        centroid = tuple(sum(p[k] for p in moved) / count for k in (0, 1))
        expect(distance(centroid, found) <= 1e-11 * size, f"the centroid is {tuple(map(float, centroid))}")
        changed = [i for i in range(count) if distance(moved[i], points[i]) > 1e-11 * size]
        for i in changed:
            off = min(distance(moved[i], nearest_on_segment(moved[i], *edge)) for edge in polygon.edges)
            expect(result["robots"][i]["place"] == "edge" and off <= 1e-11 * size, f"robots[{i}] moved, and is {off:g} from the outline")
        way = float(sum(dot(minus(p, q), minus(p, q)) for p, q in zip(moved, points)))
        if pair is not None:
            expect(len(changed) <= 2, f"robots {changed} moved, though two are enough")
            expect_near(way, pair, 1e-9 * size * size, "the sum of squared ways")
            return ["two moved" if changed else "already even"]
        expect(len(changed) <= 3, f"robots {changed} moved")
        triple = nearest_triple_move(polygon, points, found)
        expect(triple is None or way <= triple + 1e-9 * size * size, f"the sum of squared ways is {way}, where {triple} is possible")
        trial = trial_points(polygon, found)
        expect(any(distance(moved[i], b) <= 1e-9 * size for i in changed for b in trial), "none of the three is on a trial point")
        return ["three moved"]

    return Run(program, polygon, supports, *options_of(centre), "--even-out", "--json"), check


def evened_out_by_three(rng, program):
    """Sets where no two robots can move, since no middle is inside the object."""
    return evened_out(rng, program, hard=True)


BAD_CONDITIONS = ["foo", "coverage", "coverage=0.8", "held>=1", "max<=", "max<=abc", "robots<=4,,held", "stands;", "max<20", "<=3",
                  "max<=nan"]  # fmt: skip
WORDS = ["held", "stands", "steady", "coverage", "max", "min", "spread", "margin", "robots", "tip"]


def is_held_clear_of_corners(polygon, places, centre):
    """Whether the contacts hold the object that are farther than 0.02 R from every convex vertex."""
    clear, contacts = 0.0201 * max(distance(v, centre) for v in polygon.vertices), []
    for place in places:
        ends = () if place.edge is None else (place.edge, (place.edge + 1) % len(polygon.vertices))
        if all(polygon.turn_at(i) <= 0 or distance(polygon.vertices[i], place.point) > clear for i in ends):
            contacts += contacts_of(polygon, place)
    closure = closure_of(polygon, contacts, centre)
    return closure.closed or closure.second_order


def required(rng, program):
    """Conditions with --require; one word in ten is bad."""
    polygon, weight = random_polygon(rng), Fraction(100)
    centre = random_centre(rng, polygon)
    kinds = rng.choice([["edge"], ["vertex", "edge", "inside"], ["edge", "edge", "hair"]])
    supports = [support(rng, polygon, rng.choice(kinds)) for _ in range(rng.randint(2, 8))]
    places, options = placed_case(polygon, supports, 1e-4 * polygon.size, centre, weight)
    points, exact = [place.point for place in places], centre or as_doubles(polygon.centroid())
    right, loads = standing_of(polygon, points, exact), None
    if not right.stands and rng.random() < 0.7:  # most sets stand
        raise Ambiguous
    if right.stands:
        loads = springs_of(points, carried_centre(polygon, points, exact), weight)
    contacts = [contact for place in places for contact in contacts_of(polygon, place)]
    closure = closure_of(polygon, contacts, exact)
    values = {"coverage": coverage_of(polygon, convex_hull(points)), "robots": len(points)}
    least, greatest = (min(loads), max(loads)) if loads else (None, None)
    values.update({"max": greatest, "min": least, "spread": greatest - least if loads else None})
    if closure.closed:
        values["margin"] = margin_of(polygon, contacts, exact)
    yes = {"stands": right.stands}
    if not (closure.closed or closure.second_order):
        yes["held"] = False
    elif is_held_clear_of_corners(polygon, places, exact):  # the definition leaves open whether a hold beside a corner
                                                            # is held
        yes["held"] = True
    rest = [nearest_in_hull(exact, convex_hull(points[:i] + points[i + 1 :])) == exact for i in range(len(points))]
    lines = [abs(distance_to_line(exact, p, q)) for p, q in itertools.combinations(points, 2) if p != q]
    if min(lines, default=0) > 0.05 * max(distance(v, exact) for v in polygon.vertices):  # C is far from any lifting
                                                                                          # base's edges
        yes["steady"] = all(rest)
    conditions, answers = [], []
    for word in rng.sample(sorted({*values, *yes}), rng.randint(1, min(4, len(values) + len(yes)))):
        if word in yes:
            conditions.append(word)
            answers.append((yes[word], yes[word]))
            continue
        sign, value = rng.choice(["<=", ">="]), values[word]
        upper = rng.random() < (0.8 if sign == "<=" else 0.2)  # most conditions are kept
        if word == "robots":
            bound = len(points) + rng.choice([0, 1 if upper else -1])
        else:
            bound = round(float(value or 0) * rng.choice([1.1, 2] if upper else [0.5, 0.9]) + (0.01 if upper else -0.01), 4)
        if value is not None and word != "robots" and abs(bound - value) < 1e-6:
            raise Ambiguous
        conditions.append(f"{word}{sign}{bound}")
        answers.append((value, value is not None and (value <= bound if sign == "<=" else value >= bound)))
    bad = rng.choice(BAD_CONDITIONS) if rng.random() < 0.2 else None
    if bad:
        conditions.insert(rng.randint(0, len(conditions)), bad)

    def check(answer):
        if bad:
            expect(answer.status == 2, f"exit status {answer.status}, though {bad!r} is bad")
            expect("--require" in answer.error, f"the error does not name the option: {answer.error!r}")
            for word in WORDS[:-1]:  # tilt.md adds the last one
                expect(word in answer.error, f"the error does not list {word}: {answer.error!r}")
            return ["a bad word"]
        kept = all(each for _, each in answers)
        expect(answer.status == (0 if kept else 3), f"exit status {answer.status}, though the conditions are {'' if kept else 'not '}kept")
        told = answer.result["requirements"]
        expect([each["condition"] for each in told] == conditions, f"the conditions are {told}")
        for each, (value, good) in zip(told, answers):
            expect(each["kept"] is good, f"{each['condition']} is {'' if each['kept'] else 'not '}kept")
            if value is None or isinstance(value, bool):
                expect(each["value"] is value, f"{each['condition']} has the value {each['value']}")
            else:
                expect_near(each["value"], value, 1e-7, each["condition"])
        return ["kept" if kept else "not kept"]

    return Run(program, polygon, supports, *options, "--require", ", ".join(conditions)), check


# The examples of the definition.


def examples(program):
    square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    half, quarter = Fraction(1, 2), Fraction(1, 4)
    corners = square.vertices

    def example(supports, checks, *options):
        return Run(program, square, supports, "--json", *options), checks

    def four_corners(r):
        expect_loads(r, [25, 25, 25, 25])
        for f in r["loads"]["models"]["worst"]:
            expect_near(f, 50, 1e-7, "worst")
        expect_near(r["coverage"], 1, 1e-9, "coverage")
        expect(r["closure"]["margin"] is None and set(r["closure"]["free"]) == set(MOTIONS), "contacts at corners")

    def expect_loads(r, loads):
        for i, f in enumerate(loads):
            expect_near(r["robots"][i]["load"], f, 1e-7, f"robots[{i}].load")

    def three(r):
        expect_loads(r, [25, 25, 50])
        expect_near(r["coverage"], 0.5, 1e-9, "coverage")

    def five(r):
        expect_loads(r, [20, 20, 20, 20, 20])
        expect([robot["place"] for robot in r["robots"]] == ["edge"] * 4 + ["beneath"], "places")

    def falling(r):
        expect(r["stands"] is False and r["loads"] is None, "stands")
        expect_near(r["robustness"]["com_margin"], -0.6 / math.sqrt(2), 1e-12, "com_margin")
        expect(sorted(r["tips_over"]) == [1, 2], f"tips_over {r['tips_over']}")

    def segment(r):
        expect_loads(r, [100 / 3] * 3)
        expect(r["stands"] is True and r["robustness"]["com_margin"] == 0 and r["coverage"] == 0, "a segment")
        expect(r["requirements"] == [{"condition": "steady", "value": False, "kept": False}], f"requirements {r['requirements']}")

    def middles(r):
        expect_loads(r, [25, 25, 25, 25])
        expect_near(r["coverage"], 0.5, 1e-9, "coverage")
        expect(r["closure"]["form_closure"] is False and set(r["closure"]["free"]) == {"clockwise", "counterclockwise"}, "closure")
        expect(r["closure"]["second_order"] is True, "second order")

    yield example(corners, four_corners)
    yield example([(0, 0), (1, 0), (half, Fraction(1))], three)
    yield example([*corners, (half, half)], five)
    yield example([(Fraction(0), Fraction(0)), (Fraction(0.4), Fraction(0)), (Fraction(0), Fraction(0.4))], falling)
    yield example([(quarter, Fraction(0)), (1 - quarter, Fraction(1)), (half, half)], segment, "--require", "steady")
    yield example([(half, Fraction(0)), (Fraction(1), half), (half, Fraction(1)), (Fraction(0), half)], middles)


# Everything together.

SHARES = [(any_supports, 42), (deciding_vertex, 10), (second_order, 6), (line_through_centre, 9), (edge_through_centre, 5),
          (outside_support, 7), (evened_out, 10), (evened_out_by_three, 2), (required, 9)]  # fmt: skip


def disagreement(run, check):
    """The sentence of a disagreement, or None, and the names of what was checked."""
    try:
        return None, list(check(run.answer()) or [])
    except Disagreement as problem:
        return str(problem), []
    except (KeyError, TypeError, IndexError) as problem:
        return f"the result has another form: {problem!r}", []


def drawn(kind, seed, index, program):
    rng = random.Random(f"{kind.__name__} {seed} {index}")
    for _ in range(20000):
        try:
            return kind(rng, program)
        except Ambiguous:
            continue
    raise AssertionError(f"no case of {kind.__name__}")


def check_all(description, examples, shares, usual_cases):
    """Reads the options, and checks the examples and a number of cases of each kind by its share in per cent."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=usual_cases)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    begin, problems = time.monotonic(), []

    count = 0
    for run, check in examples(asked.program):
        def of_result(answer, check=check):
            expect(answer.result is not None, answer.error)
            check(answer.result)

        problem, _ = disagreement(run, of_result)
        count += 1
        if problem:
            problems.append((problem, run))
    print(f"examples: {count}")

    for kind, share in shares:
        cases, names = max(1, round(asked.cases * share / 100)), collections.Counter()
        for index in range(cases):
            run, check = drawn(kind, asked.seed, index, asked.program)
            try:
                problem, found = disagreement(run, check)
            except Ambiguous:  # the program's C and the rounded centroid decide differently
                names["too near to decide"] += 1
                continue
            names.update(found)
            if problem:
                problems.append((f"{kind.__name__} {index}: {problem}", run))
        told = ", ".join(f"{n} {name}" for name, n in sorted(names.items()))
        print(f"{kind.__name__.replace('_', ' ')}: {cases} ({told})")

    for problem, run in problems[:20]:
        print(f"\n{problem}\n    {run}", file=sys.stderr)
    print(f"{time.monotonic() - begin:.1f} s, seed {asked.seed}")
    if problems:
        sys.exit(f"{len(problems)} disagreements")


if __name__ == "__main__":
    check_all(__doc__, examples, SHARES, 300)
