#pragma once

#include <utility>

#include "evenlift/polygon.h"
#include "kit/catch.h"

namespace evenlift::testing {

inline Polygon polygon(Points vertices) {
  auto p = Polygon::create(std::move(vertices));
  REQUIRE(p.ok());
  return *std::move(p);
}

inline const Points square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
inline const Points u_shape{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};

}  // namespace evenlift::testing
