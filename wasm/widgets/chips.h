// Chips are small buttons that show and hide overlays.
#pragma once

#include <cstdint>

#include "ui/ui.h"

namespace evenlift::view {

// The samples on the chips. Each shows how the picture draws the overlay.
enum class Swatch : std::uint8_t {
  hull,
  clockwise,
  counterclockwise,
  chord,
  candidate,
  tipping,
  halo,
  tilt,
  load
};
// Lays out a chip. Returns whether it was pressed.
bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on,
          bool enabled = true);

}  // namespace evenlift::view
