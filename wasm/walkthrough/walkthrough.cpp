#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "state/browser.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_visited = 60;

// Forgets what belonged to the previous step.
void forget_step(Walkthrough& walk) {
  walk.ask.reset();
  walk.verdict.clear();
  walk.asked.reset();
  walk.asked_places.clear();
  walk.why.clear();
  walk.why_taken = false;
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

void look(Walkthrough& walk) {
  const Trace& trace = *walk.trace;
  walk.detail = look_at(trace, walk.at);
  walk.known = progress_at(trace, walk.at);
  walk.figures = figures(trace, walk.detail);
  walk.base = trace.balanced() ? walk.detail.base : lifting_base(trace, walk.known);
  walk.caption = caption(trace, walk.detail);
  walk.formula = formula(trace, walk.detail);
  const std::optional<TeamScores>& scores = walk.detail.scores;
  if (scores && !scores->ranking.empty()) show_gain(walk, scores->ranking[0]);
}

void remember(Walkthrough& walk) {
  std::vector<Visited>& visited = walk.visited;
  if (!visited.empty() && visited.back().step == walk.at) visited.pop_back();
  visited.push_back({walk.at, walk.caption});
  if (visited.size() > most_visited) visited.erase(visited.begin());
}

// The step belongs to the document, so that links carry it; but it is no edit that could be undone.
void publish(AppState& state, std::optional<std::uint32_t> step) {
  state.document.settings.step = state.placed.settings.step = step;
  browser::document_changed();
}

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

// Finds the stop for a step that was not reached from stop to stop.
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
  walk.at = std::min(step, walk.trace->size() - 1);
  settle_position(walk);
  if (!walk.script && !is_main(walk, walk.at)) walk.all_steps = true;
  look(walk);
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
  Result<Trace> trace =
      made ? Result<Trace>(std::move(*made)) : compute_trace(*state.placement, length);
  if (!trace) {
    state.notice = {Notice::Kind::problem, sentence(trace.error()) + "."};
    browser::announce(state.notice.text);
    close_walkthrough(state);
    return false;
  }
  state.walkthrough.trace = std::move(trace).value();
  state.walkthrough.main = main_steps(*state.walkthrough.trace);
  take_over_search(state);
  find_stops(state.walkthrough);
  return true;
}

std::optional<std::uint32_t> next_step(const AppState& state, int by) {
  const Timeline now = timeline(state);
  const auto wanted = static_cast<std::int64_t>(now.at) + by;
  if (wanted < 0 || wanted >= now.count) return std::nullopt;
  return step_of(state, static_cast<std::uint32_t>(wanted));
}

// Enters the step at a position; a script may have several stops at one step.
void enter_position(AppState& state, std::uint32_t position) {
  if (state.walkthrough.script) state.walkthrough.script->position = position;
  enter(state, step_of(state, position));
}

// Whether there is nothing to guess: one candidate only, or two ends that are as even as each other.
bool is_trivial(const Ask& asked) {
  if (asked.question.kind != QuestionKind::nearer_end) return asked.choices.size() < 2;
  const auto& ends = asked.detail.pair->ends;
  return ratio_in_words(ends[0].ratio) == ratio_in_words(ends[1].ratio);
}

// Whether the question is one of the few of its kind; if not, the choice is told.
bool may_ask(Walkthrough& walk, const Ask& asked) {
  std::vector<std::uint32_t>& steps =
      walk.guesses.asked[static_cast<std::size_t>(asked.question.kind)];
  const auto has = [&](const std::vector<std::uint32_t>& some) {
    return std::find(some.begin(), some.end(), asked.step) != some.end();
  };
  if (has(steps)) return true;
  if (steps.size() < most_questions) {
    steps.push_back(asked.step);
    return true;
  }
  if (!has(walk.guesses.told)) walk.guesses.told.push_back(asked.step);
  return false;
}

// Any choice but the answer: what is offered first must not give it away.
std::size_t first_offered(const Ask& asked) {
  const std::size_t n = asked.choices.size();
  const auto answer = static_cast<std::size_t>(
      std::find(asked.choices.begin(), asked.choices.end(), asked.question.answer) -
      asked.choices.begin());
  return n < 2 ? 0 : (answer + 1 + asked.step % (n - 1)) % n;
}

void ask(Walkthrough& walk, std::uint32_t step) {
  const Trace& trace = *walk.trace;
  Ask asked;
  asked.step = step;
  asked.detail = look_at(trace, step);
  const std::optional<Question> question = evenlift::question(trace, asked.detail);
  if (!question) return;
  asked.question = *question;
  asked.text = question_text(trace, asked.detail, *question);
  // In their order, as a ranking would give the answer away.
  asked.choices = choices(trace, asked.detail, *question);
  if (is_trivial(asked) || !may_ask(walk, asked)) return;
  asked.pointed = first_offered(asked);
  walk.ask = std::move(asked);
  walk.playing = false;
  browser::announce(walk.ask->text);
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
  const std::optional<std::uint32_t> wanted = state.document.settings.step;
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
  state.notice = {Notice::Kind::problem, "This lesson has no step " + std::to_string(*wanted + 1) +
                                             ": it is at its last, " + std::to_string(last + 1) +
                                             "."};
  browser::announce(state.notice.text);
}

void open_walkthrough(AppState& state, std::optional<std::uint32_t> at) {
  if (walkthrough_is_open(state) || !state.placement || state.refusal) return;
  state.second_method.reset();
  state.second.reset();
  state.selected.reset();
  state.tool = Tool::parts;
  Walkthrough& walk = state.walkthrough;
  if (trace_it(state)) enter(state, at ? *at : shown_step(walk, walk.at));
}

void close_walkthrough(AppState& state) {
  Walkthrough& walk = state.walkthrough;
  forget_step(walk);
  walk.trace.reset();
  walk.script.reset();
  walk.playing = false;
  browser::drop_frame_after();
  walk.figures.clear();
  walk.visited.clear();
  publish(state, std::nullopt);
  if (std::exchange(state.presenting, false)) browser::show_full_screen(false);
  ++state.revision;
}

void go_to_step(AppState& state, std::uint32_t step) {
  if (walkthrough_is_open(state)) enter(state, step);
}

void move_steps(AppState& state, int by) {
  Walkthrough& walk = state.walkthrough;
  if (!walkthrough_is_open(state)) return;
  const auto next = next_step(state, by);
  if (!next) {
    walk.playing = false;
    return;
  }
  const bool asked_already = walk.ask && walk.ask->step == *next;
  if (by > 0 && walk.predict && !asked_already && is_choice(*walk.trace, *next)) {
    ask(walk, *next);
    if (walk.ask) return;
  }
  enter_position(state, timeline(state).at + static_cast<std::uint32_t>(by));
}

void move_chapters(AppState& state, int by) {
  Walkthrough& walk = state.walkthrough;
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
    // From inside a chapter, back means to its beginning.
    const std::uint32_t own = begin(now.at);
    return enter_position(state, own < now.at || own == 0 ? own : begin(own - 1));
  }
  std::uint32_t to = now.at;
  while (to + 1 < now.count && chapter(to) == chapter(now.at)) ++to;
  enter_position(state, to);
}

void set_playing(AppState& state, bool playing) {
  Walkthrough& walk = state.walkthrough;
  if (!walkthrough_is_open(state)) return;
  // At the end, playing begins again.
  if (playing && !next_step(state, 1)) enter_position(state, 0);
  walk.playing = playing;
  walk.turn_at.reset();
  if (!playing) browser::drop_frame_after();
}

void set_speed(AppState& state, double speed) {
  state.walkthrough.speed = std::clamp(speed, slowest_speed, fastest_speed);
  state.walkthrough.turn_at.reset();
}

void set_predict(AppState& state, bool on) {
  if (on && !state.walkthrough.predict) state.walkthrough.guesses = {};
  state.walkthrough.predict = on;
  if (!on) state.walkthrough.ask.reset();
}

void guess(AppState& state, std::uint32_t answer) {
  Walkthrough& walk = state.walkthrough;
  if (!walkthrough_is_open(state) || !walk.ask) return;
  const Ask asked = *walk.ask;
  const bool right = answer == asked.question.answer;
  std::vector<std::uint32_t>& guessed = walk.guesses.steps;
  if (std::find(guessed.begin(), guessed.end(), asked.step) == guessed.end()) {
    guessed.push_back(asked.step);
    walk.guesses.right += right ? 1 : 0;
  }
  std::string verdict = right ? "Right." : "Not this time.";
  if (!right && asked.question.kind == QuestionKind::winning_chord)
    verdict += " " + why_not_text(*walk.trace, why_not(*walk.trace, asked.step, answer));
  if (!right && asked.question.kind == QuestionKind::even_chord)
    verdict += " " + even_chord_text(*walk.trace, asked.detail, answer);
  if (!right && asked.detail.swap)
    verdict += " " + other_swap_text(*walk.trace, asked.detail, asked.question, answer);
  if (walk.script && timeline(state).at + 1 < timeline(state).count)
    walk.script->position = timeline(state).at + 1;
  enter(state, asked.step);
  walk.verdict = verdict;
  walk.was_right = right;
  browser::announce(verdict);
}

namespace {

// Why no balanced robot stands at the place of the boundary that is nearest.
void ask_why_no_robot(AppState& state, const Vec2& at) {
  Walkthrough& walk = state.walkthrough;
  const double reach = (state.screen.touch ? 22 : 14) / state.camera.scale;
  const WhyNoRobot answer = why_no_robot(*walk.trace, walk.at, at, reach);
  walk.why = why_no_robot_text(*walk.trace, answer);
  walk.why_taken =
      answer.why == WhyNoRobot::Why::stands || answer.why == WhyNoRobot::Why::stands_from_start;
  walk.asked_places = {answer.place.position};
  for (const LiftingPoint& robot : answer.set.came)
    if (!walk.why_taken) walk.asked_places.push_back(robot.position);
  browser::announce(walk.why);
}

}  // namespace

void ask_why(AppState& state, const Vec2& at) {
  Walkthrough& walk = state.walkthrough;
  if (!walkthrough_is_open(state)) return;
  if (walk.trace->balanced()) return ask_why_no_robot(state, at);
  const Trace& trace = *walk.trace;
  // Near a candidate the question is about that; elsewhere it is about the chord through the point.
  const auto& candidates = trace.placement.candidates;
  const double reach = 9 / state.camera.scale;
  std::optional<std::uint32_t> nearest;
  double least = reach;
  for (std::uint32_t c = 0; c < candidates.size(); ++c) {
    const Chord& chord = candidates[c].chord;
    const double away = length(nearest_on_segment(chord.r1.position, chord.r2.position, at) - at);
    if (away < least) {
      least = away;
      nearest = c;
    }
  }
  WhyNot answer;
  if (nearest) {
    answer = why_not(trace, walk.at, *nearest);
    walk.asked = candidates[*nearest].chord;
  } else {
    const std::optional<Chord> chord = chord_at(trace, at);
    answer = why_not_chord(trace, walk.at, chord);
    walk.asked = chord;
  }
  walk.why = why_not_text(trace, answer);
  walk.why_taken = answer.why == Why::taken;
  browser::announce(walk.why);
}

void measure(AppState& state, std::uint32_t candidate) {
  Walkthrough& walk = state.walkthrough;
  if (walkthrough_is_open(state) && walk.detail.scores &&
      candidate < walk.detail.scores->of_candidate.size())
    show_gain(walk, candidate);
}

void leave_script(AppState& state) {
  if (!state.walkthrough.script) return;
  state.walkthrough.script.reset();
  // The step may be no main step; then all are shown around it.
  if (walkthrough_is_open(state)) enter(state, state.walkthrough.at);
  browser::document_changed();  // the address names the lesson no more
}

void show_all_steps(AppState& state, bool all) {
  Walkthrough& walk = state.walkthrough;
  walk.script.reset();
  walk.all_steps = all;
  if (walkthrough_is_open(state)) enter(state, shown_step(walk, walk.at));
  browser::document_changed();
}

bool turn_over(AppState& state, double now) {
  Walkthrough& walk = state.walkthrough;
  if (!walkthrough_is_open(state) || !walk.playing) return false;
  if (!walk.turn_at) {
    const double letters = static_cast<double>(walk.caption.size() + words_of_stop(state).size());
    const double pause = std::clamp(1 + 0.035 * letters, 1.5, 12.0) / walk.speed;
    walk.turn_at = now + pause;
    browser::request_frame_after(pause);
    return false;
  }
  if (now < *walk.turn_at) {
    if (*walk.turn_at - now < 0.05) browser::request_frame();
    return false;
  }
  move_steps(state, 1);
  browser::request_frame();
  return true;
}

void begin_script(AppState& state, Script script) {
  Walkthrough& walk = state.walkthrough;
  walk.predict = script.lesson.predict;
  walk.guesses = {};
  walk.all_steps = false;
  walk.script = std::move(script);
  walk.script->depth = state.history.depth();
  find_stops(walk);
  settle_position(walk);
}

std::optional<InputError> join_script(AppState& state, Script script) {
  if (state.refusal || !state.placement || state.document.vertices != script.vertices)
    return InputError{ErrorCode::bad_syntax, "it is of another polygon than the link", {}};
  const bool begins = !walkthrough_is_open(state);
  open_walkthrough(state);
  if (!walkthrough_is_open(state)) return std::nullopt;  // and a notice says why
  begin_script(state, std::move(script));
  if (begins) enter(state, step_of(state, 0));
  return std::nullopt;
}

bool same_settings(Settings a, const Settings& b) {
  a.overlays = b.overlays;
  a.step = b.step;
  return a == b;
}

std::optional<Settings> settings_before_script(const AppState& state) {
  const std::optional<Script>& script = state.walkthrough.script;
  if (!script || !same_settings(script->own, settings(state))) return std::nullopt;
  return script->before;
}

bool script_is_true(const AppState& state) {
  const std::optional<Script>& script = state.walkthrough.script;
  return script && script->vertices == state.document.vertices;
}

std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.ask) return std::nullopt;
  std::optional<std::uint32_t> nearest;
  double least = state.screen.touch ? 22 : 12;
  for (const std::uint32_t choice : walk.ask->choices) {
    const Chord& chord = chord_of_choice(*walk.trace, walk.ask->detail, walk.ask->question, choice);
    const Vec2 a = state.camera.to_screen(chord.r1.position);
    const Vec2 b = state.camera.to_screen(chord.r2.position);
    const double away = length(nearest_on_segment(a, b, screen) - screen);
    if (away < least) {
      least = away;
      nearest = choice;
    }
  }
  return nearest;
}

std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen) {
  const std::vector<Figure>& figures = state.walkthrough.figures;
  std::optional<std::size_t> best;
  double best_score = 1e300;
  // Later figures are drawn above earlier ones.
  for (std::size_t i = figures.size(); i-- > 0;) {
    const Points& p = figures[i].points;
    double score = 1e300;
    if (p.size() == 1 && figures[i].kind != FigureKind::gain_circle) {
      const double away = length(state.camera.to_screen(p[0]) - screen);
      if (away <= 14) score = away;
    } else if (p.size() == 2) {
      const Vec2 a = state.camera.to_screen(p[0]), b = state.camera.to_screen(p[1]);
      const double away = length(nearest_on_segment(a, b, screen) - screen);
      if (away <= 7) score = 100 + away;
    } else if (p.size() > 2 && inside(p, state.camera.to_world(screen))) {
      score = 1000;
    }
    if (score < best_score) {
      best_score = score;
      best = i;
    }
  }
  return best;
}

Timeline timeline(const AppState& state) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.trace) return {};
  if (walk.script)
    return {static_cast<std::uint32_t>(walk.script->position),
            static_cast<std::uint32_t>(walk.script->stops.size())};
  if (walk.all_steps) return {walk.at, walk.trace->size()};
  const auto at = std::lower_bound(walk.main.begin(), walk.main.end(), walk.at);
  return {static_cast<std::uint32_t>(at - walk.main.begin()),
          static_cast<std::uint32_t>(walk.main.size())};
}

std::string place_in_words(const AppState& state) {
  const Timeline now = timeline(state);
  return std::to_string(now.at + 1) + " of " + std::to_string(now.count);
}

std::uint32_t step_of(const AppState& state, std::uint32_t position) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.script && walk.all_steps) return position;
  if (!walk.script) return walk.main[std::min<std::size_t>(position, walk.main.size() - 1)];
  return walk.script->stops[std::min<std::size_t>(position, walk.script->stops.size() - 1)].step;
}

std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.script && walk.all_steps) return step;
  const Timeline now = timeline(state);
  if (step_of(state, now.at) == step) return now.at;
  for (std::uint32_t position = 0; position < now.count; ++position)
    if (step_of(state, position) == step) return position;
  return std::nullopt;
}

std::vector<ChapterPart> chapter_parts(const AppState& state) {
  const Walkthrough& walk = state.walkthrough;
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
  // The last step is at the end of the timeline.
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

std::string left_out_in_words(const AppState& state) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.trace || walk.script || walk.all_steps) return {};
  const Step& step = walk.detail.step;
  const std::uint32_t more = further_like(*walk.trace, step);
  if (more == 0) return {};
  const std::string number = std::to_string(more);
  if (step.kind == StepKind::team)
    return number + (more == 1 ? " more team is" : " more teams are") +
           " chosen like this before the last: “All steps” shows them.";
  if (step.kind == StepKind::exchange)
    return number + (more == 1 ? " smaller exchange is" : " smaller exchanges are") +
           " left out here: “All steps” shows them.";
  if (step.kind == StepKind::start)
    return number + (more == 1 ? " smaller set is" : " smaller sets are") +
           " made on the way: “All steps” shows them.";
  return std::string("There ") + (more == 1 ? "is " : "are ") + number + " more " +
         (step.kind == StepKind::ray ? (more == 1 ? "ray" : "rays")
                                     : (more == 1 ? "pair" : "pairs")) +
         " like it: “All steps” shows " + (more == 1 ? "it." : "them.");
}

std::string words_of_stop(const AppState& state) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.script) return {};
  const Stop& stop = walk.script->stops[walk.script->position];
  return stop.step == walk.at ? stop.words : std::string();
}

std::string walkthrough_in_words(const AppState& state) {
  const Walkthrough& walk = state.walkthrough;
  if (!walk.trace) return {};
  std::string text =
      "Step " + place_in_words(state) + ", " + std::string(title(walk.detail.step.chapter)) + ". ";
  if (!walk.verdict.empty()) text += walk.verdict + " ";
  if (const std::string words = words_of_stop(state); !words.empty()) text += words + " ";
  text += walk.caption;
  if (!walk.formula.empty()) text += " " + walk.formula + ".";
  if (const std::string more = left_out_in_words(state); !more.empty()) text += " " + more;
  if (walk.ask) text += " " + walk.ask->text;
  return text;
}

}  // namespace evenlift::view
