// The state of the walkthrough, which shows the algorithm step by step. A lesson is a teacher's
// text (evenlift/lesson.h). A script is a lesson whose stops were found in the walkthrough's trace.
//
// These structs are data; walkthrough/walkthrough.h changes them.
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

// A step at which a lesson stops, and the teacher's words for it.
struct Stop {
  std::uint32_t step;
  std::string words;
};
struct Script {
  Lesson lesson;
  std::vector<Stop> stops;   // the lesson's steps found in the trace; at least one
  std::size_t position = 0;  // the present or last stop
  Document of;               // the lesson's own document
  std::size_t depth = 0;     // History::depth() at the opening; below this, the lesson ends
  bool preview = false;      // the lesson is being written
};

// A question about the choice that the next step shows.
struct Ask {
  std::uint32_t step;  // the step that shows the answer
  StepDetail detail;
  Question question;
  std::string text;
  std::vector<std::uint32_t> choices;  // candidates, even chords, teams, or ends of the edge pair
  std::size_t pointed = 0;             // index of the choice that the stepper shows
};

struct Answered {
  Ask ask;
  std::uint32_t guess;  // one of the choices
};

// A step that was shown, and its caption.
struct Visited {
  std::uint32_t step;
  std::string caption;
};

// The user's guesses since predictions were turned on or another document was opened. Only the
// first guess at each step counts.
struct Guesses {
  std::vector<std::uint32_t> steps;
  std::uint32_t right = 0;
  // The steps about which a question was asked, by QuestionKind.
  std::array<std::vector<std::uint32_t>, question_kind_count> asked;
  std::vector<std::uint32_t> told;  // the steps that showed a choice without a question

  // Returns the number of questions without a guess.
  std::size_t passed_over() const {
    std::size_t all = 0;
    for (const std::vector<std::uint32_t>& of_kind : asked) all += of_kind.size();
    return all - steps.size();
  }
};

struct Walkthrough {
  std::shared_ptr<const Trace> trace;  // of the placement; null while the walkthrough is closed
  std::uint64_t traced = 0;            // the trace's number (Derived::traces)
  std::uint32_t at = 0;                // the present step; kept when the walkthrough is closed
  std::vector<std::uint32_t> main;     // the main steps (evenlift/main_steps.h)
  bool all_steps = false;              // all steps are shown, otherwise only the main steps
  bool resumes = false;                // the walkthrough reopens at the step where it was closed
  StepDetail detail;
  Progress known;                         // the results known at this step
  std::vector<Figure> figures;            // of the present step
  std::optional<std::uint32_t> measured;  // the candidate in detail.scores whose gain is drawn
  std::vector<Figure> gained;             // the figures that show this gain
  Points base;                            // the lifting base known at this step
  std::string caption, formula;
  std::vector<Visited> visited;  // the last steps shown, the newest last

  bool playing = false;
  double speed = 1;
  std::optional<double> turn_at;  // when the next step is due, in seconds

  bool predict = false;
  std::optional<Ask> ask;
  std::optional<Answered> answered;  // the question whose answer this step shows
  std::string verdict;               // whether the last guess was right
  bool was_right = false;
  Guesses guesses;

  std::optional<Chord> asked;  // the chord of the question "why not this one?"
  Points asked_places;     // the place of "why no robot here?", then places where robots would go
  std::string why;         // the answer to either question
  bool why_taken = false;  // the chord belongs to a team, or a robot stands at the place

  std::optional<std::size_t> hovered;  // index of the figure under the pointer
  std::optional<Script> script;
  std::optional<Script> aside;  // the script that is set aside while all steps are shown
  bool of_lesson = false;       // opened as a lesson; valid only while open (in_lesson())
};

}  // namespace evenlift::view
