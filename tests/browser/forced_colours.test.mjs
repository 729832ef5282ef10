// With forced colours, nothing is printed twice, every control keeps its shape, and the canvas is light or dark like
// the system.
import assert from "node:assert/strict";
import { test } from "node:test";
import { asset, idle, load, phone, sharedBrowser } from "../page/browser.mjs";
import { openWindow } from "../page/windows.mjs";

const browser = sharedBrowser({ drawn: true });

async function forced({ colorScheme = "light", ...options } = {}) {
  const page = await browser.open({ colorScheme, forcedColors: "active", reducedMotion: "reduce", ...options });
  assert.ok(await page.evaluate(() => matchMedia("(forced-colors: active)").matches));
  await idle(page);
  return page;
}

// The visible elements of the mirror, except a focused one: the canvas shows the same below them.
const twins = (page) =>
  page.$$eval("#mirror > div > *", (all) => ({
    count: all.length,
    seen: all
      .filter((element) => element !== document.activeElement && Number(getComputedStyle(element).opacity) > 0)
      .map((element) => element.outerHTML.slice(0, 80)),
  }));

for (const [where, options] of [
  ["wide", {}],
  ["dark", { colorScheme: "dark" }],
  ["on a phone", { viewport: phone, hasTouch: true, isMobile: true }],
]) {
  test(`the controls in HTML do not show over those of the canvas, ${where}`, async () => {
    const page = await forced(options);
    await load(page, asset("anchor"));
    await idle(page);
    const plain = await browser.open({
      colorScheme: options.colorScheme ?? "light",
      reducedMotion: "reduce",
      ...options,
    });
    await load(plain, asset("anchor"));
    await idle(plain);
    const { count, seen } = await twins(page);
    assert.ok(count > 10, String(count));
    assert.deepEqual(seen, []);
    // The canvas has the same letters, uncovered.
    const { width, height } = page.viewportSize();
    const clip = { x: 2, y: 2, width: width - 4, height: height - 4 }; // without the frame
    const dark = await groundIsDark(page),
      like = await groundIsDark(plain);
    if (dark === like)
      assert.ok(
        (await browser.compare(await page.screenshot({ clip }), await plain.screenshot({ clip }))).share < 0.0005,
      );
    await plain.done();
    await page.done();
  });
}

test("a control that has the focus shows where it is and no letters of its own, but for a field in which one types", async () => {
  const page = await forced();
  await page.locator("#canvas").focus();
  const kinds = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    const found = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element.closest("#mirror")) return undefined;
      const { outlineStyle, outlineColor, backgroundColor, color, opacity } = getComputedStyle(element);
      return {
        kind: element.localName === "input" ? element.type : element.localName,
        outlineStyle,
        outlineColor,
        backgroundColor,
        color,
        opacity,
      };
    });
    if (!found) break;
    kinds.add(found.kind);
    const clear = (colour) => /^rgba\(.*, 0\)$/.test(colour) || colour === "transparent";
    assert.equal(found.outlineStyle, "solid", JSON.stringify(found));
    assert.ok(!clear(found.outlineColor) && found.opacity === "1", JSON.stringify(found));
    const types = found.kind === "text";
    assert.equal(clear(found.color), !types, JSON.stringify(found));
    assert.equal(clear(found.backgroundColor), !types, JSON.stringify(found));
    assert.deepEqual((await twins(page)).seen, []);
  }
  for (const kind of ["button", "select", "range", "text"]) assert.ok(kinds.has(kind), `${kind}: ${[...kinds]}`);
  await page.done();
});

// Controls and fields without a visible edge.
const shapeless = (window) =>
  window.evaluate((root) =>
    [...root.querySelectorAll(".button, .field, .choice, .sample, kbd")]
      .filter((element) => element.checkVisibility())
      .filter((element) => {
        const { borderTopWidth, borderTopStyle, borderTopColor } = getComputedStyle(element);
        const ground = getComputedStyle(root).backgroundColor;
        return !(
          parseFloat(borderTopWidth) >= 1 &&
          borderTopStyle !== "none" &&
          borderTopColor !== ground &&
          !/^rgba\(.*, 0\)$/.test(borderTopColor)
        );
      })
      .map((element) => element.outerHTML.slice(0, 80)),
  );

for (const colorScheme of ["light", "dark"]) {
  test(`buttons and fields of windows have an edge, and what is set is told from what is not, on a ${colorScheme} system`, async () => {
    const page = await forced({ colorScheme });
    for (const name of ["samples", "open", "save", "table", "lessons", "experiment", "keys", "about"]) {
      const window = await openWindow(page, name);
      assert.ok((await window.locator("button").count()) > 0);
      assert.deepEqual(await shapeless(window), [], name);
      if (name === "samples") {
        const edge = (element) => element.evaluate((e) => getComputedStyle(e).borderTopWidth);
        assert.equal(await edge(window.locator(".sample[aria-current]").first()), "3px");
        assert.equal(await edge(window.locator(".sample:not([aria-current])").first()), "1px");
      }
      await page.keyboard.press("Escape");
      await page.evaluate(() => document.querySelector("dialog")?.close());
      await idle(page);
    }
    await page.done();
  });
}

for (const colorScheme of ["light", "dark"]) {
  test(`charts have the system's colours, and their lines are told apart without any, on a ${colorScheme} system`, async () => {
    const page = await forced({ colorScheme });
    await load(page, asset("square"));
    const window = await openWindow(page, "experiment");
    await window.getByLabel("Max. teams").fill("2");
    await window.getByLabel("Max. balanced robots").fill("3");
    await window.getByRole("button", { name: "Compare", exact: true }).click();
    await window.getByText("Done.").waitFor();
    const drawn = await window.evaluate((root) => {
      const system = (colour) => {
        root.style.outlineColor = colour;
        return getComputedStyle(root).outlineColor;
      };
      const strokes = (marks) => [
        ...new Set([...root.querySelectorAll(marks)].map((mark) => getComputedStyle(mark).stroke)),
      ];
      const keys = [...root.querySelector(".legend").querySelectorAll(".key")].map((key) =>
        [...key.querySelectorAll("path, circle")]
          .map((mark) => `${mark.localName} ${mark.getAttribute("d") ?? ""} ${getComputedStyle(mark).strokeDasharray}`)
          .join(),
      );
      return {
        text: [system("CanvasText")],
        quiet: [system("GrayText")],
        keys,
        lines: strokes("[class^=line-] path"),
        signs: strokes("[class^=dots-] > *"),
        legend: strokes(".key path, .key circle"),
        grid: strokes("[aria-label=y-grid] line"),
      };
    });
    const { text, quiet, keys } = drawn;
    assert.deepEqual([drawn.lines, drawn.signs, drawn.legend, drawn.grid], [text, text, text, quiet]);
    assert.equal(keys.length, 6);
    assert.equal(new Set(keys).size, 6, keys.join("\n"));
    await page.done();
  });
}

// Whether a background is dark: the system's, and an empty corner's of the canvas.
const groundIsDark = (page) =>
  page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.backgroundColor = "Canvas";
    const [red, green, blue] = getComputedStyle(probe)
      .backgroundColor.match(/[\d.]+/g)
      .map(Number);
    probe.remove();
    return red + green + blue < 384;
  });

async function canvasIsDark(page) {
  const png = (await page.screenshot({ clip: { x: 6, y: 300, width: 8, height: 8 } })).toString("base64");
  const other = await browser.browser.newPage();
  const sum = await other.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d");
    context.drawImage(image, 0, 0, 1, 1);
    return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3).reduce((all, each) => all + each);
  }, png);
  await other.close();
  return sum < 384;
}

test("the canvas is dark where the system's ground is, also when that changes, and has a frame", async () => {
  const page = await forced();
  for (const colorScheme of ["light", "dark", "light"]) {
    await page.emulateMedia({ forcedColors: "active", colorScheme });
    await idle(page);
    assert.equal(await canvasIsDark(page), await groundIsDark(page), colorScheme);
    const { outlineStyle, outlineWidth } = await page.evaluate(() => {
      const { outlineStyle, outlineWidth } = getComputedStyle(document.getElementById("canvas"));
      return { outlineStyle, outlineWidth };
    });
    assert.deepEqual([outlineStyle, outlineWidth], ["solid", "1px"]);
  }
  await page.emulateMedia({ forcedColors: "none", colorScheme: "dark" });
  await idle(page);
  assert.ok(await canvasIsDark(page));
  await page.done();
});
