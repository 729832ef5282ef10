#include <algorithm>
#include <cmath>
#include <string>

#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "state/method.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// Below the first step, a length is 0.
double stepped_length(const AppState& state, double length, int by) {
  const double first = first_length(size_of_object(state));
  if (by > 0) return length < first ? first : stepped(length, by);
  const double lower = length > 0 ? stepped(length, by) : 0;
  return lower < first ? 0 : lower;
}

void push(const Ui& ui, Setting setting, const Document& changed) {
  if (row_of(setting).changes == Changes::shown)
    ui.push(SetShown{changed.shown});
  else
    ui.push(SetSettings{changed.settings});
}

}  // namespace

double size_of_object(const AppState& state) {
  return state.derived().placement ? state.derived().placement->polygon().diagonal() : 100;
}

double first_length(double size_of_object) {
  return std::pow(10.0, std::floor(std::log10(size_of_object / 50)));
}

bool draw_optional(const Ui& ui, const OptionalRow& row) {
  const SettingRow& setting = row_of(row.setting);
  const std::string id(setting.name);
  Document changed{{}, {}, settings(ui.state), shown(ui.state)};
  const std::optional<double> value = read_number(text_of(row.setting, changed));
  const float width = labelled(ui, row.label, row.about), clear = ui.control();
  if (!value) {
    text_field(ui, id.c_str(), row.spoken.c_str(), id.c_str(), row.without, width);
    return false;
  }
  const Units& units = shown(ui.state).units;
  const int by = stepper(
      ui, id.c_str(),
      setting.is_length ? with_length_unit(plain(*value), units) : given_weight(*value, units),
      width - clear - 4,
      {.can_lower = *value > 1e-3,
       .can_raise = *value < 1e9,
       .label = row.spoken.c_str(),
       .setting = id.c_str(),
       .exact = shortest(*value)});
  ImGui::SameLine(0, 4);
  const bool unsets = icon_button(ui, row.unset_id, Icon::close, true, row.unset, clear);
  if (unsets || by != 0) {
    read_setting(row.setting,
                 unsets ? std::string(setting.range.unset) : shortest(stepped(*value, by)),
                 changed);
    push(ui, row.setting, changed);
  }
  return true;
}

void draw_length(const Ui& ui, const LengthRow& row) {
  Document changed{{}, {}, settings(ui.state), shown(ui.state)};
  const std::optional<double> length = read_number(text_of(row.setting, changed));
  const std::string setting(name(row.setting)),
      value = length ? with_length_unit(plain(*length), shown(ui.state).units) : "default";
  std::string id = setting;
  std::replace(id.begin(), id.end(), '_', ' ');
  const bool resets = row.member && length;
  const float width = labelled(ui, row.label, row.about), reset = resets ? ui.control() : 0;
  const int by = stepper(ui, id.c_str(), value, width - reset,
                         {.can_lower = length.value_or(1) > 0,
                          .can_raise = length.value_or(0) < max_length,
                          .label = row.spoken,
                          .setting = setting.c_str()});
  if (resets) {
    ImGui::SameLine(0, 0);
    if (icon_button(ui, ("usual " + id).c_str(), Icon::close, true, row.usual, reset)) {
      (changed.settings.*row.member).reset();
      return push(ui, row.setting, changed);
    }
  }
  if (by == 0) return;
  read_setting(row.setting, shortest(stepped_length(ui.state, length.value_or(0), by)), changed);
  push(ui, row.setting, changed);
}

// --- The robots' size and the no-go edges, behind a button that opens them.

namespace {

constexpr LengthRow rows[] = {
    {Setting::robot_reach, "Reach",
     "Length of the arm, from the body's rim to the contact with the object",
     "Reach of a robot's arm"},
    {Setting::robot_depth, "Hand's depth", "How far the hand reaches under the object to lift it",
     "Depth of a robot's hand"},
    {Setting::robot_width, "Hand's width",
     "Along the edge; the hand must not project past a corner", "Width of a robot's hand"},
    {Setting::robot_gap, "Gap", "Free distance between two robots", "Gap between two robots"},
};

// The slider ends at a tenth of the object's size: larger robots rarely fit, but can be typed.
void draw_radius(const Ui& ui) {
  Settings changed = settings(ui.state);
  const double radius = changed.robot.radius, size = size_of_object(ui.state),
               coarse = first_length(size), most = std::floor(size / 10 / coarse) * coarse;
  const Units& units = shown(ui.state).units;
  const float width = labelled(ui, "Radius", "Radius of the robot's round body"),
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

// "3,5:0.25-0.75", or, where the comma is the decimal mark, "3; 5:0,25-0,75".
std::string edges_as_read(const std::vector<EdgePart>& no_go) {
  const std::string text = no_go_text(no_go), mark = as_read(".");
  std::string read;
  for (const char c : text)
    read += c == '.' ? mark : c == ',' && mark == "," ? "; " : std::string(1, c);
  return read;
}

// No-go edges, typed or painted.
void draw_marks_row(const Ui& ui) {
  const float width = labelled(
      ui, "No-go edges",
      "Edges, or parts of them, that robots must not touch, such as 3,5:0.25-0.75; or none");
  text_field(ui, "no go", "No-go edges", "no_go", edges_as_read(settings(ui.state).no_go), width);
  const bool marks = ui.state.view.tool == Tool::mark;
  if (flat_button(ui, "mark edges", marks ? "Finish marking" : "Mark no-go parts",
                  ImGui::GetContentRegionAvail().x))
    action(ActionId::mark).run(ui.state, ui.commands);
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

void draw_size_rows(const Ui& ui) {
  const AppState& state = ui.state;
  draw_radius(ui);
  for (const LengthRow& row : rows) draw_length(ui, row);
  draw_marks_row(ui);
  if (state.derived().placement && state.derived().placement->stands && !state.derived().refusal)
    text_block(Face::label, ui.theme.second_text, left_in_words(*state.derived().placement));
}

}  // namespace

void draw_robot_size(const Ui& ui) {
  // The button stays even if the method does not use it, so that nothing below moves.
  const bool useful = takes_sizes(settings(ui.state).method);
  const bool open = useful && ui.state.view.robot_open;
  const float head = ImGui::GetCursorPosY();
  const bool kept =
      !useful && (ui.state.work.aside.robot.value_or(RobotSize{}) != RobotSize{} ||
                  !ui.state.work.aside.no_go.value_or(std::vector<EdgePart>{}).empty());
  const char* label = kept   ? "Robots are points; their size is kept"
                      : open ? "Hide the robots' size"
                             : "Robots' size and no-go edges";
  if (flat_button(ui, "robot size", label, ImGui::GetContentRegionAvail().x, useful))
    ui.push(SetSectionOpen{&View::robot_open, !open});
  if (open) draw_size_rows(ui);
  show_opened(ui, "robot size is open", open, head);
}

// --- A robot's capacity, and the number of robots needed.

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

// --- The conditions under which the object is carried, behind a button that opens them.

namespace {

constexpr LengthRow height{
    Setting::com_height, "Height of C",
    "Height of the centre of mass, of the object with its cargo, above the plane in "
    "which the robots lift",
    "Height of the centre of mass"};
constexpr LengthRow uneven{Setting::uneven, "Uneven by",
                           "How much the ground, or a robot's height, is off at most",
                           "Unevenness of the ground"};

// With the digits of the ratio: 0.07 is 7%, although 100 times 0.07 is not 7.
std::string exact_percentage(double ratio) {
  constexpr double digits = 1e13;
  const double percentage = std::round(100 * ratio * digits) / digits;
  return shortest(percentage / 100 == ratio ? percentage : 100 * ratio) + "%";
}

// A ratio with a fixed step.
struct RatioRow {
  double Carrying::*member;
  Setting setting;
  double step;
  const char *id, *label, *about, *spoken;
  std::string (*text)(double value);
  std::string (*exact)(double value);
};
const RatioRow ratios[] = {
    {&Carrying::slope, Setting::slope, 0.01, "slope", "Slope",
     "Greatest slope, in any direction, of the plane in which the robots lift: the ground's, "
     "unless they level the object; type 8 or 8%, or 4.6°",
     "Greatest slope", [](double value) { return slope_in_words(value); },
     [](double value) { return exact_percentage(value); }},
    {&Carrying::acceleration, Setting::acceleration, 0.05, "acceleration", "Braked at",
     "Greatest acceleration along the ground in any direction, in g, or with its unit: 2 m/s2",
     "Greatest acceleration, in g", [](double value) { return significant(value, 3) + "\u00A0g"; },
     [](double value) { return shortest(value); }},
    {&Carrying::dynamic, Setting::dynamic, 0.05, "dynamic", "Dynamic factor",
     "Factor on the greatest loads before they meet a capacity: a crane's lift 1.1 to 1.3",
     "Dynamic factor", [](double value) { return plain(value); },
     [](double value) { return shortest(value); }},
    {&Carrying::weight_doubt, Setting::weight_doubt, 0.01, "weight off", "Weight off by",
     "How far the weight may be off, either way, as a part of it", "How far the weight may be off",
     [](double value) { return slope_in_words(value); },
     [](double value) { return exact_percentage(value); }},
};

void draw_ratio(const Ui& ui, const RatioRow& row) {
  Carrying changed = shown(ui.state).carrying;
  double& value = changed.*row.member;
  const SettingRange& range = row_of(row.setting).range;
  const std::string setting(name(row.setting));
  const int by = stepper(ui, row.id, row.text(value), labelled(ui, row.label, row.about),
                         {.can_lower = value > range.least,
                          .can_raise = value < range.most,
                          .label = row.spoken,
                          .setting = setting.c_str(),
                          .exact = row.exact(value)});
  if (by == 0) return;
  const double steps = std::round(1 / row.step);
  value = std::clamp((std::round(value * steps) + by) / steps, range.least, range.most);
  ui.push(showing(ui.state, &Shown::carrying, changed));
}

const OptionalRow give{Setting::give,
                       "Robots give way",
                       "By how much a robot gives way under its mean load: its springs, tyres or "
                       "rubber. Without it, uneven ground can do its worst",
                       "Length by which a robot gives way",
                       "not known",
                       "no give",
                       "Not known"};
const OptionalRow extra{Setting::extra,
                        "Another load",
                        "A further weight that may stand on the object, such as a person or a box",
                        "Weight of another load",
                        "none",
                        "no extra",
                        "None"};

// Shows or hides an overlay that explains these numbers.
void draw_show(const Ui& ui, bool Overlays::*overlay, ActionId toggle, const char* show,
               const char* hide) {
  const bool on = shown(ui.state).overlays.*overlay;
  if (flat_button(ui, show, on ? hide : show, ImGui::GetContentRegionAvail().x))
    action(toggle).run(ui.state, ui.commands);
}

void draw_carrying_rows(const Ui& ui) {
  const Carrying& now = shown(ui.state).carrying;
  draw_length(ui, height);
  for (const RatioRow& row : ratios) draw_ratio(ui, row);
  draw_length(ui, uneven);
  draw_optional(ui, give);
  draw_optional(ui, extra);
  if (flat_button(ui, "cases", "All cases …", ImGui::GetContentRegionAvail().x))
    ui.push(OpenDialog{Dialog::cases});
  if (ImGui::IsItemHovered())
    tip(ui, "The loads in each case: each condition alone, all of them, and each failure");
  const std::string words = carrying_words(ui.state);
  if (!words.empty()) text_block(Face::label, ui.theme.second_text, words);
  if (now.has_height())
    draw_show(ui, &Overlays::tilt, ActionId::toggle_tilt, "Show the slopes", "Hide the slopes");
  if (now.extra)
    draw_show(ui, &Overlays::load, ActionId::toggle_load, "Show where it may stand",
              "Hide where it may stand");
}

}  // namespace

void draw_carrying_button(const Ui& ui, float width) {
  const bool open = ui.state.view.carrying_open;
  if (flat_button(ui, "carrying", open ? "Hide carrying" : "Carrying", width))
    ui.push(SetSectionOpen{&View::carrying_open, !open});
  if (ImGui::IsItemHovered()) tip(ui, "Slopes, starts, uneven ground and another load");
}

void draw_carrying(const Ui& ui, float head) {
  const bool open = ui.state.view.carrying_open;
  if (open) draw_carrying_rows(ui);
  show_opened(ui, "carrying is open", open, head);
}

}  // namespace evenlift::view
