// Buttons, cards and chips.
#pragma once

#include <cstdint>
#include <string>

#include "state/camera.h"
#include "ui/icons.h"
#include "ui/ui.h"
#include "widgets/fields.h"

namespace evenlift::view {

// --- Buttons return true when pressed. `id` is unique within the window, and `about` is the tip. A
// disabled button is drawn faintly and does nothing.

bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* about,
                 float size, Pressed on = {});
bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* about,
                 float height, Icon after = Icon::none, Pressed on = {});

float text_button_width(const char* label);  // with an icon before the label

// A button with its own background. A strong button stands out as the next action. `spoken` is the
// name for users who cannot see the button's surroundings, if it differs from the label.
bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled = true,
                 bool strong = false, const char* spoken = nullptr);

// A button that stays down while `on`.
bool toggle_button(const Ui& ui, const char* id, const char* label, const char* about, float width,
                   bool on);

// A switch with a label.
bool switch_chip(const Ui& ui, const char* label, bool on);
float switch_chip_width(const char* label);

// A pressable row at Dear ImGui's cursor; the caller draws the row.
struct PressableRow {
  ImVec2 low, high;
  bool pressed, hovered;
};
PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled = true);

// --- Lays out cards, which float over the drawing. All sizes are pixels.

// A card is a window without decoration, with a soft shadow. end_card() ends a card.
struct CardOptions {
  bool at_bottom = false;     // the card is at the foot of its rectangle
  bool fixed_height = false;  // otherwise as high as its content, within the rectangle
  bool fixed_width = true;
  float padding = 20;
  bool scrolls = true;
  bool stays_below = false;  // a press does not bring the card to the front
};
void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options = {});
void end_card(const Ui& ui);

// Lets a finger scroll the window being filled.
void scroll_by_finger(const Ui& ui);

// Keeps a finger from scrolling while an item that follows the pointer is held. Call this after
// laying out the item.
void take_way_of_finger();

// Begins a box of constant height, in which longer content scrolls; end_scrolling_box() ends it.
// The scroll bar is in the card's padding, so that lines break at the same places with and without
// it.
void begin_scrolling_box(const Ui& ui, const char* id, float height);
void end_scrolling_box(const Ui& ui);

// Stores `now` for this window and id. Returns the value stored in the last frame, or `at_first` in
// the first frame.
int in_last_frame(const char* id, int now, int at_first);

// Scrolls the card until a section that a button just opened is visible, as far as there is room.
// Call this after the section. `head` is ImGui::GetCursorPosY() before the section.
void show_opened(const Ui& ui, const char* id, bool open, float head);

// Returns whether the pointer has moved too far since the press for this to be a click.
bool is_dragged();

// Returns whether a press was a click, not the end of scrolling or a finger that rests on a part to
// ask about it.
bool tapped(const Ui& ui, bool pressed);

// Draws the soft shadow under a card or a list.
void soft_shadow(const Ui& ui, ImVec2 low, ImVec2 high);

// --- Chips are small buttons that show and hide overlays.

// The samples on the chips. Each shows how the picture draws the overlay.
enum class Swatch : std::uint8_t {
  hull,
  clockwise,
  counterclockwise,
  chord,
  candidate,
  tipping,
  halo,
  tilt,
  load
};
// Lays out a chip. Returns whether it was pressed.
bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on);

}  // namespace evenlift::view
