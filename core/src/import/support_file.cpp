// Robots' places from a file: a table, a result, or robot poses.
#include <algorithm>
#include <string>

#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "import/tables/cells.h"
#include "numbers/json_tree.h"
#include "numbers/text_cursor.h"

namespace evenlift {
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
  std::optional<std::size_t> x, y, capacity, unit;
};

// "capacity", "Rated capacity (kg)", "Cap.", "SWL", "max. load".
bool names_capacity(std::string_view heading) {
  std::string letters;
  for (const char c : heading.substr(0, heading.find_first_of("([")))
    if (is_letter(c)) letters += lower_case(c);
  return letters.find("capacity") != std::string::npos || letters == "cap" || letters == "swl" ||
         letters == "wll" || letters == "maxload" || letters == "maximumload";
}

Columns columns_of(const Fields& heading) {
  Columns columns;
  for (std::size_t i = heading.size(); i-- > 0;) {
    if (names_column(heading[i], 'x')) columns.x = i;
    if (names_column(heading[i], 'y')) columns.y = i;
    if (names_capacity(heading[i])) columns.capacity = i;
    if (same_word(heading[i], "unit")) columns.unit = i;
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
    if (columns.unit && *columns.unit < cells.size()) {
      // evenlift's own poses have this column; in other tables it may mean something else.
      const LengthUnit own = unit_named(cells[*columns.unit]).value_or(LengthUnit::none);
      if (own != LengthUnit::none && unit != LengthUnit::none && own != unit)
        return gathered.error(offset, "the robots are in different units");
      if (own != LengthUnit::none) unit = own;
    }
    if (auto wrong = gathered.add(Vec2(*x, *y), capacity, offset)) return *wrong;
  }
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
