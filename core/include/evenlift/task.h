// Tasks of lessons (lesson.h): compares what a learner reached with what the task requires. So a
// teacher can set homework as a link, and check_task() marks it.
//
// A task that says `place` begins with robots beneath the object, ready to be placed by hand. A
// task that says `find: centre` hides the centre of mass: the object opens with C at its centroid,
// and the learner is told what each robot really carries. If the lesson's document has no centre of
// mass, one is drawn at random inside the convex hull of the robots, with the learner's number as
// the seed.
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
  Document start;                // the document that opens
  std::vector<double> readings;  // the true load of each robot, if C is to be found; else empty
};

// The exercise of a lesson with or without a task, for the learner with this number: its document
// as lesson_document() returns it, and then as the task says. Errors are those of lesson_document()
// and place(). It is also an error if C is to be found and there are not three or more given
// supports, if these stand on one line, or if the object falls. O(n) and, if C is to be found, a
// placement.
Result<Exercise> exercise(const Lesson& lesson, const Document& sample, std::uint64_t number = 1);

// Whether learners with different numbers get different objects or different hidden centres of
// mass. Only the lesson's own settings are looked at, so the answer is also true if the link or the
// sample fixes the centre of mass. O(settings).
bool is_numbered(const Lesson& lesson);

// A load counts as found if it differs from the reading by at most this fraction of the weight.
inline constexpr double found_within = 0.01;

// A goal and its current value, both in words without a full stop: "the greatest load is at most 30
// kg", "33.3 kg". `value` is empty if there is no value.
struct Goalpost {
  std::string name;  // the condition as written, "max<=30", or "load 2"
  std::string words, value;
  bool kept = false;
};

// What a learner reached.
struct Attempt {
  std::vector<Goalpost> goals;       // the conditions in their order, or the loads of the robots
  std::vector<std::string> changed;  // what was changed but may not be: "the weight"
  bool kept = false;                 // all goals are kept, and `changed` is empty
};

// Compares a document and its placement with the exercise of a task. Settings that only affect
// other methods do not count as changed, nor do overlays, units or the step. O(n) and the cost of
// check_conditions().
Attempt check_task(const Task& task, const Exercise& exercise, const Document& document,
                   const ShownPlacement& of);

// "Only the robots may be changed." O(1).
std::string movable_in_words(const Task& task);

}  // namespace evenlift
