// Lessons, and links that learners hand in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// --- Links that learners hand in.

struct HandedIn {
  std::string name;                     // the text before the link on the same line; may be empty
  std::string link;                     // a share link, or an address that ends in one
  std::optional<std::uint64_t> number;  // the learner's number, if the address has one
  std::size_t line = 0;                 // the number of its line, from 1
};

// Returns the given link, or the links in a file ("-" for standard input). Each line has one link.
// Before the link there may be a name, followed by spaces, a tab, a comma or a semicolon. Skips
// empty lines and lines that begin with #. Throws Failure for an unreadable file, or one without
// links.
std::vector<HandedIn> read_handed_in(const std::string& link_or_file);

}  // namespace evenlift::native
