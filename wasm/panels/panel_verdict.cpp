// The verdict: a large sentence, and an icon that says the same without words.
#include "panels/panels.h"
#include "panels/summary.h"
#include "ui/widgets.h"

namespace evenlift::view {

namespace {

struct Sign {
  Icon icon;
  Colour disc;
};

Sign sign_of(const Theme& theme, Mood mood) {
  switch (mood) {
    case Mood::good:
      return {Icon::check, theme.hull_outline};
    case Mood::not_quite:
      return {Icon::warning, theme.amber};
    case Mood::refused:
      return {Icon::stop, theme.amber};
    case Mood::drawing:
      break;
  }
  return {Icon::draw, theme.accent};
}

}  // namespace

void draw_verdict(const Ui& ui) {
  const Verdict v = verdict(ui.state);
  const Sign sign = sign_of(ui.theme, v.mood);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(ImVec2(at.x + 11, at.y + 14), 11, sign.disc.packed(), 32);
  draw_icon(list, sign.icon, ImVec2(at.x + 11, at.y + 14), 15, ui.theme.panel);

  ImGui::SetCursorScreenPos(ImVec2(at.x + 32, at.y));
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 4));
  // The fold button stands to the right of the first lines.
  text_block(Face::verdict, ui.theme.text, v.headline, ui.layout.wide ? ui.control() - 8 : 0);
  if (!v.detail.empty()) text_block(Face::text, ui.theme.second_text, v.detail);
  ImGui::PopStyleVar();
  ImGui::EndGroup();
}

}  // namespace evenlift::view
