// The result in numbers, each with its meaning.
#include "evenlift/output/quantities.h"
#include "panels/panels.h"
#include "ui/controls.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

void fact(const Ui& ui, const char* label, const std::string& value, const char* about) {
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(label);
  ImGui::InvisibleButton("fact", ImVec2(width, 21));
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(low.x, low.y + 2), ui.theme.second_text, label);
  const ImVec2 size = text_size(Face::strong_label, value);
  draw_text(list, Face::strong_label, ImVec2(low.x + width - size.x, low.y + 2), ui.theme.text,
            value);
  list_text(label, value);
  if (ImGui::IsItemHovered()) tip(ui, about);
}

}  // namespace

void draw_numbers(const Ui& ui) {
  if (!ui.state.derived().placement) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (const Fact& each : facts_in_words(reported(ui.state)))
    fact(ui, each.label, each.value, each.about);
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
