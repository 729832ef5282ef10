"""What an experiment's folder holds, read back, and all that is said of it worked out once more in Python."""

import collections
import csv
import json
import math
import pathlib
import re
import statistics

METHODS = ["area", "circle", "distance", "distributed", "random"]
ALGORITHM = METHODS[:3]
FILES = ["measurements.csv", "aggregates.csv", "polygons.csv", "thesis.md", "report.html"]


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
        for name in ("coverage", "form_closure", "no_area", "load_min", "load_mean", "load_max", "spread", "max_share"):
            row[name] = float(row[name])
        rows.append(row)
    return rows


def figures(folder, of):
    html = (pathlib.Path(folder) / "report.html").read_text(encoding="utf-8")
    made = json.loads(re.search(r'<script type="application/json" id="figures">(.*?)</script>', html, re.S).group(1))
    return [figure for figure in made if figure["set"] == of]


def claims(folder, of):
    """Our number of a set by what it is, from the table in thesis.md."""
    head, _, *lines = [[cell.strip() for cell in line.strip("|").split("|")]
                       for line in (pathlib.Path(folder) / "thesis.md").read_text(encoding="utf-8").splitlines()]
    return {cells[1]: cells[head.index(of)] for cells in lines}


class Recomputed:
    """Aggregates and claims from the rows of measurements.csv, by the standard library's own statistics."""

    def __init__(self, rows):
        self.rows = rows
        self.by = collections.defaultdict(list)
        self.at = {}
        for row in rows:
            self.by[row["method"], row["teams"]].append(row)
            self.at[row["polygon"], row["method"], row["teams"]] = row
        self.polygons = list(dict.fromkeys(row["polygon"] for row in rows))
        self.most = collections.Counter()
        for row in rows:
            if row["method"] == "area":
                self.most[row["polygon"]] = max(self.most[row["polygon"]], row["teams"])
        self.possible = {test: {row["polygon"] for row in rows if row[test] > 0} for test in ("form_closure", "no_area")}

    def aggregate(self, method, teams):
        rows = self.by[method, teams]
        made = {"polygons": len(rows)}
        for name in ("spread", "load_max", "max_share", "coverage"):
            values = [row[name] for row in rows]
            made[f"{name}_mean"] = math.fsum(values) / len(values)
            made[f"{name}_sd"] = statistics.stdev(values) if len(values) > 1 else None
        for test, count in (("form_closure", "closable"), ("no_area", "no_area_possible")):
            values = [row[test] for row in rows if row["polygon"] in self.possible[test]]
            made[count] = len(values)
            made[f"{test}_mean"] = math.fsum(values) / len(values) if values else None
        return made

    def shown_teams(self):
        return max(teams for (method, teams), rows in self.by.items()
                   if method == "area" and 5 * len(rows) >= len(self.by["area", 1]))

    def algorithm(self, column, teams):
        return sum(self.aggregate(method, teams)[column] for method in ALGORITHM) / 3

    def robots_needed(self, method, capacity=5):
        return min(2 * teams for (m, teams), rows in self.by.items()
                   if m == method and math.fsum(row["load_max"] for row in rows) / len(rows) <= capacity)

    def times_more_even(self, method):
        ratios = []
        for teams in range(1, self.shown_teams() + 1):
            ours = self.algorithm("spread_mean", teams)
            if ours > 1e-9 * 100 / (2 * teams):  # else even but for rounding
                ratios.append(self.aggregate(method, teams)["spread_mean"] / ours)
        return min(ratios), max(ratios)

    def choices(self, polygon, teams):
        return {self.at[polygon, method, teams]["chosen"] for method in ALGORITHM}

    def same_second(self):
        able = [p for p in self.polygons if self.most[p] >= 2]
        return [p for p in able if len(self.choices(p, 2)) == 1], able

    def same_third(self):
        able = [p for p in self.same_second()[0] if self.most[p] >= 3]
        return [p for p in able if len(self.choices(p, 3)) == 1], able

    def coverage_difference(self, method):
        """By polygon: of the method less the algorithm's, averaged over 2 and more teams."""
        differences = []
        for polygon in self.polygons:
            values = [self.at[polygon, method, teams]["coverage"]
                      - sum(self.at[polygon, m, teams]["coverage"] for m in ALGORITHM) / 3
                      for teams in range(2, self.most[polygon] + 1) if (polygon, method, teams) in self.at]
            if values:
                differences.append(math.fsum(values) / len(values))
        return differences

    def lost(self, method, test):
        """Steps at which a polygon loses its closure, of all steps from closed ones."""
        steps = [(before, after) for (polygon, m, teams), before in self.at.items() if m == method and before[test] > 0
                 for after in [self.at.get((polygon, method, teams + 1))] if after]
        return [after for before, after in steps if after[test] < before[test]], steps

    def closed_by_algorithm(self, test):
        return {row["polygon"] for row in self.rows if row["method"] in ALGORITHM and row[test] > 0}
