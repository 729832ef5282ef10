// For the report of `evenlift experiment`.
import { follow, legend } from "./charts.js";

const figures = JSON.parse(document.getElementById("figures").textContent);
for (const figure of figures) {
  const place = document.querySelector(`[data-figure="${figure.id}"][data-set="${CSS.escape(figure.set)}"] .plot`);
  if (!place) continue;
  place.before(legend([figure]));
  follow(place, figure);
}
