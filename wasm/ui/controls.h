// The panels' controls as data. The page mirrors them in HTML for keyboards and screen readers;
// scripts and tests find them by name. Each pass lays them out again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// `text` is not interactive: a number of the result, for users who cannot see it. The last value
// counts the kinds, so that each must have a name.
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
  std::string name;   // an id; a stepper's ends are "id -" and "id +"
  std::string label;  // a readable name
  bool enabled = true;
  bool on = false;                   // of a toggle
  std::string value;                 // of a number, slider or text, as shown
  std::string exact;                 // of a number: for typing, if `value` is rounded
  std::string setting;               // of a number, see settings.h
  bool is_length = false;            // of a number: in the document's unit of length
  double low = 0, high = 0, at = 0;  // of a slider
  double step = 0;
  std::vector<std::string> choices;    // of a choice
  std::optional<std::size_t> current;  // the chosen one
  std::string card;                    // the card that contains it
  Rect place;                          // in pixels
  Rect window;                         // visible part of the card; empty below an open list
};

// Forgets the controls of the last pass.
void begin_controls();

// From now on, controls belong to this card.
void enter_card(const char* name);

// Whether controls from now on belong to an open list, the window being filled: it covers the
// controls below it.
void enter_list(bool on_list);
// In pixels, if a list is open.
const std::optional<Rect>& open_list();

// Lists the item that Dear ImGui laid out last. Returns each request once.
struct Asked {
  bool pressed = false;
  std::optional<std::size_t> chosen;  // of a choice
  std::optional<double> moved;        // of a slider, or a number without a setting
  bool withdrawn = false;             // of a number without a setting: the typed text
};
Asked list_control(Control control);

// The item that Dear ImGui laid out last.
void list_text(std::string label, std::string value);

// Covers all controls of other cards, laid out so far, that overlap this place: the pointer does
// not reach them.
void cover_controls(const Rect& place);

// Of the last pass, in layout order.
const std::vector<Control>& controls();

// All controls, and a place, as JSON for web/mirror. `zoom` converts places to CSS pixels.
std::string controls_json(double zoom);
std::string place_json(const Rect& place, double zoom);

// For the next pass: press the control; select a choice or move it, by `value`; scroll its card
// until it is visible; move it and confirm, as Enter confirms a typed number; or withdraw the typed
// text.
enum class ControlRequest : std::uint8_t { press, choose, move, reveal, enter, withdraw };
void ask_control(ControlRequest what, std::string card, std::string name, double value);

}  // namespace evenlift::view
