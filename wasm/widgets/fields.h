// Fields, sliders, and what all controls share.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ui/controls.h"
#include "ui/ui.h"

namespace evenlift::view {

// --- The parts that all controls share: a pressable area, and the entry in the list of controls.

// A pressable area at Dear ImGui's cursor, in pixels.
struct Area {
  ImVec2 low, high;
  bool pressed, hovered, active;
  Asked asked;
  ImVec2 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

// Lays out the area and lists its control.
Area area(const Ui& ui, ImVec2 size, Control control);

// Return an entry of this kind for the list of controls.
Control button_control(const char* id, const char* label, bool enabled = true);
Control toggle_control(const char* id, const char* label, bool on);
Control number_control(const char* id, const char* label, const char* setting,
                       const std::string& value, const std::string& exact = {});
Control slider_control(const char* id, const char* label, double at, double low, double high,
                       double step);

// Whether a toggle is down; nothing for a button that is not a toggle.
using Pressed = std::optional<bool>;

// Returns a toggle if `on` has a value, otherwise a button.
Control pressed_control(const char* id, const char* label, bool enabled, Pressed on);

// --- Fields for values that the user can type: the page lays an HTML field over the value
// (web/mirror/mirror.js). All sizes are pixels.

// A stepper is a value between two buttons, such as "− 3 +". stepper() returns -1, 0 or +1, and
// repeats -1 or +1 while a button is held. If `setting` names a setting, the value between the
// buttons can be typed.
struct StepperOptions {
  bool can_lower = true, can_raise = true;
  const char* label = "";
  const char* setting = "";
  std::string exact = {};  // the value for typing, if `value` is rounded
};
int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options);

// Fields at Dear ImGui's cursor. A number is aligned right. A text is aligned left, on its own
// background, and ends with "…" if it is too long. `exact` is the value for typing, if `value` is
// rounded.
void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width, const std::string& exact = {});
void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour,
                  const std::string& exact = {});

// A field for a number that is not a setting, with a label before it and its own background.
// typed_field() returns the typed number (`moved`), and whether Enter confirmed it (`pressed`).
struct TypedField {
  const char *id, *label;
  bool is_length = false;  // the number is in the document's unit of length
};
Asked typed_field(const Ui& ui, const TypedField& field, const std::string& value, float width);

// --- Lays out controls that follow the pointer while held. All sizes are pixels.

// Arrow keys and the pointer move a slider in steps. If `counts` is false, the slider is drawn
// faintly, since its value has no effect.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts = true);

// Returns the radius of a slider's knob. The knob's middle stays at this distance from the ends of
// the track.
float knob_radius(const Ui& ui);

// An uneven track of a slider: `share` maps a value to its place (0 .. 1), and `value` maps a place
// to its value.
struct Track {
  std::function<double(double)> share, value;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts = true);

// A row of places at Dear ImGui's cursor; the caller draws the row. A press selects a place, and a
// held pointer that moves selects one place after another. A press on the selected place clears the
// selection; `value` describes the selected place in words. In the page's HTML (web/mirror) the row
// is a slider, at 0 if no place is selected.
struct RowOfPlaces {
  ImVec2 low, high;
  std::optional<std::size_t> hovered;
  std::optional<std::size_t> taken;  // the place selected from now on
};
RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size);

}  // namespace evenlift::view
