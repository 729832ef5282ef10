// The page's controls. All sizes are CSS pixels; `id` is unique within its window.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/controls.h"
#include "ui/icons.h"
#include "ui/ui.h"

namespace evenlift::view {

// A window without any chrome: a floating card with a soft shadow. End with end_card().
struct CardOptions {
  bool at_bottom = false;     // stands on the bottom of the rectangle, not at its top
  bool fixed_height = false;  // otherwise as high as its content, at most as high as the rectangle
  bool fixed_width = true;
  float padding = 20;
  bool scrolls = true;
};
void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options = {});
void end_card(const Ui& ui);

// Lets a finger scroll the window that is being filled, as it does everywhere else.
void scroll_by_finger(const Ui& ui);

// A box of constant height, in which what is longer scrolls; ImGui::EndChild() ends it. The scroll bar lies in the padding
// of the card, so that the text breaks into the same lines with it and without it.
void begin_scrolling_box(const Ui& ui, const char* id, float height);

// Whether a press was a press, and not the end of scrolling.
bool tapped(const Ui& ui, bool pressed);

// The shadow under a card.
void soft_shadow(const Ui& ui, ImVec2 low, ImVec2 high);

// Buttons; true when pressed. A disabled one is drawn faintly and does nothing.
// One that says what is in hand stays down while `on`; without that it never does.
using Pressed = std::optional<bool>;
bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* about,
                 float size, Pressed on = {});
bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* about,
                 float height, Icon after = Icon::none, Pressed on = {});

float text_button_width(const char* label);  // with an icon before it

// A button with its own background; a strong one stands out as the next thing to do.
bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled = true,
                 bool strong = false);

// A button that stays down while `on`.
bool toggle_button(const Ui& ui, const char* id, const char* label, const char* about, float width,
                   bool on);

// A switch with a name.
bool switch_chip(const Ui& ui, const char* label, bool on);
float switch_chip_width(const char* label);

// "− 3 +": returns -1, 0 or +1; repeats while a button is held. If `setting` names one, the value between the two ends can be
// typed: the page then lays a field over it (web/page/mirror.js).
struct StepperOptions {
  bool can_lower = true, can_raise = true;
  const char* label = "";
  const char* setting = "";
};
int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options);

// A value that can be typed, at the cursor, `width` wide: a number ends at the right, a text begins at the left.
void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width);
void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour);

// A number that is typed and no setting: what was typed, and whether it was confirmed by Enter. With its label before it and
// its own ground.
Asked typed_field(const Ui& ui, const char* id, const char* label, const std::string& value,
                  float width);

// A track with a knob; arrow keys and pointer move it in steps. One whose value does not count now is drawn faintly.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts = true);

// The radius of a slider's knob, whose middle keeps so far from the ends of the track.
float knob_radius(const Ui& ui);

// The same with a track that is not divided evenly: where a value lies on it (0 .. 1), and which value lies there.
struct Track {
  std::function<double(double)> share, value;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts = true);

// A row of places at the cursor, of which a press takes one, and a pointer that is held and moves along takes one after
// another; a press on the one that is taken gives it up. The caller draws it. In the mirror it is a slider, on which 0 is
// none, and `value` says in words what is taken.
struct RowOfPlaces {
  ImVec2 low, high;
  std::optional<std::size_t> hovered;
  std::optional<std::size_t> taken;  // from now on
};
RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size);

// How an overlay is drawn in the picture.
enum class Swatch { hull, clockwise, counterclockwise, chord, candidate, tipping, halo };
bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on,
          bool enabled = true);

// A row of a list that can be pressed, at the cursor; the caller draws it.
struct PressableRow {
  ImVec2 low, high;
  bool pressed, hovered;
};
PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled = true);

// A label at the left of its control, which says more about itself under the pointer. Leaves the cursor where the control begins,
// and returns the width that is left for it.
float labelled(const Ui& ui, const char* label, const char* about);

void rule(const Ui& ui);
void tip(const Ui& ui, const char* text);
void text_line(Face face, Colour colour, const std::string& text);
void text_block(Face face, Colour colour, const std::string& text,
                float kept_free = 0);  // at the right

// The lines of a text that is broken at spaces so that none is wider than `width`; O(bytes).
std::vector<std::string_view> broken_lines(Face face, std::string_view text, float width);

// Draws these lines one below the other.
void draw_lines(ImDrawList& list, Face face, ImVec2 at, Colour colour,
                const std::vector<std::string_view>& lines);
float height_of(Face face, const std::vector<std::string_view>& lines);

// The same text in a block of constant height: at most `lines` of them, the last one cut off with "…" if there are more.
void text_block_of(Face face, Colour colour, const std::string& text, float width,
                   std::size_t lines);
float line_height(Face face);

}  // namespace evenlift::view
