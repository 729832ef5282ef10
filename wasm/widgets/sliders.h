// Controls that follow the pointer while they are held. All sizes are pixels.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ui/ui.h"

namespace evenlift::view {

// A track with a knob; arrow keys and pointer move it in steps. Without `counts` the slider is
// drawn faintly, since its value has no effect now.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts = true);

// The radius of a slider's knob, and the distance of its middle from the ends of the track.
float knob_radius(const Ui& ui);

// The same with an uneven track: `share` maps a value to its place (0 .. 1), and `value` maps back.
struct Track {
  std::function<double(double)> share, value;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts = true);

// A row of places at the cursor. A press selects a place, and a held pointer that moves along
// selects one after another; a press on the selected place clears it. The caller draws the row. In
// the mirror it is a slider with 0 for none, and `value` describes the selected place.
struct RowOfPlaces {
  ImVec2 low, high;
  std::optional<std::size_t> hovered;
  std::optional<std::size_t> taken;  // the selected place from now on
};
RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size);

}  // namespace evenlift::view
