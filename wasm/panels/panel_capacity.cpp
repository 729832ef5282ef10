// A robot's capacity, and the number of robots needed.
#include <algorithm>
#include <cmath>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/length_row.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// 100 goes up to 110, down to 99.
double step_for(double value, int direction) {
  const double below = value * (direction < 0 ? 0.999999 : 1);
  return std::pow(10.0, std::floor(std::log10(std::max(below, 1e-6))) - 1);
}

}  // namespace

double stepped(double value, int by) {
  const double step = step_for(value, by);
  const double steps = std::round(value / step) + by;
  return step >= 1 ? steps * step : steps / std::round(1 / step);
}

namespace {

// The overloaded robots and the number needed, at a constant height so that nothing below moves.
void draw_need(const Ui& ui) {
  const Derived& facts = ui.state.derived();
  const CapacityPlan* plan = facts.plan && !facts.plan_due ? &*facts.plan : nullptr;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // The verdict names overloaded robots, unless one has failed.
  text_block(Face::label, ui.theme.second_text,
             need_in_words(ui.state, failing(ui.state) || !is_overloaded(ui.state)));
  const float five_lines = 5 * line_height(Face::label) + 6;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + five_lines));
  const Settings& now = settings(ui.state);
  Settings changed = now;
  if (plan && now.method == Method::balanced) changed.robots = plan->team_size;
  if (plan && now.method != Method::balanced) changed.teams = plan->teams;
  // Only if one is overloaded: fewer robots may tip or slide. The number needed while one fails is
  // unknown.
  const bool can_take =
      plan && plan->possible && !(changed == now) && !failing(ui.state) && is_overloaded(ui.state);
  const float width = ImGui::GetContentRegionAvail().x;
  if (!can_take) {  // its place stays free
    pressable_row(ui, "use needed", "Use the number needed", width, ui.control(), false);
    return;
  }
  const std::string label =
      say("Use {robots}", {count_of(plan->team_size * plan->teams, "robot", "robots")});
  if (flat_button(ui, "use needed", label.c_str(), width)) ui.push(SetSettings{changed});
}

}  // namespace

void draw_capacity(const Ui& ui) {
  const OptionalRow capacity{
      Setting::capacity,
      "A robot carries",
      "The greatest load of one robot; type it to see the number of robots needed",
      say("Capacity of a robot, in {unit}", {weight_unit(ui.state)}),
      "no limit",
      "any",
      "No limit"};
  if (draw_optional(ui, capacity)) draw_need(ui);
}

}  // namespace evenlift::view
