#include "edits/placing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "edits/changed_settings.h"
#include "edits/outlook.h"
#include "edits/search.h"
#include "evenlift/link.h"
#include "evenlift/output/words.h"
#include "state/browser.h"
#include "state/method.h"
#include "state/notice.h"
#include "state/opened.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Two pictures of one method would show no difference: if the document takes over the second
// method, the two methods are exchanged.
void part_methods(AppState& state, Method former) {
  const Method now = state.document.settings.method;
  if (state.second_method != now) return;
  state.second_method = former == now ? std::nullopt : std::optional<Method>(former);
}

// The candidates if any load ratio were good enough.
Result<std::vector<Candidate>> all_candidates(const Placement& placement) {
  const Polygon& polygon = placement.polygon;
  if (!placement.stands) return find_candidates(polygon, placement.centre_of_mass, 0);
  auto found = standing_candidates(polygon, placement.centre_of_mass, 0, *placement.stands);
  if (!found) return found.error();
  return std::move(found->candidates);
}

// If no chord is even enough, the best load ratio that there is.
std::optional<double> best_ratio_if_none(const Placement& placement) {
  if (!placement.teams.empty() || !selects_candidates(placement.settings.method))
    return std::nullopt;
  const auto any = all_candidates(placement);
  if (!any || any->empty()) return std::nullopt;
  double best = 0;
  for (const Candidate& c : *any) best = std::max(best, c.chord.ratio);
  // Two decimals, as the slider has, and none of them too many.
  return std::floor(best * 100) / 100;
}

Haste haste(const AppState& state) { return state.edit_open ? Haste::drag : Haste::at_rest; }
// Places the second method, if there is one.
void renew_second(AppState& state) {
  constexpr auto balanced = Method::balanced;
  if (state.second && state.second->settings.method == balanced) drop_search(state);
  state.second.reset();
  if (!state.second_method) return;
  if (state.second_method == balanced) drop_search(state);
  Document document = state.placed;
  document.moved = {};
  const std::uint32_t teams = placed_teams(state);
  // So that both methods have as many robots.
  if (!document.settings.teams || document.settings.method == balanced)
    document.settings.teams = teams;
  if (state.second_method == balanced)
    document.settings.robots = std::clamp(2 * teams, fewest_robots(document.settings), most_robots);
  document.settings = with_method(document.settings, *state.second_method, teams);
  if (Result<Placement> placement = compute_placement(document, state.placement, haste(state)))
    state.second = std::move(placement).value();
}

// The plan for the capacity, if it can have changed; not during a drag, in which nobody reads it.
void renew_plan(AppState& state) {
  if (state.refusal || state.edit_open || !state.plan_due) return;
  state.plan.reset();
  drop_count(state);
  const std::optional<double>& capacity = shown(state).capacity;
  if (capacity) state.plan = plan_capacity(*state.placement, *capacity);
  if (capacity && state.placement->settings.method != Method::balanced)
    state.spare = plan_for_failures(*state.placement, *capacity);
  state.plan_due = false;
}

// Says at rest that teams are not exchanged, since nobody would wait for it.
void tell_of_no_exchange(AppState& state) {
  if (!waits_for_exchange(*state.placement)) return;
  show(state,
       {Notice::Kind::info, "So many teams are not exchanged here until they hold: among " +
                                std::to_string(state.placement->candidates.size()) +
                                " candidates that would take too long. The program does it."});
}

}  // namespace

void adopt(AppState& state, Result<Placement> placement) {
  ++state.revision;
  drop_search(state);
  state.explanation.reset();
  forget_failures(state);
  part_methods(state, state.placed.settings.method);
  const std::string before = state.refusal ? sentence(*state.refusal) : std::string();
  if (placement) {
    state.plan_due |= !state.placement || !same_plan(*state.placement, *placement) ||
                      state.placed.shown.capacity != shown(state).capacity;
    // The view makes room for larger robots.
    state.fit_due |=
        state.camera_follows && !(state.placed.settings.robot == settings(state).robot);
    state.placement = std::move(placement).value();
    state.placed = state.document;
    state.refusal.reset();
  } else {
    state.refusal = placement.error();
  }
  show(state, {});
  const std::string now = state.refusal ? sentence(*state.refusal) : std::string();
  if (now != before) browser::announce(now);
  browser::document_changed();
}

void follow_up(AppState& state) {
  if (state.refusal) return;
  renew_second(state);
  renew_outlook(state);
  state.best_ratio.reset();
  if (!state.edit_open) {
    tell_of_no_exchange(state);
    state.best_ratio = best_ratio_if_none(*state.placement);
    renew_plan(state);
    begin_search(state);
  }
  renew_failures(state);
}

void recompute(AppState& state, bool robots_stay) {
  if (!robots_stay) state.document.moved = {};
  adopt(state, compute_placement(state.document, state.placement, haste(state)));
  follow_up(state);
  follow_placement(state);
}

Beside beside(const AppState& state) { return {state.second_method, state.backdrop}; }

void begin_edit(AppState& state, bool live, Edit edit) {
  if (live && state.edit_open) return;
  state.history.record(state.document, beside(state), edit);
  state.edit_open = live;
}

void change_shown(AppState& state, Shown before, const Shown& after, bool live) {
  if (after == before) return;
  const bool is_edit = seen_as(after, before) != before;
  if (is_edit) begin_edit(state, live, edit_between({{}, {}, {}, before}, {{}, {}, {}, after}));
  for (Document* document : {&state.document, &state.placed})
    document->shown = with_changes(document->shown, before, after);
  if (state.walkthrough.trace) state.walkthrough.trace->units = shown(state).units;
  browser::document_changed();
  if (!is_edit) return;
  state.plan_due |= after.capacity != before.capacity;
  renew_plan(state);
  renew_outlook(state);
}

}  // namespace evenlift::view
