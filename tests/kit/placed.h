// The placement of a document that must have one, perhaps by another method and number of teams.
#pragma once

#include <cstdint>
#include <utility>

#include "evenlift/placement.h"
#include "kit/catch.h"

namespace evenlift::testing {

inline Placement placed(const Document& document) {
  Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  return *std::move(placement);
}

inline Placement placed(Document document, Method method, std::uint32_t teams = 3,
                        std::uint64_t seed = 1) {
  document.settings.method = method;
  document.settings.teams = teams;
  document.settings.seed = seed;
  return placed(document);
}

}  // namespace evenlift::testing
