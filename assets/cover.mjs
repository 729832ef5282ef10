// The page's index.html with what is seen while the program loads: the picture of the opening sample, and the sentences
// of class "cover" in German, too (cover.js chooses one language).
//   node cover.mjs core.wasm polygon.txt words-de.json index.html page.css OUTPUT
// It is the picture that Save writes, without its texts. The outline, the lifting base and the chords fill their box;
// the marks on them keep their size. page.css places the box where the program will draw the object.
import { readFileSync, writeFileSync } from "node:fs";

// Older Node takes a file named .js for a module only if a package.json says so.
const api = readFileSync(new URL("../npm/api.js", import.meta.url), "base64");
const { createApi } = await import(`data:text/javascript;base64,${api}`);
const [, , core, polygon, words, html, css, output] = process.argv;
const { svg } = createApi(await WebAssembly.compile(readFileSync(core)));
const lines = svg(readFileSync(polygon, "utf8"), { overlays: ["chords", "hull"] }).split("\n");

const numbersIn = (text) => text.match(/-?\d+(\.\d+)?/g).map(Number);
const attribute = (line, name) => new RegExp(` ${name}="([^"]*)"`).exec(line)?.[1];
const ofClass = (...names) => lines.filter((line) => names.includes(attribute(line, "class")));
const tenths = (value) => String(Math.round(value * 10) / 10);

// --- The object's box
const outline = ofClass("object")[0];
const ends = numbersIn(attribute(outline, "d"));
const range = (start) => {
  const values = ends.filter((_, i) => i % 2 === start);
  return { low: Math.min(...values), length: Math.max(...values) - Math.min(...values) };
};
const [x, y] = [range(0), range(1)];
const ratio = (x.length / y.length).toFixed(4);
const stated = /--ratio: ([\d.]+)/.exec(readFileSync(css, "utf8"))?.[1];
if (stated !== ratio) throw new Error(`the opening sample is ${ratio} times as wide as high: --ratio in page.css`);

// --- What fills the box
function stretched(line) {
  const points = numbersIn(attribute(line, "d"));
  let d = "";
  let before = [0, 0];
  for (let i = 0; i < points.length; i += 2) {
    const at = [Math.round(points[i] - x.low), Math.round(points[i + 1] - y.low)];
    d += `${i ? "l" : "M"}${at[0] - before[0]} ${at[1] - before[1]}`; // relative numbers are short
    before = at;
  }
  if (/Z$/.test(attribute(line, "d"))) d += "z";
  return line
    .replace(/ d="[^"]*"/, ` d="${d}"`)
    .replace(/ stroke-linejoin="round"/, ' stroke-linejoin="round" vector-effect="non-scaling-stroke"');
}

// --- What keeps its size: elements of the picture, moved to the origin and set on a place of the box
const set = (at, elements) => {
  const share = (value, { low, length }) => `${Math.round((10000 * (value - low)) / length) / 100}%`;
  return `<svg x="${share(at[0], x)}" y="${share(at[1], y)}" overflow="visible">${elements.join("")}</svg>`;
};
const start = lines.findIndex((line) => line.includes('<g class="centre-of-mass"'));
const centre = lines.slice(start + 1, lines.indexOf("</g>", start));
const marks = [set(numbersIn(attribute(lines[start], "transform")), centre)];
const bodies = ofClass("small-body");
for (const robot of ofClass("robot")) {
  const middle = (line, name, size) => Number(attribute(line, name)) + Number(attribute(line, size)) / 2;
  const at = [middle(robot, "x", "width"), middle(robot, "y", "height")];
  const isHere = (line) => Math.hypot(middle(line, "x", "width") - at[0], middle(line, "y", "height") - at[1]) < 0.1;
  const circle = (line) =>
    `<circle r="${Number(attribute(line, "rx"))}"${line.slice(line.indexOf(" fill="), -2)} class="${attribute(line, "class")}"/>`;
  const number = lines[lines.indexOf(robot) + 1].replace(/ x="[^"]*" y="[^"]*"/, ' y="5.4"').replace("<text", '<text class="number"');
  marks.push(set(at, [...bodies.filter(isHere), robot].map(circle).concat(number)));
}

const size = `width="${tenths(x.length)}" height="${tenths(y.length)}"`;
const picture = [
  `<svg ${size} overflow="visible">`,
  `<svg width="100%" height="100%" viewBox="0 0 ${tenths(x.length)} ${tenths(y.length)}" preserveAspectRatio="none" overflow="visible">`,
  ...[...ofClass("object"), ...ofClass("hull"), ...ofClass("chord")].map(stretched),
  "</svg>",
  ...marks,
  "</svg>",
].join("\n");

const place = "<!-- The build puts the opening sample's picture here. -->";
const page = readFileSync(html, "utf8");
if (!page.includes(place)) throw new Error(`${html} has no place for the picture`);
const german = JSON.parse(readFileSync(words, "utf8"));
const withGerman = page.replace(/<span class="cover">([^<]*)<\/span>/g, (english, text) => {
  if (!german[text]) throw new Error(`${words} has no "${text}"`);
  return `${english}<span class="cover" lang="de" hidden>${german[text]}</span>`;
});
const short = (text) => text.replace(/ *<!--.*?-->\n/gs, "").replace(/^ +/gm, "");
writeFileSync(output, short(withGerman.replace(place, picture)));
