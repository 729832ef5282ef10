#include "balanced/set_oracle.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace set_oracle {
namespace {

using Space = std::array<double, 3>;
constexpr double tau = 1e-9;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1]}; }
Point operator*(double s, const Point& a) { return {s * a[0], s * a[1]}; }
double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
double size(const Point& a) { return std::sqrt(dot(a, a)); }

std::vector<Point> counter_clockwise(const Object& object) {
  std::vector<Point> ring = object.vertices;
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  if (twice < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

double area(const std::vector<Point>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return twice / 2;
}

// By wrapping: the next corner has all other points on its left.
std::vector<Point> hull(const std::vector<Point>& points) {
  std::vector<Point> corners{*std::min_element(points.begin(), points.end())};
  while (corners.size() <= points.size()) {
    Point next = corners.back();
    for (const Point& p : points) {
      const double side = cross(next - corners.back(), p - corners.back());
      const bool farther = size(p - corners.back()) > size(next - corners.back());
      if (next == corners.back() || side < 0 || (side == 0 && farther)) next = p;
    }
    if (next == corners.front()) break;
    corners.push_back(next);
  }
  return corners;
}

double from_segment(const Point& a, const Point& b, const Point& p) {
  const Point along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return size(p - (a + t * along));
}

Space minus(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double inner(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Space outer(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Whether a counter-clockwise ring's vertex is convex and turns by more than 15 degrees.
bool is_corner(const std::vector<Point>& ring, std::size_t v) {
  const std::size_t n = ring.size();
  const Point in = ring[v] - ring[(v + n - 1) % n], out = ring[(v + 1) % n] - ring[v];
  const double cosine = (in[0] * out[0] + in[1] * out[1]) / (size(in) * size(out));
  return cross(in, out) > 0 && cosine < (std::sqrt(6) + std::sqrt(2)) / 4 - tau;
}

bool is_notch(std::vector<Point> ring, std::size_t v) {
  std::reverse(ring.begin(), ring.end());  // what is reflex, is convex on the way back
  return is_corner(ring, ring.size() - 1 - v);
}

// From a point on an edge along the outline to the nearest corner, until a notch.
double to_corner(const std::vector<Point>& ring, const Point& p, std::size_t edge) {
  const std::size_t n = ring.size();
  double least = std::numeric_limits<double>::infinity();
  for (const bool on : {true, false}) {
    Point at = p;
    double way = 0;
    std::size_t v = on ? (edge + 1) % n : edge;
    for (std::size_t passed = 0; passed < n; ++passed) {
      way += size(ring[v] - at);
      if (is_corner(ring, v)) least = std::min(least, way);
      if (is_corner(ring, v) || is_notch(ring, v)) break;
      at = ring[v];
      v = (v + (on ? 1 : n - 1)) % n;
    }
  }
  return least;
}

std::vector<Space> wrenches(const Object& object, const std::vector<Point>& robots, double clear) {
  const std::vector<Point> ring = counter_clockwise(object);
  const std::size_t n = ring.size();
  assert(n >= 3);
  const double near = tau * diameter(object), r = radius(object);
  std::vector<Space> all;
  const auto touch = [&](const Point& p, std::size_t edge) {
    const Point along = ring[(edge + 1) % n] - ring[edge];
    const Point normal{-along[1] / size(along), along[0] / size(along)};
    all.push_back({normal[0], normal[1], cross(p - object.centre, normal) / r});
  };
  for (const Point& p : robots) {
    std::optional<std::size_t> vertex;
    std::size_t edge = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (size(p - ring[i]) <= near) vertex = i;
      if (from_segment(ring[i], ring[(i + 1) % n], p) <
          from_segment(ring[edge], ring[(edge + 1) % n], p))
        edge = i;
    }
    if (!vertex) {
      if (to_corner(ring, p, edge) >= clear - near) touch(p, edge);
      continue;
    }
    const Point in = ring[*vertex] - ring[(*vertex + n - 1) % n],
                out = ring[(*vertex + 1) % n] - ring[*vertex];
    const double turn = cross(in, out) / (size(in) * size(out));
    if (turn > tau) continue;
    if (!is_notch(ring, *vertex) && to_corner(ring, p, *vertex) < clear - near) continue;
    touch(ring[*vertex], *vertex);
    if (turn < -tau) touch(ring[*vertex], (*vertex + n - 1) % n);
  }
  return all;
}

}  // namespace

double diameter(const Object& object) {
  double greatest = 0;
  for (const Point& v : object.vertices)
    for (const Point& w : object.vertices) greatest = std::max(greatest, size(v - w));
  return greatest;
}

double radius(const Object& object) {
  double farthest = 0;
  for (const Point& v : object.vertices) farthest = std::max(farthest, size(v - object.centre));
  return farthest;
}

bool inside_hull(const Object& object, const Point& p) {
  const std::vector<Point> corners = hull(object.vertices);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point along = corners[(i + 1) % corners.size()] - corners[i];
    if (cross(along, p - corners[i]) <= tau * diameter(object) * size(along)) return false;
  }
  return true;
}

double away_from_outline(const Object& object, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t n = object.vertices.size();
  for (std::size_t i = 0; i < n; ++i)
    least = std::min(least, from_segment(object.vertices[i], object.vertices[(i + 1) % n], p));
  return least;
}

double imbalance(const Object& object, const std::vector<Point>& robots) {
  Point sum{0, 0};
  for (const Point& p : robots) sum = sum + (p - object.centre);
  return size(sum) / static_cast<double>(robots.size());
}

double coverage(const Object& object, const std::vector<Point>& robots) {
  const std::vector<Point> corners = hull(robots);
  if (corners.size() < 3) return 0;
  std::vector<Point> part = object.vertices;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], along = corners[(i + 1) % corners.size()] - a;
    std::vector<Point> kept;
    for (std::size_t j = 0; j < part.size(); ++j) {
      const Point p = part[j], q = part[(j + 1) % part.size()];
      const double at_p = cross(along, p - a), at_q = cross(along, q - a);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p < 0) != (at_q < 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    part = kept;
    if (part.empty()) return 0;
  }
  return std::fabs(area(part) / area(object.vertices));
}

std::optional<double> margin(const Object& object, const std::vector<Point>& robots, double clear) {
  const std::vector<Space> w = wrenches(object, robots, clear);
  constexpr double flat = 1e-9;
  std::optional<double> least;
  for (std::size_t i = 0; i < w.size(); ++i)
    for (std::size_t j = 0; j < w.size(); ++j)
      for (std::size_t k = 0; k < w.size(); ++k) {
        if (j == i || k <= i || k == j) continue;
        Space normal = outer(minus(w[j], w[i]), minus(w[k], w[i]));
        const double length = std::sqrt(inner(normal, normal));
        if (length < flat) continue;
        for (double& x : normal) x /= length;
        const double height = inner(normal, w[i]);
        double deepest = 0;
        bool is_facet = true;
        for (const Space& p : w) {
          const double above = inner(normal, p) - height;
          is_facet = is_facet && above <= flat;
          deepest = std::min(deepest, above);
        }
        if (is_facet && deepest < -flat) least = std::min(least.value_or(height), height);
      }
  return least;
}

double least_distance(const std::vector<Point>& robots) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < robots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, size(robots[i] - robots[j]));
  return least;
}

std::vector<Point> stands(const Object& object) {
  std::vector<Point> ring = counter_clockwise(object);
  std::size_t first = 0;
  double farthest = radius(object);
  const double near = tau * diameter(object);
  bool found = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (size(ring[i] - object.centre) < farthest - near) continue;
    if (!found || ring[i] < ring[first]) first = i;
    found = true;
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
  const std::size_t n = ring.size();
  assert(n >= 3);
  double around = 0;
  for (std::size_t i = 0; i < n; ++i) around += size(ring[(i + 1) % n] - ring[i]);
  std::vector<Point> all;
  for (int j = 0; j < 64; ++j) {
    double left = (j + 0.5) / 64 * around;
    std::size_t i = 0;
    const auto side = [&] { return size(ring[(i + 1) % n] - ring[i]); };
    for (; left > side(); ++i) left -= side();
    const Point along = ring[(i + 1) % n] - ring[i];
    all.push_back(ring[i] + left / size(along) * along);
  }
  std::vector<Point> reflex;
  for (std::size_t i = 0; i < n; ++i) {
    const Point in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
    if (cross(in, out) < -tau * size(in) * size(out)) reflex.push_back(ring[i]);
  }
  if (reflex.size() <= 64) all.insert(all.end(), reflex.begin(), reflex.end());
  return all;
}

std::vector<std::array<Point, 2>> even_chords(const Object& object, const Point& m) {
  const std::vector<Point>& v = object.vertices;
  std::vector<std::array<Point, 2>> chords;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      // v[i] + s a = 2 m - v[j] - t b
      const Point a = v[(i + 1) % v.size()] - v[i], b = v[(j + 1) % v.size()] - v[j];
      const Point gap = 2 * m - v[j] - v[i];
      const double determinant = cross(a, b);
      if (std::fabs(determinant) < 1e-7 * size(a) * size(b)) continue;
      const double s = cross(gap, b) / determinant, t = cross(a, gap) / determinant;
      if (s < 0 || s > 1 || t < 0 || t > 1) continue;
      const Point p = v[i] + s * a;
      chords.push_back({p, 2 * m - p});
    }
  return chords;
}

}  // namespace set_oracle
