#include "output/svg/svg_stands.h"

#include <algorithm>

#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "output/svg/svg_bodies.h"

namespace evenlift::svg {

std::vector<Stand> find_stands(const Placement& placement, const std::vector<PlacedRobot>& sized,
                               const std::vector<LoadRange>& loads, const Paper& paper,
                               double apart) {
  std::vector<Stand> stands;
  std::size_t added = 0;
  const auto add = [&](const LiftingPoint& point, std::size_t team) {
    const std::size_t robot = added;
    const LoadRange load = loads.empty() ? LoadRange{} : loads[robot];
    const std::string number = std::to_string(robot + 1);
    const Vec2 at = paper(point.position);
    std::optional<Box> body;
    if (!sized.empty()) body = body_box(sized[added], placement.stands->robot(), paper);
    ++added;
    const auto taken = std::find_if(stands.begin(), stands.end(), [&](const Stand& stand) {
      return length(stand.at - at) < apart && stand.beneath == (point.edge == beneath);
    });
    if (taken == stands.end()) {
      stands.push_back({at, number, team, {load}, {robot}, body, point.edge == beneath});
    } else {
      taken->numbers += "·" + number;
      taken->team = 0;
      taken->loads.push_back(load);
      taken->robots.push_back(robot);
    }
  };
  const bool paired = !is_one_team(placement.settings.method);
  for (std::size_t i = 0; i < placement.teams.size(); ++i)
    for (const Robot& robot : placement.teams[i].robots) add(robot.point, paired ? i + 1 : 0);
  for (Stand& stand : stands)
    if (stand.loads.size() > 3) stand.numbers = "×" + std::to_string(stand.loads.size());
  return stands;
}

std::string load_text(const Stand& stand, double largest, const Units& units) {
  std::vector<std::string> texts;
  LoadRange sum;
  for (const LoadRange& load : stand.loads) {
    texts.push_back(amounts(load, largest));
    sum.least += load.least;
    sum.greatest += load.greatest;
  }
  const std::string& first = texts.front();
  if (texts.size() == 1) return with_weight_unit(first, units);
  if (std::all_of(texts.begin(), texts.end(), [&](const std::string& t) { return t == first; }))
    return std::to_string(texts.size()) + " × " + with_weight_unit(first, units);
  if (texts.size() == 2) return first + " + " + with_weight_unit(texts.back(), units);
  return "Σ " + load_in_words(sum, largest, units);
}

}  // namespace evenlift::svg
