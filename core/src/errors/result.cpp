#include "evenlift/result.h"

#include <algorithm>
#include <cstddef>

#include "evenlift/closest_name.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

struct Words {
  const char *one, *two, *in_hole, *two_in_hole, *of_outline;
};
constexpr Words vertex_words{
    "vertex {number}", "vertices {first} and {second}", "hole {hole}, vertex {number}",
    "hole {hole}, vertices {first} and {second}", "the outline's vertex {number}"};
constexpr Words edge_words{"edge {number}", "edges {first} and {second}",
                           "hole {hole}, edge {number}", "hole {hole}, edges {first} and {second}",
                           "the outline's edge {number}"};

std::string one_of(const Words& words, std::size_t ring, std::size_t number) {
  return ring == 0 ? say(words.one, {number}) : say(words.in_hole, {ring, number});
}

// "vertex 3", "vertices 3 and 7" if the place names two, "hole 2, vertex 3", or "hole 2, vertex 3
// and the outline's vertex 7".
std::string one_or_two(const Words& words, const Place& place) {
  const std::size_t first = place.index + 1, second = place.other + 1;
  if (place.ring != place.other_ring)
    return say("{first} and {second}",
               {one_of(words, place.ring, first), place.other_ring == 0
                                                      ? say(words.of_outline, {second})
                                                      : one_of(words, place.other_ring, second)});
  if (place.other == 0 || place.other == place.index) return one_of(words, place.ring, first);
  return place.ring == 0 ? say(words.two, {first, second})
                         : say(words.two_in_hole, {place.ring, first, second});
}

}  // namespace

InputError bad_setting(std::string name, std::string why) {
  return {ErrorCode::bad_setting, std::move(why), {Place::Kind::option, 0, 0, std::move(name)}};
}

std::string describe(const Place& place) {
  switch (place.kind) {
    case Place::Kind::nowhere:
      return {};
    case Place::Kind::line:
      return place.other == 0 ? say("line {line}", {place.index})
                              : say("line {line}, column {column}", {place.index, place.other});
    case Place::Kind::vertex:
      return one_or_two(vertex_words, place);
    case Place::Kind::edge:
      return one_or_two(edge_words, place);
    case Place::Kind::hole:
      return say("hole {hole}", {place.ring});
    case Place::Kind::centre_of_mass:
      return say("centre of mass");
    case Place::Kind::option:
      return place.option;
    case Place::Kind::link:
      return place.index == 0 ? say("link") : say("link, character {number}", {place.index});
  }
  return {};
}

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
