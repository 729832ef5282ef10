// Chips show and hide overlays.
#pragma once

#include <cstdint>

#include "ui/ui.h"

namespace evenlift::view {

// Of an overlay, as in the picture.
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
