// The window that compares the methods, on the open polygon or on many, as chapter 5 of the thesis does.
import { runExperiment } from "./worker_pool.js";
import { ensureStyles, openWindow, problemLine } from "../kit/dialogs.js";
import { button, download, el, typedNumber } from "../kit/elements.js";
import { showResults } from "./experiment_results.js";
import { ownFiles, samples, thesisLike, thisPolygon } from "./experiment_sources.js";
import { asRead, number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";

// As in `evenlift experiment`.
const manyPolygons = { weight: 100, weightUnit: "kg", mostTeams: 1000 };

function withoutTeams({ figures }) {
  if (figures.some(({ series }) => series.some(({ method }) => method !== "balanced"))) return "";
  return figures.length > 0
    ? "No chord through the centre of mass meets this minimum load ratio: the algorithm can place no team here, so only balanced robots were measured."
    : "No chord through the centre of mass meets this minimum load ratio: the algorithm can place no team here, and there are no balanced robots either, so nothing was measured.";
}

let kept; // the last results and what they describe, even after closing the window

// A number as the reader writes it, within limits.
function numberField({ value, min, max, whole = false }) {
  const field = el("input", {
    class: "field",
    type: "text",
    size: "6",
    inputmode: whole ? "numeric" : "decimal",
    autocomplete: "off",
    value: asRead(String(value)),
  });
  field.addEventListener("input", () => {
    const typed = typedNumber(field.value);
    const isGood = typed >= min && typed <= max && (!whole || Number.isInteger(typed));
    field.setCustomValidity(isGood ? "" : say("Type a number from {min} to {max}.", { min, max: number(max) }));
  });
  return field;
}

const polygons = (n) => (n === 1 ? translated("1 polygon") : say("{number} polygons", { number: number(n) }));

export async function show(page, { start = false, source = "this" } = {}) {
  const view = new ExperimentWindow(page, source);
  await Promise.all([ensureStyles("experiment.css"), ensureStyles("charts.css")]);
  const root = await openWindow({
    name: "experiment",
    title: "Compare methods",
    body: [el("div", { class: "scroll" }, view.form, view.problem, view.running, view.said, view.results), view.footer],
    focus: view.form.querySelector(":checked"), // at its beginning, even if not all of it is visible; Enter compares
    closed: () => view.close(),
  });
  if (root) view.connect(root, start);
}

export const curves = (page) => show(page, { start: true });

// New content below a form that fills the window would go unnoticed.
function reveal(element) {
  const { top, height } = element.closest(".scroll").getBoundingClientRect();
  if (element.getBoundingClientRect().top > top + height * 0.7) element.scrollIntoView({ block: "start" });
}

class ExperimentWindow {
  #polygon; // its text in the thesis's format, and the settings that affect it
  #files = [];
  #stop; // of the run under way
  #charts = []; // functions that end the charts' updates

  constructor({ program }, source) {
    this.#polygon = {
      text: program.text("page_text"),
      minRatio: program.number("page_min_ratio"),
      weight: program.number("page_weight"),
      weightUnit: program.text("page_weight_unit"),
      points: program.number("page_robots_are_points") === 1,
    };
    this.problem = problemLine();
    this.start = button("Compare", { class: "button primary", onclick: () => this.#run() });
    this.cancel = button("Cancel", { onclick: () => this.#stop?.abort(new DOMException("cancelled", "AbortError")) });
    this.bar = el("progress", { "aria-label": "Progress of the measurement", max: "1", value: "0" });
    this.now = el("p", { class: "second" });
    this.said = el("p", { class: "second said", role: "status" });
    this.running = el(
      "div",
      { class: "running", hidden: true },
      el("div", { class: "row" }, this.bar, this.cancel),
      this.now,
    );
    this.results = el("div", { class: "results" });
    this.footer = el("footer", {});
    this.form = this.#makeForm();
    this.form.querySelector(`[value=${source}]`).checked = true;
    this.#chosenChanged();
  }

  #makeForm() {
    this.file = el("input", {
      type: "file",
      multiple: true,
      class: "for-readers",
      tabindex: "-1",
      "aria-hidden": "true",
      accept:
        ".txt,.csv,.tsv,.svg,.dxf,.json,.geojson,.wkt,text/plain,text/csv,image/svg+xml,image/vnd.dxf,application/json,application/geo+json",
    });
    this.file.addEventListener("change", () => {
      this.#take([...this.file.files]);
      this.file.value = ""; // the same files may be chosen again
    });
    const choice = (value, text) =>
      el(
        "label",
        { class: "radio" },
        el("input", { type: "radio", name: "polygons", value, onchange: () => this.#chosenChanged() }),
        text,
      );
    this.own = el("span", {}, "My files");
    this.choose = button("Choose files …", { onclick: () => this.file.click() }, "file");
    this.samples = numberField({ value: 200, min: 1, max: 100000, whole: true });
    this.ratio = numberField({ value: 0.8, min: 0, max: 1 });
    this.ratioLabel = el("label", {}, "Minimum load ratio ", this.ratio);
    // Enough for clear curves.
    this.most = numberField({ value: 30, min: 1, max: 10000, whole: true });
    this.mostLabel = el("label", {}, "Max. teams ", this.most);
    // Up to 12, as `evenlift experiment` measures, takes five times as long as up to 8.
    this.balanced = numberField({ value: 8, min: 2, max: 64, whole: true });
    this.ownSettings = el(
      "p",
      { class: "second" },
      say("With its own centre of mass, minimum load ratio {minRatio} and weight {weight} {weightUnit}.", {
        ...this.#polygon,
        minRatio: asRead(String(this.#polygon.minRatio)),
        weight: number(this.#polygon.weight),
      }),
    );
    return el(
      "form",
      {
        class: "experiment",
        onsubmit: (event) => {
          event.preventDefault();
          this.#run();
        },
      },
      el(
        "p",
        {},
        "Loads, coverage and form closure by every method, with every number of robots: on this polygon, or averaged over many. Everything is computed here; nothing is sent anywhere.",
      ),
      el(
        "fieldset",
        {},
        el("legend", {}, "Polygons"),
        choice("this", "This polygon"),
        choice("samples", "All samples, some with a moved centre of mass"),
        choice("thesis", "Random polygons, as in the thesis behind evenlift"),
        choice("files", this.own),
        this.choose,
        this.file,
      ),
      el(
        "fieldset",
        {},
        el("legend", {}, "Settings"),
        el("label", {}, "Random placements of each polygon ", this.samples),
        this.ratioLabel,
        this.mostLabel,
        el("label", {}, "Max. balanced robots ", this.balanced),
        this.ownSettings,
        this.start,
      ),
    );
  }

  get #chosen() {
    return this.form.querySelector("[name=polygons]:checked").value;
  }

  #chosenChanged() {
    const one = this.#chosen === "this";
    this.ratioLabel.hidden = one;
    this.mostLabel.hidden = !one;
    this.ownSettings.hidden = !one;
  }

  connect(root, start) {
    for (const type of ["dragover", "drop"]) {
      root.addEventListener(type, (event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        event.preventDefault();
        event.stopPropagation(); // else the page would open them
        if (type === "drop") this.#take([...event.dataTransfer.files]);
      });
    }
    if (start) this.#run();
    else if (kept && (!kept.of || this.#isOn(kept.of))) this.#show();
  }

  // Whether the results of a single polygon describe the open one.
  #isOn(of) {
    return ["text", "minRatio", "weight", "weightUnit", "points"].every((name) => of[name] === this.#polygon[name]);
  }

  close() {
    this.#stop?.abort(new DOMException("closed", "AbortError"));
    this.#forgetCharts();
  }

  #take(files) {
    if (files.length === 0 || this.#stop) return;
    this.#files = files;
    this.own.textContent = say("My files ({number})", { number: number(files.length) });
    this.form.querySelector("[value=files]").checked = true;
    this.#chosenChanged();
    this.problem.say("");
  }

  async #plan() {
    const random = typedNumber(this.samples.value),
      mostBalanced = typedNumber(this.balanced.value);
    const upTo = say("At most {number} balanced robots are measured, since the search for more takes longer.", {
      number: number(mostBalanced),
    });
    if (this.#chosen === "this") {
      const { minRatio, weight, weightUnit, points } = this.#polygon;
      const mostTeams = typedNumber(this.most.value);
      const measured = say(
        "This polygon at a minimum load ratio of {minRatio} and a weight of {weight} {unit}, with up to one team for each candidate, at most {most}.",
        { minRatio: asRead(String(minRatio)), weight: number(weight), unit: weightUnit, most: number(mostTeams) },
      );
      const asPoints = points
        ? []
        : [translated("Robots count as points here: their size and no-go edges are ignored.")];
      return {
        tasks: thisPolygon(this.#polygon),
        counting: "{done} of {all} methods: {title}",
        of: this.#polygon,
        settings: { minRatio, samples: random, weight, weightUnit, mostTeams, mostBalanced },
        caption: [measured, ...asPoints, upTo].join(" "),
      };
    }
    const tasks = await { samples, thesis: thesisLike, files: async () => ownFiles(this.#files) }[this.#chosen]();
    const names = {
      samples: "All samples",
      thesis: "Random polygons, as in the thesis behind evenlift",
      files: "My files",
    };
    const minRatio = typedNumber(this.ratio.value);
    return {
      tasks,
      counting: "{done} of {all} polygons: {title}",
      settings: { ...manyPolygons, mostBalanced, minRatio, samples: random },
      caption: `${say("{set}: {polygons}, at a minimum load ratio of {minRatio} and a weight of 100 kg.", {
        set: names[this.#chosen],
        polygons: polygons(tasks.length),
        minRatio: asRead(String(minRatio)),
      })} ${upTo}`,
    };
  }

  async #run() {
    if (this.#stop) return;
    const stop = new AbortController();
    this.#stop = stop;
    this.problem.say("");
    this.said.textContent = "";
    this.#toggle(true);
    this.now.textContent = translated("Preparing …");
    this.bar.removeAttribute("value");
    let partly = false;
    try {
      const { tasks, counting, settings, caption, of } = await this.#plan();
      const outputs = await runExperiment(tasks, {
        settings,
        onePolygon: of !== undefined,
        signal: stop.signal,
        partly: async (some) => {
          if (some.figures.length === 0) return;
          kept = { outputs: some, caption: `${caption} ${translated("Their results are still missing.")}`, of };
          await this.#show();
          if (!partly) reveal(this.results);
          partly = true;
        },
        progress: (done, title) => {
          this.bar.value = done / tasks.length;
          this.now.textContent = say(counting, { done: number(done), all: number(tasks.length), title });
        },
      });
      kept = { outputs, caption, of };
      await this.#show();
      if (!partly) reveal(this.results);
      this.said.textContent = of ? translated("Done.") : say("Done: {polygons}.", { polygons: polygons(tasks.length) });
    } catch (error) {
      const why = translated(error.message);
      if (error.name === "AbortError")
        this.said.textContent = translated(
          partly ? "Cancelled; balanced robots are missing." : "Cancelled; nothing of this comparison is kept.",
        );
      else this.problem.say(why.charAt(0).toUpperCase() + why.slice(1));
    } finally {
      this.#stop = undefined;
      this.#toggle(false);
    }
  }

  #toggle(running) {
    const focused = this.form.contains(document.activeElement) || this.running.contains(document.activeElement);
    this.running.hidden = !running;
    for (const control of this.form.querySelectorAll("input, button")) control.disabled = running;
    if (focused) (running ? this.cancel : this.start).focus({ preventScroll: true });
    if (running) reveal(this.running);
  }

  #forgetCharts() {
    for (const end of this.#charts) end();
    this.#charts = [];
  }

  async #show() {
    const { outputs, caption, of } = kept;
    this.#forgetCharts();
    const save = (name, text, file, title) =>
      button(
        name,
        { onclick: () => download(new Blob([text], { type: "text/csv" }), `evenlift-${file}.csv`), title },
        "save",
      );
    this.footer.replaceChildren(
      save("Measurements (CSV)", outputs.measurements, "measurements", "Save every measurement"),
      ...(of ? [] : [save("Averages (CSV)", outputs.aggregates, "averages", "Save the numbers of the charts")]),
    );
    this.#charts = await showResults(this.results, outputs, (of && withoutTeams(outputs)) || caption);
  }
}
