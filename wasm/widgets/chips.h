// Chips that show and hide overlays of the picture.
#pragma once

#include <cstdint>

#include "ui/ui.h"

namespace evenlift::view {

// The symbol of an overlay, as in the picture.
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
bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on,
          bool enabled = true);

}  // namespace evenlift::view
