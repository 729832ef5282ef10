// A worker that measures polygons for the window of experiments (web/experiment.js), so that the page stays smooth.
import createModule from "./experiment_core.js";
import { Program } from "./program.js";

const started = createModule().then((module) => new Program(module));

const tasks = {
  measure: (program, { name, text, minRatio, samples }) => program.text("experiment_measure", name, text, minRatio, samples),
  refuse: (program, { name, problem }) => program.text("experiment_refuse", name, problem),
  check: (program, { minRatio, samples }) => program.text("experiment_problem", minRatio, samples),
  results(program, { parts }) {
    for (const part of parts) if (!program.number("experiment_add", part)) throw new Error("a part cannot be read");
    return JSON.parse(program.text("experiment_results"));
  },
};

addEventListener("message", async ({ data: { id, task, ...given } }) => {
  try {
    postMessage({ id, answer: tasks[task](await started, given) });
  } catch (error) {
    postMessage({ id, problem: error.message });
  }
});
