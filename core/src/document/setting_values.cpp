// Values with their own syntax.
#include "document/setting_values.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "document/list_text.h"
#include "evenlift/angles.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr NamedOverlay overlay_names[] = {
    {"candidates", &Overlays::candidates},
    {"chords", &Overlays::chords},
    {"hull", &Overlays::lifting_base},
    {"clockwise", &Overlays::clockwise},
    {"counterclockwise", &Overlays::counterclockwise},
    {"tipping", &Overlays::tipping},
    {"halo", &Overlays::halo},
    {"tilt", &Overlays::tilt},
    {"load", &Overlays::load},
};

}  // namespace

std::span<const NamedOverlay> all_overlays() { return overlay_names; }

namespace setting_value {

bool take(std::string_view text, const SettingRange&, std::optional<Vec2>& centre) {
  if (text == "centroid") {
    centre.reset();
    return true;
  }
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  const std::string_view before = text.substr(0, comma), after = text.substr(comma + 1);
  // Spaces may surround the comma, but not the whole text.
  if (trimmed(before).data() != before.data() || trimmed(text).size() != text.size()) return false;
  const std::optional<double> x = read_number(trimmed(before)), y = read_number(trimmed(after));
  if (!x || !y) return false;
  centre = Vec2(*x, *y);
  return true;
}

std::string text_of(const std::optional<Vec2>& centre, const SettingRange&) {
  return centre ? shortest(centre->x) + "," + shortest(centre->y) : "centroid";
}

// The size of the numbers is checked together with the vertices.
bool is_within(const std::optional<Vec2>&, const SettingRange&) { return true; }

bool take(std::string_view text, const SettingRange&, Overlays& overlays) {
  Overlays shown;
  for (const NamedOverlay& overlay : overlay_names) shown.*(overlay.shown) = false;
  while (text != "none") {
    const std::string_view word = text.substr(0, text.find(','));
    const NamedOverlay* found = nullptr;
    for (const NamedOverlay& overlay : overlay_names)
      if (overlay.name == word) found = &overlay;
    if (!found || shown.*(found->shown)) return false;  // unknown or repeated
    shown.*(found->shown) = true;
    if (word.size() == text.size()) break;
    text.remove_prefix(word.size() + 1);
    if (text == "none") return false;
  }
  overlays = shown;
  return true;
}

std::string text_of(const Overlays& overlays, const SettingRange&) {
  std::string text;
  for (const NamedOverlay& overlay : overlay_names)
    if (overlays.*(overlay.shown)) text += (text.empty() ? "" : ",") + std::string(overlay.name);
  return text.empty() ? "none" : text;
}

bool is_within(const Overlays&, const SettingRange&) { return true; }

bool take(std::string_view text, const SettingRange&, RobotSize& robot) {
  return read_robot(text, robot);
}
std::string text_of(const RobotSize& robot, const SettingRange&) { return robot_text(robot); }
bool is_within(const RobotSize& robot, const SettingRange&) { return is_robot_size(robot); }

bool take(std::string_view text, const SettingRange&, std::vector<EdgePart>& no_go) {
  return read_no_go(text, no_go);
}
std::string text_of(const std::vector<EdgePart>& no_go, const SettingRange&) {
  return no_go_text(no_go);
}
bool is_within(const std::vector<EdgePart>& no_go, const SettingRange&) { return is_no_go(no_go); }

bool take(std::string_view text, const SettingRange&, Points& supports) {
  Document read;
  if (!read_supports(text, read)) return false;
  supports = std::move(read.settings.supports);
  return true;
}
std::string text_of(const Points& supports, const SettingRange&) { return supports_text(supports); }
bool is_within(const Points& supports, const SettingRange&) {
  const auto is_bounded = [](const Vec2& at) {
    return std::fabs(at.x) <= max_coordinate && std::fabs(at.y) <= max_coordinate;
  };
  return supports.size() <= most_supports &&
         std::all_of(supports.begin(), supports.end(), is_bounded);
}

bool take(std::string_view text, const SettingRange&, Capacities& capacities) {
  return read_capacities(text, capacities);
}
std::string text_of(const Capacities& capacities, const SettingRange&) {
  return capacities_text(capacities);
}
bool is_within(const Capacities& capacities, const SettingRange&) {
  return are_capacities(capacities);
}

bool take(std::string_view text, const SettingRange&, CargoList& cargo) {
  return read_cargo(text, cargo);
}

bool take(std::string_view text, const SettingRange&, std::vector<std::string>& names) {
  return read_names(text, names);
}
std::string text_of(const std::vector<std::string>& names, const SettingRange&) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name_text(name);
  return text.empty() ? "none" : text;
}
bool is_within(const std::vector<std::string>& names, const SettingRange&) {
  return are_names(names);
}

// With spaces or commas between them.
bool take(std::string_view text, const SettingRange& range, Readings& readings) {
  Readings read;
  const bool good = text == "none" || for_each_item(text, [&](std::string_view item) {
                      if (item.size() > 1 && item.ends_with(',')) item.remove_suffix(1);
                      return for_each_word(item, [&](std::string_view word) {
                        const auto reading = read_number(word);
                        if (!reading || !is_within(*reading, range)) return false;
                        read.push_back(*reading + 0.0);  // -0 would make a different document
                        return read.size() <= most_supports;
                      });
                    });
  if (!good || (read.empty() && text != "none")) return false;
  readings = std::move(read);
  return true;
}
std::string text_of(const Readings& readings, const SettingRange&) {
  std::string text;
  for (const double reading : readings) text += (text.empty() ? "" : " ") + shortest(reading);
  return text.empty() ? "none" : text;
}
bool is_within(const Readings& readings, const SettingRange& range) {
  return readings.size() <= most_supports &&
         std::all_of(readings.begin(), readings.end(),
                     [&](double reading) { return is_within(reading, range); });
}

bool take(std::string_view text, const SettingRange& range, ReadingError& error) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  while (is_percent && text.ends_with(' ')) text.remove_suffix(1);
  const auto value = read_number(text);
  if (!value) return false;
  const ReadingError read =
      is_percent ? ReadingError{*value + 0.0, 0} : ReadingError{0, *value + 0.0};
  if (!is_within(read, range)) return false;
  error = read;
  return true;
}
std::string text_of(const ReadingError& error, const SettingRange&) {
  return error.percent > 0 ? shortest(error.percent) + "%" : shortest(error.weight);
}
bool is_within(const ReadingError& error, const SettingRange& range) {
  return error.percent >= 0 && error.percent <= 100 && is_within(error.weight, range) &&
         !(error.percent > 0 && error.weight > 0);
}
std::string text_of(const CargoList& cargo, const SettingRange&) { return cargo_text(cargo); }
bool is_within(const CargoList& cargo, const SettingRange&) { return is_cargo(cargo); }

}  // namespace setting_value

namespace {

struct Notation {
  std::string_view ending;
  double (*value)(double number);
};

double of_degrees(double degrees) {
  return degrees >= 0 && degrees < 90 ? slope_ratio(degrees) : -1;
}
double of_metres(double metres) {
  constexpr double standard_gravity = 9.80665;  // m/s²
  return metres / standard_gravity;
}
double as_is(double number) { return number; }

constexpr Notation of_slopes[] = {{"%", [](double percent) { return percent / 100; }},
                                  {"deg", of_degrees},
                                  {"\u00B0", of_degrees},
                                  {"", as_is}};
constexpr Notation of_accelerations[] = {
    {"m/s2", of_metres}, {"m/s\u00B2", of_metres}, {"g", as_is}, {"", as_is}};

bool read_notation(std::string_view text, std::span<const Notation> notations,
                   const SettingRange& range, double& value) {
  for (const Notation& notation : notations) {
    if (!text.ends_with(notation.ending)) continue;
    text.remove_suffix(notation.ending.size());
    if (!notation.ending.empty())
      while (text.ends_with(' ')) text.remove_suffix(1);
    const auto number = read_number(text);
    if (!number || !setting_value::is_within(notation.value(*number), range)) return false;
    value = notation.value(*number);
    return true;
  }
  return false;
}

}  // namespace

bool read_slope(std::string_view text, const SettingRange& range, double& slope) {
  return read_notation(text, of_slopes, range, slope);
}

bool read_part_of_all(std::string_view text, const SettingRange& range, double& part) {
  constexpr Notation of_parts[] = {{"%", [](double percent) { return percent / 100; }},
                                   {"", as_is}};
  return read_notation(text, of_parts, range, part);
}

bool read_direction(std::string_view text, std::optional<Vec2>& direction) {
  if (text == "none") {
    direction.reset();
    return true;
  }
  for (const std::string_view ending : {"deg", "\u00B0"}) {
    if (!text.ends_with(ending)) continue;
    const auto degrees = read_number(trimmed(text.substr(0, text.size() - ending.size())));
    if (!degrees || std::fabs(*degrees) > 360) return false;
    // The axes are exact.
    const double quarters = *degrees / 90, angle = *degrees * (pi / 180);
    constexpr Vec2 axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    direction = quarters == std::floor(quarters) ? axes[(static_cast<int>(quarters) + 8) % 4]
                                                 : Vec2(cosine(angle), sine(angle));
    return true;
  }
  std::optional<Vec2> read;
  if (!setting_value::take(text, {}, read) || !read || *read == Vec2()) return false;
  const double size = max_norm(*read);
  const bool is_usual = size <= max_coordinate && size >= 1 / max_coordinate;
  direction = is_usual ? *read : *read / size;
  return true;
}

bool read_acceleration(std::string_view text, const SettingRange& range, double& acceleration) {
  return read_notation(text, of_accelerations, range, acceleration);
}

namespace {

// A name as it is, or between quotes with each of its quotes doubled.
std::optional<std::string> read_name(std::string_view text) {
  if (text.empty()) return std::nullopt;
  if (text.find('"') == std::string_view::npos) return std::string(text);
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return std::nullopt;
  std::string name;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '"' && (++i + 1 == text.size() || text[i] != '"')) return std::nullopt;
    name += text[i];
  }
  return name;
}

// Of ASCII, U+0080 to U+009F, and those that separate lines or turn the direction of writing.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7f;
  const bool is_general = character.size() == 3 && byte(0) == 0xe2;  // U+2000 to U+2FFF
  return (byte(0) == 0xc2 && byte(1) < 0xa0) ||
         (is_general && byte(1) == 0x80 && byte(2) >= 0xa8 && byte(2) <= 0xae) ||
         (is_general && byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9);
}

// The name after a colon, at `from`; no name if the text ends there.
std::optional<std::string> name_after(std::string_view text, std::size_t from) {
  if (from >= text.size()) return std::string();
  const auto name = read_name(text.substr(from + 1));
  return name && !fault_of_name(*name) ? name : std::nullopt;
}

}  // namespace

namespace {

// No names, if none of them says anything.
std::vector<std::string> if_any(std::vector<std::string> names) {
  const bool has_any =
      std::any_of(names.begin(), names.end(), [](const auto& name) { return !name.empty(); });
  return has_any ? std::move(names) : std::vector<std::string>();
}

}  // namespace

std::string name_text(std::string_view name) {
  const bool is_plain =
      !name.empty() && name != "none" && name.find_first_of(" \"") == std::string_view::npos;
  if (is_plain) return std::string(name);
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

const char* fault_of_name(std::string_view name) {
  static_assert(max_name_characters == 60, "the message names the number");
  for (std::size_t characters = 0; !name.empty(); ++characters) {
    const std::size_t length = utf8_length(name);
    if (length == 0) return "a name must be valid UTF-8";
    if (is_control(name.substr(0, length))) return "a name must have no control characters";
    if (characters == max_name_characters) return "a name must have at most 60 characters";
    name.remove_prefix(length);
  }
  return nullptr;
}

bool read_names(std::string_view text, std::vector<std::string>& names) {
  std::vector<std::string> read;
  const bool good = text == "none" || for_each_item(text, [&](std::string_view item) {
                      const auto name = read_name(item);
                      if (!name || fault_of_name(*name) || read.size() == most_supports)
                        return false;
                      read.emplace_back(trimmed(*name));
                      return true;
                    });
  if (!good || (read.empty() && text != "none")) return false;
  names = if_any(std::move(read));
  return true;
}

bool are_names(const std::vector<std::string>& names) {
  return names.size() <= most_supports &&
         std::none_of(names.begin(), names.end(),
                      [](const std::string& name) { return fault_of_name(name); });
}

namespace {

struct Given {
  Vec2 at;
  std::optional<double> capacity;
  std::string name;
};

// X,Y, X,Y@K, X,Y:NAME or X,Y@K:NAME.
std::optional<Given> read_support(std::string_view word) {
  const std::size_t colon = std::min(word.find(':'), word.size());
  const std::string_view place = word.substr(0, colon);
  const std::size_t comma = place.find(','), sign = std::min(place.find('@'), colon);
  if (comma > sign) return std::nullopt;
  const auto x = read_number(place.substr(0, comma)),
             y = read_number(place.substr(comma + 1, sign - comma - 1));
  auto name = name_after(word, colon);
  if (!x || !y || !name) return std::nullopt;
  Given given{Vec2(*x, *y), std::nullopt, *std::move(name)};
  if (sign == colon) return given;
  given.capacity = read_number(place.substr(sign + 1));
  if (!given.capacity || !is_in_range(Setting::capacity, *given.capacity)) return std::nullopt;
  return given;
}

}  // namespace

bool read_supports(std::string_view text, Document& document) {
  Points supports;
  Capacities capacities;
  std::vector<std::string> names;
  const bool good = text == "none" || for_each_item(text, [&](std::string_view word) {
                      std::optional<Given> given = read_support(word);
                      if (!given || supports.size() == most_supports) return false;
                      supports.push_back(given->at);
                      capacities.push_back(given->capacity);
                      names.emplace_back(trimmed(given->name));
                      return true;
                    });
  if (!good || (supports.empty() && text != "none")) return false;
  if (!are_capacities(capacities)) capacities.clear();  // none is given
  document.settings.supports = std::move(supports);
  document.shown.support_capacities = std::move(capacities);
  document.settings.support_names = if_any(std::move(names));
  if (!document.settings.supports.empty()) document.settings.method = Method::given;
  return true;
}

std::string_view refused_support(std::string_view text) { return refused_item(text, read_support); }

std::string supports_text(const Points& supports) {
  std::string text;
  for (const Vec2& at : supports)
    text += (text.empty() ? "" : " ") + shortest(at.x) + ',' + shortest(at.y);
  return text.empty() ? "none" : text;
}

bool read_capacities(std::string_view text, Capacities& capacities) {
  Capacities read;
  const bool good = text.empty() || for_each_word(text, [&](std::string_view word) {
                      const std::optional<double> capacity = read_number(word);
                      read.push_back(capacity);
                      return capacity || word == "none";
                    });
  if (!good || !(read.empty() || are_capacities(read))) return false;
  capacities = std::move(read);
  return true;
}

std::string capacities_text(const Capacities& capacities) {
  std::string text;
  for (const std::optional<double>& capacity : capacities)
    text += (text.empty() ? "" : ",") + (capacity ? shortest(*capacity) : std::string("none"));
  return text;
}

bool are_capacities(const Capacities& capacities) {
  if (capacities.empty()) return true;
  if (capacities.size() > most_supports) return false;
  bool any = false;
  for (const std::optional<double>& capacity : capacities) {
    if (!capacity) continue;
    if (!is_in_range(Setting::capacity, *capacity)) return false;
    any = true;
  }
  return any;
}

namespace {

struct NamedSize {
  std::string_view name;
  double RobotSize::*value;
};
constexpr NamedSize sizes[] = {{"r", &RobotSize::radius},
                               {"reach", &RobotSize::reach},
                               {"depth", &RobotSize::depth},
                               {"width", &RobotSize::width},
                               {"gap", &RobotSize::gap}};

const NamedSize* size_of_name(std::string_view name) {
  for (const NamedSize& size : sizes)
    if (size.name == name) return &size;
  return nullptr;
}

// The hyphen between two numbers: neither a sign nor part of an exponent.
std::size_t find_hyphen(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i)
    if (text[i] == '-' && text[i - 1] != 'e' && text[i - 1] != 'E') return i;
  return std::string_view::npos;
}

bool is_part(const EdgePart& part) { return part.from >= 0 && part.from < part.to && part.to <= 1; }

std::optional<EdgePart> read_part(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::optional<std::uint64_t> edge = read_whole(text.substr(0, colon));
  if (!edge || *edge < 1 || *edge > max_vertices) return std::nullopt;
  EdgePart part;
  part.edge = static_cast<std::uint32_t>(*edge - 1);
  if (colon == std::string_view::npos) return part;
  text.remove_prefix(colon + 1);
  const std::size_t hyphen = find_hyphen(text);
  if (hyphen == std::string_view::npos) return std::nullopt;
  const std::optional<double> from = read_number(text.substr(0, hyphen)),
                              to = read_number(text.substr(hyphen + 1));
  if (!from || !to) return std::nullopt;
  part.from = *from + 0.0;  // -0 would make a different document
  part.to = *to;
  return is_part(part) ? std::optional(part) : std::nullopt;
}

}  // namespace

bool read_size(std::string_view text, double& size) {
  const std::optional<double> value = read_number(text);
  if (!value || !is_in_range(Setting::apart, *value)) return false;
  size = *value + 0.0;  // -0 would make a different document
  return true;
}

bool read_robot(std::string_view text, RobotSize& robot) {
  RobotSize read;
  unsigned named = 0;
  const bool good = text == "none" || for_each_word(text, [&](std::string_view word) {
                      const std::size_t equals = word.find('=');
                      if (equals == std::string_view::npos) return false;
                      const NamedSize* size = size_of_name(word.substr(0, equals));
                      if (!size || !read_size(word.substr(equals + 1), read.*(size->value)))
                        return false;
                      const unsigned bit = 1u << (size - sizes);
                      if (named & bit) return false;
                      named |= bit;
                      return true;
                    });
  if (good) robot = read;
  return good;
}

bool read_no_go(std::string_view text, std::vector<EdgePart>& no_go) {
  std::vector<EdgePart> read;
  const bool good = text == "none" || for_each_word(text, [&](std::string_view word) {
                      const std::optional<EdgePart> part = read_part(word);
                      if (part) read.push_back(*part);
                      return part && read.size() <= most_no_go;
                    });
  if (good) no_go = std::move(read);
  return good;
}

bool is_quotable(std::string_view part) {
  return part.size() <= 40 &&
         std::all_of(part.begin(), part.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

std::string_view refused_part(std::string_view text) {
  std::string_view refused;
  for_each_word(text, [&](std::string_view word) {
    if (read_part(word)) return true;
    refused = word;
    return false;
  });
  return is_quotable(refused) ? refused : std::string_view();
}

bool is_robot_size(const RobotSize& robot) {
  for (const NamedSize& size : sizes)
    if (!is_in_range(Setting::apart, robot.*(size.value))) return false;
  return true;
}

bool is_no_go(const std::vector<EdgePart>& no_go) {
  if (no_go.size() > most_no_go) return false;
  for (const EdgePart& part : no_go)
    if (!is_part(part)) return false;
  return true;
}

std::string robot_text(const RobotSize& robot) {
  std::string text;
  for (const NamedSize& size : sizes) {
    const double value = robot.*(size.value);
    if (value == 0) continue;
    text += (text.empty() ? "" : ",") + std::string(size.name) + '=' + shortest(value);
  }
  return text.empty() ? "none" : text;
}

std::string no_go_text(const std::vector<EdgePart>& no_go) {
  std::string text;
  for (const EdgePart& part : no_go) {
    text += (text.empty() ? "" : ",") + std::to_string(part.edge + 1);
    if (part.from != 0 || part.to != 1) text += ':' + shortest(part.from) + '-' + shortest(part.to);
  }
  return text.empty() ? "none" : text;
}

namespace {

bool is_item(const Cargo& item) {
  return is_finite(item.at) && max_norm(item.at) <= max_coordinate &&
         !fault_of_cargo_weight(item.weight) && !fault_of_name(item.name);
}

std::optional<Cargo> read_item(std::string_view text) {
  const std::size_t comma = text.find(','), colon = std::min(text.find(':'), text.size());
  if (comma > colon || colon == text.size()) return std::nullopt;
  const std::size_t end = std::min(text.find(':', colon + 1), text.size());
  const auto x = read_number(text.substr(0, comma)),
             y = read_number(text.substr(comma + 1, colon - comma - 1)),
             weight = read_number(text.substr(colon + 1, end - colon - 1));
  const std::optional<std::string> name = name_after(text, end);
  if (!x || !y || !weight || !name) return std::nullopt;
  Cargo item{Vec2(*x, *y), *weight, *name};
  return is_item(item) ? std::optional(std::move(item)) : std::nullopt;
}

}  // namespace

const char* fault_of_cargo_weight(double weight) {
  static_assert(min_weight == 1e-100 && max_weight == 1e100, "the message names the numbers");
  return weight >= min_weight && weight <= max_weight
             ? nullptr
             : "the weight of cargo must be a number greater than 0, from 1e-100 to 1e100";
}

bool read_cargo(std::string_view text, std::vector<Cargo>& cargo) {
  std::vector<Cargo> read;
  const bool good = text == "none" || for_each_item(text, [&](std::string_view word) {
                      std::optional<Cargo> item = read_item(word);
                      if (!item || read.size() == max_cargo) return false;
                      read.push_back(*std::move(item));
                      return true;
                    });
  if (!good || (read.empty() && text != "none")) return false;
  cargo = std::move(read);
  return true;
}

std::string_view refused_cargo(std::string_view text) { return refused_item(text, read_item); }

std::string cargo_text(const std::vector<Cargo>& cargo) {
  std::string text;
  for (const Cargo& item : cargo) {
    text += (text.empty() ? "" : " ") + shortest(item.at.x) + ',' + shortest(item.at.y) + ':' +
            shortest(item.weight);
    if (!item.name.empty()) text += ':' + name_text(item.name);
  }
  return text.empty() ? "none" : text;
}

bool is_cargo(const std::vector<Cargo>& cargo) {
  return cargo.size() <= max_cargo && std::all_of(cargo.begin(), cargo.end(), is_item);
}

}  // namespace evenlift
