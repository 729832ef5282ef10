// The second method, and the results of both in numbers.
#include <array>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "ui/controls.h"
#include "widgets/dropdown.h"
#include "widgets/methods.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

struct Row {
  std::string label;
  std::array<std::string, 2> values;
};

// `failed` is the number of robots in `a` that carry nothing.
std::vector<Row> compared_rows(const Placement& a, const Placement& b, std::size_t failed,
                               const std::string& weight_unit) {
  const auto both = [&](auto value) { return std::array<std::string, 2>{value(a), value(b)}; };
  const auto load = [](auto member) {
    return [member](const Placement& p) {
      return p.loads ? amount((*p.loads).*member, p.loads->max) : std::string("–");
    };
  };
  return {
      {"Robots",
       {std::to_string(count_robots(a.teams) - failed), std::to_string(count_robots(b.teams))}},
      {say("Least load, {unit}", {weight_unit}), both(load(&LoadSummary::min))},
      {say("Greatest load, {unit}", {weight_unit}), both(load(&LoadSummary::max))},
      {say("Spread of loads, {unit}", {weight_unit}), both(load(&LoadSummary::spread))},
      {"Coverage", both([](const Placement& p) { return percentage(p.coverage, 1); })},
      {"Form closure", both([](const Placement& p) { return form_closure_in_words(p.closure); })}};
}

void draw_row(const Ui& ui, const Row& row, Face face, Colour colour,
              const std::array<std::string, 2>& methods) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(low.x, low.y + 2), ui.theme.second_text, row.label);
  for (int i = 0; i < 2; ++i) {
    const std::string& text = row.values[static_cast<std::size_t>(i)];
    const float right = low.x + width - (i == 0 ? 84.0f : 0.0f);
    draw_text(list, face, ImVec2(right - text_size(face, text).x, low.y + 2), colour, text);
  }
  ImGui::Dummy(ImVec2(width, 21));
  if (!row.label.empty())
    list_text(row.label, say("{method} {value}, {second} {other}",
                             {methods[0], row.values[0], methods[1], row.values[1]}));
}

}  // namespace

void draw_compare(const Ui& ui) {
  const float width =
      labelled(ui, "Compare with", "Shows the same object under a second method beside the first");
  std::vector<Choice> choices = {{"Nothing"}};
  std::vector<Method> of_choice;
  std::size_t current = 0;
  for (const MethodWords& m : methods) {
    if (m.method == settings(ui.state).method) continue;
    if (ui.state.work.second_method == m.method) current = choices.size();
    choices.push_back({m.label, m.about});
    of_choice.push_back(m.method);
  }
  choices.push_back({"Optimum …", "the best for this number of teams"});
  choices.push_back({"All methods …", "in charts, by the number of teams"});
  const auto chosen = dropdown(ui, "compared", "Compare with", choices, current, width);
  if (!chosen) return;
  if (*chosen + 1 == choices.size())
    ui.push(OpenDialog{Dialog::curves});
  else if (*chosen + 2 == choices.size())
    ui.push(OpenDialog{Dialog::optimum});
  else
    ui.push(Compare{*chosen == 0 ? std::nullopt : std::optional<Method>(of_choice[*chosen - 1])});
}

void draw_comparison(const Ui& ui) {
  if (!ui.state.derived().placement) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const bool fails = failing(ui.state) != nullptr;
  const std::string first = words_of(ui.state.derived().placement->settings.method).label;
  const std::array<std::string, 2> both = {fails ? say("{method}, one fails", {first}) : first,
                                           words_of(*ui.state.work.second_method).label};
  draw_row(ui, {"", both}, Face::label, ui.theme.second_text, both);
  for (const Row& row : compared_rows(shown_placement(ui.state), *ui.state.derived().second,
                                      fails ? 1 : 0, weight_unit(ui.state)))
    draw_row(ui, row, Face::strong_label, ui.theme.text, both);
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
