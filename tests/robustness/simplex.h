// Linear programs in rationals, by the simplex method with Bland's rule: exact, and always ending.
#pragma once

#include <optional>
#include <vector>

#include "oracle/rational.h"

namespace simplex {

using Exact = oracle::Rational;
using Row = std::vector<Exact>;

// The least cost . x, bounded from below, over x >= 0 with rows x = right; nothing without such x.
std::optional<Exact> least(const std::vector<Row>& rows, const Row& right, const Row& cost);

}  // namespace simplex
