#include "widgets/chips.h"

#include "widgets/area.h"

namespace evenlift::view {
namespace {

void hatch_swatch(ImDrawList& list, ImVec2 low, ImVec2 high, Colour colour, bool rising) {
  list.PushClipRect(low, high, true);
  for (int line = 0; line < 11; ++line) {
    const float x = -16 + 4.5f * static_cast<float>(line);
    const ImVec2 from(low.x + x, rising ? high.y : low.y),
        to(low.x + x + 16, rising ? high.y - 16 : low.y + 16);
    list.AddLine(from, to, colour.packed(), 1.3f);
  }
  list.PopClipRect();
}

void draw_swatch(const Ui& ui, Swatch swatch, ImVec2 low, bool on) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& t = ui.theme;
  const ImVec2 high(low.x + 16, low.y + 16);
  const float y = low.y + 8;
  const auto shade = [&](Colour c) { return on ? c : t.quiet; };
  switch (swatch) {
    case Swatch::hull:
      list.AddRectFilled(low, high, (on ? t.hull : t.quiet.at(0.15f)).packed(), 3);
      list.AddRect(low, high, shade(t.hull_outline).packed(), 3, 0, 1.5f);
      break;
    case Swatch::clockwise:
    case Swatch::counterclockwise: {
      const bool clockwise = swatch == Swatch::clockwise;
      const Colour line = shade(clockwise ? t.clockwise_line : t.counter_line);
      list.AddRectFilled(low, high, line.at(0.16f).packed(), 3);
      hatch_swatch(list, low, high, line.at(0.8f), clockwise);
      break;
    }
    case Swatch::chord:
      list.AddLine(ImVec2(low.x, y), ImVec2(high.x, y), shade(t.chord).packed(), 2);
      list.AddCircleFilled(ImVec2(low.x + 2, y), 3, shade(t.text).packed(), 12);
      list.AddCircleFilled(ImVec2(high.x - 2, y), 3, shade(t.text).packed(), 12);
      break;
    case Swatch::tipping:
      for (int i = 0; i < 4; ++i) {
        const float left = low.x + 4 * static_cast<float>(i);
        const Colour band =
            on ? t.heat[2 * i] : t.quiet.at(0.2f + 0.15f * static_cast<float>(3 - i));
        list.AddRectFilled(ImVec2(left, low.y), ImVec2(left + 4, high.y), band.packed());
      }
      break;
    case Swatch::halo:
      list.AddCircleFilled(ImVec2(low.x + 8, y), 2.5f, shade(t.text).packed(), 12);
      for (int i = 0; i < 8; ++i) {
        const float from = static_cast<float>(i) * 0.785f;
        list.PathArcTo(ImVec2(low.x + 8, y), 7, from, from + 0.5f, 4);
        list.PathStroke(shade(t.hull_outline).packed(), 0, 1.5f);
      }
      break;
    case Swatch::tilt:
      for (const float radius : {3.0f, 7.0f})
        list.AddCircle(ImVec2(low.x + 8, y), radius, shade(t.hull_outline).packed(), 20, 1.5f);
      break;
    case Swatch::load:
      list.AddCircleFilled(ImVec2(low.x + 8, low.y + 4), 3, shade(t.hull_outline).packed(), 16);
      list.AddRectFilled(ImVec2(low.x + 4, low.y + 8), ImVec2(low.x + 12, high.y),
                         shade(t.hull_outline).packed(), 3);
      break;
    case Swatch::candidate:
      for (const float x : {0.0f, 6.0f, 12.0f}) {
        list.AddLine(ImVec2(low.x + x, y), ImVec2(low.x + x + 3.5f, y),
                     shade(t.second_text).packed(), 1.4f);
      }
      break;
  }
}

}  // namespace

bool chip(const Ui& ui, const char* id, Swatch swatch, const char* label, bool on, bool enabled) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control() - 2;
  const Area a =
      area(ui, ImVec2(16 + 9 + 6 + text.x + 11, height), pressed_control(id, label, enabled, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour fill = a.hovered ? ui.theme.panel_line : on ? ui.theme.well : ui.theme.panel;
  list.AddRectFilled(a.low, a.high, fill.packed(), height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.text : ui.theme.quiet).packed(), height / 2, 0, 1);
  const float y = a.middle().y;
  draw_swatch(ui, swatch, ImVec2(a.low.x + 9, y - 8), on);
  draw_text(list, Face::label, ImVec2(a.low.x + 31, y - text.y / 2),
            !enabled ? ui.theme.quiet
            : on     ? ui.theme.text
                     : ui.theme.second_text,
            label);
  return a.pressed;
}

}  // namespace evenlift::view
