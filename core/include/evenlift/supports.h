// Robots that stand where the user puts them (method `given`): legs, jacks or suction cups at known
// places. Everything that is computed for other robots is computed for them.
//
// A support within the snap distance of the outline stands *at the edge*: its contact is the
// nearest point of the outline. If several points are equally near within tau L, the contact is the
// first of them along the vertex list. If a vertex is within tau L of the contact, the contact is
// exactly that vertex. A support that is on the outline up to the rounding of its coordinates stays
// as given. A support farther inside stands *beneath* the object: it lifts, and touches nothing
// sideways. If robots have a size, a support at the edge is the contact of its robot (stands.h).
//
// All supports are one team. Their loads are not planned, so those of springs count as planned
// (load_models.h). The object stands on them if C is in H (equilibrium.h); otherwise it falls, and
// no robot has a load.
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

// The snap distance for these settings, in units of length. O(1).
double snap_distance(const Polygon& polygon, const Settings& settings);

// Finds the places of supports, one by one.
class SupportPlacer {
 public:
  // The object must outlive it. O(1).
  SupportPlacer(const PolygonWithHoles& object, const Settings& settings);

  // The contact of a support at the edge, or its place with the edge `beneath` (chords.h). Nothing
  // if it is outside the outline by more than the snap distance, or in a hole; whether it is inside
  // is decided exactly. O(n).
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

// Places for robots that the user is about to move. They are beneath the object, on the sides of a
// small square that contains the centre of mass, like the legs of a table, and their coordinates
// have few digits. The middle of the square is on the way from the centre of mass to the farthest
// vertex; if the square would have to be so small there that robots hide each other, its middle may
// be on another side of the centre of mass. If no square fits, all places are at the first vertex.
// 1 <= robots <= most_supports. The settings give the snap distance. O(n robots).
Points supports_to_place(const PolygonWithHoles& object, const Vec2& centre, std::size_t robots,
                         const Settings& settings);

// The place on the outline where one more robot adds most to the area of the lifting base: a
// vertex, and the first if several add equally. If no vertex adds anything, it is the middle of an
// edge: the middle that is farthest from its nearest robot. O(n m log m).
Vec2 widest_addition(const Polygon& polygon, const Points& robots);

// A support at which a robot of the given size does not fit, or that is too near to another.
struct Misfit {
  enum class Why : std::uint8_t {
    outside,   // the body would meet the object
    arm,       // the arm would cross the object
    hand,      // the hand would stick out of the object
    hole,      // the hand would reach into a hole of the object
    no_go,     // the robot would touch a no-go part
    too_near,  // it collides with another robot, or both are at one place
  };
  std::uint32_t robot = 0;
  Why why = Why::outside;
  std::uint32_t other = 0;  // for too_near: the other robot, with a smaller number
  bool operator==(const Misfit&) const = default;
};

// All misfits of the robots with these lifting points, in the order of their numbers: for each
// robot, first whether its place fits, then the earlier robots that are too near. Without `stands`,
// robots are points that fit anywhere; then only two at one place, within tau L, are too near. O(m
// log n + m^2).
std::vector<Misfit> misfits(const Polygon& polygon, const Stands* stands,
                            const std::vector<LiftingPoint>& robots);

// "outside", "arm", "hand", "hole", "no-go", or "too near robot 2", with robots counted from 1.
std::string misfit_in_words(const Misfit& misfit);

// The nearest places with equal loads: two robots move to the ends of a chord that makes C the
// centroid of all. All pairs of robots, all such chords, and both ways to give the two ends to the
// two robots are compared; the first choice with the least sum of squared moves wins. Robots whose
// centroid is C already, within tau L, stay. If no two robots will do, three move: the third to a
// trial point (balanced.h); for more than most_evened_by_three robots this is not tried. If robots
// have a size, the moved ones fit and collide with no other. Nothing if there are no such places. A
// single robot is never moved: for it the function returns its place if that is C, and otherwise
// nothing. `robots` are lifting points, at most most_evened. O(m^2) completions (balanced.h), or
// O(s m^3) for s trial points.
inline constexpr std::size_t most_evened = 64, most_evened_by_three = 16;
std::optional<std::vector<LiftingPoint>> even_out(const BalancedProblem& problem,
                                                  const std::vector<LiftingPoint>& robots);

}  // namespace evenlift
