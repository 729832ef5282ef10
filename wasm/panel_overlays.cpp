// What the picture shows: switches that are its legend at the same time.
#include "panels.h"
#include "widgets.h"

namespace evenlift::view {
namespace {

struct Overlay {
  bool Overlays::*shown;
  Swatch swatch;
  const char* label;
  const char* about;
};
constexpr Overlay overlays[] = {
    {&Overlays::hull, Swatch::hull, "Base",
     "Lifting base H, the hull of all robots: safe to push on (H)"},
    {&Overlays::chords, Swatch::chord, "Chords",
     "The two robots of a team and the line between them (C)"},
    {&Overlays::candidates, Swatch::candidate, "Candidates", "All chords that were weighed (A)"},
    {&Overlays::clockwise, Swatch::clockwise, "Clockwise",
     "Points about which it can still turn clockwise (R)"},
    {&Overlays::counterclockwise, Swatch::counterclockwise, "Counter-clockwise",
     "Points about which it can still turn counter-clockwise (L)"},
};

}  // namespace

void draw_overlays(const Ui& ui) {
  const float left = ImGui::GetCursorScreenPos().x, width = ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const Overlay& overlay : overlays) {
    const bool on = settings(ui.state).overlays.*overlay.shown;
    const float wide = text_size(Face::label, overlay.label).x + 42;
    if (!first && ImGui::GetItemRectMax().x + 6 + wide <= left + width) ImGui::SameLine(0, 6);
    first = false;
    if (chip(ui, overlay.label, overlay.swatch, overlay.label, on)) {
      Settings changed = settings(ui.state);
      changed.overlays.*overlay.shown = !on;
      ui.push(SetSettings{changed});
    }
    if (ImGui::IsItemHovered()) tip(ui, overlay.about);
  }
}

}  // namespace evenlift::view
