// Lists of numbers in sentences.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace evenlift {

// "1, 2 and 5". Of more than eight numbers, only the first seven
// appear, with "and 3 more".
inline std::string listed(const std::vector<std::size_t>& numbers) {
  constexpr std::size_t most_named = 8;
  const std::size_t named = numbers.size() > most_named ? most_named - 1 : numbers.size();
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) text += i + 1 == numbers.size() ? " and " : ", ";
    text += std::to_string(numbers[i]);
  }
  if (named < numbers.size()) text += " and " + std::to_string(numbers.size() - named) + " more";
  return text;
}

// "2, 4 and 5" for robots, teams or candidates numbered from 0.
template <class Number>
std::string numbers_from_1(const std::vector<Number>& numbers) {
  std::vector<std::size_t> shown;
  for (const Number number : numbers) shown.push_back(number + std::size_t{1});
  return listed(shown);
}

}  // namespace evenlift
