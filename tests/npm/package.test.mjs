// The package for npm, packed and installed as its users do: in Node, in a worker thread, in a browser and in a worker there.
//   EVENLIFT_NPM  the package's folder, build/npm if not given
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { asset, evenlift, root, startBrowser } from "../page/browser.mjs";
import { serve } from "../../web/serve.mjs";

const packageFolder = process.env.EVENLIFT_NPM || path.join(root, "build/npm");
const work = mkdtempSync(path.join(tmpdir(), "evenlift-npm-"));
after(() => rmSync(work, { recursive: true, force: true }));

const npm = (folder, ...args) => execFileSync("npm", args, { cwd: folder, encoding: "utf8" });

// A project that has installed the packed package, and nothing else.
const packed = JSON.parse(npm(work, "pack", "--json", packageFolder))[0];
const project = path.join(work, "project");
mkdirSync(project);
writeFileSync(path.join(project, "package.json"), '{ "private": true, "type": "module" }\n');
npm(project, "install", "--offline", "--no-audit", "--no-fund", path.join(work, packed.filename));
const { place, candidates, svg, poses, link, experiment, run, version, EvenliftError } =
  await import(pathToFileURL(path.join(project, "node_modules/evenlift/node.js")).href);

const plate = [[0, 0], [160, 0], [160, 90], [90, 90], [90, 60], [0, 60]];
const samples = readdirSync(path.join(root, "assets/polygons")).filter((name) => name !== "index.txt").map((name) => name.replace(/\.txt$/, ""));

// The first block of JavaScript of a text that imports the package.
function lines(file) {
  const [, code] = /```js\n(import [^`]*from "evenlift";[^`]*)```/.exec(readFileSync(path.join(root, file), "utf8"));
  return code;
}

function runInProject(name, code) {
  writeFileSync(path.join(project, name), code);
  return execFileSync(process.execPath, [name], { cwd: project, encoding: "utf8" });
}

test("it has what it needs and nothing else, and the version of the project", () => {
  assert.deepEqual(packed.files.map((file) => file.path).sort(),
    ["LICENSE", "README.md", "api.js", "evenlift.d.ts", "evenlift.js", "evenlift.wasm", "node.js", "package.json"]);
  const [, projectVersion] = /project\(evenlift VERSION ([\d.]+)/.exec(readFileSync(path.join(root, "CMakeLists.txt"), "utf8"));
  assert.equal(packed.version, projectVersion);
  assert.equal(version, projectVersion);
  assert.equal(evenlift("--version"), `evenlift ${projectVersion}\n`);
  assert.equal(JSON.parse(readFileSync(path.join(packageFolder, "package.json"), "utf8")).dependencies, undefined);
});

for (const file of ["README.md", "npm/README.md"]) {
  test(`the lines of ${file} run in Node as they stand`, () => {
    const printed = runInProject("main.mjs", lines(file));
    assert.match(printed, /^0\.\d+ \[/);
  });
}

test("every sample has the bytes that the program prints", () => {
  assert.ok(samples.length > 100);
  for (const name of samples) {
    const file = path.join(root, `assets/polygons/${name}.txt`);
    const text = asset(name);
    assert.equal(run({ text, candidates: true }), evenlift("place", file, "--json", "--candidates"), name);
    assert.deepEqual(place(text), JSON.parse(evenlift("place", file, "--json")), name);
  }
});

test("settings have the effect that the program's options have", () => {
  const file = path.join(root, "assets/polygons/hammer.txt");
  const text = asset("hammer");
  for (const [options, args] of [
    [{ teams: 5, metric: "circle", min_ratio: 0.7, weight: 42.5 }, ["--teams", "5", "--metric", "circle", "--min-ratio", "0.7", "--weight", "42.5"]],
    [{ teams: "max", failures: true, candidates: true }, ["--teams", "max", "--failures", "--candidates"]],
    [{ metric: "random", seed: 18446744073709551615n }, ["--metric", "random", "--seed", "18446744073709551615"]],
    [{ metric: "balanced", robots: 5, goal: "hold" }, ["--metric", "balanced", "--robots", "5", "--goal", "hold"]],
    [{ capacity: 20, com_radius: 10 }, ["--capacity", "20", "--com-radius", "10"]],
    [{ unit: "mm", weight_unit: "lb" }, ["--unit", "mm", "--weight-unit", "lb"]],
    [{ centre_of_mass: [260, 480] }, ["--com", "260,480"]],
  ]) assert.deepEqual(place(text, options), JSON.parse(evenlift("place", file, "--json", ...args)), JSON.stringify(args));
  assert.deepEqual(candidates(text), place(text, { candidates: true }).candidates);
  assert.equal(link(text, { metric: "circle" }), evenlift("link", "encode", file, "--metric", "circle").trim());
  const message = path.join(work, "poses.yaml");
  evenlift("place", file, "--poses", message, "--frame", "hall");
  assert.equal(poses(text, { format: "yaml", frame: "hall" }), readFileSync(message, "utf8"));
  const measured = experiment([{ name: "hammer", set: "some", text }], { samples: 2, max_teams: 2, max_balanced: 3 });
  assert.match(measured.measurements, /hammer/);
  assert.deepEqual(measured.refused, []);
  const picture = path.join(work, "picture.svg");
  evenlift("place", file, "--teams", "2", "--svg", picture);
  assert.equal(svg(text, { teams: 2 }), readFileSync(picture, "utf8"));
});

test("what is refused throws an error that says what is wrong and where", () => {
  const refused = (polygon, options) => {
    try {
      place(polygon, options);
    } catch (error) {
      assert.ok(error instanceof EvenliftError && error instanceof Error);
      return error;
    }
    return assert.fail("it was not refused");
  };
  const crossing = refused([[0, 0], [4, 4], [4, 0], [0, 4]]);
  assert.equal(crossing.code, "edges_cross");
  assert.deepEqual(crossing.place, { edges: [0, 2] });
  assert.match(crossing.message, /edges 1 and 3/i);
  assert.deepEqual(refused(plate, { min_ratio: 2 }).place, { setting: "min_ratio" });
  assert.match(refused(plate, { tems: 2 }).message, /tems/);
  assert.match(refused("no polygon at all").message, /line 1/i);
  assert.match(refused(undefined).message, /polygon/);
  assert.equal(place(plate).teams.length, 3, "it goes on");
});

test("any bytes have an answer", () => {
  for (const request of ["", "{", "[]", "null", '"\\ud800"', '{"command": "\u0000"}', '{"polygon": [[1e999, 0]]}', "[".repeat(100000)]) {
    assert.ok(JSON.parse(run(request)).error.message, request.slice(0, 40));
  }
});

// What each consumer sends back: the placement as text.
const asText = (result) => JSON.stringify(result);

test("a worker thread of Node places", () => {
  writeFileSync(path.join(project, "worker.mjs"), `
    import { parentPort, workerData } from "node:worker_threads";
    import { place } from "evenlift";
    parentPort.postMessage(place(workerData));
  `);
  const printed = runInProject("threads.mjs", `
    import { Worker } from "node:worker_threads";
    new Worker("./worker.mjs", { workerData: ${JSON.stringify(plate)} }).on("message", (result) => console.log(JSON.stringify(result)));
  `);
  assert.equal(printed.trim(), asText(place(plate)));
});

test("a browser places, in the page and in a worker, under a strict policy", async (t) => {
  const site = path.join(project, "site");
  mkdirSync(site);
  writeFileSync(path.join(site, "index.html"), '<!doctype html><meta charset="utf-8"><title>A consumer</title><script type="module" src="main.js"></script>');
  const imported = 'import { place } from "../node_modules/evenlift/evenlift.js";';
  writeFileSync(path.join(site, "worker.js"), `${imported}
    addEventListener("message", ({ data }) => postMessage(place(data)));
    postMessage("ready");`);
  writeFileSync(path.join(site, "main.js"), `${imported}
    const plate = ${JSON.stringify(plate)};
    const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    const there = new Promise((done) => {
      worker.onmessage = ({ data }) => (data === "ready" ? worker.postMessage(plate) : done(data));
    });
    globalThis.results = there.then((inWorker) => ({ here: place(plate), inWorker }));`);
  const server = await serve(project, 0);
  const { browser, close } = await startBrowser();
  t.after(async () => {
    await close();
    server.close();
  });
  const page = await browser.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  await page.goto(`${server.url}site/index.html`);
  await page.waitForFunction(() => globalThis.results);
  const { here, inWorker } = await page.evaluate(() => globalThis.results);
  assert.equal(asText(here), asText(place(plate)));
  assert.equal(asText(inWorker), asText(place(plate)));
  assert.deepEqual(complaints.filter((text) => !text.includes("favicon")), []);
});
