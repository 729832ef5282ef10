// What each figure shows, in a sentence or two made from the data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// A sentence from the aggregates with 1 .. most_teams teams. O(rows most_teams).
using Sentence = std::string (*)(const std::vector<Aggregate>& aggregates,
                                 std::uint32_t most_teams);

std::string spread_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string spread_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string closure_sentence(const std::vector<Aggregate>&, std::uint32_t);

// The pieces of such sentences. A value and its unit stay on one line.
std::string in_kg(double value);
std::string in_percent(double share);
std::string of_robots(std::uint32_t teams);  // "6 robots"
// How a method's placements came about: "by area", "at equal angles".
std::string by(Method method);
// "1, 2 and 3"; empty if there are none.
std::string listed(const std::vector<std::string>& items);

}  // namespace evenlift::experiment
