#pragma once

#include <string>

#include "evenlift/document.h"
#include "evenlift/lesson.h"

namespace evenlift::native {

// A lesson, and the sample polygon that it names, if any.
struct LessonText {
  std::string source;  // the name of the lesson's text in errors
  std::string text;
  Lesson lesson;
  Document sample;
};

// Reads a lesson. `given` is a file, "-" for standard input, a link to a lesson, an address that
// ends in such a link, or the name of a ready-made lesson. Throws Failure if the lesson cannot be
// read. The Failure names `option` if there is no such lesson.
LessonText read_lesson(const std::string& option, const std::string& given);

}  // namespace evenlift::native
