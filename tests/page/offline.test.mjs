// Without a network, the page opens after one visit, in a sub-folder and under its policy; it loads a new version on
// request and can be installed. The server really ends.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { serve } from "../../web/serve.mjs";
import {
  asset,
  controlIfShown,
  idle,
  link,
  load,
  pageFolder,
  published,
  root,
  set,
  sharedBrowser,
  state,
} from "./browser.mjs";
import { closeAll, noticed, openWindow } from "./windows.mjs";

const browser = sharedBrowser();
const policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:";

// --- A host -----------------------------------------------------------------------------------------------------------

// A folder's service worker: the build that it lists, and the rest of its text.
function workerOf(folder) {
  const text = readFileSync(path.join(folder, "service_worker.js"), "utf8");
  const [, json] = /^const build = (\{.*\});\n/.exec(text);
  return { build: JSON.parse(json), rest: text.slice(text.indexOf("\n") + 1) };
}

// Replaces files, as another build does.
function buildAgain(folder, files) {
  const { build, rest } = workerOf(folder);
  for (const [name, text] of Object.entries(files)) writeFileSync(path.join(folder, name), text);
  const script = path.join(folder, "..", "worker.js");
  writeFileSync(script, rest);
  const names = new Set([...Object.keys(build.files), ...Object.keys(files)]);
  execFileSync("python3", [path.join(root, "assets/offline_files.py"), folder, script, ...names]);
}

// A host with the page in a folder. cut() ends it, back() starts it at the same address.
async function startHost(t) {
  const whole = mkdtempSync(path.join(tmpdir(), "evenlift-offline-"));
  const folder = path.join(whole, "course", "lifting");
  mkdirSync(folder, { recursive: true });
  cpSync(pageFolder, folder, { recursive: true });
  let server = await serve(whole, 0);
  const host = {
    folder,
    site: `${server.url}course/lifting/`,
    cut() {
      server?.close();
      server = undefined;
    },
    async back() {
      const { port, href } = new URL("/", host.site);
      server = await serve(whole, Number(port));
      assert.equal(server.url, href);
    },
  };
  t.after(() => {
    host.cut();
    rmSync(whole, { recursive: true, force: true });
  });
  return host;
}

const visit = (host, options = {}) => browser.open({ site: host.site, offline: true, ...options });

// Waits until the browser keeps the whole page.
const kept = (page) =>
  page.evaluate(async () => {
    const { serviceWorker } = navigator;
    await serviceWorker.ready;
    if (!serviceWorker.controller)
      await new Promise((done) => serviceWorker.addEventListener("controllerchange", done, { once: true }));
  });

const versionSeen = (page) => page.evaluate(async () => (await (await fetch("version.json")).json()).version);

// --- Without a network ------------------------------------------------------------------------------------------------

test("every file of the page is kept, as it was built and with the policy", async (t) => {
  const host = await startHost(t);
  const page = await visit(host);
  await kept(page);
  host.cut();
  const { build } = workerOf(host.folder);
  const names = Object.keys(build.files);
  for (const name of [
    "index.html",
    "evenlift.wasm",
    "windows.js",
    "core_worker.js",
    "core.wasm",
    "charts.js",
    "samples.json",
    "lessons.json",
    "letters-regular.otf",
    "evenlift.webmanifest",
    "icon-512.png",
  ])
    assert.ok(names.includes(name), name);
  for (const name of names) {
    const { base64, sent } = await page.evaluate(async (n) => {
      const answer = await fetch(n);
      const bytes = new Uint8Array(await answer.arrayBuffer());
      let text = "";
      for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
      return { base64: btoa(text), sent: answer.headers.get("content-security-policy") };
    }, name);
    const bytes = Buffer.from(base64, "base64");
    assert.ok(bytes.equals(readFileSync(path.join(host.folder, name))), name);
    assert.equal(createHash("sha256").update(bytes).digest("hex"), build.files[name], name);
    assert.equal(sent, policy, name);
  }
  await page.done();
});

test("after one visit it opens without a network: the work, a link, a lesson, and all that is loaded later", async (t) => {
  const host = await startHost(t);
  const page = await visit(host);
  await load(page, asset("hammer"));
  await published(page);
  await kept(page);
  const mine = await state(page);
  const address = await link(page);
  host.cut();
  const context = page.context();

  await page.reload();
  await page.evaluate(() => evenlift.ready);
  await idle(page);
  assert.deepEqual(await state(page), mine);
  await set(page, { metric: "balanced", robots: 5 }); // a worker, with the core
  await idle(page);
  assert.equal((await state(page)).robots.length, 5);
  assert.equal(await noticed(page), "");

  const samples = await openWindow(page, "samples");
  await samples.locator(".sample").nth(4).click();
  await idle(page);
  assert.notDeepEqual((await state(page)).polygon, mine.polygon);
  const save = await openWindow(page, "save");
  await save.getByRole("button", { name: "QR code" }).click();
  await page.locator("#qr img.qr").waitFor();
  await closeAll(page);
  const open = await openWindow(page, "open");
  await open
    .locator("textarea")
    .fill('<svg xmlns="http://www.w3.org/2000/svg"><rect id="table" width="120" height="80"/></svg>');
  await open.getByRole("button", { name: "Open", exact: true }).click();
  await page.waitForFunction(() => evenlift.state().polygon.length === 4);
  await openWindow(page, "experiment");
  await page.locator("#experiment").getByLabel("Random placements").fill("1");
  await page.locator("#experiment").getByLabel("Max. balanced robots").fill("3");
  await page.locator("#experiment").getByRole("button", { name: "Compare", exact: true }).click();
  await page.locator("#experiment .results figure svg").first().waitFor();
  await closeAll(page);

  for (const query of [`#${address}`, `?embed=1#${address}`, `index.html#${address}`]) {
    const other = await visit(host, { context, address: query });
    assert.deepEqual((await state(other)).polygon, mine.polygon, query);
    await other.done();
  }
  const lesson = await visit(host, { context, address: "?lesson=moved" });
  assert.ok(await controlIfShown(lesson, "timeline"), "the lesson is open");
  await lesson.done();
  assert.deepEqual(page.complaints, []);
  await context.close();
});

test("without a network the policy holds", async (t) => {
  const host = await startHost(t);
  const page = await visit(host, { quiet: false });
  await kept(page);
  host.cut();
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  const refused = await page.evaluate(
    () =>
      new Promise((done) => {
        addEventListener("securitypolicyviolation", ({ violatedDirective }) => done(violatedDirective), { once: true });
        document.head.append(
          Object.assign(document.createElement("script"), { textContent: "globalThis.slipped = true" }),
        );
      }),
  );
  assert.match(refused, /^script-src/);
  assert.equal(await page.evaluate(() => globalThis.slipped), undefined);
  await page.done();
});

// Runs before the page's own scripts: records how many frames precede the registering of the service worker.
function noteRegistering() {
  globalThis.registeredAfter = [];
  const { register } = ServiceWorkerContainer.prototype;
  ServiceWorkerContainer.prototype.register = function (...given) {
    globalThis.registeredAfter.push(evenlift.frames);
    return register.apply(this, given);
  };
}

test("nothing is kept before the first picture, nor by a figure in an article", async (t) => {
  const host = await startHost(t);
  const page = await visit(host, { script: noteRegistering });
  await kept(page);
  const [frames, ...more] = await page.evaluate(() => globalThis.registeredAfter);
  assert.ok(frames >= 1 && more.length === 0, `${frames} pictures`);
  await page.done();
  const figure = await visit(host, { address: "?embed=1", script: noteRegistering });
  await idle(figure);
  assert.deepEqual(await figure.evaluate(() => globalThis.registeredAfter), []);
  assert.equal(await figure.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length), 0);
  await figure.done();
});

// --- A new version ----------------------------------------------------------------------------------------------------

// A worker that reports the version that it sees, as the page's own would.
const probe = {
  "probe.js": 'fetch("version.json").then((answer) => answer.json()).then(({ version }) => postMessage(version));\n',
};
const edition = (version) => ({ ...probe, "version.json": `{ "version": "${version}" }\n` });
const versionOfWorker = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        new Worker("probe.js").onmessage = ({ data }) => done(data);
      }),
  );
const card = (page) => page.getByRole("region", { name: "New version" });
const mark = (page) =>
  page.evaluate(() => {
    globalThis.sameVisit = true;
  });
const sameVisit = (page) => page.evaluate(() => globalThis.sameVisit === true);
const lookForNews = (page) =>
  page.evaluate(async () => {
    await (await navigator.serviceWorker.getRegistration()).update();
  });

test("a new version says so in a sentence, is loaded by its button, and other tabs keep theirs", async (t) => {
  const host = await startHost(t);
  buildAgain(host.folder, edition("first"));
  const page = await visit(host);
  const context = page.context();
  await load(page, asset("violin"));
  await published(page);
  await kept(page);
  const other = await visit(host, { context });
  for (const each of [page, other]) await mark(each);

  buildAgain(host.folder, edition("second"));
  await lookForNews(page);
  await card(page).waitFor();
  assert.equal(
    await card(page).getByRole("status").textContent(),
    "A new version of evenlift is ready. Your work stays open.",
  );
  await idle(page);
  assert.ok(await sameVisit(page), "no reload behind the back");
  assert.equal(await versionSeen(page), "first");
  await card(other).waitFor();
  await set(page, { teams: 2 });
  await published(page);
  const mine = await state(page);

  await card(page).getByRole("button", { name: "Load it" }).click();
  await page.waitForFunction(
    () => !globalThis.sameVisit && document.getElementById("cover")?.classList.contains("done"),
  );
  await idle(page);
  assert.equal(await versionSeen(page), "second");
  assert.equal(await versionOfWorker(page), "second");
  assert.deepEqual(await state(page), mine);
  assert.equal(await card(page).count(), 0);

  // The other tab, with workers started from here on, even after the service worker was ended.
  const client = await context.newCDPSession(page);
  await client.send("ServiceWorker.enable");
  await client.send("ServiceWorker.stopAllWorkers");
  await idle(other);
  assert.ok(await sameVisit(other));
  assert.equal(await versionSeen(other), "first");
  assert.equal(await versionOfWorker(other), "first");
  host.cut();
  assert.equal(await versionOfWorker(other), "first");
  await card(other).getByRole("button", { name: "Load it" }).click();
  await other.waitForFunction(
    () => !globalThis.sameVisit && document.getElementById("cover")?.classList.contains("done"),
  );
  assert.equal(await versionSeen(other), "second");
  await other.done();
  assert.deepEqual(page.complaints, []);
  await context.close();
});

test("what was needed by the former version alone goes, and what both have is not fetched again", async (t) => {
  const host = await startHost(t);
  buildAgain(host.folder, edition("first"));
  const page = await visit(host);
  await kept(page);
  const places = () =>
    page.evaluate(async () => {
      const [name] = await caches.keys();
      return (await (await caches.open(name)).keys()).map(({ url }) => url.slice(url.lastIndexOf("/") + 1)).sort();
    });
  const before = await places();
  // The server has only changed files.
  buildAgain(host.folder, edition("second"));
  for (const name of Object.keys(workerOf(host.folder).build.files))
    if (name !== "version.json") rmSync(path.join(host.folder, name));
  await mark(page);
  await lookForNews(page);
  await card(page).getByRole("button", { name: "Load it" }).click();
  await page.waitForFunction(
    () => !globalThis.sameVisit && document.getElementById("cover")?.classList.contains("done"),
  );
  await idle(page);
  assert.equal(await versionSeen(page), "second");
  // The former version's page is closed; the next page that opens checks for that.
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  await page.waitForFunction(async (count) => {
    const [name] = await caches.keys();
    return (await (await caches.open(name)).keys()).length === count;
  }, before.length);
  const after = await places();
  const changed = after.filter((place) => !before.includes(place));
  assert.deepEqual(
    changed.map((place) => place.replace(/=.*/, "")),
    ["?files", "version.json?sha256"],
  );
  await page.done();
});

test("a version that arrives damaged is not taken, and the one that is kept goes on", async (t) => {
  const host = await startHost(t);
  buildAgain(host.folder, edition("first"));
  const page = await visit(host);
  await kept(page);
  buildAgain(host.folder, edition("second"));
  writeFileSync(path.join(host.folder, "version.json"), '{ "version": "not what was built" }\n');
  const end = await page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    const ended = new Promise((done) =>
      registration.addEventListener("updatefound", () => {
        const { installing } = registration;
        installing.addEventListener("statechange", () => done(installing.state));
      }),
    );
    await registration.update().catch(() => {});
    return ended;
  });
  assert.equal(end, "redundant");
  assert.equal(await card(page).count(), 0);
  host.cut();
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  assert.equal(await versionSeen(page), "first");
  await page.context().close();
});

test("where the host has the page no more, what is kept goes", async (t) => {
  const host = await startHost(t);
  const page = await visit(host, { quiet: false });
  await kept(page);
  writeFileSync(path.join(host.folder, "index.html"), "<!doctype html><title>Something else</title>");
  rmSync(path.join(host.folder, "service_worker.js"));
  await page.reload(); // the kept page opens once more
  await page.evaluate(() => evenlift.ready);
  await page.waitForFunction(
    async () => (await navigator.serviceWorker.getRegistrations()).length === 0 && (await caches.keys()).length === 0,
  );
  await page.goto(`${host.site}?again`);
  assert.equal(await page.title(), "Something else");
  await page.context().close();
});

test("the card of a new version waits until no other card is open, and says what would be lost", async (t) => {
  const host = await startHost(t);
  const page = await visit(host);
  await kept(page);
  const open = await openWindow(page, "open");
  await open.locator("input[type=file]").setInputFiles(path.join(host.folder, "icon-192.png"));
  const photo = page.locator("#photo");
  await photo.waitFor();
  buildAgain(host.folder, edition("second"));
  await lookForNews(page);
  await page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    if (registration.installing)
      await new Promise((done) => registration.installing.addEventListener("statechange", done, { once: true }));
  });
  await idle(page);
  assert.ok(await photo.isVisible());
  assert.equal(await card(page).count(), 0);
  await photo.getByRole("button", { name: "Close" }).click();
  await card(page).waitFor();
  assert.match(
    await card(page).getByRole("status").textContent(),
    /stays open, except for the picture behind the drawing\.$/,
  );
  await page.done();
});

// --- To be installed -----------------------------------------------------------------------------------------------------

test("it can be installed: the manifest is without fault, and icons have the sizes that it says", async (t) => {
  const host = await startHost(t);
  const page = await visit(host);
  await kept(page);
  const client = await page.context().newCDPSession(page);
  const { url, errors, data } = await client.send("Page.getAppManifest");
  assert.equal(url, `${host.site}evenlift.webmanifest`);
  assert.deepEqual(errors, []);
  assert.deepEqual((await client.send("Page.getInstallabilityErrors")).installabilityErrors, []);
  const { icons, start_url, scope } = JSON.parse(data);
  assert.equal(new URL(start_url, url).href, `${host.site}index.html`);
  assert.equal(new URL(scope, url).href, host.site);
  for (const { src, sizes, type } of icons) {
    const found = await page.evaluate(async (name) => {
      const answer = await fetch(name);
      const image = new Image();
      image.src = name;
      await image.decode();
      return { type: answer.headers.get("content-type"), size: `${image.naturalWidth}x${image.naturalHeight}` };
    }, src);
    assert.equal(found.type, type);
    if (sizes !== "any") assert.equal(found.size, sizes);
  }
  await page.done();
});
