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
  // For a setting with a default: its member, and the label of the button that restores the
  // default.
  std::optional<double> Settings::*member = nullptr;
  const char* usual = nullptr;
};
void draw_length(const Ui& ui, const LengthRow& row);

// The row of a length or a weight that may have no value.
struct OptionalRow {
  Setting setting;
  const char *label, *about;
  std::string spoken;
  const char* without;           // the text shown without a value
  const char *unset_id, *unset;  // the button that removes the value
};
// Returns whether the setting has a value.
bool draw_optional(const Ui& ui, const OptionalRow& row);

// size_of_object() returns the diagonal of the polygon's bounding box, or 100 before the first
// placement. first_length() returns the length to which a step up from 0 leads: a power of ten,
// from 1/500 to 1/50 of the size.
double size_of_object(const AppState& state);
double first_length(double size_of_object);

}  // namespace evenlift::view
