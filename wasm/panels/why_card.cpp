// Answers "why here?" beside the pressed part.
#include <algorithm>
#include <string>
#include <utility>

#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr double widest = 320, away = 26;  // pixels from the explained part

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
CardPlace place_of(const Ui& ui, const Vec2& spot) {
  const Rect& free = ui.layout.free;
  const double margin = ui.layout.margin, left = free.left + margin, right = free.right - margin,
               top = free.top + margin, bottom = free.bottom - margin;
  const bool low = spot.y >= free.middle().y;
  if (!ui.layout.wide) {
    constexpr double least = 240;  // longer text scrolls
    const double foot = ui.state.session.screen.height - 4;
    const double head =
        std::max(spot.y + away, free.bottom);  // the loads above the sheet stay visible
    return {{left, std::clamp(head, top, foot - least), right, foot}, true, true};
  }
  if (ui.layout.low && ui.state.view.panel_open) return {ui.layout.panel, false, true};
  const double width = std::min(widest, right - left);
  const bool outward_left =
      spot.x < ui.state.view.camera.to_screen(ui.state.derived().placement->centre_of_mass).x;
  const double before = spot.x - away - width, behind = spot.x + away;
  const bool at_left = outward_left ? before >= left : behind + width > right;
  // Beyond the body of a sized robot, as far as there is room.
  const RobotSize& robot = settings(ui.state).robot;
  const double body = ui.state.view.camera.scale * (robot.reach + 2 * robot.radius);
  const auto [begin, end] = ends_of_object(ui, spot);
  const double off = at_left ? begin - away - body - width : end + away + body;
  const bool beside_object = off >= left && off + width <= right;
  const double x = beside_object ? off
                                 : std::clamp(at_left ? before - body : behind + body, left,
                                              std::max(left, right - width));
  const double foot =
      x < ui.layout.tools.right ? std::min(bottom, ui.layout.tools.top - margin) : bottom;
  if (low) return {{x, top, x + width, std::clamp(spot.y + 20, top, foot)}, true};
  return {{x, std::clamp(spot.y - 20, top, foot), x + width, foot}, false};
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
  draw_row(ui, {say("Robot {robot}", {failure.robot + 1}), "fails"});
}

void draw_fail_button(const Ui& ui, std::size_t robot, float width) {
  const Failure* failure = failing(ui.state);
  const bool failed = failure && failure->robot == robot;
  if (flat_button(ui, "fail", failed ? "Back to work" : "Let it fail", width))
    ui.push(Fail{failed ? std::nullopt : std::optional<std::size_t>(robot)});
}

// Side by side if height is scarce.
void draw_buttons(const Ui& ui, const Explanation& explanation, bool in_a_row) {
  constexpr float gap = 6, padding = 16;
  const bool can_fail = explanation.robot && !walkthrough_is_open(ui.state);
  const float width = ImGui::GetContentRegionAvail().x, half = (width - gap) / 2;
  const bool beside = in_a_row && can_fail && explanation.step;
  const char* lesson = "Show in walkthrough";
  if (beside && text_size(Face::text, lesson).x + padding > half) lesson = "Walkthrough";
  if (can_fail) draw_fail_button(ui, *explanation.robot, beside ? half : width);
  if (beside) ImGui::SameLine(0, gap);
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
