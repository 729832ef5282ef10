#include "schema/schema.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/settings.h"

namespace evenlift::native {
namespace {

using Members = std::vector<json::Member>;

// --- Types in words as JSON Schema

class TypeReader {
 public:
  explicit TypeReader(std::string_view text) : text_(text) {}

  std::string read() {
    std::vector<std::string> choices{one()};
    while (take(" | ")) choices.push_back(one());
    if (choices.size() == 1) return choices.front();
    return json::object({{"anyOf", json::array(choices)}});
  }

 private:
  bool take(std::string_view expected) {
    if (!text_.starts_with(expected)) return false;
    text_.remove_prefix(expected.size());
    return true;
  }

  std::string one() {
    std::string type = take("(") ? in_brackets() : named();
    while (take("[")) {
      const std::size_t end = text_.find(']');
      const std::string length(text_.substr(0, end));
      text_.remove_prefix(end + 1);
      Members members = {{"type", "\"array\""}, {"items", type}};
      if (!length.empty()) {
        members.push_back({"minItems", length});
        members.push_back({"maxItems", length});
      }
      type = json::object(members);
    }
    return type;
  }

  // One of several, or a list.
  std::string in_brackets() {
    std::string first = read();
    if (take(")")) return first;
    std::vector<std::string> items{std::move(first)};
    while (take(", ")) items.push_back(read());
    take(")");
    const std::string length = std::to_string(items.size());
    return json::object({{"type", "\"array\""},
                         {"prefixItems", json::array(items)},
                         {"minItems", length},
                         {"maxItems", length}});
  }

  std::string named() {
    const bool is_text = text_.starts_with('"');
    const std::size_t end =
        is_text ? text_.find('"', 1) + 1 : std::min(text_.find_first_of(" ,)[|"), text_.size());
    const std::string name(text_.substr(0, end));
    text_.remove_prefix(end);
    if (is_text || name == "true" || name == "false") return json::object({{"const", name}});
    for (const char* simple : {"number", "integer", "string", "boolean", "null", "object"})
      if (name == simple) return json::object({{"type", json::text(name)}});
    return json::object({{"$ref", json::text("#/$defs/" + name)}});
  }

  std::string_view text_;
};

std::string described(std::string schema, std::string_view about) {
  if (about.empty()) return schema;
  schema.pop_back();
  return schema + ", \"description\": " + json::text(about) + "}";
}

// --- Settings

struct Named {
  Setting setting;
  std::string_view type;
};
// Settings with a type of their own: as a value, and in a result.
constexpr Named enumerated[] = {{Setting::method, "Metric"},
                                {Setting::goal, "Goal"},
                                {Setting::positions, "Positions"},
                                {Setting::unit, "LengthUnit"},
                                {Setting::weight_unit, "WeightUnit"}};
constexpr Named given[] = {
    {Setting::com, "Point | string"},
    {Setting::robot, "RobotSize | string"},
    {Setting::no_go, "(integer | string)[] | string"},
    {Setting::overlays, "Overlay[] | Overlays | string"},
    {Setting::supports, "(Point | Support)[] | string"},
    {Setting::support_capacities, "(number | null)[] | string"},
    {Setting::support_names, "(string | null)[] | string"},
    {Setting::cargo, "(Cargo | (Point, number) | (Point, number, string))[] | string"},
    {Setting::slope, "number | string"},
    {Setting::acceleration, "number | string"},
    {Setting::readings, "number[] | string"},
    {Setting::reading_error, "number | string"},
    {Setting::level_error, "number | string"},
    {Setting::readings_tilted, "number[] | string"},
    {Setting::tilted, "number | string"},
    {Setting::heading, "Point | string"},
    {Setting::weight_doubt, "number | string"}};
constexpr Named told[] = {{Setting::supports, "Position[]"},
                          {Setting::support_capacities, "(number | null)[]"},
                          {Setting::support_names, "(string | null)[]"},
                          {Setting::cargo, "CargoItem[]"},
                          {Setting::readings, "number[]"},
                          {Setting::reading_error, "number | string"},
                          {Setting::readings_tilted, "number[]"},
                          {Setting::heading, "Position"},
                          {Setting::clear, "number | null"},
                          {Setting::apart, "number | null"}};

std::string_view type_among(std::span<const Named> types, Setting setting) {
  const auto found = std::find_if(types.begin(), types.end(),
                                  [&](const Named& each) { return each.setting == setting; });
  return found == types.end() ? std::string_view() : found->type;
}

std::string number_schema(const SettingRow& row) {
  Members members = {{"type", row.access.is_whole ? "\"integer\"" : "\"number\""}};
  if (row.range.most > 0) {
    members.push_back({"minimum", json::number(row.range.least)});
    members.push_back({"maximum", json::number(row.range.most)});
  }
  return json::object(members);
}

std::string plain_schema(const SettingRow& row) {
  if (const auto type = type_among(enumerated, row.setting); !type.empty())
    return TypeReader(type).read();
  return row.access.is_number ? number_schema(row) : TypeReader("string").read();
}

// What a request may give.
std::string given_schema(const SettingRow& row) {
  std::vector<std::string> choices;
  if (const auto type = type_among(given, row.setting); !type.empty())
    choices.push_back(TypeReader(type).read());
  else
    choices.push_back(plain_schema(row));
  const std::string_view unset = row.setting == Setting::unit ? "none" : row.range.unset;
  if (!unset.empty()) choices.push_back(json::object({{"const", json::text(unset)}}));
  choices.push_back(TypeReader("null").read());
  Members members = {{"anyOf", json::array(choices)}};
  if (const std::string usual = row.access.text({}, row.range); !usual.empty())
    members.push_back(
        {"default", row.access.is_number && usual != unset ? usual : json::text(usual)});
  if (row.record != 0) members.push_back({"x-link-record", std::to_string(row.record)});
  return described(json::object(members), row.option.help);
}

// When a result has the setting, if not always.
const char* presence(const SettingRow& row) {
  if (row.counts_for == CountsFor::given) return "; only with supports";
  if (row.counts_for == CountsFor::balanced) return "; only with balanced robots";
  if (row.counts_for == CountsFor::hold_requirements)
    return "; only with balanced robots and with the goal hold";
  return row.in_result == Listed::if_changed ? "; only if it is set" : "";
}

std::string told_schema(const SettingRow& row) {
  const auto type = type_among(told, row.setting);
  return described(type.empty() ? plain_schema(row) : TypeReader(type).read(),
                   std::string(row.option.help) + presence(row));
}

std::vector<std::string> names_of(const SettingRow& row) {
  std::vector<std::string> names;
  for (std::size_t i = 0; row.access.names; ++i) {
    const std::string_view name = row.access.names(i);
    if (name.empty()) break;
    if (name != "none") names.emplace_back(name);
  }
  return names;
}

// --- Objects

struct Object {
  Members properties;
  std::vector<std::string> required;
};

void add(Object& object, std::string_view name, std::string schema, bool is_optional) {
  object.properties.push_back({name, std::move(schema)});
  if (!is_optional) object.required.emplace_back(name);
}

void add_settings_as_used(Object& object) {
  for (const SettingRow& row : all_settings()) {
    if (row.in_result == Listed::never) continue;
    add(object, row.json.empty() ? row.name : row.json, told_schema(row), *presence(row) != 0);
  }
}

std::string object_schema(const Object& object, std::string_view about,
                          std::span<const std::string_view> extends, bool is_open) {
  Members members = {{"type", "\"object\""}};
  if (!about.empty()) members.push_back({"description", json::text(about)});
  std::vector<std::string> others;
  for (const std::string_view other : extends) others.push_back(TypeReader(other).read());
  if (!others.empty()) members.push_back({"allOf", json::array(others)});
  members.push_back({"properties", json::long_object(object.properties, 2)});
  if (!object.required.empty()) members.push_back({"required", json::texts(object.required)});
  if (!is_open) members.push_back({"unevaluatedProperties", "false"});
  return json::long_object(members, 1);
}

std::string type_schema(const Type& type) {
  if (!type.is.empty()) return described(TypeReader(type.is).read(), type.about);
  Object object;
  for (const TypeMember& member : type.members) {
    if (member.name == settings_as_used) {
      add_settings_as_used(object);
      continue;
    }
    const bool is_optional = member.name.ends_with('?');
    add(object, member.name.substr(0, member.name.size() - (is_optional ? 1 : 0)),
        described(TypeReader(member.type).read(), member.about), is_optional);
  }
  return object_schema(object, type.about, type.extends, type.is_open);
}

// The settings of a request, all of which may be missing.
std::string settings_schema() {
  Object object;
  for (const SettingRow& row : all_settings()) {
    if (row.changes == Changes::view) continue;
    for (const std::string_view name : {row.name, row.alias})
      if (!name.empty()) add(object, name, given_schema(row), true);
  }
  return object_schema(
      object, "The program's options, with _ in place of -. Null counts as not given.", {}, true);
}

std::string enumeration(const std::vector<std::string>& names) {
  return json::object({{"enum", json::texts(names)}});
}

}  // namespace

std::string schema_json() {
  Members types;
  for (const Named& each : enumerated)
    types.push_back({each.type, enumeration(names_of(row_of(each.setting)))});
  std::vector<std::string> overlays;
  for (const NamedOverlay& overlay : all_overlays()) overlays.emplace_back(overlay.name);
  types.push_back({"Overlay", enumeration(overlays)});
  types.push_back({"Settings", settings_schema()});
  for (const Type& type : described_types()) types.push_back({type.name, type_schema(type)});
  return json::long_object(
             {{"$schema", "\"https://json-schema.org/draft/2020-12/schema\""},
              {"title", json::text("evenlift " + std::string(version()))},
              {"description",
               json::text(
                   "What evenlift place --json prints, and in $defs all other results, requests "
                   "and settings.")},
              {"$ref", "\"#/$defs/Placement\""},
              {"$defs", json::long_object(types, 1)}},
             0) +
         "\n";
}

}  // namespace evenlift::native
