#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <utility>

#include "evenlift/output/words.h"
#include "state/browser.h"
#include "tools/pick.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_visited = 60;

// What only the step before had.
void forget_step(LessonState& lesson) {
  lesson.ask.reset();
  lesson.verdict.clear();
  lesson.asked.reset();
  lesson.why.clear();
  lesson.hovered.reset();
  lesson.measured.reset();
  lesson.gained.clear();
  lesson.turn_at.reset();
}

void show_gain(LessonState& lesson, std::uint32_t candidate) {
  const TeamScores& scores = *lesson.detail.scores;
  lesson.measured = candidate;
  lesson.gained.clear();
  if (scores.rule == Rule::score) lesson.gained = gain_figures(*lesson.trace, scores, candidate);
}

void look(LessonState& lesson) {
  const Trace& trace = *lesson.trace;
  lesson.detail = look_at(trace, lesson.at);
  lesson.known = progress_at(trace, lesson.at);
  lesson.figures = figures(trace, lesson.detail);
  lesson.base = lifting_base(trace, lesson.known.base_teams);
  lesson.caption = caption(trace, lesson.detail);
  lesson.formula = formula(trace, lesson.detail);
  const std::optional<TeamScores>& scores = lesson.detail.scores;
  if (scores && !scores->ranking.empty()) show_gain(lesson, scores->ranking[0]);
}

void remember(LessonState& lesson) {
  std::vector<Visited>& visited = lesson.visited;
  if (!visited.empty() && visited.back().step == lesson.at) visited.pop_back();
  visited.push_back({lesson.at, lesson.caption});
  if (visited.size() > most_visited) visited.erase(visited.begin());
}

// The step belongs to the document, so that links carry it; it is no edit, and nothing to undo.
void publish(AppState& state, std::optional<std::uint32_t> step) {
  state.document.settings.step = state.placed.settings.step = step;
  browser::document_changed();
}

void find_stops(LessonState& lesson) {
  if (!lesson.script) return;
  Script& script = *lesson.script;
  script.stops.clear();
  for (const LessonStep& step : script.lesson.steps) {
    if (const auto found = find_step(*lesson.trace, step.address))
      script.stops.push_back({*found, step.words});
  }
  if (script.stops.empty()) return lesson.script.reset();
  script.position = std::min(script.position, script.stops.size() - 1);
}

// The stop that is shown at a step that was reached in another way.
void settle_position(LessonState& lesson) {
  if (!lesson.script) return;
  Script& script = *lesson.script;
  if (script.stops[script.position].step == lesson.at) return;
  const auto exact = std::find_if(script.stops.begin(), script.stops.end(),
                                  [&](const Stop& s) { return s.step == lesson.at; });
  const auto later = std::find_if(script.stops.begin(), script.stops.end(),
                                  [&](const Stop& s) { return s.step > lesson.at; });
  const auto at = exact != script.stops.end() ? exact : later;
  const auto index = at - script.stops.begin();
  script.position = static_cast<std::size_t>(
      exact != script.stops.end() ? index : std::max<std::ptrdiff_t>(index - 1, 0));
}

void enter(AppState& state, std::uint32_t step) {
  LessonState& lesson = state.lesson;
  forget_step(lesson);
  lesson.at = std::min(step, lesson.trace->size() - 1);
  settle_position(lesson);
  look(lesson);
  remember(lesson);
  publish(state, lesson.at);
}

// Traces the placement. False, with a notice, if it cannot be shown step by step.
bool trace_it(AppState& state, std::optional<Trace> made = std::nullopt) {
  Result<Trace> trace = made ? Result<Trace>(std::move(*made)) : compute_trace(*state.placement);
  if (!trace) {
    state.notice = {Notice::Kind::problem, sentence(trace.error()) + "."};
    browser::announce(state.notice.text);
    close_lesson(state);
    return false;
  }
  state.lesson.trace = std::move(trace).value();
  find_stops(state.lesson);
  return true;
}

std::optional<std::uint32_t> next_step(const AppState& state, int by) {
  const Timeline now = timeline(state);
  const auto wanted = static_cast<std::int64_t>(now.at) + by;
  if (wanted < 0 || wanted >= now.count) return std::nullopt;
  return step_of(state, static_cast<std::uint32_t>(wanted));
}

void ask(LessonState& lesson, std::uint32_t step) {
  const Trace& trace = *lesson.trace;
  Ask asked;
  asked.step = step;
  asked.detail = look_at(trace, step);
  const std::optional<Question> question = evenlift::question(trace, asked.detail);
  if (!question) return;
  asked.question = *question;
  asked.text = question_text(trace, asked.detail, *question);
  if (question->kind == QuestionKind::nearer_end)
    asked.choices = {0, 1};
  else
    asked.choices = asked.detail.scores->ranking;
  // In the order of the candidates: the ranking would give the answer away.
  std::sort(asked.choices.begin(), asked.choices.end());
  lesson.ask = std::move(asked);
  lesson.playing = false;
  browser::announce(lesson.ask->text);
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
  LessonState& lesson = state.lesson;
  const std::optional<std::uint32_t> wanted = state.document.settings.step;
  if (!wanted) {
    if (lesson.trace) close_lesson(state);
    return;
  }
  if (state.refusal || !state.placement) return;
  const bool moved = !lesson.trace || *wanted != lesson.at;
  const std::optional<Step> before =
      moved ? std::nullopt : std::optional<Step>(lesson.trace->step(lesson.at));
  if (!trace_it(state, std::move(made))) return;
  if (before) {
    enter(state, nearest_step(*lesson.trace, *before));
    return;
  }
  const std::uint32_t last = lesson.trace->size() - 1;
  enter(state, *wanted);
  if (*wanted <= last) return;
  state.notice = {Notice::Kind::problem, "This lesson has no step " + std::to_string(*wanted + 1) +
                                             ": it is at its last, " + std::to_string(last + 1) +
                                             "."};
  browser::announce(state.notice.text);
}

void open_lesson(AppState& state) {
  if (lesson_is_open(state) || !state.placement || state.refusal) return;
  state.compared.reset();
  state.other.reset();
  state.selected.reset();
  state.tool = Tool::parts;
  if (trace_it(state)) enter(state, state.lesson.at);
}

void close_lesson(AppState& state) {
  LessonState& lesson = state.lesson;
  forget_step(lesson);
  lesson.trace.reset();
  lesson.script.reset();
  lesson.playing = false;
  browser::drop_frame_after();
  lesson.figures.clear();
  lesson.visited.clear();
  publish(state, std::nullopt);
  ++state.revision;
}

void go_to_step(AppState& state, std::uint32_t step) {
  if (lesson_is_open(state)) enter(state, step);
}

void move_steps(AppState& state, int by) {
  LessonState& lesson = state.lesson;
  if (!lesson_is_open(state)) return;
  const auto next = next_step(state, by);
  if (!next) {
    lesson.playing = false;
    return;
  }
  const bool asked_already = lesson.ask && lesson.ask->step == *next;
  if (by > 0 && lesson.predict && !asked_already && is_choice(*lesson.trace, *next)) {
    ask(lesson, *next);
    if (lesson.ask) return;
  }
  if (lesson.script) lesson.script->position = timeline(state).at + static_cast<std::size_t>(by);
  enter(state, *next);
}

void move_chapters(AppState& state, int by) {
  LessonState& lesson = state.lesson;
  if (!lesson_is_open(state)) return;
  const Trace& trace = *lesson.trace;
  const auto here = static_cast<int>(trace.step(lesson.at).chapter);
  const auto begin = trace.chapter_begin(static_cast<Chapter>(here));
  // Back from inside a chapter is to its beginning.
  if (by < 0 && begin && *begin < lesson.at) return enter(state, *begin);
  for (int c = here + by; c >= 0 && c < static_cast<int>(chapter_count); c += by) {
    if (const auto at = trace.chapter_begin(static_cast<Chapter>(c))) return enter(state, *at);
  }
  enter(state, by > 0 ? trace.size() - 1 : 0);
}

void set_playing(AppState& state, bool playing) {
  LessonState& lesson = state.lesson;
  if (!lesson_is_open(state)) return;
  // At the end, playing begins again.
  if (playing && !next_step(state, 1)) enter(state, step_of(state, 0));
  lesson.playing = playing;
  lesson.turn_at.reset();
  if (!playing) browser::drop_frame_after();
}

void set_speed(AppState& state, double speed) {
  state.lesson.speed = std::clamp(speed, slowest_speed, fastest_speed);
  state.lesson.turn_at.reset();
}

void set_predict(AppState& state, bool on) {
  state.lesson.predict = on;
  if (!on) state.lesson.ask.reset();
}

void guess(AppState& state, std::uint32_t answer) {
  LessonState& lesson = state.lesson;
  if (!lesson_is_open(state) || !lesson.ask) return;
  const Ask asked = *lesson.ask;
  const bool right = answer == asked.question.answer;
  std::string verdict = right ? "Right." : "Not this time.";
  if (!right && asked.question.kind == QuestionKind::winning_chord)
    verdict += " " + why_not_text(*lesson.trace, why_not(*lesson.trace, asked.step, answer));
  if (lesson.script && timeline(state).at + 1 < timeline(state).count)
    lesson.script->position = timeline(state).at + 1;
  enter(state, asked.step);
  lesson.verdict = verdict;
  lesson.was_right = right;
  browser::announce(verdict);
}

void ask_why(AppState& state, const Vec2& at) {
  LessonState& lesson = state.lesson;
  if (!lesson_is_open(state)) return;
  const Trace& trace = *lesson.trace;
  // A candidate close by is meant itself; anything else is the chord through there.
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
    answer = why_not(trace, lesson.at, *nearest);
    lesson.asked = candidates[*nearest].chord;
  } else {
    const std::optional<Chord> chord = chord_at(trace, at);
    answer = why_not_chord(trace, lesson.at, chord);
    lesson.asked = chord;
  }
  lesson.why = why_not_text(trace, answer);
  browser::announce(lesson.why);
}

void measure(AppState& state, std::uint32_t candidate) {
  LessonState& lesson = state.lesson;
  if (lesson_is_open(state) && lesson.detail.scores &&
      candidate < lesson.detail.scores->of_candidate.size())
    show_gain(lesson, candidate);
}

void leave_script(AppState& state) {
  if (!state.lesson.script) return;
  state.lesson.script.reset();
  browser::document_changed();  // the address names the lesson no more
}

bool turn_over(AppState& state, double now) {
  LessonState& lesson = state.lesson;
  if (!lesson_is_open(state) || !lesson.playing) return false;
  if (!lesson.turn_at) {
    const double letters = static_cast<double>(lesson.caption.size() + words_of_stop(state).size());
    const double pause = std::clamp(1 + 0.035 * letters, 1.5, 12.0) / lesson.speed;
    lesson.turn_at = now + pause;
    browser::request_frame_after(pause);
    return false;
  }
  if (now < *lesson.turn_at) {
    if (*lesson.turn_at - now < 0.05) browser::request_frame();
    return false;
  }
  move_steps(state, 1);
  browser::request_frame();
  return true;
}

void begin_script(AppState& state, Script script) {
  LessonState& lesson = state.lesson;
  lesson.predict = script.lesson.predict;
  lesson.script = std::move(script);
  lesson.script->depth = state.history.depth();
  find_stops(lesson);
  settle_position(lesson);
}

std::optional<InputError> join_script(AppState& state, Script script) {
  if (state.refusal || !state.placement || state.document.vertices != script.vertices)
    return InputError{ErrorCode::bad_syntax, "it is of another polygon than the link", {}};
  const bool begins = !lesson_is_open(state);
  open_lesson(state);
  if (!lesson_is_open(state)) return std::nullopt;  // and a notice says why
  begin_script(state, std::move(script));
  if (begins) enter(state, step_of(state, 0));
  return std::nullopt;
}

bool script_is_true(const AppState& state) {
  const std::optional<Script>& script = state.lesson.script;
  return script && script->vertices == state.document.vertices;
}

std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen) {
  const LessonState& lesson = state.lesson;
  if (!lesson.ask) return std::nullopt;
  std::optional<std::uint32_t> nearest;
  double least = state.screen.touch ? 22 : 12;
  for (const std::uint32_t choice : lesson.ask->choices) {
    const Chord& chord = lesson.ask->question.kind == QuestionKind::nearer_end
                             ? lesson.ask->detail.pair->ends[choice]
                             : lesson.trace->placement.candidates[choice].chord;
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
  const std::vector<Figure>& figures = state.lesson.figures;
  std::optional<std::size_t> best;
  double best_score = 1e300;
  // Later figures lie above earlier ones.
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
  const LessonState& lesson = state.lesson;
  if (!lesson.trace) return {};
  if (lesson.script)
    return {static_cast<std::uint32_t>(lesson.script->position),
            static_cast<std::uint32_t>(lesson.script->stops.size())};
  return {lesson.at, lesson.trace->size()};
}

std::uint32_t step_of(const AppState& state, std::uint32_t position) {
  const LessonState& lesson = state.lesson;
  if (!lesson.script) return position;
  return lesson.script->stops[std::min<std::size_t>(position, lesson.script->stops.size() - 1)]
      .step;
}

std::string words_of_stop(const AppState& state) {
  const LessonState& lesson = state.lesson;
  if (!lesson.script) return {};
  const Stop& stop = lesson.script->stops[lesson.script->position];
  return stop.step == lesson.at ? stop.words : std::string();
}

std::string lesson_in_words(const AppState& state) {
  const LessonState& lesson = state.lesson;
  if (!lesson.trace) return {};
  const Timeline now = timeline(state);
  std::string text = "Step " + std::to_string(now.at + 1) + " of " + std::to_string(now.count) +
                     ", " + std::string(title(lesson.detail.step.chapter)) + ". ";
  if (!lesson.verdict.empty()) text += lesson.verdict + " ";
  if (const std::string words = words_of_stop(state); !words.empty()) text += words + " ";
  text += lesson.caption;
  if (!lesson.formula.empty()) text += " " + lesson.formula + ".";
  if (lesson.ask) text += " " + lesson.ask->text;
  return text;
}

}  // namespace evenlift::view
