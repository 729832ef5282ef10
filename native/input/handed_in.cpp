#include "input/handed_in.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "evenlift/formats.h"
#include "evenlift/lesson_link.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/task.h"
#include "input/command_line.h"
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

struct GivenText {
  std::string name, text;
};

GivenText find_text(const std::string& option, const std::string& given) {
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
  GivenText source = find_text(option, given);
  Result<Lesson> lesson = parse_lesson(source.text);
  if (!lesson) throw bad_input(source.name, lesson.error());
  LessonText read{source.name, std::move(source.text), *std::move(lesson), {}};
  if (read.lesson.polygon.empty()) return read;
  const auto polygon = find(polygons, read.lesson.polygon);
  if (!polygon)
    throw Failure{bad_input_status, read.source,
                  "there is no sample polygon \"" + read.lesson.polygon + "\""};
  Result<Document> sample = read_thesis(*polygon);
  if (!sample) throw bad_input(read.lesson.polygon, sample.error());
  read.sample = *std::move(sample);
  return read;
}

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view without(std::string_view text, std::string_view ends) {
  const std::size_t from = text.find_first_not_of(ends);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(ends) - from + 1);
}

// `number=4711` in the query of an address.
std::optional<std::uint64_t> number_in(std::string_view address) {
  std::string_view query = address.substr(0, address.find('#'));
  const std::size_t begin = query.find('?');
  if (begin == std::string_view::npos) return std::nullopt;
  query.remove_prefix(begin + 1);
  while (!query.empty()) {
    const std::size_t end = query.find('&');
    const std::string_view part = query.substr(0, end);
    constexpr std::string_view key = "number=";
    if (part.starts_with(key)) {
      const auto number = read_whole(part.substr(key.size()));
      if (number && *number <= max_learner) return number;
    }
    query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
  }
  return std::nullopt;
}

HandedIn read_line(std::string_view line, std::size_t number) {
  const std::size_t before = line.find_last_of(" \t,;");
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::string_view link = line.substr(begin);
  return {std::string(without(line.substr(0, begin), " \t,;\"")), std::string(without(link, "\"")),
          number_in(link), number};
}

}  // namespace

std::vector<HandedIn> read_handed_in(const std::string& link_or_file) {
  std::optional<std::string> file;
  if (link_or_file == "-") {
    file = read_standard_input();
  } else if (file = read_file(link_or_file); !file) {
    if (!looks_like_link(link_or_file) && link_or_file.find('#') == std::string::npos)
      throw Failure{bad_input_status, link_or_file, "there is no such file, and it is no link"};
    return {read_line(link_or_file, 1)};
  }
  std::vector<HandedIn> links;
  std::string_view text = *file;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = without(text.substr(0, end), blanks);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.front() != '#') links.push_back(read_line(line, number));
  }
  if (links.empty()) throw Failure{bad_input_status, link_or_file, "it has no link"};
  return links;
}

}  // namespace evenlift::native
