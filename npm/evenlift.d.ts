/** Finds places for robots that lift a polygon together, with nearly equal loads. */

/** x to the right, y up. */
export type Point = [x: number, y: number];

/** Vertices, or a text: the thesis's format, WKT, GeoJSON, or a share link, which then sets the defaults. */
export type Polygon = readonly (readonly [x: number, y: number])[] | string;

export type Metric = "area" | "circle" | "distance" | "distributed" | "random" | "balanced" | "given";
export type Goal = "cover" | "hold";
export type Positions = "best" | "range";
export type LengthUnit = "m" | "cm" | "mm" | "in";
export type WeightUnit = "kg" | "t" | "N" | "lb";
export type Overlay =
  "candidates" | "chords" | "hull" | "clockwise" | "counterclockwise" | "tipping" | "halo" | "tilt" | "load";

/** A load fixed to the object, at its own centre of mass. */
export interface Cargo {
  at: readonly [x: number, y: number];
  weight: number;
  name?: string;
}

/** The vertices of each hole. */
export type Holes = readonly (readonly (readonly [x: number, y: number])[])[];

/** The program's options and defaults. */
export interface Settings {
  /** The holes, in place of those of the polygon's text. */
  holes?: Holes;
  /** `null` for the centroid. */
  centre_of_mass?: readonly [x: number, y: number] | null;
  /** 1 to 1048576; `"max"` places every candidate (area, circle and distance only). Default 3. */
  teams?: number | "max";
  metric?: Metric;
  /** Another name of `metric`. */
  method?: Metric;
  /** 0 to 1. Default 0.8. */
  min_ratio?: number;
  /** 1e-100 to 1e100. Default 100. */
  weight?: number;
  /** A whole number of at most 64 bits, for `random`. Default 1. */
  seed?: number | bigint;
  /** The number of balanced robots, 2 to 64. Default 6. */
  robots?: number;
  goal?: Goal;
  /** 0 to 1. Default 0.05. */
  min_margin?: number;
  /** A length, like all lengths from 0 to 1e9. Default 0.12 of the object's radius. */
  apart?: number;
  /** Shorter distances, such as those of robots from corners, are not relied on. Default 0.02 of the object's radius. */
  clear?: number;
  /** Each robot may be off its place by this length (default 0): searches promise only what still holds then. */
  accuracy?: number;
  /** 0 to 30. Default 0. */
  survive?: number;
  /** For teams of two: the best places, or any in the ranges that `min_ratio` allows. Default `"best"`. */
  positions?: Positions;
  /** The size of a robot: `"r=30,reach=5"`. Default `"none"`. */
  robot?: string;
  /** The values of `robot`, all lengths. */
  robot_radius?: number;
  robot_reach?: number;
  robot_depth?: number;
  robot_width?: number;
  robot_gap?: number;
  /** No-go edges, counted from 1, or parts of them: `"3,5:0.25-0.75"`. Default `"none"`. */
  no_go?: string;
  /** Robots that already stand: points, or a text, `"0,0 160,0@30"` with a capacity. Sets the method to `"given"`. */
  supports?: readonly (readonly [x: number, y: number])[] | string;
  /** Supports within this length of the outline stand at its edge. Default 1e-6 of the object's diameter. */
  snap?: number;
  /** The capacity of each support: `[30, null, 40]`. */
  support_capacities?: readonly (number | null)[] | string;
  /** Loads fixed to the object, or a text: `"8,8:24:motor"`. */
  cargo?: readonly Cargo[] | string;
  /** The greatest load of a robot, 1e-100 to 1e100; `"none"` for no limit. */
  capacity?: number | "none";
  /** The C uncertainty: C is known within this distance. */
  com_radius?: number;
  /** The height of C, of the object with its cargo, above the plane in which the robots lift. */
  com_height?: number;
  /** The greatest slope of the plane in which the robots lift: a ratio from 0 to 1, or a text: `"8%"`, `"4.6deg"`. */
  slope?: number | string;
  /** The greatest acceleration along the ground, in g. */
  acceleration?: number;
  /** How far a robot gives way under the mean load. With `"none"`, uneven heights can cause the worst loads. */
  give?: number | "none";
  /** How much the ground, or a robot's height, is off at most. */
  uneven?: number;
  /** A further weight, such as a person. */
  extra?: number | "none";
  /** Of coordinates and distances: a label, which changes no number. Default `"none"`. */
  unit?: LengthUnit | "none";
  /** Of weights and loads: also only a label. Default `"kg"`. */
  weight_unit?: WeightUnit;
  /** In a picture. */
  overlays?: readonly Overlay[] | "none";
  /** The step that a link opens. */
  step?: number | "none";
}

export interface PlaceOptions extends Settings {
  /** Lists the candidates. */
  candidates?: boolean;
  /** The effect of each robot's failure. */
  failures?: boolean;
  /** Moves two or three supports to the edge so that all carry the same load. */
  even_out?: boolean;
  /** Conditions on the result: `"held, max<=20, worst<=60"`. */
  require?: string;
}

export interface SvgOptions extends Settings {
  /** Shows the candidates. */
  candidates?: boolean;
}

export interface PosesOptions extends Settings {
  /** Default `"json"`. */
  format?: "csv" | "json" | "yaml";
  /** The frame's name. Default `"object"`. */
  frame?: string;
  /** Default `"file"`. */
  origin?: "file" | "com";
}

export interface Candidate {
  ends: [Point, Point];
  ratio: number;
  /** `"range"` only with `positions: "range"`, or for robots with a size. */
  kind: "bisecting" | "vertex" | "midpoint" | "range";
}

export interface Team {
  ends: Point[];
  ratio: number;
  /** `null` if supports do not carry the object. */
  loads: (number | null)[];
}

export interface Robot {
  at: Point;
  /** Counted from 0. */
  team: number;
  /** `null` if supports do not carry the object. */
  load: number | null;
  /** `null` for a support beneath the object. */
  contact: Point | null;
  stand: Point;
  /** Degrees, above -180 and up to 180; `null` for a support beneath the object. */
  heading: number | null;
  place: "edge" | "beneath";
}

export type Motion = "clockwise" | "counterclockwise" | "translation";

export interface Loads {
  min: number;
  mean: number;
  max: number;
  spread: number;
  max_share: number;
  /** By the other models, in the order of the robots; `best` is the least possible greatest load. `null` if rounding moves C
   * outside the lifting base. */
  models: { springs: number[]; best: number; worst: number[] } | null;
  /** These two only with a C uncertainty, a slope, uneven ground, or an acceleration and a `com_height`. If a robot may go slack,
   * all ranges extend from the least to the greatest load that statics allows. */
  ranges?: [least: number, greatest: number][];
  may_let_go?: boolean;
}

/** When the object tips, in the worst direction. */
export interface Tilt {
  height: number;
  /** How far from C the weight may act under the given conditions, and whether the object stays upright then. */
  reach: number;
  stays: boolean;
  /** The slope as a ratio and as an angle, and the acceleration in g, each alone and on even ground. */
  slope: number;
  degrees: number;
  acceleration: number;
  /** The acceleration at which it tips on the given slope; `null` without a slope. */
  acceleration_left: number | null;
  /** The slope at which it tips with the given acceleration; `null` without an acceleration. */
  slope_left: number | null;
}

/** Where a further load may stand; all but the weight are `null` if the object falls. */
export interface ExtraLoad {
  weight: number;
  region: Point[] | null;
  share: number | null;
  /** The greatest weight that may stand anywhere; `null` for any weight. */
  anywhere: number | null;
}

export interface Closure {
  form_closure: boolean;
  margin: number | null;
  /** The object is held even without the contacts nearer to a corner than this; `null` if no contact is beside a corner. */
  clearance: number | null;
  /** Form closure remains if each robot is off by less than this along its edge; `null` without a limit. */
  tolerance: number | null;
  second_order: boolean;
  free: Motion[];
  clockwise: Point[];
  counterclockwise: Point[];
}

/** How far all robots may be off. Each length is `null` if what it is about does not hold, or has no limit. */
export interface Accuracy {
  asked: number;
  all_within: number | null;
  limited_by: { what: "fits" | "stands" | "hold" | "capacity"; robots: number[]; edge: number | null } | null;
  fits_within: number | null;
  stands_within: number | null;
  hold_within: number | null;
  capacity_within: number | null;
}

export interface Robustness {
  com_margin: number;
  failures_carried: number;
  failures_steady: number;
  /** Like `failures_steady`, by more than `clear`. */
  failures_clear: number;
  /** `null` if `models` is. */
  load_per_length: number[] | null;
  /** These two only with a `com_radius` above 0, the last two also on slopes and uneven ground. */
  com_radius?: number;
  exact_within?: number | null;
  plan_ranges?: [least: number, greatest: number][];
  springs_ranges?: [least: number, greatest: number][];
}

export interface Verdict {
  /** `"bad"` without robots, if the object falls or tips under the given conditions, or if a robot is or can be overloaded. */
  kind: "good" | "warning" | "bad";
  /** Sentences, the most serious first; none if the result is good. */
  reasons: string[];
}

/** A support that does not fit. */
export interface Misfit {
  /** Counted from 0. */
  robot: number;
  /** `"outside"`, `"arm"`, `"hand"`, `"no-go"`, or `"too near robot 2"`, counted from 1. */
  why: string;
}

export interface Requirement {
  condition: string;
  value: number | boolean | null;
  kept: boolean;
}

/** After this robot fails; members are `null` if the others do not carry the object. */
export interface Failure {
  /** Counted from 0. */
  robot: number;
  carried: boolean;
  steady: boolean;
  /** Steady, and C is at least `clear` inside. */
  clear: boolean;
  com_margin: number | null;
  coverage: number | null;
  form_closure: boolean | null;
  margin: number | null;
  plan_max: number | null;
  springs_max: number | null;
  best_max: number | null;
  /** The load of each robot; 0 for the failed one. `null` for more than 64 robots. */
  springs: number[] | null;
  /** Only with a `capacity`; `null` where `stays` is `false`. */
  over_capacity?: boolean | null;
  /** These two only if `loads.ranges` exists: the greatest load under the given conditions, `null` where `stays` is `false`; and
   * whether the object stays upright under them. */
  greatest_end?: number | null;
  stays?: boolean | null;
}

export interface Capacity {
  /** `null` if only single supports have a capacity. */
  limit: number | null;
  /** Robots that carry more, or can on slopes, when braked or on uneven ground; counted from 0, team after team. */
  overloaded: number[];
  teams_needed: number | null;
  greatest_load: number | null;
  teams_tried: number;
  robots_needed: number | null;
  com_radius: number | null;
  /** Robots needed so that any one may fail: then C is at least `clear` inside, and the object stays upright and each robot within
   * the capacity under the given conditions. `robots_tried` is 0 if no number was tried. */
  if_one_fails: { robots_needed: number | null; greatest_load: number | null; robots_tried: number } | null;
  use: number | null;
}

/** What `evenlift place --json` prints. */
export interface Placement {
  polygon: Point[];
  /** Only if there are any. */
  holes?: Point[][];
  /** With the cargo, and without it. */
  centre_of_mass: Point;
  own_centre_of_mass: Point;
  /** With the cargo; all loads are computed from it. */
  total_weight: number;
  /** Only if there is any. */
  cargo?: Cargo[];
  metric: Metric;
  min_ratio: number;
  weight: number;
  /** Rounded by JavaScript beyond 2⁵³. */
  seed: number;
  /** Only if it is not `"none"`. */
  unit?: LengthUnit;
  /** Only if it is not `"kg"`. */
  weight_unit?: WeightUnit;
  /** Only with `candidates`. */
  candidates?: Candidate[];
  requested_teams: number;
  teams: Team[];
  /** Missing without teams. */
  robots?: Robot[];
  hull: Point[];
  coverage: number;
  loads: Loads | null;
  closure: Closure;
  goal: Goal;
  goal_reached: boolean;
  /** The robots can carry the object. */
  stands: boolean;
  verdict: Verdict;
  /** These two only with supports, the second if the object falls: the robots over which it tips, counted from 0. */
  misfits?: Misfit[];
  tips_over?: number[];
  /** As used; `null` for the default. */
  clear: number | null;
  /** For balanced robots, and for teams whose swaps were cut short. */
  search_ended?: boolean;
  requested_robots?: number;
  /** For balanced robots, and for teams with the goal `"hold"`. */
  min_margin?: number;
  apart?: number | null;
  survive?: number;
  /** Only if it is not `"best"`. */
  positions?: "range";
  /** These three only with the method `"given"`; the last two if they are set. */
  supports?: Point[];
  snap?: number;
  support_capacities?: (number | null)[];
  /** If `requested_teams` differs from the setting: `"max"`, or for balanced robots the number of teams for the other methods. */
  teams_asked?: number | "max";
  /** Only for a link whose overlays are not the default. */
  overlays?: Record<
    "candidates" | "chords" | "hull" | "clockwise" | "counterclockwise" | "tipping" | "halo" | "tilt" | "load",
    boolean
  >;
  /** These three only if robots have a size, or there are no-go edges. */
  robot?: { radius: number; reach: number; depth: number; width: number; gap: number };
  no_go?: string;
  /** Parts of edges, counted from 1, where no robot can stand, and why. */
  unusable?: [
    edge: number,
    from: number,
    to: number,
    why: "no_go" | "body" | "arm" | "corner" | "hand" | "hole" | "near_no_go" | "narrow",
  ][];
  /** Only for a link with robots that were moved by hand. */
  moved?: string;
  /** Missing without teams. */
  robustness?: Robustness;
  accuracy?: Accuracy;
  /** `null` without `com_height`. */
  tilt: Tilt | null;
  /** Only with `extra`. */
  extra?: ExtraLoad;
  /** These five only if they are set. */
  com_height?: number;
  slope?: number;
  acceleration?: number;
  give?: number;
  uneven?: number;
  /** Only with `failures`. */
  failures?: Failure[];
  /** Only with a `capacity`, or if a support has one. */
  capacity?: Capacity;
  /** Only with `require`. */
  requirements?: Requirement[];
}

export interface Figure {
  set: string;
  id: string;
  title: string;
  unit: string;
  column: string;
  sentence: string;
  series: { method: Metric; points: [robots: number, value: number, polygons: number][] }[];
}

/** The thesis's statements beside our measurements, one text for each of `sets`. */
export interface Claims {
  sets: string[];
  rows: { section: string; what: string; thesis: string; ours: string[] }[];
}

export interface FewRobots {
  set: string;
  rows: { what: string; robots: number; cells: string[] }[];
}

export interface Experiment {
  /** CSV. */
  measurements: string;
  aggregates: string;
  polygons: string;
  /** Markdown. */
  thesis: string;
  refused: { polygon: string; problem: string }[];
  figures: Figure[];
  claims: Claims;
  few_robots: FewRobots[];
}

/** Vertices and edges count from 0, lines, columns and characters from 1. */
export type Place =
  | { line: number; column: number }
  | { vertices: number[]; rings?: number[] }
  | { edges: number[]; rings?: number[] }
  | { rings: number[] }
  | { centre_of_mass: true }
  | { setting: string }
  | { character: number };

/** Thrown by all functions except `run`; `message` is a sentence with the problem and its place. */
export class EvenliftError extends Error {
  readonly name: "EvenliftError";
  readonly code: string;
  readonly place: Place | null;
}

export function place(polygon: Polygon, options?: PlaceOptions): Placement;

/** The places for teams of two, in order of slope. Only `min_ratio`, `centre_of_mass`, `positions`, the robots' size and `no_go`
 * have an effect, and `clear` with positions `"range"`. */
export function candidates(polygon: Polygon, settings?: Settings): Candidate[];

/** SVG text. */
export function svg(polygon: Polygon, options?: SvgOptions): string;

/** The text of a file. */
export function poses(polygon: Polygon, options?: PosesOptions): string;

/** The share link, without `#`. */
export function link(polygon: Polygon, settings?: Settings): string;

/** The measurements of the thesis's chapter 5, over many polygons. */
export function experiment(
  polygons: readonly {
    name?: string;
    set?: string;
    polygon?: Exclude<Polygon, string>;
    holes?: Holes;
    text?: string;
    centre_of_mass?: readonly [x: number, y: number] | null;
  }[],
  settings?: { min_ratio?: number; samples?: number; max_teams?: number; max_balanced?: number },
): Experiment;

/** The answer as text, as from the C function `evenlift_run`. An invalid request gets `{"error": …}`. */
export function run(request: string | object): string;

export const version: string;
