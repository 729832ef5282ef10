// Lessons that must be right, and refusals with their lines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "evenlift/lesson.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/data_table.h"

namespace evenlift::testing {

inline Lesson lesson_of(const std::string& text) {
  const Result<Lesson> lesson = parse_lesson(text);
  INFO((lesson ? "" : lesson.error().message));
  REQUIRE(lesson.ok());
  return *lesson;
}

inline std::filesystem::path lessons_folder() {
  return std::filesystem::path(EVENLIFT_ASSETS_DIR) / "lessons";
}

inline Lesson ready_made(const std::string& name) {
  return lesson_of(corpus::read_file(lessons_folder() / (name + ".txt")));
}

// The sample it names, or an empty document.
inline Document sample_of(const Lesson& lesson) {
  return lesson.polygon.empty() ? Document{} : corpus::polygon(lesson.polygon);
}

// Requires a refusal at this line, with this part in its sentence.
inline void refused(const std::string& text, std::size_t line, const std::string& part) {
  const Result<Lesson> lesson = parse_lesson(text);
  INFO(text);
  REQUIRE_FALSE(lesson.ok());
  INFO(lesson.error().message);
  CHECK(lesson.error().place.kind == Place::Kind::line);
  CHECK(lesson.error().place.index == line);
  CHECK(lesson.error().message.find(part) != std::string::npos);
  CHECK(is_one_sentence(lesson.error().message));
}

}  // namespace evenlift::testing
