// Seldom-used settings, behind a button that opens them.
#include <algorithm>
#include <string>

#include "evenlift/output/words.h"
#include "panels/length_row.h"
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
                             {"At best", "shared as evenly as possible"},
                             {"At worst", "unequal heights, or it bends"}};
static_assert(std::size(models) == std::size(all_load_models));

// A text in a constant number of lines, so that nothing below moves.
void draw_block(const Ui& ui, const std::string& text, std::size_t lines) {
  text_block_of(Face::label, ui.theme.second_text, text, ImGui::GetContentRegionAvail().x, lines);
}

void draw_model(const Ui& ui) {
  const float width =
      labelled(ui, "Loads shown", "The assumption behind the loads in the drawing and the table");
  const auto now = static_cast<std::size_t>(ui.state.view.load_model);
  const auto chosen = dropdown(ui, "loads", "Loads shown", models, now, width);
  if (chosen && *chosen != now) ui.push(SetLoadModel{static_cast<LoadModel>(*chosen)});
  if (ui.state.view.load_model != LoadModel::plan) draw_block(ui, model_words(ui.state), 3);
}

constexpr LengthRow uncertainty{
    Setting::com_radius, "C uncertainty",
    "The centre of mass may be anywhere within this distance of its shown place",
    "Uncertainty of the centre of mass"};
constexpr LengthRow clear{Setting::clear,
                          "Clear of corners",
                          "A hold does not rely on robots nearer to a corner than this",
                          "Distance of holds from corners",
                          &Settings::clear,
                          "Default: 2 % of the object's radius"};
constexpr LengthRow accuracy_row{
    Setting::accuracy,
    "Accuracy",
    "Robots may be off their places by this: what is found still holds",
    "How far robots may be off their places",
    &Settings::accuracy,
    "Default: exact, but you are told how far robots may be off"};
constexpr LengthRow apart{Setting::apart,
                          "Keep apart",
                          "Robots should be at least this far from each other",
                          "Least distance between robots",
                          &Settings::apart,
                          "Default: 12 % of the object's radius"};

constexpr LengthRow snap{Setting::snap,
                         "Snap",
                         "Robots within this distance of the outline stand at the edge",
                         "Snap distance of robots",
                         &Settings::snap,
                         "Default: 1/10,000 of the object's size"};

constexpr Choice length_units[] = {{"no unit"}, {"m"}, {"cm"}, {"mm"}, {"in"}};
constexpr Choice weight_units[] = {{"kg"}, {"t"}, {"N"}, {"lb"}};
static_assert(std::size(length_units) == std::size(all_length_units));
static_assert(std::size(weight_units) == std::size(all_weight_units));

void draw_units(const Ui& ui) {
  Units units = shown(ui.state).units;
  const float width = labelled(ui, "Units", "Labels of lengths and weights; no number changes"),
              each = (width - 8) / 2;
  const auto length = dropdown(ui, "length units", "Unit of lengths", length_units,
                               static_cast<std::size_t>(units.length), each);
  ImGui::SameLine(0, 8);
  const auto weight = dropdown(ui, "weight units", "Unit of weights", weight_units,
                               static_cast<std::size_t>(units.weight), each);
  if (length) units.length = static_cast<LengthUnit>(*length);
  if (weight) units.weight = static_cast<WeightUnit>(*weight);
  if (units != shown(ui.state).units) ui.push(showing(ui.state, &Shown::units, units));
}

void draw_survive(const Ui& ui) {
  Settings changed = settings(ui.state);
  const std::uint32_t most = std::min(most_survived, (std::max(changed.robots, 3u) - 3) / 2);
  const float width = labelled(
      ui, "Survive", "The object should stay steady if any robots, up to this number, fail");
  const int by = stepper(ui, "survive", count_of(changed.survive, "failure", "failures"), width,
                         {.can_lower = changed.survive > 0,
                          .can_raise = changed.survive < most,
                          .label = "Failures that should leave the object steady",
                          .setting = "survive"});
  if (by == 0) return;
  changed.survive = by > 0 ? changed.survive + 1 : changed.survive - 1;
  ui.push(SetSettings{changed});
}

void draw_positions(const Ui& ui) {
  Settings changed = settings(ui.state);
  constexpr Choice positions[] = {{"Best", "one place for two edges"},
                                  {"Anywhere in the range", "wherever the minimum ratio is met"}};
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
  draw_length(ui, uncertainty);
  if (disturbance_of(shown(ui.state)).any()) draw_block(ui, uncertainty_words(ui.state), 5);
  draw_length(ui, clear);
  draw_length(ui, accuracy_row);
  draw_units(ui);
  if (settings(ui.state).method == Method::given) draw_length(ui, snap);
  if (settings(ui.state).method != Method::balanced) return;
  draw_length(ui, apart);
  draw_survive(ui);
}

}  // namespace

void draw_more_button(const Ui& ui, float width) {
  const bool open = ui.state.view.more_open;
  if (flat_button(ui, "more settings", open ? "Fewer settings" : "More settings", width))
    ui.push(SetSectionOpen{&View::more_open, !open});
}

void draw_more(const Ui& ui, float head) {
  const bool open = ui.state.view.more_open;
  if (open) draw_rows(ui);
  show_opened(ui, "more settings are open", open, head);
}

}  // namespace evenlift::view
