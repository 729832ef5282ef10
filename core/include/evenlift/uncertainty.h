// Guarantees if C is known only roughly: it may lie anywhere within some radius of its assumed
// place (in offshore lifting, the "centre of gravity envelope").
#pragma once

#include <optional>
#include <vector>

#include "evenlift/load_models.h"
#include "evenlift/vec.h"

namespace evenlift {

// The tipping distance, by which C can be off before the object tips: the least distance of C from
// the line of an edge of H, in units of length. 0 if that is within tolerance (tau L), if H has no
// area, as with a single team of two, or if C is outside. `hull` must come from convex_hull, and
// `diameter` is L of the object. O(h).
double tipping_distance(const Points& hull, const Vec2& centre, double diameter);

struct LoadRange {
  double least = 0, greatest = 0;
};

// Whether the model's loads have ranges; true for plan and springs. O(1).
constexpr bool has_ranges(LoadModel model) {
  return model == LoadModel::plan || model == LoadModel::springs;
}

// The loads of robots that are in equilibrium with `loads` and give way like springs, while C is
// anywhere within the radius: load +- radius * per_length, but never less than 0. Exact up to the
// radius springs.same_within; beyond it robots go slack or take up load, and others carry more.
// O(m).
std::vector<LoadRange> load_ranges(const std::vector<double>& loads, const SpringLoads& springs,
                                   double radius);

// The greatest change of any load while C is anywhere within the radius. O(m).
double greatest_change(const SpringLoads& springs, double radius);

// The greatest radius within which C may lie so that, by springs, no robot carries more than its
// capacity; robots without one carry anything. At most springs.same_within, since no bound holds beyond it, and at most the tipping
// distance. Nothing if a robot is overloaded even with C at its assumed place. O(m).
std::optional<double> radius_within_capacity(const SpringLoads& springs, double tipping_distance,
                                             const std::vector<std::optional<double>>& capacities);

}  // namespace evenlift
