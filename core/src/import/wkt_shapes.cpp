#include "import/wkt_shapes.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/wording.h"
#include "formats/readers.h"
#include "import/gathering.h"
#include "import/tables/table_headings.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t first_lines_of_table = 100;  // one of them has a geometry

void add_notes(const RingNotes& notes, const WktReader& reader, Gathering& gathering) {
  gathering.add_notes(notes);
  if (!reader.system().empty() && !notes.are_degrees)
    gathering.note(say("the reference system (SRID {number}) was left out", {reader.system()}));
}

// A cell's place in its line, without quotation marks: bytes `from` .. `to` - 1.
struct GeometryCell {
  std::size_t from = 0, to = 0;
};

// The first cell of WKT in the line; nullopt if there is no such cell. It ends at its closing
// parenthesis, or at a quotation mark before any parenthesis, or at the end of the line. O(line).
std::optional<GeometryCell> find_geometry(std::string_view line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    const bool cell_begins =
        is_letter(line[at]) &&
        (at == 0 || std::string_view(" \t\",;|'").find(line[at - 1]) != std::string_view::npos);
    if (!cell_begins || !begins_wkt(TextCursor(line.substr(at)))) continue;
    std::size_t end = at;
    int depth = 0;
    for (; end < line.size(); ++end) {
      if (line[end] == '(') ++depth;
      if (line[end] == ')' && --depth == 0) break;
      if (depth == 0 && line[end] == '"') break;  // empty geometries have no parentheses
    }
    end = std::min(end + (end < line.size() && line[end] == ')' ? 1u : 0u), line.size());
    return GeometryCell{at, end};
  }
  return std::nullopt;
}

}  // namespace

Result<Import> read_wkt_shapes(std::string_view text, const ImportOptions& options) {
  Gathering gathering(options);
  gathering.import.format = "WKT";
  RingNotes notes;
  WktReader reader(gathering, notes);
  if (auto error = reader.take_all(text)) return *std::move(error);
  add_notes(notes, reader, gathering);
  const std::string found = gathering.left_out.list();
  return gathering.finish(
      {ErrorCode::unsupported,
       found.empty() ? say("this {format} has no polygon", {"WKT"})
                     : say("this {format} has no polygon, only {things}", {"WKT", found})});
}

// --- Tables

namespace {

class WktTable {
 public:
  WktTable(std::string_view text, const ImportOptions& options)
      : text_(text), gathering_(options), reader_(gathering_, notes_) {}

  Result<Import> read();

 private:
  void take_heading(const Line& line);
  void take_row(std::string_view line, const GeometryCell& cell);
  std::string name_in(std::string_view line, const GeometryCell& cell) const;

  std::string_view text_;
  Gathering gathering_;
  RingNotes notes_;
  WktReader reader_;
  char separator_ = ',';
  std::optional<std::size_t> name_;  // the column
};

// With a word in place of the geometry, which may contain separators.
std::string without_geometry(std::string_view line, const GeometryCell& cell) {
  return std::string(line.substr(0, cell.from)) + "geometry" + std::string(line.substr(cell.to));
}

void WktTable::take_heading(const Line& line) {
  const Fields headings = split_cells(line.text, separator_);
  for (const Column wanted : {Column::name, Column::number})
    for (std::size_t i = 0; i < headings.size() && !name_; ++i)
      if (column_of(headings[i]) == wanted) name_ = i;
}

std::string WktTable::name_in(std::string_view line, const GeometryCell& cell) const {
  if (!name_) return {};
  const std::string row = without_geometry(line, cell);
  const Fields cells = split_cells(row, separator_);
  return *name_ < cells.size() ? std::string(cells[*name_]) : std::string();
}

// Reads the geometry alone, so that it ends with its cell. Errors get their place in the whole
// text.
void WktTable::take_row(std::string_view line, const GeometryCell& cell) {
  const auto offset = static_cast<std::size_t>(line.data() - text_.data()) + cell.from;
  const std::string_view geometry = line.substr(cell.from, cell.to - cell.from);
  TextCursor cursor(geometry);
  if (auto wrong = reader_.take(geometry, cursor, name_in(line, cell))) {
    Place place = place_in_text(text_, offset);
    place.other += wrong->place.other - 1;
    wrong->place = place;
    gathering_.add_problem(*std::move(wrong));
  }
}

Result<Import> WktTable::read() {
  gathering_.import.format = "table with WKT";
  Lines scout(text_);
  for (auto line = scout.next(); line; line = scout.next()) {
    const auto cell = find_geometry(line->text);
    if (!cell) continue;
    separator_ = separator_of(without_geometry(line->text, *cell));
    break;
  }
  Lines lines(text_);
  bool has_rows = false;
  for (auto line = lines.next(); line && !gathering_.full(); line = lines.next()) {
    const auto cell = find_geometry(line->text);
    if (cell)
      take_row(line->text, *cell);
    else if (!has_rows)
      take_heading(*line);
    else
      gathering_.left_out.add("line without a geometry", "lines without a geometry");
    has_rows = has_rows || cell;
  }
  add_notes(notes_, reader_, gathering_);
  const std::string found = gathering_.left_out.list();
  return gathering_.finish(
      {ErrorCode::unsupported, found.empty()
                                   ? "this table has no polygon"
                                   : say("this table has no polygon, only {things}", {found})});
}

}  // namespace

Result<Import> read_wkt_table(std::string_view text, const ImportOptions& options) {
  return WktTable(text, options).read();
}

bool has_wkt_cells(std::string_view text) {
  Lines lines(text);
  bool names_coordinates = false;
  auto line = lines.next();
  for (std::size_t i = 0; line && i < first_lines_of_table; line = lines.next(), ++i) {
    const auto cell = find_geometry(line->text);
    if (!cell) {
      const Fields cells = split_cells(line->text, separator_of(line->text));
      names_coordinates = names_coordinates || named_columns(cells).has_value();
      continue;
    }
    const bool of_points = same_word(line->text.substr(cell->from, 5), "point");
    return !of_points || !names_coordinates;
  }
  return false;
}

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
  gathering_.add_notes(notes_);
  return gathering_.finish({ErrorCode::bad_syntax, "this list has no points (x, y)"});
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
