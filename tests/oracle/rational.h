// Exact numbers for tests outside the oracle: rationals, without the headers of the library that
// computes them.
#pragma once

#include <compare>
#include <memory>

namespace oracle {

class Rational {
 public:
  Rational() : Rational(0) {}
  Rational(double value);  // exactly; finite
  explicit operator double() const;

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational operator-() const { return 0 - *this; }
  Rational& operator+=(const Rational& other) { return *this = *this + other; }
  Rational& operator-=(const Rational& other) { return *this = *this - other; }
  Rational& operator/=(const Rational& other) { return *this = *this / other; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);
  friend bool operator==(const Rational& a, const Rational& b) { return std::is_eq(a <=> b); }

  struct Value;  // the library's number
  explicit Rational(Value value);

 private:
  std::shared_ptr<const Value> value_;  // never changed, so that copies share it
  friend double nearest_double(const Rational& value);
};

/// Nearest double, ties to even.
double nearest_double(const Rational& value);

inline Rational abs(const Rational& value) { return value < 0 ? -value : value; }

}  // namespace oracle
