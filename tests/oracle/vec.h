// Vectors of any numbers.
#pragma once

namespace oracle {

template <class T>
struct Vec {
  T x, y;
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator*(const Vec& a, const T& k) { return {a.x * k, a.y * k}; }
  friend Vec operator-(const Vec& a) { return {-a.x, -a.y}; }
  friend bool operator==(const Vec& a, const Vec& b) { return a.x == b.x && a.y == b.y; }
};

/// Positive if b is to the left of a.
template <class T>
T cross(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive if c is to the left of a -> b.
template <class T>
T orient(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c) {
  return cross(b - a, c - a);
}
template <class T>
int sign(const T& v) {
  return v > 0 ? 1 : v < 0 ? -1 : 0;
}

}  // namespace oracle
