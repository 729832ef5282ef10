#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "document/setting_values.h"
#include "evenlift/formats.h"
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

struct NumberColumn {
  std::size_t column = 0;
  Course course;
  const char* reason = nullptr;  // why it is not a coordinate: a clause with a place for its label
};

using NumberColumns = std::vector<NumberColumn>;

std::vector<std::size_t> left_of(const NumberColumns& all) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].reason) left.push_back(i);
  return left;
}

template <class Test>
void drop(NumberColumns& all, const char* reason, const Test& test) {
  std::size_t left = left_of(all).size();
  for (NumberColumn& each : all) {
    if (left <= 2) return;
    if (each.reason || !test(each)) continue;
    each.reason = reason;
    --left;
  }
}

void follow(NumberColumns& all, std::string_view rows, const CellStyle& style) {
  Lines lines(rows);
  for (auto line = lines.next(); line; line = lines.next()) {
    const Fields cells = split_cells(line->text, style.separator);
    for (NumberColumn& each : all) {
      if (each.column >= cells.size()) continue;
      const auto value = cell_number(cells[each.column], style.decimal_comma);
      if (value) each.course.add(cells[each.column], *value, line->after_blank);
    }
  }
}

void drop_by_headings(NumberColumns& all, const Fields& headings) {
  const auto means = [&](Column column) {
    return [&headings, column](const NumberColumn& each) {
      return each.column < headings.size() && column_of(headings[each.column]) == column;
    };
  };
  drop(all, "{column} numbers the points", means(Column::number));
  drop(all, "{column} has the heights", means(Column::height));
}

// Drops a first column of rising whole numbers if the others have decimals.
void drop_gapped_numbers(NumberColumns& all) {
  const auto left = left_of(all);
  const bool others_have_decimals = std::all_of(
      left.begin() + 1, left.end(), [&](std::size_t i) { return all[i].course.has_decimals(); });
  if (others_have_decimals)
    drop(all, "{column} numbers the points", [&](const NumberColumn& each) {
      return each.column == all[left[0]].column && each.course.rises_in_whole_numbers();
    });
}

// "column 2", or its heading.
std::string label(std::size_t column, const Fields& headings) {
  if (column < headings.size() && !headings[column].empty())
    return in_quotes(clean_name(headings[column]));
  return say("column {number}", {column + 1});
}

std::string note_of(const NumberColumns& all, const NumberColumn& x, const NumberColumn& y,
                    const Fields& headings) {
  std::vector<std::string> reasons;
  for (const NumberColumn& each : all)
    if (each.reason && each.column < y.column)
      reasons.push_back(say(each.reason, {label(each.column, headings)}));
  if (reasons.empty()) return "the first two columns with numbers were taken as x and y";
  return say(
      "{x} was taken as x and {y} as y, since {reasons}; headings such as No, N, E, Z say otherwise",
      {label(x.column, headings), label(y.column, headings), listed(reasons)});
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

namespace {

constexpr std::size_t shortest_run = 3;
constexpr std::size_t most_columns = 64;  // that are looked at

// The runs of equal cells in a column.
struct Runs {
  std::string_view last;
  std::size_t length = 0, count = 0, singles = 0, longs = 0;  // runs of one row, and of enough
  std::set<std::string_view> values;
  // The columns in which a run began wherever one began here, as bits.
  std::uint64_t begun = ~std::uint64_t{0};

  void end() {
    singles += length == 1;
    longs += length >= shortest_run;
  }
  // Returns whether a run begins.
  bool take(std::string_view cell) {
    if (length > 0 && cell == last) return ++length, false;
    end();
    last = cell;
    length = 1;
    if (++count <= max_shapes) values.insert(cell);
    return true;
  }
  bool separates() const { return longs >= 2 && longs == count; }
  // Whether it names the parts of the other's runs, or single points.
  bool separates_within(const Runs& other) const {
    return longs >= 2 && longs + singles == count && values.size() == count && count > other.count;
  }
};

}  // namespace

std::vector<std::size_t> columns_of_shapes(std::string_view rows, const CellStyle& style,
                                           const std::vector<std::size_t>& columns) {
  std::vector<Runs> all(std::min(columns.size(), most_columns));
  Lines lines(rows);
  for (auto line = lines.next(); line; line = lines.next()) {
    const Fields cells = split_cells(line->text, style.separator);
    std::uint64_t begun = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].take(columns[i] < cells.size() ? cells[columns[i]] : ""))
        begun |= std::uint64_t{1} << i;
    for (std::size_t i = 0; i < all.size(); ++i)
      if ((begun >> i & 1) != 0) all[i].begun &= begun;
  }
  for (Runs& runs : all) runs.end();
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].separates()) found.push_back(columns[i]);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::any_of(all.begin(), all.end(), [&](const Runs& other) {
          return other.separates() && (other.begun >> i & 1) != 0 && all[i].separates_within(other);
        }))
      found.insert(found.begin(), columns[i]);
  return found;
}

ChosenColumns choose_columns(std::string_view rows, const CellStyle& style, const Fields& first_row,
                             const Fields& headings) {
  NumberColumns all;
  for (const std::size_t column : number_columns(first_row, style)) all.push_back({column, {}, {}});
  if (all.size() == 2) return {all[0].column, all[1].column, {}, ""};
  follow(all, rows, style);
  const auto shapes = columns_of_shapes(rows, style, {all[0].column});
  drop(all, "{column} numbers the shapes",
       [&](const NumberColumn& each) { return !shapes.empty() && each.column == shapes[0]; });
  drop_by_headings(all, headings);
  drop(all, "{column} is the same in every line",
       [](const NumberColumn& each) { return each.course.stays_the_same(); });
  drop(all, "{column} numbers the points",
       [](const NumberColumn& each) { return each.course.counts(); });
  drop_gapped_numbers(all);
  const auto left = left_of(all);
  const NumberColumn &x = all[left[0]], &y = all[left[1]];
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

  struct Support {
    Vec2 at;
    std::optional<Vec2> contact;
    std::optional<double> capacity;
    std::string name = {};
  };

  // `line` is counted from 1; 0 where lines say nothing, as in JSON.
  Problem add(const Support& support, std::size_t offset, std::size_t line = 0) {
    if (supports_.places.size() == most_supports)
      return error(offset, "there are more than 1000 robots");
    if (support.capacity && !is_in_range(Setting::capacity, *support.capacity))
      return error(offset, requirement(Setting::capacity));
    supports_.places.push_back(support.at);
    supports_.contacts.push_back(support.contact.value_or(support.at));
    has_contacts_ = has_contacts_ || support.contact;
    supports_.capacities.push_back(support.capacity);
    supports_.names.push_back(name_of(support.name));
    if (line > 0) supports_.lines.push_back(line);
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

  void note(std::string sentence) { supports_.notes.push_back(std::move(sentence)); }

  InputError error(std::size_t offset, std::string message) const {
    return text_error(ErrorCode::bad_syntax, std::move(message), text_, offset);
  }

  // `is_own` marks a file that evenlift wrote.
  Result<SupportFile> finish(LengthUnit unit, bool is_own) {
    if (supports_.places.empty()) return error(0, "there are no robots here");
    const auto& all = supports_.capacities;
    if (std::none_of(all.begin(), all.end(), [](const auto& each) { return each.has_value(); }))
      supports_.capacities.clear();
    const auto& names = supports_.names;
    if (std::all_of(names.begin(), names.end(), [](const auto& each) { return each.empty(); }) ||
        are_counts(names))
      supports_.names.clear();
    if (!has_contacts_) supports_.contacts.clear();
    supports_.unit = unit;
    supports_.is_own = is_own;
    return supports_;
  }

 private:
  // A label of a file that is no name is made one, since the file has more to say.
  static std::string name_of(std::string_view label) {
    std::string name = clean_name(label);
    while (fault_of_name(name)) name.pop_back();
    return std::string(trimmed(name));
  }

  // 1, 2, 3 ...
  static bool are_counts(const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] != std::to_string(i + 1)) return false;
    return true;
  }

  std::string_view text_;
  SupportFile supports_;
  bool has_contacts_ = false;
};

// --- JSON: a result (robots[].at), poses (robots[].x, y) or an array of points

class JsonSupports {
 public:
  JsonSupports(std::string_view text, const JsonTree& tree) : tree_(tree), gathered_(text) {}

  Result<SupportFile> read() {
    std::optional<Index> list = tree_.root();
    LengthUnit unit = LengthUnit::none;
    const bool is_own = tree_.kind(*list) == Kind::object;
    if (is_own) {
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
      if (auto wrong =
              gathered_.add({*at, contact(i), capacity(i), std::string(name(i))}, tree_.offset(i)))
        return *wrong;
    }
    return gathered_.finish(unit, is_own);
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

  std::string_view name(Index at) const {
    const auto named =
        tree_.kind(at) == Kind::object ? tree_.member(at, "name") : std::optional<Index>();
    return named && tree_.kind(*named) == Kind::string ? tree_.text(*named) : std::string_view();
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

// The point {x: 0.5, y: 1.0} after the word.
std::optional<Vec2> point_after(std::string_view line, std::string_view word) {
  const std::size_t at = line.find(word);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + word.size());
  const auto x = number_after(line, "x:"), y = number_after(line, "y:");
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

// The rest of a line that begins with the words, after spaces and marks of a list or comment.
std::optional<std::string_view> after_words(std::string_view line, std::string_view mark,
                                            std::string_view words) {
  line = trimmed(line);
  if (!line.starts_with(mark)) return std::nullopt;
  line = trimmed(line.substr(mark.size()));
  if (!line.starts_with(words)) return std::nullopt;
  return line.substr(words.size());
}

std::optional<std::string_view> position_in(std::string_view line) {
  const auto in_list = after_words(line, "-", "position:");
  return in_list ? in_list : after_words(line, "", "position:");
}

bool has_poses(std::string_view text) {
  Lines lines(text);
  for (auto line = lines.next(); line; line = lines.next())
    if (position_in(line->text)) return true;
  return false;
}

// Comments before a pose tell the robot's name, and where one with a body lifts and touches
// (formats.h).
Result<SupportFile> read_poses(std::string_view text) {
  Gathered gathered(text);
  Lines lines(text, Comments::returned);
  Gathered::Support next;
  std::optional<Vec2> lifts;
  for (auto line = lines.next(); line; line = lines.next()) {
    if (const auto named = after_words(line->text, "#", poses_name))
      if (const Result<JsonTree> name = JsonTree::read(*named);
          name && name->kind(name->root()) == JsonTree::Kind::string)
        next.name = std::string(name->text(name->root()));
    if (const auto points = after_words(line->text, "#", poses_lift)) {
      lifts = point_after(*points, "");
      next.contact = point_after(*points, poses_touch);
    }
    const auto position = position_in(line->text);
    if (!position) continue;
    const auto offset = static_cast<std::size_t>(line->text.data() - text.data());
    const auto at = point_after(*position, "");
    if (!at) return gathered.error(offset, "expected a position {x: 0.5, y: 1.0, z: 0.0}");
    next.at = lifts.value_or(*at);
    if (auto wrong = gathered.add(next, offset, line->number)) return *wrong;
    next = {};
    lifts.reset();
  }
  return gathered.finish(LengthUnit::m, true);
}

// --- A table with a heading

using Cell = std::optional<std::size_t>;  // the column's number

struct Columns {
  Cell x, y, contact_x, contact_y, name, capacity, unit, reading, weight_unit;
  bool is_in_feet = false;
};

// The columns by what their headings mean. Of several loads, capacities or names the first counts; loads
// and capacities are numbers in the first row. Notes which columns are left out.
Columns columns_of(const Fields& headings, const Fields& first_row, const CellStyle& style,
                   Gathered& gathered) {
  Columns columns;
  for (std::size_t i = headings.size(); i-- > 0;) {
    if (names_column(headings[i], 'x')) columns.x = i;
    if (names_column(headings[i], 'y')) columns.y = i;
  }
  // "Easting" and "Northing", "Position X" and the like, as for outlines.
  const auto named = named_columns(headings);
  if (named && !(columns.x && columns.y)) {
    columns.x = named->x;
    columns.y = named->y;
  }
  columns.is_in_feet = named && named->is_in_feet;
  // In evenlift's own tables of poses; those without a place say nothing more here.
  const std::pair<std::string_view, Cell*> own[] = {{"unit", &columns.unit},
                                                    {"weight_unit", &columns.weight_unit},
                                                    {"contact_x", &columns.contact_x},
                                                    {"contact_y", &columns.contact_y},
                                                    {"at_x", &columns.x},
                                                    {"at_y", &columns.y},
                                                    {"x", nullptr},
                                                    {"y", nullptr},
                                                    {"team", nullptr},
                                                    {"heading_deg", nullptr}};
  const auto may_be_amount = [&](std::size_t i) {
    return i >= first_row.size() || first_row[i].empty() ||
           cell_number(first_row[i], style.decimal_comma).has_value();
  };
  const auto leave_out = [&](std::size_t i) {
    gathered.note(say("the column {name} was left out", {in_quotes(clean_name(headings[i]))}));
  };
  Cell support, number;
  const auto cell_for = [&](std::size_t i) -> Cell* {
    switch (content_of(headings[i])) {
      case Column::name:
        return &columns.name;
      case Column::support:
        return &support;
      case Column::capacity:
        return may_be_amount(i) ? &columns.capacity : nullptr;
      case Column::load:
        return may_be_amount(i) ? &columns.reading : nullptr;
      default:
        return nullptr;
    }
  };
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto found = std::find_if(std::begin(own), std::end(own), [&](const auto& each) {
      return same_word(headings[i], each.first);
    });
    if (found != std::end(own)) {
      if (found->second) *found->second = i;
      continue;
    }
    if (i == columns.x || i == columns.y || headings[i].empty()) continue;
    const bool numbers = column_of(headings[i]) == Column::number;
    Cell* cell = cell_for(i);
    if (!cell && numbers) cell = &number;
    if (cell && !*cell)
      *cell = i;
    else if (!numbers)
      leave_out(i);
  }
  // The robots of poses have both.
  if (columns.name && support && !same_word(headings[*support], "robot")) leave_out(*support);
  if (!columns.name) columns.name = support ? support : number;
  return columns;
}

class SupportTable {
 public:
  explicit SupportTable(std::string_view text) : text_(text), gathered_(text) {}

  Result<SupportFile> read() {
    Lines lines(text_);
    const auto heading = lines.next();
    if (heading) {
      style_ = style_of_line(heading->text);
      headings_ = split_cells(heading->text, style_.separator);
    }
    Lines ahead = lines;
    const auto first = ahead.next();
    columns_ = columns_of(headings_, first ? split_cells(first->text, style_.separator) : Fields{},
                          style_, gathered_);
    if (auto wrong = take_headings()) return *std::move(wrong);
    for (auto line = lines.next(); line; line = lines.next())
      if (auto wrong = take_row(*line)) return *std::move(wrong);
    gathered_.set_units(unit_of_capacities_, unit_of_readings_);
    return gathered_.finish(unit_, has_field(headings_, "heading_deg"));
  }

 private:
  static constexpr const char* unknown =
      "the unit of x and y is not known; it may be mm, cm, m, in or ft";
  static constexpr WordList other_units = "dm km yd yard yards mi mile miles"_words;

  Problem take_headings() {
    if (!columns_.x || !columns_.y)
      return gathered_.error(
          0, "the first line must name the columns x and y, and perhaps name and capacity");
    const std::string_view x = headings_[*columns_.x], y = headings_[*columns_.y];
    unit_ = columns_.is_in_feet ? LengthUnit::in : unit_of_column(x);
    if (!columns_.is_in_feet && (unit_ != unit_of_column(y) || is_in_feet(x) != is_in_feet(y)))
      return gathered_.error(0, "x and y are in different units");
    // Brackets may also say more, as in "x (right)" and "y (up)".
    const bool is_unknown =
        unit_ == LengthUnit::none && !in_brackets(x).empty() && in_brackets(x) == in_brackets(y);
    if (is_unknown) return gathered_.error(0, unknown);
    const auto unit_in = [&](const Cell& column) {
      return column ? weight_unit_in(headings_[*column]) : std::nullopt;
    };
    of_capacities_ = unit_of_capacities_ = unit_in(columns_.capacity);
    of_readings_ = unit_of_readings_ = unit_in(columns_.reading);
    if (of_capacities_ == 0.0)
      return gathered_.error(
          0, "the unit of the capacities is not known; it may be kg, t, N, kN or lb");
    if (of_readings_ == 0.0)
      gathered_.refuse_readings(
          0, "the unit of the readings is not known; it may be kg, t, N, kN or lb");
    return std::nullopt;
  }

  // As csv_cell() (numbers.h) writes a text: with quotation marks doubled, and perhaps an apostrophe before it.
  static std::string name_in(std::string_view cell) {
    std::string name;
    if (cell.size() > 1 && cell[0] == '\'' &&
        std::string_view("=+-@").find(cell[1]) != std::string_view::npos)
      cell.remove_prefix(1);
    for (std::size_t i = 0; i < cell.size(); ++i) {
      name += cell[i];
      if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') ++i;
    }
    return name;
  }

  // The word in brackets: "furlong" of "x (furlong)".
  static std::string_view in_brackets(std::string_view heading) {
    const std::size_t open = std::min(heading.find_first_of("(["), heading.size());
    heading.remove_prefix(open);
    if (!heading.empty()) heading.remove_prefix(1);
    heading = trimmed(heading.substr(0, heading.find_first_of(")]")));
    return std::all_of(heading.begin(), heading.end(), is_letter) ? heading : std::string_view();
  }

  std::string_view cell(const Fields& cells, const Cell& column) const {
    return column && *column < cells.size() ? cells[*column] : std::string_view();
  }

  std::optional<double> value(const Fields& cells, const Cell& column) const {
    const std::string_view text = cell(cells, column);
    return text.empty() ? std::nullopt : cell_number(text, style_.decimal_comma);
  }

  std::optional<Vec2> point(const Fields& cells, const Cell& across, const Cell& up) const {
    const auto x = value(cells, across), y = value(cells, up);
    if (!x || !y) return std::nullopt;
    const Vec2 at(*x, *y);
    return columns_.is_in_feet || in_feet_ ? inches_of_a_foot * at : at;
  }

  Problem take_row(const Line& line) {
    const Fields cells = split_cells(line.text, style_.separator);
    const auto offset = static_cast<std::size_t>(line.text.data() - text_.data());
    if (cells.size() > headings_.size())
      return gathered_.error(offset,
                             "the line has more cells than the first line; decimals with a "
                             "comma need a semicolon between the columns");
    if (auto wrong = take_units(cells, offset)) return wrong;
    begun_ = true;
    const auto at = point(cells, columns_.x, columns_.y);
    if (!at) return gathered_.error(offset, "the line needs a number for x and for y");
    const auto capacity = value(cells, columns_.capacity);
    if (!capacity && !cell(cells, columns_.capacity).empty())
      return gathered_.error(offset, "the capacity is not a number");
    const auto contact = point(cells, columns_.contact_x, columns_.contact_y);
    if (auto wrong = gathered_.add({*at, contact, capacity, name_in(cell(cells, columns_.name))},
                                   offset, line.number))
      return wrong;
    if (const auto reading = value(cells, columns_.reading); reading && *reading >= 0)
      gathered_.add_reading(*reading);
    else if (columns_.reading)
      gathered_.refuse_readings(
          offset, reading ? "the reading is negative" : "the line has no number for the reading");
    return std::nullopt;
  }

  // evenlift's own poses have a column of units; in other tables it may mean something else. A line
  // without a unit is in that of the line before.
  Problem take_units(const Fields& cells, std::size_t offset) {
    const auto weight = weight_unit_in("(" + std::string(cell(cells, columns_.weight_unit)) + ")");
    if (weight && *weight > 0) {
      if (!of_capacities_) unit_of_capacities_ = weight;
      if (!of_readings_) unit_of_readings_ = weight;
    }
    const std::string_view unit = cell(cells, columns_.unit);
    const bool in_feet = is_in_feet(unit);
    const LengthUnit own = in_feet ? LengthUnit::in : unit_in(unit);
    if (own == LengthUnit::none && other_units.has(unit)) return gathered_.error(offset, unknown);
    if (own == LengthUnit::none) return std::nullopt;
    const bool differs = unit_ == LengthUnit::none ? in_feet && begun_ : own != unit_;
    if (differs) return gathered_.error(offset, "the robots are in different units");
    unit_ = own;
    in_feet_ = in_feet;
    return std::nullopt;
  }

  std::string_view text_;
  Gathered gathered_;
  CellStyle style_;
  Fields headings_;
  Columns columns_;
  LengthUnit unit_ = LengthUnit::none;
  bool in_feet_ = false, begun_ = false;  // by the column of units; whether there was a line
  std::optional<double> of_capacities_, of_readings_;  // as the headings state them
  std::optional<double> unit_of_capacities_, unit_of_readings_;
};

}  // namespace

Result<SupportFile> read_support_file(std::string_view text) {
  if (text.size() > max_text_bytes)
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB"};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && (text[first] == '{' || text[first] == '[')) {
    const Result<JsonTree> tree = JsonTree::read(text);
    if (!tree) return tree.error();
    return JsonSupports(text, *tree).read();
  }
  return has_poses(text) ? read_poses(text) : SupportTable(text).read();
}

}  // namespace evenlift
