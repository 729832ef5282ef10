#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "import/gathering.h"
#include "import/table_columns.h"
#include "import/tables/table_headings.h"
#include "numbers/json_tree.h"
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

// --- Robots' places from a file: a table, a result, or robot poses.

namespace {

using Kind = JsonTree::Kind;
using Index = JsonTree::Index;
using Problem = std::optional<InputError>;

// Such as "mm"; nullopt for other words.
std::optional<LengthUnit> unit_named(std::string_view word) {
  for (const LengthUnit unit : all_length_units)
    if (same_word(word, name(unit))) return unit;
  return std::nullopt;
}

// Gathers supports within common limits.
class Gathered {
 public:
  explicit Gathered(std::string_view text) : text_(text) {}

  Problem add(const Vec2& at, const std::optional<double>& capacity, std::size_t offset) {
    if (supports_.places.size() == most_supports)
      return error(offset, "there are more than 1000 robots");
    if (capacity && !is_in_range(Setting::capacity, *capacity))
      return error(offset, requirement(Setting::capacity));
    supports_.places.push_back(at);
    supports_.capacities.push_back(capacity);
    return std::nullopt;
  }

  void add_reading(double reading) { supports_.readings.push_back(reading); }
  void refuse_readings(std::size_t offset, std::string message) {
    if (!supports_.wrong_reading) supports_.wrong_reading = error(offset, std::move(message));
  }
  void set_units(std::optional<double> of_capacities, std::optional<double> of_readings) {
    supports_.capacity_unit = of_capacities;
    supports_.reading_unit = of_readings;
  }

  void add_contact(const Vec2& contact) { supports_.contacts.push_back(contact); }

  InputError error(std::size_t offset, std::string message) const {
    return text_error(ErrorCode::bad_syntax, std::move(message), text_, offset);
  }

  Result<SupportFile> finish(LengthUnit unit = LengthUnit::none) {
    if (supports_.places.empty()) return error(0, "there are no robots here");
    const auto& all = supports_.capacities;
    if (std::none_of(all.begin(), all.end(), [](const auto& each) { return each.has_value(); }))
      supports_.capacities.clear();
    supports_.unit = unit;
    return supports_;
  }

 private:
  std::string_view text_;
  SupportFile supports_;
};

// --- JSON: a result (robots[].at), poses (robots[].x, y) or an array of points

class JsonSupports {
 public:
  JsonSupports(std::string_view text, const JsonTree& tree) : tree_(tree), gathered_(text) {}

  Result<SupportFile> read() {
    std::optional<Index> list = tree_.root();
    LengthUnit unit = LengthUnit::none;
    if (tree_.kind(*list) == Kind::object) {
      if (tree_.is_string(tree_.member(0, "origin"), "com"))
        return gathered_.error(tree_.offset(0),
                               "these poses are relative to the centre of mass; "
                               "save them with the origin of the file");
      if (const auto named = tree_.member(0, "unit"); named && tree_.kind(*named) == Kind::string) {
        const auto known = unit_named(tree_.text(*named));
        if (!known) return gathered_.error(tree_.offset(*named), requirement(Setting::unit));
        unit = *known;
      }
      list = tree_.member(0, "robots");
    }
    if (!list || tree_.kind(*list) != Kind::array)
      return gathered_.error(tree_.offset(0), "expected an array of points, or \"robots\"");
    for (Index i = tree_.first(*list); i != tree_.end(*list); i = tree_.next(i)) {
      const std::optional<Vec2> at = point(i);
      if (!at) return gathered_.error(tree_.offset(i), "expected a point [x, y] of two numbers");
      gathered_.add_contact(contact(i).value_or(*at));
      if (auto wrong = gathered_.add(*at, capacity(i), tree_.offset(i))) return *wrong;
    }
    return gathered_.finish(unit);
  }

 private:
  std::optional<double> number(std::optional<Index> at) const {
    if (!at || tree_.kind(*at) != Kind::number) return std::nullopt;
    return tree_.number(*at);
  }

  std::optional<Vec2> point(Index at) const {
    std::optional<double> x, y;
    if (tree_.kind(at) == Kind::object) {
      if (const auto place = tree_.member(at, "at")) return point(*place);
      x = number(tree_.member(at, "x"));
      y = number(tree_.member(at, "y"));
    } else if (tree_.kind(at) == Kind::array) {
      std::size_t count = 0;
      for (Index i = tree_.first(at); i != tree_.end(at); i = tree_.next(i), ++count)
        (count == 0 ? x : y) = number(i);
      if (count != 2) return std::nullopt;
    }
    if (!x || !y) return std::nullopt;
    return Vec2(*x, *y);
  }

  // Only robots at the edge have a contact.
  std::optional<Vec2> contact(Index at) const {
    if (tree_.kind(at) != Kind::object) return std::nullopt;
    const auto touches = tree_.member(at, "contact");
    return touches ? point(*touches) : std::nullopt;
  }

  std::optional<double> capacity(Index at) const {
    return tree_.kind(at) == Kind::object ? number(tree_.member(at, "capacity")) : std::nullopt;
  }

  const JsonTree& tree_;
  Gathered gathered_;
};

// --- YAML: evenlift's PoseArray for ROS 2, in metres

std::optional<double> number_after(std::string_view line, std::string_view name) {
  const std::size_t at = line.find(name);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + name.size());
  return read_number(trimmed(line.substr(0, line.find_first_of(",}"))));
}

Result<SupportFile> read_poses(std::string_view text) {
  Gathered gathered(text);
  Lines lines(text);
  for (auto line = lines.next(); line; line = lines.next()) {
    if (line->text.find("position:") == std::string_view::npos) continue;
    const auto offset = static_cast<std::size_t>(line->text.data() - text.data());
    const auto x = number_after(line->text, "x:"), y = number_after(line->text, "y:");
    if (!x || !y) return gathered.error(offset, "expected a position {x: 0.5, y: 1.0, z: 0.0}");
    if (auto wrong = gathered.add(Vec2(*x, *y), std::nullopt, offset)) return *wrong;
  }
  return gathered.finish(LengthUnit::m);
}

// --- A table with a heading

struct Columns {
  std::optional<std::size_t> x, y, capacity, unit, reading, weight_unit;
};

std::string letters_of(std::string_view heading) {
  std::string letters;
  for (const char c : heading.substr(0, heading.find_first_of("([")))
    if (is_letter(c)) letters += lower_case(c);
  return letters;
}

// The kilograms in the unit that a heading states in brackets, or as its only word: "load (kN)".
// Nothing without a unit; 0 for an unknown one.
std::optional<double> weight_unit_of(std::string_view heading) {
  const std::size_t open = heading.find_first_of("([");
  std::string_view unit = open == std::string_view::npos ? heading : heading.substr(open + 1);
  if (open == std::string_view::npos) unit = unit.substr(unit.rfind(' ') + 1);  // the last word
  unit = trimmed(unit.substr(0, unit.find_first_of(")]")));
  const double newton = in_kilograms(1, WeightUnit::N), pound = in_kilograms(1, WeightUnit::lb);
  const std::pair<std::string_view, double> known[] = {
      {"kg", 1},     {"kgf", 1},           {"g", 0.001},         {"t", 1000},
      {"to", 1000},  {"lb", pound},        {"lbs", pound},       {"lbf", pound},
      {"n", newton}, {"dan", 10 * newton}, {"kn", 1000 * newton}};
  for (const auto& [name, kilograms] : known)
    if (same_word(unit, name)) return kilograms;
  return open == std::string_view::npos ? std::nullopt : std::optional(0.0);
}

// "capacity", "Rated capacity (kg)", "Cap.", "SWL", "max. load".
bool names_capacity(std::string_view heading) {
  const std::string letters = letters_of(heading);
  return letters.find("capacity") != std::string::npos || letters == "cap" || letters == "swl" ||
         letters == "wll" || letters == "maxload" || letters == "maximumload";
}

// "reading", "Load (kg)", "weight", "kg".
bool names_reading(std::string_view heading) {
  static constexpr std::string_view readings[] = {
      "reading", "readings", "reads", "scale",   "load",     "loads", "weight",  "kg",
      "lb",      "n",        "kn",    "anzeige", "ablesung", "last",  "gewicht", "messwert",
      "lecture", "charge",   "poids", "lectura", "carga",    "peso"};
  const std::size_t space = heading.find(' ');
  const bool has_unit = space != std::string_view::npos &&
                        weight_unit_of(heading.substr(space + 1)).value_or(0) > 0;  // "reading kN"
  const std::string letters = letters_of(has_unit ? heading.substr(0, space) : heading);
  return std::find(std::begin(readings), std::end(readings), letters) != std::end(readings);
}

Columns columns_of(const Fields& heading) {
  Columns columns;
  for (std::size_t i = heading.size(); i-- > 0;) {
    if (names_column(heading[i], 'x')) columns.x = i;
    if (names_column(heading[i], 'y')) columns.y = i;
    if (names_capacity(heading[i])) columns.capacity = i;
    if (same_word(heading[i], "unit")) columns.unit = i;
    if (names_reading(heading[i])) columns.reading = i;
    if (same_word(heading[i], "weight_unit")) columns.weight_unit = i;
  }
  // "Easting" and "Northing", "Position X" and the like, as for outlines.
  if (const auto named = named_columns(heading); named && !(columns.x && columns.y)) {
    columns.x = named->x;
    columns.y = named->y;
  }
  return columns;
}

Result<SupportFile> read_table(std::string_view text) {
  Gathered gathered(text);
  Lines lines(text);
  const auto heading = lines.next();
  const char separator = heading ? separator_of(heading->text) : ' ';
  const bool decimal_comma = separator != ',' && separator != ' ';
  const Fields headings = heading ? split_cells(heading->text, separator) : Fields{};
  const Columns columns = columns_of(headings);
  if (!columns.x || !columns.y)
    return gathered.error(0, "the first line must name the columns x and y, and perhaps capacity");
  LengthUnit unit = unit_of_column(headings[*columns.x]);
  if (unit != unit_of_column(headings[*columns.y]))
    return gathered.error(0, "x and y are in different units");
  const auto unit_in = [&](const std::optional<std::size_t>& column) {
    return column ? weight_unit_of(headings[*column]) : std::nullopt;
  };
  const auto of_capacities = unit_in(columns.capacity), of_readings = unit_in(columns.reading);
  if (of_capacities == 0.0)
    return gathered.error(0,
                          "the unit of the capacities is not known; it may be kg, t, N, kN or lb");
  if (of_readings == 0.0)
    gathered.refuse_readings(0,
                             "the unit of the readings is not known; it may be kg, t, N, kN or lb");
  auto unit_of_weights = of_capacities, unit_of_readings = of_readings;
  for (auto line = lines.next(); line; line = lines.next()) {
    const Fields cells = split_cells(line->text, separator);
    const auto offset = static_cast<std::size_t>(line->text.data() - text.data());
    if (cells.size() > headings.size())
      return gathered.error(offset,
                            "the line has more cells than the first line; decimals with a "
                            "comma need a semicolon between the columns");
    const auto value = [&](const std::optional<std::size_t>& column) -> std::optional<double> {
      if (!column || *column >= cells.size()) return std::nullopt;
      return cell_number(cells[*column], decimal_comma);
    };
    const auto x = value(columns.x), y = value(columns.y), capacity = value(columns.capacity);
    if (!x || !y) return gathered.error(offset, "the line needs a number for x and for y");
    const bool has_cell =
        columns.capacity && *columns.capacity < cells.size() && !cells[*columns.capacity].empty();
    if (has_cell && !capacity) return gathered.error(offset, "the capacity is not a number");
    if (columns.weight_unit && *columns.weight_unit < cells.size()) {
      // As in evenlift's own poses.
      const auto own = weight_unit_of("(" + std::string(cells[*columns.weight_unit]) + ")");
      if (own && *own > 0) {
        if (!of_capacities) unit_of_weights = own;
        if (!of_readings) unit_of_readings = own;
      }
    }
    if (columns.unit && *columns.unit < cells.size()) {
      // evenlift's own poses have this column; in other tables it may mean something else.
      const LengthUnit own = unit_named(cells[*columns.unit]).value_or(LengthUnit::none);
      if (own != LengthUnit::none && unit != LengthUnit::none && own != unit)
        return gathered.error(offset, "the robots are in different units");
      if (own != LengthUnit::none) unit = own;
    }
    if (auto wrong = gathered.add(Vec2(*x, *y), capacity, offset)) return *wrong;
    if (const auto reading = value(columns.reading); reading && *reading >= 0)
      gathered.add_reading(*reading);
    else if (columns.reading)
      gathered.refuse_readings(
          offset, reading ? "the reading is negative" : "the line has no number for the reading");
  }
  gathered.set_units(unit_of_weights, unit_of_readings);
  return gathered.finish(unit);
}

}  // namespace

Result<SupportFile> read_support_file(std::string_view text) {
  if (text.size() > max_text_bytes)
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB", {}};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && (text[first] == '{' || text[first] == '[')) {
    const Result<JsonTree> tree = JsonTree::read(text);
    if (!tree) return tree.error();
    return JsonSupports(text, *tree).read();
  }
  return text.find("position:") != std::string_view::npos ? read_poses(text) : read_table(text);
}

}  // namespace evenlift
