// The rows about robots: how many, how large, how strong, where they may stand.
#include <algorithm>
#include <cmath>
#include <string>

#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "panels/drawers.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "state/method.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {

// --- The load ratio, the seed, the goal, and what it asks for.

namespace {

constexpr Choice goals[] = {{"Cover", "most of the object above the lifting base"},
                            {"Hold", "a hold with the minimum margin first"}};
constexpr Choice positions[] = {{"Best", "one place for two edges"},
                                {"Anywhere in the range", "wherever the minimum ratio is met"}};

// Null if the ratio has an effect.
const char* why_no_ratio(Method method) {
  if (method == Method::given) return "Robots placed by hand are not chosen by their load ratio";
  if (method == Method::balanced)
    return "Balanced robots can all carry the same load: the ratio is always 1";
  return selects_candidates(method)
             ? nullptr
             : "This method places teams by direction, whatever their load ratio";
}

}  // namespace

void draw_min_ratio(const Ui& ui, const DrawerRow& row) {
  Settings changed = settings(ui.state);
  const char *why_not = why_no_ratio(changed.method), *about = why_not ? why_not : row.about;
  const float width = labelled(ui, row.label, about), number = 44;
  const SliderResult moved = slider(ui, "ratio", "Minimum load ratio, as a slider",
                                    changed.min_ratio, 0, 1, 0.01, width - number, !why_not);
  if (ImGui::IsItemHovered()) tip(ui, about);
  ImGui::SameLine(0, 0);
  number_field(ui, "min ratio", "Minimum load ratio", "min_ratio", fixed(moved.value, 2), number,
               why_not ? ui.theme.quiet : ui.theme.text, shortest(moved.value));
  if (moved.changed) {
    changed.min_ratio = moved.value;
    ui.push(SetSettings{changed, true});
  }
  if (moved.released) ui.push(EndEdit{});
}

std::string told_min_ratio(const AppState& state, const DrawerRow& row) {
  return why_no_ratio(settings(state).method) ? std::string() : told_setting(state, row);
}

void draw_seed(const Ui& ui, const DrawerRow& row) {
  Settings changed = settings(ui.state);
  const float width = labelled(ui, row.label, row.about);
  const int by = stepper(ui, "seed", std::to_string(changed.seed), width,
                         {.can_lower = changed.seed > 0,
                          .can_raise = changed.seed < UINT64_MAX,
                          .label = row.label,
                          .setting = "seed"});
  if (by == 0) return;
  changed.seed += by > 0 ? 1u : UINT64_MAX;  // unsigned: adds -1
  ui.push(SetSettings{changed});
}

void draw_goal(const Ui& ui, const DrawerRow& row) {
  Settings changed = settings(ui.state);
  const Goal now = goal_of(changed);
  const float width = labelled(ui, row.label,
                               changed.method == Method::balanced
                                   ? "Which comes first when sets of robots are compared"
                                   : "Whether teams are swapped until they hold the object");
  const auto chosen = dropdown(ui, "goals", "Goal", goals, static_cast<std::size_t>(now), width);
  if (chosen && *chosen != static_cast<std::size_t>(now)) {
    changed.goal.reset();  // the default goal need not be kept
    const auto wanted = static_cast<Goal>(*chosen);
    if (goal_of(changed) != wanted) changed.goal = wanted;
    ui.push(SetSettings{changed});
  }
  if (now != Goal::hold) return;
  const float beside =
      labelled(ui, "Min. margin", "A hold with at least this margin meets the goal");
  const int by = stepper(ui, "min margin", plain(changed.min_margin), beside,
                         {.can_lower = changed.min_margin > 0,
                          .can_raise = changed.min_margin < 1,
                          .label = "Minimum margin",
                          .setting = "min_margin"});
  if (by == 0) return;
  changed.min_margin = std::clamp(std::round(changed.min_margin * 100 + by) / 100, 0.0, 1.0);
  ui.push(SetSettings{changed});
}

std::string told_goal(const AppState& state, const DrawerRow&) {
  const Settings& now = settings(state);
  std::string told =
      now.goal ? say(goals[static_cast<std::size_t>(*now.goal)].label) : std::string();
  if (goal_of(now) == Goal::hold && now.min_margin != Settings().min_margin)
    told += (told.empty() ? "" : " · ") +
            say("{setting} {value}", {"Min. margin", plain(now.min_margin)});
  return told;
}

void draw_survive(const Ui& ui, const DrawerRow& row) {
  Settings changed = settings(ui.state);
  const std::uint32_t most = std::min(most_survived, (std::max(changed.robots, 3u) - 3) / 2);
  const float width = labelled(ui, row.label, row.about);
  const int by = stepper(ui, "survive", count_of(changed.survive, "failure", "failures"), width,
                         {.can_lower = changed.survive > 0,
                          .can_raise = changed.survive < most,
                          .label = "Failures that should leave the object steady",
                          .setting = "survive"});
  if (by == 0) return;
  changed.survive = by > 0 ? changed.survive + 1 : changed.survive - 1;
  ui.push(SetSettings{changed});
}

void draw_positions(const Ui& ui, const DrawerRow& row) {
  Settings changed = settings(ui.state);
  const float width = labelled(ui, row.label, row.about);
  const auto now = static_cast<std::size_t>(changed.positions);
  const auto chosen = dropdown(ui, "positions", "Positions", positions, now, width);
  if (!chosen || *chosen == now) return;
  changed.positions = static_cast<Positions>(*chosen);
  ui.push(SetSettings{changed});
}

std::string told_positions(const AppState& state, const DrawerRow&) {
  const Positions now = settings(state).positions;
  return now == Positions{} ? std::string() : say(positions[static_cast<std::size_t>(now)].label);
}

// --- A robot's capacity, and the number of robots needed.

namespace {

// The overloaded robots and the number needed. Up to five lines have the same height, so that
// little below moves.
void draw_need(const Ui& ui) {
  const Derived& facts = ui.state.derived();
  const std::optional<CapacityPlan>& plan = facts.report.plan;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // The verdict names overloaded robots, unless one has failed.
  text_block(Face::label, ui.theme.second_text,
             need_in_words(ui.state, failing(ui.state) || !is_overloaded(ui.state)));
  const float five_lines = at.y + 5 * line_height(Face::label) + 6;
  ImGui::SetCursorScreenPos(ImVec2(at.x, std::max(five_lines, ImGui::GetCursorScreenPos().y)));
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

void draw_capacity(const Ui& ui, const DrawerRow& row) {
  DrawerRow named = row;
  const std::string spoken = say("Capacity of a robot, in {unit}", {weight_unit(ui.state)});
  named.spoken = spoken.c_str();
  draw_optional(ui, named);
  if (shown(ui.state).capacity) draw_need(ui);
}

// --- The robots' size and the no-go edges.

// The slider ends at a tenth of the object's size: larger robots rarely fit, but can be typed.
void draw_radius(const Ui& ui, const DrawerRow& row) {
  Settings changed = settings(ui.state);
  const double radius = changed.robot.radius, size = size_of_object(ui.state),
               coarse = first_length(size), most = std::floor(size / 10 / coarse) * coarse;
  const Units& units = shown(ui.state).units;
  const float width = labelled(ui, row.label, row.about),
              number = units.length == LengthUnit::none ? 60.0f : 84.0f;
  const SliderResult moved = slider(ui, "radius", "Radius of a robot, as a slider",
                                    std::min(radius, most), 0, most, coarse / 10, width - number);
  ImGui::SameLine(0, 0);
  number_field(ui, "robot radius", "Radius of a robot", "robot_radius",
               with_length_unit(plain(moved.changed ? moved.value : radius), units), number,
               ui.theme.text);
  if (moved.changed) {
    changed.robot.radius = moved.value;
    ui.push(SetSettings{changed, true});
  }
  if (moved.released) ui.push(EndEdit{});
}

namespace {

// "3,5:0.25-0.75", or, where the comma is the decimal mark, "3; 5:0,25-0,75".
std::string edges_as_read(const std::vector<EdgePart>& no_go) {
  const std::string text = no_go_text(no_go), mark = as_read(".");
  std::string read;
  for (const char c : text)
    read += c == '.' ? mark : c == ',' && mark == "," ? "; " : std::string(1, c);
  return read;
}

std::string left_in_words(const Placement& placement) {
  std::string marked = no_go_in_words(placement.settings.no_go);
  if (!marked.empty()) marked += ' ';
  double all = 0, lost = 0;
  for (std::size_t edge = 0; edge < placement.polygon().size(); ++edge)
    all += length(placement.polygon().edge_end(edge) - placement.polygon().edge_start(edge));
  for (const UnusablePart& part : placement.stands->unusable())
    lost += part.part.to - part.part.from;
  if (lost == 0) return marked + say("The whole boundary can be used.");
  return marked + say("{share} of the boundary can be used. Point at the rest to see why not.",
                      {percentage(std::clamp(1 - lost / all, 0.0, 1.0))});
}

}  // namespace

// No-go edges, typed or painted.
void draw_no_go(const Ui& ui, const DrawerRow& row) {
  const float width = labelled(ui, row.label, row.about);
  text_field(ui, "no go", "No-go edges", "no_go", edges_as_read(settings(ui.state).no_go), width);
  const bool marks = ui.state.view.tool == Tool::mark;
  if (flat_button(ui, "mark edges", marks ? "Finish marking" : "Mark no-go parts",
                  ImGui::GetContentRegionAvail().x))
    action(ActionId::mark).run(ui.state, ui.commands);
}

std::string told_no_go(const AppState& state, const DrawerRow& row) {
  return settings(state).no_go.empty()
             ? std::string()
             : say("{setting} {value}", {row.label, edges_as_read(settings(state).no_go)});
}

void draw_left_of_boundary(const Ui& ui, const DrawerRow&) {
  const Derived& facts = ui.state.derived();
  if (facts.placement && facts.placement->stands && !facts.refusal)
    text_block(Face::label, ui.theme.second_text, left_in_words(*facts.placement));
}

std::string told_sizes_kept(const AppState&, const DrawerRow&) {
  return say("Robots are points; their size is kept");
}

void draw_sizes_kept(const Ui& ui, const DrawerRow& row) {
  draw_remark(ui, told_sizes_kept(ui.state, row), 1);
}

}  // namespace evenlift::view
