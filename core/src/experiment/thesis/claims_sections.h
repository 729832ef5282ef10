// The thesis's claims, section by section.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/claims.h"
#include "experiment/thesis/by_polygon.h"

namespace evenlift::experiment::claims {

using Results = std::vector<PolygonResult>;
using Rows = std::vector<Aggregate>;

// The text of a cell without a value.
inline constexpr const char* none = "—";

std::string percent(double share, int decimals = 0);
std::string rate(const Count& count);  // "56 % (63 of 113)"
// Writes "1.5 kg (s.d. 1.9 kg)". `value` is the text "1.5 kg"; the deviation, if any, is multiplied
// by `scale`.
std::string with_deviation(const std::string& value, const std::optional<double>& deviation,
                           double scale, int decimals, const char* unit);

// Each function adds the claims of the section of the thesis whose number is beside it.
// `most_robots` is the largest number of robots in teams of two in the charts.
void add_loads(std::vector<Claim>& claims, const Rows& rows, std::uint32_t most_robots);  // 5.3
void add_coverage(std::vector<Claim>& claims, const Results& results, const Rows& rows,
                  std::uint32_t most_robots);                                            // 5.4
void add_closure(std::vector<Claim>& claims, const Results& results, const Rows& rows);  // 5.5

}  // namespace evenlift::experiment::claims
