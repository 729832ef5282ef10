// Documents of every kind for links and texts, from a seed. Polygons need not be simple, as links
// and texts do not require it.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/random.h"

namespace evenlift::testing {

inline std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value); }

inline double double_of(std::uint64_t bits) { return std::bit_cast<double>(bits); }

inline bool same_bits(const Vec2& a, const Vec2& b) {
  return bits_of(a.x) == bits_of(b.x) && bits_of(a.y) == bits_of(b.y);
}

inline bool same_vertices(const Points& a, const Points& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec2& p, const Vec2& q) { return same_bits(p, q); });
}

inline bool same_polygon(const Document& a, const Document& b) {
  if (a.centre_of_mass.has_value() != b.centre_of_mass.has_value()) return false;
  if (a.centre_of_mass && !same_bits(*a.centre_of_mass, *b.centre_of_mass)) return false;
  return same_vertices(a.vertices, b.vertices) &&
         std::equal(a.holes.begin(), a.holes.end(), b.holes.begin(), b.holes.end(), same_vertices);
}

inline bool same_document(const Document& a, const Document& b) {
  return same_polygon(a, b) && a.settings == b.settings && a.shown == b.shown &&
         a.moved == b.moved && same_vertices(a.settings.supports, b.settings.supports) &&
         bits_of(a.settings.weight) == bits_of(b.settings.weight) &&
         bits_of(a.shown.com_radius) == bits_of(b.shown.com_radius) &&
         bits_of(a.settings.min_ratio) == bits_of(b.settings.min_ratio);
}

// Finite, at most `limit` in size. All exponents are equally likely, so half are below 1e-150.
inline double any_double(Rng& rng, double limit) {
  for (;;) {
    const double value = double_of(rng.below(std::numeric_limits<std::uint64_t>::max()));
    if (std::fabs(value) <= limit) return value;
  }
}

// The kinds of coordinates.
enum class Kind { integers, decimals, doubles, binary, any, few, offset, comb, smooth, count };

inline double coordinate(Rng& rng, Kind kind, int decimals) {
  double power = 1;
  for (int i = 0; i < decimals; ++i) power *= 10;
  switch (kind) {
    case Kind::integers:
      return static_cast<double>(rng.below(2001)) - 1000.0;
    case Kind::decimals:
      return std::round((rng.uniform() - 0.5) * 1000 * power) / power;
    case Kind::doubles:
      return rng.uniform() * 1000;
    case Kind::binary:  // few bits, as in floats
      return std::ldexp(static_cast<double>(rng.below(1u << 24)), -14);
    case Kind::any:
      return any_double(rng, max_coordinate);
    case Kind::few: {
      const double values[] = {0.0, -0.0, 5e-324, -5e-324, 1.0, 0.1, -max_coordinate, 2.5e-308};
      return values[rng.below(8)];
    }
    case Kind::offset:
      return 4649776.25 + static_cast<double>(rng.below(4000)) / 4;
    default:
      return 0;
  }
}

inline Points random_vertices(Rng& rng, std::size_t n) {
  const auto kind = static_cast<Kind>(rng.below(static_cast<std::uint64_t>(Kind::count)));
  const int decimals = static_cast<int>(rng.below(8));
  Points vertices;
  for (std::size_t i = 0; i < n; ++i) {
    if (kind == Kind::comb) {
      const std::size_t column = i / 2;
      vertices.emplace_back(20.0 * static_cast<double>(column), i % 4 == 1 || i % 4 == 2 ? 400 : 0);
      continue;
    }
    if (kind == Kind::smooth) {
      // An ellipse by tangents of half angles, which all platforms compute alike.
      const double t = 8 * static_cast<double>(i) / static_cast<double>(n) - 4;
      vertices.emplace_back(500 * (1 - t * t) / (1 + t * t), 300 * 2 * t / (1 + t * t));
      continue;
    }
    const double x = coordinate(rng, kind, decimals);
    const double y = coordinate(rng, kind, decimals);
    vertices.emplace_back(x, y);
  }
  // Sometimes one vertex is of another kind, as if dragged.
  if (n > 0 && rng.below(3) == 0) {
    const std::size_t dragged = rng.below(n);
    vertices[dragged].x = rng.uniform() * 1000;
    if (rng.below(2) == 0) vertices[dragged].y = any_double(rng, max_coordinate);
  }
  return vertices;
}

inline void take_random_settings(Rng& rng, Document& document) {
  Settings& settings = document.settings;
  Overlays& overlays = document.shown.overlays;
  const auto now_and_then = [&rng] { return rng.below(3) == 0; };
  if (now_and_then()) {
    settings.teams = std::nullopt;
    if (now_and_then()) settings.teams = static_cast<std::uint32_t>(1 + rng.below(max_teams));
  }
  if (now_and_then()) settings.method = pair_methods[rng.below(5)];
  if (now_and_then()) settings.min_ratio = static_cast<double>(rng.below(101)) / 100;
  if (now_and_then()) settings.min_ratio = rng.uniform();
  if (now_and_then()) settings.weight = 1 + static_cast<double>(rng.below(1000)) / 8;
  if (now_and_then()) settings.weight = std::fabs(any_double(rng, 1e300)) + 5e-324;
  if (now_and_then()) settings.seed = rng.below(std::numeric_limits<std::uint64_t>::max());
  if (now_and_then()) {
    overlays.candidates = rng.below(2) == 0;
    overlays.chords = rng.below(2) == 0;
    overlays.lifting_base = rng.below(2) == 0;
    overlays.clockwise = rng.below(2) == 0;
    overlays.counterclockwise = rng.below(2) == 0;
    overlays.tipping = rng.below(2) == 0;
  }
  if (now_and_then()) document.shown.step = static_cast<std::uint32_t>(rng.below(1000));
}

inline Document random_document(Rng& rng, std::size_t greatest_n) {
  Document document;
  document.vertices = random_vertices(rng, rng.below(greatest_n + 1));
  const std::uint64_t centre = rng.below(4);
  if (centre == 1) document.centre_of_mass = Vec2(278, 227);
  if (centre == 2) document.centre_of_mass = random_vertices(rng, 1)[0];
  if (centre == 3 && !document.vertices.empty()) document.centre_of_mass = document.vertices[0];
  if (rng.below(2) == 0) take_random_settings(rng, document);
  return document;
}

// Adds rings that need not lie in the polygon.
inline void take_random_holes(Rng& rng, Document& document) {
  for (std::uint64_t count = rng.below(5); count > 0; --count)
    document.holes.push_back(random_vertices(rng, 1 + rng.below(9)));
}

inline void take_random_cargo(Rng& rng, Document& document) {
  const std::string names[] = {"",      "motor", "5 kg box", "Stra\u00dfe, \u00fcber (7,8)",
                               "Hole:", "e5"};
  for (std::uint64_t count = rng.below(4); count > 0; --count)
    document.settings.cargo.push_back({random_vertices(rng, 1)[0],
                                       std::fabs(any_double(rng, max_weight)) + min_weight,
                                       names[rng.below(std::size(names))]});
}

// Sets supports, the method `given`, and perhaps capacities.
inline void take_random_supports(Rng& rng, Document& document) {
  document.settings.method = Method::given;
  document.settings.supports = random_vertices(rng, 1 + rng.below(12));
  if (rng.below(2) == 0) document.settings.snap = rng.uniform();
  if (rng.below(2) == 0) {
    Weighed& weighed = document.settings.weighed;
    const auto readings = [&] {
      std::vector<double> all(document.settings.supports.size());
      for (double& each : all)
        if (rng.below(4) > 0) each = std::fabs(any_double(rng, max_weight));
      return all;
    };
    weighed.readings = readings();
    if (rng.below(2) == 0) weighed.error.percent = 100 * rng.uniform();
    if (rng.below(2) == 0) weighed.level_error = rng.uniform();
    if (rng.below(2) == 0) weighed.tilted_readings = readings();
    if (rng.below(2) == 0) weighed.tilted = rng.uniform();
    if (rng.below(2) == 0) weighed.heading = Vec2(1 + rng.uniform(), -rng.uniform());
  }
  if (rng.below(2) == 0) return;
  auto& capacities = document.shown.support_capacities;
  capacities.resize(document.settings.supports.size());
  for (auto& capacity : capacities)
    if (rng.below(2) == 0) capacity = 1 + rng.uniform();
  capacities.back() = 30;
  if (rng.below(2) == 0) return;
  auto& names = document.settings.support_names;
  for (std::size_t i = 0; i < document.settings.supports.size(); ++i)
    names.push_back(i % 3 == 0   ? "jack" + std::to_string(i)
                    : i % 3 == 1 ? std::string()
                                 : "a \"b\" none");
}

// With a few bytes changed, dropped, doubled or moved.
inline std::string mutated(Rng& rng, std::string text, std::string_view bytes) {
  for (std::uint64_t times = 1 + rng.below(4); times > 0 && !text.empty(); --times) {
    const std::size_t at = rng.below(text.size());
    const std::size_t length = std::min<std::size_t>(1 + rng.below(6), text.size() - at);
    const char byte = bytes[rng.below(bytes.size())];
    switch (rng.below(5)) {
      case 0:
        text[at] = byte;
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, 1, byte);
        break;
      case 3:
        text.insert(at, text.substr(at, length));
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

}  // namespace evenlift::testing
