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
