// Fields for values that the user can type: the page lays an HTML field over the value
// (web/mirror/mirror.js). All sizes are pixels.
#pragma once

#include <string>

#include "ui/controls.h"
#include "ui/ui.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
