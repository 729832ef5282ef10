// Lays out cards, which float over the drawing. All sizes are pixels.
#pragma once

#include "state/camera.h"
#include "ui/ui.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
