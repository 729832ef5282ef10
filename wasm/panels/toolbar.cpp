#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "state/screen.h"
#include "tools/pick.h"
#include "widgets/buttons.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// Nothing for actions without a tool.
std::optional<bool> is_on(ActionId id, const AppState& state) {
  if (id == ActionId::draw) return draws(state.view.tool) || state.view.tool == Tool::weight;
  if (id == ActionId::transform) return state.view.tool == Tool::transform;
  if (id == ActionId::add_robots) return state.view.tool == Tool::robot;
  if (id == ActionId::mark) return state.view.tool == Tool::mark;
  return std::nullopt;
}

}  // namespace

void action_button(const Ui& ui, ActionId id, float size) {
  const Action& a = action(id);
  if (icon_button(ui, a.label, a.icon, a.enabled(ui.state), tip(a, ui.state).c_str(), size,
                  is_on(id, ui.state)))
    a.run(ui.state, ui.commands);
}

void named_action_button(const Ui& ui, ActionId id, float size) {
  const Action& a = action(id);
  if (text_button(ui, a.label, a.icon, a.label, tip(a, ui.state).c_str(), size, Icon::none,
                  is_on(id, ui.state)))
    a.run(ui.state, ui.commands);
}

void action_row(const Ui& ui, ActionId id) {
  const Action& a = action(id);
  const bool keyed = *a.shown && !ui.state.session.screen.touch && !ui.state.session.screen.finger;
  const std::string name = keyed ? std::string(a.label) + " (" + a.shown + ")" : a.label;
  const std::string label = keyed ? say("{action} ({key})", {a.label, a.shown}) : a.label;
  if (choice(ui, label, nullptr, false, a.icon, a.enabled(ui.state), name))
    a.run(ui.state, ui.commands);
}

// --- The cards over the drawing: the toolbar, the view tools, the notice.

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
struct ToolbarLook {
  bool wordmark, names, dividers;
  std::size_t shown;  // of `parts`
};
constexpr ToolbarLook toolbar_looks[] = {
    {true, true, true, 8},    {false, true, true, 8},   {true, false, true, 8},
    {true, false, false, 8},  {false, false, false, 8}, {false, false, false, 7},
    {false, false, false, 6}, {false, false, false, 5}, {false, false, false, 4},
    {false, false, false, 3}, {false, false, false, 2}, {false, false, false, 1},
};

constexpr float tool_gap = 2, beside_divider = 6;

float divider_width(const ToolbarLook& look) {
  return look.dividers ? 2 * beside_divider + 1 : tool_gap;
}

float width_of(const ToolbarLook& look, float height, float padding) {
  float width = 2 * padding + tool_gap + height;  // with the menu's button
  if (look.wordmark) width += wordmark_width() + divider_width(look);
  for (std::size_t i = 0; i < look.shown; ++i) {
    const Part& part = parts[i];
    if (i > 0) width += part.begins_group ? divider_width(look) : tool_gap;
    width += look.names && part.named ? text_button_width(action(part.id).label) : height;
  }
  return width;
}

const ToolbarLook& widest_that_fits(float room, float height, float padding) {
  const auto* found = std::find_if(
      std::begin(toolbar_looks), std::end(toolbar_looks),
      [&](const ToolbarLook& look) { return width_of(look, height, padding) <= room; });
  return found == std::end(toolbar_looks) ? std::end(toolbar_looks)[-1] : *found;
}

void divider(const Ui& ui, float height, bool drawn) {
  if (!drawn) return ImGui::SameLine(0, tool_gap);
  ImGui::SameLine(0, beside_divider);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(at.x, at.y + 6), ImVec2(at.x + 1, at.y + height - 6), ui.theme.panel_line.packed());
  ImGui::Dummy(ImVec2(1, height));
  ImGui::SameLine(0, beside_divider);
}

bool has_tools(const Ui& ui) { return ui.layout.tools.width() > 0; }

// Actions without room elsewhere, and seldom-used ones.
void draw_menu(const Ui& ui, const ToolbarLook& look) {
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
  const ToolbarLook& look =
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
  ImGui::SameLine(0, tool_gap);
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
  // The button is beside the words if there is room: a second row would lift the picture.
  const float button = notice.undo.empty() ? 0 : text_button_width(notice.undo.c_str()) + 8,
              room = static_cast<float>(seat.width()) - 84, line = text_size(face, notice.text).x;
  const bool beside = button > 0 && ui.layout.wide && line + button <= room;
  const float text = std::min(line + (beside ? button : 0), room);
  const double width = static_cast<double>(text) + 84, x = seat.middle().x - width / 2;
  begin_card(ui, "notice", {x, seat.top, x + width, seat.bottom},
             {.at_bottom = true, .padding = 10});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hint = notice.kind == Notice::Kind::hint;
  list.AddCircleFilled(ImVec2(at.x + 11, at.y + 12), 11,
                       (problem ? ui.theme.amber
                        : hint  ? ui.theme.accent
                                : ui.theme.hull_outline)
                           .packed(),
                       24);
  draw_icon(list,
            problem ? Icon::warning
            : hint  ? Icon::help
                    : Icon::check,
            ImVec2(at.x + 11, at.y + 12), 15, ui.theme.panel);
  ImGui::SetCursorScreenPos(ImVec2(at.x + 32, at.y + 3));
  text_block(face, ui.theme.text, notice.text, 30);
  if (!notice.undo.empty()) {
    ImGui::SetCursorScreenPos(beside ? ImVec2(at.x + 32 + line + 8, at.y + 12 - ui.control() / 2)
                                     : ImVec2(at.x + 32, ImGui::GetCursorScreenPos().y + 4));
    if (flat_button(ui, "undo offered", notice.undo.c_str(), button - 8)) ui.push(Undo{});
  }
  const ImVec2 after = beside ? ImVec2(at.x, at.y + 24) : ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + static_cast<float>(width) - 20 - 24, at.y));
  if (icon_button(ui, "close", Icon::close, true, "Close (Esc)", 24)) ui.push(ShowNotice{});
  ImGui::SetCursorScreenPos(after);
  ImGui::Dummy(ImVec2(0, 0));
  const double height = static_cast<double>(ImGui::GetWindowHeight());
  if (std::abs(height - ui.state.session.notice_height) > 0.5) ui.push(MeasureNotice{height});
  end_card(ui);
}

// --- Answers "why here?" beside the pressed part.

namespace {

constexpr double widest = 320, away_from_part = 26;  // pixels from the explained part

Vec2 spot_of(const Ui& ui, const Explanation& explanation) {
  Vec2 at = ui.state.view.camera.to_screen(explanation.of.at);
  if (!explanation.of.second) return at;
  return at + Vec2(ui.layout.second.left - ui.layout.first.left,
                   ui.layout.second.top - ui.layout.first.top);
}

// The object's left and right ends in the picture that contains the spot, in pixels.
std::pair<double, double> ends_of_object(const Ui& ui, const Vec2& spot) {
  const Rect& second = ui.layout.second;
  const bool in_second = second.width() > 0 && second.contains(spot);
  const double shift = in_second ? second.left - ui.layout.first.left : 0;
  const Box box = bounding_box(ui.state.work.document().vertices);
  return {ui.state.view.camera.to_screen(box.low).x + shift,
          ui.state.view.camera.to_screen(box.high).x + shift};
}

// Beside the object if there is room, else beside the spot, away from the centre of mass. On a
// narrow screen, over the sheet, below the spot. On a phone on its side, over the panel: at the
// spot it would cover the object.
struct CardPlace {
  Rect rect;
  bool at_bottom;      // at the bottom of the rectangle
  bool fills = false;  // as high as the rectangle
};

constexpr double height_of_card = 332;  // usually

// The robots and C of the picture that the card explains, in pixels.
Points marks_of_card(const Ui& ui) {
  const Explanation& explanation = *ui.state.derived().explanation;
  const Placement* placement = current_placement(ui.state, explanation.of.second);
  if (!placement) return {};
  const Vec2 beside(ui.layout.second.left - ui.layout.first.left,
                    ui.layout.second.top - ui.layout.first.top);
  const auto on_screen = [&](const Vec2& world) {
    const Vec2 at = ui.state.view.camera.to_screen(world);
    return explanation.of.second ? Vec2(at + beside) : at;
  };
  Points marks{on_screen(placement->centre_of_mass)};
  for (const LiftingPoint& robot : lifting_points(placement->teams))
    marks.push_back(on_screen(robot.position));
  return marks;
}

// How many of them a card of usual height covers there. O(marks).
std::size_t covered_marks(const Points& marks, Rect card, bool at_bottom) {
  constexpr double robot = 16;
  if (at_bottom)
    card.top = std::max(card.top, card.bottom - height_of_card);
  else
    card.bottom = std::min(card.bottom, card.top + height_of_card);
  card = {card.left - robot, card.top - robot, card.right + robot, card.bottom + robot};
  return static_cast<std::size_t>(std::count_if(
      marks.begin(), marks.end(), [&](const Vec2& mark) { return card.contains(mark); }));
}

CardPlace place_of(const Ui& ui, const Vec2& spot) {
  const Rect& free = ui.layout.free;
  const double margin = ui.layout.margin, left = free.left + margin, right = free.right - margin,
               top = free.top + margin, bottom = free.bottom - margin;
  const bool low = spot.y >= free.middle().y;
  if (!ui.layout.wide) {
    constexpr double least = 240;  // longer text scrolls
    const double foot = ui.state.session.screen.height - 4;
    const double head =
        std::max(spot.y + away_from_part, free.bottom);  // the loads above the sheet stay visible
    return {{left, std::clamp(head, top, foot - least), right, foot}, true, true};
  }
  if (ui.layout.low && ui.state.view.panel_open) return {ui.layout.panel, false, true};
  const double width = std::min(widest, right - left);
  const bool outward_left =
      spot.x < ui.state.view.camera.to_screen(ui.state.derived().placement->centre_of_mass).x;
  const double before = spot.x - away_from_part - width, behind = spot.x + away_from_part;
  const bool at_left = outward_left ? before >= left : behind + width > right;
  // Beyond the body of a sized robot, as far as there is room.
  const RobotSize& robot = settings(ui.state).robot;
  const double body = ui.state.view.camera.scale * (robot.reach + 2 * robot.radius);
  const auto [begin, end] = ends_of_object(ui, spot);
  const double off = at_left ? begin - away_from_part - body - width : end + away_from_part + body;
  const bool beside_object = off >= left && off + width <= right;
  const double x = beside_object ? off
                                 : std::clamp(at_left ? before - body : behind + body, left,
                                              std::max(left, right - width));
  const auto placed = [&](double from, bool at_bottom) -> CardPlace {
    const double foot =
        from < ui.layout.tools.right ? std::min(bottom, ui.layout.tools.top - margin) : bottom;
    if (at_bottom) return {{from, top, from + width, std::clamp(spot.y + 20, top, foot)}, true};
    return {{from, std::clamp(spot.y - 20, top, foot), from + width, foot}, false};
  };
  const CardPlace usual = placed(x, low);
  const Points marks = marks_of_card(ui);
  const std::size_t covered = covered_marks(marks, usual.rect, usual.at_bottom);
  if (covered == 0) return usual;
  // The nearest place that covers fewer, which need not be beside the spot.
  constexpr double step = 24;
  CardPlace best = usual;
  std::size_t least = covered;
  double nearest = 0;
  for (double y = top; y + height_of_card <= bottom; y += step)
    for (double from = left; from + width <= right; from += step) {
      const Rect rect{from, y, from + width, bottom};
      if (from < ui.layout.tools.right && y + height_of_card > ui.layout.tools.top) continue;
      const std::size_t here = covered_marks(marks, rect, false);
      const double away = length(Vec2(from + width / 2, y + height_of_card / 2) - spot);
      if (here > least || (here == least && (least == covered || away >= nearest))) continue;
      best = {rect, false};
      least = here;
      nearest = away;
    }
  return best;
}

void draw_row(const Ui& ui, const Explanation::Row& row) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, low, ui.theme.second_text, row.label);
  const ImVec2 label = text_size(Face::label, row.label),
               value = text_size(Face::strong_label, row.value);
  const bool fits = label.x + value.x + 12 <= width;
  const float line = line_height(Face::label), top = fits ? low.y : low.y + line;
  draw_text(list, Face::strong_label, ImVec2(low.x + width - value.x, top), ui.theme.text,
            row.value);
  ImGui::Dummy(ImVec2(width, fits ? line : 2 * line));
}

// What the failure means for the card's robot.
void draw_failing(const Ui& ui, const Failure& failure, std::size_t robot) {
  if (failure.robot == robot) {
    text_block(Face::label, ui.theme.text, failure_words(ui.state, robot));
    const ShownPlacement rest(failure.placement, shown(ui.state));
    const bool tips = failure.rest && !failure.rest->stays;
    text_block(Face::label, ui.theme.second_text,
               tips ? closure_in_words(rest) : rest_in_words(rest));
    return;
  }
  const LoadRange& load = failure.report.loads[robot];
  draw_row(ui,
           {"It carries now", failure.rest && failure.rest->stays
                                  ? load_in_words(failure.report.model, load,
                                                  failure.report.greatest, shown(ui.state).units)
                                  : std::string("nothing")});
  draw_row(ui, {say("Robot {robot}", {failure.placement.number_of(failure.robot)}), "fails"});
}

void draw_fail_button(const Ui& ui, std::size_t robot, float width) {
  const Failure* failure = failing(ui.state);
  const bool failed = failure && failure->robot == robot;
  if (flat_button(ui, "fail", failed ? "Back to work" : "Let it fail", width))
    ui.push(Fail{failed ? std::nullopt : std::optional<std::size_t>(robot)});
}

// Side by side if height is scarce.
void draw_buttons(const Ui& ui, const Explanation& explanation, bool in_a_row) {
  constexpr float between = 6, padding = 16;
  const bool can_fail = explanation.robot && !walkthrough_is_open(ui.state);
  const float width = ImGui::GetContentRegionAvail().x, half = (width - between) / 2;
  const bool beside = in_a_row && can_fail && explanation.step;
  const char* lesson = "Show in walkthrough";
  if (beside && text_size(Face::text, lesson).x + padding > half) lesson = "Walkthrough";
  if (can_fail) draw_fail_button(ui, *explanation.robot, beside ? half : width);
  if (beside) ImGui::SameLine(0, between);
  if (explanation.step && flat_button(ui, "show in lesson", lesson, beside ? half : width))
    ui.push(ShowInLesson{*explanation.step});
}

void draw_words(const Ui& ui, const Explanation& explanation) {
  const Failure* failure = failing(ui.state);
  if (failure && explanation.robot) return draw_failing(ui, *failure, *explanation.robot);
  for (const Explanation::Row& row : explanation.rows) draw_row(ui, row);
  if (!explanation.reason.empty()) text_block(Face::label, ui.theme.text, explanation.reason);
}

}  // namespace

void draw_why_card(const Ui& ui) {
  if (!ui.state.derived().explanation || !ui.state.derived().placement ||
      ui.state.session.screen.embed)
    return;
  const Explanation& explanation = *ui.state.derived().explanation;
  const CardPlace place = place_of(ui, spot_of(ui, explanation));
  begin_card(ui, "why here", place.rect,
             {.at_bottom = place.at_bottom,
              .fixed_height = place.fills,
              .padding = 14,
              .scrolls = !place.fills});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 4));
  text_block(Face::strong, ui.theme.text, explanation.title, ui.control());
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + width - ui.control() + 8, at.y - 8));
  if (icon_button(ui, "close explanation", Icon::close, true, "Close (Esc)", ui.control()))
    ui.push(Explain{});
  ImGui::SetCursorScreenPos(after);
  // In a card of fixed height the words scroll and the buttons stay.
  if (place.fills)
    begin_scrolling_box(ui, "words", ImGui::GetContentRegionAvail().y - ui.control() - 8);
  draw_words(ui, explanation);
  if (place.fills) end_scrolling_box(ui);
  draw_buttons(ui, explanation, place.fills);
  ImGui::PopStyleVar();
  end_card(ui);
}

}  // namespace evenlift::view
