// Panel rows that step a setting up and down, or take a typed value.
#pragma once

#include <optional>
#include <string>

#include "evenlift/settings.h"
#include "ui/ui.h"

namespace evenlift::view {

struct LengthRow {
  Setting setting;
  const char *label, *about, *spoken;
  // For a setting with a default: its member, and the default's name.
  std::optional<double> Settings::*member = nullptr;
  const char* usual = nullptr;
};
void draw_length(const Ui& ui, const LengthRow& row);

// A length or a weight that may be missing.
struct OptionalRow {
  Setting setting;
  const char *label, *about;
  std::string spoken;
  const char* without;           // what is there instead
  const char *unset_id, *unset;  // the button that removes it
};
// Returns whether the value is given.
bool draw_optional(const Ui& ui, const OptionalRow& row);

// Of the object; and a length's first step from 0: a round number near a hundredth of the size.
double size_of_object(const AppState& state);
double first_length(double size_of_object);

}  // namespace evenlift::view
