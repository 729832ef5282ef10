#include "output/json/json_text.h"

#include "evenlift/numbers.h"

namespace evenlift::json {
namespace {

std::string member_text(const Member& member) { return text(member.first) + ": " + member.second; }

std::vector<std::string> member_texts(const std::vector<Member>& members) {
  std::vector<std::string> texts;
  for (const Member& member : members) texts.push_back(member_text(member));
  return texts;
}

std::string joined(const std::vector<std::string>& items, std::string_view between) {
  std::string out;
  for (const std::string& item : items) {
    if (!out.empty()) out += between;
    out += item;
  }
  return out;
}

std::string spread(char open, const std::vector<std::string>& items, char close, int depth) {
  if (items.empty()) return {open, close};
  const std::string outer = "\n" + std::string(2 * static_cast<std::size_t>(depth), ' ');
  const std::string inner = outer + "  ";
  return open + inner + joined(items, "," + inner) + outer + close;
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

std::string pair(const Vec2& point) { return array({number(point.x()), number(point.y())}); }

std::string array(const std::vector<std::string>& items) { return '[' + joined(items, ", ") + ']'; }

std::string object(const std::vector<Member>& members) {
  return '{' + joined(member_texts(members), ", ") + '}';
}

std::string long_array(const std::vector<std::string>& items, int depth) {
  return spread('[', items, ']', depth);
}

std::string long_object(const std::vector<Member>& members, int depth) {
  return spread('{', member_texts(members), '}', depth);
}

std::string points(const Points& points, int depth) {
  std::vector<std::string> items;
  items.reserve(points.size());
  for (const Vec2& point : points) items.push_back(pair(point));
  return long_array(items, depth);
}

}  // namespace evenlift::json
