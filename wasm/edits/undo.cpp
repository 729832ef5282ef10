#include "edits/undo.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "edits/vertices.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/screen.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

bool differs(const SettingRow& row, const Document& a, const Document& b) {
  return text_of(row.setting, a) != text_of(row.setting, b);
}

}  // namespace

bool stand_alike(const Settings& a, const Settings& b) {
  const Document before{{}, {}, a}, after{{}, {}, b};
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::stands && differs(row, before, after)) return false;
  return true;
}

Edit edit_between(const Document& before, const Document& after) {
  std::optional<Edit> only;
  for (const SettingRow& row : all_settings()) {
    const bool centre = row.setting == Setting::com;
    if ((row.edit.empty() && !centre) || !differs(row, before, after)) continue;
    const Edit edit = !centre                ? edit_of(row)
                      : after.centre_of_mass ? Edit::centre_moved
                                             : Edit::centre_released;
    if (only.value_or(edit) != edit) return Edit::settings;
    only = edit;
  }
  return only.value_or(Edit::settings);
}

Shown with_changes(const Shown& shown, const Shown& before, const Shown& after) {
  Document changed{{}, {}, {}, shown};
  const Document from{{}, {}, {}, before}, to{{}, {}, {}, after};
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::shown && row.setting != Setting::step && differs(row, from, to))
      read_setting(row.setting, text_of(row.setting, to), changed);
  return changed.shown;
}

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

bool is_in_reach(const Placement& placement) {
  return check_centre_of_mass(placement.polygon(), placement.centre_of_mass).ok();
}

// What is typed, or set by a script, must fit; what did not fit before may stay.
std::optional<InputError> new_misfit(const Document& edited, const Placement& after,
                                     const std::optional<Placement>& before) {
  const auto was_left_out = [&](const Misplaced& each) {
    return before && std::find(before->left_out.begin(), before->left_out.end(), each) !=
                         before->left_out.end();
  };
  const bool fits = std::all_of(after.left_out.begin(), after.left_out.end(), was_left_out) &&
                    (is_in_reach(after) || (before && !is_in_reach(*before)));
  if (fits) return std::nullopt;
  const Result<Placement> placed = place(edited, Effort::start);
  return placed ? std::nullopt : std::optional(placed.error());
}

}  // namespace

std::optional<Document> without_stale_readings(const AppState& state, const Document& edited) {
  const Derived& facts = state.derived();
  if (!facts.placement || !facts.placement->weighing) return std::nullopt;
  return settled_after_edit(edited, facts.placed, *facts.placement->weighing);
}

std::optional<InputError> try_edit(AppState& state, const Document& wanted, std::uint64_t failed) {
  const auto settled = without_stale_readings(state, wanted);
  const Document& edited = settled ? *settled : wanted;
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
  if (auto problem = new_misfit(edited, *placement, state.derived().placement)) return problem;
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

namespace {

// Undoing a change of the picture's scale also undoes its effect on what is traced on it.
void recall_backdrop(AppState& state, const std::optional<Backdrop>& picture) {
  if (state.work.backdrop && picture && picture->picture == state.work.backdrop->picture)
    state.work.backdrop = picture;
  else if (state.work.backdrop)
    state.work.backdrop->traced = false;
}

bool is_open(const AppState& state) { return in_lesson(state) || state.view.task; }

void close_task(AppState& state) {
  state.view.task.reset();
  state.view.challenge = false;
}

void show_recalled(AppState& state, History::Recalled recalled) {
  const bool other_shape = count_handles(recalled.document) != count_handles(state.work.document());
  state.work.edit_open = false;
  show(state, {});
  state.given = {};
  state.work.edit() = std::move(recalled.document);
  if (other_shape) state.view.selected.reset();
  drop_stale_picks(state);
  const bool other_object = is_other_object(recalled.edit);
  if (other_object) state.work.aside = {};
  if (state.view.camera_follows && (other_object || !well_shown(state))) state.view.fit_due = true;
  recall_backdrop(state, recalled.beside.backdrop);
  state.work.second_method = shown(state).step ? std::nullopt : recalled.beside.second_method;
}

// `what` is announced for users who cannot see the change.
void step_back(AppState& state, History::Recalled recalled, const char* what) {
  Walkthrough& walk = state.view.walkthrough;
  Shown& former = recalled.document.shown;
  const Edit edit = recalled.edit;
  const bool leaves_lesson = is_open(state) && edit == Edit::lesson_opened;
  if (state.view.task && (leaves_lesson || state.work.history.depth() < state.view.task->depth))
    close_task(state);
  if (leaves_lesson || (walk.script && state.work.history.depth() < walk.script->depth)) {
    walk.script.reset();
    walk.aside.reset();
    walk.of_lesson = false;
  } else {
    // The step and the overlays change only when a lesson is left: then the former ones return.
    former = seen_as(former, shown(state));
  }
  // A walkthrough would show the teams at other places.
  if (!recalled.document.moved.teams.empty()) former.step.reset();
  show_recalled(state, std::move(recalled));
  announce(state, say(what, {in_words(edit)}));
}

std::optional<History::Recalled> before_lesson(AppState& state) {
  if (!is_open(state) || state.session.screen.embed) return std::nullopt;
  return state.work.history.leave_lesson(state.work.document(), beside(state.work));
}

// After an edit in the lesson, the message explains how to return to it.
void tell_of_return(AppState& state, bool edited) {
  if (edited)
    show(state, {Notice::Kind::info,
                 "Your work from before the lesson is back. Undo shows the lesson's object as you "
                 "left it."});
  else
    announce(state, "Your work from before the lesson is back.");
}

}  // namespace

void drop_stale_picks(AppState& state) {
  const Document& document = state.work.document();
  const std::size_t count = count_vertices(document);
  if (state.view.selected && *state.view.selected >= count_handles(document))
    state.view.selected.reset();
  for (Pick* pick : {&state.view.hover, &state.view.held}) {
    const bool of_polygon = pick->kind == Pick::Kind::vertex || pick->kind == Pick::Kind::edge;
    if (of_polygon && pick->index >= count) *pick = {};
    if (pick->kind == Pick::Kind::cargo && pick->index >= document.settings.cargo.size())
      *pick = {};
  }
}

void undo(AppState& state) {
  if (can_go_on_drawing(state)) return go_on_drawing(state);
  if (state.work.history.can_undo())
    step_back(state, state.work.history.undo(state.work.document(), beside(state.work)),
              "Undone: {edit}.");
}

void redo(AppState& state) {
  if (state.work.history.can_redo())
    step_back(state, state.work.history.redo(state.work.document(), beside(state.work)),
              "Redone: {edit}.");
}

void leave_walkthrough(AppState& state) {
  const std::size_t depth = state.work.history.depth();
  std::optional<History::Recalled> before = before_lesson(state);
  close_walkthrough(state);
  state.view.walkthrough.of_lesson = false;
  if (state.view.task) close_task(state);
  if (!before) return;
  // Step by step continues at the restored document's own step.
  Walkthrough& walk = state.view.walkthrough;
  walk.at = before->document.shown.step.value_or(0);
  walk.all_steps = false;
  walk.guesses = {};
  before->document.shown.step.reset();
  state.view.selected.reset();
  fit_view(state);
  show_recalled(state, *std::move(before));
  tell_of_return(state, state.work.history.depth() > depth);
}

void leave_task(AppState& state) {
  if (!state.view.task) return;
  const std::size_t depth = state.work.history.depth();
  std::optional<History::Recalled> before = before_lesson(state);
  close_task(state);
  if (!before) return;
  state.view.selected.reset();
  fit_view(state);
  show_recalled(state, *std::move(before));
  tell_of_return(state, state.work.history.depth() > depth);
}

void leave_lesson_for_another(AppState& state) {
  std::optional<History::Recalled> before = before_lesson(state);
  if (state.view.task) close_task(state);
  if (!before) return;
  state.work.edit() = std::move(before->document);
  state.work.second_method = before->beside.second_method;
  recall_backdrop(state, before->beside.backdrop);
}

void begin_edit(AppState& state, bool live, Edit edit) {
  if (live && state.work.edit_open) return;
  state.work.history.record(state.work.document(), beside(state.work), edit);
  state.work.edit_open = live;
}

Document& edit(AppState& state, bool live, Edit edit) {
  begin_edit(state, live, edit);
  show(state, {});
  state.given = {};
  Document& document = state.work.edit();
  document.moved = {};
  return document;
}

void change_shown(AppState& state, const Shown& before, const Shown& after, bool live) {
  if (after == before) return;
  if (seen_as(after, before) != before) {
    begin_edit(state, live, edit_between({{}, {}, {}, before}, {{}, {}, {}, after}));
    if (state.session.notice.kind == Notice::Kind::problem) show(state, {});  // it was mended
  }
  state.work.show() = with_changes(shown(state), before, after);
}

}  // namespace evenlift::view
