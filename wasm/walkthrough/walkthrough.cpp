#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/notice.h"
#include "walkthrough/ask_why.h"
#include "walkthrough/script.h"
#include "walkthrough/timeline.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_visited = 60;

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

// Whether this step's numbers give away the answer to the next question.
bool gives_answer_away(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  const auto [at, count] = timeline(state);
  if (!walk.predict || walk.detail.step.kind != StepKind::sections || at + 1 >= count) return false;
  const std::uint32_t next = step_of(state, at + 1);
  const std::vector<std::uint32_t>& guessed = walk.guesses.steps;
  return next == walk.at + 1 && is_choice(*walk.trace, next) &&
         std::find(guessed.begin(), guessed.end(), next) == guessed.end();
}

// Shows the step without the parts that the next question asks for.
void look_at_present(AppState& state) {
  Walkthrough& walk = state.view.walkthrough;
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

// The step belongs to the document, so that links contain it; but changing it is not an edit to
// undo.
void publish(AppState& state, std::optional<std::uint32_t> step) {
  state.work.show().step = step;
  emit(state, DocumentChanged{});
}

bool is_main(const Walkthrough& walk, std::uint32_t step) {
  return std::binary_search(walk.main.begin(), walk.main.end(), step);
}

// The last main step up to this one.
std::uint32_t main_step_before(const Walkthrough& walk, std::uint32_t step) {
  return *(std::upper_bound(walk.main.begin() + 1, walk.main.end(), step) - 1);
}

std::uint32_t shown_step(const Walkthrough& walk, std::uint32_t step) {
  return walk.all_steps || walk.script ? step : main_step_before(walk, step);
}

void enter(AppState& state, std::uint32_t step) {
  Walkthrough& walk = state.view.walkthrough;
  forget_step(walk);
  state.view.selected.reset();  // a vertex's bar would remain over the drawing
  walk.at = std::min(step, walk.trace->size() - 1);
  settle_position(walk);
  if (!walk.script && !is_main(walk, walk.at)) walk.all_steps = true;
  look_at_present(state);
  remember(walk);
  publish(state, walk.at);
}

// Only the trace's units differ, so the step and its question stay.
void tell_in_other_units(AppState& state) {
  Walkthrough& walk = state.view.walkthrough;
  walk.trace = state.derived().trace;
  if (walk.ask || walk.answered || gives_answer_away(state)) return;
  walk.caption = caption(*walk.trace, walk.detail);
  walk.formula = formula(*walk.trace, walk.detail);
}

}  // namespace

std::optional<InputError> check_step(std::uint32_t step, const Trace& trace) {
  if (step < trace.size()) return std::nullopt;
  return InputError{ErrorCode::bad_setting,
                    say("must be less than {steps}, the number of steps", {trace.size()}),
                    {Place::Kind::option, 0, 0, "step"}};
}

void follow_trace(AppState& state) {
  Walkthrough& walk = state.view.walkthrough;
  const Derived& facts = state.derived();
  const std::optional<std::uint32_t> wanted = shown(state).step;
  const bool resumes = std::exchange(walk.resumes, false);
  if (!facts.trace) {
    if (walk.trace || (wanted && !facts.untraced.empty())) close_walkthrough(state);
    if (!facts.untraced.empty()) show(state, {Notice::Kind::problem, facts.untraced});
    return;
  }
  if (walk.trace == facts.trace || (!walk.trace && facts.refusal)) return;
  if (walk.trace && walk.traced == facts.traces) return tell_in_other_units(state);
  const bool follows = walk.trace && *wanted == walk.at;
  const Step before = follows ? walk.trace->step(walk.at) : Step{};
  walk.trace = facts.trace;
  walk.traced = facts.traces;
  walk.main = main_steps(*walk.trace);
  find_stops(walk);
  if (follows) {
    const std::optional<std::size_t> selected = state.view.selected;
    enter(state, shown_step(walk, nearest_step(*walk.trace, before)));
    // A vertex that was just added stays selected; a dragged one does not.
    if (!state.work.edit_open) state.view.selected = selected;
    return;
  }
  const std::uint32_t last = walk.trace->size() - 1;
  if (resumes) return enter(state, shown_step(walk, std::min(*wanted, last)));
  enter(state, *wanted);
  if (*wanted <= last) return;
  show(state,
       {Notice::Kind::problem,
        say("This lesson has no step {step}: this is its last, {last}.", {*wanted + 1, last + 1})});
}

void open_walkthrough(AppState& state, std::optional<std::uint32_t> at) {
  if (walkthrough_is_open(state) || !state.derived().placement || state.derived().refusal) return;
  state.work.second_method.reset();
  state.view.selected.reset();
  state.view.tool = Tool::parts;
  state.view.sheet = Sheet::closed;  // the step and its buttons are beside the drawing
  state.view.walkthrough.resumes = !at;
  state.work.show().step = at.value_or(state.view.walkthrough.at);
}

void close_walkthrough(AppState& state) {
  Walkthrough& walk = state.view.walkthrough;
  forget_step(walk);
  walk.trace.reset();
  walk.script.reset();
  walk.aside.reset();
  walk.playing = false;
  emit(state, DropFrameAfter{});
  walk.figures.clear();
  walk.visited.clear();
  publish(state, std::nullopt);
}

void go_to_step(AppState& state, std::uint32_t step) {
  if (walkthrough_is_open(state)) enter(state, step);
}

void go_to_position(AppState& state, std::uint32_t position) {
  if (state.view.walkthrough.script) state.view.walkthrough.script->position = position;
  enter(state, step_of(state, position));
}

void measure(AppState& state, std::uint32_t candidate) {
  Walkthrough& walk = state.view.walkthrough;
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
  forget_step(state.view.walkthrough);
  look_at_present(state);
}

void leave_script(AppState& state) {
  state.view.walkthrough.aside.reset();
  if (!state.view.walkthrough.script) return;
  state.view.walkthrough.script.reset();
  if (walkthrough_is_open(state)) enter(state, state.view.walkthrough.at);
  emit(state, DocumentChanged{});  // the address no longer names the lesson
}

void show_all_steps(AppState& state, bool all) {
  Walkthrough& walk = state.view.walkthrough;
  walk.all_steps = all;
  if (all && walk.script) walk.aside = std::exchange(walk.script, std::nullopt);
  if (!all && walk.aside && walk.aside->of.vertices == state.work.document().vertices &&
      walk.trace) {
    walk.script = std::exchange(walk.aside, std::nullopt);
    find_stops(walk);
    settle_position(walk);
    if (walk.script) go_to_position(state, timeline(state).at);
  } else if (walkthrough_is_open(state)) {
    enter(state, shown_step(walk, walk.at));
  }
  emit(state, DocumentChanged{});
}

}  // namespace evenlift::view
