#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "numbers/number_text.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

constexpr int most_decimals = 9;

// With a minus sign, and the reader's decimal mark.
std::string with_marks(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
    text.replace(at, 1, "−");
  return as_read(std::move(text));
}

// In units of 10^-decimals.
std::string whole_units(const Decimal& decimal, int decimals, Toward toward = Toward::nearest) {
  const int zeros = decimal.exponent + decimals;
  if (zeros >= 0)
    return decimal.digits == 0
               ? "0"
               : std::to_string(decimal.digits) + std::string(static_cast<std::size_t>(zeros), '0');
  if (zeros < -18) return toward == Toward::up && decimal.digits > 0 ? "1" : "0";
  std::uint64_t unit = 1;
  for (int i = 0; i < -zeros; ++i) unit *= 10;
  const std::uint64_t rest = decimal.digits % unit;
  const bool more =
      toward == Toward::nearest ? rest >= unit - rest : toward == Toward::up && rest > 0;
  return std::to_string(decimal.digits / unit + (more ? 1 : 0));
}

// A value that only rounding puts beyond a decimal counts as the decimal.
double within_tolerance(double value, Toward toward) {
  return toward == Toward::down ? value * (1 + tau)
         : toward == Toward::up ? value * (1 - tau)
                                : value;
}

std::string with_point(std::string units, int decimals) {
  const auto places = static_cast<std::size_t>(decimals);
  if (units.size() <= places) units.insert(0, places + 1 - units.size(), '0');
  if (places > 0) units.insert(units.size() - places, 1, '.');
  return units;
}

bool is_zero(const std::string& units) { return units.find_first_not_of('0') == std::string::npos; }

// The exponent of the first power of ten above the absolute value; 0 for 0.
int magnitude(const Decimal& decimal) {
  return decimal.digits == 0
             ? 0
             : static_cast<int>(std::to_string(decimal.digits).size()) + decimal.exponent;
}

}  // namespace

std::string ascii_fixed(double value, int decimals) {
  if (!(std::fabs(value) < 1e15)) return shortest(value);
  const Decimal decimal = shortest_decimal(value);
  const std::string units = whole_units(decimal, decimals);
  return (decimal.negative && !is_zero(units) ? "-" : "") + with_point(units, decimals);
}

std::string fixed(double value, int decimals) { return with_marks(ascii_fixed(value, decimals)); }

std::string plain(double value) {
  return value == 0 ? "0" : with_marks(shortest(value));  // -0 is "0"
}

std::string significant(double value, int digits, Toward toward) {
  const Decimal decimal = shortest_decimal(within_tolerance(value, toward));
  if (decimal.digits == 0) return "0";
  const int decimals = digits - magnitude(decimal);
  const std::string units = whole_units(decimal, decimals, toward);
  const std::string sign = decimal.negative ? "-" : "";
  return plain(*read_number(sign + units + "e" + std::to_string(-decimals)));
}

int decimals_for(double largest) {
  const Decimal decimal = shortest_decimal(std::fabs(largest));
  if (decimal.digits == 0) return 0;
  constexpr int digits = 3;
  int decimals = digits - magnitude(decimal);
  // 99.95 becomes 100, which already has three digits.
  if (whole_units(decimal, decimals).size() > digits) --decimals;
  return std::clamp(decimals, 0, most_decimals);
}

std::string amount(double value, double largest, Toward toward) {
  constexpr double least_fixed = 1e-6;  // below, fixed() would show fewer than three digits
  constexpr double most_fixed = 1e12;   // from here on, too many to read
  const double size = std::fabs(largest);
  if (size < least_fixed || size >= most_fixed) return significant(value, 3, toward);
  if (toward == Toward::nearest) return fixed(value, decimals_for(largest));
  const int decimals = decimals_for(largest);
  return as_read(with_point(
      whole_units(shortest_decimal(within_tolerance(value, toward)), decimals, toward), decimals));
}

std::string load_in_words(double value, double largest, const Units& units) {
  return with_weight_unit(amount(value, largest), units);
}

std::string load_in_words(double value, const Units& units, Toward toward) {
  return with_weight_unit(amount(value, value, toward), units);
}

std::string length_in_words(double length, const Units& units, Toward toward) {
  return with_length_unit(amount(length, length, toward), units);
}

std::string amounts(double low, double high, double largest) {
  const std::string from = amount(low, largest), to = amount(high, largest);
  return from == to ? from : from + "–" + to;
}

std::string load_in_words(double low, double high, double largest, const Units& units) {
  return with_weight_unit(amounts(low, high, largest), units);
}

std::string amounts(const LoadRange& load, double largest) {
  if (load.least == load.greatest) return amount(load.least, largest);
  const std::string from = amount(load.least, largest, Toward::down),
                    to = amount(load.greatest, largest, Toward::up);
  return from == to ? from : from + "–" + to;
}

std::string load_in_words(const LoadRange& load, double largest, const Units& units) {
  return with_weight_unit(amounts(load, largest), units);
}

std::string amounts(LoadModel model, const LoadRange& load, double largest) {
  if (has_ranges(model)) return amounts(load, largest);
  return "≤\u00A0" + amount(load.greatest, largest, Toward::up);
}

std::string load_in_words(LoadModel model, const LoadRange& load, double largest,
                          const Units& units) {
  return with_weight_unit(amounts(model, load, largest), units);
}

std::string with_weight_unit(const std::string& number, const Units& units) {
  return number + "\u00A0" + std::string(name(units.weight));
}

std::string given_weight(double weight, const Units& units) {
  constexpr int digits = 6;
  const int whole = magnitude(shortest_decimal(weight));
  return with_weight_unit(significant(weight, std::max(digits, whole)), units);
}

std::string with_length_unit(const std::string& number, const Units& units) {
  return units.length == LengthUnit::none ? number
                                          : number + "\u00A0" + std::string(name(units.length));
}

std::string promised_length(double length, const Units& units) {
  Decimal decimal = shortest_decimal(length);
  constexpr std::uint64_t two_digits = 100;
  for (; decimal.digits >= two_digits; ++decimal.exponent) decimal.digits /= 10;
  const std::string text = std::to_string(decimal.digits) + "e" + std::to_string(decimal.exponent);
  const std::string number = plain(*read_number(text));
  return units.length == LengthUnit::none ? say("{length} units", {number})
                                          : with_length_unit(number, units);
}

std::string points_ahead(double share, double other) {
  const auto hundredths = [](double of) { return std::round(10000 * of); };
  return say("{number} points", {plain((hundredths(share) - hundredths(other)) / 100)});
}

std::string percentage(double share, int decimals) {
  if (share <= tau) return "0\u00A0%";
  if (share >= 1 - tau) return "100\u00A0%";
  const std::string units = whole_units(shortest_decimal(share), decimals + 2);
  const std::string all = std::string("100") + std::string(static_cast<std::size_t>(decimals), '0');
  std::string text = with_point(units, decimals);
  if (is_zero(units)) text = "<\u00A0" + with_point("1", decimals);
  if (units == all) text = ">\u00A0" + with_point(std::string(all.size() - 1, '9'), decimals);
  return as_read(std::move(text)) + "\u00A0%";
}

std::string count_of(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + std::string(translated(n == 1 ? one : many));
}

std::string ratio_in_words(double ratio) { return fixed(ratio, 3); }

std::string given_point(const Vec2& point) {
  // Coordinates rounded to zero have no minus sign.
  const double least = 1e-9 * max_norm(point);
  const auto coordinate = [&](double value) {
    return significant(std::fabs(value) < least ? 0 : value, 6);
  };
  return say("({x}, {y})", {coordinate(point.x), coordinate(point.y)});
}

std::string point_in_words(const Vec2& point, int decimals) {
  return say("({x}, {y})", {fixed(point.x, decimals), fixed(written_y(point.y), decimals)});
}

int coordinate_decimals(const Points& vertices) {
  return std::min(decimals_for(max_norm(bounding_box(vertices).size())) + 1, most_decimals);
}

int margin_decimals(double margin) {
  return std::fabs(margin) < tau ? 0 : std::max(3, decimals_for(margin));
}

std::string margin_in_words(double margin) { return fixed(margin, margin_decimals(margin)); }

}  // namespace evenlift
