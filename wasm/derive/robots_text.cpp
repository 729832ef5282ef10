#include "derive/robots_text.h"

#include <cmath>

#include "evenlift/document.h"
#include "evenlift/numbers.h"

namespace evenlift::view {
namespace {

// Removes the word that it returns.
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
            shortest(robot.position.x) + ' ' + shortest(robot.position.y);
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
  // Any text that robots_text() would not write is invalid.
  if (robots.size() != number || robots_text(robots) != given) return std::nullopt;
  return robots;
}

std::string plan_text(const FailurePlan& plan) {
  if (!plan.possible && !plan.can_tip) return std::to_string(plan.tried);
  const std::string found = std::to_string(plan.robots) + ' ' + shortest(plan.greatest_load);
  return plan.can_tip ? found + ' ' + std::to_string(plan.tried) : found;
}

std::optional<FailurePlan> read_plan(std::string_view text) {
  const std::string_view given = text;
  const std::optional<std::uint64_t> number = read_whole(next_word(text));
  if (!number || *number > most_robots) return std::nullopt;
  const auto robots = static_cast<std::uint32_t>(*number);
  const std::optional<double> greatest = read_number(next_word(text));
  const std::optional<std::uint64_t> tried = read_whole(text);
  if (tried && *tried > most_robots) return std::nullopt;
  const FailurePlan plan{greatest && !tried, greatest && tried, greatest ? robots : 0,
                         greatest.value_or(0), tried ? static_cast<std::uint32_t>(*tried) : robots};
  return plan_text(plan) == given ? std::optional(plan) : std::nullopt;
}

}  // namespace evenlift::view
