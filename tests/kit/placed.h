// The placement of a document that must have one.
#pragma once

#include <utility>

#include "evenlift/placement.h"
#include "kit/catch.h"

namespace evenlift::testing {

inline Placement placed(const Document& document) {
  Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  return *std::move(placement);
}

}  // namespace evenlift::testing
