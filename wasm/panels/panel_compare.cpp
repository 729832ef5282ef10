// The second method, and the results of both in numbers.
#include <array>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "panels/methods.h"
#include "panels/panels.h"
#include "ui/dropdown.h"
#include "ui/widgets.h"

namespace evenlift::view {
namespace {

struct Row {
  const char* label;
  std::array<std::string, 2> values;
};

std::vector<Row> rows(const Placement& a, const Placement& b) {
  const auto both = [&](auto value) { return std::array<std::string, 2>{value(a), value(b)}; };
  const auto load = [](auto member) {
    return [member](const Placement& p) {
      return p.loads ? amount((*p.loads).*member, p.loads->max) : std::string("–");
    };
  };
  return {
      {"Robots", both([](const Placement& p) { return std::to_string(2 * p.teams.size()); })},
      {"Least load, kg", both(load(&LoadSummary::min))},
      {"Greatest load, kg", both(load(&LoadSummary::max))},
      {"Difference, kg", both(load(&LoadSummary::spread))},
      {"Coverage", both([](const Placement& p) { return percentage(p.coverage, 1); })},
      {"Form closure", both([](const Placement& p) { return form_closure_in_words(p.closure); })}};
}

void draw_row(const Ui& ui, const Row& row, Face face, Colour colour) {
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
}

}  // namespace

void draw_compare(const Ui& ui) {
  const float width = labelled(ui, "Compare with");
  const std::optional<Method>& compared = ui.state.second_method;
  dropdown_button(ui, "compared", compared ? words_of(*compared).label : "Nothing", width);
  if (begin_choices(ui, "compared", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), width)) {
    if (choice(ui, "Nothing", nullptr, !compared)) ui.push(Compare{});
    for (const MethodWords& m : methods) {
      if (m.method != settings(ui.state).method &&
          choice(ui, m.label, m.about, compared == m.method))
        ui.push(Compare{m.method});
    }
    if (choice(ui, "All methods …", "in charts, by the number of teams", false))
      ui.push(OpenDialog{browser::Dialog::curves});
    end_choices(ui);
  }
  if (!ui.state.second || !ui.state.placement) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  draw_row(ui,
           {"", {words_of(ui.state.placement->settings.method).label, words_of(*compared).label}},
           Face::label, ui.theme.second_text);
  for (const Row& row : rows(*ui.state.placement, *ui.state.second))
    draw_row(ui, row, Face::strong_label, ui.theme.text);
  ImGui::PopStyleVar();
}

}  // namespace evenlift::view
