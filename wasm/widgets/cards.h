// Cards, which float over the drawing, and how they scroll. All sizes are pixels.
#pragma once

#include "state/camera.h"
#include "ui/ui.h"

namespace evenlift::view {

// A window without any chrome: a floating card with a soft shadow. End with end_card().
struct CardOptions {
  bool at_bottom = false;     // stands on the bottom of the rectangle, not at its top
  bool fixed_height = false;  // otherwise as high as its content, at most as high as the rectangle
  bool fixed_width = true;
  float padding = 20;
  bool scrolls = true;
  bool stays_below = false;  // a press on it does not bring it before other cards
};
void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options = {});
void end_card(const Ui& ui);

// Lets a finger scroll the window that is being filled, as it does everywhere else.
void scroll_by_finger(const Ui& ui);

// Call this after laying out an item that follows the pointer: while it is held, a finger scrolls
// nothing.
void take_way_of_finger();

// A box of constant height, in which what is longer scrolls. End with end_scrolling_box(). The
// scroll bar lies in the padding of the card, so that the text breaks into the same lines with it
// and without it.
void begin_scrolling_box(const Ui& ui, const char* id, float height);
void end_scrolling_box(const Ui& ui);

// What was given here in the last frame, by the window and the id; `at_first` in the first one.
int in_last_frame(const char* id, int now, int at_first);

// Call after a section that a button opens, whose head is at `head` (ImGui::GetCursorPosY() before
// it): once it was opened, the card scrolls until all of it is seen, or as much as there is room
// for.
void show_opened(const Ui& ui, const char* id, bool open, float head);

// Whether the pointer moved so far since it was pressed that it is no press.
bool is_dragged();

// Whether a press was a press, and not the end of scrolling.
bool tapped(const Ui& ui, bool pressed);

// The shadow under a card.
void soft_shadow(const Ui& ui, ImVec2 low, ImVec2 high);

}  // namespace evenlift::view
