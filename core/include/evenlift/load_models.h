// The loads of robots whose forces are not controlled as planned.
//
// Vertical forces on a rigid object must add up to its weight and balance about C. If there are
// more than three robots, or three on one line, many different loads can meet these conditions; the
// actual loads depend on how the robots give way. A placement's own loads, the *plan*, presume
// controlled forces.
//
// *Springs* presumes that all robots are level and equally stiff, and that the object is rigid (L.
// Euler, De pressione ponderis in planum cui incumbit, 1773; also used for piles under a rigid
// cap). Of all possible loads, the loads by springs have the least sum of squares. A robot that
// would have to pull goes slack: a robot at p carries max(0, a + b . p), with the same a and b for
// all robots. All loads are equal if the robots' centroid is C, for instance if all teams are even.
//
// *Best* is the least possible greatest load: an ideal controller would share the weight so that no
// robot carries more.
//
// *Worst* is, for each robot, the greatest load that it can get if heights are unequal and some
// robots carry nothing. Each robot has its own worst case, so the sum can exceed the weight. These
// bounds follow from equilibrium alone, so they also apply under an object that bends.
//
// No model gives loads if C is outside the robots' convex hull H by more than tau L. If H is a
// segment, or if C is within tau L of an edge of H, the robots on the line of this segment or edge
// share the weight, and all others carry nothing.
//
// All functions take the positions of the `robots` in any order; several positions may be equal.
// `diameter` is L, the size of the polygon. Loads are in the unit of the weight, in the order of
// the robots, and at least 0. The functions return nothing if the robots do not carry the object.
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

// name() returns the name of a model in JSON and options, such as "springs"; load_model_from_name()
// returns the model of a name, if it is known. O(1).
std::string_view name(LoadModel model);
std::optional<LoadModel> load_model_from_name(std::string_view text);

struct SpringLoads {
  std::vector<double> loads;
  // The greatest change of each load per unit of length that C moves, as long as the same robots
  // carry load. If the robots that share the weight stand on one line, C moves along that line.
  std::vector<double> per_length;
  // The distance that C can move in any direction (or along that line) while the same robots carry
  // load. Within this distance, the loads change linearly.
  double same_within = 0;
};

// Returns the loads of equally stiff robots, by Newton's method for the dual problem. In a step of
// this method, robots may go slack or take up load again. For m robots, the cost is seldom more
// than ten steps of O(m), plus O(m log m) for H.
std::optional<SpringLoads> spring_loads(const Points& robots, const Vec2& centre, double diameter,
                                        double weight);

// Returns the least possible greatest load of m robots. For each ordered pair of robots, let g be
// the distance from their line, positive on its left, and s the sum of max(0, g) over all robots.
// The load is weight / m or, if larger, the greatest weight * g(C) / s over all pairs. Up to 64
// robots take O(m^3). For more robots, cutting planes through the centroid of the remaining region
// (A. Yu. Levin and D. J. Newman, both 1965) find the load to 13 digits in about a hundred steps of
// O(m).
std::optional<double> best_load(const Points& robots, const Vec2& centre, double diameter,
                                double weight);

// Returns each robot's greatest possible load. For a robot at p it is weight * |C q| / |p q|, where
// the ray from p through C leaves H at q. O(m log m).
std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight);

// Returns each robot's greatest possible load if C may be anywhere in H within the distance `reach`
// >= 0 of its place. For a robot at p it is the weight times the greatest t for which t p + (1 - t)
// H comes within `reach` of C. O(m log m + m h) for h corners of H, since Newton's method seldom
// takes more than six steps for each robot.
std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight, double reach);

// Returns each robot's least possible load if C may be anywhere in H within the distance `reach` >=
// 0 of its place: the weight times the least t for which t p + (1 - t) H' comes within `reach` of C,
// where H' is the hull of the other robots. It is 0 for a robot that the others can do without.
// O(m log m), and as much again for each robot without which C is not clearly inside (by 1e-6 of the
// size): seldom more than two.
std::optional<std::vector<double>> least_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight, double reach);

}  // namespace evenlift
