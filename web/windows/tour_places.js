// The places on the screen that the tour points at, in CSS pixels.
import { isSeen } from "../mirror/controls.js";

// Sizes in the drawing, as in wasm/marks. A robot's ring fits between its mark and the number beside it.
const ringOf = (robots) => (robots > 16 ? 14.5 : 17.5);
// Half of a number's size, and its distance from the robot's middle.
const label = { wide: 30, high: 12, apart: 17.5 };
const aboutVertex = 14;
const aboutCentre = 22;

const away = ([x, y], [u, v]) => Math.hypot(x - u, y - v);

// Some, if there are very many.
function corners(program) {
  const all = program.json("page_vertices", 0, program.number("page_vertex_count"));
  const every = Math.ceil(all.length / 200);
  return all.filter((_, i) => i % every === 0);
}

// Convex, counter-clockwise with y upwards.
function hull(points) {
  const sorted = [...points].sort(([a, b], [c, d]) => a - c || b - d);
  const turnsLeft = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0;
  const half = (all) =>
    all
      .reduce((chain, point) => {
        while (chain.length > 1 && !turnsLeft(chain.at(-2), chain.at(-1), point)) chain.pop();
        return [...chain, point];
      }, [])
      .slice(0, -1);
  return [...half(sorted), ...half(sorted.reverse())];
}

// The part of a line between two robots that their marks and rings leave free; undefined if they are too near.
function between([from, to], reach) {
  const length = away(from, to);
  if (length < 3 * reach) return undefined;
  const at = (share) => [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share];
  return { line: [at(reach / length), at(1 - reach / length)] };
}

// The least distance of a vertex's ring from robots' marks, their numbers (beyond the marks as seen from C), and C's
// ring; less than 0 if it touches one.
function clearance(c, robots, ring) {
  const marks = robots.map(([x, y]) => {
    const far = away([x, y], c) || 1;
    const [u, v] = [(x - c[0]) / far, (y - c[1]) / far];
    const out = label.apart + Math.abs(u) * label.wide + Math.abs(v) * label.high;
    return { disc: [x, y], number: [x + u * out, y + v * out] };
  });
  return (at) =>
    Math.min(
      away(at, c) - aboutCentre,
      ...marks.flatMap(({ disc, number }) => [
        away(at, disc) - ring,
        Math.hypot(
          Math.max(Math.abs(at[0] - number[0]) - label.wide, 0),
          Math.max(Math.abs(at[1] - number[1]) - label.high, 0),
        ),
      ]),
    ) -
    aboutVertex -
    3;
}

// The turn of the outline: 0 if it continues straight, 2 if it reverses.
function sharpness([ax, ay], [bx, by], [cx, cy]) {
  const lengths = away([ax, ay], [bx, by]) * away([bx, by], [cx, cy]);
  return 1 - ((bx - ax) * (cx - bx) + (by - ay) * (cy - by)) / (lengths || 1);
}

const controls = (program, names) => program.json("page_controls").filter(({ name }) => names.includes(name));

// Scrolls the panel until a stop's controls are visible.
export function reveal({ program }, { controls: names = [] }) {
  const scrollTo = 3; // ControlRequest::reveal of wasm/ui/controls.h
  for (const control of controls(program, names)) {
    if (!isSeen(control)) program.call("page_ask_control", scrollTo, control.card, control.name, 0);
  }
}

export function look({ program }) {
  const screen = ([x, y]) => [program.number("page_screen_x", x, y), program.number("page_screen_y", x, y)];
  const state = JSON.parse(program.text("page_state"));
  // A lesson draws only the robots of its step, which may be fewer.
  const teams = program.number("page_walkthrough_is_open") ? [] : state.teams.map(({ ends }) => ends.map(screen));
  const robots = teams.flat();
  const ring = ringOf(robots.length);
  return {
    balanced: state.metric === "balanced",
    robots,
    free: state.closure.free,
    heldByCurvature: state.closure.second_order,
    baseHasArea: hull(robots).length > 2,
    // As the verdict writes it; undefined for all or nothing.
    coverage:
      state.stands && !state.failures && state.coverage > 1e-9 && state.coverage < 1 - 1e-9
        ? program.text("page_percentage", state.coverage)
        : undefined,
    discs: (some = robots) => some.map((at) => ({ circle: [...at, ring] })),
    team: teams[0],
    hasSheet: controls(program, ["handle"]).length > 0,
    aboutCentre: { circle: [...screen(state.centre_of_mass), aboutCentre] },
    // The boundary of the lifting base, between the robots; if they are too near to each other, a box around them.
    base() {
      const around = hull(robots);
      const sides = around.map((at, i) => between([at, around[(i + 1) % around.length]], ring + 4)).filter(Boolean);
      if (sides.length || !around.length) return sides;
      const [low, high] = [Math.min, Math.max].map((choose) =>
        [0, 1].map((axis) => choose(...around.map((at) => at[axis]))),
      );
      return [{ box: [low[0] - ring, low[1] - ring, high[0] - low[0] + 2 * ring, high[1] - low[1] + 2 * ring] }];
    },
    // The sharpest vertex that is clear of robots, their numbers and C; empty if there is none.
    vertex() {
      const c = screen(state.centre_of_mass);
      const clear = clearance(c, robots, ring);
      const all = corners(program).map(screen);
      const known = all
        .map((at, i) => ({ at, clear: clear(at), sharp: sharpness(all.at(i - 1), at, all[(i + 1) % all.length]) }))
        .filter(
          ({ at: [x, y], clear: room }) =>
            room >= 0 &&
            x > aboutVertex &&
            y > aboutVertex &&
            x < innerWidth - aboutVertex &&
            y < innerHeight - aboutVertex,
        );
      const best = known.sort((a, b) => b.sharp - a.sharp)[0];
      return best ? [{ circle: [...best.at, aboutVertex] }] : [];
    },
    // The handle of a phone's sheet; empty on a wide screen.
    sheet() {
      return this.controls("handle");
    },
    // The visible ones, as one box.
    controls(...names) {
      const boxes = controls(program, names)
        .map(({ place, window }) => [
          Math.max(place.left - 4, window.left),
          Math.max(place.top - 4, window.top),
          Math.min(place.left + place.width + 4, window.left + window.width),
          Math.min(place.top + place.height + 4, window.top + window.height),
        ])
        .filter(([left, top, right, bottom]) => right - left > 12 && bottom - top > 12);
      if (!boxes.length) return [];
      const [left, top, right, bottom] = [Math.min, Math.min, Math.max, Math.max].map((choose, i) =>
        choose(...boxes.map((box) => box[i])),
      );
      return [{ box: [left, top, right - left, bottom - top] }];
    },
  };
}
