#include "evenlift/document.h"

namespace evenlift {

double total_weight(const Settings& settings) {
  double weight = settings.weight;
  for (const Cargo& item : settings.cargo) weight += item.weight;
  return weight;
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

}  // namespace evenlift
