#include "widgets/buttons.h"

#include "ui/drawn_texts.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// The background shows hovering.
void ground(const Ui& ui, const Area& a, float rounding, Colour still) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour colour = a.active || a.hovered ? ui.theme.panel_line : still;
  list.AddRectFilled(a.low, a.high, colour.packed(), rounding);
}

}  // namespace

bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* about,
                 float size, Pressed on) {
  const Area a = area(ui, ImVec2(size, size), pressed_control(id, about ? about : id, enabled, on));
  ground(ui, a, 7, on == true ? ui.theme.accent.at(0.18f) : ui.theme.panel.at(0));
  const Colour colour = on == true ? ui.theme.accent
                        : enabled  ? ui.theme.text
                                   : ui.theme.quiet.at(0.6f);
  draw_icon(*ImGui::GetWindowDrawList(), icon, a.middle(), 18, colour);
  if (ImGui::IsItemHovered()) tip(ui, about);
  return a.pressed;
}

bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* about,
                 float height, Icon after, Pressed on) {
  const ImVec2 text = text_size(Face::text, label);
  const float before = icon == Icon::none ? 12.0f : 38.0f,
              behind = after == Icon::none ? 12.0f : 30.0f;
  const Area a =
      area(ui, ImVec2(before + text.x + behind, height), pressed_control(id, label, true, on));
  ground(ui, a, 7, on == true ? ui.theme.accent.at(0.18f) : ui.theme.panel.at(0));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = a.middle().y;
  const Colour ink = on == true ? ui.theme.accent : ui.theme.text;
  draw_icon(list, icon, ImVec2(a.low.x + 20, y), 18, ink);
  draw_text(list, Face::text, ImVec2(a.low.x + before, y - text.y / 2), ink, label);
  draw_icon(list, after, ImVec2(a.high.x - 18, y), 12, ui.theme.second_text);
  if (a.hovered && about) tip(ui, about);
  return a.pressed;
}

float text_button_width(const char* label) { return 38 + text_size(Face::text, label).x + 12; }
bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled,
                 bool strong, const char* spoken) {
  const Area a =
      area(ui, ImVec2(width, ui.control()), button_control(id, spoken ? spoken : label, enabled));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour still = strong && enabled ? ui.theme.accent : ui.theme.well;
  const Colour hovered = strong ? ui.theme.accent.at(0.88f) : ui.theme.panel_line;
  list.AddRectFilled(a.low, a.high, (a.hovered ? hovered : still).packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  note_room(label, text.x, width);
  const Colour ink = !enabled ? ui.theme.quiet : strong ? ui.theme.on_accent : ui.theme.text;
  draw_text(list, Face::text, ImVec2(a.middle().x - text.x / 2, a.middle().y - text.y / 2), ink,
            label);
  return a.pressed;
}

float switch_chip_width(const char* label) { return text_size(Face::label, label).x + 46; }
bool switch_chip(const Ui& ui, const char* label, bool on) {
  const ImVec2 text = text_size(Face::label, label);
  const float height = ui.control();
  const Area a =
      area(ui, ImVec2(switch_chip_width(label), height), toggle_control(label, label, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(a.low, a.high, (a.hovered ? ui.theme.panel_line : ui.theme.panel).packed(),
                     height / 2);
  list.AddRect(a.low, a.high, (on ? ui.theme.accent : ui.theme.quiet).packed(), height / 2, 0, 1);
  const float y = a.middle().y;
  const ImVec2 low(a.low.x + 8, y - 7), high(a.low.x + 32, y + 7);
  list.AddRectFilled(low, high, (on ? ui.theme.accent : ui.theme.quiet).packed(), 7);
  list.AddCircleFilled(ImVec2(on ? high.x - 7 : low.x + 7, y), 5, ui.theme.panel.packed(), 16);
  draw_text(list, Face::label, ImVec2(a.low.x + 38, y - text.y / 2), ui.theme.text, label);
  return a.pressed;
}

bool toggle_button(const Ui& ui, const char* id, const char* label, const char* about, float width,
                   bool on) {
  const Area a = area(ui, ImVec2(width, ui.control()), toggle_control(id, about, on));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour ground = on ? ui.theme.accent : a.hovered ? ui.theme.panel_line : ui.theme.well;
  list.AddRectFilled(a.low, a.high, ground.packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  note_room(label, text.x, width);
  draw_text(list, Face::text, ImVec2(a.middle().x - text.x / 2, a.middle().y - text.y / 2),
            on ? ui.theme.on_accent : ui.theme.text, label);
  if (a.hovered) tip(ui, about);
  return a.pressed;
}

PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled) {
  const Area a = area(ui, ImVec2(width, height), button_control(id, label.c_str(), enabled));
  return {a.low, a.high, a.pressed, a.hovered};
}

}  // namespace evenlift::view
