// The result in numbers, each with a word on what it means.
#include "format.h"
#include "panels.h"
#include "widgets.h"

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
  if (ImGui::IsItemHovered()) tip(ui, about);
}

}  // namespace

void draw_numbers(const Ui& ui) {
  if (!ui.state.placement) return;
  const Placement& p = *ui.state.placement;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  fact(ui, "Coverage", fixed(p.coverage * 100, 1) + "\u202f%",
       "Share of the object inside the lifting base");
  if (p.loads) {
    const int decimals = decimals_for(p.loads->max);
    fact(ui, "Load, mean", weight(p.loads->mean, decimals), "Of all robots");
    fact(ui, "Load, greatest − least", weight(p.loads->spread, decimals),
         "How unevenly all robots share");
    fact(ui, "Greatest share in a team", fixed(p.loads->max_share * 100, 1) + "\u202f%",
         "50 % in a team that is perfectly even");
  }
  fact(ui, "Teams possible", std::to_string(p.candidates.size()),
       "One for each candidate chord with this load ratio; two robots each");
  fact(ui, "Form closure",
       p.closure.form_closure   ? "yes"
       : p.closure.second_order ? "second order"
                                : "no",
       "Whether the robots' touch alone keeps the object from moving in the plane");
  if (p.closure.margin) {
    fact(ui, "Closure margin", fixed(*p.closure.margin, 3),
         "Above 0 in form closure: how firmly it is held");
  }
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
