// The list of keys, from the table of actions.
#include <algorithm>
#include <vector>

#include "actions/actions.h"
#include "panels/panels.h"
#include "ui/widgets.h"

namespace evenlift::view {
namespace {

void key_row(const Ui& ui, const char* label, const char* keys, float width) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(low.x, low.y + 5), ui.theme.text, label);
  const ImVec2 size = text_size(Face::strong_label, keys);
  const ImVec2 box(low.x + width - size.x - 14, low.y + 1);
  list.AddRectFilled(box, ImVec2(low.x + width, low.y + 25), ui.theme.well.packed(), 5);
  draw_text(list, Face::strong_label, ImVec2(box.x + 7, low.y + 5), ui.theme.text, keys);
  ImGui::Dummy(ImVec2(width, 26));
}

// In one column or two, read downwards.
void key_table(const Ui& ui, int columns) {
  std::vector<const Action*> rows;
  for (const Action& a : actions()) {
    if (*a.shown) rows.push_back(&a);
  }
  const float gap = 32;
  const float width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) /
                      static_cast<float>(columns);
  const std::size_t each =
      (rows.size() + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns);
  for (std::size_t from = 0; from < rows.size(); from += each) {
    if (from > 0) ImGui::SameLine(0, gap);
    ImGui::BeginGroup();
    for (std::size_t i = from; i < std::min(from + each, rows.size()); ++i) {
      key_row(ui, rows[i]->label, rows[i]->shown, width);
    }
    ImGui::EndGroup();
  }
}

}  // namespace

void draw_help(const Ui& ui) {
  if (!ui.state.help_open) return;
  const Screen& screen = ui.state.screen;
  const bool two = ui.layout.free.width() >= 760;
  const double width = std::min(two ? 740.0 : 380.0, screen.width - 16),
               height = screen.height - 96;
  const double left = (ui.layout.wide ? ui.layout.free.middle().x() : screen.width / 2) - width / 2;
  begin_card(ui, "help", {left, 80, left + width, 80 + height});
  ImGui::SetWindowFocus();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  text_line(Face::verdict, ui.theme.text, "Keys");
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ImGui::GetContentRegionAvail().x - 32, at.y - 6));
  if (icon_button(ui, "close", Icon::close, true, "Close (Esc)", 32)) ui.push(SetHelpOpen{false});
  ImGui::SetCursorScreenPos(after);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 2));
  key_table(ui, two ? 2 : 1);
  rule(ui);
  text_block(
      Face::label, ui.theme.second_text,
      "Drag a vertex or the centre of mass. Drag the ground to move the view; scroll or pinch to zoom. Double-click an edge to add a vertex. Ctrl is Cmd on a Mac.");
  ImGui::PopStyleVar();
  end_card(ui);
}

}  // namespace evenlift::view
