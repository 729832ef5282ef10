/** Finds places for robots that lift a polygon together, with nearly equal loads. */

// docs/write_types.py writes this file from `evenlift --schema`.

export type Metric = "area" | "circle" | "distance" | "distributed" | "random" | "balanced" | "given";

export type Goal = "cover" | "hold";

export type Positions = "best" | "range";

export type LengthUnit = "m" | "cm" | "mm" | "in";

export type WeightUnit = "kg" | "t" | "N" | "lb";

export type Overlay = "candidates" | "chords" | "hull" | "clockwise" | "counterclockwise" | "tipping" | "halo" | "tilt" | "load";

/** The program's options, with _ in place of -. Null counts as not given. */
export interface Settings {
  /** Number of teams, or max for every candidate (default 3). */
  teams?: number | "max" | null;
  /** Area (default), circle, distance, distributed, random, balanced or given. */
  metric?: Metric | null;
  /** Area (default), circle, distance, distributed, random, balanced or given. */
  method?: Metric | null;
  /** Minimum load ratio, 0 to 1 (default 0.8). */
  min_ratio?: number | null;
  /** Centre of mass (default the file's, else the centroid). */
  com?: Point | string | null;
  /** The object's weight (default 100). */
  weight?: number | null;
  /** For the method random (default 1). */
  seed?: number | bigint | string | null;
  /** What a picture or link shows. */
  overlays?: readonly Overlay[] | Overlays | string | null;
  /** Step of the walkthrough that a link opens. */
  step?: number | "none" | null;
  /** C uncertainty: the radius within which the centre of mass is known; loads become ranges. */
  com_radius?: number | null;
  /** Load that one robot can carry: overloaded robots, and the number of robots needed. */
  capacity?: number | "none" | null;
  /** Size of a robot: r, reach, depth and width of the hand, and the gap between robots. */
  robot?: RobotSize | string | null;
  /** No-go edges from 1, or parts of them from 0 to 1. */
  no_go?: readonly (number | string)[] | string | null;
  /** Label of lengths: m, cm, mm or in (default none). */
  unit?: LengthUnit | "none" | null;
  /** Label of weights: kg (default), t, N or lb. */
  weight_unit?: WeightUnit | null;
  /** Cover: the widest lifting base; hold: a hold with the minimum margin first. */
  goal?: Goal | null;
  /** Number of balanced robots, 2 to 64 (default 6). */
  robots?: number | null;
  /** Best: one place for two edges; range: anywhere in their range. */
  positions?: Positions | null;
  /** Minimum margin of a hold (default 0.05). */
  min_margin?: number | null;
  /** Preferred minimum distance between robots (default 0.12 of the object's radius). */
  apart?: number | null;
  /** Number of failures that balanced robots should survive (default 0). */
  survive?: number | null;
  /** Clearance: shorter distances are not relied on, of contacts from corners and, after a failure, of the centre of mass from the edge of the lifting base (default 0.02 of the object's radius). */
  clear?: number | null;
  /** Robots may be off their places by A: searches keep what they promise (default 0). */
  accuracy?: number | null;
  /** Radius of the round body; it overrides that of robot, like the next four. */
  robot_radius?: number | null;
  /** Length of the arm, from the body to the contact. */
  robot_reach?: number | null;
  /** Length of the hand, from the contact to the lifting point. */
  robot_depth?: number | null;
  /** Width of the hand. */
  robot_width?: number | null;
  /** Free distance between two bodies. */
  robot_gap?: number | null;
  /** Robots that already stand, each perhaps with its capacity and name; or a file of them. */
  supports?: readonly (Point | Support)[] | string | null;
  /** Supports within S of the outline stand at the edge (default 1e-4 of its size). */
  snap?: number | null;
  /** Capacity of each support, as many as there are supports; it overrides those in supports. */
  support_capacities?: readonly (number | null)[] | string | null;
  /** Name of each support, as many as there are supports; it overrides those in supports. */
  support_names?: readonly (string | null)[] | string | null;
  /** Loads that are fixed to the object, added to those of the file; none removes those. */
  cargo?: readonly (Cargo | readonly [Point, number] | readonly [Point, number, string])[] | string | null;
  /** Height of the centre of mass, with cargo, above the lifting points: at which slope it tips. */
  com_height?: number | null;
  /** Greatest slope of the plane of the lifting points: a ratio, 8% or 4.6deg. */
  slope?: number | string | null;
  /** Greatest acceleration along the ground in any direction, in g or such as 2m/s2. */
  acceleration?: number | string | null;
  /** Length by which a robot gives way under the mean load. */
  give?: number | "none" | null;
  /** How much the ground or a robot's height is off at most; without --give, loads can reach those at worst. */
  uneven?: number | null;
  /** A further weight, such as a person: where it may stand. */
  extra?: number | "none" | null;
  /** What each support reads, without tare: gives the weight and the centre of mass. */
  readings?: readonly number[] | string | null;
  /** How far a reading may be off: a part of each, such as 1%, or a weight. */
  reading_error?: number | string | null;
  /** How far the lifting points may be from level while one reads, as a slope. */
  level_error?: number | string | null;
  /** What each support reads on the slope of --tilted: gives the height of C. */
  readings_tilted?: readonly number[] | string | null;
  /** Slope of the second weighing: a ratio, 8% or 5deg. */
  tilted?: number | string | null;
  /** Direction uphill of the second weighing: a vector, or an angle such as 90deg. */
  heading?: Point | string | null;
  /** Factor on the greatest loads before they meet a capacity, such as 1.2 (default 1). */
  dynamic?: number | null;
  /** How far the weight may be off, either way: a part of it, such as 5%. */
  weight_doubt?: number | string | null;
}

/** A point of a request: x to the right, y up; a third coordinate is left out, with a notice. */
export type Point = readonly [number, number] | readonly [number, number, number];

/** [x, y] of a result. */
export type Position = [number, number];

/** A robot that already stands. */
export interface Support {
  at: Point;
  /** What this support can carry. */
  capacity?: number | null;
  /** At most 60 characters. */
  name?: string;
}

/** A load that is fixed to the object. */
export interface Cargo {
  /** Its centre of mass, which may overhang. */
  at: Point;
  /** 1e-100 to 1e100. */
  weight: number;
  /** At most 60 characters. */
  name?: string;
}

/** A load as a result lists it. */
export interface CargoItem {
  at: Position;
  weight: number;
  name?: string;
}

/** The size of a robot. */
export interface RobotSize {
  /** Of the round body. */
  radius: number;
  /** Length of the arm, from the body to the contact. */
  reach: number;
  /** Length of the hand, from the contact to the lifting point. */
  depth: number;
  /** Of the hand. */
  width: number;
  /** Free distance between two bodies. */
  gap: number;
}

/** What a picture shows. */
export interface Overlays {
  candidates: boolean;
  chords: boolean;
  hull: boolean;
  clockwise: boolean;
  counterclockwise: boolean;
  tipping: boolean;
  halo: boolean;
  tilt: boolean;
  load: boolean;
}

/** What a request may say of its polygon. */
export interface PolygonOptions {
  /** The vertices of each hole, in place of those of the text; `false` leaves those out. */
  holes?: readonly (readonly Point[])[] | false | null;
  /** Of the object without its cargo; `null` for the centroid. The default is the one in the text, or else the centroid. */
  centre_of_mass?: Point | null;
  /** The same by its name in results; it counts if both are given. */
  own_centre_of_mass?: Point | null;
  /** Robots moved by hand on the page, as a result tells them. */
  moved?: string | null;
  /** Of a text with several shapes: the number, from 1, or name of one. */
  shape?: number | string | null;
  /** Of a drawing: greatest distance of edges from curves (default about 1/1000 of the shape). */
  flatten?: number | null;
  /** Of a drawing: greatest distance of ends that are joined (default up to 1/1000 of the drawing). */
  join?: number | null;
  /** Converts longitudes and latitudes in degrees to metres. */
  project?: boolean | null;
}

/** Settings, and what a request may say of its polygon. */
export interface Options extends Settings, PolygonOptions {
}

/** The weight from the area. */
export interface WeightOptions {
  /** The weight from the area, in place of `weight`: of each square unit, or such as `15.6/m2`. */
  weight_per_area?: number | string | null;
  /** The weight from the area, this thickness and `density`. */
  thickness?: number | string | null;
  /** Of each cubic unit, or such as `7850/m3`. */
  density?: number | string | null;
}

/** What a placement may be asked. */
export interface PlaceOptions extends Settings, PolygonOptions, WeightOptions {
  /** Lists the candidates. */
  candidates?: boolean | null;
  /** The effect of each robot's failure. */
  failures?: boolean | null;
  /** Moves two or three supports to the edge so that all carry the same load. */
  even_out?: boolean | null;
  /** Leaves out supports and holes that do not fit the object, instead of refusing it. */
  keep_misfits?: boolean | null;
  /** The loads in each case. */
  cases?: boolean | null;
  /** Conditions, such as `held, max<=20`. */
  require?: string;
}

/** What all parts may be asked. */
export interface PartsOptions extends PlaceOptions {
  /** The order of the parts, default `file`. */
  sort?: "file" | "number" | "name" | "area" | "weight" | "load";
}

/** What a picture may be asked. */
export interface SvgOptions extends Settings, PolygonOptions {
  /** Shows the candidates. */
  candidates?: boolean | null;
  /** Leaves out supports and holes that do not fit the object. */
  keep_misfits?: boolean | null;
}

/** How robots' poses are written. */
export interface PosesOptions extends Settings, PolygonOptions {
  /** Default `json`; `yaml` is a PoseArray of ROS 2. */
  format?: "csv" | "json" | "yaml";
  /** The frame's name, default `object`. */
  frame?: string;
  /** Default `file`. */
  origin?: "file" | "com";
}

/** How a file is read. */
export interface ShapesOptions {
  /** `false` leaves them out. */
  holes?: boolean | null;
  /** Greatest distance of edges from curves. */
  flatten?: number | null;
  /** Greatest distance of ends that are joined. */
  join?: number | null;
  /** Converts longitudes and latitudes in degrees to metres. */
  project?: boolean | null;
}

/** What an experiment measures. */
export interface ExperimentOptions {
  /** Default 0.8. */
  min_ratio?: number;
  /** Random placements of each polygon, default 200. */
  samples?: number;
  /** Default 1000. */
  max_teams?: number;
  /** Balanced robots, default 12. */
  max_balanced?: number;
}

/** A chord on which a team may stand. */
export interface Candidate {
  ends: [Position, Position];
  /** The shorter half divided by the longer one. */
  ratio: number;
  /** `range` only with `positions` `range`, or for robots with a size. */
  kind: "bisecting" | "vertex" | "midpoint" | "range";
}

/** A team of robots. */
export interface Team {
  /** The left end first (the lower end of a vertical chord). `balanced` gives one team with an end for each robot, counter-clockwise along the outline from the vertex farthest from C, and `given` one in the order of the supports. */
  ends: Position[];
  /** The load ratio; of `balanced` robots the least load divided by the greatest. */
  ratio: number;
  /** In the order of the ends; `null` if the object falls. */
  loads: (number | null)[];
}

/** A robot. */
export interface Robot {
  /** The lifting point. */
  at: Position;
  /** Counted from 0. */
  team: number;
  /** `null` if the object falls. */
  load: number | null;
  /** Where it touches the boundary; `null` beneath the object. */
  contact: Position | null;
  /** The middle of its body; without a size the three are one point. */
  stand: Position;
  /** The direction of the inward normal in degrees, above −180 and up to 180 (at a vertex, the bisector of the normals of its two edges); `null` beneath the object. */
  heading: number | null;
  /** Only a support stands beneath. */
  place: "edge" | "beneath";
  /** Of a support, if it has one. */
  name?: string;
  /** Its number among `supports`, counted from 0, if some are left out. */
  support?: number;
}

/** The loads by the models springs, best and worst. */
export interface LoadModels {
  /** In the order of `robots`, like `worst`. */
  springs: number[];
  /** The least possible greatest load. */
  best: number;
  worst: number[];
}

/** The loads. */
export interface Loads {
  /** As planned, like the next four. */
  min: number;
  mean: number;
  max: number;
  /** `max` − `min`. */
  spread: number;
  /** The greatest share of a team's load that one robot carries. */
  max_share: number;
  /** The loads by the other models; `null` if rounding moves C outside the lifting base. */
  models: LoadModels | null;
  /** With a C uncertainty, a slope, an acceleration (and a height of C), uneven ground (and a give) or an accuracy only: the least and the greatest load of each robot as planned. With an accuracy they include what loads may change, to first order, if all robots are off by it (tables, verdicts and `capacity` do not: they tell `accuracy` in its own sentence). They presume that the robots are set to their planned loads, then keep their heights and yield like equally stiff springs. */
  ranges?: [number, number][];
  /** With `ranges` only: whether a robot may go slack. Then every load lies between the least and the greatest that statics allows, with the weight acting anywhere within reach. */
  may_let_go?: boolean;
}

export type Motion = "clockwise" | "counterclockwise" | "translation";

export interface DependsOn {
  /** Counted from 0. */
  robot: number;
  /** Of its contact from a corner. */
  distance: number;
}

/** How the robots' contact alone holds the object. */
export interface Closure {
  /** Whether no motion is free to first order if robots keep their formation and can push sideways; contacts at convex vertices are not counted. */
  form_closure: boolean;
  /** Strength of the hold; positive in form closure, `null` without contacts. It is the largest-ball measure with one limit for the sum of all contact forces. It depends on C and R, so use it only to compare placements of one object. */
  margin: number | null;
  /** Greatest distance such that the hold needs no contact nearer than this to a corner; `null` if it needs no contact beside a corner, and 0 without form closure. */
  clearance: number | null;
  /** Form closure remains if all robots are off by less than this at once, each along the outline, if robots in inward corners stay there; `null` if it remains in any case, and 0 without form closure. */
  tolerance: number | null;
  /** Whether the object is immobile although first-order motions are free. */
  second_order: boolean;
  /** The motions that are free; empty in form closure. */
  free: Motion[];
  /** A direction of unit length in which it can slide; `null` if it cannot. */
  slides: Position | null;
  /** The robot on whose accuracy the hold depends, since its contact is at the distance `clearance` from a corner. */
  depends_on: DependsOn | null;
  /** Corners of the region of free centres of clockwise rotation whose distance from C, in x and in y, is at most 100 times the diagonal of the bounding box; may be empty (even if the region continues farther out), one point or two points. Clockwise assumes that x points right and y up. */
  clockwise: Position[];
  /** The same for counter-clockwise rotation. */
  counterclockwise: Position[];
}

export interface LimitedBy {
  what: "fits" | "stands" | "hold" | "capacity";
  /** Those that it depends on, counted from 0. */
  robots: number[];
  /** Where one has no more room. */
  edge: number | null;
}

/** How far all robots may be off. Each length is null if what it is about does not hold, or has no limit. */
export interface Accuracy {
  /** The setting. */
  asked: number;
  /** The least of the last four. */
  all_within: number | null;
  limited_by: LimitedBy | null;
  /** Robots off by this still fit. */
  fits_within: number | null;
  /** The object still stands. */
  stands_within: number | null;
  /** They still hold it. */
  hold_within: number | null;
  /** None is overloaded. */
  capacity_within: number | null;
}

/** What the placement survives. */
export interface Robustness {
  /** Tipping distance: the least distance by which C must be off for the object to tip, if robots push back and none is overloaded; 0 with one team of two. If the object falls, minus the distance of C from the lifting base. */
  com_margin: number;
  /** Number of robots that may fail at once, whichever they are, while the others, if strong enough, still carry the object at rest; −1 if it falls already. */
  failures_carried: number;
  /** The number of failures, of whichever robots, after which C is still inside the others' convex hull by more than τL; −1 if C is not that far inside even with all robots, as with one team. */
  failures_steady: number;
  /** The number of failures after which C is still at least `clear` inside. */
  failures_clear: number;
  /** For each robot: the greatest change in its load by springs per unit of length that C moves; `null` if `models` is. */
  load_per_length: number[] | null;
  /** With a C uncertainty only: as given. */
  com_radius?: number;
  /** With a C uncertainty only: the distance that C may be off while the same robots carry the object. */
  exact_within?: number | null;
  /** The same as `loads.ranges`. */
  plan_ranges?: [number, number][];
  /** The same by springs. */
  springs_ranges?: [number, number][];
}

/** When the object tips, in the worst direction. */
export interface Tilt {
  /** H. */
  height: number;
  /** How far from C the weight may act, E + H (S + A √(1 + S²)), where S includes the tilt by uneven heights. */
  reach: number;
  /** Whether the object stays upright then. */
  stays: boolean;
  /** The slope, as a ratio, at which it tips in the worst direction; this and the next two each alone, on level, even ground and with C off by up to E. */
  slope: number;
  /** The same as an angle. */
  degrees: number;
  /** In g. */
  acceleration: number;
  /** At which it tips on the given slope; `null` without one. */
  acceleration_left: number | null;
  /** At which it tips with the given acceleration; `null` without one. */
  slope_left: number | null;
}

/** Where a further load may stand. */
export interface ExtraLoad {
  /** As given; all else is `null` if the object falls. */
  weight: number;
  /** Corners of the convex polygon within the object's bounding box in which the weight lifts no robot off and overloads none. */
  region: Position[] | null;
  /** The share of the object's area in it. */
  share: number | null;
  /** The greatest weight that may stand anywhere on the object; `null` for any weight. */
  anywhere: number | null;
}

export type VerdictCode = "no_place" | "falls" | "tips" | "overloaded" | "left_out" | "misfit" | "fewer_teams" | "not_upright" | "low_coverage" | "not_held" | "inaccurate";

/** Whether the placement is good, and if not, why. */
export interface Verdict {
  /** `bad` if there are no robots, the object falls, it tips under the given conditions, or a robot carries, or within these conditions can carry, more than its capacity as planned; `warning` if a support or hole is left out, there are fewer teams than requested, a robot does not fit, the coverage is below 0.5, C is not clearly inside the lifting base, the object is not `held`, or something may end with robots off by `accuracy`; otherwise `good`. */
  kind: "good" | "warning" | "bad";
  /** Sentences, the most serious first; none if it is good. */
  reasons: string[];
  /** What each of these sentences is about. */
  codes: VerdictCode[];
}

/** A support that does not fit. */
export interface Misfit {
  /** Counted from 0. */
  robot: number;
  /** `outside` (no room for the body), `arm` (it would cross the object), `hand` (it would stick out of the object), `hole` (it would reach into a hole), `no-go`, or, for two that collide, `too near robot 2`, counted from 1. */
  why: string;
  /** Of two that collide, the other one, counted from 0. */
  other?: number;
}

/** What happens if this robot fails. */
export interface Failure {
  /** Counted from 0. */
  robot: number;
  /** Whether the others carry the object; otherwise all members after `clear` are `null`. */
  carried: boolean;
  /** Whether C is inside their convex hull by more than τL. */
  steady: boolean;
  /** Whether C is at least `clear` inside. */
  clear: boolean;
  com_margin: number | null;
  coverage: number | null;
  form_closure: boolean | null;
  /** Also `null` if there are no contacts. */
  margin: number | null;
  /** Greatest load as planned; also `null` if there is no other team. */
  plan_max: number | null;
  springs_max: number | null;
  best_max: number | null;
  /** The load of each robot by springs, 0 for the failed one; `null` for more than 64 robots, for which all failures together would have millions of loads. */
  springs: number[] | null;
  /** With capacities only: whether one of the others carries more than its capacity by springs, under the given conditions; `null` if it does not stay upright under them. */
  over_capacity?: boolean | null;
  /** With capacities only: these robots, counted from 0. */
  overloaded?: number[] | null;
  /** Only if `loads.ranges` exists: the greatest load within the given conditions; `null` if it does not stay. */
  greatest_end?: number | null;
  /** Only if `loads.ranges` exists: whether the object stays upright under the given conditions. */
  stays?: boolean | null;
}

/** The robots needed so that any one of them may fail. */
export interface FailurePlan {
  /** The least number of robots found with which, under the given conditions, none carries more than the limit, both as planned with all robots working and by springs after any one has failed, and C is then at least `clear` inside the lifting base of the others; `null` if no number was found. */
  robots_needed: number | null;
  /** With that number. */
  greatest_load: number | null;
  /** The greatest number of robots tried, 0 if none was. */
  robots_tried: number;
}

/** What robots can carry, and how many are needed. */
export interface Capacity {
  /** The common limit, or `null` if only single supports have one. */
  limit: number | null;
  /** The robots whose planned load exceeds their limit; on slopes, when braked or on uneven ground, those whose greatest end in `loads.ranges` does (`robustness.plan_ranges` also shows which may exceed it if C is anywhere within `com_radius`). Robot 2 *t* + *e* is at end *e* of team *t*, all counted from 0. */
  overloaded: number[];
  /** The least number of teams that keeps every robot within the limit; `null` if there is none. With `given` this and the next three contain no plan: they are `null`, and 0 for the numbers tried. */
  teams_needed: number | null;
  /** With that number. */
  greatest_load: number | null;
  /** The last number of teams tried: at most 512, or 32 for teams that are swapped until they hold, or all teams that find a place; 1 for balanced robots. */
  teams_tried: number;
  /** The number of robots in these teams; for balanced robots the least number, up to 64, that the weight and `survive` need. */
  robots_needed: number | null;
  /** The greatest C uncertainty with which every load by springs stays within the limit; `null` if a load is already beyond it. */
  com_radius: number | null;
  /** On the page `null` for balanced robots until it has been computed, since each number requires a search. */
  if_one_fails: FailurePlan | null;
  /** The greatest use of a robot, under all given conditions; `null` if the object falls or tips under them. */
  use: number | null;
}

/** A condition, and whether it is kept. */
export interface Requirement {
  condition: string;
  /** `null` if there is none. */
  value: number | boolean | null;
  kept: boolean;
}

export type UnusableReason = "no_go" | "body" | "arm" | "corner" | "hand" | "hole" | "near_no_go" | "narrow";

/** The values of settings whose defaults depend on the object. */
export interface Effective {
  /** The setting, or its default of 2 % of R; with `given` less by 1e-4 L, since places that are typed have few digits. */
  clear: number;
  /** The setting, or its default of 12 % of R. */
  apart: number;
  /** The setting, or its default of 1e-4 L. */
  snap: number;
}

/** What the readings of supports tell. */
export interface Weighing {
  /** Of the object with its cargo. */
  weight: number;
  /** How far it may be off. */
  weight_error: number;
  /** Of the object with its cargo. */
  centre_of_mass: Position;
  /** How far that may be off: by errors of readings, `accuracy`, and the height of C times `level_error`. */
  radius: number;
  /** By how much each reading differs from what equally stiff supports on even ground would read; `null` if fewer than four carry. */
  residuals: number[] | null;
  /** Whether errors of readings, and uneven ground if it is given, explain these. */
  fit: boolean | null;
  /** If they do not: the support whose wrong reading would explain most, counted from 0, if it is the only one of at least five that carry. */
  suspect: number | null;
  /** If they do not: by how much each support reads too little if its reading alone is wrong. */
  too_little: number[] | null;
  /** Of C above the lifting points, from a second weighing on a slope. */
  height: number | null;
  /** How far that may be off. */
  height_error: number | null;
  /** Whether the second readings add up to the same weight, or to its part across the slope. */
  height_fits: boolean | null;
}

/** A case of loading. */
export interface LoadCase {
  /** The condition that alone counts; all of them; or all of them after a robot has failed. */
  name: "level" | "com" | "slope" | "acceleration" | "uneven" | "all" | "failure";
  /** That robot, counted from 0. */
  failed: number | null;
  /** The greatest load, as planned; after a failure by springs. `null` if the object falls or can tip. */
  greatest: number | null;
  /** Whose it is. */
  robot: number | null;
  /** The least load; after a failure only without conditions. */
  least: number | null;
  /** The greatest use of a robot. */
  use: number | null;
  /** Whether the object stands and cannot tip. */
  stays: boolean;
}

/** A support or a hole that does not fit the object. */
export interface LeftOut {
  kind: "support" | "hole";
  /** Counted from 0. */
  index: number;
  /** The hole that the support is in; `null` outside the object. */
  in_hole: number | null;
}

/** A support that was moved to even out the loads. */
export interface EvenedOut {
  /** Counted from 0. */
  robot: number;
  /** Where the support stood. */
  from: Position;
  to: Position;
  /** The distance. */
  by: number;
}

/** What evenlift place --json prints. */
export interface Placement {
  /** As given. */
  polygon: Position[];
  /** Only if there are any: as given. */
  holes?: Position[][];
  /** Of the object with its cargo, to which everything else refers. */
  centre_of_mass: Position;
  /** Of the object alone; given to a request, it is the centre of mass of the object without cargo. */
  own_centre_of_mass: Position;
  /** With the cargo, from which all loads are computed. */
  total_weight: number;
  /** Area (default), circle, distance, distributed, random, balanced or given. */
  metric: Metric;
  /** Minimum load ratio, 0 to 1 (default 0.8). */
  min_ratio: number;
  /** The object's weight (default 100). */
  weight: number;
  /** For the method random (default 1). */
  seed: number;
  /** Label of lengths: m, cm, mm or in (default none); only if it is set. */
  unit?: LengthUnit;
  /** Label of weights: kg (default), t, N or lb; only if it is set. */
  weight_unit?: WeightUnit;
  /** Number of balanced robots, 2 to 64 (default 6); only with balanced robots. */
  requested_robots?: number;
  /** Best: one place for two edges; range: anywhere in their range; only if it is set. */
  positions?: Positions;
  /** Minimum margin of a hold (default 0.05); only with balanced robots and with the goal hold. */
  min_margin?: number;
  /** Preferred minimum distance between robots (default 0.12 of the object's radius); only with balanced robots. */
  apart?: number | null;
  /** Number of failures that balanced robots should survive (default 0); only with balanced robots. */
  survive?: number;
  /** Clearance: shorter distances are not relied on, of contacts from corners and, after a failure, of the centre of mass from the edge of the lifting base (default 0.02 of the object's radius). */
  clear: number | null;
  /** Robots that already stand, each perhaps with its capacity and name; or a file of them; only with supports. */
  supports?: Position[];
  /** Supports within S of the outline stand at the edge (default 1e-4 of its size); only with supports. */
  snap?: number;
  /** Capacity of each support, as many as there are supports; it overrides those in supports; only with supports. */
  support_capacities?: (number | null)[];
  /** Name of each support, as many as there are supports; it overrides those in supports; only with supports. */
  support_names?: (string | null)[];
  /** Loads that are fixed to the object, added to those of the file; none removes those; only if it is set. */
  cargo?: CargoItem[];
  /** Height of the centre of mass, with cargo, above the lifting points: at which slope it tips; only if it is set. */
  com_height?: number;
  /** Greatest slope of the plane of the lifting points: a ratio, 8% or 4.6deg; only if it is set. */
  slope?: number;
  /** Greatest acceleration along the ground in any direction, in g or such as 2m/s2; only if it is set. */
  acceleration?: number;
  /** Length by which a robot gives way under the mean load; only if it is set. */
  give?: number;
  /** How much the ground or a robot's height is off at most; without --give, loads can reach those at worst; only if it is set. */
  uneven?: number;
  /** What each support reads, without tare: gives the weight and the centre of mass; only with supports. */
  readings?: number[];
  /** How far a reading may be off: a part of each, such as 1%, or a weight; only with supports. */
  reading_error?: number | string;
  /** How far the lifting points may be from level while one reads, as a slope; only with supports. */
  level_error?: number;
  /** What each support reads on the slope of --tilted: gives the height of C; only with supports. */
  readings_tilted?: number[];
  /** Slope of the second weighing: a ratio, 8% or 5deg; only with supports. */
  tilted?: number;
  /** Direction uphill of the second weighing: a vector, or an angle such as 90deg; only with supports. */
  heading?: Position;
  /** Factor on the greatest loads before they meet a capacity, such as 1.2 (default 1); only if it is set. */
  dynamic?: number;
  /** How far the weight may be off, either way: a part of it, such as 5%; only if it is set. */
  weight_doubt?: number;
  /** If they are asked for: in order of slope, for every method, even if it does not use candidates. */
  candidates?: Candidate[];
  /** With `max` the number of candidates, and with `balanced` and `given` 1. */
  requested_teams: number;
  /** In the order of selection. */
  teams: Team[];
  /** Team by team; missing without a team, like `robustness` and `accuracy`. */
  robots?: Robot[];
  /** Corners of the lifting base, counter-clockwise; empty if there is no team. */
  hull: Position[];
  /** 0 to 1. */
  coverage: number;
  /** `null` if there is no team or the object falls. */
  loads: Loads | null;
  closure: Closure;
  goal: Goal;
  /** Whether robots are placed and, with the goal `hold`, are in firm form closure. */
  goal_reached: boolean;
  /** Whether the robots can carry the object: the centre of mass is in the lifting base. Only supports can fail this, or a placement without robots. */
  stands: boolean;
  /** Whether the robots hold the object: in form closure with a clearance of at least `clear` and a tolerance of at least half of that and of at least `accuracy`, or to second order. */
  held: boolean;
  /** The page's judgement. */
  verdict: Verdict;
  /** With `keep_misfits` only: supports and holes that do not fit the object, and do not count. */
  left_out?: LeftOut[];
  /** With `given` only: the supports that do not fit. */
  misfits?: Misfit[];
  /** With `given`, and only if the object falls: the one or two robots over which it tips, counted from 0. */
  tips_over?: number[];
  /** With `balanced`: `false` if the search was cut short, which happens on large, strongly winding outlines and with many robots, or while the page is still searching. For teams that are swapped until they hold, `false` if the swaps were cut short; otherwise missing. */
  search_ended?: boolean;
  /** Only if `requested_teams` differs from the request: `max`, or with `balanced` and `given` a link's number of teams for the other methods, unless it is 3. Used when the result is reopened. */
  teams_asked?: number | "max";
  /** From a link or the page, unless all are at their defaults. */
  overlays?: Overlays;
  /** From a link with robots moved by hand on the page: their places, in the form used in the link. */
  moved?: string;
  /** This and the next two only if robots have a size, or there are no-go edges. */
  robot?: RobotSize;
  no_go?: string;
  /** The parts of edges that robots cannot use: the edge, counted from 1, from where to where, from 0 to 1, and why. */
  unusable?: [number, number, number, UnusableReason][];
  robustness?: Robustness;
  /** How far robots may be off. */
  accuracy?: Accuracy;
  /** If they are asked for. */
  failures?: Failure[];
  /** When the object tips; `null` without a height of C. */
  tilt: Tilt | null;
  /** With `extra` only. */
  extra?: ExtraLoad;
  /** With `readings` only. */
  weighing?: Weighing;
  /** With capacities only: how much of each robot is used, its greatest planned load under all given conditions, times `dynamic` and 1 + `weight_doubt`, divided by its capacity; `null` without one. */
  use?: (number | null)[];
  /** With `cases` only: the loads in each case. */
  cases?: LoadCase[];
  /** With `capacity` or a support's own capacity only. */
  capacity?: Capacity;
  /** If conditions are required. */
  requirements?: Requirement[];
  /** Lengths that settings have here, whether or not they are set. */
  effective: Effective;
  /** With `even_out` only: the supports that were moved. */
  evened_out?: EvenedOut[];
  /** Of requests only: what was left out of polygon or text, such as third coordinates. */
  notices?: string[];
  /** Of evenlift. */
  version: string;
}

export interface GreedyChoice {
  /** Candidates, counted from 0. */
  taken: number[];
  coverage: number;
}

export interface WidestChoice {
  taken: number[];
  coverage: number;
  /** No choice covers more. */
  bound: number;
  /** Whether no choice covers more than this one. */
  proved: boolean;
}

export interface HoldingChoice {
  taken: number[];
  /** Of the hold, from 0 (none) to 3. */
  level: number;
  coverage: number;
  /** No choice has a higher one. */
  most_level: number;
  /** No choice with that level covers more. */
  bound: number;
  /** Whether no choice is better. */
  proved: boolean;
}

/** How far the greedy choice of teams is from the best one. */
export interface Optimum {
  teams: number;
  /** Their number. */
  candidates: number;
  /** The choice that is placed. */
  greedy: GreedyChoice;
  /** The widest choice that was found. */
  optimum: WidestChoice;
  /** With the goal `hold` only. */
  hold?: HoldingChoice;
  notices?: string[];
}

/** A shape of a drawing or table. */
export interface ImportedShape {
  /** Of the object or its layer; empty if there is none. */
  name: string;
  /** In words, such as `rectangle`. */
  kind: string;
  /** Whether it is the sheet of a drawing rather than a part on it. */
  sheet: boolean;
  /** Greatest distance of edges from curves; `null` without curves. */
  tolerance: number | null;
  /** Outline, holes, cargo and settings: a polygon for all other requests. */
  document: Record<string, unknown>;
}

/** The shapes of a file. */
export interface Shapes {
  /** Such as `DXF`. */
  format: string;
  /** In words, such as `millimetres`; empty if the text names none. */
  unit: string;
  /** Whether what does not close is larger than the largest shape. */
  doubtful: boolean;
  /** Omissions and decisions. */
  notices: string[];
  /** One or more; in a drawing the largest first, and sheets last. */
  shapes: ImportedShape[];
}

/** A part of a drawing. */
export interface Part {
  /** Its number in the file, from 1. */
  shape: number;
  /** Unique, or empty. */
  name: string;
  /** The middle of its bounding box. */
  at: Position;
  /** The width and height of that box. */
  size: Position;
  /** Without holes. */
  area: number;
}

/** A part with its robots. */
export interface PlacedPart extends Part, Placement {
}

/** A part that is refused. */
export interface RefusedPart extends Part {
  /** In place of a placement. */
  error: Problem;
}

/** All parts of a drawing. */
export interface Parts {
  /** Omissions and decisions. */
  notices: string[];
  /** The lines of `evenlift place --shape all --json`. */
  parts: (PlacedPart | RefusedPart)[];
  /** The rows of `--csv`. */
  csv: string;
}

export interface FigureSeries {
  method: Metric;
  /** Robots, value, polygons. */
  points: [number, number, number][];
}

/** A figure of the thesis's chapter 5. */
export interface Figure {
  set: string;
  id: string;
  title: string;
  unit: string;
  column: string;
  sentence: string;
  series: FigureSeries[];
}

/** A statement of the thesis. */
export interface Claim {
  /** Of the thesis. */
  section: string;
  what: string;
  /** What it states. */
  thesis: string;
  /** Our measurements, one text for each set. */
  ours: string[];
}

/** The thesis's statements beside our measurements. */
export interface Claims {
  sets: string[];
  rows: Claim[];
}

export interface FewRobotsRow {
  what: string;
  robots: number;
  cells: string[];
}

export interface FewRobots {
  set: string;
  rows: FewRobotsRow[];
}

export interface Refused {
  polygon: string;
  problem: string;
}

/** The measurements of the thesis's chapter 5. */
export interface Experiment {
  /** CSV, like the next two. */
  measurements: string;
  aggregates: string;
  polygons: string;
  /** Markdown. */
  thesis: string;
  /** Polygons that could not be measured. */
  refused: Refused[];
  figures: Figure[];
  claims: Claims;
  few_robots: FewRobots[];
}

/** The place of an error, of one of these kinds. */
export interface Place {
  /** Of the text, counted from 1. */
  line?: number;
  /** In characters, counted from 1. */
  column?: number;
  /** One or two, counted from 0. */
  vertices?: number[];
  /** One or two, counted from 0: edge i runs from vertex i. */
  edges?: number[];
  /** Of these, or a whole ring: 0 is the outline, 2 the second hole. */
  rings?: number[];
  centre_of_mass?: true;
  /** A setting or another member, or its path, such as `supports[3]`. */
  setting?: string;
  /** In a link, counted from 1; 0 is the whole link. */
  character?: number;
}

/** Why a part is refused. */
export interface Problem {
  /** One word for programs. */
  code: string;
  /** The sentence that the program prints. */
  message: string;
  place: Place | null;
  /** Of the member at fault, counted from 0: `cargo[2].weight`, `polygon[3]`. */
  path: string | null;
}

/** Vertices; the text or bytes of a file of any format that the program reads, or a share link; or a result or document of evenlift.
 * A link and a document set the defaults of the settings. */
export type Polygon = readonly Point[] | string | Uint8Array | Placement | Record<string, unknown>;

/** A step of the algorithm. */
export interface Step extends Record<string, unknown> {
  kind: string;
  chapter: string;
  caption: string;
}

/** Thrown by all functions except `run`; `message` is a sentence with the problem and its place. */
export class EvenliftError extends Error {
  readonly name: "EvenliftError";
  readonly code: string;
  readonly place: Place | null;
  /** Of the argument's member at fault: `cargo[2].weight`, `polygon[3]`. */
  readonly path: string | null;
}

export function place(polygon: Polygon, options?: PlaceOptions | null): Placement;

/** The places for teams of two, in order of slope. Only `min_ratio`, `centre_of_mass`, `positions`, the robots' size and `no_go`
 * have an effect, and `clear` with positions `"range"`. */
export function candidates(polygon: Polygon, options?: Options | null): Candidate[];

/** SVG text. */
export function svg(polygon: Polygon, options?: SvgOptions | null): string;

/** The text of a file. */
export function poses(polygon: Polygon, options?: PosesOptions | null): string;

/** The share link, without `#`. */
export function link(polygon: Polygon, options?: Options | null): string;

/** How far the greedy choice of teams is from the best one. */
export function optimum(polygon: Polygon, options?: Options | null): Optimum;

/** The algorithm's steps in order, with this polygon's numbers. */
export function trace(polygon: Polygon, options?: Options | null): Step[];

/** All shapes of a file: a drawing, a table, or any other format that the program reads. */
export function shapes(file: string | Uint8Array, options?: ShapesOptions | null): Shapes;

/** Robots for each shape of a file, which may have a weight by its area and, with a capacity, its own number of robots. */
export function parts(file: string | Uint8Array, options?: PartsOptions | null): Parts;

/** The measurements of the thesis's chapter 5, over many polygons. */
export function experiment(
  polygons: readonly {
    name?: string;
    set?: string;
    polygon?: readonly Point[];
    holes?: readonly (readonly Point[])[];
    text?: string;
    document?: Placement | Record<string, unknown>;
    centre_of_mass?: Point | null;
  }[],
  settings?: ExperimentOptions | null,
): Experiment;

/** The answer as text, as from the C function `evenlift_run`. An invalid request gets `{"error": …}`. */
export function run(request: string | object): string;

export const version: string;
