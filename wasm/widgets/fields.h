// Values that can be typed: the page lays a field over them (web/mirror/mirror.js). All sizes are
// pixels.
#pragma once

#include <string>

#include "ui/controls.h"
#include "ui/ui.h"

namespace evenlift::view {

// "− 3 +": returns -1, 0 or +1; repeats while a button is held. If `setting` names one, the value
// between the two ends can be typed.
struct StepperOptions {
  bool can_lower = true, can_raise = true;
  const char* label = "";
  const char* setting = "";
  std::string exact = {};  // what is typed over, where the value is rounded
};
int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options);

// A value that can be typed, at the cursor, `width` wide: a number ends at the right; a text begins
// at the left, on a ground of its own, and is cut off with "…" where it is too long. `exact` is
// what is typed over, where the value is rounded.
void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width, const std::string& exact = {});
void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour,
                  const std::string& exact = {});

// A number that is typed and is not a setting: what was typed, and whether it was confirmed by
// Enter. With its label before it and its own ground.
struct TypedField {
  const char *id, *label;
  bool is_length = false;  // in the document's unit of length
};
Asked typed_field(const Ui& ui, const TypedField& field, const std::string& value, float width);

}  // namespace evenlift::view
