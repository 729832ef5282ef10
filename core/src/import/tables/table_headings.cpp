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

template <std::size_t n>
bool is_among(std::string_view word, const std::string_view (&list)[n]) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

// --- The words

struct Meaning {
  std::string_view word;
  Column column;
};

constexpr Meaning meanings[] = {
    {"x", Column::x},
    {"y", Column::y},
    {"z", Column::height},
    {"easting", Column::easting},
    {"eastings", Column::easting},
    {"east", Column::easting},
    {"ost", Column::easting},
    {"ostwert", Column::easting},
    {"rechtswert", Column::easting},
    {"rechts", Column::easting},
    {"rw", Column::easting},
    {"est", Column::easting},
    {"este", Column::easting},
    {"oost", Column::easting},
    {"abscissa", Column::easting},
    {"abscisse", Column::easting},
    {"northing", Column::northing},
    {"northings", Column::northing},
    {"north", Column::northing},
    {"nord", Column::northing},
    {"nordwert", Column::northing},
    {"hochwert", Column::northing},
    {"hoch", Column::northing},
    {"hw", Column::northing},
    {"norte", Column::northing},
    {"noord", Column::northing},
    {"ordinate", Column::northing},
    {"ordonnee", Column::northing},
    {"ordonn\xc3\xa9"
     "e",
     Column::northing},
    {"lon", Column::longitude},
    {"long", Column::longitude},
    {"lng", Column::longitude},
    {"longitude", Column::longitude},
    {"longitud", Column::longitude},
    {"l\xc3\xa4ngengrad", Column::longitude},
    {"laengengrad", Column::longitude},
    {"lat", Column::latitude},
    {"latitude", Column::latitude},
    {"latitud", Column::latitude},
    {"breitengrad", Column::latitude},
    {"height", Column::height},
    {"elevation", Column::height},
    {"elev", Column::height},
    {"ele", Column::height},
    {"el", Column::height},
    {"altitude", Column::height},
    {"alt", Column::height},
    {"h", Column::height},
    {"h\xc3\xb6he", Column::height},
    {"hoehe", Column::height},
    {"level", Column::height},
    {"rl", Column::height},
    {"cota", Column::height},
    {"quota", Column::height},
    {"objectid", Column::number},
    {"oid", Column::number},
    {"fid", Column::number},
    {"gid", Column::number},
    {"uid", Column::number},
    {"id", Column::number},
    {"no", Column::number},
    {"nr", Column::number},
    {"num", Column::number},
    {"n\xc2\xb0", Column::number},
    {"n\xc2\xba", Column::number},
    {"number", Column::number},
    {"nummer", Column::number},
    {"numero", Column::number},
    {"num\xc3\xa9ro", Column::number},
    {"index", Column::number},
    {"idx", Column::number},
    {"seq", Column::number},
    {"sequence", Column::number},
    {"order", Column::number},
    {"count", Column::number},
    {"anzahl", Column::number},
    {"row", Column::number},
    {"line", Column::number},
    {"pnt", Column::number},
    {"pn", Column::number},
    {"p", Column::number},
    {"pkt", Column::number},
    {"punktnummer", Column::number},
    {"pointid", Column::number},
    {"pointno", Column::number},
    {"name", Column::name},
    {"nom", Column::name},
    {"nome", Column::name},
    {"nombre", Column::name},
    {"label", Column::name},
    {"title", Column::name},
    {"bezeichnung", Column::name},
    {"designation", Column::name},
    {"nazwa", Column::name},
    {"naam", Column::name},
    {"jack", Column::support},
    {"jacks", Column::support},
    {"support", Column::support},
    {"robot", Column::support},
    {"leg", Column::support},
    {"pad", Column::support},
    {"stand", Column::support},
    {"st\xc3\xbctze", Column::support},
    {"stuetze", Column::support},
    {"auflager", Column::support},
    {"heber", Column::support},
    {"winde", Column::support},
    {"bein", Column::support},
    {"appui", Column::support},
    {"v\xc3\xa9rin", Column::support},
    {"verin", Column::support},
    {"apoyo", Column::support},
    {"gato", Column::support},
    {"appoggio", Column::support},
    {"capacity", Column::capacity},
    {"capacities", Column::capacity},
    {"cap", Column::capacity},
    {"swl", Column::capacity},
    {"wll", Column::capacity},
    {"tragkraft", Column::capacity},
    {"traglast", Column::capacity},
    {"tragf\xc3\xa4higkeit", Column::capacity},
    {"tragfaehigkeit", Column::capacity},
    {"kapazit\xc3\xa4t", Column::capacity},
    {"capacit\xc3\xa9", Column::capacity},
    {"capacite", Column::capacity},
    {"cmu", Column::capacity},
    {"capacidad", Column::capacity},
    {"capacit\xc3\xa0", Column::capacity},
    {"portata", Column::capacity},
    {"reading", Column::load},
    {"readings", Column::load},
    {"reads", Column::load},
    {"scale", Column::load},
    {"load", Column::load},
    {"loads", Column::load},
    {"weight", Column::load},
    {"weights", Column::load},
    {"anzeige", Column::load},
    {"ablesung", Column::load},
    {"last", Column::load},
    {"gewicht", Column::load},
    {"messwert", Column::load},
    {"lecture", Column::load},
    {"charge", Column::load},
    {"poids", Column::load},
    {"lectura", Column::load},
    {"carga", Column::load},
    {"peso", Column::load},
    {"carico", Column::load},
    {"dia", Column::size},
    {"diam", Column::size},
    {"diameter", Column::size},
    {"diametre", Column::size},
    {"diam\xc3\xa8tre", Column::size},
    {"di\xc3\xa1metro", Column::size},
    {"diametro", Column::size},
    {"durchmesser", Column::size},
    {"radius", Column::size},
    {"radio", Column::size},
    {"rayon", Column::size},
    {"drill", Column::size},
    {"thickness", Column::thickness},
    {"dicke", Column::thickness},
};

// Before a word of loads they make a capacity: "max. load".
constexpr std::string_view greatest[] = {
    "max",     "maximum", "maximal",          "maximale",   "rated",  "allowable", "zul",
    "working", "safe",    "zul\xc3\xa4ssige", "zulaessige", "maxima", "maximo",    "m\xc3\xa1xima"};

// Words that do not change the meaning of the coordinate.
constexpr std::string_view beside[] = {"coord",
                                       "coords",
                                       "coordinate",
                                       "coordinates",
                                       "coor",
                                       "koordinate",
                                       "koord",
                                       "pos",
                                       "position",
                                       "posn",
                                       "point",
                                       "points",
                                       "pt",
                                       "pts",
                                       "punkt",
                                       "vertex",
                                       "node",
                                       "corner",
                                       "value",
                                       "wert",
                                       "axis",
                                       "center",
                                       "centre",
                                       "start",
                                       "insertion",
                                       "location",
                                       "coordonn\xc3\xa9"
                                       "e",
                                       "coordonnee",
                                       "coordenada",
                                       "coordinata",
                                       "utm",
                                       "grid",
                                       "local",
                                       "world",
                                       "map",
                                       "geo",
                                       "gps",
                                       "wgs",
                                       "etrs",
                                       "dd",
                                       "decimal",
                                       "deg",
                                       "degree",
                                       "degrees",
                                       "in",
                                       "the"};

constexpr std::string_view unit_words[] = {
    "m",           "cm",          "mm",          "km",          "ft",
    "inch",        "inches",      "feet",        "foot",        "usft",
    "px",          "meter",       "meters",      "metre",       "metres",
    "millimeter",  "millimeters", "millimetre",  "millimetres", "centimeter",
    "centimeters", "centimetre",  "centimetres", "us",          "survey"};

struct UnitWord {
  std::string_view word;
  LengthUnit unit;
};

constexpr UnitWord units_in_words[] = {
    {"meter", LengthUnit::m},       {"meters", LengthUnit::m},
    {"metre", LengthUnit::m},       {"metres", LengthUnit::m},
    {"millimeter", LengthUnit::mm}, {"millimeters", LengthUnit::mm},
    {"millimetre", LengthUnit::mm}, {"millimetres", LengthUnit::mm},
    {"centimeter", LengthUnit::cm}, {"centimeters", LengthUnit::cm},
    {"centimetre", LengthUnit::cm}, {"centimetres", LengthUnit::cm},
    {"inch", LengthUnit::in},       {"inches", LengthUnit::in},
};

Column meaning_of(std::string_view word) {
  for (const Meaning& meaning : meanings)
    if (word == meaning.word) return meaning.column;
  return Column::other;
}

// "xcoord", "posx", "xmm": an axis with a word of `beside` or `unit_words`.
Column meaning_of_compound(std::string_view word) {
  if (word.size() < 3) return Column::other;
  const auto is_beside = [](std::string_view rest) {
    return rest != "in" && rest != "the" && (is_among(rest, beside) || is_among(rest, unit_words));
  };
  const auto axis = [](char c) {
    return c == 'x' ? Column::x : c == 'y' ? Column::y : c == 'z' ? Column::height : Column::other;
  };
  if (is_beside(word.substr(1))) return axis(word.front());
  if (is_beside(word.substr(0, word.size() - 1))) return axis(word.back());
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
  const bool with_unit = words.size() == 2 && is_among(words[1], unit_words);
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
    } else if (is_among(word, beside) || is_among(word, unit_words)) {
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
  static constexpr std::string_view feet[] = {"ft", "feet", "foot"};
  static constexpr std::string_view survey[] = {"us", "survey"};
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return is_among(word, feet); }) &&
         std::none_of(words.begin(), words.end(),
                      [](const std::string& word) { return is_among(word, survey); });
}

Column column_of(std::string_view heading) {
  if (trimmed(heading) == "#") return Column::number;
  const Reading reading = reading_of(heading);
  if (reading.column != Column::other) return reading.column;
  const Words words = words_of(heading);
  const auto means = [&](Column column) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return meaning_of(word) == column; });
  };
  if (means(Column::name)) return Column::name;
  static constexpr std::string_view points[] = {"point", "points", "pt",   "pts",
                                                "punkt", "vertex", "node", "corner"};
  const bool of_a_point = std::any_of(
      words.begin(), words.end(), [](const std::string& word) { return is_among(word, points); });
  return of_a_point || means(Column::number) ? Column::number : Column::other;
}

bool may_tell_shapes(std::string_view heading) {
  static constexpr std::string_view shapes[] = {"part",  "shape",   "polygon", "ring", "layer",
                                                "parts", "feature", "parcel",  "body", "object"};
  const Column column = column_of(heading);
  if (column == Column::name || column == Column::number) return true;
  const Words words = words_of(heading);
  return column == Column::other &&
         std::any_of(words.begin(), words.end(), [](auto& word) { return is_among(word, shapes); });
}

Column content_of(std::string_view heading) {
  const Words words = words_of(heading);
  const auto means = [&](Column column) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return meaning_of(word) == column; });
  };
  const bool is_greatest = std::any_of(
      words.begin(), words.end(), [](const std::string& word) { return is_among(word, greatest); });
  // A single letter has other meanings.
  const bool is_unit =
      words.size() == 1 && words[0].size() > 1 && weight_unit_in(heading).value_or(0) > 0;
  if (means(Column::capacity) || (is_greatest && means(Column::load))) return Column::capacity;
  for (const Column column :
       {Column::size, Column::thickness, Column::load, Column::name, Column::support})
    if (means(column)) return column;
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
  if (is_among(unit, greatest)) return std::nullopt;  // "capacity (max)"
  return open == std::string_view::npos ? std::nullopt : std::optional(0.0);
}

Fields names_among(const Fields& words) {
  Fields names;
  for (const std::string_view word : words) {
    const Words parts = words_of(word);
    const bool is_beside = std::all_of(parts.begin(), parts.end(), [](const std::string& part) {
      return is_among(part, beside) || is_among(part, unit_words);
    });
    if (is_beside) continue;
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
    for (const UnitWord& unit : units_in_words)
      if (words[i] == unit.word) return unit.unit;
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
