// Linear programs in rationals, by the simplex method with Bland's rule: exact, and always
// terminating.
#pragma once

#include <optional>
#include <vector>

#include "oracle/exact.h"

namespace simplex {

using oracle::Exact;
using Row = std::vector<Exact>;

// The least value of cost . x over x >= 0 with rows x = right, or nothing if there is no such x. It
// must be bounded from below.
std::optional<Exact> least(const std::vector<Row>& rows, const Row& right, const Row& cost);

}  // namespace simplex
