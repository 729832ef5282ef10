// Columns of numbers: a CSV table, cells that a spreadsheet copies to the clipboard, or lines "x,
// y".
#include <algorithm>
#include <iterator>
#include <vector>

#include "evenlift/numbers.h"
#include "formats/readers.h"
#include "import/cells.h"
#include "import/gathering.h"
#include "import/readers.h"
#include "import/unit_words.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// Whether the line begins with a number, perhaps in quotes. No heading does.
bool has_number_first(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\"+-.,;|"), line.size()));
  return !line.empty() && line[0] >= '0' && line[0] <= '9';
}

class ColumnReader {
 public:
  ColumnReader(std::string_view text, const ImportOptions& options)
      : text_(text), gathering_(options) {}
  Result<Import> read();

 private:
  InputError error(std::string_view at, ErrorCode code, std::string_view message) const;
  InputError error(const Line& line, ErrorCode code, std::string_view message) const {
    return error(line.text, code, message);
  }
  void find_separator();
  std::optional<InputError> read_lines();
  bool is_heading(const Line& line, const Fields& fields) const;
  std::optional<InputError> heading(const Line& line, const Fields& fields);
  std::optional<InputError> row(const Line& line);
  std::optional<InputError> choose_columns(const Line& line, const Fields& fields);
  InputError not_a_number(std::string_view field) const;
  void end_shape();

  std::string_view text_;
  Gathering gathering_;
  char separator_ = ' ';
  bool decimal_comma_ = false;  // allowed
  std::optional<std::size_t> x_, y_;
  bool named_ = false;  // the heading chose the columns
  bool more_columns_ = false;
  bool has_rows_ = false;               // of numbers
  LengthUnit unit_ = LengthUnit::none;  // the heading gives it for both columns
  std::string name_;
  Points points_;
};

// `at` is a part of the text.
InputError ColumnReader::error(std::string_view at, ErrorCode code,
                               std::string_view message) const {
  const auto offset = static_cast<std::size_t>(at.data() - text_.data());
  return text_error(code, std::string(message), text_, offset);
}

std::optional<InputError> ColumnReader::heading(const Line& line, const Fields& fields) {
  if (has_field(fields, "robot") || has_field(fields, "robots"))
    return error(line, ErrorCode::unsupported, robots_are_no_polygon);
  if (has_field(fields, "polygon") && has_field(fields, "method"))
    return error(line, ErrorCode::unsupported,
                 "this is a table of an experiment, not a polygon: open the polygons themselves");
  x_.reset();
  y_.reset();
  for (std::size_t i = fields.size(); i-- > 0;) {
    if (names_column(fields[i], 'x')) x_ = i;
    if (names_column(fields[i], 'y')) y_ = i;
  }
  named_ = x_ && y_;
  if (named_) {
    const LengthUnit unit = unit_of_column(fields[*x_]);
    unit_ = unit == unit_of_column(fields[*y_]) ? unit : LengthUnit::none;
    return std::nullopt;
  }
  x_.reset();
  y_.reset();
  // A line of words before a shape is its name.
  if (fields.size() == 1 || separator_ == ' ') name_ = std::string(trimmed(line.text));
  return std::nullopt;
}

InputError ColumnReader::not_a_number(std::string_view field) const {
  const std::string quoted = "\"" + clean_name(field.substr(0, 60)) + "\"";
  if (separator_ == ',' && field.find(' ') != std::string_view::npos)
    return error(
        field, ErrorCode::bad_syntax,
        quoted +
            " is not a number: write decimals with a point (1.5, 2.3), or with a comma and a "
            "semicolon between x and y (1,5; 2,3)");
  if (field.find(',') != std::string_view::npos || field.find('.') != std::string_view::npos)
    return error(
        field, ErrorCode::bad_syntax,
        quoted +
            " is not a number: a number has one point or comma, before its decimals, and no "
            "separator between its thousands");
  return error(field, ErrorCode::bad_syntax, quoted + " is not a number");
}

// Chooses the first two columns with numbers.
std::optional<InputError> ColumnReader::choose_columns(const Line& line, const Fields& fields) {
  // "1,5 2,3" may mean 1.5 and 2.3, or three numbers.
  for (const std::string_view field : fields)
    if (!cell_number(field, decimal_comma_) &&
        field.find_first_not_of("0123456789+-.,eE \t") == std::string_view::npos && !field.empty())
      return not_a_number(field);
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!cell_number(fields[i], decimal_comma_)) continue;
    ++numbers;
    if (!x_)
      x_ = i;
    else if (!y_)
      y_ = i;
  }
  if (numbers < 2) {
    const auto wrong = std::find_if(fields.begin(), fields.end(), [&](std::string_view field) {
      return !field.empty() && !cell_number(field, decimal_comma_);
    });
    if (wrong != fields.end()) return not_a_number(*wrong);
    return error(line, ErrorCode::bad_syntax, "a line has two numbers, x and y");
  }
  more_columns_ = numbers > 2;
  return std::nullopt;
}

std::optional<InputError> ColumnReader::row(const Line& line) {
  const Fields fields = split_cells(line.text, separator_);
  if (!x_)
    if (auto wrong = choose_columns(line, fields)) return wrong;
  double values[2];
  const std::size_t columns[2] = {*x_, *y_};
  for (int i = 0; i < 2; ++i) {
    if (columns[i] >= fields.size() || fields[columns[i]].empty())
      return error(line, ErrorCode::bad_syntax, i == 0 ? "the line has no x" : "the line has no y");
    const std::optional<double> value = cell_number(fields[columns[i]], decimal_comma_);
    if (!value) return not_a_number(fields[columns[i]]);
    values[i] = *value;
  }
  if (points_.size() > max_vertices)  // one more may close it
    return error(line, ErrorCode::too_many_vertices, no_more_vertices);
  points_.push_back({values[0], values[1]});
  return std::nullopt;
}

void ColumnReader::end_shape() {
  if (points_.empty()) return;
  Document document;
  document.vertices = std::exchange(points_, {});
  document.shown.units.length = unit_;
  gathering_.add(std::move(document), std::exchange(name_, ""), "points");
}

// Takes the separator of the first line that begins with a number, even for a heading before it. If
// names fill the first column, it takes the separator of the first line that contains a digit.
void ColumnReader::find_separator() {
  bool decided = false;
  Lines scout(text_);
  for (std::optional<Line> line = scout.next(); line; line = scout.next()) {
    const bool number_first = has_number_first(line->text);
    if (!number_first &&
        (decided || line->text.find_first_of("0123456789") == std::string_view::npos))
      continue;
    separator_ = separator_of(line->text);
    decided = true;
    if (number_first) break;
  }
  decimal_comma_ = separator_ != ',' && separator_ != ' ';
}

// Whether no field of the line is a number, and the line does not begin with one.
bool ColumnReader::is_heading(const Line& line, const Fields& fields) const {
  return !has_number_first(line.text) &&
         std::none_of(fields.begin(), fields.end(), [&](std::string_view field) {
           return cell_number(field, decimal_comma_).has_value();
         });
}

// Whether the line is the heading of poses for ROS 2.
bool is_pose_array(std::string_view line) { return line == "poses:"; }

std::optional<InputError> ColumnReader::read_lines() {
  Lines lines(text_);
  bool first = true;
  for (std::optional<Line> line = lines.next(); line && !gathering_.full(); line = lines.next()) {
    if (is_pose_array(line->text) && !has_rows_)
      return error(*line, ErrorCode::unsupported, robots_are_no_polygon);
    if (line->after_blank) end_shape();
    const bool begins = first || (line->after_blank && points_.empty());
    const Fields fields = split_cells(line->text, separator_);
    first = begins && is_heading(*line, fields);  // a name may precede a heading
    if (auto wrong = first ? heading(*line, fields) : row(*line)) return wrong;
    has_rows_ = has_rows_ || !first;
  }
  end_shape();
  return std::nullopt;
}

Result<Import> ColumnReader::read() {
  gathering_.import.format = "columns";
  find_separator();
  if (auto wrong = read_lines()) return *std::move(wrong);
  if (!has_rows_) {
    return InputError{
        ErrorCode::bad_syntax, joined({"this text is in an unknown format: ", known_formats}), {}};
  }
  if (unit_ != LengthUnit::none) gathering_.import.unit = in_full(unit_);
  if (more_columns_ && !named_)
    gathering_.note("the first two columns with numbers were taken as x and y");
  if (gathering_.import.shapes.size() > 1) gathering_.note("blank lines separate the shapes");
  return gathering_.finish(text_error(ErrorCode::too_few_vertices, no_vertices, text_, 0));
}

}  // namespace

Result<Import> read_columns(std::string_view text, const ImportOptions& options) {
  return ColumnReader(text, options).read();
}

}  // namespace evenlift
