#include "derive/derive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "state/derived.h"
#include "state/method.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// The candidates of any load ratio.
Result<std::vector<Candidate>> all_candidates(const Placement& placement) {
  const Polygon& polygon = placement.polygon();
  if (!placement.stands) return find_candidates(polygon, placement.centre_of_mass, 0);
  auto found = standing_candidates(polygon, placement.centre_of_mass, 0, *placement.stands);
  if (!found) return found.error();
  return std::move(found->candidates);
}

// The number of balanced robots to compare with the placement.
std::uint32_t robots_beside(const Derived& facts, std::uint32_t teams) {
  return facts.placed.settings.method == Method::given
             ? static_cast<std::uint32_t>(facts.placed.settings.supports.size())
             : 2 * teams;
}

}  // namespace

Document by_other_method(const Derived& facts, Method method) {
  Document document = facts.placed;
  document.moved = {};
  const std::uint32_t teams = placed_teams(facts.placement);
  Settings& settings = document.settings;
  if (!settings.teams || is_one_team(settings.method)) settings.teams = teams;
  if (method == Method::balanced)
    settings.robots = std::clamp(robots_beside(facts, teams), fewest_robots(settings), most_robots);
  settings = with_method(settings, method, teams);
  return document;
}

Document settled(const Derived& facts, Document document) {
  if (!facts.placement || !facts.placement->weighing) return document;
  auto told = settled_after_edit(document, facts.placed, *facts.placement->weighing);
  return told ? *std::move(told) : document;
}

std::optional<double> best_ratio_if_none(const Placement& placement) {
  if (!placement.teams.empty() || !selects_candidates(placement.settings.method))
    return std::nullopt;
  const auto any = all_candidates(placement);
  if (!any || any->empty()) return std::nullopt;
  double best = 0;
  for (const Candidate& c : *any) best = std::max(best, c.chord.ratio);
  // To two decimals, like the slider's values.
  return std::floor(best * 100) / 100;
}

void renew_second(Derived& facts, const Work& work, Haste haste) {
  facts.second.reset();
  if (!work.second_method) return;
  const Document document = settled(facts, by_other_method(facts, *work.second_method));
  if (Result<Placement> placement = compute_placement(document, facts.placement, haste))
    facts.second = std::move(placement).value();
}

void adopt(Derived& facts, const Document& document, Result<Placement> placement) {
  if (!placement) {
    facts.refusal = placement.error();
    return;
  }
  facts.plan_due |= !facts.placement || !same_plan(*facts.placement, *placement);
  facts.placement = std::move(placement).value();
  facts.placed = document;
  facts.refusal.reset();
}

namespace {

// The others share the weight by springs, whichever model is shown.
Report report_of(const Placement& placement, const Failure& failure, const Shown& shown) {
  const Disturbance disturbance = disturbance_of(shown);
  const bool stays = failure.rest && failure.rest->stays;
  auto loads = disturbance.any() && stays ? ranges_without(placement, failure.robot, disturbance)
                                          : std::nullopt;
  return report_of_failure({failure.placement, shown}, failure.robot, failure.rest,
                           std::move(loads).value_or(std::vector<LoadRange>()));
}

// A millisecond or two at most, for each frame of a drag.
bool is_quick(const Placement& placement) {
  return count_robots(placement.teams) <= 16 && placement.vertices().size() <= 2000;
}

}  // namespace

void renew_reports(Derived& facts, LoadModel model, const Shown& shown) {
  if (!facts.placement) return;
  const ShownPlacement of(*facts.placement, shown);
  Report report = evenlift::report_of(of, {.model = model});
  if (!facts.failures_due && !facts.report.failures.empty()) {
    report.failures = std::move(facts.report.failures);
    if (report.has_capacities) report.overloaded_after = overloaded_after(of, report.failures);
  }
  facts.report = std::move(report);
  facts.second_report =
      facts.second ? evenlift::report_of({*facts.second, shown}, {.model = model}) : Report{};
  if (facts.failure) facts.failure->report = report_of(*facts.placement, *facts.failure, shown);
}

void renew_failures(Derived& facts, const Shown& shown, bool move) {
  if (!facts.failures_due || !facts.placement || facts.refusal) return;
  const Placement& placement = *facts.placement;
  if (move && !is_quick(placement)) return;
  facts.failures_due = false;
  facts.report.failures.clear();
  if (count_robots(placement.teams) <= most_failures_known)
    complete(facts.report, {placement, shown},
             {.model = facts.report.known.model, .failures = true});
}

void tell_plans(Derived& facts) {
  facts.report.plan = facts.plan_due ? std::nullopt : facts.plan;
  facts.report.if_one_fails = facts.plan_due ? std::nullopt : facts.spare;
  if (facts.failure) facts.failure->report.plan = facts.report.plan;
}

void let_fail(Derived& facts, std::size_t robot, const Shown& shown) {
  facts.failure.reset();
  const Placement& placement = *facts.placement;
  if (robot >= count_robots(placement.teams)) return;
  const bool known = robot < facts.report.failures.size();
  Failure failure{robot,
                  known ? facts.report.failures[robot]
                        : single_failure(placement, robot, disturbance_of(shown)),
                  with_failure(placement, robot),
                  {}};
  failure.report = report_of(placement, failure, shown);
  facts.failure = std::move(failure);
}

namespace {

class Derivation {
 public:
  Derivation(AppState& state, Derived& facts)
      : state_(state),
        given_(std::exchange(state.given, {})),
        facts_(facts),
        before_(facts.basis),
        effects_(state.session.effects) {
    now_ = {state.work.edits(),
            state.work.edit_open ? Haste::drag : Haste::at_rest,
            state.work.second_method,
            state.view.load_model,
            shown(state),
            state.view.challenge,
            state.view.fails.number,
            state.view.card.number};
  }

  // Each stage considers the changes of the preceding ones.
  void run() {
    const bool untraced = facts_.trace == nullptr;
    take_chosen();
    place();
    take_found();
    trace();
    place_second();
    plan();
    tell_loads();
    search();
    offer();
    let_fail();
    tell_plans(facts_);
    check();
    explain();
    tell_of_change();
    if (robots_ || second_ || fails_ || (facts_.trace == nullptr) != untraced) ++facts_.revision;
    facts_.basis = std::move(now_);
  }

 private:
  bool at_rest() const { return now_.haste == Haste::at_rest; }
  // A drag has ended, so postponed work is due.
  bool comes_to_rest() const { return at_rest() && before_.haste == Haste::drag; }
  // Whether a setting of which this is true has changed, of those that do not move robots.
  bool differ(bool SettingRow::*column) const {
    return !alike({{}, {}, {}, now_.shown}, {{}, {}, {}, before_.shown}, column);
  }

  void take_chosen();
  bool is_chosen_elsewhere();
  void place();
  void take_found();
  void trace();
  void tell_units();
  void place_second();
  void plan();
  void tell_loads();
  void search();
  void offer();
  void let_fail();
  void check();
  void explain();
  void explain_again();
  void tell_of_change();

  const AppState& state_;
  Given given_;
  Derived& facts_;
  Basis before_, now_;
  Effects& effects_;
  bool placed_ = false;  // the document was placed, or refused
  bool robots_ = false;  // the robots of the first picture may have changed
  bool second_ = false;  // and those of the second picture
  bool told_ = false;    // the loads were computed again
  bool fails_ = false;   // another robot fails, or none does
};

// The worker's choice for a document of the drag, unless the drag has ended.
void Derivation::take_chosen() {
  Elsewhere& elsewhere = facts_.elsewhere;
  if (!given_.chosen || !elsewhere.under_way || given_.chosen->number != elsewhere.number) return;
  elsewhere.under_way = false;
  elsewhere.possible = given_.chosen->choice.has_value();
  if (at_rest() || !elsewhere.possible) return;
  const Document document = std::exchange(elsewhere.document, {});
  auto choice = read_choice(*given_.chosen->choice, document.vertices.size());
  // If the worker refused the document, placing it here gives the reason.
  adopt(facts_, document,
        choice ? compute_as_chosen(document, *facts_.placement, *std::move(choice))
               : compute_placement(document, facts_.placement, now_.haste));
  before_.edits = elsewhere.edits;
  placed_ = robots_ = true;
}

// Whether a worker chooses this document's teams, or will do so after the present one.
bool Derivation::is_chosen_elsewhere() {
  Elsewhere& elsewhere = facts_.elsewhere;
  const Document& document = state_.work.document();
  const bool wanted = !at_rest() && elsewhere.possible && !given_.at_once && !given_.placement &&
                      facts_.placement && !now_.second_method && !now_.shown.step &&
                      !swaps_in_a_drag(*facts_.placement) &&
                      is_for_a_worker(document, *facts_.placement);
  if (!wanted) elsewhere.under_way = false;
  if (!wanted || elsewhere.under_way) return wanted;
  elsewhere = {elsewhere.number + 1, true, true, document, now_.edits};
  effects_.push_back(ChooseElsewhere{elsewhere.number, rings_as_numbers(document),
                                     settings_as_selected(document)});
  return true;
}

void Derivation::place() {
  const bool waits =
      comes_to_rest() && facts_.placement && !facts_.refusal && waits_for_swap(*facts_.placement);
  if (now_.edits == before_.edits && !waits) return;
  if (is_chosen_elsewhere()) {
    now_.edits = before_.edits;
    return;
  }
  placed_ = robots_ = true;
  drop_search(facts_, effects_);
  const Document& document = state_.work.document();
  if (given_.moved && document.settings.method != Method::given) {
    facts_.placement = std::move(*given_.placement);
    facts_.placed.moved = facts_.placement->moved;
  } else if (given_.placement) {
    adopt(facts_, document, std::move(*given_.placement));
  } else {
    adopt(facts_, document, compute_placement(document, facts_.placement, now_.haste));
  }
}

void Derivation::take_found() {
  if (!given_.found) return;
  const Taken taken = take(facts_, *given_.found);
  if (taken == Taken::nothing) return;
  effects_.push_back(SummaryChanged{});
  if (taken == Taken::count) return;
  told_ = true;
  const bool first = facts_.placement && facts_.placement->settings.method == Method::balanced;
  (first ? robots_ : second_) |= taken == Taken::other_robots;
}

// Traces the placement while a step is shown; during a drag, only the start of a search for
// balanced robots.
void Derivation::trace() {
  facts_.untraced.clear();
  if (!now_.shown.step) return facts_.trace.reset();
  if (facts_.refusal || !facts_.placement) return;
  const bool only_start = comes_to_rest() && facts_.trace && facts_.trace->balanced() &&
                          !facts_.trace->placement.search_ended;
  if (facts_.trace && !robots_ && !only_start) return tell_units();
  const HistoryLength length = at_rest() ? HistoryLength::whole : HistoryLength::start;
  Result<Trace> trace = given_.trace ? Result<Trace>(std::move(*given_.trace))
                                     : compute_trace(*facts_.placement, now_.shown.units, length);
  if (!trace) {
    facts_.trace.reset();
    facts_.untraced = sentence(trace.error()) + ".";
    return;
  }
  ++facts_.traces;
  facts_.trace = std::make_shared<const Trace>(std::move(trace).value());
  // The trace of balanced robots completes their search, so no other needs to continue it.
  const Placement& found = facts_.trace->placement;
  if (!facts_.trace->balanced() || !found.search_ended || facts_.placement->search_ended) return;
  end_search(facts_, effects_);
  facts_.placement = found;
  robots_ = true;
}

// The same trace in other units.
void Derivation::tell_units() {
  if (facts_.trace->units == now_.shown.units) return;
  Trace told = *facts_.trace;
  told.units = now_.shown.units;
  facts_.trace = std::make_shared<const Trace>(std::move(told));
}

void Derivation::place_second() {
  const bool waits = comes_to_rest() && facts_.second && waits_for_swap(*facts_.second);
  const bool due = (placed_ && (!given_.moved || facts_.placed.settings.method == Method::given)) ||
                   waits || now_.second_method != before_.second_method;
  if (!due || facts_.refusal) return;
  const auto balanced = [](const std::optional<Placement>& placement) {
    return placement && placement->settings.method == Method::balanced;
  };
  if (balanced(facts_.second)) drop_search(facts_, effects_);
  renew_second(facts_, state_.work, now_.haste);
  if (balanced(facts_.second)) drop_search(facts_, effects_);
  second_ = true;
}

// During a drag, the number of teams for a capacity and the best ratio wait.
void Derivation::plan() {
  facts_.plan_due |= differ(&SettingRow::plans);
  if (facts_.refusal || !facts_.placement) return;
  if (placed_ || comes_to_rest())
    facts_.best_ratio = at_rest() ? best_ratio_if_none(*facts_.placement) : std::nullopt;
  if (!at_rest() || !facts_.plan_due) return;
  facts_.plan_due = false;
  facts_.plan.reset();
  drop_count(facts_, effects_);
  if (!now_.shown.capacity) return;
  const double limit = limit_of(*now_.shown.capacity, now_.shown.carrying);
  facts_.plan = compute_plan(*facts_.placement, limit);
  if (facts_.placement->settings.method != Method::balanced)
    facts_.spare = plan_for_failures({*facts_.placement, now_.shown}, limit);
}

void Derivation::tell_loads() {
  const bool disturbed = disturbance_of(now_.shown) != disturbance_of(before_.shown);
  told_ |= robots_ || second_ || now_.load_model != before_.load_model || differ(&SettingRow::told);
  if (robots_ || disturbed) {
    facts_.report.failures.clear();
    facts_.failures_due = true;
  }
  if (robots_) {
    if (facts_.failure) fails_ = true;
    facts_.failure.reset();
  } else if (disturbed && facts_.failure) {
    facts_.failure->rest =
        single_failure(*facts_.placement, facts_.failure->robot, disturbance_of(now_.shown));
  }
  if (told_) renew_reports(facts_, now_.load_model, now_.shown);
}

void Derivation::search() {
  if (!at_rest()) return;
  begin_search(facts_, effects_);
  begin_count(facts_, now_.shown, effects_);
}

// No offer while a search can still improve the robots, nor in a walkthrough, embedded page or
// challenge.
void Derivation::offer() {
  facts_.offer_due |= robots_ || facts_.elsewhere.under_way ||
                      now_.challenge != before_.challenge || differ(&SettingRow::told);
  const bool shown = at_rest() && facts_.placement && facts_.placement->search_ended &&
                     !now_.shown.step && !state_.session.screen.embed && !now_.challenge;
  if (!facts_.offer_due) return;
  facts_.offer.reset();
  if (!shown) return;
  facts_.offer_due = false;
  renew_offer(facts_, now_.shown);
}

void Derivation::let_fail() {
  const bool held = state_.view.held.kind == Pick::Kind::robot;
  renew_failures(facts_, now_.shown, !at_rest() || facts_.search.under_way || held);
  if (now_.fails == before_.fails || !facts_.placement || facts_.refusal) return;
  facts_.failure.reset();
  fails_ = true;
  if (state_.view.fails.of) view::let_fail(facts_, *state_.view.fails.of, now_.shown);
  effects_.push_back(SummaryChanged{});
}

void Derivation::check() {
  const std::optional<OpenTask>& open = state_.view.task;
  facts_.attempt.reset();
  if (!open) return;
  facts_.attempt = Attempt();
  if (facts_.placement && !facts_.refusal)
    facts_.attempt = check_task(*open->lesson.task, open->exercise, state_.work.document(),
                                {*facts_.placement, now_.shown});
}

// The card stays with a robot moved by hand, and otherwise disappears when the robots change.
void Derivation::explain() {
  const std::optional<Pick>& of = state_.view.card.of;
  if (now_.card != before_.card) {
    facts_.explanation.reset();
    if (!of || facts_.refusal || !facts_.placement) return;
    facts_.explanation = view::explain(state_, *of);
    effects_.push_back(Announce{in_words(*facts_.explanation)});
  } else if (facts_.explanation && (robots_ || (second_ && facts_.explanation->of.second))) {
    explain_again();
  }
}

void Derivation::explain_again() {
  std::optional<std::size_t> robot = facts_.explanation->robot;
  facts_.explanation.reset();
  if (!given_.moved || !robot) return;
  if (robot == given_.moved->robot)
    robot = given_.moved->now;
  else if (robot == given_.moved->now)
    robot = given_.moved->robot;
  const auto [team, end] = find_robot(facts_.placement->teams, *robot);
  const Vec2& at = facts_.placement->teams[team].robots[end].point.position;
  facts_.explanation = view::explain(state_, {Pick::Kind::robot, team, static_cast<int>(end), at});
}

// Addresses and storage get the document after a drag: writing a large one takes longer than a
// frame.
void Derivation::tell_of_change() {
  const bool changed = placed_ || now_.shown != before_.shown;
  if (comes_to_rest() || (changed && at_rest()))
    effects_.push_back(DocumentChanged{});
  else if (changed)
    effects_.push_back(SummaryChanged{});
}

}  // namespace

void derive(AppState& state) { Derivation(state, state.derived_).run(); }

}  // namespace evenlift::view
