// The package, packed and installed as by users: in Node, in a browser, and in a worker of each.
//   EVENLIFT_NPM  the package's folder, else build/npm
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

// A project with the packed package and nothing else.
const packed = JSON.parse(npm(work, "pack", "--json", packageFolder))[0];
const project = path.join(work, "project");
mkdirSync(project);
writeFileSync(path.join(project, "package.json"), '{ "private": true, "type": "module" }\n');
npm(project, "install", "--offline", "--no-audit", "--no-fund", path.join(work, packed.filename));
const { place, candidates, svg, poses, link, optimum, trace, shapes, parts, experiment, run, version, EvenliftError } =
  await import(pathToFileURL(path.join(project, "node_modules/evenlift/node.js")).href);
const settingNames = Object.keys(JSON.parse(evenlift("--schema")).$defs.Settings.properties);

const plate = [
  [0, 0],
  [160, 0],
  [160, 90],
  [90, 90],
  [90, 60],
  [0, 60],
];
const samples = readdirSync(path.join(root, "assets/polygons"))
  .filter((name) => name !== "index.txt")
  .map((name) => name.replace(/\.txt$/, ""));

// The first block of JavaScript that imports the package.
function lines(file) {
  const [, code] = /```js\n(import [^`]*from "evenlift";[^`]*)```/.exec(readFileSync(path.join(root, file), "utf8"));
  return code;
}

function runInProject(name, code) {
  writeFileSync(path.join(project, name), code);
  return execFileSync(process.execPath, [name], { cwd: project, encoding: "utf8" });
}

test("its module needs nothing of its host but a clock and news, which only the page uses", () => {
  const module = new WebAssembly.Module(readFileSync(path.join(packageFolder, "evenlift.wasm")));
  const needed = WebAssembly.Module.imports(module).map(({ module: from, name }) => `${from}.${name}`);
  const known = [
    "host.now",
    "host.report",
    "env.emscripten_notify_memory_growth",
    "wasi_snapshot_preview1.proc_exit",
    // newer Emscripten
    "wasi_snapshot_preview1.fd_write",
    "wasi_snapshot_preview1.fd_close",
    "wasi_snapshot_preview1.fd_seek",
  ];
  assert.deepEqual(
    needed.filter((name) => !known.includes(name)),
    [],
  );
});

test("it refuses the kinds of requests that are the page's own", () => {
  for (const command of ["speak", "search", "choose", "measure", "results", "handout", "qr"])
    assert.equal(JSON.parse(run({ command })).error.code, "unsupported", command);
});

test("it has what it needs and nothing else, and the version of the project", () => {
  assert.deepEqual(packed.files.map((file) => file.path).sort(), [
    "LICENSE",
    "README.md",
    "api.js",
    "evenlift.d.ts",
    "evenlift.js",
    "evenlift.wasm",
    "licences.txt",
    "node.js",
    "package.json",
  ]);
  const [, projectVersion] = /project\(evenlift VERSION ([\d.]+)/.exec(
    readFileSync(path.join(root, "CMakeLists.txt"), "utf8"),
  );
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
    [
      { teams: 5, metric: "circle", min_ratio: 0.7, weight: 42.5 },
      ["--teams", "5", "--metric", "circle", "--min-ratio", "0.7", "--weight", "42.5"],
    ],
    [{ teams: "max", failures: true, candidates: true }, ["--teams", "max", "--failures", "--candidates"]],
    [{ metric: "random", seed: 18446744073709551615n }, ["--metric", "random", "--seed", "18446744073709551615"]],
    [{ metric: "balanced", robots: 5, goal: "hold" }, ["--metric", "balanced", "--robots", "5", "--goal", "hold"]],
    [{ capacity: 20, com_radius: 10 }, ["--capacity", "20", "--com-radius", "10"]],
    [{ unit: "mm", weight_unit: "lb" }, ["--unit", "mm", "--weight-unit", "lb"]],
    [{ centre_of_mass: [260, 480] }, ["--com", "260,480"]],
  ])
    assert.deepEqual(
      place(text, options),
      JSON.parse(evenlift("place", file, "--json", ...args)),
      JSON.stringify(args),
    );
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

// The error that a call throws.
function refused(call, ...args) {
  try {
    call(...args);
  } catch (error) {
    assert.ok(error instanceof EvenliftError && error instanceof Error, error);
    return error;
  }
  return assert.fail(`it was not refused: ${args.map(String)}`);
}

test("what is refused throws an error that says what is wrong and where", () => {
  const crossing = refused(place, [
    [0, 0],
    [4, 4],
    [4, 0],
    [0, 4],
  ]);
  assert.equal(crossing.code, "edges_cross");
  assert.deepEqual(crossing.place, { edges: [0, 2] });
  assert.match(crossing.message, /edges 1 and 3/i);
  assert.deepEqual(refused(place, plate, { min_ratio: 2 }).place, { setting: "min_ratio" });
  assert.match(refused(place, "no polygon at all").message, /unknown format/);
  assert.match(refused(place, "(0,0)\n(4,0").message, /line 2/i);
  assert.match(refused(place, undefined).message, /polygon/);
  assert.equal(place(plate).teams.length, 3, "it goes on");
});

test("files are read as the program reads them, and all shapes, optimum and trace are there", () => {
  const drawing = readFileSync(path.join(root, "tests/data/import/plate.dxf"));
  const file = path.join(work, "two.dxf");
  writeFileSync(file, drawing);
  const found = shapes(new Uint8Array(drawing));
  assert.ok(found.shapes.length > 1);
  assert.match(refused(place, new Uint8Array(drawing)).message, /"shape" chooses one of them by its number or name/);
  for (const [i, { document }] of found.shapes.entries()) {
    const printed = JSON.parse(evenlift("place", file, "--shape", String(i + 1), "--json"));
    assert.deepEqual(place(document), printed);
    const { notices, ...placed } = place(new Uint8Array(drawing), { shape: i + 1 });
    assert.deepEqual(placed, printed, String(notices));
  }
  const plain = path.join(root, "assets/polygons/hammer.txt");
  const text = asset("hammer");
  assert.deepEqual(optimum(text, { teams: 2 }), JSON.parse(evenlift("optimum", plain, "--teams", "2", "--json")));
  assert.deepEqual(trace(text, { teams: 2 }), JSON.parse(evenlift("trace", plain, "--teams", "2", "--json")));
});

test("parts are the lines and the table of the program", () => {
  const drawing = path.join(root, "examples/sheet/sheet.dxf");
  const table = path.join(work, "parts.csv");
  const options = { thickness: 8, density: "7850/m3", capacity: 0.25, sort: "load" };
  const typed = Object.entries(options).flatMap(([name, value]) => [`--${name}`, String(value)]);
  const printed = evenlift("place", drawing, "--shape", "all", "--json", "--csv", table, ...typed);
  const found = parts(readFileSync(drawing), options);
  assert.deepEqual(found.parts, printed.trim().split("\n").map(JSON.parse));
  assert.equal(found.csv, readFileSync(table, "utf8"));
  assert.equal(refused(parts, "0,0\n4,0\n4,4\n", { thickness: 8 }).path, "thickness");
});

test("a result is a polygon with its settings, and its centre of mass does not count cargo twice", () => {
  const cargo = [{ at: [30, 30], weight: 50, name: "motor" }];
  const result = place(plate, { cargo, metric: "circle", teams: 2, weight: 7, robot_radius: 1 });
  assert.deepEqual(place(result), result);
  assert.deepEqual(
    place(result, { weight: 8 }),
    place(plate, { cargo, metric: "circle", teams: 2, weight: 8, robot_radius: 1 }),
  );
  const { own_centre_of_mass, centre_of_mass } = result;
  assert.deepEqual(
    place(plate, { cargo, own_centre_of_mass, centre_of_mass }).centre_of_mass,
    place(plate, { cargo }).centre_of_mass,
  );
});

test("closed rings and third coordinates are taken, with a notice", () => {
  const closed = [...plate, plate[0]];
  const { notices, ...placed } = place(closed);
  assert.deepEqual(notices, ["a last vertex that repeats the first is left out"]);
  assert.deepEqual(placed, place(plate));
  const high = plate.map(([x, y]) => [x, y, 5]);
  assert.deepEqual(place(high).notices, ["third coordinates are left out"]);
  assert.equal(place(plate).notices, undefined);
});

test("supports may be objects with their capacity and name", () => {
  const supports = [{ at: [0, 0], capacity: 30 }, { at: [160, 0] }, [80, 50]];
  assert.deepEqual(place(plate, { supports }), place(plate, { supports: "0,0@30 160,0 80,50" }));
  const named = place(plate, { supports: [{ at: [0, 0], name: "jack" }, [160, 0], [80, 50]] });
  assert.deepEqual(named.support_names, ["jack", null, null]);
  assert.deepEqual(named, place(plate, { supports: "0,0:jack 160,0 80,50" }));
  assert.equal(named.robots[0].name, "jack");
});

test("readings weigh the object, and cases list its loads", () => {
  const square = [[0, 0], [1, 0], [1, 1], [0, 1]]; // prettier-ignore
  const asked = { supports: square, readings: [10, 20, 30, 40], reading_error: "1%", capacity: 50, cases: true };
  const { weighing, total_weight, use, cases } = place(square, asked);
  assert.equal(total_weight, 100);
  assert.deepEqual(weighing.centre_of_mass, [0.5, 0.7]);
  assert.ok(Math.abs(weighing.radius - 0.0051505) < 5e-8);
  assert.equal(use.length, 4);
  assert.deepEqual([cases[0].name, cases.at(-1).name, cases.at(-1).failed], ["level", "failure", 3]);
  assert.throws(() => place(square, { ...asked, readings: [1, 2] }), { path: "readings" });
  assert.throws(() => place(square, { ...asked, weight: 5 }), /readings give the weight/);
});

test("a wrong name is told, with the one that was meant", () => {
  for (const [wrong, right] of Object.entries({
    team: "teams",
    tems: "teams",
    min_ration: "min_ratio",
    wieght: "weight",
    minRatio: "min_ratio",
    "min-ratio": "min_ratio",
    robots_radius: "robot_radius",
    center_of_mass: "centre_of_mass",
    failure: "failures",
  })) {
    const error = refused(place, plate, { [wrong]: 3 });
    assert.equal(error.message, `There is no setting "${wrong}"; did you mean "${right}"?`);
    assert.deepEqual([error.code, error.place, error.path], ["bad_setting", { setting: wrong }, wrong]);
  }
  assert.equal(refused(place, plate, { zzz: 1 }).message, 'There is no setting "zzz"');
  assert.match(refused(poses, plate, { fromat: "csv" }).message, /"format"/);
  assert.match(refused(experiment, [{ polygon: plate }], { sample: 3 }).message, /"samples"/);
  assert.equal(refused(experiment, [{ polygn: plate }]).path, "polygons[0].polygn");
  for (const call of [candidates, svg, link])
    assert.deepEqual(refused(call, plate, { failures: true }).place, { setting: "failures" });
  for (const name of ["__proto__", "constructor", "toString"]) refused(place, plate, JSON.parse(`{"${name}": 1}`));
});

test("what is no finite number is told of by its vertex, of the centre of mass or by its setting", () => {
  for (const bad of [NaN, Infinity, -Infinity]) {
    for (const vertex of [
      [bad, 90],
      [90, bad],
    ]) {
      const error = refused(place, [...plate.slice(0, 3), vertex, ...plate.slice(4)]);
      assert.equal(error.message, "Vertex 4: a point must be two numbers [x, y]");
      assert.deepEqual([error.place, error.path], [{ vertices: [3] }, "polygon[3]"]);
      assert.deepEqual(refused(place, plate, { centre_of_mass: vertex }).place, { centre_of_mass: true });
      assert.equal(refused(experiment, [{ polygon: plate }, { polygon: [vertex] }]).path, "polygons[1].polygon[0]");
    }
    // "NaN" may be a name.
    for (const name of settingNames.filter((each) => each !== "support_names")) {
      const error = refused(place, plate, { [name]: bad });
      assert.deepEqual([error.code, error.place], ["bad_setting", { setting: name }]);
    }
    assert.deepEqual(refused(experiment, [{ polygon: plate }], { samples: bad }).place, { setting: "samples" });
  }
});

test("so is what is no number, no point, no polygon or no text at all", () => {
  for (const vertex of [[1, 2, 3, 4], [1], [], 1, null, undefined, [null, 1], ["1", "2"], [1n, 2], [1e300, 0]]) {
    assert.deepEqual(refused(place, [[0, 0], [160, 0], vertex]).place, { vertices: [2] });
  }
  assert.deepEqual(refused(place, new Array(3)).place, { vertices: [0] });
  for (const centre of [[1, 2, 3, 4], 3, ["a", "b"], [[1, 2]]])
    assert.deepEqual(refused(place, plate, { centre_of_mass: centre }).place, { centre_of_mass: true });
  for (const value of [[5], {}, () => 3, Symbol("a"), true, "half \ud800"])
    assert.deepEqual(refused(place, plate, { weight: value }).place, { setting: "weight" });
  for (const name of ["slope", "teams", "capacity"])
    assert.equal(refused(place, plate, { [name]: [1] }).path, name, "an array is no number");
  assert.equal(refused(place, plate, { unit: ["mm"] }).path, "unit");
  assert.equal(
    refused(place, plate, {
      cargo: [
        { at: [1, 1], weight: 3 },
        { at: [1, 1], weight: "x" },
      ],
    }).path,
    "cargo[1].weight",
  );
  for (const polygon of [null, undefined, 3, {}]) assert.equal(refused(place, polygon).code, "bad_syntax");
  assert.equal(refused(place, "(0,0)\n(4,\ud8000)").path, "text");
  assert.equal(refused(place, new Array(1048578).fill([0, 0])).code, "too_many_vertices");
  assert.deepEqual(refused(place, plate, { candidates: 1 }).place, { setting: "candidates" });
  assert.match(refused(place, plate, { com: [50, 50], centre_of_mass: [40, 40] }).message, /give one of them/);
  assert.match(refused(place, plate, { method: "balanced", metric: "area" }).message, /are the same setting/);
  for (const polygons of [
    undefined,
    {},
    [3],
    [null],
    [{}],
    [{ text: plate }],
    [{ polygon: "x" }],
    [{ polygon: plate, text: "x" }],
    [{ polygon: plate, name: 3 }],
    [{ polygon: plate, set: "\ud800" }],
    new Array(10001).fill({ polygon: plate }),
  ]) {
    assert.doesNotMatch(refused(experiment, polygons).message, /column/);
  }
  assert.equal(place(plate, { seed: undefined, teams: null, centre_of_mass: null }).teams.length, 3);
  assert.equal(place(plate, null).teams.length, 3);
});

test("the options of poses are refused by their names, and just those that the core refuses", () => {
  for (const [name, values] of Object.entries({
    format: ["csv", "json", "yaml", "CSV", "xml", "", null, 3],
    origin: ["file", "com", "File", "", null, 3],
    frame: ["map", "a/b", "/a", "a b", "", "a".repeat(255), "a".repeat(256), "é", "a\n", "-_.", null, 3],
  })) {
    for (const value of values) {
      if (JSON.parse(run({ command: "poses", polygon: plate, [name]: value })).error) {
        assert.deepEqual(refused(poses, plate, { [name]: value }).place, { setting: name }, String(value));
      } else {
        assert.ok(poses(plate, { [name]: value }));
      }
    }
  }
});

test("every setting is one that the core knows", () => {
  for (const name of settingNames) assert.deepEqual(place(plate, { [name]: null }), place(plate), name);
});

test("any bytes have an answer", () => {
  for (const request of [
    "",
    "{",
    "[]",
    "null",
    '"\\ud800"',
    '{"command": "\u0000"}',
    '{"polygon": [[1e999, 0]]}',
    "[".repeat(100000),
  ]) {
    assert.ok(JSON.parse(run(request)).error.message, request.slice(0, 40));
  }
});

// Each consumer's answer, as text.
const asText = (result) => JSON.stringify(result);

test("a worker thread of Node places", () => {
  writeFileSync(
    path.join(project, "worker.mjs"),
    `
    import { parentPort, workerData } from "node:worker_threads";
    import { place } from "evenlift";
    parentPort.postMessage(place(workerData));
  `,
  );
  const printed = runInProject(
    "threads.mjs",
    `
    import { Worker } from "node:worker_threads";
    new Worker("./worker.mjs", { workerData: ${JSON.stringify(plate)} }).on("message", (result) => console.log(JSON.stringify(result)));
  `,
  );
  assert.equal(printed.trim(), asText(place(plate)));
});

test("a browser places, in the page and in a worker, under a strict policy", async (t) => {
  const site = path.join(project, "site");
  mkdirSync(site);
  writeFileSync(
    path.join(site, "index.html"),
    '<!doctype html><meta charset="utf-8"><title>A consumer</title><script type="module" src="main.js"></script>',
  );
  const imported = 'import { place } from "../node_modules/evenlift/evenlift.js";';
  writeFileSync(
    path.join(site, "worker.js"),
    `${imported}
    addEventListener("message", ({ data }) => postMessage(place(data)));
    postMessage("ready");`,
  );
  writeFileSync(
    path.join(site, "main.js"),
    `${imported}
    const plate = ${JSON.stringify(plate)};
    const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    const there = new Promise((done) => {
      worker.onmessage = ({ data }) => (data === "ready" ? worker.postMessage(plate) : done(data));
    });
    globalThis.results = there.then((inWorker) => ({ here: place(plate), inWorker }));`,
  );
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
  assert.deepEqual(
    complaints.filter((text) => !text.includes("favicon")),
    [],
  );
});
