// A lesson is a teacher's text (evenlift/lesson.h). The walkthrough shows the algorithm step by
// step. A script is a lesson whose stops were found in the walkthrough's trace.
//
// This is data, which walkthrough/walkthrough.h changes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"

namespace evenlift::view {

// A lesson's step, and the teacher's words for it.
struct Stop {
  std::uint32_t step;
  std::string words;
};
struct Script {
  Lesson lesson;
  std::vector<Stop> stops;   // with an address in the trace; at least one
  std::size_t position = 0;  // the present or last stop
  Document of;               // the lesson's own document
  std::size_t depth = 0;     // edits in the history at its opening; undoing more leaves it
  bool preview = false;      // being written
};

// About a choice that the next step shows.
struct Ask {
  std::uint32_t step;  // with the answer
  StepDetail detail;
  Question question;
  std::string text;
  std::vector<std::uint32_t> choices;  // ends of the edge pair, candidates, even chords, or teams
  std::size_t pointed = 0;             // index of the choice that the buttons point at
};

struct Answered {
  Ask ask;
  std::uint32_t guess;  // one of the choices
};

struct Visited {
  std::uint32_t step;
  std::string caption;
};

// Since the walkthrough began. Only the first guess at each step counts.
struct Guesses {
  std::vector<std::uint32_t> steps;
  std::uint32_t right = 0;
  // The steps of the questions, by QuestionKind.
  std::array<std::vector<std::uint32_t>, question_kind_count> asked;
  std::vector<std::uint32_t> told;  // choices shown without a question

  // Questions without a guess.
  std::size_t passed_over() const {
    std::size_t all = 0;
    for (const std::vector<std::uint32_t>& of_kind : asked) all += of_kind.size();
    return all - steps.size();
  }
};

struct Walkthrough {
  std::shared_ptr<const Trace> trace;  // of the placement, while open
  std::uint64_t traced = 0;            // its number (Derived::traces)
  std::uint32_t at = 0;                // kept when the walkthrough is closed
  std::vector<std::uint32_t> main;     // evenlift/main_steps.h
  bool all_steps = false;              // otherwise only the main ones
  bool resumes = false;                // reopens where it was left
  StepDetail detail;
  Progress known;
  std::vector<Figure> figures;            // of the step
  std::optional<std::uint32_t> measured;  // whose gain is drawn, in `scores`
  std::vector<Figure> gained;             // what the metric measures for it
  Points base;                            // the lifting base known at this step
  std::string caption, formula;
  std::vector<Visited> visited;  // preceding steps, the newest last

  bool playing = false;
  double speed = 1;
  std::optional<double> turn_at;  // when the next step is due, in seconds

  bool predict = false;
  std::optional<Ask> ask;
  std::optional<Answered> answered;  // at the step with the answer
  std::string verdict;               // whether the last guess was right
  bool was_right = false;
  Guesses guesses;

  std::optional<Chord> asked;  // "why not this one?"
  Points asked_places;         // "why no robot here?": where the robots would go, this place first
  std::string why;
  bool why_taken = false;  // the chord belongs to a team

  std::optional<std::size_t> hovered;  // index of the figure under the pointer
  std::optional<Script> script;
  std::optional<Script> aside;  // to return to, while all steps are shown
  bool of_lesson = false;       // opened as a lesson; valid only while open: in_lesson()
};

}  // namespace evenlift::view
