#include "evenlift/result.h"

#include <algorithm>
#include <cstddef>
#include <optional>

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

// Takes "[2]" from the beginning of a path.
std::optional<std::size_t> take_index(std::string_view& path) {
  const std::size_t close = path.find(']');
  if (!path.starts_with('[') || close == std::string_view::npos) return std::nullopt;
  std::size_t index = 0;
  for (const char c : path.substr(1, close - 1)) {
    if (c < '0' || c > '9' || index > 1u << 30) return std::nullopt;
    index = 10 * index + static_cast<std::size_t>(c - '0');
  }
  path.remove_prefix(close + 1);
  return index;
}

// Takes a name from the beginning of a path that goes on with an index.
bool take_name(std::string_view& path, std::string_view name) {
  if (!path.starts_with(name) || path.substr(name.size(), 1) != "[") return false;
  path.remove_prefix(name.size());
  return true;
}

std::string option_in_words(std::string_view option) {
  for (const auto& [name, words] :
       {std::pair("supports", "robot {number}"), {"cargo", "load {number}"}}) {
    std::string_view path = option;
    if (!take_name(path, name)) continue;
    if (const auto index = take_index(path)) return say(words, {*index + 1});
  }
  return std::string(option);
}

}  // namespace

std::string path_of(const Place& place) {
  const auto index = [](std::size_t at) { return '[' + std::to_string(at) + ']'; };
  switch (place.kind) {
    case Place::Kind::vertex:
    case Place::Kind::edge:
      return (place.ring == 0 ? "polygon" : "holes" + index(place.ring - 1)) + index(place.index);
    case Place::Kind::hole:
      return "holes" + index(place.ring - 1);
    case Place::Kind::centre_of_mass:
      return "centre_of_mass";
    case Place::Kind::option:
      return place.option;
    case Place::Kind::nowhere:
    case Place::Kind::line:
    case Place::Kind::link:
      break;
  }
  return {};
}

Place place_of_path(std::string_view path) {
  for (const std::string_view container : {"settings.", "document."})
    if (path.starts_with(container)) path.remove_prefix(container.size());
  const std::string_view whole = path;
  if (path.empty()) return {};
  if (path == "centre_of_mass" || path.starts_with("centre_of_mass["))
    return {Place::Kind::centre_of_mass, 0, 0, {}};
  if (take_name(path, "polygon"))
    if (const auto vertex = take_index(path)) return {Place::Kind::vertex, *vertex, *vertex, {}};
  if (take_name(path, "holes"))
    if (const auto hole = take_index(path)) {
      const auto vertex = take_index(path);
      if (!vertex) return {Place::Kind::hole, 0, 0, {}, *hole + 1, *hole + 1};
      return {Place::Kind::vertex, *vertex, *vertex, {}, *hole + 1, *hole + 1};
    }
  return {Place::Kind::option, 0, 0, std::string(whole)};
}

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
      return option_in_words(place.option);
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
