// Double-double arithmetic: the unevaluated sum hi + lo of two doubles has about 106 bits (T. J.
// Dekker, A floating-point technique for extending the available precision, 1971). The operations
// need strict IEEE arithmetic without fused multiply-add, which the build guarantees. Callers must
// avoid products that are below 2^-969 in size but not 0, since these lose bits.
#pragma once

namespace evenlift {

struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double value) : hi(value) {}
  DoubleDouble(double high, double low) : hi(high), lo(low) {}

  double to_double() const { return hi + lo; }
  bool is_double() const { return lo == 0; }
};

// a + b exactly, for |a| >= |b|. |lo| is at most half a unit in the last place of hi.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

// a - b exactly.
inline DoubleDouble two_difference(double a, double b) { return two_sum(a, -b); }

// The product a b, exactly, for |a|, |b| < 2^996.
inline DoubleDouble two_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double product = a * b;
  const double ta = splitter * a, tb = splitter * b;
  const double a_high = ta - (ta - a), b_high = tb - (tb - b);
  const double a_low = a - a_high, b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  DoubleDouble high = two_sum(a.hi, b.hi);
  const DoubleDouble low = two_sum(a.lo, b.lo);
  high = quick_two_sum(high.hi, high.lo + low.hi);
  return quick_two_sum(high.hi, high.lo + low.lo);
}

inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(a.hi, b.hi);
  return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q1 = a.hi / b.hi;
  DoubleDouble remainder = a - DoubleDouble(q1) * b;
  const double q2 = remainder.hi / b.hi;
  remainder = remainder - DoubleDouble(q2) * b;
  return quick_two_sum(q1, q2) + DoubleDouble(remainder.hi / b.hi);
}

}  // namespace evenlift
