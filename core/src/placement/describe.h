// Completes a placement, and moves its robots.
#pragma once

#include <optional>

#include "evenlift/placement.h"

namespace evenlift {

// Computes all values that follow from the teams, such as loads and coverage. O(n log n).
void describe_grasp(Placement& placement);

// Moves robots as with_moved() (moved.h) does, or returns an error that says why they cannot stand
// there. O(n log n).
std::optional<InputError> move_robots(Placement& placement, const Moved& moved);

// --- When robots that may be off by the setting `accuracy` have no room: with which they would have.

// An accuracy below `asked` for which `has_room` is true: about the greatest down to 1/64 of it.
// Empty if there is none. Calls has_room() at most nine times.
template <class HasRoom>
std::optional<double> less_accuracy(double asked, const HasRoom& has_room) {
  constexpr int most_halvings = 6;
  double less = asked;
  for (int i = 0; i < most_halvings; ++i) {
    less /= 2;
    if (!has_room(less)) continue;
    for (const double more : {1.75 * less, 1.5 * less, 1.25 * less})
      if (has_room(more)) return more;
    return less;
  }
  return std::nullopt;
}

}  // namespace evenlift
