#include "oracle/rational.h"

#include <utility>

#include "oracle/exact.h"

namespace oracle {

struct Rational::Value {
  Exact number;
};

Rational::Rational(double value) : Rational(Value{Exact(value)}) {}
Rational::Rational(Value value) : value_(std::make_shared<const Value>(std::move(value))) {}
Rational::operator double() const { return static_cast<double>(value_->number); }

Rational operator+(const Rational& a, const Rational& b) {
  return Rational(Rational::Value{a.value_->number + b.value_->number});
}
Rational operator-(const Rational& a, const Rational& b) {
  return Rational(Rational::Value{a.value_->number - b.value_->number});
}
Rational operator*(const Rational& a, const Rational& b) {
  return Rational(Rational::Value{a.value_->number * b.value_->number});
}
Rational operator/(const Rational& a, const Rational& b) {
  return Rational(Rational::Value{a.value_->number / b.value_->number});
}
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return a.value_->number.compare(b.value_->number) <=> 0;
}

double nearest_double(const Rational& value) { return nearest_double(value.value_->number); }

}  // namespace oracle
