// The whole state of the view, in four parts, for the canvas and the panels. Commands change the
// work, the view and the session (app/update.h). The derived part follows from these three, and
// only derive() writes it. No part depends on Dear ImGui.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "state/derived.h"
#include "state/session.h"
#include "state/view_state.h"
#include "state/work.h"

namespace evenlift::view {

struct AppState {
  Work work;
  View view;
  Session session;
  Given given;  // passed from the present commands to derive()
  const Derived& derived() const { return derived_; }

 private:
  friend void derive(AppState& state);
  Derived derived_;
};

// Returns whether the walkthrough is open. O(1).
inline bool walkthrough_is_open(const AppState& state) {
  return state.view.walkthrough.trace != nullptr;
}

// Returns whether presentation mode shows the walkthrough: only the drawing and the steps' words,
// without settings. O(1).
inline bool presents_steps(const AppState& state) {
  return state.view.presenting && walkthrough_is_open(state);
}

// Returns whether the open step shows what follows from the final lifting base: the forces and
// slopes that tip the object, and the places for a further load. O(1).
inline bool knows_base(const AppState& state) {
  const StepKind kind = state.view.walkthrough.detail.step.kind;
  return kind == StepKind::coverage || kind == StepKind::result;
}

// Returns whether closing the walkthrough restores what was open before a lesson. O(1).
inline bool in_lesson(const AppState& state) {
  return walkthrough_is_open(state) && state.view.walkthrough.of_lesson;
}

// Returns the failed robot that the picture shows, or null. The picture shows no failed robot while
// a walkthrough is open, a shape is being drawn, or the document is refused. O(1).
inline const Failure* failing(const AppState& state) {
  const bool shown = state.derived().failure && !state.derived().refusal &&
                     !draws(state.view.tool) && !walkthrough_is_open(state);
  return shown ? &*state.derived().failure : nullptr;
}

// Returns the placement in one of the two pictures. If the first picture shows a failed robot, this
// is the placement after its failure. Precondition: the placement exists. O(1).
inline const Placement& shown_placement(const AppState& state, bool second = false) {
  if (second) return *state.derived().second;
  const Failure* failure = failing(state);
  return failure ? failure->placement : *state.derived().placement;
}

// Returns the report about shown_placement(). O(1).
inline const Report& shown_report(const AppState& state, bool second = false) {
  if (second) return state.derived().second_report;
  const Failure* failure = failing(state);
  return failure ? failure->report : state.derived().report;
}

// Returns whether any robot of the first picture was moved by hand. O(1).
inline bool by_hand(const AppState& state) {
  return state.derived().placement && state.derived().placement->moved.any();
}

// Return the members `settings` and `shown` of the present document. O(1).
inline const Settings& settings(const AppState& state) { return state.work.document().settings; }
inline const Shown& shown(const AppState& state) { return state.work.document().shown; }

// Whether the robots are the user's to place, so that another method would give the answer away: in a
// challenge, and in a task unless its teams may be changed. O(1).
inline bool stays_by_hand(const AppState& state) {
  if (!state.view.challenge || settings(state).method != Method::given) return false;
  if (!state.view.task) return true;
  const std::vector<Movable>& may = state.view.task->lesson.task->may;
  return std::find(may.begin(), may.end(), Movable::teams) == may.end();
}

// Whether a hold, or failures, are of interest: always without a task, and in a task if it has a
// condition on them. O(1).
inline bool is_about_hold(const AppState& state) {
  return !state.view.task || state.view.task->asks_for_hold;
}
inline bool is_about_failures(const AppState& state) {
  return !state.view.task || state.view.task->asks_for_failures;
}

// Returns shown_placement() with its report. O(1).
inline Reported reported(const AppState& state, bool second = false) {
  return {{shown_placement(state, second), shown(state)}, shown_report(state, second)};
}

// Returns whether the picture is older than the document, because a worker is choosing the teams;
// false if the document is refused. O(1).
inline bool lags(const AppState& state) {
  return state.derived().elsewhere.under_way && !state.derived().refusal;
}

// Returns the last placed document with the present `shown`, for links, files and storage. During a
// drag it may be older than the present document (lags()). O(n).
inline Document last_good(const AppState& state) {
  Document document = state.derived().placed;
  document.shown = shown(state);
  return document;
}

}  // namespace evenlift::view
