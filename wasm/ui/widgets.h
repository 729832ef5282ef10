// The page's controls. All sizes are CSS pixels; `id` is unique within its window.
#pragma once

#include <optional>
#include <string>

#include "ui/icons.h"
#include "ui/ui.h"

namespace evenlift::view {

// A window without any chrome: a floating card with a soft shadow. End with end_card().
struct CardOptions {
  bool fixed_height = false;  // otherwise as high as its content, at most as high as the rectangle
  bool fixed_width = true;
  float padding = 20;
  bool scrolls = true;
};
void begin_card(const Ui& ui, const char* id, const Rect& place, const CardOptions& options = {});
void end_card(const Ui& ui);

// Lets a finger scroll the window that is being filled, as it does everywhere else.
void scroll_by_finger(const Ui& ui);

// Whether a press was a press, and not the end of scrolling.
bool tapped(const Ui& ui, bool pressed);

// For scripts and tests: where a control stands. The first one of that name that is laid out after
// seek_control() is found. A control's name is its id; the two ends of a stepper are "id -" and
// "id +".
void seek_control(std::string name);
std::optional<Rect> found_control();

// The shadow under a card.
void soft_shadow(const Ui& ui, ImVec2 low, ImVec2 high);

// Buttons; true when pressed. A disabled one is drawn faintly and does nothing.
bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* tip,
                 float size);
bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* tip,
                 float height, Icon after = Icon::none);

// A button with its own background; a strong one stands out as the next thing to do.
bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled = true,
                 bool strong = false);

// A switch with a name.
bool switch_chip(const Ui& ui, const char* label, bool on);

// "− 3 +": returns -1, 0 or +1; repeats while a button is held.
int stepper(const Ui& ui, const char* id, const std::string& value, bool can_lower, bool can_raise,
            float width);

// A track with a knob; arrow keys and pointer move it in steps.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, double value, double low, double high,
                    double step, float width);

// How an overlay is drawn in the picture.
enum class Swatch { hull, clockwise, counterclockwise, chord, candidate, tipping };
bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on);

// A label at the left of its control: the cursor is left where the control begins; `width` is the
// rest.
float labelled(const Ui& ui, const char* label, float label_width = 120);

void rule(const Ui& ui);
void tip(const Ui& ui, const char* text);
void text_line(Face face, Colour colour, const std::string& text);
void text_block(Face face, Colour colour, const std::string& text,
                float kept_free = 0);  // at the right

}  // namespace evenlift::view
