// The settings: method, teams, minimum load ratio, weight, and those that only some methods or
// shapes have.
#include <algorithm>
#include <cmath>

#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "panels/methods.h"
#include "panels/panels.h"
#include "tools/pick.h"
#include "ui/dropdown.h"
#include "ui/widgets.h"

namespace evenlift::view {
namespace {

std::uint32_t placed_teams(const AppState& state) {
  return state.placement
             ? std::max<std::uint32_t>(1, static_cast<std::uint32_t>(state.placement->teams.size()))
             : 3;
}

void draw_method(const Ui& ui) {
  const Settings& now = settings(ui.state);
  const float width = labelled(ui, "Method");
  const MethodWords* current = &words_of(now.method);
  dropdown_button(ui, "methods", current->label, width);
  if (!begin_choices(ui, "methods", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), width))
    return;
  for (const MethodWords& m : methods) {
    if (!choice(ui, m.label, m.about, &m == current)) continue;
    Settings changed = now;
    changed.method = m.method;
    if (!selects_candidates(m.method) && !changed.teams) changed.teams = placed_teams(ui.state);
    ui.push(SetSettings{changed});
  }
  end_choices(ui);
}

void draw_ratio(const Ui& ui) {
  Settings changed = settings(ui.state);
  const float width = labelled(ui, "Min. load ratio"), number = 44;
  const SliderResult moved = slider(ui, "ratio", changed.min_ratio, 0, 1, 0.01, width - number);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (ImGui::IsItemHovered())
    tip(ui, "How evenly the two robots of a team must share; 1 is perfectly even");
  const std::string value = fixed(moved.value, 2);
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(*ImGui::GetWindowDrawList(), Face::strong,
            ImVec2(low.x + width - text.x, (low.y + high.y - text.y) / 2),
            selects_candidates(changed.method) ? ui.theme.text : ui.theme.quiet, value);
  if (moved.changed) {
    changed.min_ratio = moved.value;
    ui.push(SetSettings{changed, true});
  }
  if (moved.released) ui.push(EndEdit{});
}

void draw_weight(const Ui& ui) {
  Settings changed = settings(ui.state);
  const float width = labelled(ui, "Weight");
  const int by = stepper(ui, "weight", plain(changed.weight) + "\u00A0kg", changed.weight > 1e-3,
                         changed.weight < 1e9, width);
  if (by == 0) return;
  changed.weight = stepped(changed.weight, by);
  ui.push(SetSettings{changed});
}

void draw_seed(const Ui& ui) {
  Settings changed = settings(ui.state);
  if (changed.method != Method::random) return;
  const float width = labelled(ui, "Seed");
  const int by = stepper(ui, "seed", std::to_string(changed.seed), changed.seed > 0,
                         changed.seed < UINT64_MAX, width);
  if (by == 0) return;
  changed.seed += by > 0 ? 1u : UINT64_MAX;  // unsigned: adds -1
  ui.push(SetSettings{changed});
}

void draw_centre(const Ui& ui) {
  const float width = labelled(ui, "Centre of mass");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool own = ui.state.document.centre_of_mass.has_value();
  const float reset = own ? ui.control() : 0;
  const std::string value = own ? point_in_words(centre_of_mass(ui.state),
                                                 coordinate_decimals(ui.state.document.vertices))
                                : "centroid";
  const ImVec2 text = text_size(Face::text, value);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(at, ImVec2(at.x + width - reset, at.y + ui.control()), true);
  draw_text(list, Face::text, ImVec2(at.x, at.y + (ui.control() - text.y) / 2), ui.theme.text,
            value);
  list.PopClipRect();
  ImGui::Dummy(ImVec2(width - reset, ui.control()));
  if (!own) return;
  ImGui::SameLine(0, 0);
  if (icon_button(ui, "centroid", Icon::close, true, "Back to the centroid", ui.control()))
    ui.push(ReleaseCentre{});
}

}  // namespace

void draw_teams_stepper(const Ui& ui) {
  Settings changed = settings(ui.state);
  const bool all = !changed.teams, can_have_all = selects_candidates(changed.method);
  const float width = labelled(ui, "Teams"), for_all = 52;
  const std::uint32_t shown = all ? placed_teams(ui.state) : *changed.teams;
  const float stepper_width = can_have_all ? width - for_all - 8 : width;
  const int by = stepper(ui, "teams", std::to_string(shown), shown > 1, shown < max_teams && !all,
                         stepper_width);
  if (by != 0) {
    changed.teams = by > 0 ? shown + 1 : shown - 1;
    ui.push(SetSettings{changed});
  }
  if (!can_have_all) return;
  ImGui::SameLine(0, 8);
  if (tapped(ui, ImGui::InvisibleButton("all", ImVec2(for_all, ui.control())))) {
    changed = settings(ui.state);
    changed.teams = all ? std::optional<std::uint32_t>(placed_teams(ui.state)) : std::nullopt;
    ui.push(SetSettings{changed});
  }
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tip(ui, "A team on every candidate chord");
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour ground = all ? ui.theme.accent : hovered ? ui.theme.panel_line : ui.theme.well;
  list.AddRectFilled(low, high, ground.packed(), 7);
  const ImVec2 text = text_size(Face::text, "All");
  draw_text(list, Face::text, ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2),
            all ? ui.theme.on_accent : ui.theme.text, "All");
}

void draw_settings(const Ui& ui) {
  draw_method(ui);
  // On a narrow screen the closed sheet has this stepper already.
  if (ui.layout.wide) draw_teams_stepper(ui);
  draw_ratio(ui);
  draw_weight(ui);
  draw_capacity(ui);
  draw_seed(ui);
  draw_centre(ui);
}

}  // namespace evenlift::view
