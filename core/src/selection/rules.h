// The rules of the choice, which also explain it in the walkthrough.
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

// In order. At each key the candidates that tie with the best remain. The first of the last ones in
// candidate order wins.
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

inline bool is_eligible(Rule rule, const Candidate& candidate) {
  return rule != Rule::longest_even || is_even(candidate.chord);
}

inline double value_of(Key key, const Candidate& candidate, double score) {
  return key == Key::score ? score : key == Key::ratio ? candidate.chord.ratio : candidate.length;
}

// The best value is the largest; `floor` is the selector's.
inline bool ties(Key key, double best, double value, double floor) {
  if (key == Key::ratio) return ratios_tie(best, value);
  if (key == Key::length) return lengths_tie(best, value);
  return value >= best - score_slack(std::fabs(best), floor);
}

// Keeps candidates i that tie with the best value(i) of a key.
template <class Value>
void keep_best(std::vector<std::uint32_t>& indices, Key key, double floor, Value value) {
  double best = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : indices) best = std::max(best, value(i));
  std::erase_if(indices, [&](std::uint32_t i) { return !ties(key, best, value(i), floor); });
}

}  // namespace evenlift
