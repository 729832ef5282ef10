// The controls of the panels as data. The page mirrors them in HTML for keyboards and screen
// readers, and scripts and tests find them by name. Each pass lays out all controls anew.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// A text is nothing to press: a number of the result, for those who cannot see it. The last is no
// kind: it counts them, so that each needs its word.
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
  std::string label;  // what it is, in words
  bool enabled = true;
  bool on = false;                   // of a toggle
  std::string value;                 // of a number, slider or text: as it is shown
  std::string exact;                 // of a number: what is typed over, where that is more exact
  std::string setting;               // of a number: which setting it is, see settings.h
  bool is_length = false;            // of a number: in the document's unit of length
  double low = 0, high = 0, at = 0;  // of a slider
  double step = 0;
  std::vector<std::string> choices;    // of a choice
  std::optional<std::size_t> current;  // which of them is chosen
  std::string card;                    // the card that it is on
  Rect place;                          // in pixels
  Rect window;  // the part of the card that is seen; empty below an open list
};

// Forgets the controls of the last pass.
void begin_controls();

// From now on controls are on this card.
void enter_card(const char* name);

// From now on controls are, or are not, on an open list, the window that is being filled: it covers
// those of the cards below it.
void enter_list(bool on_list);
// Where that list is, in pixels, if one is open.
const std::optional<Rect>& open_list();

// Lists the item that Dear ImGui laid out last. What is asked of the control is returned once.
struct Asked {
  bool pressed = false;
  std::optional<std::size_t> chosen;  // of a choice
  std::optional<double> moved;        // of a slider, or a number without a setting
  bool withdrawn = false;             // what was typed of a number without a setting is taken back
};
Asked list_control(Control control);

// Lists the item that Dear ImGui laid out last as a text.
void list_text(std::string label, std::string value);

// What was laid out so far in other cards and is overlapped by this place is covered from now on:
// the pointer does not reach it.
void cover_controls(const Rect& place);

// The controls of the last pass, in the order in which they were laid out.
const std::vector<Control>& controls();

// All of them as JSON, which web/mirror reads; and a place. Places are multiplied by `zoom`: into
// pixels of the canvas.
std::string controls_json(double zoom);
std::string place_json(const Rect& place, double zoom);

// Asks something of the control with this name on this card, to be done in the next pass: to press
// it; to choose one of its choices or to move it, by `value`; to scroll its card until it is seen;
// to move it and press it: a number that is typed and confirmed; or to take back what was typed.
enum class ControlRequest : std::uint8_t { press, choose, move, reveal, enter, withdraw };
void ask_control(ControlRequest what, std::string card, std::string name, double value);

}  // namespace evenlift::view
