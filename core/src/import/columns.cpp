#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/wording.h"
#include "formats/readers.h"
#include "import/gathering.h"
#include "import/readers.h"
#include "import/table_columns.h"
#include "import/tables/table_headings.h"
#include "import/wkt_shapes.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// A text with this many lines before the first row is not a table.
constexpr std::size_t most_heading_lines = 100;
constexpr std::size_t most_comment_lines = 1000;  // later ones name no columns

// As in "X coord    Y coord".
Fields split_at_wide_spaces(std::string_view line) {
  Fields cells;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find("  "), line.size());
    if (const std::string_view cell = trimmed(line.substr(0, end)); !cell.empty())
      cells.push_back(cell);
    line.remove_prefix(std::min(line.size(), end + 2));
  }
  return cells;
}

// "x [mm] y [mm]": each bracket belongs to the name before it.
Fields with_brackets(const Fields& cells) {
  Fields whole;
  for (const std::string_view cell : cells) {
    const bool bracket = !cell.empty() && (cell[0] == '(' || cell[0] == '[');
    if (bracket && !whole.empty()) {
      const char* begin = whole.back().data();
      whole.back() = {begin, static_cast<std::size_t>(cell.data() + cell.size() - begin)};
    } else {
      whole.push_back(cell);
    }
  }
  return whole;
}

struct Block {  // the lines between two blank lines
  std::string name;
  Points points;
};

class ColumnReader {
 public:
  ColumnReader(std::string_view text, const ImportOptions& options)
      : text_(text), gathering_(options) {}
  Result<Import> read();

 private:
  using Problem = std::optional<InputError>;

  InputError error(std::string_view at, ErrorCode code, std::string message) const;
  Problem read_lines();
  bool is_row(const Line& line, const Fields& cells, const Lines& following);
  bool is_count(const Line& line, const Fields& cells, const Lines& following) const;
  Problem check_heading(const Line& line, const Fields& cells) const;
  bool take_heading(const Line& line);
  void leave_out_headings();
  void clear_headings();
  Problem begin_rows(const Line& row, const Fields& cells);
  std::string_view rows_from(const Line& row) const;
  bool take_names(const Line& heading, const Line& row, const Fields& cells);
  bool may_group(const NamedColumns& named, std::size_t column, const Fields& headings,
                 const Line& row) const;
  void take_units(const Line& heading);
  void take_words(const std::vector<Line>& words);
  Problem choose(const Line& row, const Fields& cells, const Fields& headings);
  Problem check_row(const Line& line, const Fields& cells);
  Problem check_word(const Fields& cells);
  void follow_shapes(const Fields& cells);
  Problem row(const Line& line, const Fields& cells);
  InputError not_a_number(std::string_view field) const;
  void end_block();
  void join_surfaces();
  void join_remnants();
  Problem check_count() const;
  void add_notes();

  std::string_view text_;
  Gathering gathering_;
  CellStyle style_;
  std::vector<Line> headings_;  // of this block, until its first row, with comments
  std::size_t heading_lines_ = 0, comment_lines_ = 0;  // among `headings_`
  std::optional<NamedColumns> named_;
  std::size_t x_ = 0, y_ = 0;
  bool chosen_ = false;  // x_ and y_ are set
  // Of the first row, if headings name nothing:
  std::size_t first_row_size_ = 0;
  std::vector<std::size_t> number_columns_;
  std::size_t heading_size_ = 0;         // of the heading that names x and y
  std::string_view first_word_;          // of all rows, if the first two begin with the same
  std::vector<std::size_t> shapes_;      // the columns that number or name the shapes
  std::vector<std::string_view> shape_;  // their cells in the last row
  std::size_t rows_ = 0;
  std::optional<Line> count_line_;  // states the number of rows
  LengthUnit unit_ = LengthUnit::none;
  bool is_in_feet_ = false;  // and unit_ is inches
  RingNotes notes_;
  Block block_;
  std::vector<Block> blocks_;
};

// `at` is a part of the text.
InputError ColumnReader::error(std::string_view at, ErrorCode code, std::string message) const {
  const auto offset = static_cast<std::size_t>(at.data() - text_.data());
  return text_error(code, std::move(message), text_, offset);
}

InputError ColumnReader::not_a_number(std::string_view field) const {
  const std::string cell = in_quotes(clean_name(field.substr(0, 60)));
  if (style_.separator == ',' && field.find(' ') != std::string_view::npos &&
      has_only_digits({field}))
    return error(
        field, ErrorCode::bad_syntax,
        say("{cell} is not a number: write decimals with a point (1.5, 2.3), or with a comma and a "
            "semicolon between x and y (1,5; 2,3)",
            {cell}));
  if (has_only_digits({field}) && field.find_first_of(",.") != std::string_view::npos)
    return error(
        field, ErrorCode::bad_syntax,
        say("{cell} is not a number: a number has one point or comma, before its decimals, and no "
            "separator between its thousands",
            {cell}));
  return error(field, ErrorCode::bad_syntax, say("{cell} is not a number", {cell}));
}

// --- Headings

// Whether a lone whole number is the number of the rows that follow.
bool ColumnReader::is_count(const Line& line, const Fields& cells, const Lines& following) const {
  Lines ahead = following;
  const std::optional<Line> next = ahead.next();
  if (rows_ > 0 || count_line_ || cells.size() != 1 || !read_whole(trimmed(line.text)) || !next)
    return false;
  return number_columns(split_cells(next->text, style_.separator), style_).size() > 1;
}

// Whether the line is a row. The line after a heading has numbers in other columns. Keeps a count
// of rows in `count_line_`.
bool ColumnReader::is_row(const Line& line, const Fields& cells, const Lines& following) {
  if (is_count(line, cells, following)) {
    count_line_ = line;
    return false;
  }
  Lines ahead = following;
  const std::optional<Line> next = ahead.next();
  const auto below = next ? number_columns(split_cells(next->text, style_.separator), style_)
                          : std::vector<std::size_t>();
  // Digits alone are a row, right or wrong, unless they are one word before the rows, such as a
  // date.
  if (has_only_digits(cells)) return rows_ > 0 || cells.size() > 1 || below.size() < 2;
  const auto numbers = number_columns(cells, style_);
  if (numbers.size() < 2) return false;
  if (!next || numbers[0] == 0) return true;
  return below.size() >= 2 && below[0] == numbers[0] && below[1] == numbers[1];
}

std::optional<InputError> ColumnReader::check_heading(const Line& line, const Fields& cells) const {
  if (has_field(cells, "robot") || has_field(cells, "robots"))
    return error(line.text, ErrorCode::unsupported, robots_are_no_polygon);
  if (has_field(cells, "polygon") && has_field(cells, "method"))
    return error(line.text, ErrorCode::unsupported,
                 "this is a table of an experiment, not a polygon: open the polygons themselves");
  if (line.text == "poses:" && rows_ == 0)
    return error(line.text, ErrorCode::unsupported, robots_are_no_polygon);
  return std::nullopt;
}

std::string_view ColumnReader::rows_from(const Line& row) const {
  return text_.substr(static_cast<std::size_t>(row.text.data() - text_.data()));
}

// The heading's cells may be separated in another way, and it may be a comment.
bool ColumnReader::take_names(const Line& heading, const Line& row, const Fields& cells) {
  std::string_view text = heading.text;
  const bool comment = text.front() == '#';
  if (comment) text = trimmed(text.substr(1));
  const Fields ways[] = {
      split_cells(heading.text, style_.separator), split_cells(text, style_.separator),
      split_cells(text, separator_of(text)),       split_at_wide_spaces(text),
      with_brackets(split_cells(text, ' ')),       names_among(split_cells(text, ' '))};
  const Fields* best = nullptr;
  for (const Fields& names_in_line : ways) {
    const auto names = named_columns(names_in_line);
    if (!names || names->x >= cells.size() || names->y >= cells.size()) continue;
    if (comment && names_in_line.size() != cells.size()) continue;  // comments are mostly prose
    if (!best || (best->size() != cells.size() && names_in_line.size() == cells.size()))
      best = &names_in_line;
  }
  if (!best) return false;
  named_ = named_columns(*best);
  x_ = named_->x;
  y_ = named_->y;
  chosen_ = true;
  unit_ = named_->unit;
  is_in_feet_ = named_->is_in_feet;
  heading_size_ = best->size();
  if (rows_ > 0) return true;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < best->size(); ++i)
    if (i != x_ && i != y_ && (may_tell_shapes((*best)[i]) || may_group(*named_, i, *best, row)))
      others.push_back(i);
  shapes_ = columns_of_shapes(rows_from(row), style_, others);
  for (const std::size_t column : shapes_)
    gathering_.note(
        say("the column {name} separates the shapes", {in_quotes(clean_name((*best)[column]))}));
  for (std::size_t i = 0; i < best->size(); ++i)
    if (i != x_ && i != y_ && std::find(shapes_.begin(), shapes_.end(), i) == shapes_.end() &&
        !(*best)[i].empty() && !may_tell_shapes((*best)[i]))
      gathering_.note(
          say(content_of((*best)[i]) == Column::capacity
                  ? "the column {name} was left out: if the rows are places of robots, "
                    "they are supports, not an outline"
              : content_of((*best)[i]) == Column::size
                  ? "the column {name} was left out: if the rows are holes, they are not "
                    "an outline; if robots stand there, they are supports"
                  : "the column {name} was left out",
              {in_quotes(clean_name((*best)[i]))}));
  return true;
}

// Whether a column whose heading says nothing may tell the shapes apart: it has words or small whole
// numbers, and is none of heights or amounts.
bool ColumnReader::may_group(const NamedColumns& named, std::size_t column, const Fields& headings,
                             const Line& row) const {
  return content_of(headings[column]) < Column::capacity &&
         column_of(headings[column]) == Column::other &&
         std::find(named.heights.begin(), named.heights.end(), column) == named.heights.end() &&
         has_words_or_counts(rows_from(row), style_, column);
}

// A line of units below the names.
void ColumnReader::take_units(const Line& heading) {
  const Fields cells = split_cells(heading.text, style_.separator);
  if (x_ < cells.size() && y_ < cells.size() && unit_in(cells[x_]) == unit_in(cells[y_]))
    unit_ = unit_in(cells[x_]);
}

// Lines that are neither names of columns nor units. The first line of words names the shape.
void ColumnReader::take_words(const std::vector<Line>& words) {
  bool plain = true;
  std::size_t skipped = 0;
  for (const Line& line : words) {
    const Fields cells = split_cells(line.text, style_.separator);
    plain = plain && number_columns(cells, style_).empty();
    if (block_.name.empty() && (cells.size() == 1 || style_.separator == ' '))
      block_.name = std::string(trimmed(line.text));
    ++skipped;
  }
  if (rows_ > 0 || (plain && skipped <= 1)) return;
  gathering_.note(skipped == 1 ? say("the line {text} was taken as a heading",
                                     {in_quotes(clean_name(words[0].text))})
                               : say("the first {count} lines were taken as headings", {skipped}));
}

// A line such as "sep=;", for spreadsheet programs.
bool names_separator(std::string_view line) { return same_word(line.substr(0, 4), "sep="); }

std::optional<InputError> ColumnReader::begin_rows(const Line& row, const Fields& cells) {
  std::size_t names = headings_.size();
  while (names > 0 && !take_names(headings_[names - 1], row, cells)) --names;
  std::vector<Line> words;
  Fields headings;
  for (std::size_t i = 0; i < headings_.size(); ++i) {
    const Fields own = split_cells(headings_[i].text, style_.separator);
    if (names > 0 && i + 1 == names) continue;
    if (names > 0 && i + 1 > names) {
      if (unit_ == LengthUnit::none) take_units(headings_[i]);
      continue;
    }
    if (headings_[i].text.front() == '#' || names_separator(headings_[i].text)) continue;
    if (own.size() >= cells.size() && own.size() > 1) headings = own;
    words.push_back(headings_[i]);
  }
  take_words(words);
  clear_headings();
  return chosen_ ? std::nullopt : choose(row, cells, headings);
}

// Chooses x and y if no heading names them.
std::optional<InputError> ColumnReader::choose(const Line& row, const Fields& cells,
                                               const Fields& headings) {
  // "1,5 2,3" may mean 1.5 and 2.3, or three numbers.
  for (const std::string_view cell : cells)
    if (!cell.empty() && !cell_number(cell, style_.decimal_comma) && has_only_digits({cell}))
      return not_a_number(cell);
  if (number_columns(cells, style_).size() < 2) {
    const auto wrong = std::find_if(cells.begin(), cells.end(), [&](std::string_view cell) {
      return !cell.empty() && !cell_number(cell, style_.decimal_comma);
    });
    if (wrong != cells.end()) return not_a_number(*wrong);
    return error(row.text, ErrorCode::bad_syntax, "a line has two numbers, x and y");
  }
  ChosenColumns columns = choose_columns(rows_from(row), style_, cells, headings);
  shapes_ = std::move(columns.shapes);
  x_ = columns.x;
  y_ = columns.y;
  chosen_ = true;
  first_row_size_ = cells.size();
  number_columns_ = number_columns(cells, style_);
  if (!columns.note.empty()) gathering_.note(columns.note);
  return std::nullopt;
}

// --- Rows

// If the first two rows begin with the same word, all must: meshes mark vertices and faces by
// words.
std::optional<InputError> ColumnReader::check_word(const Fields& cells) {
  if (cells.empty() || cells[0].empty() || x_ == 0 || y_ == 0 || !shapes_.empty())
    return std::nullopt;
  if (rows_ == 0) first_word_ = cell_number(cells[0], style_.decimal_comma) ? "" : cells[0];
  if (rows_ == 1 && cells[0] != first_word_) first_word_ = "";
  if (rows_ < 2 || first_word_.empty() || cells[0] == first_word_) return std::nullopt;
  return error(cells[0], ErrorCode::bad_syntax,
               say("the line begins with {word}, but the lines before it with {first}: blank "
                   "lines separate shapes",
                   {in_quotes(clean_name(cells[0])), in_quotes(clean_name(first_word_))}));
}

// Each row has its numbers where the first one has them.
std::optional<InputError> ColumnReader::check_row(const Line& line, const Fields& cells) {
  const auto is_number = [&](std::size_t column) {
    return cell_number(cells[column], style_.decimal_comma).has_value();
  };
  if (named_) {
    if (style_.separator == ' ' || cells.size() <= heading_size_ ||
        number_columns(cells, style_).size() < cells.size())
      return std::nullopt;
    return error(line.text, ErrorCode::bad_syntax,
                 say("the line has {numbers} numbers, but the heading has {names} names; decimals "
                     "with a comma need a semicolon between the columns",
                     {cells.size(), heading_size_}));
  }
  bool same = std::all_of(number_columns_.begin(), number_columns_.end(), [&](std::size_t column) {
    return column < cells.size() && (cells[column].empty() || is_number(column));
  });
  for (std::size_t column = first_row_size_; column < cells.size(); ++column)
    same = same && !is_number(column);
  if (same) return std::nullopt;
  const std::size_t numbers = number_columns(cells, style_).size();
  return error(line.text, ErrorCode::bad_syntax,
               say(numbers == 1 ? "the line has {numbers} number, but the first row has {first}: "
                                  "all rows need the same columns"
                                : "the line has {numbers} numbers, but the first row has {first}: "
                                  "all rows need the same columns",
                   {numbers, number_columns_.size()}));
}

void ColumnReader::follow_shapes(const Fields& cells) {
  std::vector<std::string_view> shape;
  for (const std::size_t column : shapes_)
    shape.push_back(column < cells.size() ? cells[column] : std::string_view());
  if (shape == shape_) return;
  end_block();
  block_.name = std::string(shape[0]);
  shape_ = std::move(shape);
}

std::optional<InputError> ColumnReader::row(const Line& line, const Fields& cells) {
  if (!shapes_.empty()) follow_shapes(cells);
  double values[2];
  const std::size_t columns[2] = {x_, y_};
  if (auto wrong = check_word(cells)) return wrong;
  for (int i = 0; i < 2; ++i) {
    if (columns[i] >= cells.size() || cells[columns[i]].empty())
      return error(line.text, ErrorCode::bad_syntax,
                   i == 0 ? "the line has no x" : "the line has no y");
    const std::optional<double> value = cell_number(cells[columns[i]], style_.decimal_comma);
    if (!value) return not_a_number(cells[columns[i]]);
    values[i] = *value;
  }
  if (auto wrong = check_row(line, cells)) return wrong;
  if (block_.points.size() > max_vertices)  // one more may close it
    return error(line.text, ErrorCode::too_many_vertices, no_more_vertices);
  block_.points.push_back({values[0], values[1]});
  ++rows_;
  return std::nullopt;
}

void ColumnReader::end_block() {
  if (block_.points.empty()) return;
  Block block = std::exchange(block_, {});
  if (shapes_.empty() || block.points.size() >= 3) return blocks_.push_back(std::move(block));
  gathering_.left_out.add("group of fewer than three points", "groups of fewer than three points");
}

void ColumnReader::clear_headings() {
  headings_.clear();
  heading_lines_ = comment_lines_ = 0;
}

// Keeps a line before the first row of a block. Returns false if a table can no longer begin.
bool ColumnReader::take_heading(const Line& line) {
  const bool comment = line.text.front() == '#';
  if (comment && comment_lines_ == most_comment_lines) return true;
  if (rows_ > 0 && heading_lines_ == most_heading_lines) leave_out_headings();
  headings_.push_back(line);
  ++(comment ? comment_lines_ : heading_lines_);
  return rows_ > 0 || heading_lines_ < most_heading_lines;
}

// Lines with no rows below them.
void ColumnReader::leave_out_headings() {
  for (const Line& line : headings_)
    if (line.text.front() != '#')
      gathering_.left_out.add("line without numbers", "lines without numbers");
  clear_headings();
}

std::optional<InputError> ColumnReader::read_lines() {
  Lines lines(text_, Comments::returned);
  bool in_rows = false;
  for (std::optional<Line> line = lines.next(); line && blocks_.size() <= max_shapes;
       line = lines.next()) {
    if (line->after_blank && in_rows) {
      end_block();
      in_rows = false;
    }
    const bool comment = line->text.front() == '#';
    if (comment && in_rows) continue;
    const Fields cells = split_cells(line->text, style_.separator);
    if (!in_rows && (comment || !is_row(*line, cells, lines))) {
      if (!comment)
        if (auto wrong = check_heading(*line, cells)) return wrong;
      const bool is_heading = !count_line_ || count_line_->number != line->number;
      if (is_heading && !take_heading(*line)) return std::nullopt;
      continue;
    }
    if (!in_rows)
      if (auto wrong = begin_rows(*line, cells)) return wrong;
    in_rows = true;
    if (auto wrong = row(*line, cells)) return wrong;
  }
  end_block();
  leave_out_headings();
  return std::nullopt;
}

// --- The whole

// Whether x runs along a chord of length 1: a surface of an airfoil.
bool runs_along_chord(const Points& points, bool forwards) {
  constexpr std::size_t fewest = 5;  // two triangles may also share an edge of length 1
  const auto along = [&](const Vec2& a, const Vec2& b) {
    return forwards ? a.x <= b.x : a.x >= b.x;
  };
  const Vec2 &nose = forwards ? points.front() : points.back(),
             &tail = forwards ? points.back() : points.front();
  return points.size() >= fewest && nose.x == 0 && tail.x == 1 &&
         std::is_sorted(points.begin(), points.end(),
                        [&](const Vec2& a, const Vec2& b) { return !along(b, a); });
}

// Joins the two blocks of an airfoil, the upper and the lower surface. In Lednicer's format a row
// with their numbers of points precedes them, and both begin at the leading edge.
void ColumnReader::join_surfaces() {
  const bool counted = blocks_.size() == 3 && blocks_[0].points.size() == 1 &&
                       blocks_[0].points[0] == Vec2(static_cast<double>(blocks_[1].points.size()),
                                                    static_cast<double>(blocks_[2].points.size()));
  if (!counted && blocks_.size() != 2) return;
  Points &upper = blocks_[blocks_.size() - 2].points, &lower = blocks_.back().points;
  const bool forwards = counted || runs_along_chord(upper, true);
  if (!counted && !(runs_along_chord(lower, true) && (forwards || runs_along_chord(upper, false))))
    return;
  if (!blocks_.back().name.empty()) return;
  if (forwards) std::reverse(upper.begin(), upper.end());
  const std::ptrdiff_t shared = upper.back() == lower.front() ? 1 : 0;
  upper.insert(upper.end(), lower.begin() + shared, lower.end());
  Block whole{blocks_[0].name, std::move(upper)};
  blocks_.clear();
  blocks_.push_back(std::move(whole));
  gathering_.note("the upper and the lower surface were joined at the leading edge");
}

// Blank lines separate shapes only if each could be one.
void ColumnReader::join_remnants() {
  const bool is_one =
      blocks_.size() > 1 && shapes_.empty() &&
      std::all_of(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.name.empty(); }) &&
      std::any_of(blocks_.begin(), blocks_.end(),
                  [](const Block& b) { return b.points.size() < 3; });
  if (!is_one) return;
  Block whole;
  for (const Block& block : blocks_)
    whole.points.insert(whole.points.end(), block.points.begin(), block.points.end());
  blocks_.clear();
  blocks_.push_back(std::move(whole));
  gathering_.note(
      "blank lines were passed over, since fewer than three points are between some of them");
}

std::optional<InputError> ColumnReader::check_count() const {
  if (!count_line_ || read_whole(trimmed(count_line_->text)) == rows_) return std::nullopt;
  return error(count_line_->text, ErrorCode::bad_syntax,
               "a line has two numbers, x and y, and this number is not that of the rows below");
}

void ColumnReader::add_notes() {
  if (unit_ != LengthUnit::none) gathering_.import.unit = in_full(unit_);
  if (is_in_feet_) gathering_.note("the coordinates in feet are now in inches");
  if (count_line_) gathering_.note("the number before the rows is how many there are");
  notes_.are_degrees = named_ && named_->meaning == Column::longitude;
  if (notes_.are_degrees && named_->y < named_->x)
    gathering_.note("the latitude comes first here: x is the longitude, and y the latitude");
  gathering_.add_notes(notes_);
  if (gathering_.import.shapes.size() > 1 && shapes_.empty())
    gathering_.note("blank lines separate the shapes");
}

Result<Import> ColumnReader::read() {
  gathering_.import.format = "columns";
  style_ = style_of_table(text_);
  if (auto wrong = read_lines()) return *std::move(wrong);
  if (rows_ == 0) {
    return InputError{ErrorCode::bad_syntax,
                      say("this text is in an unknown format: {formats}", {known_formats})};
  }
  if (auto wrong = check_count()) return *std::move(wrong);
  join_surfaces();
  join_remnants();
  for (Block& block : blocks_) {
    Document document;
    document.vertices = std::move(block.points);
    if (is_in_feet_)
      for (Vec2& vertex : document.vertices) vertex = inches_of_a_foot * vertex;
    document.shown.units.length = unit_;
    notes_.drop_repeated(document.vertices);
    gathering_.add(std::move(document), block.name, "points");
  }
  add_notes();
  return gathering_.finish(text_error(ErrorCode::too_few_vertices, no_vertices, text_, 0));
}

}  // namespace

Result<Import> read_columns(std::string_view text, const ImportOptions& options) {
  return has_wkt_cells(text) ? read_wkt_table(text, options) : ColumnReader(text, options).read();
}

}  // namespace evenlift
