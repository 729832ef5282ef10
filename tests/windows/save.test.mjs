import assert from "node:assert/strict";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  drag,
  evenlift,
  idle,
  jsQR,
  link,
  load,
  reload,
  root,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "../page/browser.mjs";
import { allClosed, closeAll, drop, noticed, openWindow, paste } from "../page/windows.mjs";

const browser = sharedBrowser();

// Presses a button; returns the file that the browser saves.
async function saved(page, button) {
  const coming = page.waitForEvent("download");
  await button.click();
  const download = await coming;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

// By the browser's decoder.
async function pixels(page, png) {
  const { width, height, data } = await page.evaluate(async (data) => {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]));
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const bytes = new Blob([context.getImageData(0, 0, image.width, image.height).data]);
    const coded = await new Promise((done) => {
      const reader = Object.assign(new FileReader(), { onload: () => done(reader.result) });
      reader.readAsDataURL(bytes);
    });
    return { width: image.width, height: image.height, data: coded.slice(coded.indexOf(",") + 1) };
  }, png.toString("base64"));
  return { width, height, data: Uint8ClampedArray.from(Buffer.from(data, "base64")) };
}

async function qrText(page, png) {
  const { width, height, data } = await pixels(page, png);
  return jsQR(data, width, height)?.data;
}

// With n corners and a long link.
const circle = (n) =>
  Array.from(
    { length: n },
    (_, i) => `(${1000 * Math.cos((2 * Math.PI * i) / n)},${1000 * Math.sin((2 * Math.PI * i) / n)})\n`,
  ).join("");

test("every file holds what it should, under a name that says what it is", async () => {
  const page = await browser.open({ acceptDownloads: true });
  await load(page, "CoM:(120.5,70)\n(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n");
  await set(page, { teams: 2, weight: 30 });
  const window = await openWindow(page, "save");
  const file = (name) => saved(page, window.getByRole("button", { name: new RegExp(`^${name}\\b`) }));
  const now = await state(page);

  const text = await file("Text");
  assert.deepEqual(
    [text.name, String(text.bytes)],
    ["polygon-4-robots.txt", await page.evaluate(() => evenlift.text())],
  );
  const wkt = await file("WKT");
  assert.equal(wkt.name, "polygon-4-robots.wkt");
  assert.match(String(wkt.bytes), /^POLYGON \(\(0 0, 400 0, 400 150,/);
  const geojson = await file("GeoJSON");
  assert.equal(geojson.name, "polygon-4-robots.geojson");
  const feature = JSON.parse(geojson.bytes);
  assert.deepEqual(feature.properties.centre_of_mass, [120.5, 70]);
  assert.deepEqual(feature.geometry.coordinates[0].slice(0, -1), now.polygon);
  const svg = await file("SVG");
  assert.deepEqual([svg.name, String(svg.bytes)], ["polygon-4-robots.svg", await page.evaluate(() => evenlift.svg())]);
  const json = await file("JSON");
  assert.equal(json.name, "polygon-4-robots-result.json");
  assert.deepEqual(JSON.parse(json.bytes), now);

  const csv = await file("CSV");
  assert.equal(csv.name, "polygon-4-robots.csv");
  const [head, ...rows] = String(csv.bytes)
    .trimEnd()
    .split("\n")
    .map((line) => line.split(","));
  assert.deepEqual(head, ["robot", "team", "end", "x", "y", "load", "share_of_team", "load_ratio"]);
  assert.equal(rows.length, 2 * now.teams.length);
  rows.forEach(([robot, team, end, ...numbers], i) => {
    const { ends, loads, ratio } = now.teams[Math.floor(i / 2)];
    assert.deepEqual([robot, team, end], [String(i + 1), String(1 + Math.floor(i / 2)), `r${1 + (i % 2)}`]);
    assert.deepEqual(numbers.map(Number), [...ends[i % 2], loads[i % 2], loads[i % 2] / (loads[0] + loads[1]), ratio]);
  });

  const png = await file("PNG");
  assert.equal(png.name, "polygon-4-robots.png");
  const [, width, height] = /width="(\d+)" height="(\d+)"/.exec(svg.bytes);
  const image = await pixels(page, png.bytes);
  assert.deepEqual([image.width, image.height], [2 * width, 2 * height]);
  assert.ok(new Set(image.data).size > 50, "it is not empty");

  // It opens again.
  for (const { bytes } of [text, wkt, geojson]) {
    await load(page, String(bytes));
    assert.deepEqual((await state(page)).polygon, now.polygon);
  }
  await page.done();
});

test("the name of a file says how many balanced robots there are", async () => {
  const page = await browser.open({ acceptDownloads: true });
  await load(page, "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n");
  await set(page, { metric: "balanced", robots: 5 });
  const window = await openWindow(page, "save");
  assert.equal((await saved(page, window.getByRole("button", { name: /^Text\b/ }))).name, "polygon-5-robots.txt");
  await page.done();
});

// For the open polygon, saved as text.
async function savedName(page) {
  const window = await openWindow(page, "save");
  const { name } = await saved(page, window.getByRole("button", { name: /^Text\b/ }));
  await page.keyboard.press("Escape");
  await allClosed(page);
  return name;
}

const bracket = "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n";

test("files are named after the one that was opened, as long as its polygon is open", async () => {
  const page = await browser.open({ acceptDownloads: true });
  const open = async (name, text) => {
    await drop(page, { files: [[name, text]] });
    await idle(page);
  };
  await open("bracket.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H400V-150H150V-300H0z"/></svg>');
  assert.equal(await savedName(page), "bracket-6-robots.txt");

  // Neither settings, edits, a lesson step nor a reload changes the name.
  await set(page, { teams: 2 });
  await drag(page, await toScreen(page, [400, 0]), await toScreen(page, [500, 0]));
  await page.keyboard.press("b");
  await page.keyboard.press("ArrowRight");
  await idle(page);
  assert.equal(await savedName(page), "bracket-4-robots.txt");
  await page.keyboard.press("b");
  await set(page, { teams: 3 });
  await reload(page);
  assert.equal(await savedName(page), "bracket-6-robots.txt");

  // Another sample or text is another document; undo restores the bracket's name.
  await openWindow(page, "samples");
  await page.locator("#samples .sample").filter({ hasText: "Violin" }).click();
  await allClosed(page);
  assert.equal(await savedName(page), "violin.txt");
  await page.locator("#canvas").focus();
  await undo(page);
  assert.equal(await savedName(page), "bracket-6-robots.txt");
  await paste(page, bracket.replaceAll("400", "444"));
  await idle(page);
  assert.equal(await savedName(page), "polygon-6-robots.txt");
  await page.locator("#canvas").focus();
  await page.keyboard.press("d");
  for (const at of [
    [300, 300],
    [500, 300],
    [400, 500],
  ])
    await page.mouse.click(...at);
  await page.keyboard.press("Enter");
  await idle(page);
  assert.match(await savedName(page), /^polygon-\d-robots\.txt$/);
  await page.done();
});

test("the name of an opened file is written so that any system takes it, and does not grow when files are opened again", async () => {
  const page = await browser.open({ acceptDownloads: true });
  for (const [name, expected] of [
    ["Side plate v1.2.txt", "Side-plate-v1.2-6-robots.txt"],
    ["bracket-8-robots-result.json", "bracket-6-robots.txt"],
    ["polygon-4-robots.txt", "polygon-6-robots.txt"],
    ["Träger.csv", "Träger-6-robots.txt"],
    [".txt", "polygon-6-robots.txt"],
  ]) {
    await load(page, asset("square"));
    await drop(page, { files: [[name, bracket]] });
    await idle(page);
    assert.equal(await savedName(page), expected);
  }
  await drop(page, {
    files: [["mounting plate.dxf", readFileSync(path.join(root, "tests/data/import/plate.dxf"), "utf8")]],
  });
  await page.locator("#shapes .sample").nth(1).click();
  await allClosed(page);
  assert.match(await savedName(page), /^mounting-plate-\d-robots\.txt$/, "one of several shapes");
  // As text, it is the polygon, edited; a sample opened from its file keeps its name.
  await drop(page, { files: [["bracket.v2.txt", bracket]] });
  await idle(page);
  await openWindow(page, "table");
  await page.locator("#table").getByRole("button", { name: "Edit as text" }).click();
  await page.locator("#open textarea").fill(bracket.replaceAll("150", "160"));
  await page.locator("#open").getByRole("button", { name: "Apply" }).click();
  await idle(page);
  await closeAll(page);
  assert.equal(await savedName(page), "bracket.v2-6-robots.txt");
  await drop(page, { files: [["violin-6-robots.txt", asset("violin")]] });
  await idle(page);
  assert.equal(await savedName(page), "violin.txt");
  await page.done();
});

test("poses are the program's, byte for byte", async () => {
  const page = await browser.open({ acceptDownloads: true });
  await load(page, asset("violin"));
  await set(page, { unit: "cm" });
  const window = await openWindow(page, "save");
  const folder = mkdtempSync(path.join(tmpdir(), "evenlift-poses-"));
  for (const [name, ending] of [
    ["Poses as CSV", "csv"],
    ["Poses as JSON", "json"],
    ["Poses for ROS 2", "yaml"],
  ]) {
    const poses = await saved(page, window.getByRole("button", { name: new RegExp(`^${name}`) }));
    const file = path.join(folder, `poses.${ending}`);
    evenlift("place", path.join(root, "assets/polygons/violin.txt"), "--unit", "cm", "--poses", file);
    assert.equal(poses.name, `violin-poses.${ending}`);
    assert.equal(String(poses.bytes), readFileSync(file, "utf8"));
  }
  await page.done();
});

test("the link is copied, and the button says so", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await load(page, asset("violin"));
  const window = await openWindow(page, "save");
  const address = `${browser.server.url}#${await link(page)}`;
  assert.equal(await window.locator("#link").inputValue(), address);
  assert.match(await window.getByRole("status").first().textContent(), new RegExp(`${address.length} characters`));
  assert.doesNotMatch(await window.getByRole("status").first().textContent(), /some programs/);
  await page.keyboard.press("Enter"); // the focus is on Copy
  await window.getByRole("button", { name: "Copied" }).waitFor();
  assert.match(await window.getByRole("status").first().textContent(), /^The link is copied\./);
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), address);
  await window.getByRole("button", { name: "Copy", exact: true }).waitFor();
  await page.done();
});

test("the length of the link is told wherever it is copied; a long one is not praised", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+c");
  assert.match(
    await noticed(page),
    /^The link is copied\. It holds the polygon and all settings\. It has \d+ characters\.$/,
  );
  await load(page, circle(400));
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+c");
  assert.match(
    await noticed(page),
    /^The link is copied\. It holds the polygon and all settings\. It has [\d,]+ characters: some programs cut links of 2,000 or more\. The JSON file in Save holds the same\.$/,
  );
  const window = await openWindow(page, "save");
  assert.match(await window.getByRole("status").first().textContent(), /some programs cut links of 2,000 or more/);
  await window.getByRole("button", { name: "QR code" }).click();
  await window.getByText("The link is too long for a QR code").waitFor();
  await page.done();
});

test("Save says as the copied link does what the link lacks", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.keyboard.press("d");
  await page.mouse.click(500, 400);
  await page.keyboard.press("Control+c");
  const copied = (await noticed(page)).replace(/^The link is copied\. /, "");
  assert.match(
    copied,
    /^The shape that you are drawing is not closed yet: the link holds the previous one\. It has \d+ characters\.$/,
  );
  const window = await openWindow(page, "save");
  assert.equal(await window.getByRole("status").first().textContent(), copied);
  await page.done();
});

test("a polygon that is too large for a link: the window says so and saves files", async () => {
  const page = await browser.open();
  await load(page, evenlift("generate", "regular", "--n", "33000", "--seed", "1"));
  const window = await openWindow(page, "save");
  assert.match(await window.locator(".problem").textContent(), /^There is no link: .*\. Save a file instead\.$/);
  assert.equal(await window.locator("#link").count(), 0);
  const { bytes } = await saved(page, window.getByRole("button", { name: /^Text/ }));
  assert.equal(String(bytes).trimEnd().split("\n").length, 33000);
  await page.done();
});

for (const colorScheme of ["light", "dark"]) {
  test(`the QR code is read by another program, ${colorScheme}; Escape goes back to the window below`, async () => {
    const page = await browser.open({ colorScheme });
    await load(page, asset("puzzle-piece"));
    const address = `${browser.server.url}#${await link(page)}`;
    const window = await openWindow(page, "save");
    await window.getByRole("button", { name: "QR code" }).click();
    const code = page.locator("#qr");
    await code.waitFor();
    await idle(page);
    const modules = await page.evaluate(() =>
      performance
        .getEntriesByType("resource")
        .map(({ name }) => /core\.wasm$/.exec(name)?.[0])
        .filter(Boolean),
    );
    assert.deepEqual(modules, ["core.wasm"], "nothing is fetched for it but what makes it");
    const shown = await code.locator("img").boundingBox();
    assert.ok(shown.width > 500, "large enough for a room");
    assert.equal(await qrText(page, await code.locator("img").screenshot()), address);
    const png = await saved(page, code.getByRole("button", { name: "PNG" }));
    assert.equal(png.name, "evenlift-link.png");
    assert.equal(await qrText(page, png.bytes), address);
    const svg = await saved(page, code.getByRole("button", { name: "SVG" }));
    assert.equal(svg.name, "evenlift-link.svg");
    const side = Number(/viewBox="0 0 (\d+)/.exec(svg.bytes)[1]);
    assert.ok((side - 8 - 17) % 4 === 0, "modules, and four of quiet zone on each side");
    await page.keyboard.press("Escape");
    await code.waitFor({ state: "detached" });
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "QR code");
    await page.keyboard.press("Escape");
    await allClosed(page);
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
    await page.done();
  });
}
