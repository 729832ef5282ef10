// The rules by which teams are chosen. The walkthrough explains each choice by them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/selection.h"
#include "evenlift/tolerance.h"

namespace evenlift {

enum class Key : std::uint8_t { score, ratio, length };

// The keys of a rule, in order. At each key, only the candidates that tie with the best one remain.
// After the last key, the first remaining candidate in candidate order wins.
inline std::span<const Key> keys_of(Rule rule) {
  static constexpr Key by_length[] = {Key::length, Key::ratio},
                       by_ratio[] = {Key::ratio, Key::length},
                       by_score[] = {Key::score, Key::ratio, Key::length};
  switch (rule) {
    case Rule::longest_even:
    case Rule::longest:
      return by_length;
    case Rule::most_even:
      return by_ratio;
    case Rule::score:
      break;
  }
  return by_score;
}

inline Rule rule_of_first_team(const std::vector<Candidate>& candidates, FirstTeam first) {
  if (first == FirstTeam::longest) return Rule::longest;
  return std::any_of(candidates.begin(), candidates.end(),
                     [](const Candidate& c) { return is_even(c.chord); })
             ? Rule::longest_even
             : Rule::most_even;
}

inline bool is_eligible(Rule rule, double ratio) {
  return rule != Rule::longest_even || ratio >= even_ratio;
}

inline double value_of(Key key, const Candidate& candidate, double score) {
  return key == Key::score ? score : key == Key::ratio ? candidate.chord.ratio : candidate.length;
}

// Whether a value ties with the best, which is the largest. `floor` is Selector::floor().
inline bool ties(Key key, double best, double value, double floor) {
  if (key == Key::ratio) return ratios_tie(best, value);
  if (key == Key::length) return lengths_tie(best, value);
  return value >= best - score_slack(std::fabs(best), floor);
}

// Keeps each candidate i if value(i), its value for the key, ties with the best value.
template <class Value>
void keep_best(std::vector<std::uint32_t>& indices, Key key, double floor, Value value) {
  double best = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : indices) best = std::max(best, value(i));
  std::erase_if(indices, [&](std::uint32_t i) { return !ties(key, best, value(i), floor); });
}

}  // namespace evenlift
