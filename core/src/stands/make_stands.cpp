#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/stands.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

// Names the whole size, since the radius need not be the reason.
InputError no_room(const Settings& settings) {
  const RobotSize& robot = settings.robot;
  const bool arm = robot.reach > 0, body = robot.radius > 0 || arm,
             hand = robot.depth > 0 || robot.width > 0;
  if (!body && !hand)
    return setting_error(Setting::no_go, "the no-go edges leave no edge for the robots");
  constexpr const char* messages[2][2] = {
      {"no edge has room for a robot of radius {radius}",
       "no edge has room for a robot of radius {radius}, with a hand of depth {depth} and width "
       "{width}"},
      {"no edge has room for a robot of radius {radius} and reach {reach}",
       "no edge has room for a robot of radius {radius} and reach {reach}, with a hand of depth "
       "{depth} and width {width}"}};
  std::vector<std::string> sizes;
  if (body) sizes.push_back(shortest(robot.radius));
  if (arm) sizes.push_back(shortest(robot.reach));
  if (hand) sizes.insert(sizes.end(), {shortest(robot.depth), shortest(robot.width)});
  const char* message = body ? messages[arm ? 1 : 0][hand ? 1 : 0]
                             : "no edge has room for a hand of depth {depth} and width {width}";
  return setting_error(Setting::robot, say_written(message, sizes.data(), sizes.size()));
}

}  // namespace

bool stands_anywhere(const Settings& settings) {
  const bool is_searched =
      selects_candidates(settings.method) || settings.method == Method::balanced;
  return settings.robot == RobotSize{} && settings.no_go.empty() &&
         !(is_searched && settings.accuracy.value_or(0) > 0);
}

Result<std::shared_ptr<const Stands>> make_stands(const PolygonWithHoles& object,
                                                  const Vec2& centre, const Settings& settings) {
  if (stands_anywhere(settings)) return std::shared_ptr<const Stands>();
  for (const EdgePart& part : settings.no_go)
    if (part.edge >= object.outline().size())
      return setting_error(Setting::no_go, say("there is no edge {edge}; the polygon has {edges}",
                                               {part.edge + 1, object.outline().size()}));
  // Given supports stay where they are, however accurate they are.
  StandReserve reserve;
  const double accuracy = settings.accuracy.value_or(0);
  if (accuracy > 0 && settings.method != Method::given)
    reserve = {accuracy,
               std::max(accuracy, settings.clear.value_or(
                                      usual_clear * farthest_vertex(object.outline(), centre)))};
  // Then places that are typed with a few digits fit again.
  if (settings.robot.has_body()) {
    reserve.part = 1e-3;
    reserve.length = usual_snap * object.outline().diameter();
  }
  auto stands = std::make_shared<const Stands>(object, settings.robot, settings.no_go, reserve);
  if (!stands->any() && settings.method != Method::given) return no_room(settings);
  if (!stands->any_usable() && settings.method != Method::given)
    return setting_error(
        Setting::accuracy,
        say("no edge has room for robots that may be off by {accuracy}", {shortest(accuracy)}));
  return std::shared_ptr<const Stands>(std::move(stands));
}

}  // namespace evenlift
