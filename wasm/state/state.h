// Everything that the view knows, in four parts. The canvas and the panels read it. Commands change
// the work, the view and the session (app/update.h); what is derived follows from those, and only
// derive() writes it. It does not depend on Dear ImGui.
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
  Given given;  // to what follows from the commands of now
  const Derived& derived() const { return derived_; }

 private:
  friend void derive(AppState& state);
  Derived derived_;
};

inline bool walkthrough_is_open(const AppState& state) {
  return state.view.walkthrough.trace != nullptr;
}

// Whether it was opened as a lesson: closing it brings back what was open before. O(1).
inline bool in_lesson(const AppState& state) {
  return walkthrough_is_open(state) && state.view.walkthrough.of_lesson;
}

// The robot that fails in the picture; null if none does. A lesson and a shape that is being drawn
// or refused show none. O(1).
inline const Failure* failing(const AppState& state) {
  const bool shown = state.derived().failure && !state.derived().refusal &&
                     state.view.tool != Tool::draw && !walkthrough_is_open(state);
  return shown ? &*state.derived().failure : nullptr;
}

// The placement in one of the two pictures, with a robot that fails, and what its robots bear;
// there must be one. O(1).
inline const Placement& shown_placement(const AppState& state, bool second = false) {
  if (second) return *state.derived().second;
  return failing(state) ? failing(state)->placement : *state.derived().placement;
}
inline const Outlook& shown_outlook(const AppState& state, bool second = false) {
  if (second) return state.derived().second_outlook;
  return failing(state) ? failing(state)->outlook : state.derived().outlook;
}

// Whether somebody moved robots of the first picture from where they were found. O(1).
inline bool by_hand(const AppState& state) {
  return state.derived().placement && state.derived().placement->moved.any();
}

// The settings in force, and what is shown. O(1).
inline const Settings& settings(const AppState& state) { return state.work.document().settings; }
inline const Shown& shown(const AppState& state) { return state.work.document().shown; }

// The last document that was not refused, as it is shown: links, files and storage hold it. O(n).
inline Document last_good(const AppState& state) {
  Document document = state.derived().placed;
  document.shown = shown(state);
  return document;
}

}  // namespace evenlift::view
