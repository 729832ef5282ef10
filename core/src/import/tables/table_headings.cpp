#include <algorithm>
#include <array>
#include <iterator>
#include <string>

#include "evenlift/numbers.h"
#include "import/tables/table_headings.h"
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

namespace {

using Words = std::vector<std::string>;

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

// Includes letters beyond ASCII and the degree sign of "n°".
bool is_part_of_word(char c) { return is_letter(c) || static_cast<unsigned char>(c) >= 0x80; }

// Whether a word begins at `i` without a separator: "PosX", "XCoord".
bool begins_inside(std::string_view text, std::size_t i) {
  if (i == 0 || !is_upper(text[i]) || !is_letter(text[i - 1])) return false;
  return !is_upper(text[i - 1]) ||
         (i + 1 < text.size() && is_letter(text[i + 1]) && !is_upper(text[i + 1]));
}

// Also lowers the capitals of Latin-1 in UTF-8.
void append_lower(std::string& word, char c) {
  const auto byte = static_cast<unsigned char>(c);
  const bool accented = !word.empty() && static_cast<unsigned char>(word.back()) == 0xc3 &&
                        byte >= 0x80 && byte <= 0x9e && byte != 0x97;
  word += accented ? static_cast<char>(byte + 0x20) : lower_case(c);
}

Words words_of(std::string_view heading) {
  Words words;
  bool inside = false;
  for (std::size_t i = 0; i < heading.size() && words.size() < 20; ++i) {
    const bool part = is_part_of_word(heading[i]);
    if (part && (!inside || begins_inside(heading, i))) words.emplace_back();
    if (part) append_lower(words.back(), heading[i]);
    inside = part;
  }
  return words;
}

bool any_among(const Words& words, WordList list) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return list.has(word); });
}

// --- The words

struct Meaning {
  Column column;
  WordList words;
};

constexpr Meaning meanings[] = {
    {Column::x, "x"_words},
    {Column::y, "y"_words},
    {Column::height,
     "z height elevation elev ele el altitude alt h höhe hoehe level rl cota quota"_words},
    {Column::easting,
     "easting eastings east ost ostwert rechtswert rechts rw est este oost abscissa abscisse"_words},
    {Column::northing,
     "northing northings north nord nordwert hochwert hoch hw norte noord ordinate ordonnee "
     "ordonnée"_words},
    {Column::longitude, "lon long lng longitude longitud längengrad laengengrad"_words},
    {Column::latitude, "lat latitude latitud breitengrad"_words},
    {Column::number,
     "objectid oid fid gid uid id no nr num n° nº number nummer numero numéro index idx seq "
     "sequence order count anzahl row line pnt pn p pkt punktnummer pointid pointno"_words},
    {Column::name, "name nom nome nombre label title bezeichnung designation nazwa naam"_words},
    {Column::support,
     "jack jacks support robot leg pad stand stütze stuetze auflager heber winde bein appui "
     "vérin verin apoyo gato appoggio"_words},
    {Column::capacity,
     "capacity capacities cap swl wll tragkraft traglast tragfähigkeit tragfaehigkeit kapazität "
     "capacité capacite cmu capacidad capacità portata"_words},
    {Column::load,
     "reading readings reads scale load loads weight weights anzeige ablesung last gewicht "
     "messwert lecture charge poids lectura carga peso carico"_words},
    {Column::size,
     "dia diam diameter diametre diamètre diámetro diametro durchmesser radius radio rayon "
     "drill"_words},
    {Column::thickness, "thickness dicke"_words},
};

// Before a word of loads they make a capacity: "max. load".
constexpr WordList greatest =
    "max maximum maximal maximale rated allowable zul working safe zulässige zulaessige maxima "
    "maximo máxima"_words;

// Words that do not change the meaning of the coordinate.
constexpr WordList beside =
    "coord coords coordinate coordinates coor koordinate koord pos position posn point points "
    "pt pts punkt vertex node corner value wert axis center centre start insertion location "
    "coordonnée coordonnee coordenada coordinata utm grid local world map geo gps wgs etrs dd "
    "decimal deg degree degrees in the"_words;

struct UnitWord {
  LengthUnit unit;
  WordList words;
};

constexpr UnitWord unit_words[] = {
    {LengthUnit::m, "meter meters metre metres"_words},
    {LengthUnit::mm, "millimeter millimeters millimetre millimetres"_words},
    {LengthUnit::cm, "centimeter centimeters centimetre centimetres"_words},
    {LengthUnit::in, "inch inches"_words},
    {LengthUnit::none, "m cm mm km ft feet foot usft px us survey"_words}};

bool is_unit_word(std::string_view word) {
  return std::any_of(std::begin(unit_words), std::end(unit_words),
                     [&](const UnitWord& unit) { return unit.words.has(word); });
}

bool is_beside(std::string_view word) { return beside.has(word) || is_unit_word(word); }

Column meaning_of(std::string_view word) {
  for (const Meaning& meaning : meanings)
    if (meaning.words.has(word)) return meaning.column;
  return Column::other;
}

bool means(const Words& words, Column column) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return meaning_of(word) == column; });
}

// "xcoord", "posx", "xmm": an axis with a word of `beside` or `unit_words`.
Column meaning_of_compound(std::string_view word) {
  if (word.size() < 3) return Column::other;
  const auto may_join = [](std::string_view rest) {
    return rest != "in" && rest != "the" && is_beside(rest);
  };
  const auto axis = [](char c) {
    return c == 'x' ? Column::x : c == 'y' ? Column::y : c == 'z' ? Column::height : Column::other;
  };
  if (may_join(word.substr(1))) return axis(word.front());
  if (may_join(word.substr(0, word.size() - 1))) return axis(word.back());
  return Column::other;
}

// A heading's meaning.
struct Reading {
  Column column = Column::other;
  int rank = 0;  // 0 for the plainest name
};

bool is_coordinate(Column column) { return column > Column::other && column < Column::number; }

// E and N, alone or with a unit: letters that only a pair of headings explains.
Column meaning_of_letter(const Words& words) {
  const bool with_unit = words.size() == 2 && is_unit_word(words[1]);
  if (words.size() != 1 && !with_unit) return Column::other;
  if (words[0] == "e") return Column::easting;
  if (words[0] == "n") return Column::northing;
  return Column::other;
}

Reading reading_of(std::string_view heading) {
  const Words words = words_of(heading);
  Reading reading;
  bool understood = true;
  std::size_t apart = 0, coordinates = 0;
  for (const std::string& word : words) {
    Column column = meaning_of(word);
    if (column == Column::other) column = meaning_of_compound(word);
    if (is_coordinate(column)) {
      reading.column = column;
      ++coordinates;
    } else if (is_beside(word)) {
      ++apart;
    } else {
      understood = false;
    }
  }
  if (understood && coordinates == 1) {
    reading.rank = apart == 0 ? 0 : 1;
    return reading;
  }
  // "x of the corner", "y [furlongs]".
  for (const char name : {'x', 'y', 'z'})
    if (names_column(heading, name))
      return {name == 'x' ? Column::x : name == 'y' ? Column::y : Column::height, 2};
  return {};
}

std::optional<std::size_t> best_column(const std::vector<Reading>& readings, Column wanted) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].column == wanted && (!best || readings[i].rank < readings[*best].rank))
      best = i;
  return best;
}

}  // namespace

bool is_in_feet(std::string_view heading) {
  const Words words = words_of(heading);
  return any_among(words, "ft feet foot"_words) && !any_among(words, "us survey"_words);
}

Column column_of(std::string_view heading) {
  if (trimmed(heading) == "#") return Column::number;
  const Reading reading = reading_of(heading);
  if (reading.column != Column::other) return reading.column;
  const Words words = words_of(heading);
  if (means(words, Column::name)) return Column::name;
  const bool of_a_point = any_among(words, "point points pt pts punkt vertex node corner"_words);
  return of_a_point || means(words, Column::number) ? Column::number : Column::other;
}

bool may_tell_shapes(std::string_view heading) {
  const Column column = column_of(heading);
  return column == Column::name || column == Column::number ||
         (column == Column::other &&
          any_among(words_of(heading),
                    "part parts shape polygon ring layer feature parcel body object"_words));
}

Column content_of(std::string_view heading) {
  const Words words = words_of(heading);
  // A single letter has other meanings.
  const bool is_unit =
      words.size() == 1 && words[0].size() > 1 && weight_unit_in(heading).value_or(0) > 0;
  if (means(words, Column::capacity) || (any_among(words, greatest) && means(words, Column::load)))
    return Column::capacity;
  for (const Column column :
       {Column::size, Column::thickness, Column::load, Column::name, Column::support})
    if (means(words, column)) return column;
  return is_unit ? Column::load : Column::other;
}

std::optional<double> weight_unit_in(std::string_view heading) {
  const std::size_t open = heading.find_first_of("([");
  std::string_view unit = open == std::string_view::npos ? heading : heading.substr(open + 1);
  if (open == std::string_view::npos) unit = unit.substr(unit.find_last_of(" _") + 1);
  unit = trimmed(unit.substr(0, unit.find_first_of(")]")));
  const double newton = in_kilograms(1, WeightUnit::N), pound = in_kilograms(1, WeightUnit::lb);
  const std::pair<std::string_view, double> known[] = {
      {"kg", 1},     {"kgf", 1},           {"g", 0.001},         {"t", 1000},
      {"to", 1000},  {"lb", pound},        {"lbs", pound},       {"lbf", pound},
      {"n", newton}, {"dan", 10 * newton}, {"kn", 1000 * newton}};
  for (const auto& [name, kilograms] : known)
    if (same_word(unit, name)) return kilograms;
  if (greatest.has(unit)) return std::nullopt;  // "capacity (max)"
  return open == std::string_view::npos ? std::nullopt : std::optional(0.0);
}

Fields names_among(const Fields& words) {
  Fields names;
  for (const std::string_view word : words) {
    const Words parts = words_of(word);
    if (std::all_of(parts.begin(), parts.end(), is_beside)) continue;
    if (column_of(word) == Column::other) return {};
    names.push_back(word);
  }
  return names;
}

LengthUnit unit_in(std::string_view heading) {
  const Words words = words_of(heading);
  for (std::size_t i = words.size(); i-- > 0;) {
    for (const LengthUnit unit : all_length_units)
      if (unit != LengthUnit::none && same_word(words[i], name(unit)) &&
          (words[i] != "in" || i + 1 == words.size()))
        return unit;
    for (const UnitWord& unit : unit_words)
      if (unit.unit != LengthUnit::none && unit.words.has(words[i])) return unit.unit;
  }
  return LengthUnit::none;
}

std::optional<NamedColumns> named_columns(const Fields& headings) {
  std::vector<Reading> readings;
  for (const std::string_view heading : headings) {
    Reading reading = reading_of(heading);
    if (reading.column == Column::other) reading.column = meaning_of_letter(words_of(heading));
    readings.push_back(reading);
  }
  static constexpr std::array<Column, 2> pairs[] = {{Column::x, Column::y},
                                                    {Column::easting, Column::northing},
                                                    {Column::longitude, Column::latitude}};
  for (const auto& [across, up] : pairs) {
    const auto x = best_column(readings, across), y = best_column(readings, up);
    if (!x || !y) continue;
    NamedColumns columns{*x, *y, across, unit_in(headings[*x])};
    if (columns.unit != unit_in(headings[*y])) columns.unit = LengthUnit::none;
    columns.is_in_feet = is_in_feet(headings[*x]) && is_in_feet(headings[*y]);
    if (columns.is_in_feet) columns.unit = LengthUnit::in;
    for (std::size_t i = 0; i < readings.size(); ++i)
      if (readings[i].column == Column::height) columns.heights.push_back(i);
    return columns;
  }
  return std::nullopt;
}

}  // namespace evenlift
