#!/usr/bin/env python3
"""`evenlift experiment` as users and schedulers run it.

    EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/experiment/test_experiment.py
"""

import csv
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import results  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
POLYGONS = ROOT / "assets" / "polygons"
PROGRAM = os.path.abspath(os.environ.get("EVENLIFT_PROGRAM", ROOT / "build" / "bin" / "evenlift"))
FEW = ("--max-balanced", "4")  # more balanced robots only take longer
SOME = ["thesis-sample", "thesis-sample-centroid", "square", "star", "star-moved", "hammer", "letter-e", "comb", "gear", "island"]


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=600, **options)


class Case(unittest.TestCase):
    maxDiff = 2000

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="evenlift-experiment-"))
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.inputs = self.folder / "polygons"
        self.inputs.mkdir()
        for name in SOME:
            shutil.copy(POLYGONS / f"{name}.txt", self.inputs)

    def experiment(self, out, *more, status=0, inputs=None):
        done = run("experiment", inputs or self.inputs, "--out", self.folder / out, "--samples", 8, *([] if "--max-balanced" in more else FEW), *more)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def assert_same(self, out, expected):
        for name, content in results.contents(self.folder / out).items():
            self.assertTrue(content == expected[name], f"{out}/{name} differs")


class Runs(Case):
    def test_any_number_of_jobs_gives_the_same_bytes(self):
        self.experiment("one", "--jobs", 1)
        expected = results.contents(self.folder / "one")
        for jobs in (2, 7):
            self.experiment(f"jobs{jobs}", "--jobs", jobs)
            self.assert_same(f"jobs{jobs}", expected)

    def test_threads_that_cannot_start_leave_their_work_to_the_others(self):
        def little_room():  # no stack of this size can be had
            resource.setrlimit(resource.RLIMIT_STACK, (1 << 46, resource.getrlimit(resource.RLIMIT_STACK)[1]))

        self.experiment("one", "--jobs", 1)
        options = [self.inputs, "--out", self.folder / "many", "--samples", 8, "--jobs", 8, *FEW]
        done = run("experiment", *options, preexec_fn=little_room)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same("many", results.contents(self.folder / "one"))

    def test_the_order_of_paths_does_not_matter(self):
        other = self.folder / "another set"
        other.mkdir()
        for name in SOME[:3]:
            shutil.copy(POLYGONS / f"{name}.txt", other)
        paths = [self.inputs, other, *self.inputs.iterdir()]
        for out, given in (("one", paths), ("two", reversed(paths))):
            done = run("experiment", *given, "--out", self.folder / out, "--samples", 8, *FEW)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same("two", results.contents(self.folder / "one"))

    def test_each_folder_is_a_set_with_averages_of_its_own(self):
        other = self.folder / "another set"
        other.mkdir()
        for name in ("kite", "heart", "star"):  # one of them is in both
            shutil.copy(POLYGONS / f"{name}.txt", other)
        done = run("experiment", self.inputs, str(other) + "/", "--out", self.folder / "both", "--samples", 8, *FEW)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.experiment("first")
        self.experiment("second", inputs=other)
        for name in ("measurements.csv", "aggregates.csv", "polygons.csv"):
            both = results.table(self.folder / "both", name)
            first, second = (results.table(self.folder / out, name) for out in ("first", "second"))
            self.assertEqual(both, second + first, name)
            self.assertEqual({row["set"] for row in both}, {"another set", "polygons"}, name)
        for of, out in (("another set", "second"), ("polygons", "first")):
            self.assertEqual(results.claims(self.folder / "both", of), results.claims(self.folder / out, of))
            self.assertEqual(results.figures(self.folder / "both", of), results.figures(self.folder / out, of))

    def test_an_interrupted_run_goes_on_and_loses_nothing(self):
        # With so many samples the comb, which is third, takes over a second.
        out = self.folder / "killed"
        process = subprocess.Popen([PROGRAM, "experiment", str(self.inputs), "--out", str(out), "--samples", "250", "--jobs", "1", *FEW],
                                   stdout=subprocess.DEVNULL)
        parts = out / "parts"
        while not (parts.exists() and len(list(parts.glob("polygon-*.csv"))) >= 2):
            self.assertIsNone(process.poll(), "it ended before it could be interrupted")
            time.sleep(0.01)
        process.send_signal(signal.SIGKILL)
        process.wait()
        kept = {path.name: path.stat().st_mtime_ns for path in parts.glob("polygon-*.csv")}
        self.assertFalse((out / "measurements.csv").exists())
        more = run("experiment", self.inputs, "--out", out, "--samples", 250, *FEW)
        self.assertEqual(more.returncode, 0, more.stderr)
        self.assertIn(f"{len(kept)} of {len(SOME)} polygons were already measured", more.stdout)
        for name, changed in kept.items():
            self.assertEqual((parts / name).stat().st_mtime_ns, changed, f"{name} was measured again")
        fresh = run("experiment", self.inputs, "--out", self.folder / "fresh", "--samples", 250, *FEW)
        self.assertEqual(fresh.returncode, 0, fresh.stderr)
        self.assert_same("killed", results.contents(self.folder / "fresh"))

    def test_damaged_and_outdated_parts_are_measured_again(self):
        self.experiment("out")
        expected = results.contents(self.folder / "out")
        parts = sorted((self.folder / "out" / "parts").glob("polygon-*.csv"))
        parts[0].write_bytes(parts[0].read_bytes()[:-30])
        parts[1].write_text("")
        parts[2].unlink()
        done = self.experiment("out")
        self.assertIn(f"{len(SOME) - 3} of {len(SOME)} polygons were already measured", done.stdout)
        self.assert_same("out", expected)
        # Another outline under the same name.
        shutil.copy(POLYGONS / "hexagon.txt", self.inputs / "square.txt")
        done = self.experiment("out")
        self.assertIn(f"{len(SOME) - 1} of {len(SOME)} polygons were already measured", done.stdout)
        self.experiment("anew")
        self.assert_same("out", results.contents(self.folder / "anew"))
        # Other settings.
        done = self.experiment("out", "--min-ratio", 0.5)
        self.assertNotIn("before", done.stdout)

    def test_a_polygon_that_is_gone_is_gone_from_the_results(self):
        self.experiment("out")
        (self.inputs / "gear.txt").unlink()
        self.experiment("out")
        self.experiment("anew")
        self.assert_same("out", results.contents(self.folder / "anew"))

    def test_what_cannot_be_read_is_reported_and_skipped(self):
        self.experiment("good")
        (self.inputs / "broken.txt").write_text("(0,0)\n(4,0)\n(4 4)\n")
        (self.inputs / "crossed.txt").write_text("(0,0)\n(4,4)\n(4,0)\n(0,4)\n")
        (self.inputs / "bytes.txt").write_bytes(bytes(range(256)))
        done = self.experiment("bad", status=1)
        errors = done.stderr.splitlines()
        self.assertEqual(len(errors), 4, done.stderr)
        self.assertRegex(errors[0], r"^evenlift: .*/broken\.txt: line 3, column 4: expected ','")
        self.assertRegex(errors[1], r"^evenlift: .*/bytes\.txt: ")
        self.assertRegex(errors[2], r"^evenlift: .*/crossed\.txt: edges 1 and 3: the edges cross")
        self.assertEqual(errors[3], "evenlift: experiment: 3 of 13 polygons could not be read and were left out")
        good, bad = (results.contents(self.folder / name) for name in ("good", "bad"))
        for name in ("measurements.csv", "aggregates.csv", "thesis.md"):
            self.assertEqual(good[name], bad[name], name)
        problems = {row["polygon"]: row["problem"] for row in results.table(self.folder / "bad", "polygons.csv") if row["problem"]}
        self.assertEqual(set(problems), {"broken", "bytes", "crossed"})
        self.assertIn("crossed: edges 1 and 3", (self.folder / "bad" / "report.html").read_text())
        # Once corrected, it is measured.
        shutil.copy(POLYGONS / "arrow.txt", self.inputs / "broken.txt")
        self.assertEqual(len(self.experiment("bad", status=1).stderr.splitlines()), 3)

    def test_tables_are_read_and_other_files_of_a_folder_are_named(self):
        shutil.copy(POLYGONS / "square.txt", self.inputs / "before.txt")
        (self.inputs / "triangle.csv").write_text("x,y\n0,0\n4,0\n0,3\n")
        (self.inputs / "notes.md").write_text("not a polygon\n")
        # The results stand in the folder itself, and are not read as polygons the next time.
        out = self.inputs / "report"
        for _ in range(2):
            done = self.experiment(out)
            self.assertEqual(done.stderr, f"evenlift: {self.inputs}: 1 file was left out: notes.md\n")
        measured = {row["polygon"] for row in results.table(out, "polygons.csv")}
        self.assertLessEqual({"before", "triangle"}, measured)
        self.assertFalse(any("report" in name for name in measured))

    def test_bad_usage_gets_one_clear_line(self):
        out = self.folder / "out"
        (self.folder / "empty").mkdir()
        (self.folder / "other").mkdir()
        (self.folder / "other" / "polygons").mkdir()
        (self.folder / "files").mkdir()
        for copy in ("other", "other/polygons", "files"):
            shutil.copy(POLYGONS / "star.txt", self.folder / copy)
        for arguments, message in [
                ([], "--out: missing; it names the folder to write to"),
                ([self.inputs], "--out: missing; it names the folder to write to"),
                (["--out", out], "PATH: missing; see `evenlift experiment --help`"),
                ([self.inputs, "--out", out, "--samples", "0"], "--samples: the number of random samples must be from 1 to 100000"),
                ([self.inputs, "--out", out, "--samples", "many"], '--samples: expected a whole number, not "many"'),
                ([self.inputs, "--out", out, "--min-ratio", "2"], '--min-ratio: the minimum load ratio must be a number from 0 to 1, not "2"'),
                ([self.inputs, "--out", out, "--jobs", "0"], "--jobs: the number of threads must be from 1 to 1024"),
                ([self.inputs, "--out", out, "--max-teams", "0"], "--max-teams: the greatest number of teams must be from 1 to 10000"),
                ([self.inputs, "--out", out, "--max-balanced", "65"], "--max-balanced: the greatest number of balanced robots must be from 2 to 64"),
                (["--merge", "--out", out, "--max-balanced", "6"], "--max-balanced: not allowed with --merge: the shards are already measured"),
                ([self.inputs, "--out", out, "--shard", "3/2"],
                 '--shard: expected I/N, with I from 1 to N and N up to 100000, not "3/2"'),
                ([self.folder / "nowhere", "--out", out], f"{self.folder}/nowhere: no such file or directory"),
                ([self.folder / "empty", "--out", out],
                 f"{self.folder}/empty: no polygon in this folder: no file name ends in .txt, .csv, .wkt, .json, .geojson, .svg or .dxf"),
                ([self.inputs / "star.txt", self.folder / "other" / "star.txt", "--out", out],
                 f"{self.inputs}/star.txt: would have the same name, star, as {self.folder}/other/star.txt; "
                 "rename one, or give a folder that contains both"),
                ([self.inputs, self.folder / "other" / "polygons", "--out", out],
                 f"{self.folder}/other/polygons: would be a set with the same name, polygons, as {self.inputs}; "
                 "rename one, or give a folder that contains both"),
                ([self.inputs / "star.txt", self.folder / "files", "--out", out],
                 f"{self.folder}/files: would be a set with the same name, files, as the files given directly; rename the folder"),
                (["--merge", "--out", out], f"{out}: no experiment has run here: there is no folder {out}/parts"),
                (["--merge", "--out", out, "--jobs", "2"], "--jobs: not allowed with --merge: the shards are already measured")]:
            done = run("experiment", *arguments)
            self.assertEqual((done.returncode, done.stderr, done.stdout), (2, f"evenlift: {message}\n", ""), arguments)
            self.assertFalse(out.exists())
        blocked = self.folder / "file"
        blocked.write_text("")
        done = run("experiment", self.inputs, "--out", blocked)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"^evenlift: .*/file: ")

    def test_folders_are_searched_through_and_names_are_their_paths(self):
        deep = self.inputs / "deep, \"er\"" / "2"
        deep.mkdir(parents=True)
        shutil.move(self.inputs / "star.txt", deep / "star.txt")
        (deep / "index.txt").write_text("a list of contents\n")
        (deep / ".hidden.txt").write_text("not looked at\n")
        (deep / "notes.md").write_text("not looked at\n")
        (self.inputs / "a.wkt").write_text("POLYGON ((0 0, 4 0, 4 3, 0 0))\n")
        (self.inputs / "b.geojson").write_text('{"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,0]]]}\n')
        (self.inputs / "c.svg").write_text('<svg><rect width="4" height="3"/></svg>\n')
        (self.inputs / "table.csv").write_text("x;y\n0;0\n4;0\n4;3\n")
        self.experiment("out")
        names = [row["polygon"] for row in results.table(self.folder / "out", "polygons.csv")]
        self.assertEqual(names, sorted([name for name in SOME if name != "star"] + ["a", "b", "c", 'deep, "er"/2/star', "table"]))

    def test_all_shapes_of_a_file_are_measured_under_its_name_and_their_numbers(self):
        shapes = [[(0, 0), (40, 0), (40, 20), (0, 20)], [(90, 0), (94, 4), (94, 0), (90, 3)], [(100, 0), (109, 0), (100, 9)]]
        one, many = self.folder / "one" / "set", self.folder / "many" / "set"
        one.mkdir(parents=True)
        many.mkdir(parents=True)
        texts = ["".join(f"{x},{y}\n" for x, y in shape) for shape in shapes]
        (many / "plates.txt").write_text("\n".join(texts))
        for number, text in enumerate(texts, 1):
            (one / f"plates {number}.txt").write_text(text)
        done = self.experiment("many-out", inputs=many, status=1)
        errors = done.stderr.splitlines()
        self.assertEqual(errors[1], f"evenlift: {many}/plates.txt: it has 3 shapes; all shapes are taken")
        self.assertEqual(errors[2], f"evenlift: {many}/plates.txt: shape 2: edges 1 and 3: the edges cross, touch or overlap")
        self.assertEqual(errors[3], "evenlift: experiment: 1 of 3 polygons could not be read and were left out")
        self.experiment("one-out", inputs=one, status=1)
        self.assert_same("many-out", results.contents(self.folder / "one-out"))
        again = self.experiment("many-out", inputs=many, status=1)
        self.assertIn("2 of 3 polygons were already measured", again.stdout)
        for i in (1, 2):
            self.experiment("shards", "--shard", f"{i}/2", inputs=many, status=1 if i == 1 else 0)
        self.assertEqual(run("experiment", "--merge", "--out", self.folder / "shards").returncode, 1)
        self.assert_same("shards", results.contents(self.folder / "one-out"))
        (many / "plates 2.txt").write_text(texts[0])
        done = self.experiment("many-out", inputs=many, status=2)
        self.assertEqual(done.stderr.splitlines()[-1], f"evenlift: {many}/plates 2.txt: would have the same name, plates 2, as "
                         f"{many}/plates.txt: shape 2; rename one of the files")

    def test_a_drawing_of_which_much_stays_open_is_measured_with_a_message(self):
        drawing = self.folder / "plate.svg"
        drawing.write_text("<svg stroke='black'><circle cx='60' cy='40' r='5'/><path d='M0 0H120V80H0'/><path d='M0 80L-9 90'/></svg>")
        done = self.experiment("out", "--max-teams", 2, inputs=drawing)
        self.assertRegex(done.stderr.splitlines()[-1], r"plate\.svg: what does not close is larger than the largest shape \(.*\); all shapes are taken$")
        self.assertEqual([row["polygon"] for row in results.table(self.folder / "out", "polygons.csv")], ["plate"])

    def test_balanced_robots_are_measured_up_to_the_number_asked_for(self):
        self.experiment("out", "--max-balanced", 5)
        rows = results.measurements(self.folder / "out", "polygons")
        for polygon in SOME:
            self.assertEqual([row["robots"] for row in rows if row["polygon"] == polygon and row["method"] == "balanced"], [2, 3, 4, 5])
        cells = results.few_robots(self.folder / "out", "polygons")
        self.assertEqual([cells["number of polygons", robots, "balanced"] for robots in range(3, 13)], [str(len(SOME))] * 3 + ["–"] * 7)
        self.assertIn("Balanced robots are measured up to 5,", (self.folder / "out" / "report.html").read_text(encoding="utf-8"))

    def test_times_are_in_a_file_of_their_own(self):
        self.experiment("out")
        times = results.table(self.folder / "out", "times.csv")
        self.assertEqual(len(times), 7 * len(SOME))
        self.assertEqual({row["stage"] for row in times}, {"candidates", *results.METHODS})
        self.assertTrue(all(0 <= float(row["seconds"]) < 600 for row in times))
        for name in results.FILES:
            self.assertNotIn(b"seconds", (self.folder / "out" / name).read_bytes().split(b"<script>")[0], name)

    def test_a_terminal_sees_a_progress_bar_and_nothing_else_does(self):
        self.assertEqual(self.experiment("quiet").stderr, "")
        master, slave = pty.openpty()
        process = subprocess.Popen([PROGRAM, "experiment", str(self.inputs), "--out", str(self.folder / "out"), "--samples", "8", *FEW],
                                   stdout=subprocess.PIPE, stderr=slave, env={**os.environ, "TERM": "xterm"})
        os.close(slave)
        seen = b""
        while True:
            try:
                chunk = os.read(master, 4096)
            except OSError:
                break
            if not chunk:
                break
            seen += chunk
        os.close(master)
        self.assertEqual(process.wait(timeout=60), 0)
        process.stdout.close()
        self.assertIn(b"[" + b"." * 30 + b"] 0/10", seen)
        self.assertIn(b"[" + b"#" * 30 + b"] 10/10", seen)
        self.assertTrue(seen.endswith(b"\r\x1b[K"), "the bar is taken away")


class Settings(Case):
    """Each value is that of place, in the tests of the core; here is what the options do."""

    def rows(self, out):
        with (self.folder / out / "measurements.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def test_weight_cargo_size_and_failures_are_options(self):
        for name in SOME[3:]:
            (self.inputs / f"{name}.txt").unlink()
        self.experiment("usual")
        usual = self.rows("usual")
        self.assertNotIn("steady", usual[0])
        self.experiment("heavy", "--weight", 250, "--failures")
        heavy = self.rows("heavy")
        for a, b in zip(usual, heavy, strict=True):
            self.assertAlmostEqual(2.5 * float(a["load_max"]), float(b["load_max"]), places=9)
            self.assertEqual(a["coverage"], b["coverage"])
            self.assertIn(b["steady"], ("0", "1") if b["method"] != "random" else b["steady"])
        self.assertEqual(*[(self.folder / out / "robots.md").read_text() for out in ("usual", "heavy")])
        self.experiment("loaded", "--cargo", "100,100:40:motor", "--robot", "r=5")
        loaded = self.rows("loaded")
        self.assertEqual({row["method"] for row in loaded}, {"area", "circle", "distance", "balanced"})
        for row in loaded:
            self.assertAlmostEqual(float(row["load_mean"]) * int(row["robots"]), 140, places=9)
        for option, text, said in (("--weight", "0", "--weight: "), ("--cargo", "1,2", "--cargo: "), ("--robot", "r=-1", "--robot: ")):
            done = self.experiment("no", option, text, status=2)
            self.assertTrue(done.stderr.startswith(f"evenlift: {said}"), done.stderr)
            self.assertFalse((self.folder / "no").exists())
            done = run("experiment", "--merge", "--out", self.folder / "usual", option, text)
            self.assertEqual((done.returncode, done.stderr), (2, f"evenlift: {option}: not allowed with --merge: the shards are already measured\n"))


class Shards(Case):
    def test_shards_of_one_folder_merge_to_the_same_bytes(self):
        self.experiment("whole")
        for i in (3, 1, 2):
            done = run("experiment", "--merge", "--out", self.folder / "shared")
            self.assertEqual(done.returncode, 2)
            self.experiment("shared", "--shard", f"{i}/3")
        self.assertFalse((self.folder / "shared" / "measurements.csv").exists())
        done = run("experiment", "--merge", "--out", self.folder / "shared")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same("shared", results.contents(self.folder / "whole"))

    def test_shards_of_folders_of_their_own_merge_too(self):
        self.experiment("whole")
        for i in range(1, 15):  # more than there are polygons
            self.experiment(f"shard{i}", "--shard", f"{i}/14")
        done = run("experiment", "--merge", *[self.folder / f"shard{i}" for i in range(1, 15)], "--out", self.folder / "merged")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same("merged", results.contents(self.folder / "whole"))

    def test_what_does_not_belong_together_is_not_merged(self):
        self.experiment("a", "--shard", "1/2")
        out = self.folder / "merged"
        done = run("experiment", "--merge", self.folder / "a", "--out", out)
        self.assertEqual((done.returncode, done.stderr), (2, "evenlift: shard 2/2: missing or not finished\n"))
        self.experiment("b", "--shard", "2/2", "--min-ratio", 0.5)
        done = run("experiment", "--merge", self.folder / "a", self.folder / "b", "--out", out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("their number or settings differ", done.stderr)
        self.experiment("b", "--shard", "2/2")
        next((self.folder / "b" / "parts").glob("polygon-*.csv")).unlink()
        done = run("experiment", "--merge", self.folder / "a", self.folder / "b", "--out", out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("are missing or damaged; run its shard again", done.stderr)
        self.assertFalse((out / "measurements.csv").exists())

    def test_a_shard_with_a_corrupt_file_says_so_and_so_does_the_merge(self):
        (self.inputs / "broken.txt").write_text("(0,0)\n")
        self.experiment("whole", status=1)
        statuses = [self.experiment("shared", "--shard", f"{i}/3", status=1 if i == 1 else 0) for i in (1, 2, 3)]
        self.assertEqual(len(statuses), 3)
        done = run("experiment", "--merge", "--out", self.folder / "shared")
        self.assertEqual(done.returncode, 1)
        self.assertIn("evenlift: broken: ", done.stderr)
        self.assertIn("1 of 11 polygons could not be read", done.stderr)
        self.assert_same("shared", results.contents(self.folder / "whole"))

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_the_recipe_with_gnu_parallel(self):
        """The lines of docs/experiments.md, unchanged."""
        text = (ROOT / "docs" / "experiments.md").read_text(encoding="utf-8")
        recipe = re.search(r"```sh\n(parallel .*?)```", text, re.S).group(1)
        self.assertIn("--merge", recipe)
        for name in SOME[3:]:  # up to 12 balanced robots take long on combs
            (self.inputs / f"{name}.txt").unlink()
        recipe = recipe.replace("assets/polygons", "polygons")
        bin_folder = self.folder / "bin"
        bin_folder.mkdir()
        (bin_folder / "evenlift").symlink_to(PROGRAM)
        done = subprocess.run(["sh", "-c", recipe], cwd=self.folder, capture_output=True, text=True, timeout=600,
                              env={**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}"})
        self.assertEqual(done.returncode, 0, done.stderr)
        whole = run("experiment", self.inputs, "--out", self.folder / "whole")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        self.assert_same("report", results.contents(self.folder / "whole"))


if __name__ == "__main__":
    unittest.main()
