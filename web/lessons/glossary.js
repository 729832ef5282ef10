// The page's words, with their meaning in docs/algorithm.md.
import { fadeFoot, openWindow } from "../kit/dialogs.js";
import { el } from "../kit/elements.js";
import { translated } from "../words/words.js";

const words = [
  ["Arm", "The distance of a robot from the centre of mass. In a team the robot with the shorter arm carries more."],
  [
    "Balanced robots",
    "Any number of robots whose centroid is the centre of mass. Equal forces at these robots can add up to the weight without turning the object, so all can carry the same load. They do if their forces are controlled, or if all are equally stiff and level and the object does not bend. Three balanced robots that are not on one line always do, even on uneven ground.",
  ],
  [
    "Candidate",
    "A chord that meets the minimum load ratio, found where two edges face each other or two vertices are opposite each other across C. Teams are chosen among the candidates.",
  ],
  [
    "Centre of mass, C",
    "The point at which the object balances, together with its cargo. It is the centroid of the area unless you move it or add weights. It must lie strictly inside the convex hull, but may lie outside the object.",
  ],
  [
    "Centroid of robots",
    "The mean of their places: its x is the mean of all x, and its y is the mean of all y. The centroid of three robots is the centroid of their triangle. If it is the centre of mass, all robots can carry the same load.",
  ],
  [
    "Chord",
    "A segment through C with its two ends on the outline, on opposite sides of C. Between its ends it may leave the object.",
  ],
  [
    "Clearance",
    "The smallest distance between a corner and a contact that a hold needs. At the corner itself the contact is lost, so a hold that needs a robot a hair’s breadth from a corner cannot be built; the verdict warns of this. How far all robots at once may be off while everything that is told stays true is said in the verdict; it may be this hold that ends first.",
  ],
  [
    "Contact",
    "A place where a robot touches an edge from outside and pushes along the edge's inward normal. A robot at a vertex that points inwards makes two contacts. A robot at a vertex that points outwards is not counted, since its push has no definite direction. This errs on the safe side: the regions of free rotation are then too large rather than too small.",
  ],
  [
    "Coverage",
    "The share of the object's area that lies inside the lifting base, from 0 to 100 %. A downward press there does not tip the object, as long as the robots push back (they are stiff, or held at height) and none is overloaded. On a slope, or while the object is braked, this is true of a press at the height of the lifting points, if the object does not tip without it.",
  ],
  [
    "Edge pair",
    "Two edges that face each other: some lines through C meet one edge on one side of C and the other edge on the other side. Each edge pair can give one candidate.",
  ],
  ["Even chord", "A chord that C halves, so that both robots carry the same load. Every convex object has one."],
  [
    "Form closure",
    "The contacts alone, without friction, prevent every small turn and slide in the plane, to first order. Both regions of free rotation are then empty, and no translation is free. It presumes robots that can push sideways and do not give way. A curve counts as the polygon that approximates it.",
  ],
  [
    "Kern",
    "The part of the lifting base where no downward press, however strong, makes a robot go slack, if all robots are equally stiff and level and the object does not bend. With more than three robots the kern is smaller than the base: a strong downward press inside the base but outside the kern makes a robot go slack, even if the object does not tip.",
  ],
  [
    "Lifting base, H",
    "The convex hull of the lifting points: a rubber band around all robots would enclose it. In robotics it is the support polygon; in heavy transport it is the stability area, and its edges are the tipping lines. A downward press inside it changes the loads but does not tip the object, if the conditions given under Coverage are met.",
  ],
  [
    "Load",
    "The weight that one robot carries: 1 kg stands for the weight of a mass of 1 kg, which is 9.81 N. As planned, all teams carry equal parts of the weight; within a team, each robot's share is the other robot's arm divided by the length of the chord. Planned loads presume that each robot's force is controlled, and coverage presumes robots that push back. Even teams and balanced robots meet both conditions if all robots are equally stiff and level and the object does not bend. Ranges of planned loads presume that the robots are set to these loads with C as assumed, and that each then keeps its height and gives way like an equally stiff spring.",
  ],
  ["Load ratio", "The shorter arm of a chord divided by the longer one. At 1 both robots carry the same load."],
  [
    "Margin",
    "The strength of a hold: the radius of the largest ball about 0 that fits among the forces and torques that the contacts can exert if all their forces together are at most 1 (the L1 form). Against a side force through C, contact forces that add up to this force divided by the margin are enough. The margin depends on C and on the object's size, so use it to compare placements of one object, not different objects.",
  ],
  [
    "Method",
    "The way in which the teams are chosen. By area, circle or distance, the next team is the candidate that adds most to the lifting base by that measure. Equal angles and random ignore the candidates and serve for comparison. Balanced places robots instead of teams, so that all of them can carry the same load.",
  ],
  [
    "Minimum load ratio",
    "The smallest load ratio that you accept, from 0 to 1. A higher minimum makes the loads more even and leaves fewer candidates.",
  ],
  [
    "Regions of free rotation",
    "The points about which the object can begin to turn: clockwise in red, counter-clockwise in blue. Each contact cuts part of these regions away; robots at vertices that point outwards cut nothing away.",
  ],
  [
    "Second order",
    "The object could move if only straight lines counted, but the curvature of any motion jams it against a contact as soon as it begins. Such an object is held as long as no robot gives way, but it is not in first-order form closure.",
  ],
  [
    "Section",
    "The part of an edge that faces another edge across C. Along a section the load ratio only rises or only falls on each side of 1.",
  ],
  [
    "Skew load",
    "The load beyond the plan that a robot carries because heights or stiffness are unequal. The loads at worst are its extreme: the greatest load that each robot can get on level ground, with C as given, as long as the object stays up. They follow from equilibrium alone, so they also bound the loads under an object that bends.",
  ],
  [
    "Team",
    "Two robots, one at each end of a chord. The lines beside the two discs of a team are the same: as many as the team's number, and a broad one counts five.",
  ],
  [
    "Tipping",
    "A downward press outside the lifting base tips the object if the press is strong enough. The colours show the force needed at each point; a C uncertainty, a slope or braking makes it smaller.",
  ],
  [
    "Tipping distance",
    "The distance that C may be off on level ground before the object tips, if the conditions given under Coverage are met. It is the radius of the dashed circle about C. The ring that you can drag shows the C uncertainty, and what slopes and braking add: the weight acts inside the ring. Riggers call the area in which C itself may lie the CoG envelope (CoG: centre of gravity); slopes and braking are not part of it.",
  ],
  [
    "Zero moment point",
    "The point of the plane of the lifting points at which weight and inertia act together. On level ground, at rest, it is C. On a slope it lies downhill of C by the height of C times the slope of this plane; while the object is braked on level ground, it lies ahead of C by the height of C times the deceleration in g. Braking on the way down a slope moves it by a little more than the sum of the two. The object tips when it leaves the lifting base.",
  ],
];

export async function show() {
  const list = el(
    "dl",
    { class: "glossary" },
    ...words
      .map(([word, meaning]) => [translated(word), meaning])
      .sort(([a], [b]) => a.localeCompare(b))
      .flatMap(([word, meaning]) => [el("dt", {}, word), el("dd", {}, meaning)]),
  );
  const scroll = el(
    "div",
    { class: "scroll", tabindex: "0", role: "group", "aria-label": "Words and their meanings" },
    list,
  );
  await openWindow({ name: "glossary", title: "Glossary", over: true, body: [scroll] });
  fadeFoot(scroll);
}
