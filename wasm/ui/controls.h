// The controls of the panels as data. The page mirrors them in HTML for keyboards and screen
// readers, and scripts and tests find them by name. Each pass lays out all controls again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// `text` is not interactive: it is a number of the result, for users who cannot see it. The last
// value is not a kind: it counts them, so that each must have a name.
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
  std::string name;   // its id; the ends of a stepper are "id -" and "id +"
  std::string label;  // a readable name
  bool enabled = true;
  bool on = false;                   // of a toggle
  std::string value;                 // of a number, slider or text: as shown
  std::string exact;                 // of a number: the exact text for typing, if the shown value
                                     // is rounded
  std::string setting;               // of a number: its setting, see settings.h
  bool is_length = false;            // of a number: in the document's unit of length
  double low = 0, high = 0, at = 0;  // of a slider
  double step = 0;
  std::vector<std::string> choices;    // of a choice
  std::optional<std::size_t> current;  // the chosen one
  std::string card;                    // the card that contains it
  Rect place;                          // in pixels
  Rect window;                         // the visible part of the card; empty below an open list
};

// Forgets the controls of the last pass.
void begin_controls();

// From now on, controls belong to this card.
void enter_card(const char* name);

// Whether controls from now on belong to an open list, the window being filled: it covers the
// controls of the cards below it.
void enter_list(bool on_list);
// The place of that list, in pixels, if one is open.
const std::optional<Rect>& open_list();

// Lists the item that Dear ImGui laid out last. A request to the control is returned once.
struct Asked {
  bool pressed = false;
  std::optional<std::size_t> chosen;  // of a choice
  std::optional<double> moved;        // of a slider, or a number without a setting
  bool withdrawn = false;             // of a number without a setting: its typed text is withdrawn
};
Asked list_control(Control control);

// Lists the item that Dear ImGui laid out last as a text.
void list_text(std::string label, std::string value);

// Covers all controls of other cards, laid out so far, that overlap this place: the pointer does
// not reach them.
void cover_controls(const Rect& place);

// The controls of the last pass, in layout order.
const std::vector<Control>& controls();

// All controls as JSON for web/mirror; and a place as JSON. Places are multiplied by `zoom`, which
// converts them to CSS pixels.
std::string controls_json(double zoom);
std::string place_json(const Rect& place, double zoom);

// Requests something of the control with this name on this card, for the next pass: press it;
// select a choice or move it, by `value`; scroll its card until it is visible; move it and confirm,
// as Enter confirms a typed number; or withdraw the typed text.
enum class ControlRequest : std::uint8_t { press, choose, move, reveal, enter, withdraw };
void ask_control(ControlRequest what, std::string card, std::string name, double value);

}  // namespace evenlift::view
