// The selection methods in a person's words.
#pragma once

#include <algorithm>
#include <iterator>

#include "evenlift/document.h"

namespace evenlift::view {

struct Method {
  Metric metric;
  const char* label;
  const char* about;
};
inline constexpr Method methods[] = {
    {Metric::area, "Area", "each team adds most area to the base"},
    {Metric::circle, "Circle", "each team fits the largest circles"},
    {Metric::distance, "Distance", "each team pushes tipping farthest out"},
    {Metric::distributed, "Distributed", "teams at equal angles, to compare"},
    {Metric::random, "Random", "teams at random, to compare"},
};

inline const Method& method(Metric metric) {
  return *std::find_if(std::begin(methods), std::end(methods),
                       [&](const Method& m) { return m.metric == metric; });
}

}  // namespace evenlift::view
