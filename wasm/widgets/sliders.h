// These controls follow the pointer while held. All sizes are pixels.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ui/ui.h"

namespace evenlift::view {

// Arrow keys and pointer move a slider in steps. Without `counts` it is drawn faintly: its value
// has no effect.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts = true);

// Also the distance of the knob's middle from the ends of the track.
float knob_radius(const Ui& ui);

// With an uneven track: `share` maps a value to its place (0 .. 1), and `value` maps back.
struct Track {
  std::function<double(double)> share, value;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts = true);

// At the cursor; the caller draws the row. A press selects a place, and a held pointer one after
// another; a press on the selected place clears it. In the mirror the row is a slider with 0 for
// none, and `value` describes the place.
struct RowOfPlaces {
  ImVec2 low, high;
  std::optional<std::size_t> hovered;
  std::optional<std::size_t> taken;  // selected from now on
};
RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size);

}  // namespace evenlift::view
