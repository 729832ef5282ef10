// Every sample's results have the declared type with every member, and the compiler refuses what the core would refuse.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { asset, evenlift, root } from "../page/browser.mjs";

const ts = createRequire(path.join(root, "tests/page/package.json"))("typescript");
const packageFolder = process.env.EVENLIFT_NPM || path.join(root, "build/npm");
const ofPackage = (name) => import(pathToFileURL(path.join(packageFolder, name)).href);
const declared = readFileSync(path.join(root, "npm/evenlift.d.ts"), "utf8");

// Complaints about a module that imports "evenlift", as "LINE: MESSAGE".
function complaintsOf(code) {
  const files = {
    "/main.ts": code,
    "/node_modules/evenlift/index.d.ts": declared,
    "/node_modules/evenlift/package.json": '{ "name": "evenlift", "types": "index.d.ts" }',
  };
  const options = {
    strict: true,
    noEmit: true,
    exactOptionalPropertyTypes: true,
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.ESNext,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    types: [],
    lib: ["lib.es2022.d.ts"],
  };
  const host = ts.createCompilerHost(options);
  const { getSourceFile, fileExists, readFile } = host;
  host.getSourceFile = (name, language) =>
    files[name] === undefined
      ? getSourceFile.call(host, name, language)
      : ts.createSourceFile(name, files[name], language);
  host.fileExists = (name) => files[name] !== undefined || fileExists.call(host, name);
  host.readFile = (name) => files[name] ?? readFile.call(host, name);
  host.directoryExists = undefined;
  host.getCurrentDirectory = () => "/";
  const program = ts.createProgram(["/main.ts"], options, host);
  return ts.getPreEmitDiagnostics(program).map(({ file, start, messageText }) => {
    const line = file ? file.getLineAndCharacterOfPosition(start).line + 1 : 0;
    return `${line}: ${ts.flattenDiagnosticMessageText(messageText, "\n").slice(0, 300)}`;
  });
}

const names = readdirSync(path.join(root, "assets/polygons"))
  .filter((name) => name !== "index.txt")
  .map((name) => name.replace(/\.txt$/, ""));
const printed = (name, ...options) =>
  evenlift("place", path.join(root, `assets/polygons/${name}.txt`), "--json", ...options);

test("what the program prints is a Placement, with no member more or less", () => {
  // As literals, in which the compiler reports undeclared members.
  const results = [
    ...names.map((name) => printed(name)),
    printed("hammer", "--failures", "--candidates", "--capacity", "20", "--com-radius", "5"),
    printed("hammer", "--capacity", "0.001"),
    printed("star", "--metric", "balanced", "--robots", "5", "--failures"),
    printed("guitar", "--positions", "range", "--goal", "hold", "--clear", "1", "--candidates"),
    printed("grand-piano", "--robot", "r=30,reach=20,depth=40,width=60,gap=10", "--no-go", "38,2:0.25-0.75"),
    printed("square", "--metric", "balanced", "--robot", "r=3"),
    printed("hammer", "--unit", "mm", "--weight-unit", "lb"),
    printed("star", "--metric", "random", "--seed", "7"),
    printed("square", "--min-ratio", "1", "--teams", "1"),
  ];
  const code = `import type { Placement } from "evenlift";\n${results.map((json, i) => `export const p${i}: Placement = ${json}`).join(";\n")};\n`;
  assert.deepEqual(complaintsOf(code), []);
});

test("a member that is not declared, or missing, is complained of", () => {
  const result = JSON.parse(printed("square"));
  const checked = (value) =>
    complaintsOf(`import type { Placement } from "evenlift";\nexport const p: Placement = ${JSON.stringify(value)};\n`);
  assert.equal(checked({ ...result, news: 1 }).length, 1);
  const { hull, ...rest } = result;
  assert.ok(hull);
  assert.equal(checked(rest).length, 1);
});

test("the lines of the READMEs and every function are typed", () => {
  for (const file of ["README.md", "npm/README.md"]) {
    const [, code] = /```js\n(import [^`]*from "evenlift";[^`]*)```/.exec(readFileSync(path.join(root, file), "utf8"));
    assert.deepEqual(
      complaintsOf(
        `declare const console: { log(...values: unknown[]): void };\n${code.replace(/const plate = (.*);/, "const plate: [number, number][] = $1;")}`,
      ),
      [],
      file,
    );
  }
  const polygon = JSON.stringify(asset("square"));
  assert.deepEqual(
    complaintsOf(`
    import { EvenliftError, candidates, experiment, link, optimum, parts as all, place, poses, run, shapes, svg, trace, version } from "evenlift";
    const polygon = ${polygon};
    const loads: (number | null)[] = place(polygon, { teams: "max", metric: "circle", seed: 7n, centre_of_mass: [500, 480], failures: true }).teams.flatMap((team) => team.loads);
    const kinds: ("bisecting" | "vertex" | "midpoint" | "range")[] = candidates([[0, 0], [4, 0], [4, 3]] as const).map(({ kind }) => kind);
    const beside: number | null = place(polygon, { clear: 0.1 }).closure.clearance;
    const texts: string[] = [svg(polygon, { overlays: ["hull"] }), link(polygon), poses(polygon, { format: "yaml", frame: "plate", origin: "com" }),
      run({ command: "version" }), version, experiment([{ name: "a", text: polygon }], { samples: 1 }).measurements];
    const placed = place([[0, 0, 1], [4, 0, 1], [4, 3, 1]], { supports: [{ at: [0, 0], capacity: 30 }, [4, 0]], require: "held" });
    const parts = shapes(new Uint8Array([40])).shapes.map(({ document }) => place(document).held);
    const sheet = all("0,0 4,0 4,4", { weight_per_area: "15.6/m2", capacity: 3, sort: "load" });
    const carried = sheet.parts.map((part) => ("error" in part ? part.error.message : part.teams[0]!.loads[0]!));
    const best: [boolean, string] = [optimum(placed, { teams: 2 }).optimum.proved, trace(polygon)[0]!.caption];
    const path = (error: EvenliftError): string | null => error.path;
    const refused = (error: unknown): string => (error instanceof EvenliftError ? error.code : "");
    export { beside, best, carried, kinds, loads, parts, path, refused, texts };
  `),
    [],
  );
});

test("an experiment's result is an Experiment, and candidates are Candidates, with no member more or less", async () => {
  const { candidates, experiment } = await ofPackage("node.js");
  const measured = experiment([{ name: "star", text: asset("star") }, { text: "POLYGON (" }], {
    samples: 2,
    max_teams: 2,
    max_balanced: 3,
  });
  assert.ok(
    measured.figures.length && measured.claims.rows.length && measured.few_robots.length && measured.refused.length,
  );
  const chords = candidates(asset("guitar"), { positions: "range" });
  assert.ok(chords.some(({ kind }) => kind === "range"));
  assert.deepEqual(
    complaintsOf(`import type { Candidate, Experiment } from "evenlift";
    export const measured: Experiment = ${JSON.stringify(measured)};
    export const chords: Candidate[] = ${JSON.stringify(chords)};\n`),
    [],
  );
});

test("the settings are those of the schema and of the manual", () => {
  const settingNames = Object.keys(JSON.parse(evenlift("--schema")).$defs.Settings.properties);
  const source = ts.createSourceFile("evenlift.d.ts", declared, ts.ScriptTarget.ES2022);
  const settings = source.statements.find(
    (statement) => ts.isInterfaceDeclaration(statement) && statement.name.text === "Settings",
  );
  const typed = settings.members.map((member) => member.name.text);
  assert.deepEqual([...typed].sort(), [...settingNames].sort());
  const [, table] = /^## Settings\n([^]*?)^## /m.exec(readFileSync(path.join(root, "docs/requests.md"), "utf8"));
  const documented = [...table.matchAll(/^\| (`.*?) \|/gm)].flatMap(([, names]) =>
    [...names.matchAll(/`(\w+)`/g)].map(([, name]) => name),
  );
  assert.deepEqual(documented.sort(), [...settingNames].sort());
});

test("what the core would refuse the compiler refuses, too", () => {
  for (const call of [
    "place()",
    "place([[0, 0, 0, 0]])",
    "place([], { tems: 2 })",
    'place([], { metric: "best" })',
    'place([], { teams: "all" })',
    "link([], { candidates: true })",
    'poses([], { format: "xml" })',
  ]) {
    assert.equal(
      complaintsOf(
        `import { link, place, poses } from "evenlift";\nexport const value = [link, place, poses, ${call}];\n`,
      ).length,
      1,
      call,
    );
  }
});
