#include "app/update.h"

#include <optional>
#include <string>

#include "derive/derive.h"
#include "edits/undo.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/screen.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// If the document changes to the second method, the two methods are swapped: two pictures of one
// method would not differ.
void part_methods(AppState& state) {
  const Method now = settings(state).method, former = state.derived().placed.settings.method;
  std::optional<Method>& second = state.work.second_method;
  if (second == now) second = former == now ? std::nullopt : std::optional<Method>(former);
}

// What readings told stays when they no longer apply.
void settle_readings(AppState& state) {
  auto settled = without_stale_readings(state, state.work.document());
  if (!settled) return;
  state.work.edit() = *std::move(settled);
  show(state, {Notice::Kind::info, say("The weight and C stay as they were weighed.")});
}

std::string refusal_in_words(const AppState& state) {
  const std::optional<InputError>& refusal = state.derived().refusal;
  return refusal ? sentence(*refusal) : std::string();
}

// The end of a refusal only withdraws its announcement, before others follow.
void tell_of_refusal(AppState& state, const std::string& before) {
  const std::string now = refusal_in_words(state);
  if (now == before) return;
  Effects& effects = state.session.effects;
  effects.insert(now.empty() ? effects.begin() : effects.end(), Announce{now});
}

// Reports at rest that the teams are not swapped, because that takes too long.
void tell_of_no_swap(AppState& state) {
  const Derived& facts = state.derived();
  if (!facts.placement || facts.refusal || state.work.edit_open) return;
  if (!state.session.notice.text.empty()) return;  // the command's own notice
  if (!waits_for_swap(*facts.placement)) return;
  show(state,
       {Notice::Kind::info, say("The teams are not swapped here until they hold: with {candidates} "
                                "candidates that would take too long. The program does it.",
                                {facts.placement->candidates.size()})});
}

}  // namespace

void conclude(AppState& state) {
  const Derived& facts = state.derived();
  const Basis before = facts.basis;
  const RobotSize robot = facts.placed.settings.robot;
  const std::string refusal = refusal_in_words(state);
  if (state.work.edits() != before.edits) {
    part_methods(state);
    settle_readings(state);
  }
  derive(state);
  // The view makes room for larger robots.
  if (state.view.camera_follows && !(facts.placed.settings.robot == robot))
    state.view.fit_due = true;
  tell_of_refusal(state, refusal);
  if (facts.basis.edits != before.edits || before.haste == Haste::drag) tell_of_no_swap(state);
  follow_trace(state);
  scale_screen(state);
}

void place_now(AppState& state) {
  if (!state.derived().elsewhere.under_way) return;
  state.given.at_once = true;
  conclude(state);
}

}  // namespace evenlift::view
