#include "evenlift/closest_name.h"

#include <algorithm>
#include <cstddef>

namespace evenlift {
namespace {

std::size_t count_edits(std::string_view a, std::string_view b) {
  // Row i counts the edits from the first i bytes of `a` to each beginning of `b`.
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = edits[i][j];
      if (i == 0 || j == 0) {
        least = i + j;
        continue;
      }
      const std::size_t replaced = a[i - 1] == b[j - 1] ? 0 : 1;
      least = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, edits[i - 1][j - 1] + replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        least = std::min(least, edits[i - 2][j - 2] + 1);
    }
  return edits[a.size()][b.size()];
}

}  // namespace

std::string_view closest_name(std::string_view typed, const std::vector<std::string_view>& names) {
  constexpr std::size_t most_edits = 2, longest = 64;
  std::size_t fewest = std::min(most_edits + 1, (typed.size() + 1) / 2);
  std::string_view closest;
  if (typed.size() > longest) return closest;
  for (const std::string_view name : names)
    if (const std::size_t edits = count_edits(typed, name); edits < fewest) {
      fewest = edits;
      closest = name;
    }
  return closest;
}

}  // namespace evenlift
