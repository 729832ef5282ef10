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
  return settings.robot == RobotSize{} && settings.no_go.empty();
}

Result<std::shared_ptr<const Stands>> make_stands(const PolygonWithHoles& object,
                                                  const Settings& settings) {
  if (stands_anywhere(settings)) return std::shared_ptr<const Stands>();
  for (const EdgePart& part : settings.no_go)
    if (part.edge >= object.outline().size())
      return setting_error(Setting::no_go, say("there is no edge {edge}; the polygon has {edges}",
                                               {part.edge + 1, object.outline().size()}));
  auto stands = std::make_shared<const Stands>(object, settings.robot, settings.no_go);
  if (!stands->any() && settings.method != Method::given) return no_room(settings);
  return std::shared_ptr<const Stands>(std::move(stands));
}

}  // namespace evenlift
