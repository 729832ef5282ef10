// The package's functions: requests as JSON in, answers of its WebAssembly as JSON out.

// `message` is a sentence that includes the place; `code` and `place` give the same facts as data.
export class EvenliftError extends Error {
  name = "EvenliftError";

  constructor({ code, message, place }) {
    super(message);
    this.code = code;
    this.place = place;
  }
}

// The module's imports: one reports that its memory grew, the others end it. It has no files and no clock.
function hostOf(compiled) {
  const host = {};
  for (const { module, name } of WebAssembly.Module.imports(compiled)) {
    (host[module] ??= {})[name] =
      name === "emscripten_notify_memory_growth"
        ? () => {}
        : () => {
            throw new WebAssembly.RuntimeError(`evenlift cannot continue: ${name}`);
          };
  }
  return host;
}

function start(compiled) {
  const { exports } = new WebAssembly.Instance(compiled, hostOf(compiled));
  exports._initialize?.();
  return exports;
}

function textAt(memory, at) {
  const bytes = new Uint8Array(memory.buffer);
  return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
}

function answerOf({ memory, evenlift_room, evenlift_free, evenlift_answer }, request) {
  const bytes = new TextEncoder().encode(request);
  const at = evenlift_room(bytes.length + 1);
  if (!at) throw new Error("evenlift: there is not enough memory for the request");
  new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  const answer = evenlift_answer(at, bytes.length);
  evenlift_free(at);
  if (!answer) throw new Error("evenlift: there is not enough memory for the answer");
  const text = textAt(memory, answer);
  evenlift_free(answer);
  return text;
}

// --- Requests.
// The core's errors refer to places in a request, which the caller never wrote. So errors with a line and a column are
// detected here, with the setting's name or the place.

// The options besides settings.
const members = {
  place: ["candidates", "failures", "even_out", "require"],
  candidates: [],
  svg: ["candidates"],
  poses: ["format", "frame", "origin"],
  link: [],
};
const ofPolygon = ["polygon", "holes", "text", "name", "set", "centre_of_mass"];
const ofExperiment = ["min_ratio", "samples", "max_teams", "max_balanced"];

const mostVertices = 1048576;
const mostPolygons = 10000;

const refusal = (code, message, place = null) => new EvenliftError({ code, message, place });
const badSetting = (setting, message) => refusal("bad_setting", message, { setting });

function distance(from, to) {
  let row = Array.from({ length: to.length + 1 }, (_, i) => i);
  for (let i = 0; i < from.length; ++i) {
    const next = [i + 1];
    for (let k = 0; k < to.length; ++k) {
      next.push(Math.min(row[k + 1] + 1, next[k] + 1, row[k] + (from[i] === to[k] ? 0 : 1)));
    }
    row = next;
  }
  return row[to.length];
}

// The known name closest to a wrong one, if close enough: minRatio and min-ratio stand for min_ratio.
function meant(wrong, known) {
  const letters = (name) => name.toLowerCase().replace(/[_-]/g, "");
  let best,
    least = Infinity;
  for (const name of known) {
    const far = distance(letters(wrong), letters(name));
    if (far < least && 3 * far <= letters(name).length + 1) [best, least] = [name, far];
  }
  return best;
}

function noSuch(what, name, known) {
  const likely = name.length <= 40 ? meant(name, known) : undefined;
  return `There is no ${what} "${name}"${likely ? `; did you mean "${likely}"?` : ""}`;
}

// Half a surrogate pair, which UTF-8 cannot contain.
const broken = /\p{Surrogate}/u;

function textOf(text) {
  const at = text.search(broken);
  if (at < 0) return text;
  const lines = text.slice(0, at).split("\n");
  const place = { line: lines.length, column: lines.at(-1).length + 1 };
  throw refusal("bad_syntax", `Line ${place.line}, column ${place.column}: this is half a character`, place);
}

const isPoint = (point) =>
  Array.isArray(point) && point.length === 2 && point.every((number) => typeof number === "number");

function vertexOf(point, i) {
  const place = { vertices: [i] };
  if (!isPoint(point)) throw refusal("bad_syntax", `Vertex ${i + 1}: a point must be two numbers [x, y]`, place);
  if (!point.every(Number.isFinite))
    throw refusal("bad_coordinate", `Vertex ${i + 1}: a coordinate is not a finite number`, place);
  return point;
}

function centreOf(point) {
  if (point === null) return null; // the centroid
  const place = { centre_of_mass: true };
  if (!isPoint(point)) throw refusal("bad_syntax", "The centre of mass must be two numbers [x, y]", place);
  if (!point.every(Number.isFinite))
    throw refusal("bad_coordinate", "A coordinate of the centre of mass is not a finite number", place);
  return point;
}

function holesOf(holes) {
  if (!Array.isArray(holes) || !holes.every(Array.isArray))
    throw refusal("bad_syntax", "The holes must be an array of arrays of points [x, y]");
  return holes.map((hole, i) => {
    const place = { rings: [i + 1] };
    if (!hole.every(isPoint)) throw refusal("bad_syntax", `Hole ${i + 1}: a point must be two numbers [x, y]`, place);
    if (!hole.flat().every(Number.isFinite))
      throw refusal("bad_coordinate", `Hole ${i + 1}: a coordinate is not a finite number`, place);
    return hole;
  });
}

function shapeOf(polygon) {
  if (typeof polygon === "string") return { text: textOf(polygon) };
  if (!Array.isArray(polygon)) throw refusal("bad_syntax", "A polygon must be an array of points [x, y], or a text");
  if (polygon.length > mostVertices)
    throw refusal("too_many_vertices", `The polygon has more than ${mostVertices} vertices`);
  return { polygon: Array.from(polygon, vertexOf) };
}

// A support is a point, its capacity a number, null or a text, and a load of the cargo an object.
const lists = ["supports", "support_capacities", "cargo"];
function loadOf({ at, weight, name } = {}) {
  if (!isPoint(at) || typeof weight !== "number" || (name !== undefined && typeof name !== "string"))
    throw badSetting("cargo", "cargo: a load must have a place [x, y], a weight and perhaps a name");
  if (![...at, weight].every(Number.isFinite)) throw badSetting("cargo", "cargo: a number is not finite");
  if (broken.test(name ?? "")) throw badSetting("cargo", "cargo: the name contains half a character");
  return name ? { at, weight, name } : { at, weight };
}

function listed(name, item) {
  if (name === "support_capacities") return valueOf(name, item ?? null);
  if (name === "cargo") return loadOf(item);
  if (!isPoint(item)) throw badSetting(name, `${name}: a support must be two numbers [x, y]`);
  if (!item.every(Number.isFinite)) throw badSetting(name, `${name}: a coordinate is not a finite number`);
  return item;
}

// The core refuses other values by the setting's name. A seed beyond 2⁵³ is a BigInt, which JSON does not support; the
// core reads its digits.
function valueOf(name, value) {
  if (Array.isArray(value) && lists.includes(name)) return Array.from(value, (item) => listed(name, item));
  if (Array.isArray(value)) return value.join(",");
  switch (typeof value) {
    case "bigint":
      return String(value);
    case "number":
      if (!Number.isFinite(value)) throw badSetting(name, `${name}: ${value} is not a finite number`);
      break;
    case "string":
      if (broken.test(value)) throw badSetting(name, `${name}: the text contains half a character`);
      break;
    case "function":
    case "symbol": // JSON.stringify() omits these
      throw badSetting(name, `${name}: expected a number or a text, not a ${typeof value}`);
  }
  return value;
}

const isOneOf =
  (...values) =>
  (value) =>
    values.includes(value);
const frame = /^[A-Za-z0-9_.-][A-Za-z0-9_./-]{0,254}$/;
const memberRules = {
  candidates: { allows: isOneOf(true, false), requirement: "candidates: expected true or false" },
  failures: { allows: isOneOf(true, false), requirement: "failures: expected true or false" },
  even_out: { allows: isOneOf(true, false), requirement: "even_out: expected true or false" },
  require: {
    allows: (value) => typeof value === "string" && !broken.test(value),
    requirement: 'require: expected a text such as "held, max<=20"',
  },
  format: { allows: isOneOf("csv", "json", "yaml"), requirement: "The format of poses must be csv, json or yaml" },
  origin: { allows: isOneOf("file", "com"), requirement: "The origin of poses must be file or com" },
  frame: {
    allows: (value) => typeof value === "string" && frame.test(value),
    requirement: "The frame must be 1 to 255 letters, digits, _, -, . and /, without / at the beginning",
  },
};

function memberOf(name, value) {
  if (!memberRules[name].allows(value)) throw badSetting(name, memberRules[name].requirement);
  return value;
}

const given = (options) => Object.entries(options ?? {}).filter(([, value]) => value !== undefined);

function requestOf(settingNames, command, polygon, options) {
  const request = { command, settings: {} };
  for (const [name, value] of given(options)) {
    if (name === "centre_of_mass") request.centre_of_mass = centreOf(value);
    else if (name === "holes") request.holes = holesOf(value);
    else if (members[command].includes(name)) request[name] = memberOf(name, value);
    // The core also accepts the program's "com".
    else if (settingNames.includes(name) || name === "com") request.settings[name] = valueOf(name, value);
    else
      throw badSetting(
        name,
        noSuch("setting", name, [...settingNames, "holes", "centre_of_mass", ...members[command]]),
      );
  }
  return { ...request, ...shapeOf(polygon) };
}

// --- Requests for experiments

function nameOf(name) {
  if (typeof name !== "string" || broken.test(name)) throw refusal("bad_syntax", "A name must be a text");
  return name;
}

function measuredOf(polygon) {
  if (typeof polygon !== "object" || polygon === null)
    throw refusal("bad_syntax", 'Expected an object with "polygon" or "text"');
  const asked = {},
    shapes = [];
  for (const [name, value] of given(polygon)) {
    if (!ofPolygon.includes(name)) throw refusal("unsupported", noSuch("member", name, ofPolygon));
    if (name === "centre_of_mass") asked[name] = centreOf(value);
    else if (name === "holes") asked[name] = holesOf(value);
    else if (name === "name" || name === "set") asked[name] = nameOf(value);
    else if ((name === "text") === (typeof value === "string")) shapes.push(shapeOf(value));
    else
      throw refusal(
        "bad_syntax",
        name === "text" ? "The text of a polygon must be a string" : "A polygon must be an array of points [x, y]",
      );
  }
  if (shapes.length !== 1)
    throw refusal("bad_syntax", 'A polygon must be given either as "polygon", an array of points [x, y], or as "text"');
  return { ...asked, ...shapes[0] };
}

// An error includes the polygon's name.
function namedOf(polygon, i) {
  try {
    return measuredOf(polygon);
  } catch (error) {
    if (!(error instanceof EvenliftError)) throw error;
    const name = typeof polygon?.name === "string" ? polygon.name : `polygon ${i + 1}`;
    throw refusal(error.code, `${name}: ${error.message[0].toLowerCase()}${error.message.slice(1)}`, error.place);
  }
}

function experimentOf(polygons, settings) {
  if (!Array.isArray(polygons)) throw refusal("bad_syntax", "An experiment needs an array of polygons");
  if (polygons.length > mostPolygons) throw refusal("unsupported", `There are more than ${mostPolygons} polygons`);
  const request = { command: "experiment", polygons: Array.from(polygons, namedOf), settings: {} };
  for (const [name, value] of given(settings)) {
    if (!ofExperiment.includes(name)) throw badSetting(name, noSuch("setting", name, ofExperiment));
    request.settings[name] = valueOf(name, value);
  }
  return request;
}

export function createApi(compiled) {
  let running = start(compiled);
  // All except the centre of mass.
  const settingNames = textAt(running.memory, running.evenlift_settings()).split(",");

  // The answer has the same bytes as the program's output. A module that stopped is replaced.
  function run(request) {
    try {
      return answerOf(running, typeof request === "string" ? request : JSON.stringify(request));
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      running = start(compiled);
      throw new Error("evenlift stopped: there is not enough memory for this", { cause: error });
    }
  }

  function ask(request) {
    const answer = JSON.parse(run(request));
    if (answer.error) throw new EvenliftError(answer.error);
    return answer;
  }

  const asked = (command) => (polygon, options) => ask(requestOf(settingNames, command, polygon, options));
  return {
    settingNames,
    run,
    place: asked("place"),
    candidates: (...args) => asked("candidates")(...args).candidates,
    svg: (...args) => asked("svg")(...args).svg,
    poses: (...args) => asked("poses")(...args).poses,
    link: (...args) => asked("link")(...args).link,
    experiment: (polygons, settings) => ask(experimentOf(polygons, settings)),
    version: ask({ command: "version" }).version,
  };
}
