// Robots that stand where the user puts them (method `given`; algorithm.md, Given supports): legs,
// jacks or suction cups. Their loads, stability, immobilization and robustness are computed as for
// other robots.
//
// A support within the snap distance of the outline stands *at the edge*. Its contact is the
// nearest point of the outline, or a vertex within tau L of that point. If the support is on the
// outline up to the rounding of its coordinates, its own place counts as the nearest point. A
// support farther inside stands *beneath* the object: it lifts but touches no edge. If robots have
// a size, a support at the edge is the contact of its robot (stands.h).
//
// All supports form one team. Their loads by springs count as planned (load_models.h). If C is not
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

// The snap distance of these settings, in units of length. O(1).
double snap_distance(const Polygon& polygon, const Settings& settings);

class SupportPlacer {
 public:
  // The object must outlive the placer. O(1).
  SupportPlacer(const PolygonWithHoles& object, const Settings& settings);

  // Returns the contact of a support at the edge: the nearest point of the outline. If it is not on
  // the outline already, up to rounding, and a notch (Polygon::is_notch) is within the snap distance,
  // it stands in the nearest notch, which keeps the robot. For a
  // support farther inside, its own place,
  // with `edge` set to the constant `beneath` (chords.h). The result is empty if the support is
  // farther than the snap distance from the outline and, by an exact test, outside the outline or
  // in a hole. O(n).
  std::optional<LiftingPoint> place(const Vec2& support) const;

  // The distance of a point from the outline. O(n).
  double distance(const Vec2& point) const;
  double snap() const { return snap_; }

 private:
  std::optional<std::uint32_t> notch_near(const Vec2& point) const;

  const PolygonWithHoles& object_;
  double snap_;
};

// The places of all supports in the settings, in order. It is an error if a support has no place
// (SupportPlacer::place()), or if the absolute value of a coordinate is below min_coordinate but
// not 0. The error's place names the support, from 0, as "supports[3]". O(n) for each support.
Result<std::vector<LiftingPoint>> place_supports(const PolygonWithHoles& object,
                                                 const Settings& settings);

// The same, with nothing for a support that has no place. O(n) for each support.
Result<std::vector<std::optional<LiftingPoint>>> places_of_supports(const PolygonWithHoles& object,
                                                                    const Settings& settings);

// What the snap distance did, in sentences without a full stop: that supports that were farther than
// 1e-6 L from the outline were put at the edge, and which supports are beneath the object although
// they are within 10 snap distances of the outline. The supports must have places. O(n) for each
// support.
std::vector<std::string> snap_notes(const PolygonWithHoles& object, const Settings& settings);

// Places beneath the object for robots that the user is about to move. They are on the sides of a
// small square that contains the centre of mass, and their coordinates have few digits. The middle
// of the square is offset from the centre of mass towards the farthest vertex. If such a square
// would be too small to show its robots apart, its middle may be elsewhere near the centre of mass.
// If no square fits, all places are at the first vertex. `robots` is 1 .. most_supports. The
// settings give the snap distance. O(n robots).
Points supports_to_place(const PolygonWithHoles& object, const Vec2& centre, std::size_t robots,
                         const Settings& settings);

// The place on the outline where one more robot adds most to the area of the lifting base. The
// place is a vertex, the first if several add the same area. If no vertex adds more than tau times
// the polygon's area, the place is the middle of an edge: the middle whose nearest robot is
// farthest away. O(n m log m) for m robots.
Vec2 widest_addition(const Polygon& polygon, const Points& robots);

// A support at which a robot of the given size does not fit or is too near to another robot.
struct Misfit {
  enum class Why : std::uint8_t {
    outside,   // there is no room for the body outside the object
    arm,       // the arm would cross the object
    hand,      // the hand would stick out of the object
    hole,      // the hand would reach into a hole
    no_go,     // the robot would touch a no-go part of an edge
    too_near,  // the robot collides with another one, or both are at one place
  };
  std::uint32_t robot = 0;
  Why why = Why::outside;
  std::uint32_t other = 0;  // for too_near: the other robot, which has the lower number
  bool operator==(const Misfit&) const = default;
};

// All misfits, in the order of the robots. For each robot, the reason why it does not fit at its
// place comes first, if there is one; the earlier robots that are too near follow. Without
// `stands`, robots are points that fit anywhere, so the only misfits are two robots at one place,
// within tau L. O(m log n + m^2).
std::vector<Misfit> misfits(const Polygon& polygon, const Stands* stands,
                            const std::vector<LiftingPoint>& robots);

// The misfit in words: "outside", "arm", "hand", "hole", "no-go", or "too near robot 2", with
// robots counted from 1.
std::string misfit_in_words(const Misfit& misfit);

// Moves robots to the nearest places at which their loads by springs are equal (algorithm.md, Given
// supports, Even out). The nearest places have the least sum of squared moves. Two robots move to
// the ends of a chord that makes C the centroid of all robots. If no two robots can do this and
// there are at most most_evened_by_three robots, three robots move. If the robots' centroid is
// within tau L of C, they stay. The result is empty if no places are found, as for a single robot
// that is not at C. `robots` are lifting points, at most most_evened. The cost is O(m^2)
// completions (balanced.h), or O(s m^3) completions for s trial points if three robots move.
inline constexpr std::size_t most_evened = 64, most_evened_by_three = 16;
std::optional<std::vector<LiftingPoint>> even_out(const BalancedProblem& problem,
                                                  const std::vector<LiftingPoint>& robots);

}  // namespace evenlift
