#include "edits/try_edit.h"

#include <utility>

#include "edits/by_hand.h"
#include "edits/changed_settings.h"
#include "edits/outlook.h"
#include "edits/placing.h"
#include "edits/undo.h"
#include "state/opened.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Whether the edit leaves the placement as it is.
bool places_nothing(const AppState& state, const Document& edited) {
  return !state.refusal && edited.vertices == state.document.vertices &&
         edited.centre_of_mass == state.document.centre_of_mass &&
         edited.settings == settings(state);
}

// Goes to another step of the open document's walkthrough, or closes the walkthrough.
std::optional<InputError> try_step(AppState& state, std::optional<std::uint32_t> step) {
  std::optional<Trace> made;
  if (step && !walkthrough_is_open(state)) {
    put_teams_back(state);
    Result<Trace> trace = compute_trace(*state.placement, shown(state).units);
    if (!trace) return trace.error();
    made = std::move(trace).value();
  }
  if (step) {
    if (auto problem = check_step(*step, made ? *made : *state.walkthrough.trace)) return problem;
  }
  if (!step) {
    if (walkthrough_is_open(state)) leave_walkthrough(state);
    return std::nullopt;
  }
  if (!made) {
    go_to_step(state, *step);
    return std::nullopt;
  }
  state.document.shown.step = state.placed.shown.step = step;
  state.walkthrough.of_lesson = false;
  follow_placement(state, std::move(made));
  return std::nullopt;
}

}  // namespace

std::optional<InputError> try_edit(AppState& state, const Document& edited, std::uint64_t failed) {
  if (places_nothing(state, edited)) {
    if (auto problem = check_robot(*state.placement, failed)) return problem;
    const Shown before = shown(state);
    // This may leave a lesson, after which other settings are in force.
    if (auto problem = try_step(state, edited.shown.step)) return problem;
    change_shown(state, before, edited.shown);
    return std::nullopt;
  }
  Result<Placement> placement = compute_placement(edited, state.placement);
  if (!placement) return placement.error();
  if (auto problem = check_robot(*placement, failed)) return problem;
  std::optional<Trace> trace;
  // A step that is open follows the edit; another one must be there.
  if (edited.shown.step && edited.shown.step != shown(state).step) {
    Result<Trace> made = compute_trace(*placement, edited.shown.units);
    if (!made) return made.error();
    if (auto problem = check_step(*edited.shown.step, *made)) return problem;
    trace = std::move(made).value();
  }
  begin_edit(state, false, edit_between(state.document, edited));
  if (!walkthrough_is_open(state)) state.walkthrough.of_lesson = false;
  state.document = edited;
  adopt(state, std::move(placement));
  follow_up(state);
  follow_placement(state, std::move(trace));
  return std::nullopt;
}

}  // namespace evenlift::view
