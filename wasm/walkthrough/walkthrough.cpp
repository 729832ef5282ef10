#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/screen.h"

namespace evenlift::view {

void find_stops(Walkthrough& walk) {
  if (!walk.script) return;
  Script& script = *walk.script;
  script.stops.clear();
  for (const LessonStep& step : script.lesson.steps) {
    if (const auto found = find_step(*walk.trace, step.address))
      script.stops.push_back({*found, step.words});
  }
  if (script.stops.empty()) return walk.script.reset();
  script.position = std::min(script.position, script.stops.size() - 1);
}

void settle_position(Walkthrough& walk) {
  if (!walk.script) return;
  Script& script = *walk.script;
  if (script.stops[script.position].step == walk.at) return;
  const auto exact = std::find_if(script.stops.begin(), script.stops.end(),
                                  [&](const Stop& s) { return s.step == walk.at; });
  const auto later = std::find_if(script.stops.begin(), script.stops.end(),
                                  [&](const Stop& s) { return s.step > walk.at; });
  const auto at = exact != script.stops.end() ? exact : later;
  const auto index = at - script.stops.begin();
  script.position = static_cast<std::size_t>(
      exact != script.stops.end() ? index : std::max<std::ptrdiff_t>(index - 1, 0));
}

void begin_script(AppState& state, Script script) {
  Walkthrough& walk = state.view.walkthrough;
  walk.predict = script.lesson.predict;
  walk.guesses = {};
  walk.all_steps = false;
  walk.aside.reset();
  walk.script = std::move(script);
  walk.script->depth = state.work.history.depth();
  find_stops(walk);
  settle_position(walk);
}

bool script_is_true(const AppState& state) {
  const std::optional<Script>& script = state.view.walkthrough.script;
  const Document& document = state.work.document();
  return script && script->of.vertices == document.vertices && script->of.holes == document.holes &&
         script->of.centre_of_mass == document.centre_of_mass;
}

std::string words_of_stop(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.script || walk.ask) return {};
  const Document& of = walk.script->of;
  if (!script_is_true(state) || of.settings != settings(state) ||
      seen_as(of.shown, shown(state)) != shown(state))
    return say(
        "You changed the shape or a setting, so the lesson's words no longer apply. Undo brings them back.");
  const Stop& stop = walk.script->stops[walk.script->position];
  return stop.step == walk.at ? stop.words : std::string();
}

Timeline timeline(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.trace) return {};
  if (walk.script)
    return {static_cast<std::uint32_t>(walk.script->position),
            static_cast<std::uint32_t>(walk.script->stops.size())};
  if (walk.all_steps) return {walk.at, walk.trace->size()};
  const auto at = std::lower_bound(walk.main.begin(), walk.main.end(), walk.at);
  return {static_cast<std::uint32_t>(at - walk.main.begin()),
          static_cast<std::uint32_t>(walk.main.size())};
}

std::uint32_t step_of(const AppState& state, std::uint32_t position) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.script && walk.all_steps) return position;
  if (!walk.script) return walk.main[std::min<std::size_t>(position, walk.main.size() - 1)];
  return walk.script->stops[std::min<std::size_t>(position, walk.script->stops.size() - 1)].step;
}

std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.script && walk.all_steps) return step;
  const Timeline now = timeline(state);
  if (step_of(state, now.at) == step) return now.at;
  for (std::uint32_t position = 0; position < now.count; ++position)
    if (step_of(state, position) == step) return position;
  return std::nullopt;
}

std::vector<ChapterPart> chapter_parts(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  const Timeline now = timeline(state);
  if (!walk.trace || walk.script) return {{0, now.count}};
  std::vector<ChapterPart> parts;
  for (std::uint32_t c = 0; c < chapter_count; ++c) {
    const auto begin = walk.trace->chapter_begin(static_cast<Chapter>(c));
    if (!begin) continue;
    std::uint32_t first = *begin;
    if (!walk.all_steps)
      first = static_cast<std::uint32_t>(
          std::lower_bound(walk.main.begin(), walk.main.end(), *begin) - walk.main.begin());
    if (!parts.empty()) parts.back().count = first - parts.back().first;
    if (!parts.empty() && parts.back().count == 0) parts.pop_back();
    parts.push_back({first, now.count - first});
  }
  return parts;
}

double share_of(const std::vector<ChapterPart>& parts, std::uint32_t position) {
  std::size_t i = parts.size() - 1;
  while (i > 0 && parts[i].first > position) --i;
  const bool last = i + 1 == parts.size();
  const double within = position - parts[i].first;
  // The last step is at the very end of the timeline.
  const double inside = !last                ? within / parts[i].count
                        : parts[i].count > 1 ? within / (parts[i].count - 1)
                        : parts.size() > 1   ? 1.0
                                             : 0.0;
  return (static_cast<double>(i) + inside) / static_cast<double>(parts.size());
}

std::uint32_t position_at(const std::vector<ChapterPart>& parts, double share) {
  const double scaled = std::clamp(share, 0.0, 1.0) * static_cast<double>(parts.size());
  const std::size_t i = std::min(static_cast<std::size_t>(scaled), parts.size() - 1);
  const bool last = i + 1 == parts.size();
  const double steps = parts[i].count - (last ? 1.0 : 0.0);
  return parts[i].first +
         static_cast<std::uint32_t>(std::lround((scaled - static_cast<double>(i)) * steps));
}

namespace {

std::optional<std::uint32_t> next_step(const AppState& state, int by) {
  const Timeline now = timeline(state);
  const auto wanted = static_cast<std::int64_t>(now.at) + by;
  if (wanted < 0 || wanted >= now.count) return std::nullopt;
  return step_of(state, static_cast<std::uint32_t>(wanted));
}

}  // namespace

void move_steps(AppState& state, int by) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  const auto next = next_step(state, by);
  if (!next) {
    walk.playing = false;
    return;
  }
  const bool asked_already = walk.ask && walk.ask->step == *next;
  if (by > 0 && walk.predict && !asked_already && is_choice(*walk.trace, *next)) {
    ask(state, *next);
    if (walk.ask) return;
  }
  go_to_position(state, timeline(state).at + static_cast<std::uint32_t>(by));
}

void move_chapters(AppState& state, int by) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  const Timeline now = timeline(state);
  const auto chapter = [&](std::uint32_t position) {
    return walk.trace->step(step_of(state, position)).chapter;
  };
  const auto begin = [&](std::uint32_t position) {
    while (position > 0 && chapter(position - 1) == chapter(position)) --position;
    return position;
  };
  if (by < 0) {
    const std::uint32_t own = begin(now.at);
    return go_to_position(state, own < now.at || own == 0 ? own : begin(own - 1));
  }
  std::uint32_t to = now.at;
  while (to + 1 < now.count && chapter(to) == chapter(now.at)) ++to;
  go_to_position(state, to);
}

void set_playing(AppState& state, bool playing) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  if (playing && !next_step(state, 1)) go_to_position(state, 0);
  walk.playing = playing;
  walk.turn_at.reset();
  if (!playing) emit(state, DropFrameAfter{});
}

void set_speed(AppState& state, double speed) {
  state.view.walkthrough.speed = std::clamp(speed, slowest_speed, fastest_speed);
  state.view.walkthrough.turn_at.reset();
}

bool turn_over(AppState& state, double now) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state) || !walk.playing) return false;
  if (!walk.turn_at) {
    const double letters = static_cast<double>(walk.caption.size() + words_of_stop(state).size());
    const double pause = std::clamp(1 + 0.035 * letters, 1.5, 12.0) / walk.speed;
    walk.turn_at = now + pause;
    emit(state, FrameAfter{pause});
    return false;
  }
  if (now < *walk.turn_at) {
    if (*walk.turn_at - now < 0.05) emit(state, NextFrame{});
    return false;
  }
  move_steps(state, 1);
  emit(state, NextFrame{});
  return true;
}

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
