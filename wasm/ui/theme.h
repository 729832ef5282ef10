// Colours by role, light and dark, and the typefaces.
#pragma once

#include <imgui.h>

#include <string_view>

#include "state/state.h"

namespace evenlift::view {

// 0xRRGGBB, with an opacity in [0, 1].
struct Colour {
  unsigned rgb = 0;
  float opacity = 1;
  constexpr Colour at(float share) const { return {rgb, opacity * share}; }
  ImU32 packed() const;
  ImVec4 vec() const;
};

struct Theme {
  Colour ground, dots;
  Colour object, object_outline;
  Colour panel, panel_line, well;   // well: a control's background
  Colour text, second_text, quiet;  // quiet: lines, and icons that are off
  Colour hull, hull_outline, hull_text;
  Colour heat[7];  // from parts that a light press tips to parts that none tips
  Colour clockwise, clockwise_line, counter, counter_line;
  Colour robot, robot_ring, robot_track, robot_text;
  Colour chord, candidate;
  Colour accent, on_accent;
  Colour amber, amber_ground, red;
  // For the object, which is light in both themes.
  Colour accent_on_object, amber_on_object;
  Colour shadow;
};

const Theme& theme(const AppState& state);

// Of the heat map, where a press down of `share` of the weight tips the object; infinity if none
// does.
Colour heat_colour(const Theme& theme, double share);

// Sizes in pixels: tiny 11, label 13, text 15, verdict and large 20; all but label, text and large
// are semibold. The last value counts the faces.
enum class Face { tiny, label, strong_label, text, strong, verdict, large, end_of_faces };

// For a device-pixel ratio. Call it before a frame, and upload the font texture afterwards (Dear
// ImGui from 1.92 on does both itself).
void load_fonts(double ratio);

// All text of widgets until pop_face() has this face.
void push_face(Face face);
void pop_face();

// For drawing.
ImFont* font(Face face);
float size(Face face);         // of a font's line, as Dear ImGui counts
float line_height(Face face);  // between lines of a text, in whole pixels
ImVec2 text_size(Face face, std::string_view english, float wrap_width = 0);
void draw_text(ImDrawList& list, Face face, ImVec2 at, Colour colour, std::string_view english,
               float wrap_width = 0);

// For Dear ImGui's own widgets.
void apply_style(const AppState& state, double control_height);

// Makes anti-aliasing one device pixel wide, not one pixel: thin lines are as sharp as possible.
void sharpen(ImDrawList& list, const AppState& state);

}  // namespace evenlift::view
