// The fuzzers, and their first texts from the project's assets and tests.
import { mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";

const textsOf = async (folder) => {
  const names = (await readdir(folder)).filter((name) => name.endsWith(".txt") && name !== "index.txt");
  return Promise.all(names.map((name) => readFile(path.join(folder, name), "utf8")));
};

// Of a table in tests/data (tests/kit/data_table.h); texts are JSON strings or bare.
const column = async (root, file, index) => {
  const rows = (await readFile(path.join(root, "tests/data", file), "utf8")).split("\n");
  const cells = rows.filter((line) => line && !line.startsWith("#")).map((line) => line.split("\t")[index]);
  return cells.map((cell) => (cell.startsWith('"') ? JSON.parse(cell) : cell));
};

const polygons = (root) => textsOf(path.join(root, "assets/polygons"));
const links = async (root) => [
  ...(await column(root, "links_version_1.txt", 0)),
  ...(await column(root, "links_version_2.txt", 0)),
];

const written = [
  "POLYGON ((0 0, 160 0, 160 90, 90 90, 90 60, 0 60, 0 0))",
  "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1), (4 4, 5 4, 5 5, 4 4))",
  "CoM:(4,5)\n(0,0)\n(9,0)\n(9,9)\n(0,9)\nHole:\n(1,1)\n(2,1)\n(2,2)\nCargo:(8,8) 24 motor\nCargo:(1,12) 0.5\n",
  '{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,0]]]}',
  '{"type":"Feature","properties":{"centre_of_mass":[1,1]},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,0]]]}}',
];
// Besides tests/data/import.
const drawn = [
  '<svg><path d="M0 0C1 0 2 1 2 2S0 4 0 3zm9 9a1 2 30 0110 0q1 1 2 0t3 4z"/><rect x="1" width="3mm" height="2" rx=".5" transform="rotate(30)skewX(3)"/></svg>',
  '<svg><ellipse rx="3" ry="2"/><polyline points="0,0 1e1,0 0-3"/><polygon points="0 0 4 0 4 3"/><circle r="2"/></svg>',
  "[[0,0],[4,0],[4,3]]",
  `{"polygon": [[0,0],[9,0],[9,9]], "holes": [[[7,1],[8,1],[8,2]]], "cargo": [{"at": [8,8], "weight": 24, "name": "m"}]}`,
  '<svg><path d="M0 0h9v9h-9zM1 1v7h7v-7z" style="fill-rule:evenodd"/><g fill="none" stroke="red"><rect x="2" y="2" width="3" height="3"/><circle cx="20" r="9"/><circle cx="20" r="3"/></g></svg>',
  '[{"x":0,"y":0},{"x":4,"y":0},{"x":4,"y":3}]',
  "0;0\n4,5;0\n4;3,25\n",
  "x\ty\n0\t0\n4\t0\n4\t3\n\nlid\n1 2\n",
  "0 0\n4 0\n4 3\n",
  "0|0\n4|0\n4|3",
  '"X (m)","Y (m)"\n0,0\n4,0\n4,3\n',
];
const dataOf = async (root) => {
  const folder = path.join(root, "tests/data/import");
  return Promise.all((await readdir(folder)).map((name) => readFile(path.join(folder, name), "utf8")));
};
const expected = async (root) => {
  const folder = path.join(root, "tests/expected");
  const names = (await readdir(folder)).filter((name) => name.startsWith("t") && name.endsWith(".json"));
  return Promise.all(names.map((name) => readFile(path.join(folder, name), "utf8")));
};

const settings = [
  "teams=3\nmetric=circle\nmin_ratio=0.5\nweight=7\nseed=18446744073709551615\ncom=10,20\nstep=4\ncapacity=12.5",
  "teams=max\ncom=centroid\nstep=none\ncapacity=none\noverlays=chords,hull",
  "metric=distributed\nteams=1048576",
  "weight=1e100\nmin_ratio=1",
];

// For tests/fuzz/any_numbers.h: choices and unusual doubles.
const numbers = ["", "\0\x01\x02\x03".repeat(40), "\x04\x07\x7f\x01".repeat(40), "0123456789abcdef".repeat(10)];

const square = '"polygon": [[0, 0], [4, 0], [4, 3], [0, 3]]';
const requests = [
  `{${square}, "settings": {"teams": 2, "weight": 30, "unit": "mm", "weight_unit": "lb"}}`,
  `{"command": "place", ${square}, "centre_of_mass": [1, 1], "candidates": true, "failures": true, "settings": {"metric": "balanced", "robots": 4, "goal": "cover"}}`,
  `{"command": "candidates", "text": "POLYGON ((0 0, 4 0, 4 3, 0 0))", "settings": {"min_ratio": 0.5}}`,
  `{"command": "svg", ${square}, "settings": {"overlays": "chords,hull", "capacity": 20, "com_radius": 0.1, "teams": "max"}}`,
  `{"command": "poses", ${square}, "format": "yaml", "frame": "map", "origin": "com"}`,
  `{"command": "link", ${square}, "centre_of_mass": null}`,
  `{"command": "experiment", "polygons": [{"name": "a", "set": "b", ${square}}], "settings": {"samples": 2, "max_teams": 2, "max_balanced": 3, "min_ratio": 0.9}}`,
  '{"command": "version"}',
];

// The page's kept texts (tests/fuzz/fuzz_kept.cpp), separated by bytes 0.
const kept = async (root) => {
  const [polygon] = await polygons(root);
  const some = (await links(root)).slice(0, 6);
  const drawing = "0,0\n100,0\n50.5,1e2\n";
  return [
    ...some.map((link, i) => [link, some.at(-1 - i), "", drawing, "motion=0\ncapacity=20"].join("\0")),
    ["", polygon, some[0], drawing, "motion=1"].join("\0"),
    ["", "", "", "", ""].join("\0"),
  ];
};

export const fuzzers = {
  link: {
    what: "links",
    longest: 4096,
    seeds: async (root) => [...(await links(root)), ...(await column(root, "hostile_links.txt", 1))],
  },
  formats: {
    what: "texts",
    longest: 4096,
    seeds: async (root) => [...(await polygons(root)), ...written, ...(await column(root, "bad_polygons.txt", 2))],
  },
  import: {
    what: "drawings",
    longest: 8192,
    seeds: async (root) => [
      ...drawn,
      ...(await dataOf(root)),
      ...(await expected(root)),
      ...written,
      ...(await links(root)).slice(0, 3),
    ],
  },
  lesson: { what: "lessons", longest: 4096, seeds: (root) => textsOf(path.join(root, "assets/lessons")) },
  set: { what: "settings", longest: 512, seeds: async () => settings },
  numbers: { what: "numbers", longest: 256, seeds: async () => numbers },
  request: { what: "requests", longest: 2048, seeds: async () => requests },
  kept: { what: "kept work", longest: 2048, seeds: kept },
};

// Returns the name of the folder.
export async function writeSeeds(root, name) {
  const folder = path.join(root, "build/soak/seeds", name);
  await mkdir(folder, { recursive: true });
  const texts = await fuzzers[name].seeds(root);
  await Promise.all(texts.map((text, i) => writeFile(path.join(folder, `${i}`), text)));
  return folder;
}
