// Continues a search for balanced robots (wasm/modules/searching_api.cpp) in slices, between which other tasks run.
// Calls `found(robots, ended)` for better robots, at most once in `betweenNews` milliseconds, and at the end.
// `goesOn()` returns whether the result is still needed. Throws if the problem cannot be read.
const betweenNews = 100;

const turn = () => new Promise((done) => setTimeout(done));

export async function search(program, { polygon, settings, robots }, { slice, goesOn, found }) {
  if (!program.number("balanced_begin", polygon, settings, robots)) throw new Error("the search cannot begin");
  let told = robots;
  let toldAt = performance.now();
  for (let ended = false; !ended;) {
    await turn();
    if (!goesOn()) return;
    ended = program.number("balanced_go_on", slice) === 1;
    const now = performance.now();
    if (!ended && now < toldAt + betweenNews) continue;
    const better = program.text("balanced_robots");
    if (!ended && better === told) continue;
    told = better;
    toldAt = now;
    found(better, ended);
  }
}
