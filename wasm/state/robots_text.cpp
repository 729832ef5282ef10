#include "state/robots_text.h"

#include <cmath>

#include "evenlift/document.h"
#include "evenlift/numbers.h"

namespace evenlift::view {
namespace {

// Takes the next word off the text.
std::string_view next_word(std::string_view& text) {
  const std::size_t end = text.find(' ');
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return word;
}

std::optional<double> coordinate(std::string_view word) {
  const std::optional<double> value = read_number(word);
  return value && std::abs(*value) <= 2 * max_coordinate ? value : std::nullopt;
}

}  // namespace

std::string robots_text(const std::vector<LiftingPoint>& robots) {
  std::string text;
  for (const LiftingPoint& robot : robots)
    text += (text.empty() ? "" : " ") + std::to_string(robot.edge) + ' ' +
            shortest(robot.position.x()) + ' ' + shortest(robot.position.y());
  return text;
}

std::optional<std::vector<LiftingPoint>> read_robots(std::string_view text, std::size_t number,
                                                     const Polygon& polygon) {
  const std::string_view given = text;
  std::vector<LiftingPoint> robots;
  while (!text.empty() && robots.size() < number) {
    const std::optional<std::uint64_t> edge = read_whole(next_word(text));
    const std::optional<double> x = coordinate(next_word(text)), y = coordinate(next_word(text));
    if (!edge || *edge >= polygon.vertices().size() || !x || !y) return std::nullopt;
    robots.push_back({Vec2(*x, *y), static_cast<std::uint32_t>(*edge)});
  }
  // What robots_text() would not write is no such text.
  if (robots.size() != number || robots_text(robots) != given) return std::nullopt;
  return robots;
}

}  // namespace evenlift::view
