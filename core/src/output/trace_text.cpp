#include "trace_text.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/formats.h"
#include "evenlift/output/words.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

constexpr int most_decimals = 9;
constexpr double least_fixed = 1e-5;  // below, fixed() would show hardly a digit

// About four significant digits, none after the point of a large number.
int decimals_shown(double scale) { return scale >= 1e4 ? 0 : decimals_for(scale) + 1; }

// Four significant digits.
std::string significant(double value) {
  if (value == 0) return "0";
  double unit = 1;
  while (std::fabs(value) * unit < 1000) unit *= 10;
  return shortest(std::floor(value * unit + 0.5) / unit);
}

std::string with_decimals(double value, int decimals, double scale) {
  return scale < least_fixed ? significant(value) : fixed(value, std::min(decimals, most_decimals));
}

}  // namespace

std::string fill(std::string_view pattern, std::initializer_list<std::string> values) {
  std::string text;
  const std::string* value = values.begin();
  for (const char c : pattern) {
    if (c == '#' && value != values.end()) {
      text += *value++;
    } else {
      text += c;
    }
  }
  return text;
}

std::string whole(std::size_t number) { return std::to_string(number); }

std::string counted(std::size_t number, std::string_view noun) {
  std::string text = whole(number) + ' ';
  if (number != 1 && noun == "vertex") return text + "vertices";
  text += noun;
  return number == 1 ? text : text + 's';
}

std::string number(double value, double scale) {
  return with_decimals(value, decimals_shown(scale), scale);
}

std::string number_unlike(double value, double other, double scale) {
  int decimals = decimals_shown(scale);
  std::string text = with_decimals(value, decimals, scale);
  while (value != other && decimals < most_decimals &&
         text == with_decimals(other, decimals, scale))
    text = with_decimals(value, ++decimals, scale);
  return text;
}

std::string ratio_text(double ratio, double other) {
  if (std::fabs(ratio - 1) <= tau) return "1";
  int decimals = 3;
  const auto looks_like = [&](double known) {
    return std::fabs(ratio - known) > tau && fixed(ratio, decimals) == fixed(known, decimals);
  };
  while (decimals < most_decimals && (looks_like(1) || looks_like(other))) ++decimals;
  return fixed(ratio, decimals);
}

std::string length_text(const Trace& trace, double value) {
  return number(value, trace.polygon.diagonal());
}

std::string point_text(const Trace& trace, const Vec2& point) {
  return fill("(#, #)", {length_text(trace, point.x()), length_text(trace, point.y())});
}

std::string load_text(const Trace& trace, double value) {
  return number(value, 10 * trace.placement.loads->max);
}

std::string margin_text(double value) {
  const double size = std::fabs(value);
  return fixed(value, size < tau ? 0 : std::max(3, decimals_for(size)));
}

std::string score_text(const Trace& trace, Rule rule, double value, double other) {
  if (rule == Rule::most_even) return ratio_text(value, other);
  const double size = trace.polygon.diagonal();
  const bool is_length =
      rule == Rule::longest_even || trace.placement.settings.metric == Metric::distance;
  return number_unlike(value, other, is_length ? size : 0.1 * size * size);
}

std::string candidate_text(std::uint32_t candidate) {
  return "candidate " + whole(candidate + std::size_t{1});
}

std::string angle_text(const Vec2& direction) {
  if (is_vertical(direction)) return "90°";
  const Vec2 u = direction.x() < 0 ? Vec2(-direction) : direction;
  return fixed(180 / pi * arctangent2(u.y(), u.x()), 1) + "°";
}

}  // namespace evenlift
