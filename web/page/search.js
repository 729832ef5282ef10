// Searches for balanced robots in a worker: the page has already shown the start if that is quick, and better results
// replace it. If a capacity is set, the worker computes instead the number of robots needed when any one may fail.
import { Core } from "./core.js";
import { begin, end } from "./work.js";

// `call` calls the program. begin() ends any search under way.
export function createSearch(call) {
  let core;
  let wanted = 0; // the number of the search under way, or 0

  // A search that is no longer wanted would keep its worker.
  function stop() {
    if (!wanted) return;
    wanted = 0;
    core.end();
    end();
  }

  // The search ends before the program takes its result, since the program may begin another one at once.
  async function search(number, request) {
    const goesOn = () => wanted === number;
    const tell = (...result) => {
      if (!goesOn()) return;
      wanted = 0;
      call(...result);
      end();
    };
    const progress = ({ robots }) => goesOn() && call("page_take_robots", number, robots, 0);
    await core.ask(request, { progress }).then(
      ({ robots, cut_short }) => tell("page_take_robots", number, robots, cut_short ? 2 : 1),
      () => tell("page_search_failed", number),
    );
  }

  return {
    begin(number, polygon, settings, robots) {
      stop();
      begin();
      wanted = number;
      if (!core || core.ended) core = new Core();
      search(number, { command: "search", polygon, settings, robots });
    },
    end: stop,
  };
}
