#include "edits/try_edit.h"

#include <string>
#include <utility>

#include "edits/by_hand.h"
#include "edits/changed_settings.h"
#include "edits/editing.h"
#include "edits/undo.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "state/opened.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

bool places_nothing(const AppState& state, const Document& edited) {
  return !state.derived().refusal && edited.vertices == state.work.document().vertices &&
         edited.holes == state.work.document().holes &&
         edited.centre_of_mass == state.work.document().centre_of_mass &&
         edited.settings == settings(state);
}

// With the teams at their original places.
std::optional<InputError> try_to_open(AppState& state, std::uint32_t step, const Units& units) {
  Result<Placement> found = *state.derived().placement;
  if (!state.work.document().moved.teams.empty()) {
    Document document = state.work.document();
    document.moved = {};
    found = compute_placement(document, found.value());
  }
  if (!found) return found.error();
  Result<Trace> trace = compute_trace(*found, units);
  if (!trace) return trace.error();
  if (auto problem = check_step(step, *trace)) return problem;
  put_teams_back(state);
  state.given = {std::move(found).value(), std::move(trace).value(), {}, {}};
  state.work.show().step = step;
  state.view.walkthrough.of_lesson = false;
  return std::nullopt;
}

// Goes to a step of the open document's walkthrough, or closes it.
std::optional<InputError> try_step(AppState& state, const Shown& wanted) {
  const std::optional<std::uint32_t> step = wanted.step;
  if (!step) {
    if (walkthrough_is_open(state)) leave_walkthrough(state);
    return std::nullopt;
  }
  if (!walkthrough_is_open(state)) return try_to_open(state, *step, wanted.units);
  if (auto problem = check_step(*step, *state.view.walkthrough.trace)) return problem;
  go_to_step(state, *step);
  return std::nullopt;
}

std::optional<InputError> check_robot(const Placement& placement, std::uint64_t number) {
  const std::size_t count = count_robots(placement.teams);
  if (number <= count) return std::nullopt;
  InputError error = setting_error(Setting::failed);
  error.message =
      count == 0
          ? say("there is no robot {robot}: there are none", {std::to_string(number)})
          : say("there is no robot {robot}: there are {robots}", {std::to_string(number), count});
  return error;
}

}  // namespace

std::optional<InputError> try_edit(AppState& state, const Document& edited, std::uint64_t failed) {
  if (places_nothing(state, edited)) {
    if (auto problem = check_robot(*state.derived().placement, failed)) return problem;
    const Shown before = shown(state);
    // This may leave a lesson, which restores other settings.
    if (auto problem = try_step(state, edited.shown)) return problem;
    change_shown(state, before, edited.shown);
    return std::nullopt;
  }
  Result<Placement> placement = compute_placement(edited, state.derived().placement);
  if (!placement) return placement.error();
  if (auto problem = check_robot(*placement, failed)) return problem;
  std::optional<Trace> trace;
  // An open step follows the edit; any other must exist.
  if (edited.shown.step && edited.shown.step != shown(state).step) {
    Result<Trace> made = compute_trace(*placement, edited.shown.units);
    if (!made) return made.error();
    if (auto problem = check_step(*edited.shown.step, *made)) return problem;
    trace = std::move(made).value();
  }
  Document& document = edit(state, false, edit_between(state.work.document(), edited));
  if (!walkthrough_is_open(state)) state.view.walkthrough.of_lesson = false;
  document = edited;
  state.given = {std::move(placement).value(), std::move(trace), {}, {}};
  return std::nullopt;
}

}  // namespace evenlift::view
