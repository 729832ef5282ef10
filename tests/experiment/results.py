"""Reads the folder of an experiment, and recomputes all its statements in Python."""

import collections
import csv
import json
import math
import pathlib
import re
import statistics

PAIRS = ["area", "circle", "distance", "distributed", "random"]
METHODS = [*PAIRS, "balanced"]
ALGORITHM = PAIRS[:3]
FILES = ["measurements.csv", "aggregates.csv", "polygons.csv", "thesis.md", "robots.md", "report.html"]


def contents(folder):
    """The files that must not differ between runs, byte for byte."""
    return {name: (pathlib.Path(folder) / name).read_bytes() for name in FILES}


def table(folder, name):
    with open(pathlib.Path(folder) / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def measurements(folder, of):
    """The rows of one set."""
    rows = []
    for row in table(folder, "measurements.csv"):
        if row["set"] != of:
            continue
        for name in ("teams", "robots", "samples"):
            row[name] = int(row[name])
        for name in ("coverage", "form_closure", "no_area", "held_clear", "load_min", "load_mean", "load_max", "spread", "max_share"):
            row[name] = float(row[name])
        rows.append(row)
    return rows


def figures(folder, of):
    html = (pathlib.Path(folder) / "report.html").read_text(encoding="utf-8")
    made = json.loads(re.search(r'<script type="application/json" id="figures">(.*?)</script>', html, re.S).group(1))
    return [figure for figure in made if figure["set"] == of]


def claims(folder, of):
    """Our values for a set by their meaning, from the table in thesis.md."""
    head, _, *lines = [[cell.strip() for cell in line.strip("|").split("|")]
                       for line in (pathlib.Path(folder) / "thesis.md").read_text(encoding="utf-8").splitlines()]
    return {cells[1]: cells[head.index(of)] for cells in lines}


def few_robots(folder, of):
    """The cells of a set by measure, number of robots and method, from the tables in robots.md."""
    cells = {}
    for lines in (pathlib.Path(folder) / "robots.md").read_text(encoding="utf-8").split("\n\n"):
        head, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines.strip().splitlines()]
        if head[0] == of:
            cells.update({(what, int(robots), method): cell for what, robots, *row in rows for method, cell in zip(head[2:], row)})
    return cells


# The rows of thesis.md that docs/experiments.md gives: where the thesis states a number, and what its conclusions rest on.
SMALL, ITS_TEST = ", polygons with at most 12 vertices", ", by the thesis’s test that no region has an area"
MANUAL_CLAIMS = [
    *(f"Spread of loads with {robots} robots, {method}" for robots, method in [(4, "distance"), (4, "distributed"), (30, "area"), (30, "random")]),
    *(f"Shares of the team’s load with 10 teams, {method}" for method in ("area", "distributed")),
    *(f"Fewest robots with a greatest load of at most 5 kg of 100 kg, averaged over the polygons, {method}" for method in ("area", "distributed")),
    *(f"Spread of loads of {method} in multiples of the algorithm’s, {where}"
      for method in ("distributed", "random") for where in ("over the numbers of robots shown", "with 4 robots")),
    "All three metrics choose the same second team",
    f"The same second team{SMALL}",
    *(f"The same third team, where the second is the same{which}" for which in ("", SMALL)),
    *(f"Coverage by the algorithm: {how}" for how in ("with 36 robots", "mean over all its measurements from 4 robots on")),
    "Coverage of distributed less coverage of the algorithm, mean over a polygon’s numbers of teams",
    "Coverage of the algorithm less coverage of random, mean over a polygon’s numbers of teams",
    "Coverage with 12 robots before and after the centre of mass is moved, worst case (figure 5.9)",
    *(f"{what}{ITS_TEST}" for what in (
        "Polygons that no method brings into form closure", "In form closure with 4 robots, distributed", "In form closure with 8 robots, distance",
        f"In form closure with 8 robots, distance{SMALL}", "Form closure lost by adding a team, distributed",
        "Polygons in form closure by the algorithm, of those in form closure by any method")),
]
MANUAL_ROBOTS = {3: ["balanced"], 5: ["balanced"], 7: ["balanced"], 12: ["balanced"],
                 **dict.fromkeys((4, 6, 8), ["area", "distributed", "random", "balanced"])}  # fmt: skip


def written(rows):
    """A table in Markdown."""
    return "".join(f"| {' | '.join(row)} |\n" for row in [rows[0], ["---"] * len(rows[0]), *rows[1:]])


def manual_tables(folder):
    """The tables of docs/experiments.md: rows of thesis.md and robots.md."""
    head, _, *lines = [line.strip("| ").split(" | ") for line in (pathlib.Path(folder) / "thesis.md").read_text(encoding="utf-8").splitlines()]
    rows = {row[1]: row for row in lines}
    claimed = [rows[what] for what in MANUAL_CLAIMS]
    tables = [written([head, *([section, what.replace(ITS_TEST, ", by its test"), *values] for section, what, *values in claimed)])]
    measures = ["coverage, %", "in form closure, %", "held with clearance, %", "spread of loads, kg of 100 kg", "number of polygons"]
    for of in head[3:]:
        cells = few_robots(folder, of)
        tables.append(written([[f"{of}: robots", "method", *measures],
                               *([str(robots), method, *(cells[what, robots, method] for what in measures)]
                                 for robots, methods in sorted(MANUAL_ROBOTS.items()) for method in methods)]))
    return tables


def readme_spreads(folder):
    """The spreads of loads that the README gives: of six robots at random places and in pairs by area, averaged over the samples."""
    means = {row["method"]: row for row in table(folder, "aggregates.csv") if (row["set"], row["robots"]) == ("polygons", "6")}
    return [f"{float(means[method]['spread_mean']):.1f} kg" for method in ("random", "area")]


class Recomputed:
    """Aggregates and claims from the rows of measurements.csv, by the standard library's own statistics."""

    def __init__(self, rows):
        self.rows = rows
        self.by = collections.defaultdict(list)
        self.at = {}
        for row in rows:
            self.by[row["method"], row["robots"]].append(row)
            self.at[row["polygon"], row["method"], row["robots"]] = row
        self.polygons = list(dict.fromkeys(row["polygon"] for row in rows))
        self.most = collections.Counter()  # robots in teams of two
        for row in rows:
            if row["method"] == "area":
                self.most[row["polygon"]] = max(self.most[row["polygon"]], row["robots"])
        # Where teams of two can have form closure; without balanced robots, which the thesis lacks.
        self.possible = {test: {row["polygon"] for row in rows if row["method"] in PAIRS and row[test] > 0} for test in ("form_closure", "no_area")}

    def aggregate(self, method, robots):
        rows = self.by[method, robots]
        made = {"polygons": len(rows), "closed_mean": math.fsum(row["form_closure"] for row in rows) / len(rows),
                "held_clear_mean": math.fsum(row["held_clear"] for row in rows) / len(rows)}
        for name in ("spread", "load_max", "max_share", "coverage"):
            values = [row[name] for row in rows]
            made[f"{name}_mean"] = math.fsum(values) / len(values)
            made[f"{name}_sd"] = statistics.stdev(values) if len(values) > 1 else None
        for test, count in (("form_closure", "closable"), ("no_area", "no_area_possible")):
            values = [row[test] for row in rows if row["polygon"] in self.possible[test]]
            made[count] = len(values)
            made[f"{test}_mean"] = math.fsum(values) / len(values) if values else None
        return made

    def shown(self, of="area"):
        return max(robots for (method, robots), rows in self.by.items()
                   if method == of and 5 * len(rows) >= len(self.by[of, 2]))

    def algorithm(self, column, robots):
        return sum(self.aggregate(method, robots)[column] for method in ALGORITHM) / 3

    def robots_needed(self, method, capacity=5):
        return min(robots for (m, robots), rows in self.by.items()
                   if m == method and math.fsum(row["load_max"] for row in rows) / len(rows) <= capacity)

    def times_more_even(self, method):
        ratios = []
        for robots in range(2, self.shown() + 1, 2):
            ours = self.algorithm("spread_mean", robots)
            if ours > 1e-9 * 100 / robots:  # else even except for rounding
                ratios.append(self.aggregate(method, robots)["spread_mean"] / ours)
        return min(ratios), max(ratios)

    def choices(self, polygon, teams):
        return {self.at[polygon, method, 2 * teams]["chosen"] for method in ALGORITHM}

    def same_second(self):
        able = [p for p in self.polygons if self.most[p] >= 4]
        return [p for p in able if len(self.choices(p, 2)) == 1], able

    def same_third(self):
        able = [p for p in self.same_second()[0] if self.most[p] >= 6]
        return [p for p in able if len(self.choices(p, 3)) == 1], able

    def coverage_difference(self, method):
        """By polygon: the method's value less the algorithm's, averaged over 2 and more teams."""
        differences = []
        for polygon in self.polygons:
            values = [self.at[polygon, method, robots]["coverage"]
                      - sum(self.at[polygon, m, robots]["coverage"] for m in ALGORITHM) / 3
                      for robots in range(4, self.most[polygon] + 1, 2) if (polygon, method, robots) in self.at]
            if values:
                differences.append(math.fsum(values) / len(values))
        return differences

    def lost(self, method, test):
        """The share of steps at which a polygon loses its form closure, of all steps that begin with it."""
        steps = [(before, after) for (polygon, m, robots), before in self.at.items() if m == method and before[test] > 0
                 for after in [self.at.get((polygon, method, robots + 2))] if after]
        return [after for before, after in steps if after[test] < before[test]], steps

    def closed_by_algorithm(self, test):
        return {row["polygon"] for row in self.rows if row["method"] in ALGORITHM and row[test] > 0}
