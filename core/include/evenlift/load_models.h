// What the robots bear if their forces are not controlled as planned.
//
// Vertical forces on a rigid object have to add up to its weight and to balance about C: three
// equations. More than three robots can do that in many ways, and what decides between them is how
// the robots give way. A placement's own loads, the *plan*, presume that forces are controlled.
//
// *Springs* presumes that all robots are equally stiff and level and the object is rigid (L. Euler,
// De pressione ponderis in planum cui incumbit, 1773; engineers compute piles under a rigid cap
// so). It is also the distribution whose loads have the least sum of squares. Robots only push: one
// that would have to pull lets go. The load of a robot at p is max(0, a + b . p), with a and b the
// same for all. If the robots' centroid is C, as with even teams, such robots share evenly.
//
// *Best* is the greatest load of a robot if the best of all controllers shares the weight.
//
// *Worst* is the greatest load that each robot can come to bear if heights are unequal and some
// robots bear nothing, as the two legs of four on which a table stands. Each robot has a worst case
// of its own, so these loads add up to more than the weight. They follow from equilibrium alone, so
// they bound the loads under an object that bends, too.
//
// Only robots that push count, so whatever C is not above carries nothing: no model gives loads if
// C is outside the robots' convex hull H by more than tolerance (tau L). If H is flat within
// tolerance, or C is within tolerance of an edge of H, the robots on that line share the weight,
// and all others bear nothing.
//
// In all functions `robots` are the positions of the robots in any order, some perhaps at the same
// place, `diameter` is L of the object, and loads are in the unit of the weight, in the order of
// the robots, and at least 0.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

enum class LoadModel : std::uint8_t { plan, springs, best, worst };
inline constexpr LoadModel all_load_models[] = {LoadModel::plan, LoadModel::springs,
                                                LoadModel::best, LoadModel::worst};

// The model's name in JSON and options, such as "springs"; and the model of a name, or nothing for
// an unknown name. O(1).
std::string_view name(LoadModel model);
std::optional<LoadModel> load_model_from_name(std::string_view text);

struct SpringLoads {
  std::vector<double> loads;
  // How much each load changes at most for each unit of length that C moves, as long as the same
  // robots bear something. If the robots stand on one line, C moves along it.
  std::vector<double> per_length;
  // The distance that C can move in any direction (along the line) while the same robots bear
  // something, so that loads change in proportion.
  double same_within = 0;
};

// The loads of equally stiff robots; nothing if the robots do not carry the object. Found by
// Newton's method on the dual problem, in whose steps robots let go and take hold again: seldom
// more than ten steps of O(m), besides O(m log m) for H.
std::optional<SpringLoads> spring_loads(const Points& robots, const Vec2& centre, double diameter,
                                        double weight);

// The least possible value of the greatest load; nothing if the robots do not carry the object. It
// is the larger of weight / m and the greatest of weight g(C) / (sum over robots of max(0, g)),
// over the functions g that measure the distance to the left of a line through two robots. O(m^3)
// for up to 64 robots. For more it is found to 13 digits by cutting planes through the centre of
// gravity (A. Yu. Levin and D. J. Newman, both 1965), in some hundred steps of O(m).
std::optional<double> best_load(const Points& robots, const Vec2& centre, double diameter,
                                double weight);

// The greatest load that each robot at p can come to bear: weight |C q| / |p q|, where the ray from
// p through C leaves H at q; nothing if the robots do not carry the object. O(m log m).
std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight);

}  // namespace evenlift
