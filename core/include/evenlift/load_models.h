// The loads of robots whose forces are not controlled as planned.
//
// Vertical forces on a rigid object must add up to its weight and balance about C: three equations.
// More than three robots can do that in many ways, and the outcome depends on how the robots give
// way. A placement's own loads, the *plan*, presume that forces are controlled.
//
// *Springs* presumes that all robots are equally stiff and level and that the object is rigid (L.
// Euler, De pressione ponderis in planum cui incumbit, 1773; engineers use it for piles under a
// rigid cap). It is also the distribution of loads with the least sum of squares. Robots only push
// up: a robot that would have to pull goes slack. The load of a robot at p is max(0, a + b . p),
// with the same a and b for all. If the robots' centroid is C, as with even teams, all carry the
// same load.
//
// *Best* is the least possible value of the greatest load, which an ideal controller would reach.
//
// *Worst* is the greatest load that each robot can get if heights are unequal and some robots carry
// nothing, as under a table that stands on two of its four legs. Each robot has its own worst case,
// so these loads can add up to more than the weight. They follow from equilibrium alone, so they
// also bound the loads under an object that bends.
//
// Robots only push up, so no model gives loads if C is outside the robots' convex hull H by more
// than tolerance (tau L). If H is a segment within tolerance, or C is within tolerance of an edge
// of H, the robots on the line of that segment or edge share the weight, and all others carry
// nothing.
//
// In all functions, `robots` are the positions of the robots in any order, some perhaps at the same
// place; `diameter` is L of the object; loads are in the unit of the weight, in the order of the
// robots, and at least 0.
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

// The model's name in JSON and options, such as "springs"; and the model with a name, or nothing
// for an unknown name. O(1).
std::string_view name(LoadModel model);
std::optional<LoadModel> load_model_from_name(std::string_view text);

struct SpringLoads {
  std::vector<double> loads;
  // The greatest change of each load per unit of length that C moves, as long as the same robots
  // carry load. If the robots stand on one line, C moves along it.
  std::vector<double> per_length;
  // The distance that C can move in any direction (or, if the robots stand on one line, along it)
  // while the same robots carry load, so that loads change linearly.
  double same_within = 0;
};

// The loads of equally stiff robots; nothing if the robots do not carry the object. Newton's method
// solves the dual problem; in its steps robots may go slack and take up load again. Seldom more
// than ten steps of O(m), plus O(m log m) for H.
std::optional<SpringLoads> spring_loads(const Points& robots, const Vec2& centre, double diameter,
                                        double weight);

// The least possible value of the greatest load; nothing if the robots do not carry the object. It
// is the larger of weight / m and the greatest of weight g(C) / (sum over robots of max(0, g)),
// over the functions g that measure the distance to the left of a line through two robots. O(m^3)
// for up to 64 robots. For more robots, the method of cutting planes through the centroid of the
// remaining region (A. Yu. Levin and D. J. Newman, both 1965) finds it to 13 digits in about a
// hundred steps of O(m).
std::optional<double> best_load(const Points& robots, const Vec2& centre, double diameter,
                                double weight);

// The greatest load that each robot at p can get: weight |C q| / |p q|, where the ray from p
// through C leaves H at q; nothing if the robots do not carry the object. O(m log m).
std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight);

// The greatest loads if C may be anywhere in H within `reach` >= 0 of its place: the weight times
// the greatest t for which t p + (1 - t) H comes within reach of C. O(m log m + m h) in seldom more
// than six steps of Newton's method for each robot.
std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight, double reach);

}  // namespace evenlift
