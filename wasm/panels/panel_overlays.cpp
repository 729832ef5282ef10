// The overlays' switches, also the legend of the picture.
#include <algorithm>
#include <iterator>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "picture/heat.h"
#include "widgets/chips.h"
#include "widgets/text.h"

namespace evenlift::view {
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
  if (overlay.shown == &Overlays::tilt) return shown.carrying.com_height > 0;
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

}  // namespace evenlift::view
