// For typing, the page lays a field over these values (web/mirror/mirror.js). All sizes are pixels.
#pragma once

#include <string>

#include "ui/controls.h"
#include "ui/ui.h"

namespace evenlift::view {

// "− 3 +": returns -1, 0 or +1; repeats while a button is held. If `setting` names a setting, the
// value between the ends can be typed.
struct StepperOptions {
  bool can_lower = true, can_raise = true;
  const char* label = "";
  const char* setting = "";
  std::string exact = {};  // for typing, if the value is rounded
};
int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options);

// For typing, at the cursor. A number is aligned right; a text left, on its own background, and it
// ends with "…" if it is too long. `exact` is for typing, if the value is rounded.
void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width, const std::string& exact = {});
void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour,
                  const std::string& exact = {});

// A typed number that is not a setting, with its label before it and its own background. Also
// returns whether Enter confirmed it.
struct TypedField {
  const char *id, *label;
  bool is_length = false;  // in the document's unit of length
};
Asked typed_field(const Ui& ui, const TypedField& field, const std::string& value, float width);

}  // namespace evenlift::view
