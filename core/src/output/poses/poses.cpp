#include "evenlift/output/poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "evenlift/formats.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json_text.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

constexpr std::size_t longest_frame = 255;

bool is_of_frame(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-./").find(c) != std::string_view::npos;
}

std::string_view name(PoseOrigin origin) { return origin == PoseOrigin::file ? "file" : "com"; }

// Zero has no sign in a table or a message.
double without_sign(double value) { return value == 0 ? 0 : value; }

// The robots relative to `origin`.
std::vector<PlacedRobot> robots_from(const Placement& placement, PoseOrigin origin) {
  std::vector<PlacedRobot> robots = placed_robots(placement);
  if (origin == PoseOrigin::com)
    for (PlacedRobot& robot : robots)
      for (Vec2* const place : {&robot.at, &robot.contact, &robot.stand})
        *place -= placement.centre_of_mass;
  return robots;
}

std::string unit_or_nothing(LengthUnit unit) {
  return unit == LengthUnit::none ? std::string() : std::string(name(unit));
}

std::string as_csv(const std::vector<PlacedRobot>& robots, bool carried, const Units& units) {
  std::string text =
      "robot,team,x,y,heading_deg,load,unit,weight_unit,at_x,at_y,contact_x,contact_y,name\n";
  const std::string labels =
      "," + unit_or_nothing(units.length) + "," + std::string(name(units.weight));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const PlacedRobot& robot = robots[i];
    text += std::to_string(robot.number) + "," + std::to_string(robot.team + 1);
    for (const double value : {robot.stand.x, robot.stand.y, robot.heading_deg})
      text += "," + shortest(without_sign(value));
    text += "," + (carried ? shortest(without_sign(robot.load)) : std::string());
    text += labels;
    for (const double value : {robot.at.x, robot.at.y}) text += "," + shortest(without_sign(value));
    for (const double value : {robot.contact.x, robot.contact.y})
      text += "," + (robot.beneath ? std::string() : shortest(without_sign(value)));
    text += "," + csv_cell(robot.name) + "\n";
  }
  return text;
}

std::string as_json(const std::vector<PlacedRobot>& robots, bool carried, const Units& units,
                    const PoseOptions& options) {
  std::vector<std::string> items;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const PlacedRobot& robot = robots[i];
    const auto number = [](double value) { return json::number(without_sign(value)); };
    const auto pair = [&](const Vec2& at) { return json::array({number(at.x), number(at.y)}); };
    std::vector<json::Member> members = {{"robot", std::to_string(robot.number)},
                                         {"team", std::to_string(robot.team + 1)},
                                         {"x", number(robot.stand.x)},
                                         {"y", number(robot.stand.y)},
                                         {"heading_deg", number(robot.heading_deg)},
                                         {"direction", pair(robot.direction)},
                                         {"load", carried ? number(robot.load) : "null"},
                                         {"at", pair(robot.at)},
                                         {"contact", robot.beneath ? "null" : pair(robot.contact)}};
    if (!robot.name.empty()) members.push_back({"name", json::text(robot.name)});
    items.push_back(json::object(members));
  }
  const bool has_unit = units.length != LengthUnit::none;
  return json::long_object({{"frame", json::text(options.frame)},
                            {"origin", json::text(name(options.origin))},
                            {"unit", has_unit ? json::text(name(units.length)) : "null"},
                            {"weight_unit", json::text(name(units.weight))},
                            {"robots", json::long_array(items, 1)}},
                           0) +
         "\n";
}

// --- The message of ROS 2

// Some YAML readers require floating-point numbers to have a point, and a sign in the exponent.
std::string yaml_number(double value) {
  std::string text = shortest(without_sign(value));
  const std::size_t exponent = text.find('e');
  if (text.find('.') == std::string::npos)
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  return text;
}

// z and w >= 0 of the quaternion that turns the x axis about z to `direction`, by the half-angle
// formula without cancellation.
std::array<double, 2> half_turn(const Vec2& direction) {
  const double x = direction.x, y = direction.y + 0.0;  // straight back is a left turn
  if (x >= 0) {
    const double w = std::sqrt((1 + x) / 2);
    return {y / (2 * w), w};
  }
  const double z = std::sqrt((1 - x) / 2);
  return {y < 0 ? -z : z, std::fabs(y) / (2 * z)};
}

std::string vector_in_yaml(std::initializer_list<std::pair<const char*, double>> members) {
  std::string text;
  for (const auto& [member, value] : members)
    text += (text.empty() ? "{" : ", ") + std::string(member) + ": " + yaml_number(value);
  return text + "}";
}

std::string point_in_yaml(const Vec2& at, const Units& units) {
  return vector_in_yaml(
      {{"x", in_metres(at.x, units.length)}, {"y", in_metres(at.y, units.length)}});
}

std::string as_yaml(const std::vector<PlacedRobot>& robots, bool carried, bool sized,
                    const Units& units, const PoseOptions& options) {
  std::string text =
      "# " + say("geometry_msgs/msg/PoseArray, in metres; x of each pose faces the object") + "\n";
  if (units.length == LengthUnit::none)
    text += "# " + say("The object has no unit: its coordinates are taken for metres") + "\n";
  text += "header:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: \"" + options.frame + "\"\n";
  text += robots.empty() ? "poses: []\n" : "poses:\n";
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const PlacedRobot& robot = robots[i];
    const auto [z, w] = half_turn(robot.direction);
    text += "  # " +
            (carried ? say("Robot {robot} (team {team}) carries {load}",
                           {robot.number, robot.team + 1,
                            shortest(robot.load) + " " + std::string(name(units.weight))})
                     : say("Robot {robot} (team {team}) carries nothing: the object falls",
                           {robot.number, robot.team + 1})) +
            "\n";
    if (!robot.name.empty())
      text += "  # " + std::string(poses_name) + " " + json::text(robot.name) + "\n";
    if (sized)
      text += "  # " + std::string(poses_lift) + " " + point_in_yaml(robot.at, units) +
              (robot.beneath
                   ? ""
                   : ", " + std::string(poses_touch) + " " + point_in_yaml(robot.contact, units)) +
              "\n";
    text += "  - position: " +
            vector_in_yaml({{"x", in_metres(robot.stand.x, units.length)},
                            {"y", in_metres(robot.stand.y, units.length)},
                            {"z", 0}}) +
            "\n    orientation: " + vector_in_yaml({{"x", 0}, {"y", 0}, {"z", z}, {"w", w}}) + "\n";
  }
  return text;
}

}  // namespace

std::optional<PoseFormat> pose_format_of_file(std::string_view file_name) {
  for (const auto& [ending, format] :
       {std::pair(".csv", PoseFormat::csv), std::pair(".json", PoseFormat::json),
        std::pair(".yaml", PoseFormat::yaml)})
    if (file_name.ends_with(ending)) return format;
  return std::nullopt;
}

std::optional<PoseOrigin> pose_origin_from_name(std::string_view text) {
  for (const PoseOrigin origin : {PoseOrigin::file, PoseOrigin::com})
    if (text == name(origin)) return origin;
  return std::nullopt;
}

bool is_frame_name(std::string_view text) {
  return !text.empty() && text.size() <= longest_frame && text.front() != '/' &&
         std::all_of(text.begin(), text.end(), is_of_frame);
}

std::string poses_text(const ShownPlacement& of, PoseFormat format, const PoseOptions& options) {
  const std::vector<PlacedRobot> robots = robots_from(of.placement, options.origin);
  const bool carried = of.placement.loads.has_value(), sized = of.placement.stands != nullptr;
  switch (format) {
    case PoseFormat::csv:
      return as_csv(robots, carried, of.shown.units);
    case PoseFormat::json:
      return as_json(robots, carried, of.shown.units, options);
    case PoseFormat::yaml:
      return as_yaml(robots, carried, sized, of.shown.units, options);
  }
  return {};
}

}  // namespace evenlift
