#include "widgets/dropdown.h"

#include <algorithm>

#include "ui/controls.h"
#include "ui/drawn_texts.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"

namespace evenlift::view {

bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width) {
  const auto width = static_cast<float>(ui.state.session.screen.width),
             height = static_cast<float>(ui.state.session.screen.height);
  const float room_below = height - anchor_high.y - 16, room_above = anchor_low.y - 16;
  constexpr float enough = 340;  // for the longest list of the panel
  const bool below = room_below > enough || room_below >= room_above;
  // In the window's right half the list extends to the left, to stay inside.
  const bool leftwards = anchor_low.x + anchor_high.x > width;
  // A list too narrow for its longest row extends past its button to the right.
  constexpr float longest = 346;
  const float right = std::max(anchor_high.x, std::min(width - 8, longest));
  ImGui::SetNextWindowPos(
      ImVec2(leftwards ? right : anchor_low.x, below ? anchor_high.y + 6 : anchor_low.y - 6),
      ImGuiCond_Always, ImVec2(leftwards ? 1.0f : 0.0f, below ? 0.0f : 1.0f));
  const float widest = (leftwards ? right : width - anchor_low.x) - 8;
  ImGui::SetNextWindowSizeConstraints(
      ImVec2(std::min(least_width, widest), 0),
      ImVec2(std::min(widest, 420.0f), std::max(below ? room_below : room_above, 120.0f)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6, 6));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove)) {
    if (ui.state.session.close_list) ImGui::CloseCurrentPopup();
    sharpen(*ImGui::GetWindowDrawList(), ui.state);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    soft_shadow(ui, low, ImVec2(low.x + size.x, low.y + size.y));
    enter_list(true);
    return true;
  }
  ImGui::PopStyleVar(2);
  return false;
}

void end_choices(const Ui& ui) {
  enter_list(false);
  scroll_by_finger(ui);
  ImGui::EndPopup();
  ImGui::PopStyleVar(2);
}

bool choice(const Ui& ui, const std::string& label, const char* about, bool current, Icon icon,
            bool enabled, const std::string& name) {
  // On the smallest phones the longest rows do not fit in larger letters.
  const Face face = ui.state.session.screen.width < 344 ? Face::label : Face::text;
  const ImVec2 title = text_size(face, label);
  const ImVec2 word = about ? text_size(Face::label, about) : ImVec2(0, 0);
  const float height = std::max(ui.control(), about ? 50.0f : 0.0f);
  const float width = std::max(ImGui::GetContentRegionAvail().x, std::max(title.x, word.x) + 56);
  const PressableRow row =
      pressable_row(ui, (name.empty() ? label : name).c_str(), label, width, height, enabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (row.hovered) list.AddRectFilled(row.low, row.high, ui.theme.well.packed(), 7);
  const ImVec2 sign(row.low.x + 18, row.low.y + height / 2);
  const Colour ink = enabled ? ui.theme.text : ui.theme.quiet;
  draw_icon(list, icon, sign, 18, ink);
  if (current) draw_icon(list, Icon::check, sign, 15, ui.theme.accent);
  const float text = title.y + (about ? word.y + 3 : 0), y = row.low.y + (height - text) / 2;
  draw_text(list, face, ImVec2(row.low.x + 36, y), ink, label);
  if (about)
    draw_text(list, Face::label, ImVec2(row.low.x + 36, y + title.y + 3), ui.theme.second_text,
              about);
  if (row.pressed) ImGui::CloseCurrentPopup();
  return row.pressed;
}

namespace {

bool dropdown_button(const Ui& ui, const std::string& label, float width) {
  const bool pressed = tapped(ui, ImGui::InvisibleButton("open", ImVec2(width, ui.control())));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, (hovered ? ui.theme.panel_line : ui.theme.well).packed(), 7);
  const ImVec2 text = text_size(Face::text, label);
  note_room(label, text.x, width - 12 - 24);
  draw_text(list, Face::text, ImVec2(low.x + 12, (low.y + high.y - text.y) / 2), ui.theme.text,
            label);
  draw_icon(list, Icon::down, ImVec2(high.x - 18, (low.y + high.y) / 2), 12, ui.theme.second_text);
  return pressed;
}

Control choice_control(const char* id, const char* label, std::span<const Choice> choices,
                       std::size_t current) {
  Control control;
  control.kind = ControlKind::choice;
  control.name = id;
  control.label = label;
  for (const Choice& c : choices) control.choices.emplace_back(c.label);
  control.current = current;
  return control;
}

}  // namespace

std::optional<std::size_t> dropdown(const Ui& ui, const char* id, const char* label,
                                    std::span<const Choice> choices, std::size_t current,
                                    float width) {
  ImGui::PushID(id);
  const bool pressed = dropdown_button(ui, choices[current].label, width);
  const Asked asked = list_control(choice_control(id, label, choices, current));
  if (pressed || asked.pressed) ImGui::OpenPopup("list");
  std::optional<std::size_t> chosen = asked.chosen;
  if (begin_choices(ui, "list", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), width)) {
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (choice(ui, choices[i].label, choices[i].about, i == current)) chosen = i;
    end_choices(ui);
  }
  ImGui::PopID();
  return chosen;
}

}  // namespace evenlift::view
