// The page on all kinds of screens and without one.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import {
  asset,
  axe,
  evenlift,
  fragment,
  idle,
  link,
  load,
  phone,
  press,
  sample,
  set,
  sharedBrowser,
  startBrowser,
  state,
  thrown,
  wide,
} from "./browser.mjs";
import { loaded, total } from "./sizes.mjs";

const browser = sharedBrowser();

const canvasSize = (page) =>
  page.evaluate(() => {
    const canvas = document.getElementById("canvas");
    return [canvas.width, canvas.height];
  });

for (const ratio of [1, 1.5, 2, 3]) {
  test(`${ratio} device pixels for a CSS pixel: the canvas has them all`, async () => {
    const page = await browser.open({ deviceScaleFactor: ratio });
    assert.deepEqual(await canvasSize(page), [wide.width * ratio, wide.height * ratio]);
    await page.done();
  });
}

test("it follows the window's size and a change of the device-pixel ratio", async () => {
  const page = await browser.open();
  await page.setViewportSize({ width: 1000, height: 700 });
  await idle(page);
  assert.deepEqual(await canvasSize(page), [1000, 700]);
  const client = await page.context().newCDPSession(page);
  await client.send("Emulation.setDeviceMetricsOverride", {
    width: 1000,
    height: 700,
    deviceScaleFactor: 2,
    mobile: false,
  });
  await page.mouse.move(500, 300); // the browser sends an event on a real screen only
  await page.waitForFunction(() => document.getElementById("canvas").width === 2000);
  await idle(page);
  assert.deepEqual(await canvasSize(page), [2000, 1400]);
  await page.done();
});

test("the object stays in sight when the window changes, and everything is within it on a phone", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  await idle(page);
  const seen = () =>
    page.evaluate(() =>
      evenlift.state().polygon.every((p) => {
        const [x, y] = evenlift.view.to_screen(...p);
        return x >= 0 && x <= innerWidth && y >= 0 && y <= innerHeight;
      }),
    );
  assert.ok(await seen());
  await page.setViewportSize({ width: phone.height, height: phone.width });
  await idle(page);
  assert.ok(await seen());
  await page.done();
});

test("light and dark follow the system while the page runs", async () => {
  const page = await browser.open({ drawn: true });
  await idle(page);
  const bright = await lightness(page);
  await page.emulateMedia({ colorScheme: "dark" });
  await idle(page);
  const dark = await lightness(page);
  assert.ok(bright > 0.8 && dark < 0.25, `${bright} and ${dark}`);
  await page.done();
});

// Of the background, in an empty corner.
async function lightness(page) {
  const other = await browser.browser.newPage();
  const png = (await page.screenshot({ clip: { x: 4, y: 300, width: 8, height: 8 } })).toString("base64");
  const value = await other.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d");
    context.drawImage(image, 0, 0, 1, 1);
    const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
    return (r + g + b) / 765;
  }, png);
  await other.close();
  return value;
}

test("a lost WebGL context comes back with everything on it", async () => {
  const page = await browser.open({ drawn: true });
  await idle(page);
  const before = await page.screenshot();
  await page.evaluate(() => {
    globalThis.extension = document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
    globalThis.extension.loseContext();
  });
  await page.waitForFunction(() => !document.getElementById("cover").classList.contains("done"));
  await page.evaluate(() => evenlift.set({ teams: 3 })); // the program continues without a canvas
  await page.evaluate(() => globalThis.extension.restoreContext());
  await page.waitForFunction(() => document.getElementById("cover").classList.contains("done"));
  await idle(page);
  const { share } = await browser.compare(before, await page.screenshot());
  assert.ok(share < 0.001, `${share} of the picture differs`);
  await page.done();
});

test("without WebAssembly it says so", async () => {
  const page = await browser.open({
    ready: false,
    quiet: false,
    script: () => {
      delete globalThis.WebAssembly;
    },
  });
  assert.match(
    await page.evaluate(() =>
      evenlift.ready.then(
        () => "ready",
        (error) => error.message,
      ),
    ),
    /WebAssembly/,
  );
  assert.ok(await page.locator("#problem").isVisible());
  await page.done();
});

test("without JavaScript there is a word about it", async () => {
  const page = await browser.open({ ready: false, javaScriptEnabled: false });
  assert.match(await page.locator("body").textContent(), /JavaScript/);
  await page.done();
});

test("it runs in a sub-folder of a static host, under its policy", async () => {
  const response = await fetch(browser.server.url);
  assert.equal(
    response.headers.get("content-security-policy"),
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:",
  );
  const html = await response.text();
  assert.doesNotMatch(html, /(?:src|href)="(?:\/|https?:)/, "only relative addresses");
  assert.doesNotMatch(html, /<script(?![^>]*src)|<style|\son\w+=|style="/, "nothing inline");
});

test("it has nothing in the console from start to end of a session", async () => {
  const page = await browser.open();
  await load(page, "(0,0)\n(10,0)\n(10,10)\n(0,10)");
  await page.mouse.move(500, 400);
  await page.mouse.wheel(0, 200);
  await idle(page);
  assert.equal((await state(page)).polygon.length, 4);
  await page.done();
});

test("embedded it shows the drawing and a link out, and no panel", async () => {
  const page = await browser.open({ address: "?embed=1", viewport: { width: 640, height: 420 } });
  await idle(page);
  const seen = await page.evaluate(() =>
    evenlift.state().polygon.every((p) => {
      const [x, y] = evenlift.view.to_screen(...p);
      return x >= 0 && x <= innerWidth && y >= 0 && y <= innerHeight;
    }),
  );
  assert.ok(seen);
  const [popup] = await Promise.all([page.waitForEvent("popup"), press(page, "out")]);
  await popup.waitForLoadState();
  const url = new URL(popup.url());
  assert.equal(url.search, "");
  await page.done();
});

test("what the page loads until it is ready is at most 758,600 bytes after compression", async () => {
  const page = await browser.open();
  const files = await loaded(page);
  assert.ok(files.some(({ name }) => name === "evenlift.wasm"));
  assert.ok(total(files) <= 758600, `${total(files)} bytes: ${files.map(({ name, bytes }) => `${name} ${bytes}`)}`);
  await page.done();
});

// --- Without WebGL 2: the still picture -----------------------------------------------------------------------------

const encoded = (name, ...options) => evenlift("link", "encode", sample(name), ...options).trim();
const verdict = (name, ...options) => evenlift("place", sample(name), ...options).split("\n")[0];
// Two vertices are at one place.
const refusedLink = "1.KmDRFlKatH44ZmxgIVCLZ23kF5N";

const withoutWebGl = () => {
  const before = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind === "2d" ? before.call(this, kind, ...rest) : null;
  };
  const address = URL.createObjectURL;
  URL.createObjectURL = (blob) => address((globalThis.lastBlob = blob));
};
const open = (options) => browser.open({ script: withoutWebGl, ...options });

const words = (page) => page.locator("#still section").innerText();
const alt = (page) => page.locator("#still img").getAttribute("alt");
const shown = (page) => page.evaluate(() => globalThis.lastBlob.text());

test("without WebGL 2 the link's polygon is the picture that Save writes, with its verdict and what is missing", async () => {
  const page = await open({ address: `#${encoded("guitar", "--teams", "4")}` });
  assert.equal(await alt(page), verdict("guitar", "--teams", "4"));
  assert.equal(await shown(page), await page.evaluate(() => evenlift.svg()));
  const said = await words(page);
  assert.ok(said.includes(verdict("guitar", "--teams", "4")), said);
  assert.match(said, /still picture[^]*WebGL 2[^]*Firefox[^]*The link in the address bar holds everything/);
  assert.equal((await state(page)).teams.length, 4);
  await page.done();
});

test("without graphics at all it is there, too, of the opening sample", async (t) => {
  const bare = await startBrowser(["--disable-gpu", "--disable-3d-apis"], { drawn: true });
  t.after(() => bare.close());
  const page = await bare.open({ quiet: false });
  assert.match(await alt(page), /robots carry/);
  assert.ok(
    await page.locator("#still img").evaluate((picture) => picture.decode().then(() => picture.naturalWidth > 0)),
  );
  await page.done();
});

test("a link of a polygon that is refused says why, and the opening sample is shown", async () => {
  const page = await open({ address: `#${refusedLink}` });
  assert.match(
    await words(page),
    /This link cannot be opened: vertices 2 and 3: two vertices are at the same place\./i,
  );
  assert.match(await alt(page), /robots carry/);
  await page.done();
});

test("another link in the address changes the still picture, and a refused one says that nothing was changed", async () => {
  const page = await open({ address: `#${encoded("guitar")}` });
  await page.evaluate((to) => {
    location.hash = to;
  }, encoded("anchor"));
  await idle(page);
  assert.equal(await alt(page), verdict("anchor"));
  await page.evaluate((to) => {
    location.hash = to;
  }, refusedLink);
  await idle(page);
  assert.match(await words(page), /cannot be opened: .* same place\. Nothing was changed\./i);
  assert.equal(await alt(page), verdict("anchor"));
  await page.evaluate((to) => {
    location.hash = to;
  }, encoded("violin"));
  await idle(page);
  assert.doesNotMatch(await words(page), /cannot be opened/);
  assert.equal(await shown(page), await page.evaluate(() => evenlift.svg()));
  await page.done();
});

test("scripts change the still picture and the address as they would the canvas", async () => {
  const page = await open();
  await page.evaluate((text) => evenlift.load(text), asset("guitar"));
  await set(page, { teams: 2 });
  await idle(page);
  assert.equal(await alt(page), verdict("guitar", "--teams", "2"));
  assert.equal(await fragment(page), await link(page));
  assert.equal(await page.evaluate(() => evenlift.frames), 0);
  assert.equal(await page.evaluate(() => evenlift.view.control("Samples")), null);
  assert.match(await thrown(page, "set", { teams: 0 }), /teams/);
  await page.done();
});

test("balanced robots are looked for until the still picture has them", async () => {
  const page = await open({ address: `#${encoded("guitar", "--metric", "balanced", "--robots", "4")}` });
  await idle(page);
  assert.equal((await state(page)).teams[0].ends.length, 4);
  assert.equal(await shown(page), await page.evaluate(() => evenlift.svg()));
  await page.done();
});

test("the one thing to press is Save, which saves the same picture and gives the focus back", async () => {
  const page = await open({ address: `#${encoded("guitar")}` });
  const pressable = () =>
    page.$$eval("button, a, input, select, canvas", (all) =>
      all.filter((element) => element.checkVisibility()).map((element) => element.textContent),
    );
  assert.deepEqual(await pressable(), ["Save"]);
  await page.getByRole("button", { name: "Save" }).click();
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: /^SVG/ }).click()]);
  assert.equal(readFileSync(await file.path(), "utf8"), await page.evaluate(() => evenlift.svg()));
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Save");
  await page.done();
});

test("what was kept of other visits stays as it is", async () => {
  const page = await open({ script: withoutWebGl });
  const kept = { "evenlift.work": encoded("guitar"), "evenlift.draft": refusedLink, "evenlift.history": "x" };
  await page.evaluate((all) => Object.assign(localStorage, all), kept);
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  await set(page, { teams: 2 });
  await idle(page);
  const now = await page.evaluate(
    (names) => Object.fromEntries(names.map((name) => [name, localStorage[name]])),
    Object.keys(kept),
  );
  assert.deepEqual(now, kept);
  await page.done();
});

test("a challenge shows no picture, which would hold its answer", async () => {
  const page = await open({ address: `?challenge=1#${encoded("guitar")}`, ready: false });
  assert.match(
    await page.evaluate(() =>
      evenlift.ready.then(
        () => "ready",
        (error) => error.message,
      ),
    ),
    /WebGL 2/,
  );
  assert.match(await page.locator("#problem").innerText(), /cannot run here[^]*WebGL 2/);
  assert.match(await thrown(page, "link"), /not ready/);
  await page.done();
});

for (const [where, viewport] of [
  ["a phone", phone],
  ["a desk", wide],
  ["a figure in an article", { width: 640, height: 420 }],
]) {
  for (const colorScheme of ["light", "dark"]) {
    test(`the still picture is whole on ${where} in ${colorScheme} colours, and can be read by all`, async () => {
      const embed = viewport.width === 640;
      const page = await open({ address: `${embed ? "?embed=1" : ""}#${encoded("anchor")}`, viewport, colorScheme });
      await idle(page);
      const { width, height } = await page.locator("#still img").boundingBox();
      assert.ok(width > 200 && width <= viewport.width - 32 && height <= viewport.height - 32, `${width} x ${height}`);
      assert.ok(await page.evaluate(() => document.getElementById("still").scrollWidth <= innerWidth));
      assert.equal(await page.getByRole("button").count(), embed ? 0 : 1);
      await page.evaluate(axe);
      assert.deepEqual(
        await page.evaluate(async () =>
          (await globalThis.axe.run()).violations.map(({ id, nodes }) => [id, nodes[0].html]),
        ),
        [],
      );
      await page.done();
    });
  }
}
