// A table of the teams: two loads as bars from the middle, and the load ratio.
#include <algorithm>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "widgets/buttons.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_rows = 60;  // the JSON has more

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
  const float height = std::max(28.0f, ui.control() - 8);
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
  draw_text(list, Face::label, ImVec2(c.middle - size.x / 2, bottom + 3), ui.theme.accent, text);
}

void draw_robot_row(const Ui& ui, const Columns& c, std::size_t index, const TeamInWords& words) {
  const Placement& placement = *ui.state.derived().placement;
  const Robot& robot = placement.teams[0].robots[index];
  const Pick pick{Pick::Kind::robot, 0, static_cast<int>(index), robot.point.position};
  const std::string number = std::to_string(index + 1), name = "Robot " + number;
  const auto [low, high, pressed, hovered] =
      pressable_row(ui, name.c_str(),
                    say("Robot {robot}: at {place}, load {load} {unit}. Why here?",
                        {number, words.at[index], load_text(ui, index), weight_unit(ui.state)}),
                    c.ratio - c.left, std::max(28.0f, ui.control() - 8));
  if (pressed) ui.push(Explain{pick});
  const Pick& over = ui.state.view.hover;
  const bool named = over.kind == pick.kind && over.end == pick.end && !over.second;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || named)
    list.AddRectFilled(ImVec2(low.x - 6, low.y), ImVec2(high.x + 6, high.y), ui.theme.well.packed(),
                       7);
  const float y = (low.y + high.y) / 2;
  draw_team_numbers(ui, c.left, y, 20, number);
  const ImVec2 size = text_size(Face::label, words.at[index]);
  draw_text(list, Face::label, ImVec2(c.left + 32, y - size.y / 2), ui.theme.text, words.at[index]);
  right_aligned(list, Face::strong_label, c.ratio, y,
                is_overloaded(ui.state, index) ? ui.theme.amber : ui.theme.text,
                load_text(ui, index));
  if (hovered) ui.row = pick;
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
  for (std::size_t i = 0; i < words.at.size(); ++i) draw_robot_row(ui, c, i, words);
}

}  // namespace

void draw_teams(const Ui& ui) {
  if (!ui.state.derived().placement || ui.state.derived().placement->teams.empty()) {
    text_line(Face::label, ui.theme.second_text, "No robots to list.");
    return;
  }
  const std::size_t count = ui.state.derived().placement->teams.size();
  const Columns c = columns(ui, ImGui::GetCursorScreenPos().x, ImGui::GetContentRegionAvail().x);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 2));
  if (is_one_team(ui.state.derived().placement->settings.method)) {
    draw_robots(ui, c);
    return ImGui::PopStyleVar();
  }
  draw_heading(ui, c);
  const float top = ImGui::GetCursorScreenPos().y;
  for (std::size_t i = 0; i < std::min(count, most_rows); ++i) {
    if (draw_row(ui, c, i)) ui.row = {Pick::Kind::chord, i, 0, Vec2(0, 0)};
  }
  draw_even_share(ui, c, top, ImGui::GetItemRectMax().y + 2);
  ImGui::Dummy(ImVec2(1, 20));
  if (count > most_rows) {
    text_line(Face::label, ui.theme.second_text, say("and {number} more", {count - most_rows}));
  }
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
