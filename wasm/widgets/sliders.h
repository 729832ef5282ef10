// Controls that follow the pointer while they are held. All sizes are pixels.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ui/ui.h"

namespace evenlift::view {

// A track with a knob; arrow keys and pointer move it in steps. One whose value does not count now
// is drawn faintly.
struct SliderResult {
  bool changed = false;
  bool released = false;
  double value = 0;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts = true);

// The radius of a slider's knob, whose middle keeps so far from the ends of the track.
float knob_radius(const Ui& ui);

// The same with a track that is not divided evenly: where a value lies on it (0 .. 1), and which
// value lies there.
struct Track {
  std::function<double(double)> share, value;
};
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts = true);

// A row of places at the cursor, of which a press takes one, and a pointer that is held and moves
// along takes one after another; a press on the one that is taken gives it up. The caller draws it.
// In the mirror it is a slider, on which 0 is none, and `value` says in words what is taken.
struct RowOfPlaces {
  ImVec2 low, high;
  std::optional<std::size_t> hovered;
  std::optional<std::size_t> taken;  // from now on
};
RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size);

}  // namespace evenlift::view
