// Tasks of lessons (lesson.h): a teacher sets homework as a link, and check_task() compares what a
// learner reached with what the task requires.
//
// A task that says `place` begins with robots beneath the object, to be placed by hand. One that
// says `find: centre` hides the centre of mass: the object opens with C at its centroid, and the
// learner sees what each robot really carries. If the lesson's document has no centre of mass, one
// is drawn at random inside the convex hull of the robots, with the learner's number as the seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/placed_robots.h"
#include "evenlift/result.h"

namespace evenlift {

// The greatest number of a learner; learners are numbered from 0.
inline constexpr std::uint64_t max_learner = 999999999;
struct Exercise {
  Document start;                // the document that opens
  std::vector<double> readings;  // each robot's true load, if C is to be found; else empty
};

// The exercise of a lesson, with or without a task, for the learner with this number: the document
// of lesson_document(), changed as the task says. Errors are those of lesson_document() and
// place(). If C is to be found, it is also an error if there are fewer than three given supports,
// if these stand on one line, or if the object falls. O(n) and, if C is to be found, a placement.
Result<Exercise> exercise(const Lesson& lesson, const Document& sample, std::uint64_t number = 1);

// Whether different numbers give different objects or different hidden centres of mass. Only the
// lesson's own settings count, so the answer is also true if the link or the sample fixes the
// centre of mass. O(settings).
bool is_numbered(const Lesson& lesson);

// A load counts as found if it differs from the reading by at most this fraction of the weight.
inline constexpr double found_within = 0.01;

// A goal and its current value in words without a full stop: "the greatest load is at most 30 kg",
// "33.3 kg". `value` is empty if the goal has no value.
struct Goalpost {
  std::string name;  // the condition as written, "max<=30", or "load 2"
  std::string words, value;
  bool kept = false;
};

struct Attempt {
  std::vector<Goalpost> goals;       // the robots' loads, if C is to be found; then the conditions
  std::vector<std::string> changed;  // what the task does not let change: "the weight"
  bool kept = false;                 // all goals are kept, and `changed` is empty
};

// Compares a document and its placement with the exercise. Settings that only affect other methods,
// overlays, units and the step never count as changed. O(n) and the cost of check_conditions().
Attempt check_task(const Task& task, const Exercise& exercise, const Document& document,
                   const ShownPlacement& of);

// A sentence that states what may be changed: "Only the robots may be changed." O(1).
std::string movable_in_words(const Task& task);

}  // namespace evenlift
