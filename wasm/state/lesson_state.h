// Where the lesson stands, and what it says there. Data; lesson.h changes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"

namespace evenlift::view {

// A ready-made lesson, its addresses found in the trace.
struct Stop {
  std::uint32_t step;
  std::string words;
};
struct Script {
  Lesson lesson;
  std::vector<Stop> stops;   // those that the trace has, at least one
  std::size_t position = 0;  // the stop that is shown, or was last
  Points vertices;           // of the polygon that it was written for
  std::size_t depth = 0;     // of the history when it was opened: undo beyond leaves it
};

// A choice that the learner is asked about before it is shown.
struct Ask {
  std::uint32_t step;  // that shows it
  StepDetail detail;
  Question question;
  std::string text;
  std::vector<std::uint32_t> choices;  // ends of the pair, or candidates
  std::size_t pointed = 0;             // among the choices, by key
};

struct Visited {
  std::uint32_t step;
  std::string caption;
};

struct LessonState {
  std::optional<Trace> trace;  // of the placement, while a lesson is open
  std::uint32_t at = 0;        // its step; kept when it is closed
  StepDetail detail;
  Progress known;
  std::vector<Figure> figures;            // what the step is about
  std::optional<std::uint32_t> measured;  // the candidate whose gain is drawn, in `scores`
  std::vector<Figure> gained;             // what the metric measures for it
  Points base;                            // H as known
  std::string caption, formula;
  std::vector<Visited> visited;  // the newest last

  bool playing = false;
  double speed = 1;
  std::optional<double> turn_at;  // seconds: when the next step is due

  bool predict = false;
  std::optional<Ask> ask;
  std::string verdict;  // on the last guess
  bool was_right = false;

  std::optional<Chord> asked;  // "why not this one?"
  std::string why;

  std::optional<std::size_t> hovered;  // of the figures
  std::optional<Script> script;
};

}  // namespace evenlift::view
