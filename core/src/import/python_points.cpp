#include "import/python_points.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/wording.h"
#include "formats/readers.h"
#include "import/gathering.h"
#include "import/ring_notes.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t deepest = 32;

bool opens(char c) { return c == '[' || c == '('; }
char closing(char c) { return c == '[' ? ']' : ')'; }

std::size_t after_spaces(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

class PythonPoints {
 public:
  PythonPoints(std::string_view text, const ImportOptions& options)
      : cursor_(text), text_(text), gathering_(options) {}

  Result<Import> read();

 private:
  // An open bracket.
  struct Level {
    char closes = ']';
    std::vector<double> numbers;
    Points points;
  };

  std::optional<InputError> take();
  std::optional<InputError> close();
  void add_shape(Points points);

  TextCursor cursor_;
  std::string_view text_;
  Gathering gathering_;
  RingNotes notes_;
  std::vector<Level> levels_;
};

void PythonPoints::add_shape(Points points) {
  Document document;
  document.vertices = std::move(points);
  notes_.drop_repeated(document.vertices);
  gathering_.add(std::move(document), "", "points");
}

// A bracket with numbers is a point; one with points is a shape.
std::optional<InputError> PythonPoints::close() {
  if (!cursor_.take(levels_.back().closes))
    return cursor_.expected(
        say("',' or {bracket}", {std::string("'") + levels_.back().closes + "'"}));
  Level level = std::move(levels_.back());
  levels_.pop_back();
  if (level.numbers.empty()) {
    if (!level.points.empty()) add_shape(std::move(level.points));
    return std::nullopt;
  }
  if (level.numbers.size() < 2 || level.numbers.size() > 4 || !level.points.empty())
    return cursor_.error_at(cursor_.offset() - 1, ErrorCode::bad_syntax,
                            "expected points (x, y) of two numbers");
  if (level.numbers.size() > 2) ++notes_.heights;
  if (levels_.empty()) levels_.push_back({'\0', {}, {}});  // for pairs without brackets around them
  if (levels_.back().points.size() > max_vertices)
    return cursor_.error(ErrorCode::too_many_vertices, no_more_vertices);
  levels_.back().points.push_back({level.numbers[0], level.numbers[1]});
  return std::nullopt;
}

// A bracket, a number or the end of a list. numpy prints no commas between them.
std::optional<InputError> PythonPoints::take() {
  const char c = text_[cursor_.offset()];
  if (opens(c)) {
    if (levels_.size() == deepest)
      return cursor_.error(ErrorCode::unsupported, "the lists are nested too deep");
    cursor_.take(c);
    levels_.push_back({closing(c), {}, {}});
    return std::nullopt;
  }
  if (levels_.empty() || levels_.back().closes == '\0') return cursor_.expected("'('");
  if (!cursor_.sees_number()) return close();
  double value = 0;
  if (auto error = cursor_.take_number(value, "a number")) return error;
  if (levels_.back().numbers.size() < 5) levels_.back().numbers.push_back(value);
  return std::nullopt;
}

Result<Import> PythonPoints::read() {
  gathering_.import.format = "points in Python";
  cursor_.skip_white_space();
  while (!cursor_.at_end() && !gathering_.full()) {
    if (auto error = take()) return *std::move(error);
    cursor_.skip_white_space();
    if (cursor_.take(',')) cursor_.skip_white_space();
  }
  if (!levels_.empty() && levels_.back().closes != '\0')
    return cursor_.expected(std::string("'") + levels_.back().closes + "'");
  if (!levels_.empty()) add_shape(std::move(levels_.back().points));
  notes_.add_to(gathering_);
  return gathering_.finish({ErrorCode::bad_syntax, "this list has no points (x, y)", {}});
}

}  // namespace

bool looks_like_python(std::string_view text) {
  if (text.find_first_not_of("0123456789+-.,eE()[] \t\r\n") != std::string_view::npos) return false;
  const std::size_t first = after_spaces(text, 0);
  if (first == text.size() || !opens(text[first])) return false;
  const std::size_t second = after_spaces(text, first + 1);
  if (second < text.size() && opens(text[second])) return true;
  const std::size_t end = text.find(')', second);
  if (text[first] != '(' || end == std::string_view::npos) return false;
  const std::size_t next = after_spaces(text, end + 1);
  return next < text.size() && text[next] == ',';
}

Result<Import> read_python_points(std::string_view text, const ImportOptions& options) {
  return PythonPoints(text, options).read();
}

}  // namespace evenlift
