// Measures polygons for experiment.js, and compares with the optimum for ../windows/optimum.js, so that the page stays
// responsive.
import createModule from "./experiment_core.js";
import { Program } from "../page/program.js";

const started = createModule().then((module) => new Program(module));

const tasks = {
  speak: (program, { words }) => program.speak(words),
  begin: (program, { minRatio, samples, weight, weightUnit, mostTeams, mostBalanced }) =>
    program.text("experiment_begin", minRatio, samples, weight, weightUnit, mostTeams, mostBalanced),
  measure: (program, { set, name, text, method }) => program.text("experiment_measure", set, name, text, method),
  refuse: (program, { set, name, problem }) => program.text("experiment_refuse", set, name, problem),
  optimum(program, { link, seconds }) {
    const found = program.json("optimum_compare", link, seconds);
    return { found, pictures: found.problem ? [] : [0, 1].map((best) => program.text("optimum_picture", best)) };
  },
  results(program, { parts, onePolygon }) {
    for (const part of parts) if (!program.number("experiment_add", part)) throw new Error("a part cannot be read");
    return program.json("experiment_results", onePolygon ? 1 : 0);
  },
};

addEventListener("message", async ({ data: { id, task, ...given } }) => {
  try {
    postMessage({ id, answer: tasks[task](await started, given) });
  } catch (error) {
    postMessage({ id, problem: error.message });
  }
});
