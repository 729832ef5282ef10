// Parts of sentences: lists of numbers, and a capital letter at the beginning.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "evenlift/wording.h"

namespace evenlift {

// Writes "1, 2 and 5". If there are more than eight items, it writes the first seven and "and 3
// more".
inline std::string listed_briefly(const std::vector<std::string>& numbers) {
  if (numbers.empty()) return {};
  constexpr std::size_t most_named = 8;
  const bool all = numbers.size() <= most_named;
  const std::size_t before = all ? numbers.size() - 1 : most_named - 1;
  std::string text;
  for (std::size_t i = 0; i < before; ++i) text += (i > 0 ? ", " : "") + numbers[i];
  if (!all) return say("{numbers} and {rest} more", {text, numbers.size() - before});
  return before == 0 ? numbers[0] : say("{numbers} and {last}", {text, numbers.back()});
}

// Writes indices of robots, teams or candidates, which count from 0, as numbers from 1: "2, 4 and
// 5".
template <class Number>
std::string numbers_from_1(const std::vector<Number>& numbers) {
  std::vector<std::string> shown;
  for (const Number number : numbers) shown.push_back(std::to_string(number + std::size_t{1}));
  return listed_briefly(shown);
}

// The same of robots by what people call them (Placement::called()).
template <class Robots, class Indices>
std::string numbers_of(const Robots& placement, const Indices& robots) {
  std::vector<std::string> shown;
  for (const auto robot : robots) shown.push_back(placement.called(robot));
  return listed_briefly(shown);
}

inline std::string with_capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

// --- Rounds numbers as words.h does, but writes them for programs: the minus sign is "-".

// Writes exactly `decimals` (0 .. 9) digits after the point, and never "-0". From 1e15 on, it
// writes the same as shortest() (numbers.h).
std::string ascii_fixed(double value, int decimals);

}  // namespace evenlift
