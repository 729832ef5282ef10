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
  const Settings but = placing_as(edited.settings, settings(state));
  return !state.refusal && edited.vertices == state.document.vertices &&
         edited.centre_of_mass == state.document.centre_of_mass && but == settings(state);
}

// Goes to another step of the open document's walkthrough, or closes the walkthrough.
std::optional<InputError> try_step(AppState& state, std::optional<std::uint32_t> step) {
  std::optional<Trace> made;
  if (step && !walkthrough_is_open(state)) {
    put_teams_back(state);
    Result<Trace> trace = compute_trace(*state.placement);
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
  state.document.settings.step = state.placed.settings.step = step;
  state.walkthrough.of_lesson = false;
  follow_placement(state, std::move(made));
  return std::nullopt;
}

}  // namespace

std::optional<InputError> try_edit(AppState& state, const Document& edited, std::uint64_t failed) {
  if (places_nothing(state, edited)) {
    if (auto problem = check_robot(*state.placement, failed)) return problem;
    const Settings before = settings(state), &after = edited.settings;
    // This may leave a lesson, after which other settings are in force.
    if (auto problem = try_step(state, after.step)) return problem;
    const bool capacity = before.capacity != after.capacity,
               radius = before.com_radius != after.com_radius, units = before.units != after.units;
    if (!capacity && !radius && !units) return std::nullopt;
    change_beside(state, false, edit_between(before, after), [&](Settings& s) {
      if (capacity) s.capacity = after.capacity;
      if (radius) s.com_radius = after.com_radius;
      if (units) s.units = after.units;
    });
    return std::nullopt;
  }
  Result<Placement> placement = compute_placement(edited, state.placement);
  if (!placement) return placement.error();
  if (auto problem = check_robot(*placement, failed)) return problem;
  std::optional<Trace> trace;
  // A step that is open follows the edit; another one must be there.
  if (edited.settings.step && edited.settings.step != settings(state).step) {
    Result<Trace> made = compute_trace(*placement);
    if (!made) return made.error();
    if (auto problem = check_step(*edited.settings.step, *made)) return problem;
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
