// The whole state of the view, in four parts, for the canvas and the panels. Commands change the
// work, the view and the session (app/update.h); the derived part follows from them, and only
// derive() writes it. No part depends on Dear ImGui.
#pragma once

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
  Given given;  // from the present commands to derive()
  const Derived& derived() const { return derived_; }

 private:
  friend void derive(AppState& state);
  Derived derived_;
};

inline bool walkthrough_is_open(const AppState& state) {
  return state.view.walkthrough.trace != nullptr;
}

// Without settings: only the drawing with the steps' words. O(1).
inline bool presents_steps(const AppState& state) {
  return state.view.presenting && walkthrough_is_open(state);
}

// Whether the open step knows the last lifting base, and so the forces and slopes that tip, and the
// places for a further load. O(1).
inline bool knows_base(const AppState& state) {
  const StepKind kind = state.view.walkthrough.detail.step.kind;
  return kind == StepKind::coverage || kind == StepKind::result;
}

// Whether closing the walkthrough restores what was open before a lesson. O(1).
inline bool in_lesson(const AppState& state) {
  return walkthrough_is_open(state) && state.view.walkthrough.of_lesson;
}

// The failed robot in the picture, or null. Lessons, and shapes being drawn or refused, show none.
// O(1).
inline const Failure* failing(const AppState& state) {
  const bool shown = state.derived().failure && !state.derived().refusal &&
                     !draws(state.view.tool) && !walkthrough_is_open(state);
  return shown ? &*state.derived().failure : nullptr;
}

// In one of the two pictures, with a failed robot considered. Precondition: it exists. O(1).
inline const Placement& shown_placement(const AppState& state, bool second = false) {
  if (second) return *state.derived().second;
  return failing(state) ? failing(state)->placement : *state.derived().placement;
}
inline const Outlook& shown_outlook(const AppState& state, bool second = false) {
  if (second) return state.derived().second_outlook;
  return failing(state) ? failing(state)->outlook : state.derived().outlook;
}

// Whether robots of the first picture were moved. O(1).
inline bool by_hand(const AppState& state) {
  return state.derived().placement && state.derived().placement->moved.any();
}

// The present ones. O(1).
inline const Settings& settings(const AppState& state) { return state.work.document().settings; }
inline const Shown& shown(const AppState& state) { return state.work.document().shown; }

// Whether the picture is older than the document, whose teams a worker is choosing; false if the
// document is refused. O(1).
inline bool lags(const AppState& state) {
  return state.derived().elsewhere.under_way && !state.derived().refusal;
}

// The last placed document, with what is shown, for links, files and storage. During a drag it may
// be older than the present one (lags()). O(n).
inline Document last_good(const AppState& state) {
  Document document = state.derived().placed;
  document.shown = shown(state);
  return document;
}

}  // namespace evenlift::view
