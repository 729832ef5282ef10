#include "evenlift/document.h"

#include <algorithm>
#include <vector>

#include "document/setting_values.h"
#include "evenlift/closest_name.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/similar_setting.h"
#include "evenlift/wording.h"

namespace evenlift {

double total_weight(const Settings& settings) {
  double weight = settings.weight;
  for (const Cargo& item : settings.cargo) weight += item.weight;
  return weight;
}

std::string_view name_of_support(const Settings& settings, std::size_t support) {
  const std::vector<std::string>& names = settings.support_names;
  const bool has_name = settings.method == Method::given && support < names.size();
  return has_name ? std::string_view(names[support]) : std::string_view();
}

std::string support_called(const Settings& settings, std::size_t support) {
  const std::string number = std::to_string(support + 1);
  const std::string_view name = name_of_support(settings, support);
  return name.empty() ? number : number + " (" + std::string(name) + ")";
}

std::string_view name(Method method) {
  switch (method) {
    case Method::area:
      return "area";
    case Method::circle:
      return "circle";
    case Method::distance:
      return "distance";
    case Method::distributed:
      return "distributed";
    case Method::random:
      return "random";
    case Method::balanced:
      return "balanced";
    case Method::given:
      return "given";
  }
  return {};
}

std::optional<Method> method_from_name(std::string_view text) {
  for (const Method method : named_methods) {
    if (text == name(method)) return method;
  }
  return std::nullopt;
}

std::string_view name(Goal goal) { return goal == Goal::cover ? "cover" : "hold"; }

std::optional<Goal> goal_from_name(std::string_view text) {
  for (const Goal goal : {Goal::cover, Goal::hold})
    if (text == name(goal)) return goal;
  return std::nullopt;
}

std::string_view name(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::none:
      return "none";
    case LengthUnit::m:
      return "m";
    case LengthUnit::cm:
      return "cm";
    case LengthUnit::mm:
      return "mm";
    case LengthUnit::in:
      return "in";
  }
  return {};
}

std::string_view name(WeightUnit unit) {
  switch (unit) {
    case WeightUnit::kg:
      return "kg";
    case WeightUnit::t:
      return "t";
    case WeightUnit::N:
      return "N";
    case WeightUnit::lb:
      return "lb";
  }
  return {};
}

const char weight_is_weighed[] =
    "the readings give the weight: leave out the weight, or the readings";

double in_kilograms(double weight, WeightUnit unit) {
  switch (unit) {
    case WeightUnit::kg:
      return weight;
    case WeightUnit::t:
      return weight * 1000;
    case WeightUnit::N:
      return weight / 9.80665;
    case WeightUnit::lb:
      return weight * 0.45359237;
  }
  return weight;
}

double in_metres(double length, LengthUnit unit) {
  switch (unit) {
    case LengthUnit::none:
    case LengthUnit::m:
      break;
    case LengthUnit::cm:
      return length / 100;
    case LengthUnit::mm:
      return length / 1000;
    case LengthUnit::in:
      return length * 254 / 10000;
  }
  return length;
}

std::string_view name(Positions positions) {
  return positions == Positions::best ? "best" : "range";
}

std::optional<Positions> positions_from_name(std::string_view text) {
  for (const Positions positions : {Positions::best, Positions::range})
    if (text == name(positions)) return positions;
  return std::nullopt;
}

Goal goal_of(const Settings& settings) {
  if (settings.method == Method::given) return Goal::cover;
  if (settings.goal) return *settings.goal;
  const bool holds = settings.method == Method::balanced && settings.robots > 3;
  return holds ? Goal::hold : Goal::cover;
}

bool swaps_teams(const Settings& settings) {
  return selects_candidates(settings.method) && goal_of(settings) == Goal::hold;
}

namespace {

bool is_edge_point(const EdgePoint& point) {
  return point.edge < max_vertices && point.part >= 0 && point.part <= 1;
}

// Reads a number from 1 to `most` as an index from 0.
std::optional<std::uint32_t> read_index(std::string_view text, std::uint64_t most) {
  const std::optional<std::uint64_t> number = read_whole(text);
  if (!number || *number < 1 || *number > most) return std::nullopt;
  return static_cast<std::uint32_t>(*number - 1);
}

std::optional<EdgePoint> read_edge_point(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto edge = read_index(text.substr(0, colon), max_vertices);
  const auto part = read_number(text.substr(colon + 1));
  if (!edge || !part) return std::nullopt;
  const EdgePoint point{*edge, *part + 0.0};  // -0 would make a different document
  return is_edge_point(point) ? std::optional(point) : std::nullopt;
}

// `at` is the position of the '@'.
std::optional<MovedTeam> read_moved_team(std::string_view text, std::size_t at) {
  const std::size_t slash = text.find('/', at);
  if (slash == std::string_view::npos) return std::nullopt;
  const auto team = read_index(text.substr(0, at), max_teams);
  const auto end = read_edge_point(text.substr(at + 1, slash - at - 1));
  const auto opposite = read_index(text.substr(slash + 1), max_vertices);
  if (!team || !end || !opposite) return std::nullopt;
  return MovedTeam{*team, *end, *opposite};
}

bool read_one(std::string_view text, Moved& moved) {
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos) {
    const auto point = read_edge_point(text);
    if (point) moved.robots.push_back(*point);
    return point && moved.robots.size() <= most_robots;
  }
  const auto team = read_moved_team(text, at);
  if (team) moved.teams.push_back(*team);
  return team && moved.teams.size() <= most_moved_teams;
}

std::string text_of(const EdgePoint& point) {
  return std::to_string(point.edge + 1) + ':' + shortest(point.part);
}

}  // namespace

std::string moved_text(const Moved& moved) {
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : ",") + word; };
  for (const EdgePoint& robot : moved.robots) add(text_of(robot));
  for (const MovedTeam& team : moved.teams)
    add(std::to_string(team.team + 1) + '@' + text_of(team.end) + '/' +
        std::to_string(team.opposite + 1));
  return text;
}

std::optional<Moved> read_moved(std::string_view text) {
  Moved moved;
  const bool good =
      for_each_word(text, [&](std::string_view word) { return read_one(word, moved); });
  return good && is_moved(moved) ? std::optional(std::move(moved)) : std::nullopt;
}

bool is_moved(const Moved& moved) {
  if (!moved.robots.empty() && !moved.teams.empty()) return false;
  if (moved.robots.size() > most_robots || moved.teams.size() > most_moved_teams) return false;
  if (!std::all_of(moved.robots.begin(), moved.robots.end(), is_edge_point)) return false;
  for (std::size_t i = 0; i < moved.teams.size(); ++i) {
    const MovedTeam& team = moved.teams[i];
    if (!is_edge_point(team.end) || team.opposite >= max_vertices || team.team >= max_teams)
      return false;
    if (i > 0 && !(moved.teams[i - 1].team < team.team)) return false;
  }
  return true;
}

std::string_view similar_setting(std::string_view typed) {
  std::vector<std::string_view> names;
  for (const SettingRow& row : all_settings()) names.push_back(row.name);
  return closest_name(typed, names);
}

std::string unknown_setting(std::string_view typed) {
  const std::string_view similar = similar_setting(typed);
  return similar.empty() ? say("unknown setting")
                         : say("unknown setting; did you mean {setting}?", {similar});
}

}  // namespace evenlift
