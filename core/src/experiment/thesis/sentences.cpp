#include "experiment/thesis/sentences.h"

#include <algorithm>
#include <cmath>

#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/output/words.h"

namespace evenlift::experiment {
namespace {

using Rows = std::vector<Aggregate>;

constexpr const char* nothing =
    "No polygon of this set has a candidate, so no teams of two were measured.";

std::string points(double share) { return fixed(100 * std::fabs(share), 1) + " percentage points"; }

// "1.20 kg by area, 1.30 kg by circle and 12.5 kg at equal angles": every method with a value.
template <class Write>
std::string by_every_method(const Rows& rows, std::uint32_t robots, Pick pick, Write write) {
  std::vector<std::string> items;
  for (const Method method : all_methods) {
    const Aggregate* a = find(rows, method, robots);
    const std::optional<double> value = a ? pick(*a) : std::nullopt;
    if (value) items.push_back(write(*value) + " " + by(method));
  }
  return listed(items);
}

std::string times(const Range& range) {
  const std::string least = fixed(range.least, 1), most = fixed(range.most, 1);
  return least == most ? least : least + " to " + most;
}

// Names the method whose values vary most between the polygons, and the method whose values vary
// least. The greatest deviation over all numbers of robots decides.
template <class Write>
std::string deviations(const Rows& rows, std::uint32_t most_robots, Pick pick, Write write) {
  const Aggregate *most = nullptr, *least = nullptr;
  for (const Method method : all_methods) {
    const Aggregate* held = nullptr;
    for (const Aggregate& a : rows)
      if (a.method == method && a.robots <= most_robots && pick(a) &&
          (!held || *pick(a) > *pick(*held)))
        held = &a;
    if (!held) continue;
    if (!most || *pick(*held) > *pick(*most)) most = held;
    if (!least || *pick(*held) < *pick(*least)) least = held;
  }
  if (!most) return "One polygon alone has no standard deviation.";
  if (*pick(*most) <= 0) return "The value is the same for all these polygons, with every method.";
  return "Polygons differ most from each other when robots are placed " + by(most->method) +
         " (standard deviation up to " + write(*pick(*most)) + ", with " + of_robots(most->robots) +
         ") and least " + by(least->method) + " (up to " + write(*pick(*least)) + ", with " +
         of_robots(least->robots) + ").";
}

// The coverage of the greatest measured number of balanced robots, if it is below `robots`.
std::string fewer_in_balance(const Rows& rows, std::uint32_t robots) {
  const Aggregate* most = nullptr;
  for (const Aggregate& a : rows)
    if (a.method == Method::balanced && (!most || a.robots > most->robots)) most = &a;
  if (!most || most->robots >= robots) return "";
  return " " + of_robots(most->robots) + " " + by(most->method) + " cover " +
         in_percent(most->coverage.mean) + ".";
}

std::string lead_in_words(const std::optional<double>& lead, Method method) {
  if (!lead) return "";
  return points(*lead) + (*lead < 0 ? " less than " : " more than ") + by(method);
}

}  // namespace

// U+00A0 is between a value and its unit.
std::string in_unit(double value, const std::string& unit) {
  return fixed(value, 2) + "\u00A0" + unit;
}
std::string in_kg(double value) { return in_unit(value, "kg"); }
std::string in_percent(double share) { return fixed(100 * share, 1) + "\u00A0%"; }

std::string of_robots(std::uint32_t robots) { return std::to_string(robots) + " robots"; }

std::string by(Method method) {
  switch (method) {
    case Method::distributed:
      return "at equal angles";
    case Method::random:
      return "at random";
    case Method::balanced:
      return "in balance";
    case Method::area:
    case Method::circle:
    case Method::distance:
    case Method::given:  // no experiment places them
      break;
  }
  return "by " + std::string(name(method));
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

std::string spread_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  const std::uint32_t robots = std::min<std::uint32_t>(4, most_robots);
  std::string text = "With " + of_robots(robots) + " the spread of loads is " +
                     by_every_method(rows, robots, pick_spread, in_kg) +
                     ", averaged over the polygons.";
  const auto distributed = spread_ratio(rows, Method::distributed, most_robots);
  const auto random = spread_ratio(rows, Method::random, most_robots);
  if (distributed && random)
    text += " From 2 to " + of_robots(most_robots) + " the spread at equal angles is " +
            times(*distributed) +
            " times the spread of the algorithm (the mean of its three metrics), " +
            "and at random " + times(*random) + " times.";
  return text;
}

std::string spread_deviation_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  return deviations(
      rows, most_robots, [](const Aggregate& a) { return a.spread.deviation; }, in_kg);
}

std::string share_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  const std::uint32_t robots = std::min<std::uint32_t>(20, most_robots);
  return "With " + of_robots(robots) +
         " the robot with the larger share of its team’s load carries " +
         by_every_method(rows, robots, pick_share, in_percent) +
         ", averaged over the polygons; an even half is 50\u00A0%, as for any two balanced robots.";
}

std::string share_deviation_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  return deviations(
      rows, most_robots, [](const Aggregate& a) { return a.max_share.deviation; }, in_percent);
}

std::string coverage_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  if (most_robots == 2) return "One team stands on a line, which covers nothing.";
  const std::uint32_t robots = std::min<std::uint32_t>(12, most_robots);
  std::string text = "With " + of_robots(robots) + " the lifting base covers " +
                     by_every_method(rows, robots, pick_coverage, in_percent) + "." +
                     fewer_in_balance(rows, robots);
  const auto distributed = coverage_lead(rows, Method::distributed, most_robots);
  const auto random = coverage_lead(rows, Method::random, most_robots);
  if (distributed && random)
    text += " From 4 to " + of_robots(most_robots) + " the algorithm covers on average " +
            lead_in_words(distributed, Method::distributed) + ", and " +
            lead_in_words(random, Method::random) + ".";
  return text;
}

std::string coverage_deviation_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  return deviations(
      rows, most_robots, [](const Aggregate& a) { return a.coverage.deviation; }, in_percent);
}

std::string closure_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  const Aggregate* first = find(rows, Method::area, 2);
  if (!first || first->closable == 0)
    return "No teams of two bring any of these polygons into form closure.";
  const std::uint32_t robots = std::min<std::uint32_t>(8, most_robots);
  return "With " + of_robots(robots) + ", " +
         by_every_method(rows, robots, pick_closure, in_percent) +
         " are in form closure, of the polygons that teams of two can bring into it.";
}

}  // namespace evenlift::experiment
