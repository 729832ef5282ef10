// std::from_chars gives the same doubles, and can replace this code once all supported Emscripten
// versions have it for doubles.
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <optional>

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

}  // namespace evenlift
