#include "import/tables/cells.h"

#include <algorithm>
#include <string>

#include "evenlift/numbers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// No table of coordinates has more.
constexpr std::size_t most_fields = 1000;

std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

// A spreadsheet writes an empty row as separators alone.
std::string_view trimmed_of_commas(std::string_view line) {
  const bool nothing = line.find_first_not_of(" \t,;|") == std::string_view::npos;
  return nothing ? std::string_view() : line;
}

std::size_t end_of_quotes(std::string_view line, std::size_t at) {
  std::size_t end = line.find('"', at + 1);
  while (end != std::string_view::npos && end + 1 < line.size() && line[end + 1] == '"')
    end = line.find('"', end + 2);
  return end;
}

}  // namespace

std::optional<Line> Lines::next() {
  bool blank = false;
  while (at_ < text_.size()) {
    ++number_;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string_view line = trimmed_of_commas(text_.substr(at_, end - at_));
    at_ = end + 1;
    if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++at_;
    if (line.empty())
      blank = true;
    else if (line.front() != '#' || comments_ == Comments::returned)
      return Line{line, blank, number_};
  }
  return std::nullopt;
}

char separator_of(std::string_view line) {
  constexpr std::string_view separators = "\t;|,";
  std::size_t best = separators.size();
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted) best = std::min(best, separators.find(c));
  }
  return best < separators.size() ? separators[best] : ' ';
}

Fields split_cells(std::string_view line, char separator) {
  Fields fields;
  for (std::size_t at = 0; at <= line.size() && fields.size() < most_fields;) {
    if (separator == ' ') {
      at = std::min(line.find_first_not_of(" \t", at), line.size());
      if (at == line.size()) break;
    }
    const bool quoted = at < line.size() && line[at] == '"';
    const std::size_t quote = quoted ? end_of_quotes(line, at) : std::string_view::npos;
    const std::size_t from = quote == std::string_view::npos ? at : quote;
    const std::string_view separators =
        separator == ' ' ? std::string_view(" \t") : std::string_view(&separator, 1);
    const std::size_t end = std::min(line.find_first_of(separators, from), line.size());
    fields.push_back(unquoted(line.substr(at, end - at)));
    at = end + 1;
  }
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  return fields;
}

std::optional<double> cell_number(std::string_view field, bool decimal_comma) {
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos) return read_number(field);
  const bool one_mark = field.find_first_of(".,", comma + 1) == std::string_view::npos &&
                        field.find('.') == std::string_view::npos;
  if (!decimal_comma || !one_mark) return std::nullopt;
  std::string with_point(field);
  with_point[comma] = '.';
  return read_number(with_point);
}

bool names_column(std::string_view field, char name) {
  if (field.empty() || lower_case(field[0]) != name) return false;
  return field.size() == 1 || (!is_letter(field[1]) && static_cast<unsigned char>(field[1]) < 0x80);
}

bool has_field(const Fields& fields, std::string_view name) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](std::string_view field) { return same_word(field, name); });
}

LengthUnit unit_of_column(std::string_view field) {
  const auto is_mark = [](char c) { return !is_letter(c); };
  field.remove_prefix(1);
  while (!field.empty() && is_mark(field.front())) field.remove_prefix(1);
  while (!field.empty() && is_mark(field.back())) field.remove_suffix(1);
  for (const LengthUnit unit : all_length_units)
    if (unit != LengthUnit::none && same_word(field, name(unit))) return unit;
  return LengthUnit::none;
}

}  // namespace evenlift
