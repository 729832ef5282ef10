// Colours and typefaces, letters, and points for Dear ImGui.
#pragma once

#include <imgui.h>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/vec.h"
#include "state/state.h"

namespace evenlift::view {

// --- Converts coordinates and points to Dear ImGui's points, which are stored as floats.

inline ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
inline ImVec2 vec(const Vec2& p) { return vec(p.x, p.y); }

// --- The heat map's levels: forces that tip the object, in units of its weight. A band of the heat map
// is between two levels, below the first or above the last.

inline constexpr double heat_levels[] = {0.1, 0.2, 0.5, 1, 2};

// --- The colours by role, light and dark, and the typefaces.

// A colour 0xRRGGBB, with an opacity in [0, 1].
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
  Colour heat[7];  // from where a light press tips the object to where no press tips it
  Colour clockwise, clockwise_line, counter, counter_line;
  Colour robot, robot_ring, robot_track, robot_text;
  Colour chord, candidate;
  Colour accent, on_accent;
  Colour amber, amber_ground, red;
  // The colours on the object, which is light in both themes.
  Colour accent_on_object, amber_on_object;
  Colour shadow;
};

// Returns the light or the dark theme, whichever the page requests.
const Theme& theme(const AppState& state);

// Returns the heat map's colour where only a downward press of at least `share` times the weight
// tips the object. `share` is 0, one of `heat_levels`, or infinite where no press tips it.
Colour heat_colour(const Theme& theme, double share);

// The typefaces. Their sizes in pixels are 11 for `tiny`, 13 for both labels, 15 for `text` and
// `strong`, and 20 for `verdict` and `large`. All but `label`, `text` and `large` are semibold. The
// last value counts the faces.
enum class Face { tiny, label, strong_label, text, strong, verdict, large, end_of_faces };

// Loads the fonts for a device-pixel ratio. Call this before a frame, and upload the font texture
// afterwards. From 1.92 on, Dear ImGui itself adapts to the ratio and uploads the texture.
void load_fonts(double ratio);

// Draws the text of all widgets in this face until pop_face().
void push_face(Face face);
void pop_face();

// The fonts and sizes for drawing text. All sizes are pixels.
ImFont* font(Face face);
float size(Face face);         // the height of a font's line, as Dear ImGui measures it
float line_height(Face face);  // the distance between lines of a text, in whole pixels
ImVec2 text_size(Face face, std::string_view english, float wrap_width = 0);
void draw_text(ImDrawList& list, Face face, ImVec2 at, Colour colour, std::string_view english,
               float wrap_width = 0);

// Applies the theme to Dear ImGui's own widgets.
void apply_style(const AppState& state, double control_height);

// Makes anti-aliasing one device pixel wide, not one pixel of the view, so that thin lines are as
// sharp as possible.
void sharpen(ImDrawList& list, const AppState& state);

// --- The page's two fonts: those of assets/fonts, embedded by cmake/Embed.cmake or given, or larger
// ones that the page fetched.

struct FontData {
  const unsigned char* bytes;
  int size;  // in bytes
};

FontData regular_font();
FontData semibold_font();

// Replaces the fonts by larger ones that the page fetched (letters.h).
void give_fonts(std::vector<unsigned char> regular, std::vector<unsigned char> semibold);

// --- Finds characters for users' texts, such as lessons and file names. At first the page's fonts have
// only the few characters that the page itself writes. The page fetches larger fonts
// (web/page/bindings.js), from which other characters are rasterised.

// Notes which characters of the text the font lacks. O(bytes).
void note_letters(const ImFont& font, std::string_view text);

// Returns whether any noted characters have yet to be looked up in the fonts.
bool letters_are_due();

// letters_are_here() returns whether the larger fonts have arrived. Call have_letters() when they
// arrive.
bool letters_are_here();
void have_letters();

// Returns the ranges of characters to rasterise, ended by 0: the page's own characters and, once
// the larger fonts are here, a range around each noted character. No letters are due afterwards.
const ImWchar* letter_ranges();

// Returns, as text, the noted characters that the font lacks and that no earlier call returned.
// Call this after the fonts are built.
std::string absent_letters(const ImFont& font);

// --- Records the texts that the view draws, so that tests can check their language and their room.

struct DrawnText {
  std::string text;  // as drawn
  bool has_room;     // the text fits its place
};

// From now on, adds drawn texts to the record; null ends the recording.
void record_texts(std::vector<DrawnText>* record);

void note_drawn(std::string_view text);
// Records the text only if its width is greater than the room for it, both in pixels.
void note_room(std::string_view text, float width, float room);

}  // namespace evenlift::view
