// The three controls that everybody needs: the method, the number of robots, and the weight; and what
// belongs to robots placed by hand.
#include <string>
#include <vector>

#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "state/method.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/methods.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr float short_label = 84;  // of these controls

void draw_method(const Ui& ui) {
  const Settings& now = settings(ui.state);
  const float width = labelled(ui, "Method", "How the robots' places are chosen", short_label);
  const std::vector<Choice> choices = method_choices();
  const auto current = static_cast<std::size_t>(&words_of(now.method) - std::begin(methods));
  const auto chosen = dropdown(ui, "methods", "Method", choices, current, width);
  if (!chosen || *chosen == current) return;
  ui.push(SetMethod{methods[*chosen].method});
}

constexpr float weigh_width = 92;

void draw_weigh_button(const Ui& ui, float width) {
  if (flat_button(ui, "weigh", "Weigh it …", width))
    action(ActionId::weigh).run(ui.state, ui.commands);
  if (ImGui::IsItemHovered())
    tip(ui, "Type what scales, load cells or the robots read: this tells the weight and C");
}

void draw_weight(const Ui& ui) {
  Settings changed = settings(ui.state);
  const bool weighed = when::is_weighed(ui.state);
  if (weighed) changed.weight = ui.state.derived().placement->settings.weight;
  const bool can_weigh = !weighed && !ui.state.work.document().centre_of_mass &&
                         action(ActionId::weigh).enabled(ui.state);
  const std::string value = given_weight(changed.weight, shown(ui.state).units);
  const float width = labelled(ui, "Weight", "Weight of the whole object", short_label);
  const std::string label = say("Weight in {unit}", {weight_unit(ui.state)});
  const float beside = width - weigh_width - 8;
  const bool fits = text_size(Face::strong, value).x <= beside - 2 * ui.control() - 16;
  const int by = stepper(ui, "weight", value, can_weigh && fits ? beside : width,
                         {.can_lower = changed.weight > 1e-3,
                          .can_raise = changed.weight < 1e9,
                          .label = label.c_str(),
                          .setting = "weight",
                          .exact = shortest(changed.weight)});
  if (can_weigh && fits) ImGui::SameLine(0, 8);
  if (can_weigh) draw_weigh_button(ui, fits ? weigh_width : ImGui::GetContentRegionAvail().x);
  if (by == 0) return;
  changed.weight = stepped(changed.weight, by);
  ui.push(SetSettings{changed});
}

void draw_reset(const Ui& ui, float width) {
  ImGui::SameLine(0, 8);
  if (flat_button(ui, "reset robots", "Reset", width)) ui.push(ResetRobots{});
  if (ImGui::IsItemHovered()) tip(ui, "Put all robots back where the method placed them");
}

void draw_robots_stepper(const Ui& ui) {
  Settings changed = settings(ui.state);
  const float width = labelled(
      ui, "Robots", "Any number, even or odd; all robots can carry the same load", short_label);
  const float reset = by_hand(ui.state) ? 64.0f : 0.0f;
  const int by =
      stepper(ui, "robots", std::to_string(changed.robots), width - reset - (reset > 0 ? 8 : 0),
              {.can_lower = changed.robots > fewest_robots(changed),
               .can_raise = changed.robots < most_robots,
               .label = "Robots",
               .setting = "robots"});
  if (reset > 0) draw_reset(ui, reset);
  if (by == 0) return;
  changed.robots = by > 0 ? changed.robots + 1 : changed.robots - 1;
  ui.push(SetSettings{changed});
}

// For robots placed by hand, with the button that makes their loads equal.
void draw_supports_stepper(const Ui& ui) {
  const std::size_t robots = settings(ui.state).supports.size();
  constexpr float button = 92;
  const float width =
      labelled(ui, "Robots", "One more goes where it adds most to the lifting base; drag any robot",
               short_label);
  const bool challenge = ui.state.view.challenge;  // its card has the score; no help is given
  const int by =
      stepper(ui, "supports", std::to_string(robots), challenge ? width : width - button - 8,
              {.can_lower = robots > 1,
               .can_raise = robots < most_supports,
               .label = "Robots placed by hand"});
  if (by > 0) ui.push(AddRobot{});
  if (by < 0) ui.push(RemoveRobot{});
  if (challenge) return;
  ImGui::SameLine(0, 8);
  if (flat_button(ui, "even out", "Even out", button)) ui.push(EvenOut{});
  if (ImGui::IsItemHovered()) tip(ui, "Move two or three robots so that all carry the same load");
  // The field of the weight is on the open sheet.
  const bool closed = !ui.layout.wide && ui.state.view.sheet == Sheet::closed;
  if (closed && !ui.state.view.task) draw_weigh_button(ui, ImGui::GetContentRegionAvail().x);
}

}  // namespace

void draw_teams_stepper(const Ui& ui) {
  if (settings(ui.state).method == Method::given) return draw_supports_stepper(ui);
  if (settings(ui.state).method == Method::balanced) return draw_robots_stepper(ui);
  Settings changed = settings(ui.state);
  const bool all = !changed.teams, can_have_all = selects_candidates(changed.method);
  const float width =
                  labelled(ui, "Teams",
                           "Two robots each, at the two ends of a chord through the centre of mass",
                           short_label),
              for_all = 52, reset = by_hand(ui.state) ? 64 : 0;
  const std::uint32_t shown = all ? placed_teams(ui.state) : *changed.teams;
  const float stepper_width =
      width - (can_have_all ? for_all + 8 : 0) - (reset > 0 ? reset + 8 : 0);
  const int by = stepper(ui, "teams", std::to_string(shown), stepper_width,
                         {.can_lower = shown > 1,
                          .can_raise = shown < max_teams && !all,
                          .label = "Teams",
                          .setting = "teams"});
  if (by != 0) {
    changed.teams = by > 0 ? shown + 1 : shown - 1;
    ui.push(SetSettings{changed});
  }
  if (reset > 0) draw_reset(ui, reset);
  if (!can_have_all) return;
  ImGui::SameLine(0, 8);
  if (toggle_button(ui, "all", "All", "A team on every candidate chord", for_all, all)) {
    changed = settings(ui.state);
    changed.teams = all ? std::optional<std::uint32_t>(placed_teams(ui.state)) : std::nullopt;
    ui.push(SetSettings{changed});
  }
}

// The score, and a button that shows the same number of balanced robots in a second picture.
void draw_score(const Ui& ui) {
  text_block_of(Face::label, ui.theme.second_text, score(ui.state),
                ImGui::GetContentRegionAvail().x, 2);
  const bool compared = ui.state.work.second_method == Method::balanced;
  const float width = ImGui::GetContentRegionAvail().x;
  if (flat_button(ui, "evenlift's", compared ? "Hide evenlift's" : "Show evenlift's", width))
    ui.push(Compare{compared ? std::nullopt : std::optional(Method::balanced)});
  if (ImGui::IsItemHovered()) tip(ui, "As many balanced robots, in a second picture");
}

void draw_controls(const Ui& ui) {
  if (!stays_by_hand(ui.state)) draw_method(ui);
  // On a narrow screen the closed sheet already has this stepper.
  if (ui.layout.wide) draw_teams_stepper(ui);
  draw_weight(ui);
}

void draw_weighing(const Ui& ui) {
  text_block(Face::label, ui.theme.second_text, weighing_words(ui.state));
  if (flat_button(ui, "take over", "Take over", ImGui::GetContentRegionAvail().x))
    action(ActionId::take_over).run(ui.state, ui.commands);
  if (ImGui::IsItemHovered())
    tip(ui, "Makes this weight and C the object's, so that any method can place robots for it");
}

}  // namespace evenlift::view
