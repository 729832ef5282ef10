// Lays out controls that follow the pointer while held. All sizes are pixels.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ui/ui.h"

namespace evenlift::view {

// Arrow keys and the pointer move a slider in steps. If `counts` is false, the slider is drawn
// faintly, since its value has no effect.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts = true);

// Returns the radius of a slider's knob. The knob's middle stays at this distance from the ends of
// the track.
float knob_radius(const Ui& ui);

// An uneven track of a slider: `share` maps a value to its place (0 .. 1), and `value` maps a place
// to its value.
struct Track {
  std::function<double(double)> share, value;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts = true);

// A row of places at Dear ImGui's cursor; the caller draws the row. A press selects a place, and a
// held pointer that moves selects one place after another. A press on the selected place clears the
// selection; `value` describes the selected place in words. In the page's HTML (web/mirror) the row
// is a slider, at 0 if no place is selected.
struct RowOfPlaces {
  ImVec2 low, high;
  std::optional<std::size_t> hovered;
  std::optional<std::size_t> taken;  // the place selected from now on
};
RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size);

}  // namespace evenlift::view
