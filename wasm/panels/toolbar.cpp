// The cards over the drawing: the toolbar, the view tools, the notice.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "evenlift/wording.h"
#include "panels/action_button.h"
#include "panels/panels.h"
#include "state/seen.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/dropdown.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

float wordmark_width() { return text_size(Face::strong, "evenlift").x + 38; }

void wordmark(const Ui& ui, float height) {
  const ImVec2 size = text_size(Face::strong, "evenlift"), at = ImGui::GetCursorScreenPos();
  draw_centre_mark(*ImGui::GetWindowDrawList(), ImVec2(at.x + 15, at.y + height / 2), 8,
                   ui.theme.text, ui.theme.panel);
  draw_text(*ImGui::GetWindowDrawList(), Face::strong,
            ImVec2(at.x + 30, at.y + (height - size.y) / 2), ui.theme.text, "evenlift");
  ImGui::Dummy(ImVec2(wordmark_width(), height));
}

// If not all buttons fit, the last are in the toolbar's menu.
struct Part {
  ActionId id;
  bool named;         // its name is beside it if there is room
  bool begins_group;  // after a line
};
constexpr Part parts[] = {
    {ActionId::samples, true, false},  {ActionId::draw, true, false},
    {ActionId::undo, false, true},     {ActionId::redo, false, false},
    {ActionId::copy_link, true, true}, {ActionId::lessons, true, true},
    {ActionId::open, true, false},     {ActionId::save, true, false},
};

// From the widest to the narrowest.
struct Look {
  bool wordmark, names, dividers;
  std::size_t shown;  // of `parts`
};
constexpr Look looks[] = {
    {true, true, true, 8},    {false, true, true, 8},   {true, false, true, 8},
    {true, false, false, 8},  {false, false, false, 8}, {false, false, false, 7},
    {false, false, false, 6}, {false, false, false, 5}, {false, false, false, 4},
    {false, false, false, 3}, {false, false, false, 2}, {false, false, false, 1},
};

constexpr float gap = 2, beside_divider = 6;

float divider_width(const Look& look) { return look.dividers ? 2 * beside_divider + 1 : gap; }

float width_of(const Look& look, float height, float padding) {
  float width = 2 * padding + gap + height;  // with the menu's button
  if (look.wordmark) width += wordmark_width() + divider_width(look);
  for (std::size_t i = 0; i < look.shown; ++i) {
    const Part& part = parts[i];
    if (i > 0) width += part.begins_group ? divider_width(look) : gap;
    width += look.names && part.named ? text_button_width(action(part.id).label) : height;
  }
  return width;
}

const Look& widest_that_fits(float room, float height, float padding) {
  const auto* found = std::find_if(std::begin(looks), std::end(looks), [&](const Look& look) {
    return width_of(look, height, padding) <= room;
  });
  return found == std::end(looks) ? std::end(looks)[-1] : *found;
}

void divider(const Ui& ui, float height, bool drawn) {
  if (!drawn) return ImGui::SameLine(0, gap);
  ImGui::SameLine(0, beside_divider);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(at.x, at.y + 6), ImVec2(at.x + 1, at.y + height - 6), ui.theme.panel_line.packed());
  ImGui::Dummy(ImVec2(1, height));
  ImGui::SameLine(0, beside_divider);
}

bool has_tools(const Ui& ui) { return ui.layout.tools.width() > 0; }

// Actions without room elsewhere, and seldom-used ones.
void draw_menu(const Ui& ui, const Look& look) {
  if (!begin_choices(ui, "menu", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), 0)) return;
  for (std::size_t i = look.shown; i < std::size(parts); ++i) action_row(ui, parts[i].id);
  if (!has_tools(ui))
    for (const ActionId id : {ActionId::fit, ActionId::transform, ActionId::table})
      action_row(ui, id);
  if (!has_tools(ui) || !ui.layout.wide) action_row(ui, ActionId::add_robots);
  if (!has_tools(ui) || !ui.layout.wide)
    for (const ActionId id : {ActionId::zoom_in, ActionId::zoom_out}) action_row(ui, id);
  if (snaps_in_menu(ui)) draw_snap_choices(ui);
  for (const ActionId id :
       {ActionId::walkthrough, ActionId::present, ActionId::experiment, ActionId::glossary,
        ActionId::welcome, ActionId::help, ActionId::about, ActionId::language})
    action_row(ui, id);
  end_choices(ui);
}

}  // namespace

void draw_toolbar(const Ui& ui) {
  const float height = ui.control(), padding = static_cast<float>(ui.layout.bar_padding);
  const Look& look =
      widest_that_fits(static_cast<float>(ui.layout.toolbar.width()), height, padding);
  begin_card(ui, "toolbar", ui.layout.toolbar,
             {.fixed_width = false, .padding = padding, .scrolls = false});
  if (look.wordmark) {
    wordmark(ui, height);
    divider(ui, height, look.dividers);
  }
  for (std::size_t i = 0; i < look.shown; ++i) {
    if (i > 0) divider(ui, height, parts[i].begins_group && look.dividers);
    if (look.names && parts[i].named)
      named_action_button(ui, parts[i].id, height);
    else
      action_button(ui, parts[i].id, height);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(ui, "more", Icon::more, true, "More", height)) ImGui::OpenPopup("menu");
  draw_menu(ui, look);
  end_card(ui);
}

// As a percentage of the view that fits, which a press restores.
void draw_zoom(const Ui& ui) {
  const std::string zoom = zoom_in_words(ui.state);
  const auto [low, high, pressed, hovered] =
      pressable_row(ui, "zoom", say("{zoom}: show the whole object", {zoom}),
                    static_cast<float>(zoom_width), ui.control());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered) list.AddRectFilled(low, high, ui.theme.panel_line.packed(), 7);
  const ImVec2 text = text_size(Face::label, zoom);
  draw_text(list, Face::label, ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2),
            ui.theme.text, zoom);
  if (pressed) ui.push(FitView{});
}

void draw_view_tools(const Ui& ui) {
  if (!has_tools(ui)) return;
  begin_card(ui, "tools", ui.layout.tools,
             {.fixed_height = true,
              .padding = static_cast<float>(ui.layout.bar_padding),
              .scrolls = false});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 2));
  // A narrow screen has no room for these; there, two fingers zoom.
  if (ui.layout.wide) {
    action_button(ui, ActionId::zoom_out, ui.control());
    ImGui::SameLine(0, 2);
    draw_zoom(ui);
    ImGui::SameLine(0, 2);
    action_button(ui, ActionId::zoom_in, ui.control());
    ImGui::SameLine(0, 2);
  }
  action_button(ui, ActionId::fit, ui.control());
  if (ui.layout.wide) divider(ui, ui.control(), true);
  if (ui.layout.wide && !walkthrough_is_open(ui.state)) {
    action_button(ui, ActionId::add_robots, ui.control());
    ImGui::SameLine(0, 2);
  }
  action_button(ui, ActionId::transform, ui.control());
  if (ui.layout.wide) ImGui::SameLine(0, 2);
  action_button(ui, ActionId::table, ui.control());
  ImGui::PopStyleVar();
  end_card(ui);
}

// Leads to an object outside the window or completely around it.
void draw_way_back(const Ui& ui) {
  if (ui.state.view.camera_follows || draws(ui.state.view.tool) || !ui.state.derived().placement)
    return;
  if (!ui.layout.wide && ui.state.view.sheet == Sheet::full) return;  // it covers the drawing
  if (outline_is_seen(ui.state)) return;
  const Rect& free = ui.layout.free;
  const float width = text_size(Face::text, "Show the object").x + 28;
  const double left = free.middle().x - static_cast<double>(width) / 2 - 8,
               top = free.middle().y - ui.layout.control / 2 - 8;
  begin_card(ui, "way back", {left, top, free.right, free.bottom},
             {.fixed_width = false, .padding = 8, .scrolls = false});
  if (flat_button(ui, "show object", "Show the object", width, true, true)) ui.push(FitView{});
  end_card(ui);
}

void draw_notice(const Ui& ui) {
  const Notice& notice = ui.state.session.notice;
  if (notice.text.empty()) return;
  const bool problem = notice.kind == Notice::Kind::problem;
  const Rect& seat = ui.layout.notice;
  // A long notice in large letters would cover half of a phone's drawing.
  const Face face = ui.layout.wide ? Face::text : Face::label;
  const float text =
      std::min(text_size(face, notice.text).x, static_cast<float>(seat.width()) - 84);
  const double width = static_cast<double>(text) + 84, x = seat.middle().x - width / 2;
  begin_card(ui, "notice", {x, seat.top, x + width, seat.bottom},
             {.at_bottom = true, .padding = 10});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(ImVec2(at.x + 11, at.y + 12), 11,
                       (problem ? ui.theme.amber : ui.theme.hull_outline).packed(), 24);
  draw_icon(list, problem ? Icon::warning : Icon::check, ImVec2(at.x + 11, at.y + 12), 15,
            ui.theme.panel);
  ImGui::SetCursorScreenPos(ImVec2(at.x + 32, at.y + 3));
  text_block(face, ui.theme.text, notice.text, 30);
  if (!notice.undo.empty()) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + 32, ImGui::GetCursorScreenPos().y + 4));
    if (flat_button(ui, "undo offered", notice.undo.c_str(),
                    text_button_width(notice.undo.c_str())))
      ui.push(Undo{});
  }
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + static_cast<float>(width) - 20 - 24, at.y));
  if (icon_button(ui, "close", Icon::close, true, "Close (Esc)", 24)) ui.push(ShowNotice{});
  ImGui::SetCursorScreenPos(after);
  ImGui::Dummy(ImVec2(0, 0));
  const double height = static_cast<double>(ImGui::GetWindowHeight());
  if (std::abs(height - ui.state.session.notice_height) > 0.5) ui.push(MeasureNotice{height});
  end_card(ui);
}

}  // namespace evenlift::view
