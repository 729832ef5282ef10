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

// Returns the lesson in a file or on standard input ("-"), in a link or an address that ends in
// one, or the ready-made lesson that has the given name. Throws Failure about `option` or the
// lesson.
LessonText read_lesson(const std::string& option, const std::string& given);

}  // namespace evenlift::native
