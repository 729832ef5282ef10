#include "evenlift/output/json_text.h"

#include <algorithm>

#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/output/words.h"

namespace evenlift::json {
namespace {

std::size_t length_of(const std::string& item) { return item.size(); }
std::size_t length_of(const Member& member) {
  return text(member.first).size() + 2 + member.second.size();
}

void append(std::string& out, const std::string& item) { out += item; }
void append(std::string& out, const Member& member) {
  out += text(member.first);
  out += ": ";
  out += member.second;
}

// One allocation, since a placement's robots alone may need hundreds of megabytes.
template <class Items>
std::string joined(std::string_view open, const Items& items, std::string_view between,
                   std::string_view close) {
  std::size_t length = open.size() + close.size();
  for (const auto& item : items) length += length_of(item) + between.size();
  std::string out;
  out.reserve(length);
  out += open;
  bool first = true;
  for (const auto& item : items) {
    if (!first) out += between;
    first = false;
    append(out, item);
  }
  out += close;
  return out;
}

template <class Item>
std::string spread(char open, const std::vector<Item>& items, char close, int depth) {
  if (items.empty()) return {open, close};
  const std::string outer = "\n" + std::string(2 * static_cast<std::size_t>(depth), ' ');
  const std::string inner = outer + "  ";
  return joined(open + inner, items, "," + inner, outer + close);
}

}  // namespace

std::string number(double value) { return shortest(value); }

std::string text(std::string_view utf8) {
  constexpr char hex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (c == '\n')
      out += "\\n";
    else if (byte < 0x20)
      (out += "\\u00") += {hex[byte >> 4], hex[byte & 15]};
    else
      out += c;
  }
  return out + '"';
}

std::string boolean(bool value) { return value ? "true" : "false"; }

std::string pair(const Vec2& point) { return array({number(point.x), number(point.y)}); }

std::string array(const std::vector<std::string>& items) { return joined("[", items, ", ", "]"); }
std::string array(std::initializer_list<std::string> items) {
  return joined("[", items, ", ", "]");
}

std::string numbers(const std::vector<double>& values) {
  std::string out = "[";
  for (const double value : values) {
    if (out.size() > 1) out += ", ";
    out += number(value);
  }
  return out + "]";
}

std::string wholes(const std::vector<std::size_t>& values) {
  std::vector<std::string> items;
  for (const std::size_t value : values) items.push_back(std::to_string(value));
  return array(items);
}

std::string texts(const std::vector<std::string>& values) {
  std::vector<std::string> items;
  for (const std::string& value : values) items.push_back(text(value));
  return array(items);
}

std::string object(const std::vector<Member>& members) { return joined("{", members, ", ", "}"); }
std::string object(std::initializer_list<Member> members) {
  return joined("{", members, ", ", "}");
}

std::string long_array(const std::vector<std::string>& items, int depth) {
  return spread('[', items, ']', depth);
}

std::string long_object(const std::vector<Member>& members, int depth) {
  return spread('{', members, '}', depth);
}

std::string on_one_line(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '\n') {
      out += text[at];
      continue;
    }
    if (!out.empty() && out.back() == ',') out += ' ';
    at = std::min(text.find_first_not_of(' ', at + 1), text.size()) - 1;
  }
  return out;
}

std::string points(const Points& points, int depth) {
  std::vector<std::string> items;
  items.reserve(points.size());
  for (const Vec2& point : points) items.push_back(pair(point));
  return long_array(items, depth);
}

}  // namespace evenlift::json

namespace evenlift {

namespace {

const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::too_few_vertices:
      return "too_few_vertices";
    case ErrorCode::too_many_vertices:
      return "too_many_vertices";
    case ErrorCode::bad_coordinate:
      return "bad_coordinate";
    case ErrorCode::repeated_vertex:
      return "repeated_vertex";
    case ErrorCode::no_area:
      return "no_area";
    case ErrorCode::edges_cross:
      return "edges_cross";
    case ErrorCode::object_too_small:
      return "object_too_small";
    case ErrorCode::centre_outside_hull:
      return "centre_outside_hull";
    case ErrorCode::bad_setting:
      return "bad_setting";
    case ErrorCode::hole_outside:
      return "hole_outside";
    case ErrorCode::too_many_edge_pairs:
      return "too_many_edge_pairs";
    case ErrorCode::bad_syntax:
      return "bad_syntax";
    case ErrorCode::unsupported:
      return "unsupported";
    case ErrorCode::text_too_long:
      return "text_too_long";
    case ErrorCode::bad_link:
      return "bad_link";
    case ErrorCode::bad_checksum:
      return "bad_checksum";
    case ErrorCode::unknown_version:
      return "unknown_version";
  }
  return "";
}

// One or two vertices or edges, from 0, and their rings unless both are on the outline.
std::string place_json(const Place& place) {
  const std::string index = std::to_string(place.index), other = std::to_string(place.other);
  const bool two = place.other != 0 && place.other != place.index;
  const bool in_holes = place.ring != 0 || place.other_ring != 0;
  const bool pair = two || place.ring != place.other_ring;
  const auto both = [&](const char* name) {
    std::vector<json::Member> members{
        {name, json::array(pair ? std::vector{index, other} : std::vector{index})}};
    const std::string ring = std::to_string(place.ring), second = std::to_string(place.other_ring);
    if (in_holes)
      members.push_back(
          {"rings", json::array(pair ? std::vector{ring, second} : std::vector{ring})});
    return json::object(members);
  };
  switch (place.kind) {
    case Place::Kind::nowhere:
      break;
    case Place::Kind::line:
      return json::object({{"line", index}, {"column", other}});
    case Place::Kind::vertex:
      return both("vertices");
    case Place::Kind::edge:
      return both("edges");
    case Place::Kind::hole:
      return json::object({{"rings", json::array({std::to_string(place.ring)})}});
    case Place::Kind::centre_of_mass:
      return json::object({{"centre_of_mass", "true"}});
    case Place::Kind::option:
      return json::object({{"setting", json::text(place.option)}});
    case Place::Kind::link:
      return json::object({{"character", index}});
  }
  return "null";
}

}  // namespace

std::string error_json(const InputError& error) {
  const std::string path = path_of(error.place);
  return json::object({{"code", json::text(name(error.code))},
                       {"message", json::text(sentence(error))},
                       {"place", place_json(error.place)},
                       {"path", path.empty() ? "null" : json::text(path)}});
}

}  // namespace evenlift
