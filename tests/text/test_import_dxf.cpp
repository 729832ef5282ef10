// Blocks, visibility, old polylines and splines.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "curves/outline.h"
#include "evenlift/hull.h"
#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "kit/imported.h"

using namespace evenlift;
using evenlift::testing::read;
using evenlift::testing::refusal;

namespace {

struct Pair {
  int code;
  std::string value;
  Pair(int c, const char* text) : code(c), value(text) {}
  Pair(int c, const std::string& text) : code(c), value(text) {}
  Pair(int c, double number) : code(c), value(shortest(number)) {}
  Pair(int c, int number) : code(c), value(std::to_string(number)) {}
};
using Pairs = std::vector<Pair>;

std::string lines(const Pairs& pairs) {
  std::string text;
  for (const Pair& pair : pairs) text += std::to_string(pair.code) + "\n" + pair.value + "\n";
  return text;
}

std::string section(const std::string& name, const std::string& content) {
  return lines({{0, "SECTION"}, {2, name}}) + content + lines({{0, "ENDSEC"}});
}

std::string drawing(const std::string& entities, const std::string& blocks = "",
                    const std::string& tables = "") {
  return section("TABLES", tables) + section("BLOCKS", blocks) + section("ENTITIES", entities) +
         lines({{0, "EOF"}});
}

std::string block(const std::string& name, const std::string& content, const Vec2& base = {0, 0},
                  int flags = 0) {
  return lines({{0, "BLOCK"}, {8, "0"}, {2, name}, {70, flags}, {10, base.x}, {20, base.y}}) +
         content + lines({{0, "ENDBLK"}});
}

std::string polyline(const Points& points, const std::string& layer = "0") {
  Pairs pairs = {{0, "LWPOLYLINE"}, {8, layer}, {70, 1}};
  for (const Vec2& p : points) {
    pairs.emplace_back(10, p.x);
    pairs.emplace_back(20, p.y);
  }
  return lines(pairs);
}

std::string insert(const std::string& name, const Pairs& more = {}) {
  return lines({{0, "INSERT"}, {2, name}}) + lines(more);
}

std::vector<Points> outlines(const std::string& text) {
  std::vector<Points> all;
  for (const ImportedShape& shape : read(text).shapes) all.push_back(shape.document.vertices);
  return all;
}

const Points square = {{1, 1}, {3, 1}, {3, 2}, {1, 2}};

}  // namespace

TEST_CASE("DXF: a block is drawn where it is inserted, scaled, turned and mirrored",
          "[import][dxf]") {
  struct Case {
    const char* what;
    Pairs insert;
    Vec2 base;
    Points right;
  };
  const Case cases[] = {
      {"as it is", {}, {0, 0}, square},
      {"moved", {{10, 10}, {20, -5}}, {0, 0}, {{11, -4}, {13, -4}, {13, -3}, {11, -3}}},
      {"from its base", {{10, 10}, {20, -5}}, {1, 2}, {{10, -6}, {12, -6}, {12, -5}, {10, -5}}},
      {"scaled", {{41, 2}, {42, 3}, {43, 9}}, {0, 0}, {{2, 3}, {6, 3}, {6, 6}, {2, 6}}},
      {"turned", {{50, 90}}, {0, 0}, {{-1, 1}, {-1, 3}, {-2, 3}, {-2, 1}}},
      {"turned back", {{50, -450}}, {0, 0}, {{1, -1}, {1, -3}, {2, -3}, {2, -1}}},
      {"mirrored by scale", {{41, -1}, {42, 1}}, {0, 0}, {{-1, 1}, {-3, 1}, {-3, 2}, {-1, 2}}},
      {"seen from behind", {{10, 10}, {230, -1}}, {0, 0}, {{-11, 1}, {-13, 1}, {-13, 2}, {-11, 2}}},
      {"seen from behind and turned",
       {{50, 90}, {230, -1}},
       {0, 0},
       {{1, 1}, {1, 3}, {2, 3}, {2, 1}}},
      {"scaled before it is turned",
       {{10, 100}, {41, 2}, {42, -1}, {50, 180}},
       {1, 1},
       {{100, 0}, {96, 0}, {96, 1}, {100, 1}}},
  };
  for (const Case& c : cases) {
    INFO(c.what);
    const auto all =
        outlines(drawing(insert("part", c.insert), block("PART", polyline(square), c.base)));
    REQUIRE(all.size() == 1);
    CHECK(all[0] == c.right);
  }
}

TEST_CASE("DXF: steps between columns and rows turn with the block, and are not scaled",
          "[import][dxf]") {
  const auto all = outlines(drawing(
      insert("part", {{10, 7}, {41, 2}, {42, 2}, {50, 90}, {70, 3}, {71, 2}, {44, 10}, {45, 20}}),
      block("part", polyline(square))));
  REQUIRE(all.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec2 step(i < 3 ? 0 : -20, 10 * static_cast<double>(i % 3));
    Points right = {{5, 2}, {5, 6}, {3, 6}, {3, 2}};
    for (Vec2& corner : right) corner += step;
    CHECK(std::find(all.begin(), all.end(), right) != all.end());
  }
}

TEST_CASE("DXF: blocks within blocks, and their objects on layer 0", "[import][dxf]") {
  // Parts are not called by blocks whose names a program made up.
  const std::string blocks =
      block("*inner", polyline(square) + polyline({{0, 0}, {1, 0}, {0, 1}}, "own")) +
      block("*outer", insert("*inner", {{8, "0"}, {10, 10}, {50, 90}}) +
                          insert("*inner", {{8, "lids"}, {41, -2}}));
  const Import import = read(drawing(insert("*outer", {{8, "parts"}, {10, 100}, {41, 3}}), blocks));
  REQUIRE(import.shapes.size() == 4);
  const char* layers[] = {"parts", "own", "lids", "own"};
  const Points right[] = {{{127, 1}, {127, 3}, {124, 3}, {124, 1}},
                          {{130, 0}, {130, 1}, {127, 0}},
                          {{94, 1}, {82, 1}, {82, 2}, {94, 2}},
                          {{100, 0}, {94, 0}, {100, 1}}};
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(std::any_of(import.shapes.begin(), import.shapes.end(), [&](const ImportedShape& shape) {
      return shape.name == layers[i] && shape.document.vertices == right[i];
    }));
}

TEST_CASE("DXF: an arc of a full turn is a circle", "[import][dxf]") {
  const Import import =
      read(drawing(lines({{0, "ARC"}, {10, 1}, {20, 0}, {40, 2}, {50, 0}, {51, 360}})), {1e-5});
  REQUIRE(import.shapes.size() == 1);
  CHECK(std::abs(signed_area(import.shapes[0].document.vertices)) ==
        Approx(4 * 3.14159265).epsilon(1e-4));
}

TEST_CASE("DXF: arcs that programs leave at corners, from an angle to itself, are left out",
          "[import][dxf]") {
  // A plate with a round corner, beside which trimming left an arc of no length, and a hole.
  const Import import =
      read(drawing(lines({{0, "LINE"}, {10, 0}, {20, 0}, {11, 40}, {21, 0}}) +
                   lines({{0, "LINE"}, {10, 40}, {20, 0}, {11, 40}, {21, 20}}) +
                   lines({{0, "ARC"}, {10, 30}, {20, 20}, {40, 10}, {50, 0}, {51, 90}}) +
                   lines({{0, "ARC"}, {10, 30}, {20, 20}, {40, 10}, {50, 90}, {51, 90}}) +
                   lines({{0, "LINE"}, {10, 30}, {20, 30}, {11, 0}, {21, 30}}) +
                   lines({{0, "LINE"}, {10, 0}, {20, 30}, {11, 0}, {21, 0}}) +
                   lines({{0, "CIRCLE"}, {10, 28}, {20, 18}, {40, 2}})));
  REQUIRE(import.shapes.size() == 1);
  CHECK(import.shapes[0].document.holes.size() == 1);
  CHECK(std::any_of(import.notes.begin(), import.notes.end(), [](const std::string& note) {
    return note == "1 arc of no length was left out";
  }));
}

TEST_CASE("DXF: each side of a polyline has its own bulge, the closing one too", "[import][dxf]") {
  // A square of side 10 with a half circle outside at one side.
  const Points corners = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  for (std::size_t round = 0; round < corners.size(); ++round) {
    Pairs pairs = {{0, "LWPOLYLINE"}, {70, 1}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      pairs.insert(pairs.end(), {{10, corners[i].x}, {20, corners[i].y}});
      if (i == round) pairs.push_back({42, 1});
    }
    const Import import = read(drawing(lines(pairs)), {1e-4});
    INFO("side " << round);
    REQUIRE(import.shapes.size() == 1);
    const Points& outline = import.shapes[0].document.vertices;
    CHECK(std::abs(signed_area(outline)) == Approx(100 + 12.5 * 3.14159265).epsilon(1e-4));
    const Box box = bounding_box(outline);
    CHECK(box.low.y == Approx(round == 0 ? -5 : 0).margin(1e-6));
    CHECK(box.high.x == Approx(round == 1 ? 15 : 10).margin(1e-6));
    CHECK(box.high.y == Approx(round == 2 ? 15 : 10).margin(1e-6));
    CHECK(box.low.x == Approx(round == 3 ? -5 : 0).margin(1e-6));
  }
}

TEST_CASE("DXF: the widest gap that was joined is told, whichever layer has it", "[import][dxf]") {
  const auto square_of_lines = [](const std::string& layer, double x, double gap) {
    const Points corners = {{x, 0}, {x + 40, 0}, {x + 40, 40}, {x, 40}};
    std::string text;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 from = corners[i], to = corners[(i + 1) % 4];
      text += lines({{0, "LINE"},
                     {8, layer},
                     {10, from.x},
                     {20, from.y},
                     {11, to.x},
                     {21, to.y + (i == 3 ? gap : 0)}});
    }
    return text;
  };
  for (const auto& [first, second] : {std::pair(0.05, 0.0), std::pair(0.0, 0.05)}) {
    const Import import =
        read(drawing(square_of_lines("A", 0, first) + square_of_lines("B", 60, second)));
    INFO(first);
    REQUIRE(import.shapes.size() == 2);
    CHECK(std::count(import.notes.begin(), import.notes.end(),
                     "ends up to 0.05 apart were joined") == 1);
  }
}

TEST_CASE("DXF: circles and arcs of a block follow its scale", "[import][dxf]") {
  const std::string round = lines({{0, "CIRCLE"}, {10, 1}, {20, 0}, {40, 2}}) +
                            lines({{0, "ARC"}, {10, 9}, {20, 0}, {40, 2}, {50, 0}, {51, 180}}) +
                            lines({{0, "LINE"}, {10, 7}, {20, 0}, {11, 11}, {21, 0}});
  const Import import =
      read(drawing(insert("round", {{41, -3}, {42, 0.5}}), block("round", round)), {1e-5});
  REQUIRE(import.shapes.size() == 2);
  const Points &circle = import.shapes[0].document.vertices,
               &half = import.shapes[1].document.vertices;
  CHECK(import.shapes[0].kind == "circle");
  for (const Vec2& p : circle) CHECK((p.x + 3) * (p.x + 3) / 36 + p.y * p.y == Approx(1));
  CHECK(std::abs(signed_area(circle)) == Approx(6 * 3.14159265).epsilon(1e-4));
  CHECK(std::abs(signed_area(half)) == Approx(3 * 3.14159265).epsilon(1e-4));
  CHECK(bounding_box(half).low.y == Approx(0).margin(1e-9));
  CHECK(bounding_box(half).high.y == Approx(1));
}

TEST_CASE("DXF: pieces within blocks are joined with others", "[import][dxf]") {
  const std::string corner = lines({{0, "LINE"}, {11, 5}}) + lines({{0, "LINE"}, {21, 5}});
  const Import import = read(drawing(
      insert("corner") + insert("corner", {{10, 5}, {20, 5}, {50, 180}}), block("corner", corner)));
  REQUIRE(import.shapes.size() == 1);
  CHECK(std::abs(signed_area(import.shapes[0].document.vertices)) == 25);
}

TEST_CASE("DXF: a block that is not drawn has its own reason", "[import][dxf]") {
  const std::string blocks = block("other", "", {0, 0}, 4) + block("*D3", polyline(square)) +
                             block("*X1", polyline(square)) + block("*U2", polyline(square)) +
                             block("empty", "") + block("never", insert("never"));
  const Import import =
      read(drawing(insert("bolt") + insert("other") + insert("*D3") + insert("*X1") +
                       insert("*U2") + insert("empty") + lines({{0, "DIMENSION"}, {2, "*D3"}}),
                   blocks));
  CHECK(import.shapes.size() == 1);
  REQUIRE(import.notes.size() == 1);
  CHECK(import.notes[0] ==
        "1 block (INSERT) that the drawing does not define, 1 block (INSERT) from another file, 2 "
        "dimensions and 1 hatching were left out");
}

TEST_CASE("DXF: blocks without end are refused", "[import][dxf]") {
  CHECK(refusal(drawing(insert("a"), block("a", insert("b")) + block("b", insert("A"))))
            .find("the block \"a\" contains itself") != std::string::npos);
  // Each has two of the next.
  const auto tower = [](int height) {
    std::string blocks = block("b0", polyline(square));
    for (int i = 1; i <= height; ++i) {
      const std::string inner = insert("b" + std::to_string(i - 1));
      blocks += block("b" + std::to_string(i), inner + inner);
    }
    return drawing(insert("b" + std::to_string(height)), blocks);
  };
  CHECK(read(tower(5)).notes ==
        std::vector<std::string>{"31 outlines that repeat another were left out"});
  CHECK(refusal(tower(16)) == "the text has more than 10000 shapes");
  CHECK(refusal(tower(40)).find("more than 32 deep") != std::string::npos);
  const Pairs many = {{70, 65535}, {71, 65535}};
  CHECK(refusal(drawing(insert("a", many), block("a", ""))).find("inserts its blocks too often") !=
        std::string::npos);
  CHECK(refusal(drawing(insert("a", many), block("a", lines({{0, "LINE"}, {11, 5}}))))
            .find("more than 1048576 lines and arcs") != std::string::npos);
  // An invalid number does not matter in a block that nothing inserts.
  const std::string bad = lines({{0, "CIRCLE"}, {40, "1,5"}});
  CHECK(read(drawing(polyline(square), block("a", bad))).notes.empty());
  CHECK(refusal(drawing(insert("a"), block("a", bad))).find("expected a number") !=
        std::string::npos);
  // The product of scales overflows.
  CHECK(refusal(drawing(insert("b", {{41, 1e300}}),
                        block("a", polyline(square)) + block("b", insert("a", {{41, 1e300}})))) ==
        "a coordinate is beyond 1,000,000,000");
  const std::string edge = lines({{0, "LINE"}, {11, 5}, {21, 5}});
  CHECK(refusal(drawing(insert("b", {{41, 1e300}}),
                        block("a", edge) + block("b", insert("a", {{41, -1e300}})))) ==
        "a coordinate is beyond 1,000,000,000");
}

TEST_CASE("DXF: what is not seen is left out, and counted", "[import][dxf]") {
  const auto layer = [](const char* name, int flags, int colour) {
    return lines({{0, "LAYER"}, {2, name}, {70, flags}, {62, colour}});
  };
  const std::string tables = lines({{0, "TABLE"}, {2, "LAYER"}}) + layer("0", 0, 7) +
                             layer("Cut", 4, 1) + layer("Frame", 0, -7) + layer("Old", 1, 3) +
                             lines({{0, "ENDTAB"}});
  const auto notes = [&](const std::string& entities, const std::string& blocks = "") {
    const Import import = read(drawing(polyline(square, "CUT") + entities, blocks, tables));
    CHECK(import.shapes.size() == 1);
    CHECK(import.notes.size() <= 1);
    return import.notes.empty() ? std::string() : import.notes[0];
  };
  const Points other = {{0, 0}, {9, 0}, {0, 9}};
  CHECK(notes(polyline(other, "FRAME") + polyline(other, "old")) ==
        "2 objects on layers that are off or frozen were left out");
  CHECK(notes(polyline(other, "DEFPOINTS")) == "1 object on the layer Defpoints was left out");
  CHECK(notes(polyline(other) + lines({{60, 1}})) == "1 invisible object was left out");
  // A hidden polyline's vertices are hidden.
  CHECK(notes(lines({{0, "POLYLINE"},
                     {8, "frame"},
                     {70, 1},
                     {0, "VERTEX"},
                     {0, "VERTEX"},
                     {10, 5},
                     {0, "VERTEX"},
                     {20, 5},
                     {0, "SEQEND"}})) == "1 object on a layer that is off or frozen was left out");

  // A frozen layer hides a whole block; one that is off, only its objects on layer 0.
  const std::string blocks = block("mixed", polyline(other) + polyline(other, "old"));
  CHECK(notes(insert("mixed", {{8, "Old"}}), blocks) ==
        "1 object on a layer that is off or frozen was left out");
  CHECK(notes(insert("mixed", {{8, "Frame"}}), blocks) ==
        "2 objects on layers that are off or frozen were left out");
  CHECK(
      read(drawing(insert("mixed", {{8, "Frame"}}), block("mixed", polyline(other, "Cut")), tables))
          .shapes.size() == 1);
  CHECK(refusal(drawing(polyline(other, "frame"), "", tables)) ==
        "this DXF drawing has no closed outline, only 1 object on a layer that is off or frozen");
}

TEST_CASE("DXF: an old polyline is the curve, not the frame of its spline", "[import][dxf]") {
  const auto vertices = [](const std::vector<std::pair<Vec2, int>>& all, int flags) {
    std::string text = lines({{0, "POLYLINE"}, {70, flags}});
    for (const auto& [point, bits] : all)
      text += lines({{0, "VERTEX"}, {10, point.x}, {20, point.y}, {70, bits}});
    return drawing(text + lines({{0, "SEQEND"}}));
  };
  CHECK(outlines(vertices({{{0, 0}, 16}, {{9, 0}, 16}, {{1, 1}, 8}, {{5, 1}, 8}, {{3, 4}, 8}},
                          5)) == std::vector<Points>{{{1, 1}, {5, 1}, {3, 4}}});
  // In space, with bit 32 of its vertices, not mirrored.
  CHECK(outlines(vertices({{{9, 0}, 48}, {{1, 1}, 40}, {{5, 1}, 40}, {{3, 4}, 40}}, 13)) ==
        std::vector<Points>{{{1, 1}, {5, 1}, {3, 4}}});
  // Vertices added to fit arcs, and a frame without its curve.
  CHECK(outlines(vertices({{{0, 0}, 0}, {{9, 0}, 1}, {{9, 9}, 0}}, 3)).at(0).size() == 3);
  CHECK(outlines(vertices({{{0, 0}, 16}, {{9, 0}, 16}, {{9, 9}, 16}}, 1)).at(0).size() == 3);
  CHECK(refusal(vertices({{{0, 0}, 0}, {{9, 0}, 0}, {{9, 9}, 0}}, 17)).find("1 mesh") !=
        std::string::npos);
}

// --- Splines

namespace {

struct Curve {
  int degree;
  Points control;
  std::vector<double> knots, weights;
  int flags = 0;
};

std::string spline(const Curve& curve) {
  Pairs pairs = {{0, "SPLINE"}, {70, curve.flags}, {71, curve.degree}};
  for (const double knot : curve.knots) pairs.emplace_back(40, knot);
  for (const double weight : curve.weights) pairs.emplace_back(41, weight);
  for (const Vec2& p : curve.control) {
    pairs.emplace_back(10, p.x);
    pairs.emplace_back(20, p.y);
  }
  return drawing(lines(pairs));
}

// By the recursion of de Boor and Cox.
double basis(const std::vector<double>& knots, std::size_t k, std::size_t degree, double t) {
  if (degree == 0) return knots[k] <= t && t < knots[k + 1] ? 1 : 0;
  const double a = knots[k + degree] - knots[k], b = knots[k + degree + 1] - knots[k + 1];
  return (a > 0 ? (t - knots[k]) / a * basis(knots, k, degree - 1, t) : 0) +
         (b > 0 ? (knots[k + degree + 1] - t) / b * basis(knots, k + 1, degree - 1, t) : 0);
}

Vec2 point_at(const Curve& curve, double t) {
  Vec2 sum;
  double total = 0;
  for (std::size_t k = 0; k < curve.control.size(); ++k) {
    const double weight = (curve.weights.empty() ? 1 : curve.weights[k]) *
                          basis(curve.knots, k, static_cast<std::size_t>(curve.degree), t);
    sum += weight * curve.control[k];
    total += weight;
  }
  return sum / total;
}

double distance_from(const Points& edges, const Vec2& p) {
  double least = length(p - edges[0]);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Vec2 along = edges[i + 1] - edges[i];
    const double part = std::clamp(dot(p - edges[i], along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, length(p - (edges[i] + part * along)));
  }
  return least;
}

// 0 and 1 at the ends, others once between.
std::vector<double> even_knots(std::size_t points, std::size_t degree) {
  std::vector<double> knots(degree + 1, 0.0);
  const double spans = static_cast<double>(points - degree);
  for (double i = 1; i < spans; ++i) knots.push_back(i / spans);
  knots.insert(knots.end(), degree + 1, 1.0);
  return knots;
}

// Around a square of side 2 about the origin.
const double root = std::sqrt(0.5);
const Curve circle = {
    2,
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
    {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
    {1, root, 1, root, 1, root, 1, root, 1},
    11};

}  // namespace

TEST_CASE("DXF: a circle as a NURBS curve", "[import][dxf]") {
  const Import import = read(spline(circle), {1e-6});
  REQUIRE(import.shapes.size() == 1);
  CHECK(import.shapes[0].kind == "closed spline");
  CHECK(std::abs(signed_area(import.shapes[0].document.vertices) - 3.14159265) < 1e-4);
  for (const Vec2& p : import.shapes[0].document.vertices) CHECK(length(p) == Approx(1));
  // As few vertices as a circle.
  CHECK(outlines(spline(circle)).at(0).size() == 64);

  // A half circle of degree 3, and its diameter.
  const Curve half = {3, {{1, 0}, {1, 2}, {-1, 2}, {-1, 0}}, even_knots(4, 3), {3, 1, 1, 3}};
  const std::string line = lines({{0, "LINE"}, {10, -1}, {11, 1}});
  std::string text = spline(half);
  text.insert(text.rfind("0\nENDSEC"), line);
  const Import joined = read(text, {1e-6});
  REQUIRE(joined.shapes.size() == 1);
  CHECK(std::abs(signed_area(joined.shapes[0].document.vertices) - 3.14159265 / 2) < 1e-5);
}

TEST_CASE("a B-spline of any degree with weights is near its formula", "[import][curves]") {
  Rng rng(8);
  for (int degree = 1; degree <= 10; ++degree)
    for (int i = 0; i < 12; ++i) {
      const auto n = static_cast<std::size_t>(degree);
      Curve curve{degree, {}, {}, {}};
      curve.control.resize(n + 1 + static_cast<std::size_t>(rng.uniform() * 6));
      for (Vec2& p : curve.control) p = Vec2(rng.uniform() * 10 + 1e6, rng.uniform() * 10);
      curve.knots = even_knots(curve.control.size(), n);
      if (i % 3 == 1) {  // repeated, and not from 0 to 1
        for (double& knot : curve.knots) knot = std::floor(knot * 3);
      }
      if (i % 2 == 0)
        for (std::size_t k = 0; k < curve.control.size(); ++k)
          curve.weights.push_back(0.1 + 3 * rng.uniform());
      const auto outline = Outline::b_spline(curve.control, curve.knots, n, curve.weights);
      const double first = curve.knots[n], last = curve.knots[curve.control.size()];
      bool whole = true;
      for (std::size_t k = 1; k + n < curve.knots.size(); ++k)
        if (curve.knots[k] == curve.knots[k + n] && curve.knots[k] > first && curve.knots[k] < last)
          whole = false;
      REQUIRE(outline.has_value() == whole);
      if (!outline) continue;
      CHECK(outline->pieces.size() < 400);
      const auto edges = flatten(*outline, 1e-4, 100000);
      REQUIRE(edges);
      for (int s = 0; s < 60; ++s) {
        const double t = first + (last - first) * s / 60;
        const double apart = distance_from(*edges, point_at(curve, t));
        if (apart > 1.02e-4) FAIL("degree " << degree << " at " << t << ": " << apart);
      }
    }
}

TEST_CASE("DXF: a spline of degree 5 is near its formula", "[import][dxf]") {
  Curve curve{
      5, {{0, 0}, {40, -10}, {70, 20}, {60, 60}, {30, 50}, {10, 70}, {-20, 30}, {0, 0}}, {}, {}};
  curve.knots = even_knots(8, 5);
  const Points edges = outlines(spline(curve)).at(0);
  Points closed = edges;
  closed.push_back(edges.front());
  for (int s = 0; s < 200; ++s) CHECK(distance_from(closed, point_at(curve, s / 200.0)) < 0.1);
}

TEST_CASE("DXF: knots as different programs write them", "[import][dxf]") {
  // Bézier curves in turn, whose ends have all knots.
  const Curve beziers = {
      2, {{0, 0}, {9, 0}, {9, 9}, {9, 9}, {0, 9}, {0, 0}}, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {}, 11};
  const Points leaf = outlines(spline(beziers)).at(0);
  CHECK(signed_area(leaf) == Approx(54).epsilon(0.01));

  // Equal weights change nothing.
  Curve weighted = beziers;
  weighted.weights.assign(6, 0.25);
  CHECK(outlines(spline(weighted)).at(0) == leaf);

  // Without the first and last knot.
  Curve shorter = beziers;
  shorter.knots.erase(shorter.knots.begin());
  shorter.knots.pop_back();
  CHECK(outlines(spline(shorter)).at(0) == leaf);

  // Closed, with and without its first points again.
  const Curve around = {
      2, {{0, 0}, {9, 0}, {5, 8}, {0, 0}, {9, 0}}, {0, 1, 2, 3, 4, 5, 6, 7}, {}, 11};
  Curve once = around;
  once.control.resize(3);
  CHECK(outlines(spline(once)) == outlines(spline(around)));

  // Marked as periodic, with an open curve's knots.
  once.knots = even_knots(3, 2);
  const Import marked = read(spline(once));
  CHECK(marked.shapes.at(0).document.vertices == outlines(spline(around)).at(0));
  CHECK(marked.notes ==
        std::vector<std::string>{
            "1 spline is marked as periodic but has the knots of an open curve, and "
            "was read as periodic"});
  once.flags = 8;
  CHECK(
      refusal(spline(once)) ==
      "this DXF drawing has no closed outline: the nearest open ends, (0, 0) and (5, 8), are 9.434 apart");
}

TEST_CASE("DXF: each spline that cannot be read has its own reason", "[import][dxf]") {
  const auto reason = [](const Curve& curve) { return refusal(spline(curve)); };
  const auto says = [&](const Curve& curve, const std::string& why) {
    CHECK(reason(curve) == "this DXF drawing has no closed outline, only 1 spline " + why +
                               "; such splines must be turned into polylines first");
  };
  Curve curve = circle;
  curve.degree = 11;
  says(curve, "of a degree outside 1 to 10");
  curve = circle;
  curve.degree = 9;
  says(curve, "with too few control points for its degree");
  curve = circle;
  curve.knots.insert(curve.knots.begin(), 0.0);
  says(curve, "whose number of knots does not fit its control points");
  curve = circle;
  std::swap(curve.knots[3], curve.knots[8]);
  says(curve, "whose knots are out of order");
  curve = circle;
  curve.knots.assign(12, 1.0);
  says(curve, "whose knots are all equal");
  curve = circle;
  curve.weights.pop_back();
  says(curve, "whose number of weights does not fit its control points");
  curve = circle;
  curve.weights[4] = 0;
  says(curve, "with a weight of 0 or less");
  says({2, {{0, 0}, {9, 0}, {9, 9}, {9, 8}, {0, 9}, {0, 0}}, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {}},
       "of several separate parts");
  says({3, {}, {}, {}}, "without control points");
  CHECK(refusal(drawing(lines({{0, "SPLINE"}, {70, 1}, {11, 0}, {21, 0}, {11, 5}, {21, 5}})))
            .find("1 spline that has only fit points") != std::string::npos);
}

TEST_CASE("DXF: units of new and old drawings", "[import][dxf]") {
  const auto unit = [](const Pairs& header) {
    std::string text = section("HEADER", lines(header)) + drawing(polyline(square));
    return read(text).unit;
  };
  CHECK(unit({{9, "$ACADVER"}, {1, "AC1009"}, {9, "$INSUNITS"}, {70, 5}}) == "centimetres");
  CHECK(unit({{9, "$ACADVER"}, {1, "AC1032"}, {9, "$INSUNITS"}, {70, 21}}) == "US survey feet");
  CHECK(unit({{9, "$MEASUREMENT"}, {70, 1}}).empty());
}

TEST_CASE("names of layers are read in the drawing's code page", "[import][dxf]") {
  const auto layer = [](const std::string& page, const std::string& name) {
    const std::string header =
        page.empty() ? "" : "0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\n" + page + "\n0\nENDSEC\n";
    const std::string square =
        "0\nLWPOLYLINE\n8\n" + name + "\n70\n1\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n";
    return evenlift::testing::read(header + "0\nSECTION\n2\nENTITIES\n" + square +
                                   "0\nENDSEC\n0\nEOF\n");
  };
  const auto name = [&](const std::string& page, const std::string& bytes) {
    return layer(page, bytes).shapes.at(0).name;
  };
  CHECK(name("ANSI_1252",
             "Au\xDF"
             "enma\xDF") == "Außenmaß");
  CHECK(name("ANSI_1250",
             "\xA3\xF3"
             "d\x9F") == "Łódź");
  CHECK(name("ANSI_1251", "\xCA\xEE\xED\xF2\xF3\xF0") == "Контур");
  CHECK(name("ANSI_932", "\x8A\x4F\x8C\x60") == "外形");
  CHECK(name("ANSI_936", "\xCD\xE2\xD0\xCE") == "外形");
  CHECK(name("ANSI_949", "\xBF\xDC\xC7\xFC") == "외형");
  CHECK(name("ANSI_950", "\xA5\x7E\xA7\xCE") == "外形");
  // UTF-8 stays, whatever the header says; letters may be written by their number.
  CHECK(name("ANSI_1252", "Außenmaß") == "Außenmaß");
  CHECK(name("", "Au\\U+00DFen") == "Außen");
  CHECK(name("", "\\U+5916\\U+5F62") == "外形");
  CHECK(name("", "\\U+D83D\\U+12") == "\\U+D83D\\U+12");
  // A byte without a letter, and a page that is not known.
  CHECK(name("ANSI_932", "A\x8A") == "A\uFFFD");
  const Import unknown = layer("dos437",
                               "gr\x94\xE1"
                               "e");
  CHECK(unknown.notes.back() == "names are in the code page dos437, which is not known here");
}

TEST_CASE("DXF: a polyline in space that is not level is read from above, with a notice",
          "[import][dxf]") {
  const auto polyline = [](double height) {
    std::string text = "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\nA\n66\n1\n70\n9\n";
    const double corners[4][3] = {{0, 0, 0}, {120, 0, height}, {120, 80, height}, {0, 80, 0}};
    for (const auto& [x, y, z] : corners)
      text += "0\nVERTEX\n8\nA\n10\n" + shortest(x) + "\n20\n" + shortest(y) + "\n30\n" +
              shortest(z) + "\n70\n32\n";
    return evenlift::testing::read(text + "0\nSEQEND\n0\nENDSEC\n0\nEOF\n");
  };
  CHECK(polyline(0).notes.empty());
  const Import slanted = polyline(30);
  CHECK(slanted.shapes.size() == 1);
  REQUIRE(slanted.notes.size() == 1);
  CHECK(slanted.notes[0] == "1 polyline in space is not level, and was read as seen from above");
}

TEST_CASE("DXF: lines that cross, so that nothing is enclosed, are named", "[import][dxf]") {
  const auto line = [](double x1, double y1, double x2, double y2) {
    return "0\nLINE\n10\n" + shortest(x1) + "\n20\n" + shortest(y1) + "\n11\n" + shortest(x2) +
           "\n21\n" + shortest(y2) + "\n";
  };
  const std::string bow =
      line(0, 0, 120, 80) + line(120, 80, 120, 0) + line(120, 0, 0, 80) + line(0, 80, 0, 0);
  CHECK(
      evenlift::testing::refusal("0\nSECTION\n2\nENTITIES\n" + bow + "0\nENDSEC\n0\nEOF\n") ==
      "this DXF drawing has no closed outline: the line from (0, 0) to (120, 80) crosses that from (120, 0) to "
      "(0, 80)");
}

TEST_CASE("DXF: parts are named by the texts in them, else by the nearest beside them",
          "[import][dxf]") {
  const auto square_at = [](double x, double side = 10) {
    return polyline({{x, 0}, {x + side, 0}, {x + side, side}, {x, side}}, "PARTS");
  };
  const auto text = [](double x, double y, const std::string& words, const char* type = "TEXT") {
    return lines({{0, type}, {8, "NOTES"}, {10, x}, {20, y}, {1, words}});
  };
  const auto names = [](const std::string& entities) {
    std::map<double, std::string> by_place;
    const Import import = read(drawing(entities));
    for (const ImportedShape& shape : import.shapes)
      by_place[bounding_box(shape.document.vertices).low.x] = shape.name;
    std::vector<std::string> all;
    for (const auto& [x, name] : by_place) all.push_back(name);
    return all;
  };
  using Names = std::vector<std::string>;
  const std::string three = square_at(0) + square_at(30) + square_at(60);
  CHECK(names(three) == Names{"PARTS", "PARTS", "PARTS"});
  CHECK(names(three + text(1, 1, "P1") + text(31, 9, "P2") + text(61, -3, "P3")) ==
        Names{"P1", "P2", "P3"});
  // Of several texts the one nearest to the middle; one that is far from all names none.
  CHECK(names(three + text(1, 1, "steel") + text(5, 5, "P1") + text(45, 40, "a title")) ==
        Names{"P1", "PARTS", "PARTS"});
  // Words without the codes for their format; a text with a faulty place is left out like others.
  CHECK(names(three + text(5, 5, "{\\fArial|b1;P\\H2x;1}\\Psteel", "MTEXT") +
              lines({{0, "TEXT"}, {8, "0"}, {10, "x"}, {20, 5}, {1, "no"}})) ==
        Names{"P1 steel", "PARTS", "PARTS"});
  // A drawing of one part keeps the name of its layer.
  CHECK(names(square_at(0) + text(5, 5, "P1")) == Names{"PARTS"});
  // Texts that became names were not left out.
  const auto notes = read(drawing(three + text(1, 1, "P1") + text(200, 0, "far"))).notes;
  CHECK(std::find(notes.begin(), notes.end(), "1 text was left out") != notes.end());
}

TEST_CASE("DXF: parts without a text are named by their blocks, unless all are in one copy of one",
          "[import][dxf]") {
  const auto names = [](const std::string& entities, const std::string& blocks) {
    std::vector<std::string> all;
    for (const ImportedShape& shape : read(drawing(entities, blocks)).shapes)
      all.push_back(shape.name);
    std::sort(all.begin(), all.end());
    return all;
  };
  using Names = std::vector<std::string>;
  const auto side = [](const Vec2& from, const Vec2& to) {
    return lines({{0, "LINE"}, {8, "CUT"}, {10, from.x}, {20, from.y}, {11, to.x}, {21, to.y}});
  };
  const std::string drawn = side({0, 0}, {2, 0}) + side({2, 0}, {0, 2}) + side({0, 2}, {0, 0});
  const std::string blocks =
      block("bracket", polyline(square, "CUT")) + block("gusset", drawn) +
      block("both", insert("bracket") + insert("gusset", {{10, 20}})) +
      block("*U7", polyline(square, "CUT")) +
      block("A3-Rahmen", polyline({{-9, -9}, {90, -9}, {90, 60}, {-9, 60}}, "CUT"));
  CHECK(names(insert("bracket") + insert("bracket", {{10, 9}}) + insert("gusset", {{10, 20}}),
              blocks) == Names{"bracket", "bracket", "gusset"});
  CHECK(names(insert("bracket", {{70, 2}, {44, 9}}), blocks) == Names{"bracket", "bracket"});
  CHECK(names(insert("both") + insert("both", {{20, 20}}), blocks) ==
        Names{"bracket", "bracket", "gusset", "gusset"});
  CHECK(names(insert("*U7") + insert("bracket", {{10, 20}}), blocks) == Names{"CUT", "bracket"});
  // A text is nearer to what people call a part.
  CHECK(names(insert("bracket") + insert("gusset", {{10, 20}}) +
                  lines({{0, "TEXT"}, {10, 2}, {20, 1.5}, {1, "P1"}}),
              blocks) == Names{"P1", "gusset"});
  // The block that is the whole drawing names nothing, and that of a border tells the sheet.
  CHECK(names(insert("all"), block("all", polyline(square, "CUT") +
                                              polyline({{9, 9}, {12, 9}, {12, 12}}, "LID"))) ==
        Names{"CUT", "LID"});
  const Import framed = read(drawing(insert("A3-Rahmen") + insert("bracket"), blocks));
  REQUIRE(framed.shapes.size() == 2);
  CHECK(framed.shapes[1].sheet);
  // A plate and its holes in one block are a plate, whatever the block's name.
  const Import plate = read(drawing(
      insert("Frame"),
      block("Frame", polyline({{0, 0}, {90, 0}, {90, 60}, {0, 60}}, "CUT") +
                         polyline(square, "CUT") + polyline({{9, 9}, {12, 9}, {12, 12}}, "CUT"))));
  REQUIRE(plate.shapes.size() == 1);
  CHECK(plate.shapes[0].document.holes.size() == 2);
}
