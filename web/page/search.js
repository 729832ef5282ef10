// Searches for balanced robots in a worker: the page has already shown the start if that is quick, and better results
// replace it. If a capacity is set, the worker computes instead the number of robots needed when any one may fail.
import { Core } from "./core.js";
import { begin, end } from "./work.js";

// `call` calls the program. begin() ends any search under way.
export function createSearch(call) {
  let core;
  let wanted = 0; // the number of the search under way, or 0

  function over() {
    if (!wanted) return;
    wanted = 0;
    end();
  }

  // A search that is no longer wanted would keep its worker.
  function stop() {
    if (wanted) core.end();
    over();
  }

  async function search(number, request) {
    const goesOn = () => wanted === number;
    try {
      const progress = ({ robots }) => goesOn() && call("page_take_robots", number, robots, 0);
      const { robots } = await core.ask(request, { progress });
      if (goesOn()) call("page_take_robots", number, robots, 1);
    } catch {
      if (goesOn()) call("page_search_failed", number);
    }
    if (goesOn()) over();
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
