import assert from "node:assert/strict";
import { axe, idle } from "./browser.mjs";

const keys = {
  samples: "g",
  open: "o",
  save: "s",
  table: "e",
  lessons: "Shift+B",
  experiment: "K",
  keys: "?",
  about: "A",
  glossary: "G",
};

// Opens a window by its key, and waits for it.
export async function openWindow(page, name) {
  await page.locator("#canvas").focus();
  await page.keyboard.press(keys[name]);
  const root = page.locator(`#${name}`);
  await root.waitFor();
  if (name === "lessons") await root.locator("li").first().waitFor();
  if (name === "samples") await root.locator(".sample").first().waitFor();
  await idle(page);
  return root;
}

// The page's notice, after all work that leads to it.
export async function noticed(page) {
  await idle(page);
  return page.locator("#alert").textContent();
}

// Drops files or a text like a browser, with the page's own DataTransfer.
export async function drop(page, { files = [], text }, target = "#canvas") {
  const data = await page.evaluateHandle(
    ([list, plain]) => {
      const transfer = new DataTransfer();
      for (const [name, content] of list) transfer.items.add(new File([content], name));
      if (plain !== undefined) transfer.setData("text/plain", plain);
      return transfer;
    },
    [files, text],
  );
  await page.dispatchEvent(target, "dragover", { dataTransfer: data });
  await page.dispatchEvent(target, "drop", { dataTransfer: data });
}

// Like Ctrl+V, by the clipboard's event.
export async function paste(page, text) {
  await page.evaluate((plain) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", plain);
    document.activeElement.dispatchEvent(
      new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }),
    );
  }, text);
}

// After a test that leaves windows open.
export async function closeAll(page) {
  await page.evaluate(() => document.querySelectorAll("dialog").forEach((window) => window.close()));
  await allClosed(page);
}

export async function allClosed(page) {
  await idle(page);
  assert.equal(await page.locator("dialog").count(), 0, "a window is open");
}

// The faults that axe finds, with their places.
export async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () =>
    (await globalThis.axe.run(document)).violations.map(
      ({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(" | ")}`,
    ),
  );
}
