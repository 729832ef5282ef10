#include "widgets/fields.h"

#include <cmath>

#include "evenlift/wording.h"
#include "ui/icons.h"
#include "widgets/area.h"

namespace evenlift::view {
namespace {

// When pressed, and repeatedly while held.
bool repeats(const Ui& ui, const Area& a) {
  if (!a.active) return a.pressed && ImGui::GetIO().MouseDownDurationPrev[0] < 0.35f;
  const ImGuiIO& io = ImGui::GetIO();
  ui.push(LayOutAgain{});
  const float held = io.MouseDownDuration[0];
  if (held < 0.35f) return false;
  constexpr float every = 0.09f;
  return std::floor(held / every) > std::floor((held - io.DeltaTime) / every);
}

void draw_ground(const Ui& ui, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  list.AddRect(low, high, ui.theme.quiet.packed(), 7, 0, 1);
}

std::string cut_off(std::string text, float width) {
  if (text_size(Face::text, text).x <= width) return text;
  while (!text.empty() && text_size(Face::text, text + "…").x > width) {
    while (text.size() > 1 && (text.back() & 0xC0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

}  // namespace

int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options) {
  const float height = ui.control(), side = height + 4;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(id);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  int change = 0;
  const auto end = [&](const char* sign, const char* words, Icon icon, bool enabled, int by) {
    const std::string name = std::string(id) + ' ' + sign, label = say(words, {options.label});
    const Area a =
        area(ui, ImVec2(side, height), button_control(name.c_str(), label.c_str(), enabled));
    if (a.hovered || a.active) list.AddRectFilled(a.low, a.high, ui.theme.panel_line.packed(), 7);
    draw_icon(list, icon, a.middle(), 16, enabled ? ui.theme.text : ui.theme.quiet.at(0.6f));
    if (enabled && (a.asked.pressed || repeats(ui, a))) change = by;
  };
  end("-", "{setting}: less", Icon::minus, options.can_lower, -1);
  ImGui::SameLine(0, 0);
  const float middle = width - 2 * side;
  ImGui::Dummy(ImVec2(middle, height));
  if (*options.setting)
    list_control(number_control(id, options.label, options.setting, value, options.exact));
  ImGui::SameLine(0, 0);
  end("+", "{setting}: more", Icon::plus, options.can_raise, 1);
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  ImGui::PopID();
  return change;
}

void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width, const std::string& exact) {
  constexpr float pad = 10;
  ImGui::Dummy(ImVec2(width, ui.control()));
  list_control(number_control(id, label, setting, value, exact));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  draw_ground(ui, low, high);
  draw_text(*ImGui::GetWindowDrawList(), Face::text,
            ImVec2(low.x + pad, (low.y + high.y - text_size(Face::text, value).y) / 2),
            ui.theme.text, cut_off(value, width - 2 * pad));
}

void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour, const std::string& exact) {
  ImGui::Dummy(ImVec2(width, ui.control()));
  list_control(number_control(id, label, setting, value, exact));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(*ImGui::GetWindowDrawList(), Face::strong,
            ImVec2(high.x - text.x, (low.y + high.y - text.y) / 2), colour, value);
}

Asked typed_field(const Ui& ui, const TypedField& field, const std::string& value, float width) {
  const ImVec2 name = text_size(Face::label, field.label), from = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(from.x, from.y + (ui.control() - name.y) / 2),
            ui.theme.second_text, field.label);
  ImGui::SetCursorScreenPos(ImVec2(from.x + name.x + 6, from.y));
  ImGui::Dummy(ImVec2(width, ui.control()));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
               text = text_size(Face::strong, value);
  draw_ground(ui, low, high);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  Control control = number_control(field.id, field.label, "", value);
  control.is_length = field.is_length;
  return list_control(std::move(control));
}

}  // namespace evenlift::view
