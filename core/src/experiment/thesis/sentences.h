// Writes a sentence or two about each figure from the figure's data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// `most_robots` is the largest number of robots in teams of two, or 0 if there are no such teams.
// O(rows most_robots).
using Sentence = std::string (*)(const std::vector<Aggregate>& aggregates,
                                 std::uint32_t most_robots);

std::string spread_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string spread_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string closure_sentence(const std::vector<Aggregate>&, std::uint32_t);

// These functions write parts of such sentences. A no-break space keeps a value and its unit on one
// line.
std::string in_unit(double value, const std::string& unit);
std::string in_kg(double value);
std::string in_percent(double share);
// Names the method in words: "by area", "at equal angles", "in balance".
std::string by(Method method);
// Joins the items: "1, 2 and 3". Empty if there are no items.
std::string listed(const std::vector<std::string>& items);

}  // namespace evenlift::experiment
