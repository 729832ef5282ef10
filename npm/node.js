// For Node and its worker threads.
import { readFile } from "node:fs/promises";
import { createApi } from "./api.js";

export { EvenliftError } from "./api.js";
export const { run, place, candidates, svg, poses, link, optimum, trace, shapes, parts, experiment, version } =
  createApi(await WebAssembly.compile(await readFile(new URL("evenlift.wasm", import.meta.url))));
