// Rows of the panels in which a setting that is a length goes up and down, or is typed.
#pragma once

#include <optional>

#include "evenlift/settings.h"
#include "ui/ui.h"

namespace evenlift::view {

struct LengthRow {
  Setting setting;
  const char *label, *about, *spoken;
  // Of one that has a usual value: its member, and what that is.
  std::optional<double> Settings::*member = nullptr;
  const char* usual = nullptr;
};
void draw_length(const Ui& ui, const LengthRow& row);

// How large the object is; and the first step of a length from 0: a round number of about a
// hundredth of that.
double size_of_object(const AppState& state);
double first_length(double size_of_object);

}  // namespace evenlift::view
