import assert from "node:assert/strict";
import path from "node:path";
import { afterEach, test } from "node:test";
import { mkdtemp, readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { asset, evenlift, idle, link, load, phone, root, sharedBrowser, state } from "../page/browser.mjs";
import { allClosed, closeAll, drop, noticed, openWindow, paste, violations } from "../page/windows.mjs";

let page;
const browser = sharedBrowser({
  begin: async () => {
    page = await browser.open();
  },
  end: () => page.done(),
});

// An open window must not affect the next test.
afterEach(() => closeAll(page));

const triangle = [
  [0, 0],
  [40, 0],
  [10, 30.5],
];
const svg = (inside, more = "") => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 50 50"${more}>${inside}</svg>`;

// In all formats that are read.
const good = {
  thesis: "(0,0)\n(40,0)\n(10,30.5)\n",
  WKT: "POLYGON ((0 0, 40 0, 10 30.5, 0 0))",
  GeoJSON: '{"type":"Polygon","coordinates":[[[0,0],[40,0],[10,30.5],[0,0]]]}',
  "columns with commas": "0,0\n40,0\n10,30.5\n",
  "columns of a spreadsheet": "x\ty\n0\t0\n40\t0\n10\t30,5\n",
  "CSV with decimal commas": "# measured\nPunkt;x;y\nA;0;0\nB;40;0\nC;10;30,5\n",
  "JSON points": "[[0,0],[40,0],[10,30.5]]",
  "a collection":
    '{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"MultiPolygon","coordinates":[[[[0,0],[40,0],[10,30.5],[0,0]]]]}}]}',
  DXF: "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n40\n20\n0\n10\n10\n20\n30.5\n0\nENDSEC\n0\nEOF\n",
  "SVG polyline": svg('<polyline points="0,0 40,0 10-30.5"/>'),
  "SVG polygon": svg('<polygon points="0,0 40,0 10-30.5"/>'),
  "SVG path": svg('<path d="M0 0L40 0 10,-30.5Z"/>'),
  "SVG path, relative": svg('<path d="m0,0h40l-30-30.5z"/>'),
  "SVG path, open": svg('<path d="M0 0H40V0L1e1-30.5"/>').replace("V0", ""),
  "SVG path, vertical": svg('<path d="M10-30.5V-30.5L0 0h40z"/>').replace("V-30.5", ""),
  "SVG with transforms": svg(
    '<g transform="translate(1 2)"><g transform="scale(2)rotate(90 1 1)"><polygon transform="translate(-.5,-1) scale(.5) rotate(-90, 2, 2)" points="0,0 40,0 10,-30.5"/></g></g>',
  ),
  "SVG with prefixes": `<s:svg xmlns:s="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"><s:polygon s:points="" xlink:href="#a" points="0,0 40,0 10-30.5"/></s:svg>`,
  "SVG with styles, handlers and scripts": svg(
    '<style>polygon { fill: red }</style><script>alert(1)</script><image href="nowhere.png"/><foreignObject><p xmlns="http://www.w3.org/1999/xhtml" style="color: red" onclick="alert(1)">text</p></foreignObject><polygon style="fill:red" onload="alert(1)" points="0,0 40,0 10-30.5"/>',
    ' style="color:red" onload="alert(1)"',
  ),
  "SVG with characters as numbers": svg('<polygon points="&#x30;,0&#32;40,0 1&#48;-30.5"/>'),
  "SVG without a namespace": '<svg><polygon xlink:href="#a" points="0,0 40,0 10-30.5"/></svg>',
  "SVG with a heading": `<?xml version="1.0"?>\n<!-- a drawing -->\n${svg('<defs><path d="M0 0C1 1 2 2 3 3"/></defs><title>T</title><text>a</text><polygon points="0 0 40 0 10 -30.5 0 0"/>')}`,
};

const polygon = async () => (await state(page)).polygon;
async function isTriangle(what) {
  await page.waitForFunction(() => evenlift.state().polygon.length === 3);
  const now = await polygon();
  const start = now.findIndex(
    ([x, y]) =>
      Math.hypot(x - now[0][0], y - now[0][1]) < 1e9 &&
      Math.abs(y - Math.min(...now.map((p) => p[1]))) < 1e-9 &&
      Math.abs(x - Math.min(...now.map((p) => p[0]))) < 1e-9,
  );
  const turned = [0, 1, 2].map((i) => now[(start + i) % 3]);
  const [ox, oy] = turned[0];
  turned.forEach(([x, y], i) =>
    assert.ok(Math.hypot(x - ox - triangle[i][0], y - oy - triangle[i][1]) < 1e-9, `${what}: ${JSON.stringify(now)}`),
  );
}

for (const [format, text] of Object.entries(good)) {
  test(`${format}: dropped as a file, pasted, and typed`, async () => {
    for (const how of ["drop", "paste", "type"]) {
      await load(page, asset("cross"));
      await page.locator("#canvas").focus();
      if (how === "drop") await drop(page, { files: [["a file", text]] });
      else if (how === "paste") await paste(page, text);
      else {
        const root = await openWindow(page, "open");
        await root.locator("textarea").fill(text);
        await root.getByRole("button", { name: "Open" }).click();
      }
      await isTriangle(`${format}, ${how}`);
      await allClosed(page);
      await idle(page);
      await page.keyboard.press("Control+z");
      assert.equal((await polygon()).length, 12, "undo");
    }
  });
}

test("SVG without a transform is taken to the last bit", async () => {
  await drop(page, { files: [["a.svg", svg('<path d="M.1 .2 12345.6789 0 7e-3 -99.30000000000001z"/>')]] });
  await page.waitForFunction(() => evenlift.state().polygon[0][0] === 0.1);
  assert.deepEqual(await polygon(), [
    [0.1, -0.2],
    [12345.6789, 0],
    [0.007, 99.30000000000001],
  ]);
});

test("a chosen file", async () => {
  await load(page, asset("cross"));
  const root = await openWindow(page, "open");
  const chooser = page.waitForEvent("filechooser");
  await root.getByRole("button", { name: "Choose a file" }).click();
  await (
    await chooser
  ).setFiles({ name: "plate.geojson", mimeType: "application/geo+json", buffer: Buffer.from(good.GeoJSON) });
  await isTriangle("chosen");
  assert.match(
    await noticed(page),
    /“plate.geojson” is opened\. By the standard of GeoJSON its coordinates are degrees .* Undo/,
  );
});

test("links, bare and whole, come with their settings", async () => {
  const made = evenlift("link", "encode", path.join(root, "assets/polygons/key.txt"), "--teams", "2").trim();
  for (const text of [made, `https://example.org/x/index.html#${made}`, ` ${browser.server.url}#${made}\n`]) {
    await load(page, asset("cross"));
    await page.locator("#canvas").focus();
    await paste(page, text);
    await page.waitForFunction((l) => evenlift.link() === l, made);
    assert.equal((await state(page)).requested_teams, 2);
  }
});

test("the system's clipboard, by Ctrl+V on the canvas", async () => {
  const other = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await other.evaluate((text) => navigator.clipboard.writeText(text), good.WKT);
  await other.locator("#canvas").focus();
  await other.keyboard.press("Control+v");
  await other.waitForFunction(() => evenlift.state().polygon.length === 3);
  await other.done();
});

test("pasting into a field is the field's", async () => {
  const before = await link(page);
  const root = await openWindow(page, "open");
  await root.locator("textarea").focus();
  await paste(page, good.WKT);
  assert.equal(await link(page), before);
  await page.keyboard.press("Escape");
});

const triangleShape = '<polygon points="0,0 4,0 4,4"/>';
const bad = [
  ["", /empty/i],
  [" \n ", /empty/i],
  ["hello", /in an unknown format: evenlift reads lines/],
  ["(0,0)\n(1,0)\n(1;1)\n", /line 3/i],
  ["(0,0)\n(1,0)\n", /at least 3 vertices/i],
  ["(0,0)\n(4,4)\n(4,0)\n(0,4)\n", /edges 1 and 3/i],
  ["LINESTRING (0 0, 4 0, 4 4)", /no polygon, only 1 Linestring/],
  ["v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", /a mesh \(OBJ\)/],
  ["1.abcdefgh", /link/i],
  ["(0,0)\n\0", /not text/i],
  ["<html></html>", /not SVG.*<html>/],
  ["<svg", /not well-formed/],
  ["<svg>\n<g></svg>", /not well-formed/],
  ["<svg><polygon points='0 0'", /not well-formed/],
  ["</>", /not well-formed/],
  ["<!-- no element -->", /not well-formed/],
  ["<!-- no end", /not well-formed/],
  [`${svg(triangleShape)}${svg("")}`, /not well-formed/],
  [svg('<polygon points="0,0 4,0 4,&#x10034;"/>'), /character 11: not a number/],
  [
    '<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "b">]><svg xmlns="http://www.w3.org/2000/svg"><polygon points="&a;"/></svg>',
    /character 1: not a number/,
  ],
  [svg(""), /no closed shape/],
  [svg("<text>a</text>"), /no closed shape, only 1 text \(in Inkscape: Path, Object to Path/],
  [svg('<path d="M0 0L1 1"/><path d="M0 0L1 1"/>'), /no closed shape/],
  [
    "0\nSECTION\n2\nENTITIES\n0\nLINE\n11\n5\n0\nENDSEC\n0\nEOF\n",
    /DXF drawing has no closed outline: the nearest open ends, \(0, 0\) and \(5, 0\), are 5 apart/,
  ],
  ["robot,team,end,x,y,load\n1,1,r1,0,0,5\n", /the robots of a result, not a polygon: open the JSON/],
  ["1,5 2,3\n2,5 4,3\n", /write decimals with a point/],
  ['{"type":"Point","coordinates":[1,2]}', /no polygon, only 1 Point/],
  [svg('<path d="L0 0 1 1"/>'), /character 1/],
  [svg('<path d="M0 0L4 0 4"/>'), /character 11: expected a number here/],
  [svg('<path d="M0 0L4 0 x 4"/>'), /character \d+: expected a command/],
  [svg('<polygon points="0,0 4,0 4"/>'), /no y/],
  [svg('<polygon points="0,0 4,0 4,z"/>'), /character 11: not a number/],
  [svg('<polygon transform="perspective(3)" points="0,0 4,0 4,4"/>'), /transform "perspective\(3\)" is not understood/],
  [svg('<polygon transform="constructor(1)" points="0,0 4,0 4,4"/>'), /transform "constructor\(1\)" is not understood/],
  [svg('<polygon transform="scale(1 2 3)" points="0,0 4,0 4,4"/>'), /transform "scale\(1 2 3\)" is not understood/],
  [svg('<polygon transform="scale(1 x)" points="0,0 4,0 4,4"/>'), /transform "scale\(1 x\)" is not understood/],
  [svg('<g transform="rotate(3"><polygon points="0,0 4,0 4,4"/></g>'), /transform "rotate\(3" is not understood/],
  [svg('<polygon style="rotate:3deg" points="0,0 4,0 4,4"/>'), /by the style “?"?rotate/],
  [svg('<style>polygon{scale:2}</style><polygon points="0,0 4,0 4,4"/>'), /by the style “?"?scale/],
];

test("what is wrong is said in one sentence, and nothing changes", async () => {
  await load(page, asset("cross"));
  const before = JSON.stringify(await state(page));
  for (const [text, pattern] of bad) {
    const root = await openWindow(page, "open");
    await root.locator("textarea").evaluate((area, value) => {
      area.value = value;
    }, text);
    await root.getByRole("button", { name: "Open" }).click();
    await idle(page);
    const said = await root.locator(".problem").textContent();
    assert.match(said, pattern, text.slice(0, 60));
    assert.match(said, /^[A-Z“1][^\n]*[^.]\.$/, said);
    assert.equal(JSON.stringify(await state(page)), before);
    await page.keyboard.press("Escape");
    await root.waitFor({ state: "detached" });
  }
});

const data = (name) => readFile(path.join(root, "tests/data/import", name), "utf8");
const shapes = (where) => where.locator("#shapes .sample");
const openLines = (where) =>
  where.locator("#shapes .drawing .open").evaluateAll((paths) => paths.map((each) => each.getAttribute("d")));
const focused = (where) => where.evaluate(() => document.activeElement.dataset.index);

test("the sheet of a drawing is offered last, and its parts first", async () => {
  const frame = 'fill="none" stroke="black"';
  const drawing = svg(
    `<rect width="50" height="50" fill="white"/><rect x="3" y="3" width="9" height="9" ${frame}/>` +
      `<rect x="15" y="5" width="30" height="20" ${frame}/><circle cx="25" cy="15" r="4" ${frame}/>`,
  );
  await drop(page, { files: [["sheet.svg", drawing]] });
  await shapes(page).first().waitFor();
  await idle(page);
  assert.deepEqual(await shapes(page).allTextContents(), [
    "rectangle 4 vertices, 1 hole, 30 × 20 on the sheet",
    "rectangle 4 vertices, 9 × 9 on the sheet",
    "sheet, rectangle 4 vertices, 50 × 50",
  ]);
  assert.equal(await focused(page), "0", "not the sheet, though it is larger");
});

test("of several shapes one is chosen, by the keys or a click", async () => {
  await load(page, asset("cross"));
  await drop(page, { files: [["layers.svg", await data("layers.svg")]] });
  await shapes(page).first().waitFor();
  await idle(page);
  assert.deepEqual(await shapes(page).allTextContents(), [
    "Layer 1 path 57 vertices, 1 hole, 130.8 × 122",
    "wheel circle 64 vertices, 80 × 80",
    "plate rectangle with round corners 20 vertices, 100 × 50",
  ]);
  assert.match(
    await page.locator("#shapes .second").first().textContent(),
    /^Lengths are in millimetres\. 1 text, 1 copy \(<use>\) without an original and 1 hidden element were left out\.$/,
  );
  assert.equal((await polygon()).length, 12, "nothing is opened yet");
  assert.deepEqual(await openLines(page), []);
  assert.match(
    await page.locator("#shapes").textContent(),
    /“layers\.svg” has 3 shapes\. Choose the one to open\..*Keep edges within of the curves, in millimetres/s,
  );
  assert.equal(await focused(page), "0", "the largest comes first");
  for (const [key, at] of [
    ["ArrowRight", "1"],
    ["End", "2"],
    ["Home", "0"],
    ["ArrowLeft", "0"],
    ["ArrowRight", "1"],
  ]) {
    await page.keyboard.press(key);
    assert.equal(await focused(page), at, key);
  }
  await page.keyboard.press("Enter");
  assert.match(
    await noticed(page),
    /^“layers\.svg” is opened\. Curves were flattened to within 0\.05 millimetres, which “Open” can change\. Undo/,
  );
  assert.equal((await polygon()).length, 64);
  await allClosed(page);
  await page.keyboard.press("Control+z");
  assert.equal((await polygon()).length, 12);
  await drop(page, { files: [["layers.svg", await data("layers.svg")]] });
  await shapes(page).nth(2).click();
  await idle(page);
  assert.equal((await polygon()).length, 20);
});

test("shapes on a sheet and in holes show where they lie, and the largest part is offered", async () => {
  await load(page, asset("cross"));
  const text = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400"><rect width="600" height="400" fill="white"/>
    <g fill="none" stroke="black"><rect x="50" y="50" width="300" height="220"/><rect x="100" y="90" width="180" height="120"/>
    <rect x="160" y="110" width="80" height="80"/><rect x="190" y="140" width="20" height="20"/></g></svg>`;
  await drop(page, { files: [["levels.svg", text]] });
  await shapes(page).first().waitFor();
  await idle(page);
  assert.deepEqual(await shapes(page).allTextContents(), [
    "rectangle 4 vertices, 1 hole, 300 × 220 on the sheet",
    "rectangle 4 vertices, 1 hole, 80 × 80 inside another shape",
    "sheet, rectangle 4 vertices, 600 × 400",
  ]);
  const pictures = (at) => shapes(page).nth(at).locator("svg").count();
  assert.deepEqual(
    [await pictures(0), await pictures(1), await pictures(2)],
    [2, 3, 1],
    "sheet › plate › part in its hole",
  );
  assert.equal(await focused(page), "0");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).holes.length, 1);
});

test("a typed text of several shapes is still there if none is chosen", async () => {
  const text = `<svg viewBox="0 0 9 9"><path d="M0 0h2v2h-2z"/><path d="M4 4h3v3h-3z"/></svg>`;
  const typed = await openWindow(page, "open");
  await typed.locator("textarea").fill(text);
  await typed.getByRole("button", { name: "Open" }).click();
  await shapes(page).first().waitFor();
  await page.keyboard.press("Escape");
  await allClosed(page);
  const again = await openWindow(page, "open");
  assert.equal(await again.locator("textarea").inputValue(), text);
  await again.getByRole("button", { name: "Open" }).click();
  await shapes(page).first().click();
  await allClosed(page);
  assert.equal(await (await openWindow(page, "open")).locator("textarea").inputValue(), "");
  await page.keyboard.press("Escape");
  await allClosed(page);
});

test("all shapes of a file are a table with robots of their own, which sorts, opens and is saved", async () => {
  const drawing = await readFile(path.join(root, "examples/sheet/sheet.dxf"), "utf8");
  await drop(page, { files: [["sheet.dxf", drawing]] });
  await page.getByRole("button", { name: "All in a table" }).click();
  const parts = page.locator("#parts");
  const cells = (column) => parts.locator(`tbody tr > :nth-child(${column})`).allTextContents();
  const place = async () => {
    await parts.getByRole("button", { name: "Place robots" }).click();
    await idle(page);
  };
  await parts.waitFor();
  await idle(page);
  assert.deepEqual((await cells(3)).slice(0, 3), ["P001", "P002", "P003"], "in the order of the file");
  assert.equal((await cells(3)).length, 200);
  assert.ok((await cells(5)).every((weight) => weight === "100"));
  assert.deepEqual(await violations(page), []);

  await parts.getByLabel("Density").fill("steel");
  await parts.getByLabel("Thickness").fill("8");
  await place();
  assert.match(await parts.locator(".problem").textContent(), /^The density must be a number above 0.*“?"?steel/);
  await parts.getByLabel("Density").fill("7850/m3");
  await parts.getByLabel("A robot carries").fill("0,25");
  await place();
  assert.equal(await parts.locator(".problem").textContent(), "");
  const download = page.waitForEvent("download");
  await parts.getByRole("button", { name: "Save as CSV" }).click();
  const saved = await download;
  assert.equal(saved.suggestedFilename(), "sheet-parts.csv");
  const table = path.join(await mkdtemp(path.join(tmpdir(), "evenlift-")), "parts.csv");
  const steel = ["--thickness", "8", "--density", "7850/m3", "--capacity", "0.25"];
  evenlift("place", path.join(root, "examples/sheet/sheet.dxf"), "--shape", "all", ...steel, "--csv", table);
  assert.equal(await readFile(await saved.path(), "utf8"), await readFile(table, "utf8"));

  await parts.getByRole("button", { name: "Weight", exact: true }).click();
  const weights = (await cells(5)).map(Number);
  assert.deepEqual(
    weights,
    weights.toSorted((a, b) => b - a),
  );
  await parts.getByRole("button", { name: "Weight", exact: true }).click();
  assert.deepEqual((await cells(5)).map(Number), weights.toReversed());
  const [name] = await cells(3);
  await parts.locator("tbody button").first().click();
  assert.match(await noticed(page), new RegExp(`^${name} of “sheet\\.dxf” is opened`));
  const opened = await state(page);
  assert.ok(Math.abs(opened.weight - weights.at(-1)) < 1e-3 && opened.capacity.limit === 0.25);

  // Later again, and nothing is computed any more once the window is closed.
  await (await openWindow(page, "open")).getByRole("button", { name: "All in a table" }).click();
  await parts.waitFor();
  await page.keyboard.press("Escape");
  await allClosed(page);
});

test("how near the edges are to curves can be set, before and after", async () => {
  await drop(page, { files: [["layers.svg", await data("layers.svg")]] });
  await shapes(page).first().waitFor();
  const field = page.locator("#shapes .curves input");
  assert.match(await field.getAttribute("placeholder"), /^0\.05 to 0\.1$/);
  for (const wrong of ["0", "-1", "x"]) {
    await field.fill(wrong);
    await field.press("Enter");
    await idle(page);
    assert.match(await page.locator("#shapes .problem").textContent(), /must be a number above 0, in .*, not “.*”\.$/);
  }
  await field.fill("0,001");
  await field.press("Enter");
  await idle(page);
  assert.equal(await page.locator("#shapes .problem").textContent(), "");
  assert.match(await shapes(page).nth(1).textContent(), /512 vertices/);
  await shapes(page).nth(1).click();
  await idle(page);
  assert.equal((await polygon()).length, 512);

  await drop(page, { files: [["wheel.svg", svg('<circle r="40"/>')]] });
  assert.match(
    await noticed(page),
    /^“wheel\.svg” is opened\. Curves were flattened to within 0\.05 units of the drawing/,
  );
  assert.equal((await polygon()).length, 64);
  const open = await openWindow(page, "open");
  assert.match(
    await open.textContent(),
    /The curves of “wheel\.svg” were flattened to within 0\.05 units of the drawing\./,
  );
  await open.getByRole("button", { name: "Change" }).click();
  await shapes(page).first().waitFor();
  assert.equal(await field.inputValue(), "0.05");
  await field.fill("1");
  await field.press("Enter");
  await idle(page);
  await shapes(page).first().click();
  await idle(page);
  assert.equal((await polygon()).length, 16);
});

test("a saved result opens with all its settings, and a picture by the link in it", async () => {
  const made = evenlift(
    "link",
    "encode",
    path.join(root, "assets/polygons/key.txt"),
    "--metric",
    "random",
    "--seed",
    "18446744073709551615",
    "--teams",
    "2",
  ).trim();
  const result = evenlift("place", made, "--capacity", "30", "--json");
  const limited = evenlift("link", "encode", made, "--capacity", "30").trim();
  await load(page, asset("cross"));
  await drop(page, { files: [["evenlift-result.json", result]] });
  await page.waitForFunction((l) => evenlift.link() === l, limited);
  await idle(page);
  assert.equal((await state(page)).capacity.limit, 30);
  await load(page, asset("cross"));
  await drop(page, { files: [["picture.svg", svg(`<metadata>${made}</metadata><rect width="3" height="4"/>`)]] });
  await page.waitForFunction((l) => evenlift.link() === l, made);
});

test("a drawing of a CAD program, chosen as a file", async () => {
  const window = await openWindow(page, "open");
  assert.match(await page.locator("#open-file").getAttribute("accept"), /\.csv.*\.dxf/);
  const chooser = page.waitForEvent("filechooser");
  await window.getByRole("button", { name: "Choose a file" }).click();
  await (await chooser).setFiles(path.join(root, "tests/data/import/plate.dxf"));
  await shapes(page).first().waitFor();
  assert.match(
    await page.locator("#shapes .second").first().textContent(),
    /^Lengths are in millimetres\. 1 line or arc does not close/,
  );
  assert.match(await page.locator("#shapes .curves").textContent(), /of the curves, in millimetres/);
  const [line] = await openLines(page);
  assert.match(line, /^M[\d. -]+L[\d. -]+$/, "the line that does not close is drawn, dashed");
  await shapes(page).nth(1).click();
  assert.match(await noticed(page), /^“plate\.dxf” is opened\. Curves were flattened to within 0\.01 millimetres/);
  assert.equal((await state(page)).unit, "mm");
});

test("files that are no texts are refused with what to do", async () => {
  const bytes = (name, list) =>
    page.evaluate(
      ([called, numbers]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([new Uint8Array(numbers)], called));
        dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true }));
      },
      [name, list],
    );
  const codes = (text) => Array.from(text, (c) => c.charCodeAt(0));
  for (const [name, list, pattern] of [
    ["a.png", [0x89, ...codes("PNG\r\n"), 0], /damaged, or this browser/],
    ["a.jpg", [0xff, 0xd8, 0xff, 0xe0], /damaged, or this browser/],
    ["a.gif", codes("GIF89a"), /PNG, JPEG and WebP can/],
    ["a.pdf", codes("%PDF-1.7\n"), /PDF.*Inkscape/],
    ["a.xlsx", [...codes("PK"), 3, 4, 20, 0], /save the sheet as CSV/],
    ["a.dxf", [...codes("AutoCAD Binary DXF\r\n"), 26, 0], /ASCII DXF/],
    ["zeros", [0, 0, 0], /not text/],
  ]) {
    await bytes(name, list);
    assert.match(await noticed(page), pattern, name);
  }
  await bytes("unicode.txt", [0xff, 0xfe, ...[..."0\t0\n4\t0\n4\t3\n"].flatMap((c) => [c.charCodeAt(0), 0])]);
  await page.waitForFunction(() => evenlift.state().polygon.length === 3);
});

test("what reads drawings is fetched when the first one is opened", async () => {
  const other = await browser.open();
  const fetched = () =>
    other.evaluate(
      () => performance.getEntriesByType("resource").filter(({ name }) => name.includes("core.wasm")).length,
    );
  await drop(other, { text: good.thesis });
  await idle(other);
  assert.equal((await state(other)).polygon.length, 3);
  assert.equal(await fetched(), 0);
  await drop(other, { text: good["columns with commas"] });
  await idle(other);
  assert.ok((await fetched()) > 0);
  await other.done();
});

test("a large picture is read, and one that is nested without end does no harm", async () => {
  const corners = 20000;
  const d = Array.from(
    { length: corners },
    (_, i) =>
      `${i ? "L" : "M"}${(100 * Math.cos((2 * Math.PI * i) / corners)).toFixed(6)} ${(100 * Math.sin((2 * Math.PI * i) / corners)).toFixed(6)}`,
  ).join("");
  await drop(page, { files: [["circle.svg", svg(`<g>${"<a b='c'></a>".repeat(50000)}</g><path d="${d}z"/>`)]] });
  await noticed(page);
  assert.equal((await polygon()).length, corners);
  await drop(page, { files: [["deep.svg", `${"<svg>".repeat(300000)}`]] });
  assert.match(await noticed(page), /not well-formed/);
});

test("texts made to keep a reader busy are refused soon", async () => {
  const long = "a".repeat(4e6);
  const texts = [
    svg(`<polygon transform="${long}" points="0,0 4,0 4,4"/>`),
    `${"<!--".repeat(1e6)}<svg/>`,
    `<!DOCTYPE ${long}`,
    `<svg ${long}`,
    svg(`<defs>${"<path/>".repeat(4e5)}</defs>`),
  ];
  for (const [i, text] of texts.entries()) {
    await drop(page, { files: [[`busy-${i}.svg`, text]] });
    assert.match(await noticed(page), new RegExp(`^“busy-${i}\\.svg” cannot be opened: .{10,150}$`));
  }
});

test("bad files and texts dropped or pasted are a notice", async () => {
  await load(page, asset("cross"));
  const before = JSON.stringify(await state(page));
  await page.locator("#canvas").focus();
  await drop(page, { files: [["plate.svg", svg('<path d="M0 0Q1 1 2 2z"/>')]] });
  assert.match(await noticed(page), /^“plate\.svg” cannot be opened: this SVG has no closed shape/);
  await paste(page, "(0,0)\n(1,1)\n(2");
  assert.match(await noticed(page), /^The pasted text cannot be opened: line 3/);
  await drop(page, { text: "nothing" });
  assert.match(await noticed(page), /^The dropped text cannot be opened/);
  await drop(page, {
    files: [
      ["a", "1"],
      ["b", "2"],
    ],
  });
  assert.match(await noticed(page), /^Please open one file at a time\.$/);
  assert.equal(JSON.stringify(await state(page)), before);
});

test("files beyond 64 MiB are refused unread", async () => {
  await page.evaluate(() => {
    const file = new File([new Uint8Array(64 * 1024 * 1024 + 1)], "large.txt");
    file.arrayBuffer = () => {
      throw new Error("was read");
    };
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(file);
    dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true }));
  });
  assert.match(await noticed(page), /“large\.txt” cannot be opened: it has 65 MiB/);
});

test("a drop is shown where it will be taken, above an open window, too", async () => {
  await openWindow(page, "open");
  const data = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(["(0,0)"], "x"));
    return transfer;
  });
  await page.dispatchEvent("#canvas", "dragover", { dataTransfer: data });
  await page.locator("#drop-hint").waitFor();
  assert.ok(await page.evaluate(() => document.getElementById("drop-hint").matches(":popover-open")));
  await page.dispatchEvent("#canvas", "drop", { dataTransfer: data });
  await page.locator("#drop-hint").waitFor({ state: "detached" });
  await idle(page);
  assert.match(await page.locator("#open .problem").textContent(), /“x” cannot be opened: .*at least 3/);
  await page.keyboard.press("Escape");
});

test("Escape in the window changes nothing; Ctrl+Enter opens", async () => {
  const root = await openWindow(page, "open");
  await page.keyboard.type(good.thesis);
  await page.keyboard.press("Control+Enter");
  await root.waitFor({ state: "detached" });
  await isTriangle("Ctrl+Enter");
  assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
});

test("embedded, the page takes nothing in", async () => {
  const embedded = await browser.open({ address: "?embed=1" });
  const before = await link(embedded);
  await embedded.locator("#canvas").focus();
  await paste(embedded, good.WKT);
  await idle(embedded);
  assert.equal(await link(embedded), before);
  await embedded.done();
});

test("under a finger on a phone", async () => {
  const small = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  const root = await openWindow(small, "open");
  await root.locator("textarea").fill(good.WKT);
  await root.getByRole("button", { name: "Open" }).tap();
  await small.waitForFunction(() => evenlift.state().polygon.length === 3);
  await small.done();
});
