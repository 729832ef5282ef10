#include "input/lesson_texts.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "evenlift/formats.h"
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

}  // namespace

LessonText read_lesson(const std::string& option, const std::string& name_or_file) {
  std::optional<std::string> text = read_file(name_or_file);
  if (!text) {
    const auto ready_made = find(lessons, name_or_file);
    if (!ready_made)
      throw Failure{bad_input_status, option,
                    "there is neither a file nor a ready-made lesson \"" + name_or_file +
                        "\"; the ready-made lessons with tasks are:",
                    names_of_tasks()};
    text = *ready_made;
  }
  Result<Lesson> lesson = parse_lesson(*text);
  if (!lesson) throw bad_input(name_or_file, lesson.error());
  LessonText read{name_or_file, *std::move(lesson), {}};
  if (read.lesson.polygon.empty()) return read;
  const auto polygon = find(polygons, read.lesson.polygon);
  if (!polygon)
    throw Failure{bad_input_status, name_or_file,
                  "there is no sample polygon \"" + read.lesson.polygon + "\""};
  Result<Document> sample = read_polygon(*polygon);
  if (!sample) throw bad_input(read.lesson.polygon, sample.error());
  read.sample = *std::move(sample);
  return read;
}

}  // namespace evenlift::native
