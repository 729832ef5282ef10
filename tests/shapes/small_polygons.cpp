#include "shapes/small_polygons.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace small_polygons {
namespace {

using oracle::Point;
using Points = std::vector<Point>;

class Draw {  // splitmix64
 public:
  explicit Draw(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 12345) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool chance(int percent) { return below(100) < percent; }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  template <class T, std::size_t n>
  T one_of(const T (&list)[n]) {
    return list[below(static_cast<int>(n))];
  }

 private:
  std::uint64_t state_;
};

/// (cos, sin) of 2 pi f, f in [0, 1]: Taylor's series for a 16th, squared four times.
Point turn(double f) {
  const double x = f * 6.283185307179586 / 16;
  double c = 1, s = x, term = x;
  for (int k = 2; k < 20; ++k) {
    term = term * x / k;
    (k % 2 ? s : c) += (k % 4 < 2 ? term : -term);
  }
  for (int k = 0; k < 4; ++k) {
    const double cc = c * c - s * s;
    s = 2 * c * s;
    c = cc;
  }
  return {c, s};
}

Point polar(double f, double radius) {
  const Point u = turn(f - std::floor(f));
  return {u[0] * radius, u[1] * radius};
}

double cross(const Point& o, const Point& a, const Point& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

Points regular(Draw& draw) {
  const int n = draw.between(3, 12);
  const double phase = draw.chance(50) ? 0 : draw.unit();
  Points p;
  for (int i = 0; i < n; ++i) p.push_back(polar(phase + static_cast<double>(i) / n, 10));
  return p;
}

Points on_ellipse(Draw& draw) {
  const int n = draw.between(3, 14);
  std::vector<double> f;
  for (int i = 0; i < n; ++i) f.push_back(draw.unit());
  std::sort(f.begin(), f.end());
  const double flat = draw.between(0.2, 1.0);
  Points p;
  p.reserve(f.size());
  for (double g : f) {
    const Point q = polar(g, 10);
    p.push_back({q[0], q[1] * flat});
  }
  return p;
}

Points star(Draw& draw) {
  const int n = draw.chance(10) ? draw.between(20, 30) : draw.between(5, 12);
  const bool even = draw.chance(30);  // regular, with every possible tie
  const double inner = draw.between(2.0, 8.0);
  Points p;
  for (int i = 0; i < n; ++i)
    p.push_back(
        polar(static_cast<double>(i) / n, even ? (i % 2 ? inner : 10) : draw.between(1.0, 10.0)));
  return p;
}

Points comb(Draw& draw) {
  // A C-shaped frame with teeth on both arms, or one arm alone.
  const int teeth = draw.between(1, 4);
  const bool even = draw.chance(50);
  const auto height = [&] { return even ? 4.0 : draw.between(2.0, 4.5); };
  Points p{{0, 0}, {2.0 * teeth + 1, 0}};
  if (draw.chance(50)) {
    for (int i = teeth; i-- > 0;) {
      p.push_back({2.0 * i + 1.5, height()});
      p.push_back({2.0 * i + 0.5, 1});
    }
    return p;
  }
  for (int i = teeth; i-- > 0;) {
    p.push_back({2.0 * i + 1.5, height()});
    p.push_back({2.0 * i + 1, 1});
  }
  for (int i = 0; i < teeth; ++i) {
    p.push_back({2.0 * i + 1, 9});
    p.push_back({2.0 * i + 1.5, 10 - height()});
  }
  p.push_back({2.0 * teeth + 1, 10});
  p.push_back({0, 10});
  return p;
}

Points spiral(Draw& draw) {
  const int steps = draw.between(5, 9);
  const double turns = draw.between(0.6, 1.6), grow = draw.between(1.0, 2.0);
  const auto radius = [&](int i) { return 3 + grow * i; };
  const double width = grow * 0.4;
  Points p;
  for (int i = 0; i < steps; ++i) p.push_back(polar(turns * i / steps, radius(i) + width));
  for (int i = steps; i-- > 0;) p.push_back(polar(turns * i / steps, radius(i)));
  return p;
}

/// A closed walk through the points: crossing edges are reconnected until there are none.
Points untangled(Points p) {
  const std::size_t n = p.size();
  for (int round = 0; round < 400; ++round) {
    bool crossed = false;
    for (std::size_t i = 0; i < n && !crossed; ++i) {
      for (std::size_t j = i + 2; j < n && !crossed; ++j) {
        if (i == 0 && j == n - 1) continue;
        const Point &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
        crossed = cross(a, b, c) * cross(a, b, d) <= 0 && cross(c, d, a) * cross(c, d, b) <= 0;
        if (crossed)
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      }
    }
    if (!crossed) break;
  }
  return p;
}

Points random_simple(Draw& draw) {
  const int n = draw.chance(8) ? draw.between(16, 30) : draw.between(4, 12);
  Points p;
  for (int i = 0; i < n; ++i) {
    const double x = draw.between(0.0, 10.0);
    p.push_back({x, draw.between(0.0, 10.0)});
  }
  return untangled(p);
}

Points on_grid(Draw& draw) {
  const int n = draw.between(4, 12), side = draw.between(2, 8);
  Points p;
  while (static_cast<int>(p.size()) < std::min(n, side * side)) {
    const int x = draw.between(0, side);
    const Point q{2.0 * x, 2.0 * draw.between(0, side)};
    if (std::find(p.begin(), p.end(), q) == p.end()) p.push_back(q);
  }
  return untangled(p);
}

/// Upright and level edges; often mirror-symmetric.
Points staircase(Draw& draw) {
  const int columns = draw.between(1, 5);
  const bool mirrored = draw.chance(50);
  std::vector<int> top;
  top.reserve(static_cast<std::size_t>(columns));
  for (int i = 0; i < columns; ++i) top.push_back(draw.between(1, 5));
  if (mirrored)
    for (int i = 0; i < columns; ++i)
      top[static_cast<std::size_t>(columns - 1 - i)] = top[static_cast<std::size_t>(i)];
  Points p{{0, 0}, {2.0 * columns, 0}};
  for (int i = columns; i-- > 0;) {
    const double h = 2.0 * top[static_cast<std::size_t>(i)];
    if (i + 1 < columns && top[static_cast<std::size_t>(i)] == top[static_cast<std::size_t>(i) + 1])
      p.pop_back();
    else
      p.push_back({2.0 * (i + 1), h});
    p.push_back({2.0 * i, h});
  }
  return p;
}

/// About the vertical through 0, or about the point 0.
Points symmetric(Draw& draw) {
  const int k = draw.between(2, 6);
  Points half;
  for (int i = 0; i < k; ++i) {
    const double radius = draw.between(2.0, 10.0);
    const Point q = polar((i + draw.unit() * 0.8) / (2.0 * k) - 0.25, radius);
    half.push_back(draw.chance(50) ? q : Point{std::round(q[0]), std::round(q[1])});
  }
  const bool mirror = draw.chance(60);
  Points p = half;
  for (std::size_t i = 0; i < half.size(); ++i) {
    const Point q = mirror ? half[half.size() - 1 - i] : half[i];
    p.push_back({-q[0], mirror ? q[1] : -q[1]});
  }
  return p;
}

/// In the exact middle of edges, if coordinates permit.
void add_straight_vertices(Points& p, Draw& draw) {
  for (std::size_t i = 0; i < p.size() && p.size() < 30; ++i) {
    if (!draw.chance(30)) continue;
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    const Point middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
    ++i;
  }
}

/// Hard for doubles. C changes too, if given.
std::string transform(Points& p, std::optional<Point>& c, Draw& draw) {
  const auto each = [&](auto change) {
    for (Point& q : p) q = change(q);
    if (c) c = change(*c);
  };
  switch (draw.below(12)) {
    case 0: {  // an awkward angle
      const Point u = turn(draw.unit());
      each([&](const Point& q) {
        return Point{u[0] * q[0] - u[1] * q[1], u[1] * q[0] + u[0] * q[1]};
      });
      return " turned";
    }
    case 1:
      each([](const Point& q) { return Point{0.6 * q[0] - 0.8 * q[1], 0.8 * q[0] + 0.6 * q[1]}; });
      return " turned 3-4-5";
    case 2: {
      const double far = draw.one_of({1e2, 1e3, 1e4, 1e5, 9e8});
      each([&](const Point& q) { return Point{q[0] + far, q[1] - far / 3}; });
      return " far";
    }
    case 3: {
      const double k = draw.one_of({1e-7, 1e-5, 1e-3, 1e3});
      each([&](const Point& q) { return Point{q[0], q[1] * k}; });
      return " squeezed";
    }
    case 4: {
      const double k = draw.one_of({1e-9, 1e-5, 1.0 / 3, 1e7});
      each([&](const Point& q) { return Point{q[0] * k, q[1] * k}; });
      return " scaled";
    }
    case 5: {  // as from few digits in a file, or a dragged vertex
      const double step = draw.one_of({1e-14, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-3});
      for (Point& q : p)
        for (double& x : q) x += step * draw.between(-1.0, 1.0);
      return " shaken";
    }
    case 6:
      each([](const Point& q) { return Point{q[1], q[0]}; });
      return " swapped";
    default:
      return "";
  }
}

/// `hairs` permits a centre a hair off an edge's line or a vertex.
std::optional<Point> choose_centre(const Points& p, Draw& draw, std::string& name, bool hairs) {
  const int n = static_cast<int>(p.size());
  const auto vertex = [&](int i) -> const Point& { return p[static_cast<std::size_t>(i % n)]; };
  const int i = draw.below(n), j = draw.below(n), k = draw.below(n);
  switch (draw.below(hairs ? 11 : 10)) {
    case 10: {  // just within the tolerance of a vertex or an edge's line, or just not
      name += ", C a hair off";
      const double s = draw.one_of({0.0, 0.5, 1.5, -1.0}),
                   hair = draw.one_of({1e-15, 1e-12, 1e-10, 1e-7}) * 10;
      const double dx = hair * draw.between(-1.0, 1.0);
      return Point{
          vertex(i)[0] + s * (vertex(i + 1)[0] - vertex(i)[0]) + dx,
          vertex(i)[1] + s * (vertex(i + 1)[1] - vertex(i)[1]) + hair * draw.between(-1.0, 1.0)};
    }
    case 0:
      name += ", C at a vertex";
      return vertex(i);
    case 1:
      name += ", C on an edge";
      return Point{(vertex(i)[0] + vertex(i + 1)[0]) / 2, (vertex(i)[1] + vertex(i + 1)[1]) / 2};
    case 2: {
      name += ", C in line with an edge";
      const double s = draw.one_of({-0.5, 1.5, 1.25, 2.0, -1.0});
      return Point{vertex(i)[0] + s * (vertex(i + 1)[0] - vertex(i)[0]),
                   vertex(i)[1] + s * (vertex(i + 1)[1] - vertex(i)[1])};
    }
    case 3:
      name += ", C between vertices";
      return Point{(vertex(i)[0] + vertex(j)[0]) / 2, (vertex(i)[1] + vertex(j)[1]) / 2};
    case 4:
      name += ", C on the grid";
      return Point{std::round((vertex(i)[0] + vertex(j)[0] + vertex(k)[0]) / 3),
                   std::round((vertex(i)[1] + vertex(j)[1] + vertex(k)[1]) / 3)};
    case 5:
    case 6: {
      name += ", C anywhere";
      const double a = draw.unit(), b = draw.unit() * (1 - a);
      return Point{a * vertex(i)[0] + b * vertex(j)[0] + (1 - a - b) * vertex(k)[0],
                   a * vertex(i)[1] + b * vertex(j)[1] + (1 - a - b) * vertex(k)[1]};
    }
    default:
      return std::nullopt;
  }
}

using Maker = Points (*)(Draw&);
const Maker makers[] = {regular,       on_ellipse, star,      comb,     spiral,
                        random_simple, on_grid,    staircase, symmetric};
static_assert(std::size(makers) == std::size(families));

}  // namespace

Case attempt_case(std::uint64_t number, std::uint64_t attempt) {
  Draw draw(number * 1000 + attempt);
  const std::size_t family = number % std::size(families);
  Case c{families[family], {}};
  oracle::Problem& problem = c.problem;
  problem.vertices = makers[family](draw);
  if (draw.chance(20)) add_straight_vertices(problem.vertices, draw);
  problem.centre_of_mass = choose_centre(problem.vertices, draw, c.name, true);
  c.name += transform(problem.vertices, problem.centre_of_mass, draw);
  if (draw.chance(30)) {
    std::reverse(problem.vertices.begin(), problem.vertices.end());
    c.name += " reversed";
  }
  problem.min_ratio = draw.one_of({0.0, 0.5, 0.8, 0.8, 1.0});
  problem.teams = draw.one_of({1, 2, 3, 3, 4, 5, 8});
  problem.metric =
      draw.one_of({oracle::Metric::area, oracle::Metric::circle, oracle::Metric::distance});
  return c;
}

Case attempt_plain_case(std::uint64_t number, std::uint64_t attempt) {
  Draw draw(number * 1000 + attempt + 250'000'000);
  const std::size_t family = number % std::size(families);
  Case c{families[family], {}};
  oracle::Problem& problem = c.problem;
  problem.vertices = makers[family](draw);
  if (draw.chance(30)) add_straight_vertices(problem.vertices, draw);
  problem.centre_of_mass = choose_centre(problem.vertices, draw, c.name, false);
  if (draw.chance(30)) std::reverse(problem.vertices.begin(), problem.vertices.end());
  problem.min_ratio = draw.one_of({0.0, 0.5, 0.8, 0.8, 1.0});
  return c;
}

Case make_careless_case(std::uint64_t number) {
  Draw draw(number + 500'000'000);
  const int n = draw.between(2, 7), side = draw.between(1, 5);
  Case c{"careless", {}};
  for (int i = 0; i < n; ++i) {
    const double x = draw.between(0, side);
    c.problem.vertices.push_back({x, draw.chance(10) ? x : draw.between(0, side)});
  }
  if (draw.chance(50)) c.problem.vertices = untangled(c.problem.vertices);
  if (draw.chance(50)) {
    const double x = draw.between(0, 2 * side) / 2.0;
    c.problem.centre_of_mass = Point{x, draw.between(0, 2 * side) / 2.0};
  }
  if (draw.chance(50)) c.name += transform(c.problem.vertices, c.problem.centre_of_mass, draw);
  return c;
}

}  // namespace small_polygons
