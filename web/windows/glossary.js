// The words that the page uses, with the meaning that docs/algorithm.md gives them.
import { fadeFoot, openWindow } from "../kit/dialogs.js";
import { el } from "../kit/elements.js";

const words = [
  ["Arm", "The distance of a robot from the centre of mass. In a team the robot with the shorter arm bears more."],
  [
    "Balanced robots",
    "Robots, any number of them, whose centroid is the centre of mass. Equal forces at them add up to the weight and do not turn the object, so all can bear the same. They do so if their forces are controlled, or if all are equally stiff and level and the object does not bend; three robots that are not on one line do so in any case.",
  ],
  [
    "Candidate",
    "A chord whose load ratio is at least the minimum, found where two edges face each other or two vertices are opposite each other across C. Teams are chosen among the candidates.",
  ],
  [
    "Centre of mass, C",
    "The point at which the object could be balanced. It is the centroid of the area unless you move it, and must lie strictly inside the convex hull, though it may lie outside the object.",
  ],
  ["Chord", "A segment through C with one end on the outline on either side of C. It may leave the object on its way."],
  [
    "Clearance",
    "How far the contacts that a hold needs are from the nearest corner. At the corner itself a contact is gone, so a hold by a robot a hair beside one is none that anybody can build: the verdict warns of it. The tolerance says how far each robot may be off along its side, all at once, and form closure stays; robots in inward corners stay there.",
  ],
  [
    "Contact",
    "Where a robot touches an edge from outside, and pushes along the edge's inward normal. A robot at a vertex that points inwards makes two contacts. One at a vertex that points outwards is not counted, since its push has no definite direction there. That is the safe side: the regions of free rotation are then rather too large.",
  ],
  [
    "Coverage",
    "The part of the object's area that lies inside the lifting base, from 0 to 100 %. A push down there does not tip the object, as long as the robots push back (they are stiff, or held at height) and none is loaded beyond what it can carry.",
  ],
  [
    "Edges that face each other",
    "Two edges form a pair if some lines through C meet one on one side and the other on the other side. Each pair can give one candidate.",
  ],
  ["Even chord", "A chord that C halves, so that both robots bear the same. Every convex object has one."],
  [
    "Form closure",
    "The contacts alone, without friction, keep the object from every small turn and slide in the plane, to first order. Both regions of free rotation are empty then, and no translation is free. It presumes robots that can push sideways and do not give way. A curve counts as the polygon that it was flattened to.",
  ],
  [
    "Halo",
    "A dashed circle about C: as far as C may be off before the object tips. A ring inside it, which you can drag, says how well you know where C is: those who lift call its inside the CoG envelope (CoG: centre of gravity).",
  ],
  [
    "Kern",
    "The part of the lifting base where a push down, however strong, lifts no robot off, if all robots are equally stiff and level. With more than three robots it is smaller than the base: a strong push between its rim and that of the base lifts a robot off, though the object does not tip.",
  ],
  [
    "Lifting base, H",
    "The convex hull of all robots: what a rubber band round them would enclose. Robotics calls it the support polygon; in heavy transport it is the stability area, and its edges are the tipping lines. A push down inside it changes the loads and does not tip the object, on the conditions of coverage.",
  ],
  [
    "Load",
    "What one robot bears. As planned, each team bears an equal part of the weight, and in a team each robot the part of it that the other robot's arm is of the chord. Planned loads presume that each robot's force is controlled. Coverage presumes robots that push back; perfectly even teams and balanced robots meet both if all robots are equally stiff and level and the object does not bend.",
  ],
  ["Load ratio", "The shorter arm of a chord divided by the longer one. At 1 both robots bear the same."],
  [
    "Margin",
    "How firmly the contacts hold the object: the radius of the largest ball about 0 that fits among the forces and torques which the contacts can exert if all their forces together are at most 1 (the L1 form). It depends on C and on the object's size, so it compares placements of one object, not objects.",
  ],
  [
    "Method",
    "How the teams are chosen. By area, circle or distance the next team is the candidate that adds most to the lifting base, as measured by that method; distributed and random know nothing of candidates, and are there to compare with. Balanced places robots instead of teams, so that all of them can bear the same.",
  ],
  [
    "Minimum load ratio",
    "The least load ratio that you accept, from 0 to 1. A higher one makes the loads more even and leaves fewer candidates.",
  ],
  [
    "Regions of free rotation",
    "The points about which the object can begin to turn: clockwise in red, counter-clockwise in blue. Each contact cuts a part of them away; robots at vertices that point outwards cut nothing away.",
  ],
  [
    "Second order",
    "The object could begin to move if only straight lines counted, but the curvature of the motion runs into a contact. Such an object is held as long as no robot gives way, though not in first-order form closure.",
  ],
  [
    "Section",
    "The part of an edge that faces another edge across C. Along a section the load ratio only rises or only falls, on either side of 1.",
  ],
  [
    "Skew load",
    "What a robot bears more than planned because heights or stiffness are unequal. The loads at worst are its extreme: the most that each robot can come to bear as long as the object stays up. They follow from equilibrium alone, so they also bound the loads under an object that bends.",
  ],
  ["Team", "Two robots, one at each end of a chord. The two discs of a team have the same number."],
  [
    "Tipping",
    "A push down outside of the lifting base tips the object if it is strong enough. The colours show how strong it must be at each point.",
  ],
];

export async function show() {
  const list = el(
    "dl",
    { class: "glossary" },
    ...words.flatMap(([word, meaning]) => [el("dt", {}, word), el("dd", {}, meaning)]),
  );
  const scroll = el(
    "div",
    { class: "scroll", tabindex: "0", role: "group", "aria-label": "Words and their meanings" },
    list,
  );
  await openWindow({ name: "glossary", title: "Glossary", over: true, body: [scroll] });
  fadeFoot(scroll);
}
