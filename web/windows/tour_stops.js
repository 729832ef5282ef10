// The stops of the tour: texts, and the places at which they point (tour_places.js).
import { say, translated } from "../words/words.js";

// There may be no hatching.
function mobility({ free, heldByCurvature }) {
  const turns = { clockwise: "clockwise in red", counterclockwise: "counter-clockwise in blue" };
  const hatched = Object.keys(turns)
    .filter((turn) => free.includes(turn))
    .map((turn) => translated(turns[turn]))
    .join(", ");
  if (heldByCurvature)
    return "Here it cannot, as long as no robot gives way, but only the curvature of its motion holds it. Hatching would show the points about which it could turn.";
  if (!free.length)
    return "Here it cannot, as long as no robot gives way: the robots hold it. Hatching would show the points about which it could turn.";
  if (!hatched) return "It cannot turn, so nothing is hatched; but it can slide, as the arrow shows.";
  const turning = say("Hatching shows the points about which it can turn: {turns}.", { turns: hatched });
  return free.includes("translation") ? `${turning} ${translated("The arrow shows how it slides.")}` : turning;
}

const finger = () => matchMedia("(pointer: coarse)").matches;

// `points` returns the shapes to ring: circles [x, y, radius], boxes [x, y, width, height], lines [from, to]. If it is
// undefined, `controls` are ringed; if a small screen hides them, the handle of their sheet or, with `menu`, the menu
// button. A stop whose `where` does not hold is left out.
export const stops = [
  {
    title: "Teams",
    where: ({ balanced, team }) => !balanced && team,
    words: () =>
      "The two ringed discs are a team. They stand at the ends of a chord, a line through C, the centre of mass. You can drag every robot.",
    points: (here) => here.discs(here.team),
  },
  {
    title: "Robots",
    where: ({ balanced, team }) => balanced && team,
    words: () =>
      "Each disc is a robot. Thin lines join the robots to C, the centre of mass. It is their centroid, so they balance the object.",
    points: (here) => here.discs(),
  },
  {
    title: "Loads",
    where: ({ balanced, team }) => !balanced && team,
    words: () =>
      "The number beside each ringed disc is the robot’s planned load. C nearly halves each chord, so the loads of a team are nearly equal.",
    points: (here) => here.discs(here.team),
  },
  {
    title: "Loads",
    where: ({ balanced, team }) => balanced && team,
    words: () =>
      "The number beside each ringed disc is the robot’s planned load. Balanced robots can all carry exactly the same load.",
    points: (here) => here.discs(),
  },
  {
    title: "Lifting base",
    where: ({ baseHasArea }) => baseHasArea,
    words: ({ coverage }) =>
      say(
        coverage
          ? "The green area is the lifting base. A downward press inside it does not tip the object as long as the robots push back and none is overloaded. Coverage, here {coverage}, is the share of the object above the lifting base."
          : "The green area is the lifting base. A downward press inside it does not tip the object as long as the robots push back and none is overloaded. Coverage is the share of the object above the lifting base.",
        { coverage },
      ),
    points: (here) => here.base(),
  },
  { title: "Can it still move?", where: ({ team }) => team, words: mobility, points: (here) => here.discs() },
  {
    title: "Settings",
    words: ({ balanced, hasSheet }) =>
      balanced
        ? hasSheet
          ? "Pull the sheet up, and choose the method, the number of robots and the weight. Below the loads, drawers have all other settings."
          : "Choose the method, the number of robots and the weight. Below the loads, drawers have all other settings."
        : hasSheet
          ? "Pull the sheet up, and choose the method that places teams, their number and the weight. Below the loads, drawers have all other settings."
          : "Choose the method that places teams, their number and the weight. Below the loads, drawers have all other settings.",
    controls: ["methods", "teams -", "teams +", "robots -", "robots +", "weight"],
  },
  {
    title: "The shape",
    words: () =>
      finger()
        ? "Drag a vertex or C. Double-tap an edge to add a vertex. You can remove a vertex that you have tapped. Undo reverts every change."
        : "Drag a vertex or C. Double-click an edge to add a vertex. Delete removes the selected vertex. Undo reverts every change.",
    points: (here) => [...here.vertex(), here.aboutCentre],
  },
  {
    title: "Lessons",
    words: () =>
      "This window explains the algorithm step by step, with the reason for each choice, on your own shape too.",
    controls: ["Lessons"],
    menu: true,
  },
  {
    title: "Links",
    words: () => "The link in the address bar holds the shape and the settings. Send it, and others see what you see.",
    controls: ["Copy link"],
    menu: true,
  },
];
