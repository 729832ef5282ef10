// The effect of each robot's failure, as a sign; pressing it makes the robot fail.
#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/output/markup.h"
#include "evenlift/output/quantities.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "ui/controls.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
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
    const std::string number = std::to_string(ui.state.derived().placement->number_of(i));
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

// --- The result in numbers, each with its meaning.

namespace {

void fact(const Ui& ui, const char* label, const std::string& value, const char* about) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool fits =
      text_size(Face::label, label).x + text_size(Face::strong_label, value).x + 12 <= width;
  ImGui::PushID(label);
  ImGui::InvisibleButton("fact", ImVec2(width, fits ? 21 : 42));
  ImGui::PopID();
  const ImVec2 low = ImGui::GetItemRectMin();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(low.x, low.y + 2), ui.theme.second_text, label);
  const ImVec2 size = text_size(Face::strong_label, value);
  draw_text(list, Face::strong_label, ImVec2(low.x + width - size.x, low.y + (fits ? 2 : 23)),
            ui.theme.text, value);
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

// --- A table of the teams: two loads as bars from the middle, and the load ratio.

namespace {

constexpr std::size_t most_rows = 60;  // the JSON has more

float row_height(const Ui& ui) { return std::max(28.0f, ui.control() - 8); }

// The table's height depends on settings alone, so that nothing below moves when the result changes:
// it has room for four teams, or for as many robots as are asked for, from four to six if the window
// is 900 pixels high. A button shows more.
std::size_t room_of_rows(const Ui& ui) {
  constexpr double of_six = 868;
  constexpr std::size_t least = 4, most = 6;
  const Settings& now = settings(ui.state);
  const bool is_high = !ui.layout.wide || ui.layout.panel.height() >= of_six;
  if (!is_one_team(now.method) || !is_high) return least;
  const std::size_t asked =
      now.method == Method::given ? now.supports.size() : std::size_t{now.robots};
  return std::clamp(asked, least, most);
}

std::size_t shown_rows(const Ui& ui, std::size_t count) {
  return std::min(count, ui.state.view.all_loads ? most_rows : room_of_rows(ui));
}

// A row: a disc at the left, bars to both sides of the middle, two numbers at the right.
struct Columns {
  float left, middle, half, span, ratio;
  float text;     // room for a load beside its bar
  float numbers;  // the width of the robots' numbers
};

// Without its unit.
std::string load_text(const Ui& ui, std::size_t number) {
  const Failure* failure = failing(ui.state);
  if (failure && failure->robot == number) return "fails";
  const Report& report = shown_report(ui.state);
  if (report.greatest == 0) return "–";
  return amounts(report.model, report.loads[number], report.greatest);
}

// "5 6" for the third team.
std::string numbers_of_team(std::size_t team) {
  return std::to_string(2 * team - 1) + " " + std::to_string(2 * team);
}

Columns columns(const Ui& ui, float left, float width) {
  const float ratio_width = 46, span_width = 50;
  const std::size_t robots = count_robots(ui.state.derived().placement->teams);
  const float numbers = std::max(
      34.0f, text_size(Face::tiny, numbers_of_team(std::min(robots / 2, most_rows))).x + 14);
  const float disc = numbers + 6;
  const float bars = width - disc - ratio_width - span_width;
  float text = 32;
  const std::size_t rows = std::min(robots, 2 * most_rows);
  for (std::size_t i = 0; i < rows; ++i)
    text = std::max(text, text_size(Face::label, load_text(ui, i)).x);
  return {
      left,   left + disc + bars / 2, bars / 2, left + width - ratio_width, left + width, text + 8,
      numbers};
}

// The length of the bar for the greatest load.
float full_bar(const Columns& c) { return std::max(12.0f, c.half - c.text); }

void right_aligned(ImDrawList& list, Face face, float right, float middle_y, Colour colour,
                   const std::string& text) {
  const ImVec2 size = text_size(face, text);
  draw_text(list, face, ImVec2(right - size.x, middle_y - size.y / 2), colour, text);
}

void draw_heading(const Ui& ui, const Columns& c) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = ImGui::GetCursorScreenPos().y + 8;
  const std::string loads = say("Loads in {unit}", {weight_unit(ui.state)});
  const ImVec2 size = text_size(Face::label, loads);
  draw_text(list, Face::label, ImVec2(c.left, y - size.y / 2), ui.theme.second_text, "Robots");
  draw_text(list, Face::label, ImVec2(c.middle - size.x / 2, y - size.y / 2), ui.theme.second_text,
            loads);
  right_aligned(list, Face::label, c.span, y, ui.theme.second_text, "Length");
  right_aligned(list, Face::label, c.ratio, y, ui.theme.second_text, "Ratio");
  ImGui::Dummy(ImVec2(1, line_height(Face::label)));
}

// The bar is fainter beyond the least load of a range.
void draw_load_bar(const Ui& ui, const Columns& c, float y, std::size_t number, int side) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Report& report = shown_report(ui.state);
  const LoadRange& load = report.loads[number];
  const bool over = is_overloaded(ui.state, number);
  const float way = static_cast<float>(side), full = full_bar(c);
  const auto bar = [&](double value, Colour colour) {
    const double share = report.greatest > 0 ? value / report.greatest : 0;
    const float inner = c.middle + way * 1.5f,
                outer = c.middle + way * (1.5f + full * static_cast<float>(share));
    list.AddRectFilled(ImVec2(std::min(inner, outer), y - 6), ImVec2(std::max(inner, outer), y + 6),
                       colour.packed(), 3);
  };
  const Colour colour = over ? ui.theme.amber : ui.theme.chord;
  if (load.greatest > load.least) bar(load.greatest, colour.at(0.45f));
  bar(load.least, colour);
  const std::string text = load_text(ui, number);
  const ImVec2 size = text_size(Face::label, text);
  const float x = c.middle + way * (full + 8);
  draw_text(list, Face::label, ImVec2(side > 0 ? x : x - size.x, y - size.y / 2), ui.theme.text,
            text);
}

void draw_team_numbers(const Ui& ui, float left, float y, float width, const std::string& numbers) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low(left + 1, y - 10), high(left + 1 + width, y + 10);
  list.AddRectFilled(low, high, ui.theme.robot.packed(), 10);
  list.AddRect(low, high, ui.theme.robot_ring.packed(), 10);
  const ImVec2 size = text_size(Face::tiny, numbers);
  draw_text(list, Face::tiny, ImVec2((low.x + high.x) / 2 - size.x / 2, y - size.y / 2),
            ui.theme.robot_text, numbers);
}

// For users who cannot see the row: "Team 2, robots 3 and 4: loads 15.2 and 18.1 kg, length 320,
// ratio 0.84. Why here?"
std::string team_row_in_words(const Ui& ui, std::size_t index) {
  const Team& team = ui.state.derived().placement->teams[index];
  const double span = team.robots[0].arm + team.robots[1].arm;
  return say(
      "Team {team}, robots {first} and {second}: loads {load} and {other} {unit}, "
      "length {length}, ratio {ratio}. Why here?",
      {index + 1, 2 * index + 1, 2 * index + 2, load_text(ui, 2 * index),
       load_text(ui, 2 * index + 1), weight_unit(ui.state), amount(span, span),
       ratio_in_words(team.ratio)});
}

bool draw_row(const Ui& ui, const Columns& c, std::size_t index) {
  const Placement& placement = *ui.state.derived().placement;
  const Team& team = placement.teams[index];
  const float height = row_height(ui);
  const std::string name = "Team " + std::to_string(index + 1);
  const auto [low, high, pressed, hovered] =
      pressable_row(ui, name.c_str(), team_row_in_words(ui, index), c.ratio - c.left, height);
  if (pressed) ui.push(Explain{Pick{Pick::Kind::chord, index, 0, team.robots[0].point.position}});
  const bool named = (ui.state.view.hover.kind == Pick::Kind::chord ||
                      ui.state.view.hover.kind == Pick::Kind::robot) &&
                     ui.state.view.hover.index == index;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || named) {
    list.AddRectFilled(ImVec2(low.x - 6, low.y), ImVec2(high.x + 6, high.y), ui.theme.well.packed(),
                       7);
  }
  const float y = (low.y + high.y) / 2;
  draw_team_numbers(ui, c.left, y, c.numbers, numbers_of_team(index + 1));
  for (int end = 0; end < 2; ++end)
    draw_load_bar(ui, c, y, 2 * index + static_cast<std::size_t>(end), end == 0 ? -1 : 1);
  const double span = team.robots[0].arm + team.robots[1].arm;
  right_aligned(list, Face::label, c.span, y, ui.theme.text, amount(span, span));
  right_aligned(list, Face::strong_label, c.ratio, y, ui.theme.text, ratio_in_words(team.ratio));
  return hovered;
}

// On each side, a line through all bars at the mean load.
void draw_even_share(const Ui& ui, const Columns& c, float top, float bottom) {
  const Placement& placement = shown_placement(ui.state);
  if (!placement.loads) return;
  const double mean = placement.loads->mean, greatest = shown_report(ui.state).greatest;
  const float out = 1.5f + full_bar(c) * static_cast<float>(mean / greatest);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const float way : {-1.0f, 1.0f}) {
    const float x = c.middle + way * out;
    list.AddLine(ImVec2(x, top), ImVec2(x, bottom), ui.theme.accent.packed(), 1.5f);
  }
  const std::string text =
      say("even share {load}", {load_in_words(mean, greatest, shown(ui.state).units)});
  const ImVec2 size = text_size(Face::label, text);
  draw_text(list, Face::label, ImVec2(c.middle - size.x / 2, bottom + 3), ui.theme.second_text,
            text);
}

void draw_robot_row(const Ui& ui, const Columns& c, std::size_t index, const TeamInWords& words) {
  const Placement& placement = *ui.state.derived().placement;
  const Robot& robot = placement.teams[0].robots[index];
  const Pick pick{Pick::Kind::robot, 0, static_cast<int>(index), robot.point.position};
  const std::string number = std::to_string(placement.number_of(index)), name = "Robot " + number;
  const auto [low, high, pressed, hovered] = pressable_row(
      ui, name.c_str(),
      say("Robot {robot}: at {place}, load {load} {unit}. Why here?",
          {placement.called(index), words.at[index], load_text(ui, index), weight_unit(ui.state)}),
      c.ratio - c.left, row_height(ui));
  if (pressed) ui.push(Explain{pick});
  const Pick& over = ui.state.view.hover;
  const bool named = over.kind == pick.kind && over.end == pick.end && !over.second;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || named)
    list.AddRectFilled(ImVec2(low.x - 6, low.y), ImVec2(high.x + 6, high.y), ui.theme.well.packed(),
                       7);
  const float y = (low.y + high.y) / 2;
  draw_team_numbers(ui, c.left, y, 20, number);
  constexpr std::size_t most_characters = 20;
  const std::string_view own = placement.name_of(index);
  const std::string shown_name = own.empty() ? words.at[index] : shortened(own, most_characters);
  const ImVec2 size = text_size(Face::label, shown_name);
  draw_text(list, Face::label, ImVec2(c.left + 32, y - size.y / 2), ui.theme.text, shown_name);
  right_aligned(list, Face::strong_label, c.ratio, y,
                is_overloaded(ui.state, index) ? ui.theme.amber : ui.theme.text,
                load_text(ui, index));
  if (hovered) ui.row = pick;
}

// The place of the rows that are missing, and the line below the table, which may have a button at
// its right.
void end_rows(const Ui& ui, std::size_t count) {
  const std::size_t room = room_of_rows(ui), shown = shown_rows(ui, count);
  const auto missing = static_cast<float>(room - std::min(shown, room));
  const float height = ui.state.session.screen.finger ? ui.control() : 22;
  ImGui::Dummy(ImVec2(1, missing * (row_height(ui) + 2)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  ImGui::Dummy(ImVec2(1, height));
  if (count <= room) return;
  const bool all = ui.state.view.all_loads;
  const std::string label =
      all ? say("Fewer rows") : say("All {number} rows", {std::min(count, most_rows)});
  const ImVec2 text = text_size(Face::label, label);
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(right - text.x - 8, at.y));
  const PressableRow button = pressable_row(ui, "all loads", label, text.x + 8, height);
  ImGui::SetCursorScreenPos(below);
  draw_text(*ImGui::GetWindowDrawList(), Face::label,
            ImVec2(right - text.x, at.y + (height - text.y) / 2), ui.theme.accent, label);
  if (button.pressed) ui.push(SetSectionOpen{&View::all_loads, !all});
  if (all && count > most_rows)
    draw_text(*ImGui::GetWindowDrawList(), Face::label, ImVec2(at.x, at.y + (height - text.y) / 2),
              ui.theme.second_text, say("and {number} more", {count - most_rows}));
}

void draw_robots(const Ui& ui, const Columns& c) {
  const Placement& placement = *ui.state.derived().placement;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text(list, Face::label, at, ui.theme.second_text, "Robot");
  right_aligned(list, Face::label, c.ratio, at.y + 8, ui.theme.second_text,
                say("Load in {unit}", {weight_unit(ui.state)}));
  ImGui::Dummy(ImVec2(1, line_height(Face::label)));
  const TeamInWords words = team_in_words(placement, 0, place_decimals(placement));
  for (std::size_t i = 0; i < shown_rows(ui, words.at.size()); ++i) draw_robot_row(ui, c, i, words);
  end_rows(ui, words.at.size());
}

}  // namespace

void draw_teams(const Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 2));
  const auto& placement = ui.state.derived().placement;
  if (!placement || placement->teams.empty()) {
    text_line(Face::label, ui.theme.second_text, "No robots to list.");
    end_rows(ui, 0);
    return ImGui::PopStyleVar();
  }
  const std::size_t count = placement->teams.size();
  const Columns c = columns(ui, ImGui::GetCursorScreenPos().x, ImGui::GetContentRegionAvail().x);
  if (is_one_team(placement->settings.method)) {
    draw_robots(ui, c);
    return ImGui::PopStyleVar();
  }
  draw_heading(ui, c);
  const float top = ImGui::GetCursorScreenPos().y;
  for (std::size_t i = 0; i < shown_rows(ui, count); ++i) {
    if (draw_row(ui, c, i)) ui.row = {Pick::Kind::chord, i, 0, Vec2(0, 0)};
  }
  draw_even_share(ui, c, top, ImGui::GetItemRectMax().y + 2);
  end_rows(ui, count);
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
