// Robots that stand where the user puts them (method `given`; algorithm.md, Given supports): legs,
// jacks or suction cups. Everything that is computed for other robots is computed for them.
//
// A support within the snap distance of the outline stands *at the edge*: its contact is the
// nearest point of the outline, or a vertex within tau L of that point. A support that is on the
// outline up to the rounding of its coordinates stays as given. A support farther inside stands
// *beneath* the object: it lifts, and touches nothing sideways. If robots have a size, a support at
// the edge is the contact of its robot (stands.h).
//
// All supports are one team. Their loads by springs count as planned (load_models.h). If C is not
// in H (equilibrium.h), the object falls, and no robot has a load.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/balanced.h"
#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/result.h"
#include "evenlift/stands.h"

namespace evenlift {

// The default snap distance, in units of L.
inline constexpr double usual_snap = 1e-6;

// The snap distance of these settings, in units of length. O(1).
double snap_distance(const Polygon& polygon, const Settings& settings);

class SupportPlacer {
 public:
  // The object must outlive the placer. O(1).
  SupportPlacer(const PolygonWithHoles& object, const Settings& settings);

  // The contact of a support at the edge; farther inside, its place with the edge `beneath`
  // (chords.h). Empty if the support is farther than the snap distance from the outline and is
  // outside it or in a hole; this is decided exactly. O(n).
  std::optional<LiftingPoint> place(const Vec2& support) const;

  // The distance of a point from the outline. O(n).
  double distance(const Vec2& point) const;

 private:
  const PolygonWithHoles& object_;
  double snap_;
};

// The places of all supports in the settings, in order. It is an error if a support is outside the
// object or in a hole, or if the absolute value of a coordinate is below min_coordinate but not 0.
// The error's place names the support, counted from 0, as "supports[3]". O(n) for each.
Result<std::vector<LiftingPoint>> place_supports(const PolygonWithHoles& object,
                                                 const Settings& settings);

// Places beneath the object for robots that the user is about to move. Like the legs of a table,
// they are on the sides of a small square that contains the centre of mass, and they have few
// digits. The middle of the square is offset from the centre of mass towards the farthest vertex.
// If the square would be so small there that robots hide each other, its middle may lie on another
// side of the centre of mass. If no square fits, all places are at the first vertex. 1 <= robots <=
// most_supports. The settings give the snap distance. O(n robots).
Points supports_to_place(const PolygonWithHoles& object, const Vec2& centre, std::size_t robots,
                         const Settings& settings);

// The place on the outline where one more robot adds most to the area of the lifting base. It is a
// vertex, the first if several add equally. If no vertex adds any area, it is the middle of the
// edge whose middle is farthest from its nearest robot. O(n m log m) for m robots.
Vec2 widest_addition(const Polygon& polygon, const Points& robots);

// A support where a robot of the given size does not fit, or that is too near to another.
struct Misfit {
  enum class Why : std::uint8_t {
    outside,   // the body would meet the object
    arm,       // it would cross the object
    hand,      // it would stick out of the object
    hole,      // the hand would reach into it
    no_go,     // the robot would touch a no-go part of an edge
    too_near,  // it collides with another robot, or both are at one place
  };
  std::uint32_t robot = 0;
  Why why = Why::outside;
  std::uint32_t other = 0;  // for too_near: the other robot, of smaller number
  bool operator==(const Misfit&) const = default;
};

// All misfits, in the order of the robots. For each robot, first comes the reason why its place
// does not fit, if any, and after it the earlier robots that are too near. Without `stands`, robots
// are points that fit anywhere, so only two at one place, within tau L, are too near. O(m log n +
// m^2).
std::vector<Misfit> misfits(const Polygon& polygon, const Stands* stands,
                            const std::vector<LiftingPoint>& robots);

// The misfit in words: "outside", "arm", "hand", "hole", "no-go", or "too near robot 2", with
// robots counted from 1.
std::string misfit_in_words(const Misfit& misfit);

// The nearest places with equal loads, by the sum of squared moves (algorithm.md, Given supports,
// Even out): two robots move to the ends of a chord that makes C the centroid of all robots. If no
// two robots can do this and there are at most most_evened_by_three robots, three move. Robots
// whose centroid is C within tau L stay, and a single robot never moves. Empty if there are no such
// places. `robots` are lifting points, at most most_evened. O(m^2) completions (balanced.h), or O(s
// m^3) for s trial points.
inline constexpr std::size_t most_evened = 64, most_evened_by_three = 16;
std::optional<std::vector<LiftingPoint>> even_out(const BalancedProblem& problem,
                                                  const std::vector<LiftingPoint>& robots);

}  // namespace evenlift
