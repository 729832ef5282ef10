#include "ui/dropdown.h"

#include <algorithm>

namespace evenlift::view {

bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width) {
  const float room = static_cast<float>(ui.state.screen.height) - anchor_high.y - 16;
  const bool below = room > 220;
  ImGui::SetNextWindowPos(ImVec2(anchor_low.x, below ? anchor_high.y + 6 : anchor_low.y - 6),
                          ImGuiCond_Always, ImVec2(0, below ? 0.0f : 1.0f));
  const float highest = below ? room : anchor_low.y - 16;
  ImGui::SetNextWindowSizeConstraints(ImVec2(least_width, 0),
                                      ImVec2(420, std::max(highest, 120.0f)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6, 6));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove)) {
    if (ui.state.close_list) ImGui::CloseCurrentPopup();
    sharpen(*ImGui::GetWindowDrawList(), ui.state);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    soft_shadow(ui, low, ImVec2(low.x + size.x, low.y + size.y));
    return true;
  }
  ImGui::PopStyleVar(2);
  return false;
}

void end_choices(const Ui& ui) {
  scroll_by_finger(ui);
  ImGui::EndPopup();
  ImGui::PopStyleVar(2);
}

bool choice(const Ui& ui, const std::string& label, const char* about, bool current) {
  const ImVec2 title = text_size(Face::text, label);
  const ImVec2 word = about ? text_size(Face::label, about) : ImVec2(0, 0);
  const float height = std::max(ui.control(), about ? 50.0f : 0.0f);
  const float width = std::max(ImGui::GetContentRegionAvail().x, std::max(title.x, word.x) + 56);
  ImGui::PushID(label.c_str());
  const bool chosen = tapped(ui, ImGui::InvisibleButton("choice", ImVec2(width, height)));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (current)
    draw_icon(list, Icon::check, ImVec2(low.x + 18, low.y + height / 2), 15, ui.theme.accent);
  const float text = title.y + (about ? word.y + 3 : 0), y = low.y + (height - text) / 2;
  draw_text(list, Face::text, ImVec2(low.x + 36, y), ui.theme.text, label);
  if (about)
    draw_text(list, Face::label, ImVec2(low.x + 36, y + title.y + 3), ui.theme.second_text, about);
  ImGui::PopID();
  if (chosen) ImGui::CloseCurrentPopup();
  return chosen;
}

void dropdown_button(const Ui& ui, const char* id, const std::string& label, float width) {
  ImGui::PushID(id);
  const bool pressed = tapped(ui, ImGui::InvisibleButton("open", ImVec2(width, ui.control())));
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, (hovered ? ui.theme.panel_line : ui.theme.well).packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  draw_text(list, Face::text, ImVec2(low.x + 12, (low.y + high.y - text.y) / 2), ui.theme.text,
            label);
  draw_icon(list, Icon::down, ImVec2(high.x - 18, (low.y + high.y) / 2), 12, ui.theme.second_text);
  if (pressed) ImGui::OpenPopup(id);
}

}  // namespace evenlift::view
