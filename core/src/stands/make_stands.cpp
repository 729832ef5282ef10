// Makes the stands for given settings.
#include <memory>
#include <string>
#include <utility>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/stands.h"

namespace evenlift {
namespace {

// Names the robot's whole size, since the radius need not be the reason.
InputError no_room(const Settings& settings) {
  const RobotSize& robot = settings.robot;
  const bool hand = robot.depth > 0 || robot.width > 0;
  if (robot.radius == 0 && robot.reach == 0 && !hand)
    return setting_error(Setting::no_go, "the no-go edges leave no edge for the robots");
  std::string text = "no edge has room for a ";
  if (robot.radius > 0 || robot.reach > 0)
    text += "robot of radius " + shortest(robot.radius) +
            (robot.reach > 0 ? " and reach " + shortest(robot.reach) : "") +
            (hand ? ", with a " : "");
  if (hand)
    text += "hand of depth " + shortest(robot.depth) + " and width " + shortest(robot.width);
  return setting_error(Setting::robot, text);
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
      return setting_error(Setting::no_go, "there is no edge " + std::to_string(part.edge + 1) +
                                               "; the polygon has " +
                                               std::to_string(object.outline().size()));
  auto stands = std::make_shared<const Stands>(object, settings.robot, settings.no_go);
  if (!stands->any() && settings.method != Method::given) return no_room(settings);
  return std::shared_ptr<const Stands>(std::move(stands));
}

}  // namespace evenlift
