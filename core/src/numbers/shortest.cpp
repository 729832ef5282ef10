// std::from_chars gives the same doubles, and can replace this code once all supported Emscripten
// versions have it for doubles.
#include <cassert>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "evenlift/numbers.h"
#include "exact/pseudo_angle.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "a product of doubles must be rounded once, to a double");

// At most 768 digits decide the rounding, so beyond `limit` it matters only whether a digit other
// than 0 follows.
struct SignificantDigits {
  static constexpr int limit = 800;
  char text[limit];
  int count = 0;
  bool more = false;          // a digit other than 0 follows
  std::int64_t exponent = 0;  // the value is text * 10^exponent (a little more if `more`)

  void take(char digit, bool after_point) {
    if (count == 0 && digit == '0') {
      if (after_point) --exponent;  // leading zeros only move the point
      return;
    }
    if (count < limit) {
      text[count++] = digit;
      if (after_point) --exponent;
    } else {
      more = more || digit != '0';
      if (!after_point) ++exponent;
    }
  }
};

// If both the digits and the power of ten are doubles, one operation rounds correctly.
std::optional<double> quick_value(const SignificantDigits& digits) {
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (digits.count > 15 || digits.exponent > 22 || digits.exponent < -22) return std::nullopt;
  std::uint64_t integer = 0;  // below 10^15 < 2^53
  for (int i = 0; i < digits.count; ++i) {
    integer = 10 * integer + static_cast<unsigned>(digits.text[i] - '0');
  }
  double value = static_cast<double>(integer);
  if (digits.exponent < 0) value /= powers[-digits.exponent];
  if (digits.exponent > 0) value *= powers[digits.exponent];
  return value;
}

// strtod rounds correctly in current glibc, musl and others. It receives no decimal point, which
// would depend on the locale.
double library_value(const SignificantDigits& digits) {
  char text[SignificantDigits::limit + 16];
  int size = 0;
  for (; size < digits.count; ++size) text[size] = digits.text[size];
  std::int64_t exponent = digits.exponent;
  if (digits.more) {
    text[size++] = '1';
    --exponent;
  }
  text[size++] = 'e';
  if (exponent < 0) text[size++] = '-';
  // At most 4 digits: the caller handles larger exponents.
  const unsigned power = static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
  for (unsigned unit = 1000; unit > 0; unit /= 10) {
    text[size++] = static_cast<char>('0' + power / unit % 10);
  }
  text[size] = '\0';
  return std::strtod(text, nullptr);
}

// Without the sign; infinity beyond the largest double.
double nearest_double(const SignificantDigits& digits) {
  if (digits.count == 0) return 0;
  if (const std::optional<double> value = quick_value(digits)) return *value;
  const std::int64_t magnitude = digits.count + digits.exponent;  // value < 10^magnitude
  if (magnitude > 310) return HUGE_VAL;
  if (magnitude < -325) return 0;  // below half of the smallest subnormal
  return library_value(digits);
}

}  // namespace

ScannedNumber scan_number(std::string_view text) {
  const ScannedNumber none{ScannedNumber::Kind::none, 0, 0};
  std::size_t at = 0;
  const auto digit_here = [&] { return at < text.size() && is_digit(text[at]); };

  const bool negative = !text.empty() && text[0] == '-';
  if (negative || (!text.empty() && text[0] == '+')) ++at;

  SignificantDigits digits;
  bool any = false;
  for (; digit_here(); ++at, any = true) digits.take(text[at], false);
  if (at < text.size() && text[at] == '.') {
    const std::size_t point = at++;
    for (; digit_here(); ++at, any = true) digits.take(text[at], true);
    if (!any) at = point;
  }
  if (!any) return none;

  const std::size_t mantissa_end = at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    const bool below = at < text.size() && text[at] == '-';
    if (below || (at < text.size() && text[at] == '+')) ++at;
    if (digit_here()) {
      // Saturates far beyond any exponent that the digits can compensate.
      constexpr std::int64_t exponent_limit = std::int64_t{1} << 40;
      std::int64_t exponent = 0;
      for (; digit_here(); ++at) {
        if (exponent < exponent_limit) exponent = 10 * exponent + (text[at] - '0');
      }
      digits.exponent += below ? -exponent : exponent;
    } else {
      at = mantissa_end;  // the 'e' begins something else
    }
  }

  const double size = nearest_double(digits);
  if (size == HUGE_VAL) return {ScannedNumber::Kind::too_large, at, 0};
  return {ScannedNumber::Kind::finite, at, negative ? -size : size};
}

std::optional<double> read_number(std::string_view text) {
  const ScannedNumber number = scan_number(text);
  if (number.kind != ScannedNumber::Kind::finite || number.length != text.size())
    return std::nullopt;
  return number.value;
}

std::optional<std::uint64_t> read_whole(std::string_view text) {
  if (text.empty()) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    const auto digit = static_cast<std::uint64_t>(c - '0');
    if (value > (~std::uint64_t{0} - digit) / 10) return std::nullopt;
    value = 10 * value + digit;
  }
  return value;
}

// --- Shortest decimal numbers by Schubfach (R. Giulietti, The Schubfach way to render doubles, 2020).
// std::to_chars gives the same results and can replace this once every supported Emscripten has it.

namespace {

struct Uint128 {
  std::uint64_t high;
  std::uint64_t low;
};

Uint128 multiply(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t a0 = a & 0xffffffffu, a1 = a >> 32;
  const std::uint64_t b0 = b & 0xffffffffu, b1 = b >> 32;
  const std::uint64_t low = a0 * b0;
  const std::uint64_t middle = a1 * b0 + (low >> 32);
  const std::uint64_t other = a0 * b1 + (middle & 0xffffffffu);
  return {a1 * b1 + (middle >> 32) + (other >> 32), (other << 32) | (low & 0xffffffffu)};
}

// floor(log10(2^e)), floor(log10(3/4 2^e)) and floor(log2(10^e)), for all e of doubles. In C++20,
// shifts of negative numbers round down.
constexpr int floor_log10_pow2(int e) { return (e * 1262611) >> 22; }
constexpr int floor_log10_three_quarters_pow2(int e) { return (e * 1262611 - 524031) >> 22; }
constexpr int floor_log2_pow10(int e) { return (e * 1741647) >> 19; }

// 10^e for e from -292 to 324, as 128-bit numbers g with 2^127 <= g < 2^128, rounded up: g =
// ceil(10^e / 2^(floor_log2_pow10(e) - 127)). Computed at first use: constants would add 10 KB to
// the page, even compressed.
class PowersOfTen {
 public:
  static constexpr int least = -292;
  static constexpr int greatest = 324;

  PowersOfTen() {
    // 10^e and 5^e differ by a power of two. For e >= 0, products are exact; below, quotients are
    // floor(2^1023 / 5^-e): dividing one again loses nothing.
    Limbs power{};
    power.limb[0] = 1;
    for (int e = 0; e <= greatest; ++e, power.multiply_by_5()) store(e, power, false);
    Limbs quotient{};
    quotient.limb[Limbs::count - 1] = 1u << 31;
    for (int e = -1; e >= least; --e) {
      quotient.divide_by_5();
      store(e, quotient, true);
    }
  }

  const Uint128& operator[](int e) const { return powers_[e - least]; }

 private:
  struct Limbs {
    static constexpr int count = 32;  // 5^324 has 753 bits; 2^1023 / 5^292 keeps 345
    std::uint32_t limb[count];        // lowest first

    void multiply_by_5() {
      std::uint64_t carry = 0;
      for (std::uint32_t& part : limb) {
        carry += std::uint64_t{5} * part;
        part = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
    }
    void divide_by_5() {
      std::uint64_t remainder = 0;
      for (int i = count; i-- > 0;) {
        remainder = (remainder << 32) | limb[i];
        limb[i] = static_cast<std::uint32_t>(remainder / 5);
        remainder %= 5;
      }
    }
    bool bit(int i) const { return i >= 0 && ((limb[i / 32] >> (i % 32)) & 1u) != 0; }
  };

  void store(int e, const Limbs& number, bool inexact) {
    int top = 32 * Limbs::count - 1;
    while (!number.bit(top)) --top;
    Uint128 g{0, 0};
    for (int i = 0; i < 64; ++i) {
      g.high = (g.high << 1) | (number.bit(top - i) ? 1u : 0u);
      g.low = (g.low << 1) | (number.bit(top - 64 - i) ? 1u : 0u);
    }
    for (int i = top - 128; i >= 0 && !inexact; --i) inexact = number.bit(i);
    if (inexact && ++g.low == 0) ++g.high;
    powers_[e - least] = g;
  }

  Uint128 powers_[greatest - least + 1];
};

const Uint128& power_of_ten(int e) {
  static const PowersOfTen powers;
  return powers[e];
}

// floor(g * x / 2^128), with the lowest bit set if at least 2^-63 was cut off: "round to odd". Less
// may come from rounding g.
std::uint64_t product_rounded_to_odd(const Uint128& g, std::uint64_t x) {
  const Uint128 low = multiply(g.low, x);
  Uint128 high = multiply(g.high, x);
  high.low += low.high;
  if (high.low < low.high) ++high.high;
  return high.high | (high.low > 1 ? 1u : 0u);
}

struct UnsignedDecimal {
  std::uint64_t digits;
  int exponent;
};

// The result may end in zeros. `at_binade`: the next smaller double is nearer than the next larger
// one.
UnsignedDecimal schubfach(std::uint64_t significand, int exponent, bool at_binade) {
  const bool even = significand % 2 == 0;  // then the rounding interval includes its ends
  const int k = at_binade ? floor_log10_three_quarters_pow2(exponent) : floor_log10_pow2(exponent);
  const int h = exponent + floor_log2_pow10(-k) + 1;
  const Uint128& g = power_of_ten(-k);

  // The value and the ends of its rounding interval, times 4 / 10^k.
  const std::uint64_t value = product_rounded_to_odd(g, (4 * significand) << h);
  const std::uint64_t left =
      product_rounded_to_odd(g, (4 * significand - (at_binade ? 1 : 2)) << h) + (even ? 0 : 1);
  const std::uint64_t right =
      product_rounded_to_odd(g, (4 * significand + 2) << h) - (even ? 0 : 1);

  const std::uint64_t s = value / 4;
  if (s >= 10) {  // one digit fewer if exactly one neighbour lies inside
    const std::uint64_t tens = s / 10;
    const bool lower_inside = left <= 40 * tens;
    const bool upper_inside = 40 * tens + 40 <= right;
    if (lower_inside != upper_inside) return {tens + (upper_inside ? 1 : 0), k + 1};
  }
  const bool lower_inside = left <= 4 * s;
  const bool upper_inside = 4 * s + 4 <= right;
  if (lower_inside != upper_inside) return {s + (upper_inside ? 1 : 0), k};
  const std::uint64_t middle = 4 * s + 2;  // both inside: the nearer one, or the even one in a tie
  const bool up = value > middle || (value == middle && s % 2 == 1);
  return {s + (up ? 1 : 0), k};
}

}  // namespace

Decimal shortest_decimal(double value) {
  assert(std::isfinite(value));
  const auto bits = to_bits(value);
  const bool negative = (bits >> 63) != 0;
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased == 0 && fraction == 0) return {0, 0, negative};

  const std::uint64_t significand = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
  const int exponent = biased == 0 ? -1074 : biased - 1075;
  UnsignedDecimal found;
  if (exponent <= 0 && exponent > -53 &&
      (significand & ((std::uint64_t{1} << -exponent) - 1)) == 0) {
    found = {significand >> -exponent, 0};  // has no shorter decimal below 2^53
  } else {
    found = schubfach(significand, exponent, fraction == 0 && biased > 1);
  }
  while (found.digits % 10 == 0) {
    found.digits /= 10;
    ++found.exponent;
  }
  return {found.digits, found.exponent, negative};
}

// As Number::toString in the page's scripts, except that -0 becomes "-0.0": a JSON reader would
// read "-0" as an integer and lose the sign.
void append_shortest(std::string& text, double value) {
  const Decimal decimal = shortest_decimal(value);
  if (decimal.digits == 0) {
    text += decimal.negative ? "-0.0" : "0";
    return;
  }
  char digits[20];
  int count = 0;
  for (std::uint64_t rest = decimal.digits; rest != 0; rest /= 10) {
    digits[19 - count++] = static_cast<char>('0' + rest % 10);
  }
  const std::string_view shown(digits + 20 - count, static_cast<std::size_t>(count));
  const int point = count + decimal.exponent;  // digits before the decimal point
  if (decimal.negative) text += '-';

  if (count <= point && point <= 21) {
    text += shown;
    text.append(static_cast<std::size_t>(point - count), '0');
  } else if (0 < point && point <= 21) {
    text += shown.substr(0, static_cast<std::size_t>(point));
    text += '.';
    text += shown.substr(static_cast<std::size_t>(point));
  } else if (-6 < point && point <= 0) {
    text += "0.";
    text.append(static_cast<std::size_t>(-point), '0');
    text += shown;
  } else {
    text += shown[0];
    if (count > 1) {
      text += '.';
      text += shown.substr(1);
    }
    text += point > 0 ? "e+" : "e-";
    text += std::to_string(point > 0 ? point - 1 : 1 - point);
  }
}

std::string shortest(double value) {
  std::string text;
  append_shortest(text, value);
  return text;
}

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) >= 0xa0;
  const bool beyond = first == 0xf4 && byte(1) >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

bool is_line_of_text(std::string_view line) {
  while (!line.empty()) {
    const std::size_t length = utf8_length(line);
    const auto first = static_cast<unsigned char>(line.front());
    const bool control = (first < 0x20 && first != '\t' && first != '\r') || first == 0x7f;
    if (length == 0 || control) return false;
    line.remove_prefix(length);
  }
  return true;
}

}  // namespace evenlift
