// Turns a placement into shapes, each with a role, for the SVG writer and the page's canvas. The
// shapes are in polygon coordinates, and have no colours or pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/report.h"

namespace evenlift {

enum class Role : std::uint8_t {
  object,            // filled P, without its holes
  lifting_base,      // filled H
  clockwise,         // filled region of the centres of free clockwise rotations
  counterclockwise,  // filled region of the centres of free counter-clockwise rotations
  candidate,         // a chord that no team took
  chord,             // a line of joining_lines()
  robot,             // a lifting point
  centre_of_mass,
  cargo,        // a disc whose area is in proportion to an item's weight
  cargo_lever,  // from C0, the object's own centre of mass, to C; only with cargo
  own_centre,   // C0; only with cargo
};

struct Shape {
  Role role = Role::object;
  Points points;                      // an area (3 points or more), a segment (2) or a spot (1)
  std::optional<std::uint32_t> team;  // set for chords and robots
  double load = 0;                    // of a robot; for cargo, its weight
  std::vector<Points> holes = {};     // of the object
  std::uint32_t item = 0;             // index of the cargo
  double radius = 0;                  // of the cargo's disc, in units of length
};

// The lines that show a team: for a team of two its chord, otherwise a line from each robot to C.
// O(robots of the team).
struct Segment {
  Vec2 from, to;
};
std::vector<Segment> joining_lines(const Team& team, const Vec2& centre);

// Returns the radius of the disc of each item of cargo, in units of length. A disc has the area of
// a part of the object that weighs the same as the item. If the largest radius would exceed
// `largest_cargo_disc` L, all are reduced by the same factor. O(items).
inline constexpr double largest_cargo_disc = 0.06;
std::vector<double> cargo_radii(const Placement& placement);

// Returns a mark that shows which robots form a team: strokes side by side that add up to the
// team's number, counted from 1. A broad stroke counts as five. `at` is the robot's place on the
// picture, in pixels, and `outward` is the direction away from C, as a vector of any length. The
// strokes begin at the distance `radius` from `at`. O(team).
struct TallyStroke {
  Segment line;
  bool five = false;
};
std::vector<TallyStroke> tally(std::size_t team, const Vec2& at, const Vec2& outward,
                               double radius);

// Returns the object, cargo, centre of mass and robots, and the shapes that the overlays select,
// from back to front. If there are more than `most_lines` candidates or teams, lines are drawn only
// for every second (or third, and so on), since more lines would be indistinguishable. O(output).
std::vector<Shape> make_picture(const Placement& placement, const Overlays& overlays,
                                std::size_t most_lines = SIZE_MAX);

}  // namespace evenlift
