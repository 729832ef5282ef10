import assert from "node:assert/strict";
import { test } from "node:test";
import { fragment, idle, set, sharedBrowser, state } from "../page/browser.mjs";

const browser = sharedBrowser({ drawn: true });

// Drops a red picture of this size in pixels, made by the browser.
const dropPicture = (page, { name = "table.png", type = "image/png", width = 400, height = 200 } = {}) =>
  page.evaluate(
    async ([name, type, width, height]) => {
      const canvas = Object.assign(document.createElement("canvas"), { width, height });
      const context = canvas.getContext("2d");
      context.fillStyle = "#FF0000";
      context.fillRect(0, 0, width, height);
      const blob = await new Promise((done) => canvas.toBlob(done, type));
      const data = new DataTransfer();
      data.items.add(new File([blob], name, { type }));
      dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
    },
    [name, type, width, height],
  );

async function withPhoto(options, screen) {
  const page = await browser.open(screen);
  await idle(page);
  await dropPicture(page, options);
  await page.locator("#photo").waitFor();
  await idle(page);
  return page;
}

async function colourAt(page, x, y) {
  const shot = await page.screenshot({ clip: { x, y, width: 1, height: 1 } });
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d");
    context.drawImage(image, 0, 0);
    return [...context.getImageData(0, 0, 1, 1).data];
  }, shot.toString("base64"));
}

const boxOf = (page) =>
  page.locator("#backdrop").evaluate((image) => {
    const { left, top, width, height } = image.getBoundingClientRect();
    return { left, top, width, height };
  });

test("a picture that is dropped is seen behind the drawing, and drawing begins", async () => {
  for (const type of ["image/png", "image/jpeg", "image/webp"]) {
    const page = await withPhoto({ type, name: `table.${type.slice(6)}` });
    const { left, top, width, height } = await boxOf(page);
    const colours = []; // at two places: one may be a dot of the grid
    for (const off of [3, 8])
      colours.push(await colourAt(page, Math.round(left + width / 2) + off, Math.round(top + height / 2) + off));
    assert.ok(
      colours.some(([red, green]) => red > 200 && green < 120),
      `${type}: ${colours.join("; ")}`,
    );
    assert.match(await page.locator("#photo").textContent(), /stays on this device/);
    assert.match(await page.locator("#alert").textContent(), /^“table\.\w+” is behind the drawing/);
    assert.equal(
      await page.evaluate(() => document.querySelector('#mirror [aria-label^="Draw"]').getAttribute("aria-pressed")),
      "true",
    );
    await page.done();
  }
});

test("it moves with the view, and the link does not hold it", async () => {
  const page = await withPhoto();
  const before = await boxOf(page);
  const world = (x, y) => page.evaluate((p) => evenlift.view.to_world(...p), [x, y]);
  const corner = await world(before.left, before.top);
  await page.mouse.move(400, 400);
  await page.mouse.wheel(0, -300);
  await idle(page);
  const after = await boxOf(page);
  assert.ok(after.width > before.width * 1.2);
  const now = await world(after.left, after.top);
  assert.ok(Math.hypot(now[0] - corner[0], now[1] - corner[1]) < 1, `${corner} ${now}`);
  assert.ok((await fragment(page)).length < 200);
  await page.done();
});

test("two points and their distance set the scale, and what is traced has it", async () => {
  const page = await withPhoto();
  await page.getByRole("button", { name: "Set scale" }).click();
  await idle(page);
  const { left, top, width, height } = await boxOf(page);
  await page.mouse.click(left + width * 0.25, top + height / 2);
  await page.mouse.click(left + width * 0.75, top + height / 2);
  await page.getByLabel("Distance", { exact: true }).first().fill("2,5");
  await page.keyboard.press("Enter");
  await page.locator("#photo").waitFor();
  await idle(page);
  const scaled = await boxOf(page);
  const at = (x, y) => [scaled.left + scaled.width * x, scaled.top + scaled.height * y];
  for (const corner of [
    [0.2, 0.3],
    [0.8, 0.3],
    [0.8, 0.9],
    [0.2, 0.9],
  ])
    await page.mouse.click(...at(...corner));
  await page.locator("#canvas").focus();
  await page.keyboard.press("Enter");
  await idle(page);
  const { polygon } = await state(page);
  assert.equal(polygon.length, 4);
  assert.ok(Math.abs(Math.abs(polygon[1][0] - polygon[0][0]) - 3) < 0.03, JSON.stringify(polygon));
  await page.done();
});

test("both points and the line between them are seen where they were pressed, while the distance is asked for", async () => {
  const page = await withPhoto();
  const before = await boxOf(page);
  await page.getByRole("button", { name: "Set scale" }).click();
  await idle(page);
  const marks = () =>
    page.locator("#measured").evaluate((svg) => {
      const box = document.getElementById("backdrop").getBoundingClientRect();
      const on = (x, y) => [(x - box.left) / box.width, (y - box.top) / box.height];
      const circles = [...svg.querySelectorAll("circle")].map((c) =>
        on(Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))),
      );
      const line = svg.querySelector("line");
      return {
        circles,
        line:
          line &&
          [
            ["x1", "y1"],
            ["x2", "y2"],
          ].map((of) => on(...of.map((name) => Number(line.getAttribute(name))))),
      };
    });
  const near = (got, want) =>
    got.forEach(([x, y], i) =>
      assert.ok(Math.abs(x - want[i][0]) < 0.01 && Math.abs(y - want[i][1]) < 0.01, JSON.stringify(got)),
    );
  const at = ([x, y]) => [before.left + before.width * x, before.top + before.height * y];
  const says = (words) =>
    page.waitForFunction((of) => document.getElementById("summary").textContent.includes(of), words);
  await says("Two points set the scale.");
  const ends = [
    [0.25, 0.5],
    [0.75, 0.25],
  ];
  await page.mouse.dblclick(...at(ends[0]));
  assert.equal(await page.locator("#measured circle").count(), 1, "a double press is one point");
  await page.mouse.move(...at([0.5, 0.5]));
  near((await marks()).line, [ends[0], [0.5, 0.5]]);
  await page.mouse.click(...at(ends[1]));
  const distance = page.getByLabel("Distance", { exact: true }).first();
  await distance.waitFor();
  await idle(page);
  near((await marks()).circles, ends);
  near((await marks()).line, ends);
  assert.deepEqual(await boxOf(page), before, "the picture stays where it is");
  await distance.fill("0.5 m");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => /“0\.5 m” is not a number/.test(document.getElementById("alert").textContent));
  near((await marks()).line, ends);
  await page.locator("#scale .away").click();
  assert.equal(await page.locator("#measured").count(), 0);
  await says("Draw a shape.");
  await page.done();
});

test("where lengths have a unit the distance has it too, and another one is converted", async () => {
  const page = await withPhoto();
  await set(page, { unit: "cm" });
  await page.getByRole("button", { name: "Set scale" }).click();
  await page.locator("#points").getByRole("button", { name: "Cancel" }).click();
  await page.getByRole("button", { name: "Set scale" }).click();
  await idle(page);
  const { left, top, width, height } = await boxOf(page);
  await page.mouse.click(left + width * 0.25, top + height / 2);
  await page.mouse.click(left + width * 0.75, top + height / 2);
  assert.match(await page.locator("#scale").textContent(), /Distance\s*cm/);
  await page.getByLabel("Distance", { exact: true }).first().fill("0,6 m");
  await page.keyboard.press("Enter");
  await page.locator("#photo").waitFor();
  assert.ok(Math.abs(Number(await page.getByLabel("Width", { exact: true }).first().inputValue()) - 120) < 1);
  await page.done();
});

const widthOfPhoto = (page) => page.getByLabel("Width", { exact: true }).first();
async function setWidth(page, text) {
  await widthOfPhoto(page).fill(text);
  await page.keyboard.press("Enter");
  await idle(page);
}

test("what was traced goes with the picture when its scale is set afterwards, and back with undo", async () => {
  const page = await withPhoto();
  await setWidth(page, "4");
  const picture = await boxOf(page);
  const at = (x, y) => [picture.left + picture.width * x, picture.top + picture.height * y];
  const corners = [
    [0.25, 0.25],
    [0.75, 0.25],
    [0.75, 0.75],
  ];
  for (const corner of corners) await page.mouse.click(...at(...corner));
  await setWidth(page, "8"); // while drawing
  await page.mouse.click(...at(0.25, 0.75));
  await page.locator("#canvas").focus();
  await page.keyboard.press("Enter");
  await idle(page);
  const near = (polygon, want) =>
    polygon.forEach(([x, y], i) =>
      assert.ok(Math.abs(x - want[i][0]) < 0.1 && Math.abs(y - want[i][1]) < 0.1, JSON.stringify(polygon)),
    );
  near((await state(page)).polygon, [
    [2, 3],
    [6, 3],
    [6, 1],
    [2, 1],
  ]);
  await setWidth(page, "800");
  near(
    (await state(page)).polygon.map((p) => p.map((c) => c / 100)),
    [
      [2, 3],
      [6, 3],
      [6, 1],
      [2, 1],
    ],
  );
  assert.equal(
    await page.evaluate(() => document.querySelector('#mirror [aria-label^="Draw"]').getAttribute("aria-pressed")),
    "false",
  );
  assert.match(
    await page.locator("#alert").textContent(),
    /The picture is now 800 wide\. Shapes traced on it are scaled with it\./,
  );
  const about = async () => {
    // the place of the picture relative to the polygon
    const { left, width } = await boxOf(page),
      [x] = await page.evaluate((p) => evenlift.view.to_screen(...p), (await state(page)).polygon[0]);
    return (x - left) / width;
  };
  assert.ok(Math.abs((await about()) - 0.25) < 0.02);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+z");
  await idle(page);
  near((await state(page)).polygon, [
    [2, 3],
    [6, 3],
    [6, 1],
    [2, 1],
  ]);
  assert.ok(Math.abs((await about()) - 0.25) < 0.02, "the picture is as it was, too");
  await setWidth(page, "1e12");
  assert.match(
    await page.locator("#alert").textContent(),
    /Width: The picture would reach beyond the largest coordinate\./,
  );
  near((await state(page)).polygon, [
    [2, 3],
    [6, 3],
    [6, 1],
    [2, 1],
  ]);
  await page.done();
});

test("two points of the picture can be taken by keys", async () => {
  const page = await withPhoto();
  await page.getByRole("button", { name: "Set scale" }).click();
  await page.locator("#measure").waitFor();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  assert.match(await page.locator("#alert").textContent(), /The first point is taken/);
  for (let i = 0; i < 10; ++i) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  const distance = page.getByLabel("Distance", { exact: true }).first();
  await distance.waitFor();
  const { width } = await boxOf(page);
  await distance.fill("1");
  await page.keyboard.press("Enter");
  await page.locator("#photo").waitFor();
  const wanted = width / 100; // the points are 100 screen pixels apart
  assert.ok(Math.abs(Number(await widthOfPhoto(page).inputValue()) / wanted - 1) < 0.01);
  await page.done();
});

for (const [width, height] of [
  [320, 568],
  [360, 740],
  [740, 360],
]) {
  test(`at ${width} by ${height} the picture is seen beside its card, and all of the card can be had`, async () => {
    const page = await withPhoto({}, { viewport: { width, height }, hasTouch: true, isMobile: true });
    const card = page.locator("#photo");
    // The picture's share that neither the card nor a control covers.
    const seen = () =>
      page.evaluate(() => {
        const picture = document.getElementById("backdrop").getBoundingClientRect(),
          over = document.querySelector(".seat-card")?.getBoundingClientRect();
        const boxes = ["Close the shape", "Cancel", "Snap to grid", "Snap to axis", "Coordinates"]
          .map((name) => evenlift.view.control(name))
          .filter(Boolean)
          .map(({ x, y, width: w, height: h }) => ({ left: x - 8, top: y - 8, right: x + w + 8, bottom: y + h + 8 }));
        let free = 0;
        for (let i = 0; i < 400; ++i) {
          const x = picture.left + (picture.width * ((i % 20) + 0.5)) / 20,
            y = picture.top + (picture.height * (Math.floor(i / 20) + 0.5)) / 20;
          free += [over, ...boxes].every((b) => !b || x < b.left || x > b.right || y < b.top || y > b.bottom);
        }
        return free / 400;
      });
    assert.equal(await seen(), 1, "with the card");
    await page.locator("#photo .away").tap();
    await idle(page);
    assert.equal(await seen(), 1, "without the card");
    await page.touchscreen.tap(width / 2, height / 2); // a vertex, for all controls of the bar
    await idle(page);
    assert.equal(await seen(), 1, "while it is traced");
    await page.locator("#canvas").focus();
    await page.keyboard.press("o");
    await page.getByRole("button", { name: "Change …" }).tap();
    await card.waitFor();
    await idle(page);
    await card.getByRole("button", { name: "Set scale" }).tap();
    await idle(page);
    assert.equal(await card.count(), 0, "no card covers the points that are to be pressed");
    await page.keyboard.press("Escape");
    await card.waitFor();
    await card.getByRole("button", { name: "More …" }).tap();
    for (const name of ["Set", "Remove", "Less"]) await card.getByRole("button", { name, exact: true }).waitFor();
    const place = await card.boundingBox();
    assert.ok(
      place.y >= 0 && place.x + place.width <= width && place.y + place.height <= height,
      JSON.stringify(place),
    );
    await card.getByRole("button", { name: "Remove", exact: true }).tap();
    assert.equal(await page.locator("#backdrop").count(), 0);
    await page.done();
  });
}

test("opacity, removal, and the way back by Open", async () => {
  const page = await withPhoto();
  await page.getByLabel("Opacity of the picture").fill("0.3");
  assert.equal(await page.locator("#backdrop").evaluate((image) => image.style.opacity), "0.3");
  await page.locator("#photo .away").click();
  await page.locator("#canvas").focus();
  await page.keyboard.press("o");
  await page.getByRole("button", { name: "Change …" }).click();
  await page.getByRole("button", { name: "Remove", exact: true }).click();
  assert.equal(await page.locator("#backdrop").count(), 0);
  assert.equal(await page.locator("#photo").count(), 0);
  await idle(page);
  const [red, green, blue] = await colourAt(page, 30, 500);
  assert.ok(red > 190 && green > 190 && blue > 190, "the ground is opaque again");
  await page.done();
});

test("a damaged picture and one of too many pixels are refused, and nothing changes", async () => {
  const page = await browser.open();
  await idle(page);
  const before = await state(page);
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array([0x89, 0x50, 0x4e, 0x47, 1, 2, 3, 4])], "broken.png"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
  });
  await page.waitForFunction(() =>
    /“broken\.png” cannot be opened: it is damaged/.test(document.getElementById("alert").textContent),
  );
  await dropPicture(page, { name: "huge.png", width: 10000, height: 5100 });
  await page.waitForFunction(() => /51 megapixels/.test(document.getElementById("alert").textContent));
  assert.equal(await page.locator("#backdrop").count(), 0);
  assert.deepEqual(await state(page), before);
  await page.done();
});
