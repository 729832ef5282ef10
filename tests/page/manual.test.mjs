// The lines in docs/page.md that serve and script the page run as printed.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import path from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";
import { pageFolder, root, sharedBrowser } from "./browser.mjs";

const browser = sharedBrowser();
const manual = readFileSync(path.join(root, "docs/page.md"), "utf8");
const block = (language, begin) => new RegExp(`\`\`\`${language}\n(${begin}[^\`]*)\`\`\``).exec(manual)[1];

test("the page is served, opens at the address that is printed, and can be scripted", async (t) => {
  const [command, ...more] = block("sh", "node web/serve").trim().split("\n");
  assert.deepEqual(more, []);
  const server = spawn("sh", ["-c", `exec ${command.replace("build/page", `'${pageFolder}'`)}`], { cwd: root });
  t.after(() => server.kill());
  let address;
  for await (const line of createInterface({ input: server.stdout })) {
    [address] = /http:\S+/.exec(line) ?? [];
    if (address) break;
  }
  const page = await browser.open({ site: address });
  const said = [];
  page.on("console", (message) => message.type() === "log" && said.push(message.args()));
  const lines = block("js", "await evenlift.ready");
  assert.ok(lines.trim().split("\n").length <= 5);
  await page.evaluate(`(async () => { ${lines} })()`);
  assert.equal(said.length, 1);
  const [coverage, link] = await Promise.all(said[0].map((value) => value.jsonValue()));
  assert.ok(coverage > 0.3 && coverage <= 1, `${coverage}`);
  assert.equal(link, await page.evaluate(() => evenlift.link()));
  await page.done();
});
