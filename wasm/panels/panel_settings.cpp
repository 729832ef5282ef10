// Method, teams, minimum load ratio, weight, and settings of only some methods or shapes.
#include <algorithm>
#include <cmath>

#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "state/method.h"
#include "tools/pick.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/methods.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

void draw_method(const Ui& ui) {
  const Settings& now = settings(ui.state);
  const float width = labelled(ui, "Method", "How the robots' places are chosen");
  const std::vector<Choice> choices = method_choices();
  const auto current = static_cast<std::size_t>(&words_of(now.method) - std::begin(methods));
  const auto chosen = dropdown(ui, "methods", "Method", choices, current, width);
  if (!chosen || *chosen == current) return;
  ui.push(SetMethod{methods[*chosen].method});
}

// Null if the ratio has an effect.
const char* why_no_ratio(Method method) {
  if (method == Method::given) return "Robots placed by hand are not chosen by their load ratio";
  if (method == Method::balanced)
    return "Balanced robots can all carry the same load: the ratio is always 1";
  return selects_candidates(method)
             ? nullptr
             : "This method places teams by direction, whatever their load ratio";
}

void draw_ratio(const Ui& ui) {
  Settings changed = settings(ui.state);
  constexpr const char* about = "The least load ratio of a team's two robots; 1 is even";
  const char* why_not = why_no_ratio(changed.method);
  const float width = labelled(ui, "Min. load ratio", why_not ? why_not : about), number = 44;
  const SliderResult moved = slider(ui, "ratio", "Minimum load ratio, as a slider",
                                    changed.min_ratio, 0, 1, 0.01, width - number, !why_not);
  if (ImGui::IsItemHovered()) tip(ui, why_not ? why_not : about);
  ImGui::SameLine(0, 0);
  number_field(ui, "min ratio", "Minimum load ratio", "min_ratio", fixed(moved.value, 2), number,
               why_not ? ui.theme.quiet : ui.theme.text, shortest(moved.value));
  if (moved.changed) {
    changed.min_ratio = moved.value;
    ui.push(SetSettings{changed, true});
  }
  if (moved.released) ui.push(EndEdit{});
}

// What readings told, if there are any.
const Placement* weighed(const Ui& ui) {
  const auto& placement = ui.state.derived().placement;
  return placement && placement->weighing ? &*placement : nullptr;
}

void draw_weight(const Ui& ui) {
  Settings changed = settings(ui.state);
  if (const Placement* placement = weighed(ui)) changed.weight = placement->settings.weight;
  const float width = labelled(ui, "Weight", "Weight of the whole object");
  const std::string label = say("Weight in {unit}", {weight_unit(ui.state)});
  const int by = stepper(ui, "weight", given_weight(changed.weight, shown(ui.state).units), width,
                         {.can_lower = changed.weight > 1e-3,
                          .can_raise = changed.weight < 1e9,
                          .label = label.c_str(),
                          .setting = "weight",
                          .exact = shortest(changed.weight)});
  if (by == 0) return;
  changed.weight = stepped(changed.weight, by);
  ui.push(SetSettings{changed});
}

void draw_seed(const Ui& ui) {
  Settings changed = settings(ui.state);
  if (changed.method != Method::random) return;
  const float width = labelled(ui, "Seed", "Another seed places other teams at random");
  const int by = stepper(ui, "seed", std::to_string(changed.seed), width,
                         {.can_lower = changed.seed > 0,
                          .can_raise = changed.seed < UINT64_MAX,
                          .label = "Seed",
                          .setting = "seed"});
  if (by == 0) return;
  changed.seed += by > 0 ? 1u : UINT64_MAX;  // unsigned: adds -1
  ui.push(SetSettings{changed});
}

struct WeighingRow {
  Setting setting;
  const char *label, *about;
};
constexpr WeighingRow weighing_rows[] = {
    {Setting::reading_error, "Readings off by",
     "How far a reading may be off: a part of each, such as 1%, or a weight"},
    {Setting::level_error, "Level within",
     "How far from level the robots' lifting points may be while you read, such as 1% or 0.5°"},
    {Setting::tilted, "Second: slope",
     "A second weighing on a known slope tells the height of C: its slope, such as 5°"},
    {Setting::heading, "Second: uphill", "The direction uphill, such as 1,0 or 90°"},
    {Setting::readings_tilted, "Second: readings",
     "What the robots read on that slope, in their order, with spaces between"},
};

// What the robots' readings tell (web/windows/table.js), and a way to keep it without them.
void draw_weighing(const Ui& ui) {
  if (!weighed(ui)) return;
  text_block(Face::label, ui.theme.second_text, weighing_words(ui.state));
  if (flat_button(ui, "take over", "Take over", ImGui::GetContentRegionAvail().x))
    action(ActionId::take_over).run(ui.state, ui.commands);
  if (ImGui::IsItemHovered())
    tip(ui, "Makes this weight and C the object's, so that any method can place robots for it");
  for (const WeighingRow& row : weighing_rows) {
    const std::string id(name(row.setting));
    const float width = labelled(ui, row.label, row.about);
    text_field(ui, id.c_str(), row.label, id.c_str(),
               text_of(row.setting, ui.state.work.document()), width);
  }
}

constexpr float weigh_width = 92;

void draw_weigh_button(const Ui& ui, float width) {
  if (flat_button(ui, "weigh", "Weigh it …", width))
    action(ActionId::weigh).run(ui.state, ui.commands);
  if (ImGui::IsItemHovered())
    tip(ui, "Type what scales, load cells or the robots read: this tells the weight and C");
}

void draw_centre(const Ui& ui) {
  const float width = labelled(
      ui, "Centre of mass", "Drag it in the drawing, or type x and y; the default is the centroid");
  const bool own = ui.state.work.document().centre_of_mass.has_value();
  const bool can_weigh = !own && !weighed(ui) && action(ActionId::weigh).enabled(ui.state);
  const float reset = own ? ui.control() : can_weigh ? weigh_width + 8 : 0;
  const std::string value =
      own || weighed(ui) ? point_in_words(centre_of_mass(ui.state),
                                          coordinate_decimals(ui.state.work.document().vertices))
                         : "centroid";
  const Vec2 centre = centre_of_mass(ui.state);
  const std::string exact =
      own || weighed(ui) ? shortest(centre.x) + ", " + shortest(centre.y) : "";
  text_field(ui, "com", "Centre of mass, x and y", "com", value, width - reset, exact);
  if (can_weigh) {
    ImGui::SameLine(0, 8);
    draw_weigh_button(ui, weigh_width);
  }
  if (!own) return draw_weighing(ui);
  ImGui::SameLine(0, 0);
  if (icon_button(ui, "centroid", Icon::close, true, "Back to the centroid", ui.control()))
    ui.push(ReleaseCentre{});
}

// The score, and a button that shows the same number of balanced robots in a second picture.
void draw_score(const Ui& ui) {
  if (!ui.state.derived().placement) return;
  text_block_of(Face::label, ui.theme.second_text, score(ui.state),
                ImGui::GetContentRegionAvail().x, 2);
  const bool compared = ui.state.work.second_method == Method::balanced;
  const float width = ImGui::GetContentRegionAvail().x;
  if (flat_button(ui, "evenlift's", compared ? "Hide evenlift's" : "Show evenlift's", width))
    ui.push(Compare{compared ? std::nullopt : std::optional(Method::balanced)});
  if (ImGui::IsItemHovered()) tip(ui, "As many balanced robots, in a second picture");
}

void draw_reset(const Ui& ui, float width) {
  ImGui::SameLine(0, 8);
  if (flat_button(ui, "reset robots", "Reset", width)) ui.push(ResetRobots{});
  if (ImGui::IsItemHovered()) tip(ui, "Put all robots back where the method placed them");
}

void draw_robots_stepper(const Ui& ui) {
  Settings changed = settings(ui.state);
  const float width =
      labelled(ui, "Robots", "Any number, even or odd; all robots can carry the same load");
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

// For robots placed by hand, with the button that makes their loads equal, and their score.
void draw_supports_stepper(const Ui& ui) {
  const std::size_t robots = settings(ui.state).supports.size();
  constexpr float button = 92;
  const float width = labelled(
      ui, "Robots", "One more goes where it adds most to the lifting base; drag any robot");
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
  // A closed sheet has no room for the score, and the field of C is on the open one.
  const bool closed = !ui.layout.wide && ui.state.view.sheet == Sheet::closed;
  if (closed && !ui.state.view.task) draw_weigh_button(ui, ImGui::GetContentRegionAvail().x);
  if (!closed) draw_score(ui);
}

}  // namespace

void draw_goal(const Ui& ui) {
  Settings changed = settings(ui.state);
  constexpr Choice goals[] = {{"Cover", "most of the object above the lifting base"},
                              {"Hold", "a hold with the minimum margin first"}};
  const Goal now = goal_of(changed);
  const float width = labelled(ui, "Goal",
                               changed.method == Method::balanced
                                   ? "Which comes first when sets of robots are compared"
                                   : "Whether teams are swapped until they hold the object");
  const auto chosen = dropdown(ui, "goals", "Goal", goals, static_cast<std::size_t>(now), width);
  if (chosen && *chosen != static_cast<std::size_t>(now)) {
    changed.goal.reset();  // the default goal need not be kept
    const auto wanted = static_cast<Goal>(*chosen);
    if (goal_of(changed) != wanted) changed.goal = wanted;
    ui.push(SetSettings{changed});
  }
  if (now != Goal::hold) return;
  const float beside =
      labelled(ui, "Min. margin", "A hold with at least this margin meets the goal");
  const int by = stepper(ui, "min margin", plain(changed.min_margin), beside,
                         {.can_lower = changed.min_margin > 0,
                          .can_raise = changed.min_margin < 1,
                          .label = "Minimum margin",
                          .setting = "min_margin"});
  if (by == 0) return;
  changed.min_margin = std::clamp(std::round(changed.min_margin * 100 + by) / 100, 0.0, 1.0);
  ui.push(SetSettings{changed});
}

void draw_teams_stepper(const Ui& ui) {
  if (settings(ui.state).method == Method::given) return draw_supports_stepper(ui);
  if (settings(ui.state).method == Method::balanced) return draw_robots_stepper(ui);
  Settings changed = settings(ui.state);
  const bool all = !changed.teams, can_have_all = selects_candidates(changed.method);
  const float width = labelled(
                  ui, "Teams",
                  "Two robots each, at the two ends of a chord through the centre of mass"),
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

namespace {

// Two buttons in one row; their sections open below them.
void draw_further_settings(const Ui& ui) {
  constexpr float gap = 8;
  const float head = ImGui::GetCursorPosY(), half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  draw_carrying_button(ui, half);
  ImGui::SameLine(0, gap);
  draw_more_button(ui, half);
  draw_carrying(ui, head);
  draw_more(ui, head);
}

}  // namespace

void draw_settings(const Ui& ui) {
  const bool by_hand_alone = stays_by_hand(ui.state);
  if (!by_hand_alone) draw_method(ui);
  // On a narrow screen the closed sheet already has this stepper.
  if (ui.layout.wide) draw_teams_stepper(ui);
  draw_ratio(ui);
  draw_weight(ui);
  draw_capacity(ui);
  draw_seed(ui);
  if (settings(ui.state).method == Method::balanced) draw_goal(ui);
  draw_centre(ui);
  draw_further_settings(ui);
  draw_robot_size(ui);
  if (!walkthrough_is_open(ui.state) && !by_hand_alone) draw_compare(ui);
}

}  // namespace evenlift::view
