#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "state/browser.h"
#include "state/notice.h"
#include "state/opened.h"
#include "state/screen.h"
#include "walkthrough/ask_why.h"
#include "walkthrough/script.h"
#include "walkthrough/timeline.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_visited = 60;

// Forgets what belonged to the previous step.
void forget_step(Walkthrough& walk) {
  walk.ask.reset();
  walk.answered.reset();
  walk.verdict.clear();
  forget_why(walk);
  walk.hovered.reset();
  walk.measured.reset();
  walk.gained.clear();
  walk.turn_at.reset();
}

void show_gain(Walkthrough& walk, std::uint32_t candidate) {
  const TeamScores& scores = *walk.detail.scores;
  walk.measured = candidate;
  walk.gained.clear();
  if (scores.rule == Rule::score) walk.gained = gain_figures(*walk.trace, scores, candidate);
}

void look(Walkthrough& walk, std::uint32_t step) {
  const Trace& trace = *walk.trace;
  walk.detail = look_at(trace, step);
  walk.known = progress_at(trace, step);
  walk.figures = figures(trace, walk.detail);
  walk.base = trace.balanced() ? walk.detail.base : lifting_base(trace, walk.known);
  walk.caption = caption(trace, walk.detail);
  walk.formula = formula(trace, walk.detail);
  const std::optional<TeamScores>& scores = walk.detail.scores;
  if (scores && !scores->ranking.empty()) show_gain(walk, scores->ranking[0]);
}

// Whether the numbers of this step would answer the question that comes next.
bool gives_answer_away(const AppState& state) {
  const Walkthrough& walk = state.walkthrough;
  const auto [at, count] = timeline(state);
  if (!walk.predict || walk.detail.step.kind != StepKind::sections || at + 1 >= count) return false;
  const std::uint32_t next = step_of(state, at + 1);
  const std::vector<std::uint32_t>& guessed = walk.guesses.steps;
  return next == walk.at + 1 && is_choice(*walk.trace, next) &&
         std::find(guessed.begin(), guessed.end(), next) == guessed.end();
}

// Shows the present step, and in a challenge nothing of it that is about to be asked.
void look_at_present(AppState& state) {
  Walkthrough& walk = state.walkthrough;
  look(walk, walk.at);
  if (!gives_answer_away(state)) return;
  walk.caption = caption_before_choice(*walk.trace, walk.detail);
  walk.formula.clear();
  std::erase_if(walk.figures,
                [](const Figure& figure) { return figure.kind == FigureKind::section_end; });
}

void remember(Walkthrough& walk) {
  std::vector<Visited>& visited = walk.visited;
  if (!visited.empty() && visited.back().step == walk.at) visited.pop_back();
  visited.push_back({walk.at, walk.caption});
  if (visited.size() > most_visited) visited.erase(visited.begin());
}

// The step belongs to the document, so that links carry it; but it is no edit that could be undone.
void publish(AppState& state, std::optional<std::uint32_t> step) {
  state.document.shown.step = state.placed.shown.step = step;
  browser::document_changed();
}

bool is_main(const Walkthrough& walk, std::uint32_t step) {
  return std::binary_search(walk.main.begin(), walk.main.end(), step);
}

// The last main step that is not after this one.
std::uint32_t main_step_before(const Walkthrough& walk, std::uint32_t step) {
  return *(std::upper_bound(walk.main.begin() + 1, walk.main.end(), step) - 1);
}

// The step itself if it is shown, or else the main step before it.
std::uint32_t shown_step(const Walkthrough& walk, std::uint32_t step) {
  return walk.all_steps || walk.script ? step : main_step_before(walk, step);
}

void enter(AppState& state, std::uint32_t step) {
  Walkthrough& walk = state.walkthrough;
  forget_step(walk);
  state.selected.reset();  // the bar of a vertex would stay over the drawing
  walk.at = std::min(step, walk.trace->size() - 1);
  settle_position(walk);
  if (!walk.script && !is_main(walk, walk.at)) walk.all_steps = true;
  look_at_present(state);
  remember(walk);
  publish(state, walk.at);
}

// Balanced robots: the trace has searched to the end, so nobody need go on with it.
void take_over_search(AppState& state) {
  const Placement& found = state.walkthrough.trace->placement;
  if (!state.walkthrough.trace->balanced() || !found.search_ended || state.placement->search_ended)
    return;
  if (state.search.under_way) browser::end_search();
  state.search.under_way = state.search.due = false;
  state.placement = found;
  ++state.revision;
}

// Traces the placement. During a drag only the start of a search for balanced robots is traced. If that is impossible, says so in a notice and returns false.
bool trace_it(AppState& state, std::optional<Trace> made = std::nullopt) {
  const HistoryLength length = state.edit_open ? HistoryLength::start : HistoryLength::whole;
  Result<Trace> trace = made ? Result<Trace>(std::move(*made))
                             : compute_trace(*state.placement, shown(state).units, length);
  if (!trace) {
    show(state, {Notice::Kind::problem, sentence(trace.error()) + "."});
    close_walkthrough(state);
    return false;
  }
  state.walkthrough.trace = std::move(trace).value();
  state.walkthrough.main = main_steps(*state.walkthrough.trace);
  take_over_search(state);
  find_stops(state.walkthrough);
  return true;
}

}  // namespace

std::optional<InputError> check_step(std::uint32_t step, const Trace& trace) {
  if (step < trace.size()) return std::nullopt;
  return InputError{
      ErrorCode::bad_setting,
      "must be less than " + std::to_string(trace.size()) + ", the number of steps of this lesson",
      {Place::Kind::option, 0, 0, "step"}};
}

void follow_placement(AppState& state, std::optional<Trace> made) {
  Walkthrough& walk = state.walkthrough;
  const std::optional<std::uint32_t> wanted = state.document.shown.step;
  if (!wanted) {
    if (walk.trace) close_walkthrough(state);
    return;
  }
  if (state.refusal || !state.placement) return;
  const bool moved = !walk.trace || *wanted != walk.at;
  const std::optional<Step> before =
      moved ? std::nullopt : std::optional<Step>(walk.trace->step(walk.at));
  if (!trace_it(state, std::move(made))) return;
  if (before) {
    enter(state, shown_step(walk, nearest_step(*walk.trace, *before)));
    return;
  }
  const std::uint32_t last = walk.trace->size() - 1;
  enter(state, *wanted);
  if (*wanted <= last) return;
  show(state,
       {Notice::Kind::problem, "This lesson has no step " + std::to_string(*wanted + 1) +
                                   ": it is at its last, " + std::to_string(last + 1) + "."});
}

void open_walkthrough(AppState& state, std::optional<std::uint32_t> at) {
  if (walkthrough_is_open(state) || !state.placement || state.refusal) return;
  state.second_method.reset();
  state.second.reset();
  state.selected.reset();
  state.tool = Tool::parts;
  state.sheet = Sheet::closed;  // which shows the step and its buttons beside the drawing
  Walkthrough& walk = state.walkthrough;
  if (trace_it(state)) enter(state, at ? *at : shown_step(walk, walk.at));
}

void close_walkthrough(AppState& state) {
  Walkthrough& walk = state.walkthrough;
  forget_step(walk);
  walk.trace.reset();
  walk.script.reset();
  walk.aside.reset();
  walk.playing = false;
  browser::drop_frame_after();
  walk.figures.clear();
  walk.visited.clear();
  publish(state, std::nullopt);
  set_presenting(state, false);
  ++state.revision;
}

void go_to_step(AppState& state, std::uint32_t step) {
  if (walkthrough_is_open(state)) enter(state, step);
}

void go_to_position(AppState& state, std::uint32_t position) {
  if (state.walkthrough.script) state.walkthrough.script->position = position;
  enter(state, step_of(state, position));
}

void measure(AppState& state, std::uint32_t candidate) {
  Walkthrough& walk = state.walkthrough;
  if (walkthrough_is_open(state) && walk.detail.scores &&
      candidate < walk.detail.scores->of_candidate.size())
    show_gain(walk, candidate);
}

void look_before_choice(Walkthrough& walk) {
  const Ask& asked = *walk.ask;
  look(walk, asked.step - 1);
  walk.measured.reset();
  walk.gained.clear();
  walk.caption.clear();
  walk.formula.clear();
  const bool pair = asked.question.kind == QuestionKind::nearer_end;
  std::erase_if(walk.figures, [&](const Figure& figure) {
    return !pair || (figure.kind != FigureKind::edge && figure.kind != FigureKind::section);
  });
}

void show_step_again(AppState& state) {
  if (!walkthrough_is_open(state)) return;
  forget_step(state.walkthrough);
  look_at_present(state);
}

void leave_script(AppState& state) {
  state.walkthrough.aside.reset();
  if (!state.walkthrough.script) return;
  state.walkthrough.script.reset();
  // The step may be no main step; then all are shown around it.
  if (walkthrough_is_open(state)) enter(state, state.walkthrough.at);
  browser::document_changed();  // the address names the lesson no more
}

void show_all_steps(AppState& state, bool all) {
  Walkthrough& walk = state.walkthrough;
  walk.all_steps = all;
  if (all && walk.script) walk.aside = std::exchange(walk.script, std::nullopt);
  if (!all && walk.aside && walk.aside->of.vertices == state.document.vertices && walk.trace) {
    walk.script = std::exchange(walk.aside, std::nullopt);
    find_stops(walk);
    settle_position(walk);
    if (walk.script) go_to_position(state, timeline(state).at);
  } else if (walkthrough_is_open(state)) {
    enter(state, shown_step(walk, walk.at));
  }
  browser::document_changed();
}

std::optional<InputError> join_script(AppState& state, Script script) {
  if (state.refusal || !state.placement || state.document.vertices != script.of.vertices)
    return InputError{ErrorCode::bad_syntax, "it is of another polygon than the link", {}};
  const bool begins = !walkthrough_is_open(state);
  open_walkthrough(state);
  if (!walkthrough_is_open(state)) return std::nullopt;  // and a notice says why
  begin_script(state, std::move(script));
  if (begins) enter(state, step_of(state, 0));
  return std::nullopt;
}

}  // namespace evenlift::view
