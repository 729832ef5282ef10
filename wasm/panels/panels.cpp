#include "panels/panels.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "actions/actions.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

bool compares(const AppState& s) {
  return s.derived().second.has_value() && s.work.second_method.has_value();
}

bool shows_forces(const AppState& s) {
  return shown(s).overlays.tipping && (!walkthrough_is_open(s) || knows_base(s));
}
bool has_score(const AppState& s) {
  return s.derived().placement && settings(s).method == Method::given && !s.view.challenge;
}

// The answer, three controls, and the loads; then all else that can be set. Nothing that is pressed
// moves because a result changes.
constexpr Panel side_panel[] = {
    {"verdict", draw_verdict, false},
    {"settings", draw_controls, false},
    {"weighing", draw_weighing, true, when::is_weighed},
    {"comparison", draw_comparison, true, compares},
    {"forces", draw_heat_key, true, shows_forces},
    {"teams", draw_teams, true},
    {"score", draw_score, true, has_score},
    {"drawers", draw_drawers, false},
    {"numbers", draw_numbers, true},
};
bool ranks(const AppState& s) {
  const auto& scores = s.view.walkthrough.detail.scores;
  return scores && !scores->ranking.empty();
}
bool has_history(const AppState& s) { return s.view.walkthrough.visited.size() > 1; }
bool is_formal(const AppState& s) { return s.view.formal_open; }
constexpr Panel walkthrough_panel[] = {
    {"step", draw_walkthrough_step, true},
    {"forces", draw_heat_key, true, shows_forces},
    {"ranking", draw_walkthrough_ranking, true, ranks},
    {"code", draw_walkthrough_code, true, is_formal},
    {"settings", draw_controls, false},
    {"weighing", draw_weighing, true, when::is_weighed},
    {"drawers", draw_drawers, false},
    {"history", draw_walkthrough_history, true, has_history},
};

std::span<const Panel> sections(const AppState& state) {
  if (walkthrough_is_open(state)) return walkthrough_panel;
  return side_panel;
}

// The last result stays while the document is refused.
void dim(const Ui& ui, ImVec2 from) {
  const float right = from.x + ImGui::GetContentRegionAvail().x + 6;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(from.x - 6, from.y),
                                            ImVec2(right, ImGui::GetCursorScreenPos().y),
                                            ui.theme.panel.at(0.65f).packed());
}

void draw_sections(const Ui& ui, std::size_t first) {
  const std::span<const Panel> panels = sections(ui.state);
  for (std::size_t i = first; i < panels.size(); ++i) {
    if (panels[i].shown && !panels[i].shown(ui.state)) continue;
    // Results of the former shape would be mistaken for those of the new one.
    if (panels[i].of_result && draws(ui.state.view.tool)) continue;
    if (i > first) rule(ui);
    ImGui::PushID(panels[i].name);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    panels[i].draw(ui);
    if (panels[i].of_result && ui.state.derived().refusal) dim(ui, from);
    ImGui::PopID();
  }
}

// In the corner of the panel, above its content.
void draw_fold_button(const Ui& ui, Icon icon, bool open, const char* about) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ui.control() - 8;
  ImGui::SetCursorScreenPos(ImVec2(right, ImGui::GetWindowPos().y + 8 - ImGui::GetScrollY()));
  if (icon_button(ui, "fold", icon, true, about, ui.control())) ui.push(SetPanelOpen{open});
  ImGui::SetCursorScreenPos(at);
}

void draw_close_button(const Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ui.control() - 8;
  ImGui::SetCursorScreenPos(ImVec2(right, ImGui::GetWindowPos().y + 8 - ImGui::GetScrollY()));
  if (icon_button(ui, "leave", Icon::close, true, "Leave the walkthrough (B)", ui.control()))
    ui.push(CloseWalkthrough{});
  ImGui::SetCursorScreenPos(at);
}

// Scrolls to the head when the user opens a document, or begins or leaves a lesson.
void begin_at_head(const Ui& ui) {
  const int shown = 2 * ui.state.session.opened + (walkthrough_is_open(ui.state) ? 1 : 0);
  if (in_last_frame("shows", shown, shown) != shown) ImGui::SetScrollY(0);
}

// The verdict stays visible while the rest scrolls, to show the effect of a changed setting.
void draw_verdict_and_rest(const Ui& ui) {
  draw_verdict(ui);
  rule(ui);
  const float padding = ImGui::GetStyle().WindowPadding.y,
              room =
                  static_cast<float>(ui.layout.panel.height()) - ImGui::GetCursorPosY() - padding;
  float& content = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("content"), room);
  begin_scrolling_box(ui, "below the verdict", std::min(content, room));
  begin_at_head(ui);
  draw_sections(ui, 1);
  const float now = ImGui::GetCursorPosY();
  if (std::exchange(content, now) != now) ui.push(LayOutAgain{});
  end_scrolling_box(ui);
}

void draw_side_panel(const Ui& ui) {
  // High enough for most settings below the verdict.
  constexpr double least_height = 560;
  const bool lesson = walkthrough_is_open(ui.state),
             stays = !lesson && ui.layout.panel.height() >= least_height;
  begin_card(ui, "panel", ui.layout.panel, {.scrolls = !stays, .stays_below = true});
  if (!stays) begin_at_head(ui);
  if (lesson)
    draw_close_button(ui);
  else
    draw_fold_button(ui, Icon::fold, false, "Fold the panel away (P)");
  if (stays)
    draw_verdict_and_rest(ui);
  else
    draw_sections(ui, 0);
  end_card(ui);
}

void draw_rail(const Ui& ui) {
  const Rect place{ui.layout.panel.left, ui.layout.panel.top, ui.layout.panel.right,
                   ui.layout.panel.top + ui.layout.control + 16};
  begin_card(ui, "rail", place, {.fixed_height = true, .padding = 8, .scrolls = false});
  if (icon_button(ui, "unfold", Icon::unfold, true, "Show the panel (P)", ui.control()))
    ui.push(SetPanelOpen{true});
  end_card(ui);
}

constexpr float handle_height = 24;

Sheet opened_further(const AppState& state, int by) {
  auto wanted = static_cast<Sheet>(std::clamp(static_cast<int>(state.view.sheet) + by, 0, 2));
  if (wanted == Sheet::half && !has_half_sheet(state))
    wanted = by > 0 ? Sheet::full : Sheet::closed;
  return wanted;
}

// A press opens the sheet further or closes it; a drag pulls it.
void draw_handle(const Ui& ui) {
  ImGui::SetCursorPosY(4);
  const float width = ImGui::GetContentRegionAvail().x;
  const auto [low, high, pressed, hovered] =
      pressable_row(ui, "handle", "Open the sheet further", width, handle_height);
  const float dragged = ImGui::GetIO().MousePos.y - ImGui::GetIO().MouseClickedPos[0].y;
  if (ImGui::IsItemDeactivated() && std::abs(dragged) > 24) {
    const int step = std::abs(dragged) > 260 ? 2 : 1;
    ui.push(SetSheet{opened_further(ui.state, dragged < 0 ? step : -step)});
  } else if (pressed) {
    ui.push(
        SetSheet{ui.state.view.sheet == Sheet::full ? Sheet::closed : opened_further(ui.state, 1)});
  }
}

void draw_grip(const Ui& ui) {
  const ImVec2 low = ImGui::GetWindowPos();
  const float middle = low.x + ImGui::GetWindowWidth() / 2;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(middle - 20, low.y + 10), ImVec2(middle + 20, low.y + 14),
                     ui.theme.quiet.packed(), 2);
}

// The step's words in the remaining height, and one row of buttons.
void draw_step_and_row(const Ui& ui) {
  constexpr float gap = 4;
  draw_walkthrough_briefly(ui, ImGui::GetContentRegionAvail().y - ui.control() - gap);
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ImGui::GetStyle().WindowPadding.y - ui.control());
  draw_player_row(ui);
}

// Controls of the selected vertex or the next edge replace the teams here: over the drawing, they
// would cover it.
void draw_row_below_verdict(const Ui& ui) {
  if (vertex_is_on_sheet(ui)) return draw_vertex_buttons(ui);
  if (!draws(ui.state.view.tool)) return draw_teams_stepper(ui);
  // The row keeps its place before the first vertex.
  if (ui.state.view.drawing.points.empty()) return ImGui::Dummy(ImVec2(1, ui.control()));
  const float labels = text_size(Face::label, "Length").x + text_size(Face::label, "Angle").x;
  const float width = (ImGui::GetContentRegionAvail().x - labels - 20) / 2;
  draw_edge_fields(ui, width, width);
}

// With little height, for example above a keyboard, the row is at the foot, and only an open sheet
// shows the failures.
void draw_low_sheet(const Ui& ui) {
  draw_verdict_words(ui);
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ImGui::GetStyle().WindowPadding.y - ui.control());
  draw_row_below_verdict(ui);
}

void draw_closed_sheet(const Ui& ui) {
  if (ui.layout.bare) return;
  if (walkthrough_is_open(ui.state))
    return ui.layout.brief ? draw_player_row(ui) : draw_step_and_row(ui);
  constexpr double too_low = 8;  // pixels of the row's margin that may be missing
  if (!ui.layout.brief && ui.state.session.closed_sheet_height > ui.layout.panel.height() + too_low)
    return draw_low_sheet(ui);
  draw_verdict(ui);
  draw_row_below_verdict(ui);
  if (ui.layout.brief) return;
  const double height =
      static_cast<double>(ImGui::GetItemRectMax().y - ImGui::GetWindowPos().y) + 16;
  if (std::abs(height - ui.state.session.closed_sheet_height) > 0.5) ui.push(MeasureSheet{height});
}

void draw_open_sheet(const Ui& ui) {
  const bool lesson = walkthrough_is_open(ui.state);
  if (lesson)
    draw_player_row(ui);
  else
    draw_headline(ui);
  begin_scrolling_box(ui, "below the headline", ImGui::GetContentRegionAvail().y);
  begin_at_head(ui);
  if (lesson) {
    draw_walkthrough_step(ui);
  } else {
    draw_verdict_details(ui);
    draw_row_below_verdict(ui);
  }
  rule(ui);
  draw_sections(ui, 1);
  end_scrolling_box(ui);
}

void draw_sheet(const Ui& ui) {
  begin_card(ui, "sheet", ui.layout.panel,
             {.fixed_height = true, .padding = 16, .scrolls = false, .stays_below = true});
  draw_handle(ui);
  ImGui::SetCursorPosY(handle_height + 6);
  if (ui.state.view.sheet == Sheet::closed)
    draw_closed_sheet(ui);
  else
    draw_open_sheet(ui);
  draw_grip(ui);
  end_card(ui);
}

void draw_floating_player(const Ui& ui) {
  const bool tells = ui.state.session.screen.embed || presents_steps(ui.state);
  begin_card(ui, "player", ui.layout.player,
             {.fixed_height = true,
              .padding = ui.state.session.screen.embed ? 8.0f : 12.0f,
              .scrolls = false});
  if (tells)
    draw_step_and_row(ui);
  else
    draw_player(ui);
  end_card(ui);
}

}  // namespace

void draw_panels(const AppState& state, const Layout& places, Commands& commands) {
  begin_controls();
  apply_style(state, places.control);
  Pick row;
  const Ui ui{state, theme(state), places, commands, row};
  if (!state.session.screen.embed && !presents_steps(state)) {
    if (!places.wide)
      draw_sheet(ui);
    else if (state.view.panel_open)
      draw_side_panel(ui);
    else
      draw_rail(ui);
    draw_view_tools(ui);
  }
  if (walkthrough_is_open(state) &&
      (places.wide || state.session.screen.embed || presents_steps(state)))
    draw_floating_player(ui);
  else if (state.session.screen.embed)
    draw_embedded_verdict(ui);
  if (!state.session.screen.embed && !presents_steps(state)) {
    draw_toolbar(ui);
    draw_tool_bar(ui);
  }
  draw_way_back(ui);
  draw_why_card(ui);
  draw_notice(ui);
  const bool list_open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (list_open != state.session.list_open) ui.push(ListIsOpen{list_open});
  // A finger cannot hover.
  const bool hovers = ImGui::GetIO().WantCaptureMouse && !state.session.screen.touch;
  if (hovers && !(row == state.view.hover)) ui.push(SetHover{row});
}

}  // namespace evenlift::view
