// On the polygon on the screen, or over many.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { asset, axe, evenlift, idle, load, phone, root, set, sharedBrowser, state } from "../page/browser.mjs";
import { allClosed, drop, openWindow } from "../page/windows.mjs";
import { fixed } from "../../web/charts/numbers.js";

const some = ["square", "star", "hammer", "thesis-sample"];

const browser = sharedBrowser();
const folder = mkdtempSync(path.join(tmpdir(), "evenlift-page-experiment-"));
after(() => rmSync(folder, { recursive: true, force: true }));

// From tests/text/test_words.cpp, and where toFixed() differs from the program.
test("numbers are rounded as the program rounds them", () => {
  const examples = [
    [2.345, 2, "2.35"],
    [1.005, 2, "1.01"],
    [0.25, 1, "0.3"],
    [9.995, 2, "10.00"],
    [-0.04, 1, "0.0"],
    [-2.5, 0, "−3"],
    [1.5e-7, 2, "0.00"],
    [0, 2, "0.00"],
    [100, 1, "100.0"],
    [99.95, 1, "100.0"],
    [1234.5, 0, "1235"],
  ];
  for (const [value, decimals, text] of examples) assert.equal(fixed(value, decimals), text);
});

// More balanced robots only take longer.
const mostBalanced = 3;

// The program's output files, by name.
function program(paths, { samples }) {
  const out = mkdtempSync(path.join(folder, "out-"));
  try {
    evenlift(
      "experiment",
      ...paths,
      "--out",
      out,
      "--samples",
      String(samples),
      "--max-balanced",
      String(mostBalanced),
    );
  } catch (error) {
    assert.equal(error.status, 1); // some were refused
  }
  return (name) => readFileSync(path.join(out, name), "utf8");
}

const pathsOf = (names) => names.map((name) => path.join(root, "assets/polygons", `${name}.txt`));

// A file for the program.
function fileWith(name, text) {
  const file = path.join(mkdtempSync(path.join(folder, "file-")), name);
  writeFileSync(file, text);
  return file;
}

// By the names of its columns.
function rowsOf(csv) {
  const [head, ...lines] = csv
    .trim()
    .split("\n")
    .map((line) => line.split(","));
  return lines.map((cells) => Object.fromEntries(head.map((name, at) => [name, cells[at]])));
}

const filesOf = (names) =>
  names.map((name) => ({ name: `${name}.txt`, mimeType: "text/plain", buffer: Buffer.from(asset(name)) }));

async function saved(page, button) {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: button }).click(),
  ]);
  return readFileSync(await download.path(), "utf8");
}

// Checks that no worker is left.
async function ended(page) {
  await Promise.all(page.workers().map((worker) => new Promise((done) => worker.once("close", done))));
  assert.equal(page.workers().length, 0);
}

async function finished(window) {
  await window.locator(".results figure").first().waitFor();
  await window.getByText(/^Done/).waitFor();
}

async function compare(window, samples, balanced = mostBalanced) {
  await window.getByLabel("Random placements").fill(String(samples));
  await window.getByLabel("Max. balanced robots").fill(String(balanced));
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  await finished(window);
}

async function runOver(window, files, samples) {
  await window.locator("input[type=file]").setInputFiles(files);
  await compare(window, samples);
}

test("it costs nothing until it is opened, and computes nothing until it is told to", async () => {
  const page = await browser.open();
  const asked = () =>
    page.evaluate(() =>
      performance
        .getEntriesByType("resource")
        .filter(({ name }) => /experiment|charts|windows/.test(name))
        .map(({ name }) => name.split("/").pop()),
    );
  assert.deepEqual(await asked(), []);
  await openWindow(page, "experiment");
  assert.deepEqual((await asked()).sort(), ["charts.css", "experiment.css", "windows.js"]);
  assert.equal(page.workers().length, 0);
  await page.done();
});

async function checkWhole(page, window, of, titles) {
  await window.locator(".running p").evaluate((line) => {
    globalThis.told = new Set();
    new MutationObserver(() => globalThis.told.add(line.textContent.replace(/^.*?: /, ""))).observe(line, {
      childList: true,
    });
  });
  await compare(window, 2);
  const told = await page.evaluate(() => [...globalThis.told]);
  for (const title of titles) assert.ok(told.includes(title), title);
  const expected = program([path.join(root, "assets", of)], { samples: 2 });
  assert.equal(await saved(page, "Measurements"), expected("measurements.csv"));
  assert.equal(await saved(page, "Averages"), expected("aggregates.csv"));
  await window.getByText("3 to 12 robots").click();
  const few = await window
    .locator(".few-robots figure")
    .evaluateAll((all) =>
      all.map((figure) => [
        figure.querySelector("h3").textContent,
        [...figure.querySelectorAll("tbody tr")].map((row) => [...row.children].map((cell) => cell.textContent)),
      ]),
    );
  const lines = expected("robots.md")
    .trim()
    .split("\n")
    .slice(2)
    .map((line) => line.slice(2, -2).split(" | "));
  assert.deepEqual(
    few.flatMap(([what, rows]) => rows.map((row) => [what, ...row])),
    lines,
  );
  await window.getByText("Against the thesis").click();
  const rows = await window
    .locator(".claims tbody tr")
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  const table = expected("thesis.md")
    .trim()
    .split("\n")
    .slice(2)
    .map((line) => line.slice(2, -2).split(" | "));
  assert.deepEqual(rows, table);
  await page.done();
}

test("over all samples, moved ones too, it writes what the program writes, byte for byte", async () => {
  const page = await browser.open();
  const samples = await openWindow(page, "samples");
  await samples.getByRole("button", { name: "Compare methods over many polygons" }).click();
  const window = page.locator("#experiment");
  await window.waitFor();
  assert.ok(await window.getByLabel("All samples").isChecked());
  await checkWhole(page, window, "polygons", ["Grand piano", "Jigsaw piece, centre of mass moved"]);
});

test("over the set like the thesis's it writes what the program writes, byte for byte", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "experiment");
  await window.getByLabel("Random polygons, as in the thesis behind evenlift").check();
  await checkWhole(page, window, "thesis-like", ["Regular, 40 sides"]);
});

test("the polygon on the screen is measured with its own centre of mass, ratio and weight", async () => {
  const page = await browser.open();
  await load(page, asset("letter-e-moved"));
  await set(page, { min_ratio: 0.7, weight: 480, weight_unit: "lb" });
  const window = await openWindow(page, "experiment");
  assert.ok(await window.getByLabel("This polygon").isChecked());
  assert.ok(await window.getByText("minimum load ratio 0.7 and weight 480 lb").isVisible());
  await compare(window, 4, 5);
  assert.deepEqual(await window.locator("h3").allTextContents(), [
    "Greatest load of a robot (lb)",
    "Spread of loads: the greatest less the least load of a robot (lb)",
    "Coverage: share of the object above the lifting base (%)",
    "Form closure (%)",
  ]);
  const rows = rowsOf(await saved(page, "Measurements"));
  const file = fileWith("shape.txt", asset("letter-e-moved"));
  const candidates = JSON.parse(evenlift("place", file, "--min-ratio", "0.7", "--json", "--candidates")).candidates
    .length;
  assert.ok(candidates > 5);
  for (const method of ["area", "circle", "distance", "distributed", "random"]) {
    const measured = rows.filter((row) => row.method === method);
    assert.deepEqual(
      measured.map(({ teams }) => Number(teams)),
      Array.from({ length: candidates }, (_, at) => at + 1),
      method,
    );
    if (method === "random") continue;
    for (const row of measured) {
      const placed = JSON.parse(
        evenlift(
          "place",
          file,
          "--min-ratio",
          "0.7",
          "--weight",
          "480",
          "--metric",
          method,
          "--teams",
          row.teams,
          "--json",
        ),
      );
      const expected = [placed.loads.max, placed.loads.spread, placed.coverage, placed.closure.form_closure ? 1 : 0];
      assert.deepEqual(
        ["load_max", "spread", "coverage", "form_closure"].map((name) => Number(row[name])),
        expected,
        `${method} ${row.teams}`,
      );
    }
  }
  const balanced = rows.filter(({ method }) => method === "balanced");
  assert.deepEqual(
    balanced.map(({ robots }) => Number(robots)),
    [2, 3, 4, 5],
  );
  for (const row of balanced) {
    const placed = JSON.parse(
      evenlift("place", file, "--weight", "480", "--metric", "balanced", "--robots", row.robots, "--json"),
    );
    assert.deepEqual(
      ["load_max", "spread", "coverage", "form_closure"].map((name) => Number(row[name])),
      [placed.loads.max, placed.loads.spread, placed.coverage, placed.closure.form_closure ? 1 : 0],
      row.robots,
    );
  }
  // Teams at every even number of robots, balanced robots at every number.
  for (const method of ["area", "balanced"]) {
    const drawn = await window
      .locator(".plot svg")
      .nth(2)
      .locator(`.dots-${method} > *`)
      .evaluateAll((all) => all.map((sign) => sign.getAttribute("aria-label")));
    assert.deepEqual(
      drawn,
      rows
        .filter((row) => row.method === method)
        .map(({ robots, coverage }) => `${method}: ${fixed(100 * coverage, 1)} % with ${robots} robots`),
    );
  }
  assert.ok(await window.getByText("At most 5 balanced robots are measured, since").isVisible());
  // Results stay for the next opening, until the polygon changes.
  await page.keyboard.press("Escape");
  await allClosed(page);
  await openWindow(page, "experiment");
  await window.locator(".plot svg").nth(3).waitFor();
  await page.keyboard.press("Escape");
  await allClosed(page);
  await set(page, { weight: 100 });
  await openWindow(page, "experiment");
  assert.equal(await window.locator("figure").count(), 0);
  await page.done();
});

test("balanced robots come last, and whoever cancels then keeps the other curves", async () => {
  const page = await browser.open();
  await load(page, asset("labyrinth"));
  const window = await openWindow(page, "experiment");
  await window.getByLabel("Random placements").fill("2");
  await window.getByLabel("Max. balanced robots").fill("64"); // this takes minutes
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  await window.locator(".plot svg").nth(3).waitFor();
  await window
    .getByText(
      "At most 64 balanced robots are measured, since the search for more takes longer. Their results are still missing.",
    )
    .waitFor();
  assert.ok(await window.getByRole("progressbar").isVisible(), "it still computes");
  assert.equal(await window.locator(".dots-balanced").count(), 0);
  assert.ok((await window.locator(".dots-random").count()) > 0);
  await window.getByRole("button", { name: "Cancel" }).click();
  await window.getByText("Cancelled; balanced robots are missing.").waitFor();
  assert.equal(await window.locator(".plot svg").count(), 4);
  await ended(page);
  await page.done();
});

test("where no team can be placed it says so, and measures balanced robots", async () => {
  const page = await browser.open();
  await load(page, "CoM:(100,300)\n(0,0)\n(400,0)\n(400,100)\n(100,100)\n(100,400)\n(0,400)\n");
  await set(page, { min_ratio: 1 });
  assert.equal((await state(page)).teams.length, 0);
  const window = await openWindow(page, "experiment");
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  await window
    .getByText(
      "No chord through the centre of mass meets this minimum load ratio: the algorithm can place no team here, so only balanced robots were measured.",
    )
    .waitFor();
  await window.locator(".plot svg").nth(3).waitFor();
  assert.deepEqual(await window.locator("figure .legend").allTextContents(), [
    "balanced",
    "balanced",
    "balanced",
    "balanced",
  ]);
  await page.done();
});

test("what the charts draw is what the CSV holds", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "experiment");
  await runOver(window, filesOf(some), 5);
  await window.locator(".plot svg").nth(6).waitFor();
  const rows = rowsOf(await saved(page, "Averages"));
  const columns = {
    5.3: "spread_mean",
    5.4: "spread_sd",
    5.5: "max_share_mean",
    5.6: "max_share_sd",
    5.7: "coverage_mean",
    5.8: "coverage_sd",
    5.11: "form_closure_mean",
  };
  for (const [id, column] of Object.entries(columns)) {
    const drawn = await window
      .locator(`[data-figure="${id}"]`)
      .evaluate((plot) =>
        Object.fromEntries(
          ["area", "circle", "distance", "distributed", "random", "balanced"].map((method) => [
            method,
            [...plot.querySelectorAll(`.dots-${method} > *`)].map(
              (sign) => sign.cy?.baseVal.value ?? sign.transform.baseVal.consolidate().matrix.f,
            ),
          ]),
        ),
      );
    const ticks = await window
      .locator(`[data-figure="${id}"]`)
      .evaluate((plot) =>
        [...plot.querySelectorAll("[aria-label='y-axis tick label'] text")].map((label) => [
          Number(label.textContent),
          label.transform.baseVal.consolidate().matrix.f,
        ]),
      );
    const [[v0, y0], [v1, y1]] = [ticks[0], ticks.at(-1)];
    const scale = ["5.3", "5.4"].includes(id) ? 1 : 100;
    const most = Math.max(
      ...rows
        .filter((row) => row.method === "area" && Number(row.polygons) * 5 >= some.length)
        .map((row) => Number(row.teams)),
    );
    let points = 0;
    for (const [method, places] of Object.entries(drawn)) {
      const expected = rows
        .filter(
          (row) => row.method === method && row[column] !== "" && (method === "balanced" || Number(row.teams) <= most),
        )
        .map((row) => scale * Number(row[column]));
      assert.equal(places.length, expected.length, `${id} ${method}`);
      places.forEach((y, at) => {
        const value = v0 + ((v1 - v0) * (y - y0)) / (y1 - y0);
        assert.ok(
          Math.abs(value - expected[at]) < Math.abs(v1 - v0) / 200,
          `${id} ${method} ${at}: ${value} for ${expected[at]}`,
        );
      });
      points += places.length;
    }
    assert.ok(points > 20, id);
  }
  await page.done();
});

test("the visitor's own files, one of them broken", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "experiment");
  const broken = "(0,0)\n(4,0)\n(4 4)\n";
  await runOver(
    window,
    [...filesOf(some), { name: "broken.txt", mimeType: "text/plain", buffer: Buffer.from(broken) }],
    4,
  );
  const expected = program([...pathsOf(some), fileWith("broken.txt", broken)], { samples: 4 });
  assert.equal(await saved(page, "Measurements"), expected("measurements.csv"));
  assert.match(
    await window.locator(".results .problem").textContent(),
    /1 polygon could not be read and was left out:broken: line 3, column 4: expected ','/,
  );
  // Files dropped on the window belong to it.
  await drop(
    page,
    {
      files: [
        ["a.txt", asset("kite")],
        ["b.wkt", "POLYGON ((0 0, 4 0, 4 3, 0 0))"],
      ],
    },
    "#experiment",
  );
  await window.getByText("My files (2)").waitFor();
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  await page.waitForFunction(() => document.querySelector(".results .problem") === null);
  const names = new Set(
    (await saved(page, "Measurements"))
      .trim()
      .split("\n")
      .slice(1)
      .map((line) => line.split(",")[1]),
  );
  assert.deepEqual([...names], ["a", "b"]);
  await page.done();
});

test("it says what is wrong with files and settings", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "experiment");
  const problem = window.locator("> .scroll > .problem");
  const press = async () => window.getByRole("button", { name: "Compare", exact: true }).click();
  await window.getByLabel("My files").check();
  await press();
  await window.getByText("Choose files first, or drop them here.").waitFor();
  await window
    .locator("input[type=file]")
    .setInputFiles([...filesOf(["star"]), { name: "star.wkt", mimeType: "text/plain", buffer: Buffer.from("x") }]);
  await press();
  await window.getByText("Two files have the name “star”.").waitFor();
  await window.locator("input[type=file]").setInputFiles(filesOf(["star"]));
  for (const [label, value, message] of [
    ["Minimum load ratio", "1.2", "The minimum load ratio must be a number from 0 to 1."],
    ["Random placements", "0", "The number of random samples must be from 1 to 100000."],
    ["Random placements", "", "The number of random samples must be from 1 to 100000."],
    ["Max. teams", "0", "The greatest number of teams must be from 1 to 10000."],
    ["Max. balanced robots", "1", "The greatest number of balanced robots must be from 2 to 64."],
    ["Max. balanced robots", "", "The greatest number of balanced robots must be from 2 to 64."],
  ]) {
    const ofOne = label === "Max. teams";
    await window.getByLabel(ofOne ? "This polygon" : "My files").check();
    if (!ofOne) await window.getByLabel("Minimum load ratio").fill("0.8");
    await window.getByLabel("Random placements").fill("5");
    await window.getByLabel("Max. balanced robots").fill("5");
    await window.getByLabel(label).fill(value);
    await press();
    await window.getByText(message).waitFor();
    assert.equal(await problem.textContent(), message);
  }
  assert.equal(await window.locator("figure").count(), 0);
  await page.done();
});

test("the page stays smooth while it computes; it shows how far it is, and stops when told to", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "experiment");
  await window.locator("input[type=file]").setInputFiles(filesOf(["square", "kite", "labyrinth"]));
  await window.getByLabel("Random placements").fill("20000"); // the last polygon then takes minutes
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  const bar = window.getByRole("progressbar");
  await page.waitForFunction(() => document.querySelector("#experiment progress").value > 0);
  assert.match(await window.locator(".running p").textContent(), /^\d of 3 polygons: (square|kite)$/);
  assert.ok(page.workers().length >= 1);
  // The page's thread is never blocked: it accepts changes and draws them.
  const frames = await page.evaluate(() => evenlift.frames);
  for (const teams of [1, 2, 4]) {
    await page.evaluate((n) => evenlift.set({ teams: n }), teams);
    await page.waitForFunction((before) => evenlift.frames > before, frames);
  }
  assert.ok(await bar.isVisible(), "it still computes");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Cancel");
  await page.keyboard.press("Enter");
  await window.getByText("Cancelled; nothing of this comparison is kept.").waitFor();
  assert.ok(await bar.isHidden());
  assert.equal(await window.locator("figure").count(), 0);
  await page.waitForFunction(() => document.activeElement.textContent === "Compare");
  await ended(page);
  // Closing the window also ends it.
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  await page.waitForFunction(() => document.querySelector("#experiment progress").value > 0);
  await page.keyboard.press("Escape");
  await allClosed(page);
  await ended(page);
  await page.done();
});

test("results are there again when the window is opened again", async () => {
  const page = await browser.open();
  let window = await openWindow(page, "experiment");
  await runOver(window, filesOf(["square", "kite"]), 2);
  const before = await saved(page, "Measurements");
  await page.keyboard.press("Escape");
  await allClosed(page);
  window = await openWindow(page, "experiment");
  await window.locator(".plot svg").nth(6).waitFor();
  assert.equal(await saved(page, "Measurements"), before);
  await page.done();
});

test("when the module cannot be fetched it says so, and tries again", async () => {
  const page = await browser.open({ quiet: false });
  const window = await openWindow(page, "experiment");
  await page.route("**/polygons.json", (route) => route.abort());
  await window.getByLabel("All samples").check();
  await window.getByRole("button", { name: "Compare", exact: true }).click();
  await window.getByText("The samples cannot be fetched: the server cannot be reached.").waitFor();
  await page.unroute("**/polygons.json");
  await runOver(window, filesOf(["square"]), 2);
  await page.done();
});

for (const [how, options] of [
  ["light", {}],
  ["dark", { colorScheme: "dark" }],
  ["on a phone", { viewport: phone, hasTouch: true, isMobile: true }],
]) {
  test(`with results it has no fault that axe finds and fits, ${how}`, async () => {
    const page = await browser.open({ ...options, reducedMotion: "reduce" });
    const window = await openWindow(page, "experiment");
    await runOver(window, filesOf(some), 3);
    await window.locator(".plot svg").nth(6).waitFor();
    for (const summary of await window.locator("summary").all()) await summary.click();
    await page.evaluate(axe);
    const found = await page.evaluate(async () =>
      (await globalThis.axe.run(document)).violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(" | ")}`,
      ),
    );
    assert.deepEqual(found, []);
    assert.ok(
      await window.evaluate(
        (dialog) => dialog.querySelector(".scroll").scrollWidth <= dialog.querySelector(".scroll").clientWidth,
      ),
    );
    await page.done();
  });
}

test("the program's report has the same charts, and needs nothing else", async () => {
  const out = path.join(folder, "report");
  execFileSync("mkdir", ["-p", out]);
  evenlift(
    "experiment",
    ...pathsOf(some),
    path.join(root, "assets/thesis-like"),
    "--out",
    out,
    "--samples",
    "2",
    "--max-balanced",
    String(mostBalanced),
  );
  const page = await browser.browser.newPage({ viewport: { width: 360, height: 700 } });
  const complaints = [];
  page.on("console", (message) => complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => request.url().startsWith("file:") || complaints.push(request.url()));
  await page.goto(`file://${path.join(out, "report.html")}`);
  await page.locator(".plot svg").nth(13).waitFor();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  const figures = await page.evaluate(() => JSON.parse(document.getElementById("figures").textContent));
  for (const figure of figures) {
    const drawn = await page
      .locator(`[data-figure="${figure.id}"][data-set="${figure.set}"] .plot svg`)
      .evaluate((svg) =>
        [...svg.querySelectorAll("[class^=dots-] > *")].map((sign) => sign.getAttribute("aria-label")),
      );
    assert.equal(drawn.length, figure.series.flatMap(({ points }) => points).length, figure.id);
    const [first] = figure.series[0].points;
    const value = figure.unit === "%" ? fixed(100 * first[1], 1) : fixed(first[1], 2);
    assert.ok(drawn[0].includes(`${value} ${figure.unit} with ${first[0]} robots`), drawn[0]);
  }
  await page.evaluate(axe);
  assert.deepEqual(
    await page.evaluate(async () => (await globalThis.axe.run(document)).violations.map(({ id }) => id)),
    [],
  );
  assert.deepEqual(complaints, []);
  await page.close();
});

test("on a phone the results are seen when they are there", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  await load(page, asset("square"));
  const window = await openWindow(page, "experiment");
  await window.getByLabel("Max. teams").fill("2");
  await window.getByLabel("Max. balanced robots").fill("2");
  await window.getByRole("button", { name: "Compare", exact: true }).tap();
  await window.getByText("Done.").waitFor();
  await idle(page);
  const { y, height } = await window.locator("figure").first().boundingBox();
  assert.ok(y >= 0 && y + height / 2 < phone.height, `the first chart begins at ${y}`);
  await page.done();
});
