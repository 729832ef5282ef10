// Cards float over the drawing. All sizes are pixels.
#pragma once

#include "state/camera.h"
#include "ui/ui.h"

namespace evenlift::view {

// A window without decoration, with a soft shadow. End with end_card().
struct CardOptions {
  bool at_bottom = false;     // of the rectangle
  bool fixed_height = false;  // otherwise as high as its content, within the rectangle
  bool fixed_width = true;
  float padding = 20;
  bool scrolls = true;
  bool stays_below = false;  // a press does not bring it to the front
};
void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options = {});
void end_card(const Ui& ui);

// Lets a finger scroll the window being filled.
void scroll_by_finger(const Ui& ui);

// Call this after laying out an item that follows the pointer: while it is held, a finger scrolls
// nothing.
void take_way_of_finger();

// Of constant height; longer content scrolls. End with end_scrolling_box(). The scroll bar is in
// the card's padding, so that lines break at the same places without it.
void begin_scrolling_box(const Ui& ui, const char* id, float height);
void end_scrolling_box(const Ui& ui);

// The value passed in the last frame, by window and id; `at_first` in the first one.
int in_last_frame(const char* id, int now, int at_first);

// Call after a section that a button opens, with its head at `head` (ImGui::GetCursorPosY() before
// it). The card then scrolls until the section is visible, as far as there is room.
void show_opened(const Ui& ui, const char* id, bool open, float head);

// Whether the pointer moved too far since the press for a click.
bool is_dragged();

// Whether a press was a click, and not the end of scrolling.
bool tapped(const Ui& ui, bool pressed);

// Under a card.
void soft_shadow(const Ui& ui, ImVec2 low, ImVec2 high);

}  // namespace evenlift::view
