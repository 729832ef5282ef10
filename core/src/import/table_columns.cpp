#include "import/table_columns.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "evenlift/wording.h"
#include "import/gathering.h"
#include "import/tables/table_headings.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t first_lines = 200;  // the first row is among them

// Headings never begin with a number, even in quotes.
bool has_number_first(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\"+-.,;|"), line.size()));
  return !line.empty() && is_digit(line[0]);
}

CellStyle style_of_line(std::string_view line) {
  const char separator = separator_of(line);
  return {separator, separator != ',' && separator != ' '};
}

// Properties of a column's cells so far.
class Course {
 public:
  void add(std::string_view cell, double value, bool after_blank) {
    const bool whole = cell.find_first_not_of("0123456789\"") == std::string_view::npos;
    if (count_ == 0) first_ = value;
    if (count_ > 0) {
      counts_ = counts_ && (value == last_ + 1 || (after_blank && value == first_));
      rises_ = rises_ && value > last_;
      same_ = same_ && value == first_;
    }
    whole_ = whole_ && whole;
    pointed_ = pointed_ && cell.find_first_of(".,") != std::string_view::npos;
    last_ = value;
    ++count_;
  }

  bool stays_the_same() const { return same_ && count_ >= 3; }
  // 1, 2, 3 ...; from another number on, three may be chance.
  bool counts() const { return counts_ && whole_ && count_ >= (first_ == 1 ? 3u : 4u); }
  // The numbers of the points that remain after others were deleted.
  bool rises_in_whole_numbers() const { return rises_ && whole_ && count_ >= 3; }
  bool has_decimals() const { return pointed_ && count_ > 0; }

 private:
  std::size_t count_ = 0;
  double first_ = 0, last_ = 0;
  bool counts_ = true, rises_ = true, same_ = true, whole_ = true, pointed_ = true;
};

struct Candidate {
  std::size_t column = 0;
  Course course;
  const char* reason = nullptr;  // why it is not a coordinate: a clause with a place for its label
};

using Candidates = std::vector<Candidate>;

std::vector<std::size_t> left_of(const Candidates& all) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].reason) left.push_back(i);
  return left;
}

template <class Test>
void drop(Candidates& all, const char* reason, const Test& test) {
  std::size_t left = left_of(all).size();
  for (Candidate& each : all) {
    if (left <= 2) return;
    if (each.reason || !test(each)) continue;
    each.reason = reason;
    --left;
  }
}

void follow(Candidates& all, std::string_view rows, const CellStyle& style) {
  Lines lines(rows);
  for (auto line = lines.next(); line; line = lines.next()) {
    const Fields cells = split_cells(line->text, style.separator);
    for (Candidate& each : all) {
      if (each.column >= cells.size()) continue;
      const auto value = cell_number(cells[each.column], style.decimal_comma);
      if (value) each.course.add(cells[each.column], *value, line->after_blank);
    }
  }
}

void drop_by_headings(Candidates& all, const Fields& headings) {
  const auto means = [&](Column column) {
    return [&headings, column](const Candidate& each) {
      return each.column < headings.size() && column_of(headings[each.column]) == column;
    };
  };
  drop(all, "{column} numbers the points", means(Column::number));
  drop(all, "{column} has the heights", means(Column::height));
}

// Drops a first column of rising whole numbers if the others have decimals.
void drop_gapped_numbers(Candidates& all) {
  const auto left = left_of(all);
  const bool others_have_decimals = std::all_of(
      left.begin() + 1, left.end(), [&](std::size_t i) { return all[i].course.has_decimals(); });
  if (others_have_decimals)
    drop(all, "{column} numbers the points", [&](const Candidate& each) {
      return each.column == all[left[0]].column && each.course.rises_in_whole_numbers();
    });
}

// "column 2", or its heading.
std::string label(std::size_t column, const Fields& headings) {
  if (column < headings.size() && !headings[column].empty())
    return in_quotes(clean_name(headings[column]));
  return say("column {number}", {column + 1});
}

std::string note_of(const Candidates& all, const Candidate& x, const Candidate& y,
                    const Fields& headings) {
  std::string reasons;
  for (const Candidate& each : all) {
    if (!each.reason || each.column >= y.column) continue;
    const std::string reason = say(each.reason, {label(each.column, headings)});
    reasons = reasons.empty() ? reason : say("{first} and {last}", {reasons, reason});
  }
  if (reasons.empty()) return "the first two columns with numbers were taken as x and y";
  return say(
      "{x} was taken as x and {y} as y, since {reasons}; headings such as No, N, E, Z say otherwise",
      {label(x.column, headings), label(y.column, headings), reasons});
}

}  // namespace

std::vector<std::size_t> number_columns(const Fields& cells, const CellStyle& style) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cell_number(cells[i], style.decimal_comma)) columns.push_back(i);
  return columns;
}

bool has_only_digits(const Fields& cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return cell.empty() ||
           (cell.find_first_not_of("0123456789+-.,eE \t") == std::string_view::npos &&
            std::any_of(cell.begin(), cell.end(), is_digit));
  });
}

namespace {

// Where commas separate cells, a comma in a cell is in quotes, and may separate thousands if three
// digits follow. Otherwise it precedes decimals.
bool has_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  return comma != std::string_view::npos && cell.size() - comma - 1 != 3 &&
         cell_number(cell, true).has_value();
}

// Such as "1,5","2,25".
bool has_quoted_decimals(std::string_view text) {
  Lines lines(text);
  auto line = lines.next();
  for (std::size_t i = 0; line && i < first_lines; line = lines.next(), ++i) {
    const Fields cells = split_cells(line->text, ',');
    if (std::any_of(cells.begin(), cells.end(), has_decimal_comma)) return true;
  }
  return false;
}

CellStyle style_of_first_row(std::string_view text) {
  std::optional<CellStyle> with_numbers, with_digit;
  Lines lines(text);
  auto line = lines.next();
  for (std::size_t i = 0; line && i < first_lines; line = lines.next(), ++i) {
    if (std::none_of(line->text.begin(), line->text.end(), is_digit)) continue;
    const CellStyle style = style_of_line(line->text);
    if (!with_digit) with_digit = style;
    const Fields cells = split_cells(line->text, style.separator);
    const bool is_row =
        cells.size() > 1 && (number_columns(cells, style).size() > 1 || has_only_digits(cells));
    if (!is_row) continue;
    if (!with_numbers) with_numbers = style;
    if (has_number_first(line->text)) return style;
  }
  return with_numbers ? *with_numbers : with_digit.value_or(CellStyle{});
}

}  // namespace

CellStyle style_of_table(std::string_view text) {
  CellStyle style = style_of_first_row(text);
  if (style.separator == ',') style.decimal_comma = has_quoted_decimals(text);
  return style;
}

bool has_words_or_counts(std::string_view rows, const CellStyle& style, std::size_t column) {
  constexpr double most = 9999;
  Lines lines(rows);
  for (auto line = lines.next(); line; line = lines.next()) {
    const Fields cells = split_cells(line->text, style.separator);
    if (column >= cells.size()) continue;
    const auto number = cell_number(cells[column], style.decimal_comma);
    if (number && !(*number >= 0 && *number <= most && *number == std::floor(*number)))
      return false;
  }
  return true;
}

std::vector<std::size_t> columns_of_shapes(std::string_view rows, const CellStyle& style,
                                           const std::vector<std::size_t>& columns) {
  constexpr std::size_t shortest_run = 3;
  struct Runs {
    std::string_view last;
    std::size_t length = 0, count = 0;
    bool long_enough = true;
  };
  std::vector<Runs> all(columns.size());
  Lines lines(rows);
  for (auto line = lines.next(); line; line = lines.next()) {
    const Fields cells = split_cells(line->text, style.separator);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      Runs& runs = all[i];
      const std::string_view cell = columns[i] < cells.size() ? cells[columns[i]] : "";
      if (runs.length > 0 && cell == runs.last) {
        ++runs.length;
        continue;
      }
      runs.long_enough = runs.long_enough && (runs.count == 0 || runs.length >= shortest_run);
      runs.last = cell;
      runs.length = 1;
      ++runs.count;
    }
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (all[i].count >= 2 && all[i].long_enough && all[i].length >= shortest_run)
      found.push_back(columns[i]);
  return found;
}

ChosenColumns choose_columns(std::string_view rows, const CellStyle& style, const Fields& first_row,
                             const Fields& headings) {
  Candidates all;
  for (const std::size_t column : number_columns(first_row, style)) all.push_back({column, {}, {}});
  if (all.size() == 2) return {all[0].column, all[1].column, {}, ""};
  follow(all, rows, style);
  const auto shapes = columns_of_shapes(rows, style, {all[0].column});
  drop(all, "{column} numbers the shapes",
       [&](const Candidate& each) { return !shapes.empty() && each.column == shapes[0]; });
  drop_by_headings(all, headings);
  drop(all, "{column} is the same in every line",
       [](const Candidate& each) { return each.course.stays_the_same(); });
  drop(all, "{column} numbers the points",
       [](const Candidate& each) { return each.course.counts(); });
  drop_gapped_numbers(all);
  const auto left = left_of(all);
  const Candidate &x = all[left[0]], &y = all[left[1]];
  return {x.column, y.column, shapes, note_of(all, x, y, headings)};
}

}  // namespace evenlift
