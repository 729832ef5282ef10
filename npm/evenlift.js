// For browsers, their workers, and bundlers; node.js is for Node.
import { createApi } from "./api.js";

async function compile(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url} cannot be fetched: the server answered ${answer.status}`);
  return WebAssembly.compile(await answer.arrayBuffer()); // whatever type the server declares
}

export { EvenliftError } from "./api.js";
export const { run, place, candidates, svg, poses, link, optimum, trace, shapes, parts, experiment, version } =
  createApi(await compile(new URL("evenlift.wasm", import.meta.url)));
