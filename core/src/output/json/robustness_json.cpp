#include "output/json/robustness_json.h"

#include <algorithm>
#include <cmath>

#include "evenlift/output/json_text.h"
#include "evenlift/output/quantities.h"

namespace evenlift::json {

std::string number_or_null(const std::optional<double>& value) {
  return value ? number(*value) : "null";
}

namespace {

std::string written(const std::optional<double>& value, Unit unit) {
  if (!value || std::isinf(*value)) return "null";
  if (unit == Unit::yes_or_no) return boolean(*value == 1);
  return number(*value);
}

std::string failure(std::size_t robot, const std::optional<RestOfRobots>& rest,
                    const std::vector<std::size_t>* overloaded, bool with_disturbance) {
  const auto if_carried = [&](const std::string& value) { return rest ? value : "null"; };
  const RestOfRobots known = rest.value_or(RestOfRobots{});
  std::vector<Member> members = {
      {"robot", std::to_string(robot)},
      {"carried", boolean(rest.has_value())},
      {"steady", boolean(known.steady)},
      {"clear", boolean(known.clear)},
      {"com_margin", if_carried(number(known.tipping_distance))},
      {"coverage", if_carried(number(known.coverage))},
      {"form_closure", if_carried(boolean(known.form_closure))},
      {"margin", number_or_null(known.margin)},
      {"plan_max", number_or_null(known.greatest_by_plan)},
      {"springs_max", if_carried(number(known.greatest_by_springs))},
      {"best_max", if_carried(number(known.least_greatest))},
      {"springs", known.springs.empty() ? "null" : numbers(known.springs)}};
  if (overloaded) {
    const bool is_known = rest && known.stays;
    members.push_back({"over_capacity", is_known ? boolean(!overloaded->empty()) : "null"});
    members.push_back({"overloaded", is_known ? wholes(*overloaded) : "null"});
  }
  if (with_disturbance) {
    members.push_back({"greatest_end", number_or_null(known.greatest_end)});
    members.push_back({"stays", if_carried(boolean(known.stays))});
  }
  return object(members);
}

}  // namespace

std::vector<Member> quantities_of(std::string_view object, const Reported& of) {
  std::vector<Member> members;
  for (const Quantity& quantity : quantities()) {
    const std::size_t dot = quantity.json.find('.');
    if (dot != std::string_view::npos && quantity.json.substr(0, dot) == object)
      members.push_back(
          {quantity.json.substr(dot + 1), written(quantity.value(of), quantity.unit)});
  }
  return members;
}

Member quantity(std::string_view name, const Reported& of) {
  const auto all = quantities();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Quantity& each) { return each.json == name; });
  return {found->json, written(found->value(of), found->unit)};
}

std::string robots(const Placement& placement, int depth) {
  std::vector<std::string> items;
  for (const PlacedRobot& robot : placed_robots(placement)) {
    std::vector<Member> members = {{"at", pair(robot.at)},
                                   {"team", std::to_string(robot.team)},
                                   {"load", placement.loads ? number(robot.load) : "null"},
                                   {"contact", robot.beneath ? "null" : pair(robot.contact)},
                                   {"stand", pair(robot.stand)},
                                   {"heading", robot.beneath ? "null" : number(robot.heading_deg)},
                                   {"place", text(robot.beneath ? "beneath" : "edge")}};
    if (!robot.name.empty()) members.push_back({"name", text(robot.name)});
    if (!placement.supports.empty())
      members.push_back({"support", std::to_string(robot.number - 1)});
    items.push_back(object(members));
  }
  return long_array(items, depth);
}

std::string models(const std::optional<ModelLoads>& models, int depth) {
  if (!models) return "null";
  return long_object({{"springs", numbers(models->springs.loads)},
                      {"best", number(models->best)},
                      {"worst", numbers(models->worst)}},
                     depth);
}

std::string ranges(const std::vector<LoadRange>& ranges) {
  std::vector<std::string> items;
  for (const LoadRange& range : ranges)
    items.push_back(array({number(range.least), number(range.greatest)}));
  return array(items);
}

std::string accuracy(const Reported& of, int depth) {
  const Accuracy& accuracy = of.report.accuracy;
  std::string limited_by = "null";
  if (accuracy.first) {
    std::vector<std::string> robots;
    for (const std::size_t robot : accuracy.first->robots) robots.push_back(std::to_string(robot));
    const auto& edge = accuracy.first->edge;
    limited_by = object({{"what", text(name(accuracy.first->what))},
                         {"robots", array(robots)},
                         {"edge", edge ? std::to_string(*edge) : "null"}});
  }
  std::vector<Member> members = {
      {"asked", number(accuracy.asked)},
      {"all_within", accuracy.first ? number(accuracy.first->within) : "null"},
      {"limited_by", limited_by}};
  for (Member& member : quantities_of("accuracy", of)) members.push_back(std::move(member));
  return long_object(members, depth);
}

std::string tilt(const std::optional<Tilt>& tilt, int depth) {
  if (!tilt) return "null";
  return long_object({{"height", number(tilt->height)},
                      {"reach", number(tilt->reach)},
                      {"stays", boolean(tilt->stays)},
                      {"slope", number(tilt->slope)},
                      {"degrees", number(tilt->degrees)},
                      {"acceleration", number(tilt->acceleration)},
                      {"acceleration_left", number_or_null(tilt->acceleration_left)},
                      {"slope_left", number_or_null(tilt->slope_left)}},
                     depth);
}

// If the object falls, a load has no place. The weight stays, so that the result can be opened.
std::string extra(const std::optional<ExtraLoad>& extra, double weight, int depth) {
  const ExtraLoad known = extra.value_or(ExtraLoad{});
  const auto if_known = [&](const std::string& value) { return extra ? value : "null"; };
  return long_object({{"weight", number(weight)},
                      {"region", if_known(points(known.region, depth + 1))},
                      {"share", if_known(number(known.share))},
                      {"anywhere", number_or_null(known.anywhere)}},
                     depth);
}

std::string weighing(const Reported& of, int depth) {
  const Weighing& found = *of.placement.weighing;
  const auto& fit = of.report.readings_fit;
  const auto& height = found.height;
  return long_object(
      {{"weight", number(found.weight)},
       {"weight_error", number(found.weight_error)},
       {"centre_of_mass", pair(found.centre)},
       {"radius", number(radius_of(found, of.placement.settings, of.shown.carrying.com_height))},
       {"residuals", found.residuals.empty() ? "null" : numbers(found.residuals)},
       {"fit", fit ? boolean(fit->fit) : "null"},
       {"suspect", fit && fit->suspect ? std::to_string(*fit->suspect) : "null"},
       {"too_little", fit && !fit->too_little.empty() ? numbers(fit->too_little) : "null"},
       {"height", height ? number(height->height) : "null"},
       {"height_error", height ? number(height->error) : "null"},
       {"height_fits", height ? boolean(height->fits) : "null"}},
      depth);
}

std::string robustness(const Reported& of, const std::optional<ModelLoads>& models, int depth) {
  const Placement& placement = of.placement;
  const double com_radius = of.shown.com_radius;
  std::vector<Member> members = quantities_of("robustness", of);
  members.push_back({"load_per_length", models ? numbers(models->springs.per_length) : "null"});
  if (com_radius > 0) {
    members.push_back({"com_radius", number(com_radius)});
    members.push_back({"exact_within", models ? number(models->springs.same_within) : "null"});
  }
  if (models && models->are_ranges()) {
    members.push_back({"plan_ranges", ranges(loads_by(LoadModel::plan, placement, models))});
    members.push_back({"springs_ranges", ranges(loads_by(LoadModel::springs, placement, models))});
  }
  return long_object(members, depth);
}

std::string failures(const Report& report, int depth) {
  std::vector<std::string> items;
  for (std::size_t robot = 0; robot < report.failures.size(); ++robot)
    items.push_back(failure(robot, report.failures[robot],
                            report.has_capacities ? &report.overloaded_after[robot] : nullptr,
                            report.disturbance.any()));
  return long_array(items, depth);
}

}  // namespace evenlift::json
