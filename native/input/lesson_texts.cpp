#include "input/lesson_texts.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "evenlift/formats.h"
#include "evenlift/lesson_link.h"
#include "input/failure.h"
#include "input/files.h"

namespace evenlift::native {
namespace {

struct Text {
  std::string_view name, text;
};
constexpr Text lessons[] = {
#include "lessons.inc"
};
constexpr Text polygons[] = {
#include "polygons.inc"
};

template <class Texts>
std::optional<std::string_view> find(const Texts& texts, std::string_view name) {
  const auto* text = std::find_if(std::begin(texts), std::end(texts),
                                  [&](const Text& each) { return each.name == name; });
  if (text == std::end(texts)) return std::nullopt;
  return text->text;
}

// The names of all ready-made lessons with a task.
std::vector<std::string> names_of_tasks() {
  std::vector<std::string> names;
  for (const Text& text : lessons)
    if (const Result<Lesson> lesson = parse_lesson(text.text); lesson && lesson->task)
      names.push_back(std::string(text.name) + "  " + lesson->title);
  return names;
}

std::string text_of_lesson(const std::string& option, const std::string& given) {
  if (given == "-") return read_standard_input();
  if (std::optional<std::string> text = read_file(given)) return *std::move(text);
  if (has_lesson_link(given)) {
    Result<std::string> text = decode_lesson_link(given);
    if (!text) throw bad_input(option, text.error());
    return *std::move(text);
  }
  if (const auto ready_made = find(lessons, given)) return std::string(*ready_made);
  throw Failure{bad_input_status, option,
                "there is neither a file nor a ready-made lesson \"" + given +
                    "\"; the ready-made lessons with tasks are:",
                names_of_tasks()};
}

}  // namespace

LessonText read_lesson(const std::string& option, const std::string& given) {
  const std::string text = text_of_lesson(option, given);
  Result<Lesson> lesson = parse_lesson(text);
  if (!lesson) throw bad_input(given, lesson.error());
  LessonText read{given, text, *std::move(lesson), {}};
  if (read.lesson.polygon.empty()) return read;
  const auto polygon = find(polygons, read.lesson.polygon);
  if (!polygon)
    throw Failure{bad_input_status, given,
                  "there is no sample polygon \"" + read.lesson.polygon + "\""};
  Result<Document> sample = read_polygon(*polygon);
  if (!sample) throw bad_input(read.lesson.polygon, sample.error());
  read.sample = *std::move(sample);
  return read;
}

}  // namespace evenlift::native
