// The page's windows, and functions that open texts from outside: one file, loaded at the first use.
export { ensureStyles } from "../kit/dialogs.js";
export { curves, show as experiment } from "../experiment/experiment.js";
export { show as cases } from "./cases.js";
export { show as challenge } from "./challenge.js";
export { show as about } from "./about.js";
export { show as samples } from "./gallery.js";
export { show as glossary } from "../lessons/glossary.js";
export { show as keys } from "./keys.js";
export { beginFromAddress } from "../lessons/lesson_source.js";
export { show as lessons } from "../lessons/lessons.js";
export { changeLanguage as language } from "../page/language.js";
export { newVersion } from "./new_version.js";
export { show as optimum } from "./optimum.js";
export { show as open, take } from "./open.js";
export { show as save } from "./save.js";
export { show as table, weigh } from "./table.js";
export { firstVisit, welcome } from "./welcome.js";
