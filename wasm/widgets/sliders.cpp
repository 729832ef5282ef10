#include "widgets/sliders.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/area.h"
#include "widgets/cards.h"

namespace evenlift::view {

float knob_radius(const Ui& ui) { return ui.control() > 40 ? 11.0f : 8.0f; }
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts) {
  const Track even{[=](double at) { return (at - low) / (high - low); },
                   [=](double share) { return low + share * (high - low); }};
  return slider(ui, id, label, value, low, high, step, width, even, counts);
}

SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts) {
  const Colour ink = counts ? ui.theme.accent : ui.theme.quiet;
  const float height = ui.control(), knob = knob_radius(ui);
  const Area a = area(ui, ImVec2(width, height), slider_control(id, label, value, low, high, step));
  SliderResult result{false, ImGui::IsItemDeactivated(), value};
  if (a.asked.moved && *a.asked.moved >= low && *a.asked.moved <= high)
    result = {*a.asked.moved != value, true, *a.asked.moved};
  take_way_of_finger();
  const float from = a.low.x + knob, to = a.high.x - knob;
  if (a.active && ImGui::IsMouseDown(0)) {
    const double share =
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from) / (to - from)), 0.0, 1.0);
    // Steps are decimals: a quotient of integers is the double nearest to the shown decimal.
    const double steps = std::round(1 / step);
    const double at = track.value(share);
    const double wanted =
        step < 1 ? std::round(at * steps) / steps : std::min(std::round(at / step) * step, high);
    result.changed = wanted != value;
    result.value = wanted;
  }
  const float x = from + (to - from) * static_cast<float>(track.share(result.value)),
              y = a.middle().y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(a.high.x, y + 3), ui.theme.quiet.packed(), 3);
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(x, y + 3), ink.packed(), 3);
  if (a.hovered || a.active)
    list.AddCircleFilled(ImVec2(x, y), knob + 5, ui.theme.accent.at(0.16f).packed(), 32);
  list.AddCircleFilled(ImVec2(x, y), knob, ui.theme.panel.packed(), 32);
  list.AddCircle(ImVec2(x, y), knob, ink.packed(), 32, 2);
  return result;
}

RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size) {
  const double at = taken ? static_cast<double>(*taken) + 1 : 0, most = static_cast<double>(count);
  Control control = slider_control(id, label, at, 0, most, 1);
  control.value = value;
  control.enabled = count > 0;
  const Area a = area(ui, size, std::move(control));
  take_way_of_finger();
  RowOfPlaces row{a.low, a.high, {}, taken};
  if (count == 0) return row;
  if (a.asked.moved && *a.asked.moved >= 0 && *a.asked.moved <= most) {
    const auto place = static_cast<std::size_t>(std::round(*a.asked.moved));
    row.taken = place > 0 ? std::optional(place - 1) : std::nullopt;
    return row;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const float share = std::clamp((io.MousePos.x - a.low.x) / size.x, 0.0f, 1.0f);
  const auto under =
      std::min(count - 1, static_cast<std::size_t>(static_cast<double>(share) * most));
  if (a.hovered || a.active) row.hovered = under;
  const bool slid = is_dragged();
  if (a.active && slid) row.taken = under;
  if (a.pressed && !slid) row.taken = taken == under ? std::nullopt : std::optional(under);
  return row;
}

}  // namespace evenlift::view
