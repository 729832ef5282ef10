#include "format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "evenlift/formats.h"

namespace evenlift::view {
namespace {

std::string with_minus_sign(std::string digits) {
  if (!digits.empty() && digits[0] == '-') digits.replace(0, 1, "−");
  return digits;
}

}  // namespace

std::string fixed(double value, int decimals) {
  char digits[400];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
  const bool zero = std::all_of(digits, digits + std::char_traits<char>::length(digits),
                                [](char c) { return c == '-' || c == '0' || c == '.'; });
  return with_minus_sign(zero && digits[0] == '-' ? digits + 1 : digits);
}

std::string plain(double value) { return with_minus_sign(shortest(value)); }

int decimals_for(double value) {
  const double size = std::abs(value);
  if (!(size > 0) || !std::isfinite(size)) return 0;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
}

std::string weight(double value, int decimals) { return fixed(value, decimals) + "\u202fkg"; }

std::string range(double low, double high, int decimals) {
  const std::string from = fixed(low, decimals), to = fixed(high, decimals);
  return from == to ? from : from + "–" + to;
}

std::string percent(double share) {
  double whole = std::round(share * 100);
  if (whole >= 100 && share < 1 - 1e-9) whole = 99;
  if (whole <= 0 && share > 1e-9) return "<\u202f1\u202f%";
  return fixed(whole, 0) + "\u202f%";
}

std::string point(const Vec2& p) {
  // What rounding left of a zero is written as one.
  const double least = 1e-9 * std::max(std::abs(p.x()), std::abs(p.y()));
  const auto coordinate = [least](double value) {
    if (std::abs(value) < least) value = 0;
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return with_minus_sign(digits);
  };
  return "(" + coordinate(p.x()) + ", " + coordinate(p.y()) + ")";
}

std::string sentence(const InputError& error) {
  std::string text = describe(error.place);
  text = text.empty() ? error.message : text + ": " + error.message;
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace evenlift::view
