/** Where robots stand so that they lift a polygon together, each with nearly the same load. */

/** x to the right, y up. */
export type Point = [x: number, y: number];

/** The vertices of a polygon, or a text: the thesis's format, WKT, GeoJSON, or a share link, whose settings are the defaults then. */
export type Polygon = readonly (readonly [x: number, y: number])[] | string;

export type Metric = "area" | "circle" | "distance" | "distributed" | "random" | "balanced";
export type Goal = "cover" | "hold";
export type Positions = "best" | "range";
export type LengthUnit = "m" | "cm" | "mm" | "in";
export type WeightUnit = "kg" | "t" | "N" | "lb";
export type Overlay = "candidates" | "chords" | "hull" | "clockwise" | "counterclockwise" | "tipping" | "halo";

/** As the program's options of the same names; each has the program's default. */
export interface Settings {
  /** Where the centre of mass is; `null` for the centroid. */
  centre_of_mass?: readonly [x: number, y: number] | null;
  /** Teams asked for, 1 to 1048576; `"max"` places every candidate (area, circle and distance only). Default 3. */
  teams?: number | "max";
  metric?: Metric;
  /** 0 to 1. Default 0.8. */
  min_ratio?: number;
  /** 1e-100 to 1e100. Default 100. */
  weight?: number;
  /** A whole number of at most 64 bits, for `random`. Default 1. */
  seed?: number | bigint;
  /** Balanced robots, 2 to 64. Default 6. */
  robots?: number;
  goal?: Goal;
  /** 0 to 1. Default 0.05. */
  min_margin?: number;
  /** A length, as all lengths 0 to 1e9. Default 0.12 of the object's radius. */
  apart?: number;
  /** Distances below this length are not relied on, such as those of robots from corners. Default 0.02 of the object's radius. */
  clear?: number;
  /** 0 to 30. Default 0. */
  survive?: number;
  /** Where teams of two may stand: at the best places, or anywhere in the ranges that `min_ratio` allows. Default `"best"`. */
  positions?: Positions;
  /** The size of a robot, such as `"r=30,reach=5"`. Default `"none"`. */
  robot?: string;
  /** One of its numbers, a length. */
  robot_radius?: number;
  robot_reach?: number;
  robot_depth?: number;
  robot_width?: number;
  robot_gap?: number;
  /** What no robot may touch: edges from 1 or parts of them, such as `"3,5:0.25-0.75"`. Default `"none"`. */
  no_go?: string;
  /** What one robot carries, 1e-100 to 1e100; `"none"` for no limit. */
  capacity?: number | "none";
  /** The centre of mass is known within this length. */
  com_radius?: number;
  /** Of coordinates and distances: a label, which changes no number. Default `"none"`. */
  unit?: LengthUnit | "none";
  /** Of weights and loads, likewise. Default `"kg"`. */
  weight_unit?: WeightUnit;
  /** What a picture shows. */
  overlays?: readonly Overlay[] | "none";
  /** The step of the lesson that a link opens. */
  step?: number | "none";
}

export interface PlaceOptions extends Settings {
  /** Lists the candidates, too. */
  candidates?: boolean;
  /** Tells what happens if one robot fails, for each of them. */
  failures?: boolean;
}

export interface SvgOptions extends Settings {
  /** Shows the candidates. */
  candidates?: boolean;
}

export interface PosesOptions extends Settings {
  /** Default `"json"`. */
  format?: "csv" | "json" | "yaml";
  /** The coordinate frame's name. Default `"object"`. */
  frame?: string;
  /** Where the coordinates begin. Default `"file"`. */
  origin?: "file" | "com";
}

export interface Candidate {
  ends: [Point, Point];
  ratio: number;
  /** `"range"` only with positions anywhere in the ranges, or of robots with a size. */
  kind: "bisecting" | "vertex" | "midpoint" | "range";
}

export interface Team {
  ends: Point[];
  ratio: number;
  loads: number[];
}

export interface Robot {
  at: Point;
  /** Counted from 0. */
  team: number;
  load: number;
  contact: Point;
  stand: Point;
  /** Degrees, above -180 and up to 180. */
  heading: number;
}

export type Motion = "clockwise" | "counterclockwise" | "translation";

export interface Loads {
  min: number;
  mean: number;
  max: number;
  spread: number;
  max_share: number;
  /** By the other models, in the order of the robots; `best` is the least possible greatest load. `null` if rounding puts C beside the robots. */
  models: { springs: number[]; best: number; worst: number[] } | null;
}

export interface Closure {
  form_closure: boolean;
  margin: number | null;
  /** It is held without the contacts that are nearer to a corner than this; `null` where no contact is beside a corner. */
  clearance: number | null;
  /** Each robot may be off by less than this along its edge, and form closure stays. */
  tolerance: number;
  second_order: boolean;
  free: Motion[];
  clockwise: Point[];
  counterclockwise: Point[];
}

export interface Robustness {
  com_margin: number;
  failures_carried: number;
  failures_steady: number;
  /** As `failures_steady`, by more than `clear`. */
  failures_clear: number;
  /** `null` where the models are. */
  load_per_length: number[] | null;
  /** The following with a `com_radius` above 0. */
  com_radius?: number;
  exact_within?: number | null;
  plan_ranges?: [least: number, greatest: number][];
  springs_ranges?: [least: number, greatest: number][];
}

/** What is left of the lift if this robot fails; `null` where the others do not carry the object. */
export interface Failure {
  /** Counted from 0. */
  robot: number;
  carried: boolean;
  steady: boolean;
  /** Steady, and the centre of mass is at least `clear` inside. */
  clear: boolean;
  com_margin: number | null;
  coverage: number | null;
  form_closure: boolean | null;
  margin: number | null;
  plan_max: number | null;
  springs_max: number | null;
  best_max: number | null;
  /** With a `capacity`. */
  over_capacity?: boolean | null;
}

export interface Capacity {
  limit: number;
  /** The robots that carry more, counted from 0, team after team. */
  overloaded: number[];
  teams_needed: number | null;
  greatest_load: number | null;
  teams_tried: number;
  robots_needed: number | null;
  com_radius: number | null;
  /** How many robots are needed so that any one of them may fail. */
  if_one_fails: { robots_needed: number | null; greatest_load: number | null; robots_tried: number } | null;
}

/** The object that `evenlift place --json` prints. */
export interface Placement {
  polygon: Point[];
  centre_of_mass: Point;
  metric: Metric;
  min_ratio: number;
  weight: number;
  /** Rounded by JavaScript beyond 2⁵³. */
  seed: number;
  /** Where it is not `"none"`. */
  unit?: LengthUnit;
  /** Where it is not `"kg"`. */
  weight_unit?: WeightUnit;
  /** With `candidates`. */
  candidates?: Candidate[];
  requested_teams: number;
  teams: Team[];
  /** Not there with no team. */
  robots?: Robot[];
  hull: Point[];
  coverage: number;
  loads: Loads | null;
  closure: Closure;
  goal: Goal;
  goal_reached: boolean;
  /** As used; `null` for the default. */
  clear: number | null;
  /** Of balanced robots: whether the search has come to its end. */
  search_ended?: boolean;
  requested_robots?: number;
  /** The same, and with teams of two that are to hold. */
  min_margin?: number;
  apart?: number | null;
  survive?: number;
  /** Where it is not `"best"`. */
  positions?: "range";
  /** Where `requested_teams` does not tell it: `"max"`, or what was asked for of the other methods where robots are balanced. */
  teams_asked?: number | "max";
  /** Of a link whose overlays are others than usual. */
  overlays?: Record<"candidates" | "chords" | "hull" | "clockwise" | "counterclockwise" | "tipping" | "halo", boolean>;
  /** The following three where robots have a size, or edges must not be touched. */
  robot?: { radius: number; reach: number; depth: number; width: number; gap: number };
  no_go?: string;
  /** Parts of edges, which count from 1, where no robot can stand, and why. */
  unusable?: [
    edge: number,
    from: number,
    to: number,
    why: "no_go" | "body" | "arm" | "corner" | "hand" | "near_no_go" | "narrow",
  ][];
  /** Of a link with robots that somebody moved by hand. */
  moved?: string;
  /** Not there with no team. */
  robustness?: Robustness;
  /** With `failures`. */
  failures?: Failure[];
  /** With a `capacity`. */
  capacity?: Capacity;
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

/** What the thesis states, beside the same of the measurements, a text for each of `sets`. */
export interface Claims {
  sets: string[];
  rows: { section: string; what: string; thesis: string; ours: string[] }[];
}

export interface FewRobots {
  set: string;
  rows: { what: string; robots: number; cells: string[] }[];
}

export interface Experiment {
  /** Three tables as CSV. */
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

/** Where in a request something is wrong; vertices and edges count from 0, lines, columns and characters from 1. */
export type Place =
  | { line: number; column: number }
  | { vertices: number[] }
  | { edges: number[] }
  | { centre_of_mass: true }
  | { setting: string }
  | { character: number };

/** A request that was refused; `message` is a sentence that says what is wrong and where. */
export class EvenliftError extends Error {
  readonly name: "EvenliftError";
  readonly code: string;
  readonly place: Place | null;
}

/** Places robots. Throws EvenliftError. */
export function place(polygon: Polygon, options?: PlaceOptions): Placement;

/** Where teams of two may stand, in order of slope. Of the settings those count that have a say in it: `min_ratio`, `centre_of_mass`,
 * `positions`, the robots' size and `no_go`, and `clear` with positions `"range"`. Throws EvenliftError. */
export function candidates(polygon: Polygon, settings?: Settings): Candidate[];

/** The picture, as a text of SVG. Throws EvenliftError. */
export function svg(polygon: Polygon, options?: SvgOptions): string;

/** The robots' poses, as the text of a file. Throws EvenliftError. */
export function poses(polygon: Polygon, options?: PosesOptions): string;

/** The share link, without `#`. Throws EvenliftError. */
export function link(polygon: Polygon, settings?: Settings): string;

/** The measurements of the thesis's chapter 5, over many polygons. Throws EvenliftError. */
export function experiment(
  polygons: readonly {
    name?: string;
    set?: string;
    polygon?: Exclude<Polygon, string>;
    text?: string;
    centre_of_mass?: readonly [x: number, y: number] | null;
  }[],
  settings?: { min_ratio?: number; samples?: number; max_teams?: number; max_balanced?: number },
): Experiment;

/** The answer to a request, as the text that the C function `evenlift_run` gives. A bad request gets `{"error": …}`. */
export function run(request: string | object): string;

/** Of the package. */
export const version: string;
