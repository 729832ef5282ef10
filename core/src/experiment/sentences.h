// What each figure shows, in a sentence or two made from the data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift {

// Of aggregates with 1 .. most_teams teams. O(rows most_teams).
using Sentence = std::string (*)(const std::vector<Aggregate>& aggregates,
                                 std::uint32_t most_teams);

std::string spread_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string spread_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string share_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string coverage_deviation_sentence(const std::vector<Aggregate>&, std::uint32_t);
std::string closure_sentence(const std::vector<Aggregate>&, std::uint32_t);

}  // namespace evenlift
