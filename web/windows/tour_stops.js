// The stops of the tour: the text of each, and the place at which it points (tour_places.js).

// The movements that remain free in this placement; there may be no hatching.
function mobility({ free, heldByCurvature }) {
  const turns = { clockwise: "clockwise in red", counterclockwise: "counter-clockwise in blue" };
  const hatched = Object.keys(turns)
    .filter((turn) => free.includes(turn))
    .map((turn) => turns[turn])
    .join(", ");
  if (heldByCurvature)
    return "Here it cannot, though only the curvature of the contact holds it. Hatching would show about which points it could turn.";
  if (!free.length)
    return "Here it cannot: the robots also keep it from turning. Hatching would show about which points it could.";
  if (!hatched) return "It cannot turn, so nothing is hatched; but it can slide, as the arrow shows.";
  return `Hatching shows about which points it can turn: ${hatched}.${free.includes("translation") ? " The arrow shows how it slides." : ""}`;
}

const finger = () => matchMedia("(pointer: coarse)").matches;

// `points` returns the shapes to ring: circles [x, y, radius], boxes [x, y, width, height], lines [from, to]; if it
// returns none, `controls` are ringed. If a small screen hides them, the handle of their sheet is ringed, or with
// `menu` the menu button. A stop whose `where` does not hold is left out.
export const stops = [
  {
    title: "Teams",
    where: ({ balanced, team }) => !balanced && team,
    words: () =>
      "Two discs with the same number are a team. They stand at the ends of a chord, a line through C, the centre of mass.",
    points: (here) => here.discs(here.team),
  },
  {
    title: "Robots",
    where: ({ balanced, team }) => balanced && team,
    words: () =>
      "Each disc is a robot. Their centroid is C, the centre of mass, to which the thin lines lead: so they balance the object.",
    points: (here) => here.discs(),
  },
  {
    title: "Loads",
    where: ({ balanced, team }) => !balanced && team,
    words: () =>
      "The number beside each ringed disc is what this robot is to bear. C nearly halves a chord, so a team bears nearly equal loads.",
    points: (here) => here.discs(here.team),
  },
  {
    title: "Loads",
    where: ({ balanced, team }) => balanced && team,
    words: () =>
      "The number beside each ringed disc is what this robot is to bear. Balanced robots can all bear exactly the same.",
    points: (here) => here.discs(),
  },
  {
    title: "Lifting base",
    where: ({ baseHasArea }) => baseHasArea,
    words: ({ coverage }) =>
      `The green area is the lifting base. A push down inside it does not tip the object unless a robot is overloaded; coverage${coverage ? `, here ${coverage},` : ""} says how much of it that is.`,
    points: (here) => here.base(),
  },
  {
    title: "Can it still move?",
    where: ({ team }) => team,
    words: mobility,
    points: (here) => (here.hasSheet ? here.discs() : undefined), // the switches are further down in the sheet
    controls: ["Clockwise", "Counter-clockwise"],
  },
  {
    title: "Settings",
    words: ({ balanced, hasSheet }) =>
      `${hasSheet ? "Pull the sheet up, and choose" : "Choose"} ${
        balanced
          ? "how many robots there are, how their places are found, and whether they are to hold or to cover"
          : "how many teams there are, how they are chosen, and how even a chord must be"
      }. The answer follows.`,
    controls: ["methods", "teams -", "teams +", "robots -", "robots +", "ratio"],
  },
  {
    title: "The shape",
    words: () =>
      finger()
        ? "Drag a vertex, or C. A double tap on an edge adds a vertex; one that you tap can be removed. Undo takes all back."
        : "Drag a vertex, or C. A double click on an edge adds a vertex, Delete removes the one that is selected, and Undo takes all back.",
    points: (here) => [...here.vertex(), here.aboutCentre],
  },
  {
    title: "Lessons",
    words: () =>
      "Lessons show the algorithm step by step, with the reason for each choice, also on a shape of your own.",
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
