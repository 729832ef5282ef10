// Settings that are seldom needed, behind a row that opens them: where teams may stand and what they are for, which loads are
// shown, how well the centre of mass is known, units, and how balanced robots keep apart and what they survive.
#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/dropdown.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr Choice models[] = {{"As planned", "each robot's force is controlled"},
                             {"Springs", "all equally stiff and level"},
                             {"At best", "shared as well as can be"},
                             {"At worst", "unequal heights, or it bends"}};
static_assert(std::size(models) == std::size(all_load_models));

// A text in a block of so many lines, so that nothing below moves when it changes.
void draw_block(const Ui& ui, const std::string& text, std::size_t lines) {
  text_block_of(Face::label, ui.theme.second_text, text, ImGui::GetContentRegionAvail().x, lines);
}

void draw_model(const Ui& ui) {
  const float width =
      labelled(ui, "Loads shown", "What the loads in the drawing and the table presume");
  const auto now = static_cast<std::size_t>(ui.state.load_model);
  const auto chosen = dropdown(ui, "loads", "Loads shown", models, now, width);
  if (chosen && *chosen != now) ui.push(SetLoadModel{static_cast<LoadModel>(*chosen)});
  if (ui.state.load_model != LoadModel::plan) draw_block(ui, model_words(ui.state), 3);
}

// A first step from 0: a round number of about a hundredth of the object.
double first_length(const Ui& ui) {
  const double size = ui.state.placement ? ui.state.placement->polygon.diagonal() : 100;
  return std::pow(10.0, std::floor(std::log10(size / 50)));
}

// A length one step up or down; below its first step it is 0.
double stepped_length(const Ui& ui, double length, int by) {
  const double first = first_length(ui);
  if (by > 0) return length < first ? first : stepped(length, by);
  const double lower = length > 0 ? stepped(length, by) : 0;
  return lower < first ? 0 : lower;
}

void draw_doubt(const Ui& ui) {
  const double radius = settings(ui.state).com_radius;
  const float width =
      labelled(ui, "C known within",
               "The centre of mass lies somewhere within this distance of where it is shown");
  const int by =
      stepper(ui, "com radius", with_length_unit(plain(radius), settings(ui.state).units), width,
              {.can_lower = radius > 0,
               .can_raise = radius < max_coordinate,
               .label = "Distance within which the centre of mass is known",
               .setting = "com_radius"});
  if (by != 0) ui.push(SetComRadius{stepped_length(ui, radius, by)});
  if (radius > 0) draw_block(ui, doubt_words(ui.state), 5);
}

constexpr Choice length_units[] = {{"no unit"}, {"m"}, {"cm"}, {"mm"}, {"in"}};
constexpr Choice weight_units[] = {{"kg"}, {"t"}, {"N"}, {"lb"}};
static_assert(std::size(length_units) == std::size(all_length_units));
static_assert(std::size(weight_units) == std::size(all_weight_units));

void draw_units(const Ui& ui) {
  Units units = settings(ui.state).units;
  const float width = labelled(ui, "Units", "Labels of lengths and weights; no number changes"),
              each = (width - 8) / 2;
  const auto length = dropdown(ui, "length units", "Unit of lengths", length_units,
                               static_cast<std::size_t>(units.length), each);
  ImGui::SameLine(0, 8);
  const auto weight = dropdown(ui, "weight units", "Unit of weights", weight_units,
                               static_cast<std::size_t>(units.weight), each);
  if (length) units.length = static_cast<LengthUnit>(*length);
  if (weight) units.weight = static_cast<WeightUnit>(*weight);
  if (!(units == settings(ui.state).units)) ui.push(SetUnits{units});
}

// A length that has a usual value, and how it is shown.
struct UsualLength {
  std::optional<double> Settings::*member;
  const char *label, *tip, *about, *setting, *reset, *usual;
};

void draw_usual_length(const Ui& ui, const UsualLength& row) {
  Settings changed = settings(ui.state);
  std::optional<double>& length = changed.*row.member;
  const float width = labelled(ui, row.label, row.tip), reset = length ? ui.control() : 0;
  const std::string value = length ? with_length_unit(plain(*length), changed.units) : "usual";
  const int by = stepper(ui, row.setting, value, width - reset,
                         {.can_lower = length.value_or(1) > 0,
                          .can_raise = length.value_or(0) < max_coordinate,
                          .label = row.about,
                          .setting = row.setting});
  if (length) {
    ImGui::SameLine(0, 0);
    if (icon_button(ui, row.reset, Icon::close, true, row.usual, ui.control())) {
      length.reset();
      ui.push(SetSettings{changed});
      return;
    }
  }
  if (by == 0) return;
  length = stepped_length(ui, length.value_or(0), by);
  ui.push(SetSettings{changed});
}

void draw_apart(const Ui& ui) {
  draw_usual_length(
      ui, {&Settings::apart, "Keep apart", "Robots nearer to each other than this are too near",
           "Distance that robots keep apart", "apart", "usual apart",
           "As usual: 12 % of the object's radius"});
}

void draw_clear(const Ui& ui) {
  draw_usual_length(ui, {&Settings::clear, "Clear of corners",
                         "A hold does not rely on robots that are nearer to a corner than this",
                         "Distance from corners that holds keep", "clear", "usual clear",
                         "As usual: 2 % of the object's radius"});
}

void draw_survive(const Ui& ui) {
  Settings changed = settings(ui.state);
  const std::uint32_t most = std::min(most_survived, (std::max(changed.robots, 3u) - 3) / 2);
  const float width = labelled(
      ui, "Survive", "So many robots may fail, whichever they are, and the object stays steady");
  const int by = stepper(ui, "survive", count_of(changed.survive, "failure", "failures"), width,
                         {.can_lower = changed.survive > 0,
                          .can_raise = changed.survive < most,
                          .label = "Failures that should leave the object steady",
                          .setting = "survive"});
  if (by == 0) return;
  changed.survive = by > 0 ? changed.survive + 1 : changed.survive - 1;
  ui.push(SetSettings{changed});
}

// Whether a team stands at the best place of two edges or anywhere in their range.
void draw_positions(const Ui& ui) {
  Settings changed = settings(ui.state);
  constexpr Choice positions[] = {{"Best", "one place for two edges, as in the thesis"},
                                  {"Anywhere in the range", "wherever the ratio allows it"}};
  const float width = labelled(ui, "Positions", "Where on two edges a team may stand");
  const auto now = static_cast<std::size_t>(changed.positions);
  const auto chosen = dropdown(ui, "positions", "Positions", positions, now, width);
  if (!chosen || *chosen == now) return;
  changed.positions = static_cast<Positions>(*chosen);
  ui.push(SetSettings{changed});
}

void draw_rows(const Ui& ui) {
  if (selects_candidates(settings(ui.state).method)) {
    draw_positions(ui);
    draw_goal(ui);
  }
  draw_model(ui);
  draw_doubt(ui);
  draw_clear(ui);
  draw_units(ui);
  if (settings(ui.state).method != Method::balanced) return;
  draw_apart(ui);
  draw_survive(ui);
}

}  // namespace

void draw_more(const Ui& ui) {
  const bool open = ui.state.more_open;
  const float head = ImGui::GetCursorPosY();
  if (flat_button(ui, "more settings", open ? "Fewer settings" : "More settings",
                  ImGui::GetContentRegionAvail().x))
    ui.push(SetMoreOpen{!open});
  if (open) draw_rows(ui);
  show_opened("more settings are open", open, head);
}

}  // namespace evenlift::view
