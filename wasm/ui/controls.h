// The panels' controls as data. The page mirrors the controls in HTML for keyboards and screen
// readers; scripts and tests find them by name. Each pass lays all controls out again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// `text` is not interactive: it states a value of the result for users who cannot see the panels.
// The last enumerator counts the kinds; controls.cpp uses it to check that each has a name.
enum class ControlKind : std::uint8_t {
  button,
  toggle,
  number,
  slider,
  choice,
  text,
  end_of_kinds
};

struct Control {
  ControlKind kind = ControlKind::button;
  std::string name;   // an id; a stepper's buttons are "id -" and "id +"
  std::string label;  // a readable name
  bool enabled = true;
  bool on = false;                   // of a toggle
  std::string value;                 // of a number, slider or text: the value as shown
  std::string exact;                 // of a number: the value for typing, if `value` is rounded
  std::string setting;               // of a number: the setting's name (settings.h)
  bool is_length = false;            // of a number: in the document's unit of length
  double low = 0, high = 0, at = 0;  // of a slider
  double step = 0;
  std::vector<std::string> choices;    // of a choice
  std::optional<std::size_t> current;  // the chosen index of `choices`
  std::string card;                    // the name of the card that contains the control
  Rect place;                          // the control's place, in pixels
  Rect window;  // the card's window, in pixels; empty if a list or another card covers the control
};

// Forgets the controls of the last pass.
void begin_controls();

// Controls that are listed from now on belong to this card.
void enter_card(const char* name);

// enter_list(true) notes that the window being filled is an open list. Controls listed from then
// until enter_list(false) belong to it; while it is open, all other controls count as covered.
void enter_list(bool on_list);
// Returns the place of the open list, in pixels; nothing if no list is open.
const std::optional<Rect>& open_list();

// The requests for a control. list_control() lists the control at the place of the item that Dear
// ImGui laid out last, and returns each request once.
struct Asked {
  bool pressed = false;
  std::optional<std::size_t> chosen;  // the index, of a choice
  std::optional<double> moved;        // the value, of a slider or a number without a setting
  bool withdrawn = false;             // of a number without a setting: its typed text is withdrawn
};
Asked list_control(Control control);

// Lists a text at the place of the item that Dear ImGui laid out last.
void list_text(std::string label, std::string value);

// Marks as covered all controls of other cards that were listed so far and overlap this place,
// since the pointer does not reach them.
void cover_controls(const Rect& place);

// Returns the controls of the last pass, in the order in which they were laid out.
const std::vector<Control>& controls();

// Return all controls, or a place, as JSON for web/mirror. `zoom` converts places to CSS pixels.
std::string controls_json(double zoom);
std::string place_json(const Rect& place, double zoom);

// Requests for the next pass, in the order of the values: press the control; select the choice with
// the index `value`; move the control to `value`; scroll its card until the control is visible;
// move and confirm, as Enter confirms a typed number; or withdraw the typed text.
enum class ControlRequest : std::uint8_t { press, choose, move, reveal, enter, withdraw };
void ask_control(ControlRequest what, std::string card, std::string name, double value);

}  // namespace evenlift::view
