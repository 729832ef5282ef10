// The window that compares the methods over many polygons, as chapter 5 of the thesis does: computed by workers, shown as
// charts.
import { runExperiment } from "./crew.js";
import { ensureStyles, openWindow, problemLine } from "./dialogs.js";
import { button, download, el, number } from "./elements.js";
import { figureTable } from "./figure_table.js";
import { fetchJson } from "./fetched.js";
import { svgToText } from "./svg_import.js";

const mostBytes = 64 * 1024 * 1024;  // core/include/evenlift/document.h
let kept;  // the results of the last run: closing the window does not lose them

const nameOf = (file) => file.name.replace(/\.[^.]*$/, "") || file.name;
const count = (n, word) => `${number(n)} ${word}${n === 1 ? "" : "s"}`;

async function textOf(file) {
  if (file.size > mostBytes) throw new Error("it has more than the 64 MiB that evenlift reads");
  const text = await file.text().catch(() => {
    throw new Error("it cannot be read");
  });
  if (text.includes("\0")) throw new Error("it is not a text");
  return /^\s*</.test(text) ? svgToText(text) : text;
}

// Polygons as the workers' crew takes them; files of one name would be one polygon.
function polygonsOf(files) {
  const names = files.map(nameOf);
  const twice = names.find((name, at) => names.indexOf(name) !== at);
  if (twice !== undefined) throw new Error(`Two files have the name “${twice}”`);
  return files.map((file, at) => ({ name: names[at], read: () => textOf(file) }));
}

async function samplesAsPolygons() {
  return (await fetchJson("samples.json")).map(({ name, text }) => ({ name, read: async () => text }));
}

export async function show() {
  const view = new ExperimentWindow();
  await Promise.all([ensureStyles("experiment.css"), ensureStyles("charts.css")]);
  const root = await openWindow({
    name: "experiment",
    title: "Compare methods",
    body: [el("div", { class: "scroll" }, view.form, view.problem, view.running, view.results), view.footer],
    focus: view.start,
    closed: () => view.close(),
  });
  if (root) view.connect(root);
}

class ExperimentWindow {
  #files = [];
  #stop;  // of the run that is under way
  #charts = [];  // what ends their following the width

  constructor() {
    this.problem = problemLine();
    this.start = button("Compare", { class: "button primary", onclick: () => this.#run() });
    this.cancel = button("Cancel", { onclick: () => this.#stop?.abort(new DOMException("cancelled", "AbortError")) });
    this.bar = el("progress", { "aria-label": "Polygons measured", max: "1", value: "0" });
    this.now = el("p", { class: "second" });
    this.said = el("p", { class: "for-readers", role: "status" });
    this.running = el("div", { class: "running", hidden: true }, el("div", { class: "row" }, this.bar, this.cancel), this.now);
    this.results = el("div", { class: "results" });
    this.footer = el("footer", {}, this.said);
    this.form = this.#makeForm();
  }

  #makeForm() {
    this.file = el("input", { type: "file", multiple: true, class: "for-readers", tabindex: "-1", "aria-hidden": "true", accept: ".txt,.wkt,.json,.geojson,.svg,text/plain,application/geo+json,image/svg+xml" });
    this.file.addEventListener("change", () => {
      this.#take([...this.file.files]);
      this.file.value = "";  // the same files may be chosen again
    });
    const choice = (value, text) => el("label", { class: "radio" }, el("input", { type: "radio", name: "polygons", value, checked: value === "samples" }), text);
    this.own = el("span", {}, "My files");
    this.choose = button("Choose files …", { onclick: () => this.file.click() }, "file");
    this.samples = el("input", { class: "field", type: "number", min: "1", max: "100000", step: "1", value: "200", inputmode: "numeric" });
    this.ratio = el("input", { class: "field", type: "number", min: "0", max: "1", step: "any", value: "0.8", inputmode: "decimal" });
    return el("form", { class: "experiment", onsubmit: (event) => {
      event.preventDefault();
      this.#run();
    } },
      el("p", {}, "Every method with every number of teams on many polygons, as in chapter 5 of the thesis. It is computed here; nothing is sent anywhere."),
      el("fieldset", {}, el("legend", {}, "Polygons"), choice("samples", "The samples"), choice("files", this.own), this.choose, this.file),
      el("fieldset", {}, el("legend", {}, "Settings"),
        el("label", {}, "Random placements ", this.samples), el("label", {}, "Minimum load ratio ", this.ratio), this.start));
  }

  connect(root) {
    for (const type of ["dragover", "drop"]) {
      root.addEventListener(type, (event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        event.preventDefault();
        event.stopPropagation();  // the page would open them
        if (type === "drop") this.#take([...event.dataTransfer.files]);
      });
    }
    if (kept) this.#show(kept);
  }

  close() {
    this.#stop?.abort(new DOMException("closed", "AbortError"));
    this.#forgetCharts();
  }

  #take(files) {
    if (files.length === 0 || this.#stop) return;
    this.#files = files;
    this.own.textContent = `My files (${number(files.length)})`;
    this.form.querySelector("[value=files]").checked = true;
    this.problem.say("");
  }

  async #polygons() {
    if (this.form.querySelector("[value=samples]").checked) {
      return samplesAsPolygons().catch((error) => {
        throw new Error(`The samples cannot be fetched: ${error.message}`);
      });
    }
    if (this.#files.length === 0) throw new Error("Choose files first, or drop them here");
    return polygonsOf(this.#files);
  }

  async #run() {
    if (this.#stop) return;
    const stop = new AbortController();
    this.#stop = stop;
    this.problem.say("");
    this.#toggle(true);
    this.now.textContent = "Getting ready …";
    this.bar.removeAttribute("value");
    try {
      const polygons = await this.#polygons();
      this.said.textContent = `Measuring ${count(polygons.length, "polygon")}.`;
      const outputs = await runExperiment(polygons, {
        minRatio: this.ratio.valueAsNumber, samples: this.samples.valueAsNumber, signal: stop.signal,
        progress: (done, name) => {
          this.bar.value = done / polygons.length;
          this.now.textContent = `${number(done)} of ${number(polygons.length)}: ${name}`;
        },
      });
      kept = outputs;
      this.#show(outputs);
      this.said.textContent = `Done: ${count(polygons.length, "polygon")}.`;
    } catch (error) {
      if (error.name === "AbortError") this.said.textContent = "Cancelled.";
      else this.problem.say(error.message.charAt(0).toUpperCase() + error.message.slice(1));
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
  }

  #forgetCharts() {
    for (const end of this.#charts) end();
    this.#charts = [];
  }

  async #show(outputs) {
    this.#forgetCharts();
    const csv = (text, name) => () => download(new Blob([text], { type: "text/csv" }), `evenlift-${name}.csv`);
    this.footer.replaceChildren(this.said,
      button("Measurements (CSV)", { onclick: csv(outputs.measurements, "measurements"), title: "Save every measurement" }, "save"),
      button("Averages (CSV)", { onclick: csv(outputs.aggregates, "aggregates"), title: "Save what the charts show" }, "save"));
    const places = outputs.figures.map((figure) => el("div", { class: "plot", "data-figure": figure.id }));
    const figures = outputs.figures.map((figure, at) => el("figure", {},
      el("h3", {}, `${figure.title} (${figure.unit})`), places[at], el("figcaption", {}, figure.sentence),
      el("details", {}, el("summary", {}, "Numbers"), el("div", { class: "wide", tabindex: "0", role: "region", "aria-label": `Numbers of figure ${figure.id}` }, figureTable(figure)))));
    this.results.replaceChildren(...this.#refused(outputs), el("div", { class: "figures" }, ...figures), this.#claims(outputs));
    const charts = await import("./charts.js");
    if (charts.missing) {
      this.results.prepend(el("p", { class: "problem" }, "The charts are missing: this page was built without what draws them. Their numbers are below."));
      return;
    }
    outputs.figures.forEach((figure, at) => {
      if (!places[at].isConnected) return;
      places[at].before(charts.legend([figure]));
      this.#charts.push(charts.follow(places[at], figure));
    });
  }

  // What was left out, from the rows of polygons.csv that say why.
  #refused({ refused }) {
    if (refused.length === 0) return [];
    return [el("div", { class: "problem", role: "status" }, `${count(refused.length, "polygon")} could not be read and ${refused.length === 1 ? "was" : "were"} left out:`,
      el("ul", {}, ...refused.map(({ polygon, problem }) => el("li", {}, `${polygon}: ${problem}`))))];
  }

  #claims({ claims }) {
    return el("details", { class: "claims" }, el("summary", {}, "Against the thesis: what its chapter 5 states, and these polygons"),
      el("div", { class: "wide", tabindex: "0", role: "region", "aria-label": "Against the thesis" }, el("table", {},
        el("thead", {}, el("tr", {}, ...["Section", "What", "The thesis", "Here"].map((name) => el("th", { scope: "col" }, name)))),
        el("tbody", {}, ...claims.map(({ section, what, thesis, ours }) => el("tr", {}, el("td", {}, section), el("th", { scope: "row" }, what), el("td", {}, thesis), el("td", {}, ours)))))));
  }
}
