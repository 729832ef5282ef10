#include "input/lesson_texts.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

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

std::vector<std::string> names_of_lessons(bool with_task) {
  std::vector<std::string> names;
  for (const Text& text : lessons)
    if (const Result<Lesson> lesson = parse_lesson(text.text);
        lesson && (lesson->task || !with_task))
      names.push_back(std::string(text.name) + "  " + lesson->title);
  return names;
}

struct Source {
  std::string name, text;
};

Source find_text(const std::string& option, const std::string& given) {
  if (given == "-") return {"standard input", read_standard_input()};
  if (std::optional<std::string> text = read_file(given)) return {given, *std::move(text)};
  if (has_lesson_link(given)) {
    Result<std::string> text = decode_lesson_link(given);
    if (!text) throw bad_input("link", text.error());
    return {"the lesson of the link", *std::move(text)};
  }
  if (const auto ready_made = find(lessons, given)) return {given, std::string(*ready_made)};
  const bool task = option == "--task";
  throw Failure{bad_input_status, option,
                "there is neither a file nor a ready-made lesson \"" + given +
                    "\"; the ready-made lessons" + (task ? " with tasks" : "") + " are:",
                names_of_lessons(task)};
}

}  // namespace

LessonText read_lesson(const std::string& option, const std::string& given) {
  Source source = find_text(option, given);
  Result<Lesson> lesson = parse_lesson(source.text);
  if (!lesson) throw bad_input(source.name, lesson.error());
  LessonText read{source.name, std::move(source.text), *std::move(lesson), {}};
  if (read.lesson.polygon.empty()) return read;
  const auto polygon = find(polygons, read.lesson.polygon);
  if (!polygon)
    throw Failure{bad_input_status, read.source,
                  "there is no sample polygon \"" + read.lesson.polygon + "\""};
  Result<Document> sample = read_polygon(*polygon);
  if (!sample) throw bad_input(read.lesson.polygon, sample.error());
  read.sample = *std::move(sample);
  return read;
}

}  // namespace evenlift::native
