// The text on which the model for lesson links (lesson_link.cpp) is trained before it writes or
// reads a lesson. The text is part of the format and never changes. docs/lesson-primer.txt repeats
// it for other programs.
#pragma once

#include <string_view>

namespace evenlift {

inline constexpr std::string_view lesson_primer =
    R"primer(# Lines that begin with # are notes for the author.
title: My lesson
link: 2.
com: 0,0
metric: area
teams: 3
min-ratio: 0.8
generate: star n=9 seed={number}
loads: springs
capacity: 30
slope: 0.1
require: steady, closed, max<=30, coverage>=0.9
move: robots, centre, teams, vertices
place: 4
find: centre

[polygon]
What should they notice here? Ask before you explain.

[centre]
The centre of mass C of the object.

[vertex 1]
A chord from the first vertex through C.

[candidates]
All chords that meet the minimum ratio.

[team 1]
The first team, and why this one was chosen.

[lever]
Two robots, and the load of each: the robot that is nearer to C carries more.

title: A robot fails
polygon: worktop
metric: balanced
robots: 6

[loads]
The plan gives each of the six robots a sixth of the weight. What happens if a motor stops or a battery runs out?

[failure 2]
Some robots are hardly missed. If robot 2 fails, the others take over its load, and the lifting base stays nearly as
wide.

[failure 3]
But without robot 3 the worktop falls. The other five robots cannot carry it, however strong they are: the centre of
mass is no longer between them.

[failure 6]
Robot 6 stands far out at one end. Without it the worktop stays up, but a strong downward press at that end tips it.

[failures]
So before a lift, check the effect of each robot's failure.

[pairs]
Teams of two cover less, and here much less. But whichever robot fails, the worktop does not tip as long as the others
can carry its load: the other teams still have a robot on each side of the centre of mass. With only two teams, a
failure could leave the worktop balanced on a knife's edge.

[end]
You can have safety and nearly the same coverage: with Survive, under More settings, the search looks for places at
which any one robot may fail.

title: Task: put the motor in the right place
polygon: stone-slab
supports: 330,20 1000,300 520,790 0,420
weight: 60
cargo: 250,250:40:motor
require: spread<=1
move: cargo

[task]
A motor of 40 kg lies on a slab of 60 kg that stands on four equally stiff robots. Drag the motor until all four carry
the same, to within 1 kg.

[question]
Must the motor lie above C of the slab alone?

[answer]
No. All four carry the same if C of both together lies at the middle of the four robots. C of the slab alone does not lie there,
so the motor has to lie on the other side of that middle.
)primer";

}  // namespace evenlift
