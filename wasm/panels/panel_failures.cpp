// The effect of each robot's failure, as a sign; pressing it makes the robot fail.
#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/sliders.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr float caption_height = 16, least_height = 42, widest_place = 48;
constexpr float least_for_number = 34;  // width of a place with room for a robot's number

// A disc if the others carry the object, a triangle if it may tip or one is overloaded, a cross if
// it falls. Where only a line has room, longer is worse.
void draw_sign(const Theme& theme, ImDrawList& list, ImVec2 at, float reach, Mood mood) {
  const bool good = mood == Mood::good, falls = mood == Mood::falls;
  const ImU32 colour = (good ? theme.hull_outline : falls ? theme.red : theme.amber).packed();
  if (reach < 3.5f) {
    // All have one width, as wider ones would look darker.
    const float half = good    ? 2.5f
                       : falls ? 9.0f
                               : 5.5f,
                wide = std::max(1.0f, std::floor(2 * reach - 0.8f)),
                left = std::round(at.x - wide / 2);
    list.AddRectFilled(ImVec2(left, at.y - half), ImVec2(left + wide, at.y + half), colour);
  } else if (good) {
    list.AddCircleFilled(at, reach, colour, 24);
  } else if (falls) {
    const float arm = reach - 1;
    list.AddLine(ImVec2(at.x - arm, at.y - arm), ImVec2(at.x + arm, at.y + arm), colour, 3);
    list.AddLine(ImVec2(at.x - arm, at.y + arm), ImVec2(at.x + arm, at.y - arm), colour, 3);
  } else {
    const float up = reach * 1.1f, down = reach * 0.8f;
    list.AddTriangleFilled(ImVec2(at.x, at.y - up), ImVec2(at.x + up, at.y + down),
                           ImVec2(at.x - up, at.y + down), colour);
  }
}

void draw_unknown(const Theme& theme, ImDrawList& list, ImVec2 at, float reach) {
  list.AddRectFilled(ImVec2(at.x - std::min(reach, 3.0f), at.y - 1),
                     ImVec2(at.x + std::min(reach, 3.0f), at.y + 1), theme.quiet.packed());
}

void draw_signs(const Ui& ui, const RowOfPlaces& row, std::size_t count) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float each = (row.high.x - row.low.x) / static_cast<float>(count),
              reach = std::clamp(each / 2 - 1.5f, 0.8f, 7.0f),
              y = (row.low.y + caption_height + row.high.y) / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const float aside = each < least_for_number ? 0.0f : 5.0f;  // centres sign and number together
    const ImVec2 at(row.low.x + each * (static_cast<float>(i) + 0.5f) - aside, y);
    const bool failed = failing(ui.state) && failing(ui.state)->robot == i;
    if (failed || row.hovered == i) {
      const Colour colour = failed ? ui.theme.accent : ui.theme.quiet;
      const float half = std::max(reach + 4, 5.0f) + aside, middle = at.x + aside;
      list.AddRect(ImVec2(middle - half, y - 12), ImVec2(middle + half, y + 12), colour.packed(), 5,
                   0, failed ? 2.0f : 1.0f);
    }
    if (i < ui.state.derived().report.failures.size())
      draw_sign(ui.theme, list, at, reach,
                mood_of(ui.state, ui.state.derived().report.failures[i]));
    else
      draw_unknown(ui.theme, list, at, reach);
    if (each < least_for_number) continue;
    const std::string number = std::to_string(i + 1);
    const ImVec2 size = text_size(Face::tiny, number);
    draw_text(list, Face::tiny, ImVec2(at.x + reach + 3, y - size.y / 2), ui.theme.second_text,
              number);
  }
}

// 0 for too many robots, and while the result is not shown.
std::size_t signs(const AppState& state) {
  if (!state.derived().placement || state.derived().refusal || draws(state.view.tool)) return 0;
  const std::size_t count = count_robots(state.derived().placement->teams);
  return count == state.derived().report.failures.size() || state.derived().failures_due ? count
                                                                                         : 0;
}

const char* caption(const AppState& state, std::size_t count) {
  if (count > 0) return "If one robot fails";
  const bool many = state.derived().placement && !state.derived().refusal &&
                    !draws(state.view.tool) && !state.derived().placement->teams.empty();
  return many ? "If one robot fails: too many robots to check each" : "";
}

// The signs of many robots are too small for a finger: these buttons step through them.
void draw_steps(const Ui& ui, ImVec2 at, std::size_t count, std::optional<std::size_t> now) {
  const float size = ui.control();
  ImGui::SetCursorScreenPos(at);
  if (icon_button(ui, "failure -", Icon::step_back, now.has_value(),
                  "The previous robot fails; before the first one, none", size))
    ui.push(Fail{*now > 0 ? std::optional(*now - 1) : std::nullopt});
  ImGui::SetCursorScreenPos(ImVec2(at.x + size, at.y));
  if (icon_button(ui, "failure +", Icon::step_on, !now || *now + 1 < count, "The next robot fails",
                  size))
    ui.push(Fail{now ? *now + 1 : std::size_t{0}});
}

}  // namespace

void draw_failures(const Ui& ui) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x,
              height = std::max(ui.control(), least_height);
  const std::size_t count = signs(ui.state);
  const Failure* failed = failing(ui.state);
  const auto now = failed ? std::optional<std::size_t>(failed->robot) : std::nullopt;
  const float places = static_cast<float>(std::max<std::size_t>(count, 1));
  const bool steps = ui.state.session.screen.finger && width / places < 44;
  const float row_width = std::min(width - (steps ? 2 * ui.control() : 0), widest_place * places);
  const RowOfPlaces row =
      row_of_places(ui, "failures", "The robot that fails",
                    failed ? failure_words(ui.state, failed->robot) : say("none"), count, now,
                    ImVec2(row_width, height));
  draw_text(*ImGui::GetWindowDrawList(), Face::label, low, ui.theme.second_text,
            caption(ui.state, count));
  if (steps) draw_steps(ui, ImVec2(low.x + width - 2 * ui.control(), low.y), count, now);
  ImGui::SetCursorScreenPos(ImVec2(low.x, low.y + height));
  ImGui::Dummy(ImVec2(width, 0));
  if (count == 0) return;
  draw_signs(ui, row, count);
  if (row.taken != now) ui.push(Fail{row.taken});
  if (!row.hovered) return;
  tip(ui, failure_words(ui.state, *row.hovered).c_str());
  const std::vector<Team>& teams = ui.state.derived().placement->teams;
  const auto [team, robot] = find_robot(teams, *row.hovered);
  ui.row = {Pick::Kind::robot, team, static_cast<int>(robot),
            teams[team].robots[robot].point.position};
}

}  // namespace evenlift::view
