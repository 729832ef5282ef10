// A photo or scan behind the drawing, for tracing: an image under the transparent canvas that moves with the view. It
// is never uploaded, is in no link or file, and is gone with the page.
import { closingButton, openCard } from "../kit/card.js";
import { closeWindows, ensureStyles } from "../kit/dialogs.js";
import { button, el, typedNumber } from "../kit/elements.js";
import { number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";
import { twoPoints } from "./two_points.js";

const mostPixels = 50e6;

let photo; // { name, url, image, opacity }; the program has its position

export function isPhoto(head, bytes) {
  const webp = head === "RIFF" && String.fromCharCode(...bytes.subarray(8, 12)) === "WEBP";
  return webp || /^(\x89PNG|\xff\xd8\xff)/.test(head);
}

// Returns why the picture cannot be shown, or undefined.
export async function layBehind(page, file) {
  const url = URL.createObjectURL(file);
  const image = el("img", { id: "backdrop", alt: "", "aria-hidden": "true" });
  const there = new Promise((done, fail) => Object.assign(image, { onload: done, onerror: fail }));
  image.src = url;
  const problem = await there.then(
    () => {
      const pixels = image.naturalWidth * image.naturalHeight;
      if (!pixels) return "It has no pixels";
      return pixels > mostPixels
        ? say("It has {number} megapixels, more than the 50 that can be shown", {
            number: number(Math.ceil(pixels / 1e6)),
          })
        : "";
    },
    () => "It is damaged, or this browser cannot show it",
  );
  if (problem) {
    URL.revokeObjectURL(url);
    return problem;
  }
  await ensureStyles();
  remove(page);
  // As large as it would be in the middle of the screen, until its scale is set.
  const [left, bottom] = worldAt(page.program, innerWidth * 0.2, innerHeight * 0.8);
  const [right] = worldAt(page.program, innerWidth * 0.7, innerHeight * 0.8);
  const unit = tidy((right - left) / image.naturalWidth);
  photo = { name: file.name, url, image, opacity: 0.7 };
  document.getElementById("canvas").before(image);
  image.style.opacity = photo.opacity;
  page.program.onPicture = () => place(page);
  page.program.call("page_backdrop", left, bottom, unit * image.naturalWidth, unit * image.naturalHeight);
  closeWindows();
  await openControls(page);
  page.announce(
    say("“{name}” is behind the drawing for tracing. A card sets its scale and opacity.", { name: file.name }),
  );
}

const worldAt = (program, x, y) => [program.number("page_world_x", x, y), program.number("page_world_y", x, y)];

const tidy = (value) => Number(value.toPrecision(6));

// The lower left corner in the polygon's coordinates, and the size of a pixel.
function lie({ program }) {
  const { left, bottom, width } = program.json("page_backdrop_place");
  return { left, bottom, unit: width / photo.image.naturalWidth };
}

function place(page) {
  const { image } = photo,
    { program } = page,
    { left, bottom, unit } = lie(page);
  const width = unit * image.naturalWidth,
    top = bottom + unit * image.naturalHeight;
  const x = program.number("page_screen_x", left, top),
    y = program.number("page_screen_y", left, top);
  const shown = program.number("page_screen_x", left + width, top) - x;
  image.style.transform = `translate(${x}px, ${y}px) scale(${shown / image.naturalWidth})`;
}

function remove(page) {
  if (!photo) return;
  page.program.onPicture = () => {};
  page.program.call("page_backdrop", 0, 0, 0, 0);
  photo.image.remove();
  URL.revokeObjectURL(photo.url);
  photo = undefined;
}

// Gives this number of the picture's pixels this length. The picture is scaled with everything traced on it, and then
// shown as a whole. Returns whether that is possible.
function scaleTo(page, label, pixels, length) {
  const width = tidy(length / pixels) * photo.image.naturalWidth;
  const problem = page.program.text("page_scale_backdrop", width);
  const { unit } = JSON.parse(page.program.text("page_state"));
  const now = `${number(tidy(width))}${unit ? ` ${unit}` : ""}`;
  if (problem) page.notice(`${translated(label)}: ${translated(problem)}.`, true);
  else
    page.notice(say("The picture is now {width} wide. Shapes traced on it are scaled with it.", { width: now }), false);
  return !problem;
}

// Pixels are counted from the picture's lower left corner; middle() is on the screen.
const pixelsOf = (page) => ({
  middle() {
    return this.toScreen([photo.image.naturalWidth / 2, photo.image.naturalHeight / 2]);
  },
  fromScreen(x, y) {
    const { left, bottom, unit } = lie(page),
      [right, up] = worldAt(page.program, x, y);
    return [(right - left) / unit, (up - bottom) / unit];
  },
  toScreen([right, up]) {
    const { left, bottom, unit } = lie(page),
      { program } = page;
    const x = left + right * unit,
      y = bottom + up * unit;
    return [program.number("page_screen_x", x, y), program.number("page_screen_y", x, y)];
  },
});

const inMetres = { m: 1, cm: 0.01, mm: 0.001, in: 0.0254 };

// Converts another unit to the polygon's. Returns { length } or { problem }.
function typedLength(text, unit) {
  const typed = text.trim(),
    [, amount, of] = typed.match(/^(.*?)\s*(m|cm|mm|in)$/) ?? [];
  const converted = unit && of ? (typedNumber(amount) * inMetres[of]) / inMetres[unit] : typedNumber(typed);
  if (!typed) return { problem: "please type a number above 0." };
  if (!Number.isFinite(converted))
    return {
      problem: unit
        ? say("“{typed}” is not a number. Please type it in {unit}, such as 2.5.", { typed, unit })
        : say("“{typed}” is not a number. Please type it without a unit, such as 2.5.", { typed }),
    };
  return converted > 0 ? { length: converted } : { problem: say("{typed} is not above 0.", { typed }) };
}

// `set` applies the length; `of` is a CSS class.
function lengthField(page, label, value, set, of = "") {
  const { unit } = JSON.parse(page.program.text("page_state"));
  const field = el("input", {
    class: "field",
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    "aria-label": label,
    size: "8",
  });
  field.value = value;
  const take = () => {
    const { length, problem } = typedLength(field.value, unit);
    return problem ? page.notice(`${translated(label)}: ${translated(problem)}`, true) : set(length);
  };
  field.addEventListener("keydown", (event) => event.key === "Enter" && take());
  return [
    el("label", { class: `row ${of}` }, label, field, ...(unit ? [unit] : [])),
    button("Set", { class: `button ${of}`, onclick: take }),
  ];
}

async function openControls(page) {
  const { image } = photo;
  const opacity = el("input", {
    type: "range",
    min: "0.1",
    max: "1",
    step: "0.05",
    "aria-label": "Opacity of the picture",
  });
  opacity.value = photo.opacity;
  opacity.addEventListener("input", () => {
    photo.opacity = Number(opacity.value);
    image.style.opacity = photo.opacity;
  });
  // The next cards are as high as this one, so that the picture stays in place.
  const alike = ({ root, seat }) => {
    root.style.minHeight = `${height}px`;
    seat();
    return root;
  };
  let height;
  const measure = async () => {
    const givenUp = new AbortController();
    page.program.call("page_measuring", 1);
    const asking = await openCard(page, {
      name: "points",
      title: "Two points of the picture",
      cross: false,
      closed: () => givenUp.abort(),
      body: [
        el("p", {}, "Press two points on the picture whose distance you know."),
        el("div", { class: "ways" }, button("Cancel", { onclick: () => asking.close() })),
      ],
    });
    alike(asking);
    page.announce(
      "Press two points on the picture whose distance you know. By keys: arrows move a ring, Enter takes the point.",
    );
    const measured = await twoPoints(page, pixelsOf(page), givenUp.signal);
    const over = () => {
      measured?.unmark();
      page.program.call("page_measuring", 0);
    };
    if (!photo || !measured) {
      over();
      return photo && openControls(page);
    }
    const scaled = (length) => scaleTo(page, "Distance", measured.pixels, length) && openControls(page);
    alike(
      await openCard(page, {
        name: "scale",
        title: "Scale of the picture",
        closed: over,
        body: [
          el("p", {}, "How far apart are the two points?"),
          el("div", { class: "ways" }, ...lengthField(page, "Distance", "", scaled)),
        ],
      }),
    )
      .querySelector("input")
      .focus({ preventScroll: true });
  };
  // With little room, the card starts small.
  const more = button("More …", {
    class: "button more",
    "aria-expanded": "false",
    onclick: () => {
      const whole = card.root.classList.toggle("whole");
      more.setAttribute("aria-expanded", String(whole));
      more.textContent = translated(whole ? "Less" : "More …");
      card.seat();
    },
  });
  const measuring = button("Set scale", {
    title: "Press two points and type their distance",
    onclick: () => {
      height = card.root.offsetHeight;
      measure();
    },
  });
  const card = await openCard(page, {
    name: "photo",
    title: "Picture behind the drawing",
    body: [
      el(
        "p",
        {},
        `${say("“{name}” is behind the drawing.", { name: photo.name })} `,
        el(
          "span",
          { class: "second" },
          "It stays on this device, is in no link or file, and is gone when this page is closed.",
        ),
      ),
      el(
        "div",
        { class: "ways" },
        opacity,
        measuring,
        ...lengthField(
          page,
          "Width",
          tidy(lie(page).unit * image.naturalWidth),
          (length) => scaleTo(page, "Width", image.naturalWidth, length),
          "seldom",
        ),
        closingButton("Remove", { class: "button seldom" }, () => remove(page)),
        more,
      ),
    ],
  });
}

export const hasPhoto = () => photo !== undefined;

// For the Open window.
export function photoLine(page) {
  if (!photo) return [];
  return [
    el(
      "p",
      { class: "row second" },
      say("“{name}” is behind the drawing.", { name: photo.name }),
      button("Change …", {
        onclick: () => {
          closeWindows();
          openControls(page);
        },
      }),
    ),
  ];
}
