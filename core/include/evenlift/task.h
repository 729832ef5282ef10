// Tasks of lessons: what a learner reached, compared with what was to be reached (lesson.h). So
// homework is a link, and marking it is a function.
//
// A task that says `place` begins with robots beneath the object, ready to be placed by hand. A task
// that says `find: centre` hides the centre of mass: the object opens with C at its centroid, and
// the learner is told what each robot carries in truth. If the lesson gives no centre of mass, the
// learner's number draws one among the robots.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/placed_robots.h"
#include "evenlift/result.h"

namespace evenlift {

// A learner's task. The numbers of learners are 0 .. max_learner.
inline constexpr std::uint64_t max_learner = 999999999;
struct Exercise {
  Document start;                // what opens
  std::vector<double> readings;  // the load of each robot in truth, if C is to be found; else empty
};

// The exercise of a lesson with or without a task, for the learner with this number: its document
// as lesson_document() returns it, and then as the task says. Errors are those of lesson_document()
// and place(), and a task to find C without three robots that determine it. O(n) and, if C is to be
// found, a placement.
Result<Exercise> exercise(const Lesson& lesson, const Document& sample, std::uint64_t number = 1);

// Whether learners with other numbers get other objects, or another hidden centre of mass. A centre
// of mass in a link counts as drawn here: only the lesson's own settings are looked at. O(settings).
bool is_numbered(const Lesson& lesson);

// A load counts as found if it is as near to the reading as this part of the weight.
inline constexpr double found_within = 0.01;

// One thing to be reached, with its value now, both in words without a full stop: "the greatest load
// is at most 30 kg", "33.3 kg". No words for the value if there is none.
struct Goalpost {
  std::string name;  // the condition as written, "max<=30", or "load 2"
  std::string words, value;
  bool kept = false;
};

// What a learner reached.
struct Attempt {
  std::vector<Goalpost> goals;       // the conditions in their order, or the loads of the robots
  std::vector<std::string> changed;  // what was changed but may not be: "the weight"
  bool kept = false;                 // all goals, and nothing else was changed
};

// Compares a document and its placement with the exercise of a task. Settings that only affect
// other methods do not count as changed, nor do overlays, units, and the step. O(n) and the cost of
// check_conditions().
Attempt check_task(const Task& task, const Exercise& exercise, const Document& document,
                   const ShownPlacement& of);

// "Only the robots may be changed." O(1).
std::string movable_in_words(const Task& task);

}  // namespace evenlift
