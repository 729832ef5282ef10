// The second method, and the results of both in numbers.
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "evenlift/output/quantities.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "picture/scene.h"
#include "ui/controls.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/methods.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// The worse of two values recedes.
void draw_row(const Ui& ui, const Compared& row, Face face,
              const std::array<std::string, 2>& methods) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(low.x, low.y + 2), ui.theme.second_text, row.label);
  for (const std::size_t i : {0u, 1u}) {
    const std::string& text = row.values[i];
    const float right = low.x + width - (i == 0 ? 84.0f : 0.0f);
    const bool recedes = row.label.empty() || row.better.value_or(i) != i;
    const Colour colour = recedes ? ui.theme.second_text : ui.theme.text;
    draw_text(list, face, ImVec2(right - text_size(face, text).x, low.y + 2), colour, text);
  }
  ImGui::Dummy(ImVec2(width, 21));
  if (!row.label.empty())
    list_text(row.label, say("{method} {value}, {second} {other}",
                             {methods[0], row.values[0], methods[1], row.values[1]}));
}

}  // namespace

void draw_compare(const Ui& ui) {
  const float width =
      labelled(ui, "Compare with", "Shows the same object under a second method beside the first");
  std::vector<Choice> choices = {{"Nothing"}};
  std::vector<Method> of_choice;
  std::size_t current = 0;
  for (const MethodWords& m : methods) {
    if (m.method == settings(ui.state).method) continue;
    if (ui.state.work.second_method == m.method) current = choices.size();
    choices.push_back({m.label, m.about});
    of_choice.push_back(m.method);
  }
  choices.push_back({"Optimum …", "the best for this number of teams"});
  choices.push_back({"All methods …", "in charts, by the number of teams"});
  const auto chosen = dropdown(ui, "compared", "Compare with", choices, current, width);
  if (!chosen) return;
  if (*chosen + 1 == choices.size())
    ui.push(OpenDialog{Dialog::curves});
  else if (*chosen + 2 == choices.size())
    ui.push(OpenDialog{Dialog::optimum});
  else
    ui.push(Compare{*chosen == 0 ? std::nullopt : std::optional<Method>(of_choice[*chosen - 1])});
}

void draw_comparison(const Ui& ui) {
  if (!ui.state.derived().placement) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const bool fails = failing(ui.state) != nullptr;
  const std::string first = words_of(ui.state.derived().placement->settings.method).label;
  const std::array<std::string, 2> both = {fails ? say("{method}, one fails", {first}) : first,
                                           words_of(*ui.state.work.second_method).label};
  draw_row(ui, {"", both, {}}, Face::label, both);
  for (const Compared& row : compared_in_words(reported(ui.state), reported(ui.state, true)))
    draw_row(ui, row, Face::strong_label, both);
  ImGui::PopStyleVar();
}

// --- The overlays' switches, also the legend of the picture.

namespace {

struct Overlay {
  bool Overlays::*shown;
  Swatch swatch;
  const char* label;
  const char* about;
  const char* about_none =
      nullptr;                 // if it can be empty: a held object has no points to turn about
  const char* name = nullptr;  // of its chip for scripts, if not the label
};
constexpr Overlay overlays[] = {
    {&Overlays::lifting_base, Swatch::hull, "Base",
     "Lifting base H, the convex hull of the robots: no press down there tips it, if robots push back and none is overloaded (H)"},
    {&Overlays::chords, Swatch::chord, "Chords",
     "The two robots of a team and the line between them (C)"},
    {&Overlays::candidates, Swatch::candidate, "Candidates", "All chords that were compared (A)"},
    {&Overlays::clockwise, Swatch::clockwise, "Clockwise turns",
     "Points about which it can still turn clockwise, robots on corners not counted (R)",
     "Points about which it can still turn clockwise, robots on corners not counted: none here (R)",
     "Clockwise"},
    {&Overlays::counterclockwise, Swatch::counterclockwise, "Counter-clockwise turns",
     "Points about which it can still turn counter-clockwise, robots on corners not counted (L)",
     "Points about which it can still turn counter-clockwise, robots on corners not counted: none here (L)",
     "Counter-clockwise"},
    {&Overlays::tipping, Swatch::tipping, "Tipping",
     "The press down that tips the object, at each point (F)"},
    {&Overlays::halo, Swatch::halo, "Tipping distance",
     "How far the centre of mass may be off before the object tips, if robots push back and none is overloaded (Shift+C)"},
    {&Overlays::tilt, Swatch::tilt, "Tilt",
     "On which slopes it tips in each direction: where a circle leaves the lifting base (Shift+S)"},
    {&Overlays::load, Swatch::load, "Load",
     "Where the extra load may stand: in the striped part it lifts a robot off or overloads one (Shift+L)"},
};

// Null if the method can have the overlay.
const char* why_none(Method method, const Overlay& overlay) {
  const bool weighs = !is_one_team(method) || overlay.shown != &Overlays::candidates;
  return weighs ? nullptr : "These robots are not chosen among candidate chords";
}

// Two overlays need a setting of *Carrying*.
bool is_offered(const Shown& shown, const Overlay& overlay) {
  if (overlay.shown == &Overlays::tilt) return shown.carrying.has_height();
  if (overlay.shown == &Overlays::load) return shown.carrying.extra.has_value();
  return true;
}

// Whether it shows lines to C, not chords.
bool shows_lines(Method method, const Overlay& overlay) {
  return overlay.shown == &Overlays::chords && is_one_team(method);
}

const char* label_of(Method method, const Overlay& overlay) {
  return shows_lines(method, overlay) ? "Lines" : overlay.label;
}

bool is_empty(const Placement& placement, const Overlay& overlay) {
  const Closure& closure = placement.closure;
  return (overlay.shown == &Overlays::clockwise && !closure.clockwise.exists) ||
         (overlay.shown == &Overlays::counterclockwise && !closure.counterclockwise.exists);
}

const char* about(const AppState& state, const Overlay& overlay) {
  if (shows_lines(settings(state).method, overlay))
    return "Balanced robots have no chords: a line joins each with the centre of mass (C)";
  const bool empty = state.derived().placement && is_empty(shown_placement(state), overlay);
  return empty ? overlay.about_none : overlay.about;
}

}  // namespace

void draw_heat_key(const Ui& ui) {
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int bands = 7;
  const float each = width / bands, top = low.y + 20;
  float written = low.x - 4;  // end of the last number
  draw_text(list, Face::label, ImVec2(low.x, low.y), ui.theme.second_text,
            say("Force that tips it, in {unit}", {weight_unit(ui.state)}));
  for (int i = 0; i < bands; ++i) {
    const float left = low.x + each * static_cast<float>(i);
    list.AddRectFilled(ImVec2(left, top), ImVec2(left + each - 1, top + 10),
                       ui.theme.heat[i].packed(), 2);
    const bool last = i + 1 == bands;
    const double force = last ? 0
                              : heat_levels[std::min<std::size_t>(static_cast<std::size_t>(i),
                                                                  std::size(heat_levels) - 1)] *
                                    settings(ui.state).weight;
    const std::string text = last ? "none" : plain(force);
    const ImVec2 size = text_size(Face::tiny, text);
    // Each number is at the border of two bands; the last band has a word.
    const float x = last ? left + (each - size.x) / 2 : left + each - size.x / 2;
    if (i + 2 == bands || x < written + 4) continue;
    written = x + size.x;
    draw_text(list, Face::tiny, ImVec2(x, top + 13), ui.theme.second_text, text);
  }
  ImGui::Dummy(ImVec2(width, 50));
}

void draw_overlays(const Ui& ui) {
  const float left = ImGui::GetCursorScreenPos().x, width = ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const Overlay& overlay : overlays) {
    if (!is_offered(shown(ui.state), overlay)) continue;
    const bool on = shown(ui.state).overlays.*overlay.shown;
    const char* label = label_of(settings(ui.state).method, overlay);
    const float wide = text_size(Face::label, label).x + 42;
    if (!first && ImGui::GetItemRectMax().x + 6 + wide <= left + width) ImGui::SameLine(0, 6);
    first = false;
    const char* why_not = why_none(settings(ui.state).method, overlay);
    const char* name = overlay.name ? overlay.name : overlay.label;
    if (chip(ui, name, overlay.swatch, label, on && !why_not, !why_not)) {
      Shown changed = shown(ui.state);
      changed.overlays.*overlay.shown = !on;
      ui.push(SetShown{changed});
    }
    if (ImGui::IsItemHovered()) tip(ui, why_not ? why_not : about(ui.state, overlay));
  }
  if (shown(ui.state).overlays.tipping) draw_heat_key(ui);
}

// --- Seldom-used settings, behind a button that opens them.

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

constexpr LengthRow snap_row{Setting::snap,
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
  if (settings(ui.state).method == Method::given) draw_length(ui, snap_row);
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
