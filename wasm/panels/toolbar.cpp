// The cards over the drawing: the bar at the top, the tools of the view, the notice.
#include <algorithm>

#include "panels/action_button.h"
#include "panels/panels.h"
#include "state/browser.h"
#include "ui/widgets.h"

namespace evenlift::view {
namespace {

void wordmark(const Ui& ui, float height) {
  const ImVec2 size = text_size(Face::strong, "evenlift"), at = ImGui::GetCursorScreenPos();
  draw_centre_mark(*ImGui::GetWindowDrawList(), ImVec2(at.x + 15, at.y + height / 2), 8,
                   ui.theme.text, ui.theme.panel);
  draw_text(*ImGui::GetWindowDrawList(), Face::strong,
            ImVec2(at.x + 30, at.y + (height - size.y) / 2), ui.theme.text, "evenlift");
  ImGui::Dummy(ImVec2(size.x + 38, height));
}

// The button of an action, with its name if `named`.
void tool_button(const Ui& ui, ActionId id, float size, bool named) {
  if (named)
    named_action_button(ui, id, size);
  else
    action_button(ui, id, size);
}

void divider(const Ui& ui, float height) {
  if (ui.layout.toolbar.width() < 440) return ImGui::SameLine(0, 0);
  ImGui::SameLine(0, 6);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(at.x, at.y + 6), ImVec2(at.x + 1, at.y + height - 6), ui.theme.panel_line.packed());
  ImGui::Dummy(ImVec2(1, height));
  ImGui::SameLine(0, 6);
}

void draw_embedded_bar(const Ui& ui) {
  begin_card(ui, "bar", ui.layout.toolbar, {.fixed_width = false, .padding = 4});
  if (text_button(ui, "out", Icon::open_out, "Open in evenlift", nullptr, 32)) browser::open_page();
  end_card(ui);
}

}  // namespace

void draw_toolbar(const Ui& ui) {
  if (ui.state.screen.embed) return draw_embedded_bar(ui);
  // On a phone eight buttons just fit; the list of keys is of no use there.
  const float all = static_cast<float>(ui.layout.toolbar.width()) - 4;
  const float height = ui.layout.wide ? ui.control() : std::clamp(all / 8, 40.0f, 44.0f),
              padding = ui.layout.wide ? 8.0f : 2.0f;
  begin_card(ui, "toolbar", ui.layout.toolbar, {.fixed_width = false, .padding = padding});
  if (ui.state.screen.width > 480) {
    wordmark(ui, height);
    divider(ui, height);
  }
  const double width = ui.layout.toolbar.width();
  const float gap = width < 440 ? 0.0f : 2.0f;
  for (const ActionId id :
       {ActionId::samples, ActionId::draw, ActionId::lessons, ActionId::open, ActionId::save}) {
    tool_button(ui, id, height, width > 700);
    ImGui::SameLine(0, gap);
  }
  divider(ui, height);
  action_button(ui, ActionId::undo, height);
  ImGui::SameLine(0, gap);
  action_button(ui, ActionId::redo, height);
  divider(ui, height);
  tool_button(ui, ActionId::copy_link, height, width > 560);
  if (width > 440) {
    ImGui::SameLine(0, gap);
    action_button(ui, ActionId::help, height);
  }
  end_card(ui);
}

void draw_view_tools(const Ui& ui) {
  begin_card(ui, "tools", ui.layout.tools,
             {.fixed_height = true, .padding = ui.layout.wide ? 8.0f : 2.0f, .scrolls = false});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 2));
  // A narrow screen has no room for these; two fingers do the same.
  if (ui.layout.wide) {
    action_button(ui, ActionId::zoom_out, ui.control());
    ImGui::SameLine(0, 2);
    action_button(ui, ActionId::zoom_in, ui.control());
    ImGui::SameLine(0, 2);
  }
  action_button(ui, ActionId::fit, ui.control());
  if (ui.layout.wide) divider(ui, ui.control());
  action_button(ui, ActionId::transform, ui.control());
  if (ui.layout.wide) ImGui::SameLine(0, 2);
  action_button(ui, ActionId::table, ui.control());
  ImGui::PopStyleVar();
  end_card(ui);
}

void draw_notice(const Ui& ui) {
  const Notice& notice = ui.state.notice;
  if (notice.text.empty()) return;
  const bool problem = notice.kind == Notice::Kind::problem;
  const double widest = std::min(ui.layout.free.width() - 2 * ui.layout.margin, 560.0);
  const float text =
      std::min(text_size(Face::text, notice.text).x, static_cast<float>(widest) - 84);
  const double width = text + 84, x = ui.layout.free.middle().x() - width / 2;
  begin_card(ui, "notice", {x, ui.layout.toolbar.bottom + 12, x + width, ui.layout.free.bottom},
             {.padding = 10});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(ImVec2(at.x + 11, at.y + 12), 11,
                       (problem ? ui.theme.amber : ui.theme.hull_outline).packed(), 24);
  draw_icon(list, problem ? Icon::warning : Icon::check, ImVec2(at.x + 11, at.y + 12), 15,
            ui.theme.panel);
  ImGui::SetCursorScreenPos(ImVec2(at.x + 32, at.y + 3));
  text_block(Face::text, ui.theme.text, notice.text, 30);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + static_cast<float>(width) - 20 - 24, at.y));
  if (icon_button(ui, "close", Icon::close, true, "Close (Esc)", 24)) ui.push(ShowNotice{});
  ImGui::SetCursorScreenPos(after);
  ImGui::Dummy(ImVec2(0, 0));
  end_card(ui);
}

}  // namespace evenlift::view
