// The rows about the picture: the overlays, the shown loads, and the second method; and the results of
// both methods in numbers.
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "evenlift/output/quantities.h"
#include "evenlift/wording.h"
#include "panels/drawers.h"
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

void draw_compare(const Ui& ui, const DrawerRow& row) {
  const float width = labelled(ui, row.label, row.about);
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
  const auto chosen = dropdown(ui, "compared", row.label, choices, current, width);
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

// --- The overlays' switches.

namespace {

struct Overlay {
  bool Overlays::*shown;
  Swatch swatch;
  const char* label;
  const char* about;
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
     "Clockwise"},
    {&Overlays::counterclockwise, Swatch::counterclockwise, "Counter-clockwise turns",
     "Points about which it can still turn counter-clockwise, robots on corners not counted (L)",
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

// Whether there can be something to show.
bool is_offered(const AppState& state, const Overlay& overlay) {
  const Shown& now = shown(state);
  if (overlay.shown == &Overlays::tilt) return now.carrying.has_height();
  if (overlay.shown == &Overlays::load) return now.carrying.extra.has_value();
  if (overlay.shown == &Overlays::candidates) return !is_one_team(settings(state).method);
  if (!state.derived().placement) return true;
  const Closure& closure = shown_placement(state).closure;
  if (overlay.shown == &Overlays::clockwise) return closure.clockwise.exists;
  if (overlay.shown == &Overlays::counterclockwise) return closure.counterclockwise.exists;
  return true;
}

// Whether it shows lines to C, not chords.
bool shows_lines(Method method, const Overlay& overlay) {
  return overlay.shown == &Overlays::chords && is_one_team(method);
}

const char* label_of(Method method, const Overlay& overlay) {
  return shows_lines(method, overlay) ? "Lines" : overlay.label;
}

const char* about(const AppState& state, const Overlay& overlay) {
  return shows_lines(settings(state).method, overlay)
             ? "Balanced robots have no chords: a line joins each with the centre of mass (C)"
             : overlay.about;
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

void draw_overlays(const Ui& ui, const DrawerRow&) {
  const float left = ImGui::GetCursorScreenPos().x, width = ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const Overlay& overlay : overlays) {
    if (!is_offered(ui.state, overlay)) continue;
    const bool on = shown(ui.state).overlays.*overlay.shown;
    const char* label = label_of(settings(ui.state).method, overlay);
    const float wide = text_size(Face::label, label).x + 42;
    if (!first && ImGui::GetItemRectMax().x + 6 + wide <= left + width) ImGui::SameLine(0, 6);
    first = false;
    if (chip(ui, overlay.name ? overlay.name : overlay.label, overlay.swatch, label, on)) {
      Shown changed = shown(ui.state);
      changed.overlays.*overlay.shown = !on;
      ui.push(SetShown{changed});
      // A full sheet would cover what the press shows.
      if (!ui.layout.wide && ui.state.view.sheet == Sheet::full) ui.push(SetSheet{Sheet::half});
    }
    if (ImGui::IsItemHovered()) tip(ui, about(ui.state, overlay));
  }
}

std::string told_overlays(const AppState& state, const DrawerRow&) {
  static const Overlays usual;
  std::string told;
  for (const Overlay& overlay : overlays) {
    const bool on = shown(state).overlays.*overlay.shown;
    if (on == usual.*overlay.shown || !is_offered(state, overlay)) continue;
    const std::string label(translated(label_of(settings(state).method, overlay)));
    told += (told.empty() ? "" : ", ") + (on ? label : say("without {overlay}", {label}));
  }
  return told;
}

std::string told_compare(const AppState& state, const DrawerRow&) {
  return state.work.second_method ? say(words_of(*state.work.second_method).label) : std::string();
}

namespace {

constexpr Choice models[] = {{"As planned", "each robot's force is controlled"},
                             {"Springs", "all equally stiff and level"},
                             {"At best", "shared as evenly as possible"},
                             {"At worst", "unequal heights, or it bends"}};
static_assert(std::size(models) == std::size(all_load_models));

}  // namespace

void draw_model(const Ui& ui, const DrawerRow& row) {
  const float width = labelled(ui, row.label, row.about);
  const auto now = static_cast<std::size_t>(ui.state.view.load_model);
  const auto chosen = dropdown(ui, "loads", row.label, models, now, width);
  if (chosen && *chosen != now) ui.push(SetLoadModel{static_cast<LoadModel>(*chosen)});
  if (ui.state.view.load_model != LoadModel::plan) draw_remark(ui, model_words(ui.state), 3);
}

std::string told_model(const AppState& state, const DrawerRow&) {
  return state.view.load_model == LoadModel::plan
             ? std::string()
             : say(models[static_cast<std::size_t>(state.view.load_model)].label);
}

}  // namespace evenlift::view
