// Tasks of lessons (lesson.h): a teacher sets homework as a link, and check_task() compares the
// learner's result with what the task requires.
//
// A task that says `place` begins with robots beneath the object; the learner places them by hand.
// A task that says `find: centre` hides the object's own centre of mass: the object opens with it
// at the centroid, and the learner sees the load that each robot has with the hidden C. If the
// lesson's document has no centre of mass, exercise() draws one at random inside the convex hull of
// the robots, with the learner's number as the seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/placed_robots.h"
#include "evenlift/result.h"

namespace evenlift {

// Learners are numbered from 0 to this number.
inline constexpr std::uint64_t max_learner = 999999999;
struct Exercise {
  Document start;                // the document that opens
  std::vector<double> readings;  // each robot's load with the hidden C; empty if C is shown
};

// The exercise of a lesson for the learner with this number. The document that opens is that of
// lesson_document(), changed as the lesson's task, if any, requires. Errors are those of
// lesson_document() and place(). If C is to be found, fewer than three given supports, supports on
// one line, and an object that falls are errors too. O(n), plus the cost of a placement if C is to
// be found.
Result<Exercise> exercise(const Lesson& lesson, const Document& sample, std::uint64_t number = 1);

// Whether different learners may get different objects or different hidden centres of mass. A
// hidden C counts as different unless a setting of the lesson itself gives it, even if the lesson's
// link or sample does. O(settings).
bool is_numbered(const Lesson& lesson);

// A robot's load counts as found if it differs from its reading by at most this fraction of the
// weight.
inline constexpr double found_within = 0.01;

// A goal and its current value, in words without a full stop, such as "the greatest load is at most
// 30 kg" and "33.3 kg". `value` is empty if the goal has no value.
struct Goalpost {
  std::string name;  // the condition as written, such as "max<=30"; for a load, "load 2"
  std::string words, value;
  bool kept = false;  // whether the goal is met
};

struct Attempt {
  std::vector<Goalpost> goals;       // the robots' loads, if C is to be found; then the conditions
  std::vector<std::string> changed;  // what the learner must not change, but did: "the weight"
  bool kept = false;                 // all goals are met, and `changed` is empty
};

// Compares a document and its placement with the exercise. Overlays, units, the step, and settings
// that affect only other methods never count as changed. O(n), plus the cost of check_conditions().
Attempt check_task(const Task& task, const Exercise& exercise, const Document& document,
                   const ShownPlacement& of);

// A sentence that states what the learner may change: "Only the robots may be changed." O(1).
std::string movable_in_words(const Task& task);

}  // namespace evenlift
