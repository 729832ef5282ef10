// How far robots may be off their places while all that is told of a placement stays true
// (algorithm.md, Accuracy). A robot at the edge is off along the outline, and a robot beneath the
// object in any direction. A robot in a notch (Polygon::is_notch) is pressed into it and counts as
// exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/placed_robots.h"

namespace evenlift {

// What may end first, in the order in which ties are decided.
enum class Promise : std::uint8_t {
  fits,      // the robots have room at the outline, and do not collide
  stands,    // the object stands, and does not tip under the given conditions (tilt.h)
  hold,      // form closure (Clearance::tolerance)
  capacity,  // no robot is overloaded, by its planned load under the given conditions
};
inline constexpr std::size_t promise_count = 4;

// The name in JSON: "fits", "stands" and so on. O(1).
std::string_view name(Promise promise);

struct Accuracy {
  double asked = 0;  // the setting `accuracy`

  // The lengths within which all robots must stand for each promise: if all are off by less, in any
  // combination, it is kept. Empty if it is not kept even without errors, or if no error ends it.
  // `fits` is safe, not sharp, and so is `stands`, except that the tilt by uneven heights is taken as
  // that without errors. `capacity` is computed to first order, and with
  // all robots off in the worst sense for each load, so it is about right.
  std::array<std::optional<double>, promise_count> within;

  // The least of them; empty if there is none.
  struct First {
    Promise what = Promise::fits;
    double within = 0;
    // The robots that it depends on, as far as they can be named: the one without more room, or two
    // that are too near; the two at the ends of the tipping line; the robot that comes to a corner;
    // the robot that is overloaded.
    std::vector<std::size_t> robots;
    // The edge, counted from 0, at which the first of them has no more room. Only for `fits`.
    std::optional<std::uint32_t> edge;
  };
  std::optional<First> first;

  // If all robots are off by up to `asked`: the greatest load under the given conditions, computed
  // like `capacity`, and its robot. Empty if `asked` is 0, or if the object falls or tips.
  struct Greatest {
    std::size_t robot = 0;
    double load = 0;
  };
  std::optional<Greatest> greatest;

  std::vector<std::size_t> in_notches;  // the robots that stay in their notches

  // Whether what is told remains true if all robots are off by less than `asked`. `near` is tau L.
  bool keeps_asked(double near) const { return !first || first->within >= asked - near; }

  const std::optional<double>& operator[](Promise promise) const {
    return within[static_cast<std::size_t>(promise)];
  }
};

// The edge of the lifting base nearest to C, between two robots, counted from 0; and the tipping
// distance (uncertainty.h). If all robots are on one line, they are its ends.
struct TippingLine {
  std::array<std::size_t, 2> robots{};
  double distance = 0;
};

}  // namespace evenlift
