#!/usr/bin/env python3
"""The numbers of `evenlift experiment`, recomputed from measurements.csv by other code.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/experiment/test_numbers.py
"""

import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import results  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("EVENLIFT_PROGRAM", str(ROOT / "build" / "bin" / "evenlift"))
FIGURES = {"5.3": "spread_mean", "5.4": "spread_sd", "5.5": "max_share_mean", "5.6": "max_share_sd",
           "5.7": "coverage_mean", "5.8": "coverage_sd", "5.11": "form_closure_mean"}


def numbers(text):
    return [float(n) for n in re.findall(r"\d+(?:\.\d+)?", text)]


SETS = ["polygons", "thesis-like"]


def setUpModule():
    """Both sets are measured once, for all tests."""
    global FOLDER
    FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="evenlift-numbers-"))
    unittest.addModuleCleanup(shutil.rmtree, FOLDER, True)
    done = subprocess.run([PROGRAM, "experiment", *[str(ROOT / "assets" / name) for name in SETS], "--out", str(FOLDER)],
                          capture_output=True, text=True, timeout=2400)
    assert done.returncode == 0, done.stderr


class Numbers:
    """Properties of each set."""
    maxDiff = 4000
    of = ""

    @classmethod
    def setUpClass(cls):
        cls.folder = FOLDER
        cls.polygons = [row for row in results.table(cls.folder, "polygons.csv") if row["set"] == cls.of]
        cls.rows = results.measurements(cls.folder, cls.of)
        cls.made = results.Recomputed(cls.rows)
        cls.claims = results.claims(cls.folder, cls.of)

    def aggregates(self):
        return [row for row in results.table(self.folder, "aggregates.csv") if row["set"] == self.of]

    def near(self, text, *expected, places):
        """Numbers in a text equal the recomputed ones, to the digits in the text."""
        given = numbers(text)
        self.assertEqual(len(given), len(expected), text)
        for shown, value in zip(given, expected):
            self.assertLessEqual(abs(shown - value), 0.5 * 10 ** -places + 1e-9, f"{text}: {value}")

    def test_every_polygon_can_be_read(self):
        files = {path.stem for path in (ROOT / "assets" / self.of).glob("*.txt")} - {"index"}
        self.assertEqual({row["polygon"] for row in self.polygons}, files)
        self.assertTrue(all(row["problem"] == "" for row in self.polygons))

    def test_every_polygon_method_and_number_of_robots_has_its_row(self):
        candidates = {row["polygon"]: int(row["candidates"]) for row in self.polygons}
        expected = [(p, m, 2 * t) for p in sorted(candidates) for m in results.PAIRS for t in range(1, candidates[p] + 1)]
        self.assertEqual([(r["polygon"], r["method"], r["robots"]) for r in self.rows if r["method"] != "balanced"], expected)
        # Balanced robots need no candidates, and their rows come last in each polygon.
        self.assertEqual([(r["polygon"], r["method"]) for r in self.rows],
                         sorted(((r["polygon"], r["method"]) for r in self.rows), key=lambda at: (at[0], results.METHODS.index(at[1]))))
        for polygon in candidates:
            numbers_of = [r["robots"] for r in self.rows if r["polygon"] == polygon and r["method"] == "balanced"]
            self.assertEqual(numbers_of, sorted(set(numbers_of)), polygon)
            self.assertLessEqual(set(numbers_of), set(range(2, 13)), polygon)
            self.assertGreaterEqual(set(numbers_of), set(range(5, 13)), polygon)

    def test_rows_are_consistent_in_themselves(self):
        for row in self.rows:
            where = f'{row["polygon"]} {row["method"]} {row["teams"]}'
            balanced = row["method"] == "balanced"
            team = 200 / row["robots"]  # the load of two robots
            self.assertEqual(row["teams"], 1 if balanced else row["robots"] / 2, where)
            self.assertEqual(row["samples"], 200 if row["method"] == "random" else 1, where)
            self.assertAlmostEqual(row["load_mean"], team / 2, delta=1e-12 * team, msg=where)
            self.assertAlmostEqual(row["spread"], row["load_max"] - row["load_min"], delta=1e-12 * team, msg=where)
            self.assertAlmostEqual(row["max_share"], row["load_max"] / team, delta=1e-12, msg=where)
            self.assertTrue(0 <= row["coverage"] <= 1 and row["held_clear"] <= row["form_closure"] <= row["no_area"] <= 1, where)
            if row["method"] in results.ALGORITHM:
                self.assertLessEqual(row["max_share"], 1 / 1.8 + 1e-9, where)
            if balanced:
                self.assertEqual((row["spread"], row["max_share"], row["chosen"]), (0, 0.5, ""), where)

    def test_aggregates_are_those_of_the_rows(self):
        seen = set()
        for row in self.aggregates():
            key = row["method"], int(row["robots"])
            seen.add(key)
            self.assertEqual(int(row["teams"]), 1 if key[0] == "balanced" else key[1] / 2)
            for name, value in self.made.aggregate(*key).items():
                if value is None:
                    self.assertEqual(row[name], "", (key, name))
                else:
                    self.assertAlmostEqual(float(row[name]), value, delta=1e-9 * max(1, abs(value)), msg=str((key, name)))
        self.assertEqual(seen, set(self.made.by))

    def test_figures_draw_the_aggregates(self):
        aggregates = {(row["method"], int(row["robots"])): row for row in self.aggregates()}
        figures = results.figures(self.folder, self.of)
        self.assertEqual([figure["id"] for figure in figures], list(FIGURES))
        shown = {method: self.made.shown("balanced" if method == "balanced" else "area") for method in results.METHODS}
        self.assertGreaterEqual(shown["area"], 20)
        self.assertEqual(shown["balanced"], 12)
        for figure in figures:
            column = FIGURES[figure["id"]]
            self.assertEqual(figure["column"], column)
            expected = {key: row[column] for key, row in aggregates.items() if key[1] <= shown[key[0]] and row[column] != ""}
            drawn = {(series["method"], robots): value for series in figure["series"] for robots, value, _ in series["points"]}
            self.assertEqual(set(drawn), set(expected), figure["id"])
            for key, value in drawn.items():
                self.assertEqual(value, float(expected[key]), (figure["id"], key))
            counts = "closable" if figure["id"] == "5.11" else "polygons"
            for series in figure["series"]:
                for robots, _, polygons in series["points"]:
                    self.assertEqual(polygons, int(aggregates[series["method"], robots][counts]))

    def test_sentences_say_what_the_figures_show(self):
        sentences = {figure["id"]: figure["sentence"].replace("\u00a0", " ") for figure in results.figures(self.folder, self.of)}
        for figure, robots, column, places in [("5.3", 4, "spread_mean", 2), ("5.5", 20, "max_share_mean", 1),
                                               ("5.7", 12, "coverage_mean", 1), ("5.11", 8, "form_closure_mean", 1)]:
            scale = 1 if figure == "5.3" else 100
            for method, by in [("area", "by area"), ("circle", "by circle"), ("distance", "by distance"),
                               ("distributed", "at equal angles"), ("random", "at random"), ("balanced", "in balance")]:
                if (method, robots) not in self.made.by:
                    self.assertNotIn(by, sentences[figure])
                    continue
                value = float(re.search(rf"([\d.]+) (?:kg|%) {by}", sentences[figure]).group(1))
                self.assertAlmostEqual(value, scale * self.made.aggregate(method, robots)[column], delta=0.5001 * 10 ** -places)
        least, most = self.made.times_more_even("distributed")
        self.assertIn(f"{least:.1f} to {most:.1f} times the spread of the algorithm", sentences["5.3"])
        report = (self.folder / "report.html").read_text(encoding="utf-8")
        for sentence in sentences.values():
            self.assertIn(sentence.replace(" kg", "\u00a0kg").replace(" %", "\u00a0%"), report)

    def test_claims_about_loads(self):
        for robots in (4, 30):
            for method in results.PAIRS:
                made = self.made.aggregate(method, robots)
                ours = self.claims[f"Spread of loads with {robots} robots, {method}"]
                self.near(ours, made["spread_mean"], made["spread_sd"], places=2)
        for method in results.PAIRS:
            made = self.made.aggregate(method, 20)
            ours = self.claims[f"Shares of the team’s load with 10 teams, {method}"]
            self.near(ours, 100 - 100 * made["max_share_mean"], 100 * made["max_share_mean"], 100 * made["max_share_sd"], places=1)
            ours = self.claims[f"Fewest robots with a greatest load of at most 5 kg of 100 kg, averaged over the polygons, {method}"]
            self.assertEqual(numbers(ours)[0], self.made.robots_needed(method))
        for method in ("distributed", "random"):
            ours = self.claims[f"Spread of loads of {method} in multiples of the algorithm’s, over the numbers of robots shown"]
            self.near(ours, *self.made.times_more_even(method), places=1)

    def test_claims_about_choices_and_coverage(self):
        same, of = self.made.same_second()
        self.assertIn(f"({len(same)} of {len(of)})", self.claims["All three metrics choose the same second team"])
        same, of = self.made.same_third()
        self.assertIn(f"({len(same)} of {len(of)})", self.claims["The same third team, where the second is the same"])
        small = {row["polygon"] for row in self.polygons if int(row["vertices"]) <= 12}
        for what, (same, of) in [("The same second team", self.made.same_second()), ("The same third team, where the second is the same", self.made.same_third())]:
            self.assertIn(f"({len(small.intersection(same))} of {len(small.intersection(of))})", self.claims[f"{what}, polygons with at most 12 vertices"])
        self.near(self.claims["Coverage by the algorithm: with 36 robots"], 100 * self.made.algorithm("coverage_mean", 36), places=1)
        rows = [100 * row["coverage"] for row in self.rows if row["method"] in results.ALGORITHM and row["teams"] >= 2]
        self.near(self.claims["Coverage by the algorithm: mean over all its measurements from 4 robots on"], statistics.fmean(rows), statistics.stdev(rows), places=1)
        covered = [self.made.algorithm("coverage_mean", robots) for robots in range(4, self.made.shown() + 1, 2)]
        self.near(self.claims["Coverage by the algorithm: mean of figure 5.7 from 4 robots on"], 100 * statistics.fmean(covered), places=1)
        for what, method, sign in [("Coverage of distributed less coverage of the algorithm, mean over a polygon’s numbers of teams", "distributed", 1),
                                   ("Coverage of the algorithm less coverage of random, mean over a polygon’s numbers of teams", "random", -1)]:
            made = self.made.coverage_difference(method)
            ours = self.claims[what]
            self.near(ours, abs(sign * 100 * statistics.fmean(made)), 100 * statistics.stdev(made), places=1)
            self.assertEqual(ours.startswith("-"), sign * statistics.fmean(made) < 0)

    def test_claims_about_closure(self):
        for test, how in (("form_closure", ""), ("no_area", ", by the thesis’s test that no region has an area")):
            possible = self.made.possible[test]
            self.assertEqual(self.claims[f"Polygons that no method brings into form closure{how}"],
                             f"{len(self.made.polygons) - len(possible)} of {len(self.made.polygons)}")
            for robots in (4, 8):
                for method in results.PAIRS:
                    made = self.made.aggregate(method, robots)
                    count = made["closable" if test == "form_closure" else "no_area_possible"]
                    self.near(self.claims[f"In form closure with {robots} robots, {method}{how}"], 100 * made[f"{test}_mean"], count, places=0)
            small = [row for row in self.rows if row["method"] == "distance" and row["teams"] == 4 and row["polygon"] in possible
                     and next(int(p["vertices"]) for p in self.polygons if p["polygon"] == row["polygon"]) <= 12]
            self.assertIn(f"({sum(row[test] > 0 for row in small)} of {len(small)})", self.claims[f"In form closure with 8 robots, distance, polygons with at most 12 vertices{how}"])
            for method in results.ALGORITHM:
                lost, steps = self.made.lost(method, test)
                self.assertEqual(lost, [], method)
                self.assertEqual(self.claims[f"Form closure lost by adding a team, {method}{how}"], f"never (in {len(steps)} steps)")
            lost, steps = self.made.lost("distributed", test)
            ours = self.claims[f"Form closure lost by adding a team, distributed{how}"]
            self.assertEqual(numbers(ours), [len(lost), len(steps), *sorted({row["robots"] for row in lost})])
            closed = self.made.closed_by_algorithm(test) & possible
            self.assertIn(f"({len(closed)} of {len(possible)})",
                          self.claims[f"Polygons in form closure by the algorithm, of those in form closure by any method{how}"])

    def test_the_table_of_few_robots_has_the_means_of_the_rows(self):
        cells = results.few_robots(self.folder, self.of)
        measures = {"coverage, %": ("coverage", 100, 1), "in form closure, %": ("form_closure", 100, 1), "held with clearance, %": ("held_clear", 100, 1),
                    "spread of loads, kg of 100 kg": ("spread", 1, 2)}
        self.assertEqual(set(cells), {(what, robots, method) for what in [*measures, "number of polygons"] for robots in range(3, 13) for method in results.METHODS})
        for (what, robots, method), cell in cells.items():
            rows = self.made.by.get((method, robots), [])
            where = (what, robots, method)
            self.assertEqual(cell == "–", robots % 2 == 1 and method != "balanced", where)
            if cell == "–":
                self.assertEqual(rows, [], where)
            elif what == "number of polygons":
                self.assertEqual(int(cell), len(rows), where)
            else:
                column, scale, places = measures[what]
                self.near(cell, scale * statistics.fmean(row[column] for row in rows), places=places)


class Samples(Numbers, unittest.TestCase):
    of = "polygons"


class ThesisLike(Numbers, unittest.TestCase):
    of = "thesis-like"


# By the outline and the row in polygons.csv.
def class_of_sample(outline, row, regular):
    if outline in regular:
        return "convex regular"
    if row["convex"] == "1":
        return "convex irregular"
    return "non-convex, simple" if int(row["vertices"]) < 40 else "non-convex, complex"


def class_of_thesis_like(outline, row, regular):
    return {"regular": "convex regular", "convex": "convex irregular", "notched": "non-convex, notched", "star": "non-convex, star-shaped"}[outline.split("-")[0]]


class Manual(unittest.TestCase):
    """The manual's statements about the sets are true."""
    maxDiff = 4000

    def section(self, heading):
        text = (ROOT / "assets" / "README.md").read_text(encoding="utf-8")
        return re.search(rf"^#+ {re.escape(heading)}$(.*?)(?=^#|\Z)", text, re.M | re.S).group(1)

    def check_classes(self, of, heading, class_of):
        text = self.section(heading)
        stated = {name: [int(n) for n in re.findall(r"\d+", rest)][:4]
                  for name, rest in re.findall(r"^\| ((?:non-)?convex[^|]*) \| (.*)$", text, re.M)}
        regular = re.findall(r"`([\w-]+)`", re.search(r"^\| convex regular .*$", text, re.M).group(0))
        found = {name: [] for name in stated}
        for row in results.table(FOLDER, "polygons.csv"):
            if row["set"] == of:
                found[class_of(re.sub(r"-moved(-\d)?$", "", row["polygon"]), row, regular)].append(row)
        for kind, rows in found.items():
            vertices = [int(row["vertices"]) for row in rows]
            moved = sum("-moved" in row["polygon"] for row in rows)
            self.assertEqual(stated[kind], [len(rows), moved, min(vertices), max(vertices)], kind)

    def test_the_classes_of_the_samples_are_filled_as_it_says(self):
        self.check_classes("polygons", "As a set for experiments", class_of_sample)

    def test_the_classes_of_the_generated_set_are_filled_as_it_says(self):
        self.check_classes("thesis-like", "`thesis-like/`", class_of_thesis_like)

    def test_every_outline_of_the_samples_is_described(self):
        text = self.section("`polygons/`")
        for row in results.table(FOLDER, "polygons.csv"):
            if row["set"] == "polygons":
                self.assertIn(f"| `{row['polygon'].removesuffix('-moved').removesuffix('-centroid')}` |", text)

    def test_it_holds_the_tables_that_the_program_makes(self):
        manual = (ROOT / "docs" / "experiments.md").read_text(encoding="utf-8")
        for table in results.manual_tables(FOLDER):
            self.assertIn(table, manual, "docs/experiments.md is not what the program makes of both sets now; "
                                         "tests/experiment/update_manual.py writes its tables anew")

    def test_what_it_says_of_balanced_robots_where_pairs_stand_is_so(self):
        text = " ".join((ROOT / "docs" / "experiments.md").read_text(encoding="utf-8").split())
        stated = numbers(re.search(r"On those alone on which 6 robots stand in pairs, (.*?)\. What", text).group(1))
        found = []
        for of in SETS:
            rows = results.measurements(FOLDER, of)
            pairs = {row["polygon"] for row in rows if (row["method"], row["robots"]) == ("area", 6)}
            six = [row for row in rows if (row["method"], row["robots"]) == ("balanced", 6)]
            found += [100 * statistics.fmean(row[column] for row in six if row["polygon"] in pairs) for column in ("coverage", "form_closure")]
        self.assertEqual(stated, [round(value, 1) for value in found])
        self.assertIn(f"cover as little as {100 * min(row['coverage'] for row in six):.1f} %", text)

    def test_the_readme_gives_the_spreads_of_six_robots(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        stated = re.search(r"exceeds\s+the\s+least\s+by\s+([\d.]+ kg)[^.]*\brandom\b[^.]*\bby\s+([\d.]+ kg)\s[^.]*\barea\b", readme)
        self.assertIsNotNone(stated, "README.md does not say by how much the loads differ at random, and by how much with area")
        self.assertEqual(stated.groups(), tuple(results.readme_spreads(FOLDER)))

    def test_the_generator_makes_the_files_that_are_kept(self):
        kept = ROOT / "assets" / "thesis-like"
        with tempfile.TemporaryDirectory() as made:
            subprocess.run([sys.executable, str(kept / "generate.py"), "--program", PROGRAM, "--out", made], check=True, capture_output=True)
            files = {path.name: path.read_bytes() for path in pathlib.Path(made).iterdir()}
            self.assertEqual(files, {path.name: path.read_bytes() for path in kept.glob("*.txt")})


if __name__ == "__main__":
    unittest.main()
