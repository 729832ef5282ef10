#include "evenlift/import.h"

#include <cmath>
#include <filesystem>

#include "curves/outline.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/svg.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/random.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/imported.h"
#include "kit/json.h"
#include "kit/random_documents.h"

using namespace evenlift;
using evenlift::testing::only;
using evenlift::testing::read;
using evenlift::testing::refusal;
using evenlift::testing::same_vertices;

namespace {

Import read_data(const char* name, const ImportOptions& options = {}) {
  return read(corpus::read_file(std::filesystem::path(EVENLIFT_TESTS_DIR) / "data/import" / name),
              options);
}

std::string svg(const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\">" + inside + "</svg>";
}

std::string path(const std::string& d) { return svg("<path d=\"" + d + "\"/>"); }

std::vector<std::string> described(const Import& import) {
  std::vector<std::string> lines;
  for (const ImportedShape& shape : import.shapes) lines.push_back(describe(shape));
  return lines;
}

bool near(const Points& a, const Points& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec2& p, const Vec2& q) { return length(p - q) < 1e-9; });
}

// From the nearest edge.
double distance(const Points& edges, const Vec2& p, bool closed) {
  double best = HUGE_VAL;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < edges.size(); ++i) {
    const Vec2& a = edges[i];
    const Vec2 d = edges[(i + 1) % edges.size()] - a;
    const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
    best = std::min(best, length(p - a - t * d));
  }
  return best;
}

const Points triangle = {{0, 0}, {40, 0}, {10, 30.5}};

}  // namespace

// --- Curves

TEST_CASE("edges are nowhere farther from a cubic curve than the tolerance", "[import][curves]") {
  Rng rng(3);
  for (int i = 0; i < 300; ++i) {
    Vec2 c[4];
    for (Vec2& p : c) {
      p.x = rng.uniform() * 100;
      p.y = rng.uniform() * 100;
    }
    Outline outline;
    outline.start = c[0];
    outline.cubic_to(c[1], c[2], c[3]);
    const double tolerance = i % 2 == 0 ? 0.5 : 0.01;
    const std::optional<Points> edges = flatten(outline, tolerance, 100000);
    REQUIRE(edges);
    CHECK(same_vertices({edges->front(), edges->back()}, {c[0], c[3]}));
    CHECK(edges->size() < (i % 2 == 0 ? 70u : 400u));
    for (int k = 0; k <= 200; ++k) {
      const double t = k / 200.0, u = 1 - t;
      const Vec2 p =
          u * u * u * c[0] + 3 * u * u * t * c[1] + 3 * u * t * t * c[2] + t * t * t * c[3];
      if (distance(*edges, p, false) > tolerance * (1 + 1e-9)) FAIL("curve " << i << " at " << t);
    }
  }
}

TEST_CASE("edges are nowhere farther from an ellipse than the tolerance, whatever the map",
          "[import][curves]") {
  Rng rng(4);
  for (int i = 0; i < 200; ++i) {
    Affine frame;
    for (double* value : {&frame.a, &frame.b, &frame.c, &frame.d, &frame.e, &frame.f})
      *value = rng.uniform() * 20 - 10;
    const std::optional<Points> edges = flatten(Outline::ellipse(frame), 0.01, 100000);
    REQUIRE(edges);
    for (int k = 0; k < 300; ++k) {
      const double angle = 2 * M_PI * k / 300;
      const Vec2 p = frame({std::cos(angle), std::sin(angle)});
      if (distance(*edges, p, false) > 0.01 * (1 + 1e-9)) FAIL("ellipse " << i << " at " << angle);
    }
    // Its corners are on the ellipse, so it is no larger.
    const double determinant = frame.a * frame.d - frame.b * frame.c;
    for (const Vec2& p : *edges) {
      const Vec2 q = p - Vec2(frame.e, frame.f);
      const Vec2 unit((frame.d * q.x - frame.c * q.y) / determinant,
                      (frame.a * q.y - frame.b * q.x) / determinant);
      if (std::abs(length(unit) - 1) > 1e-6) FAIL("ellipse " << i);
    }
  }
}

TEST_CASE("a circle has no more edges than its tolerance asks for", "[import][curves]") {
  // Quarters are halved until edges are near: their distance is 100 (1 - cos(180° / edges)).
  const auto edges = [](double tolerance) {
    return flatten(Outline::ellipse({100, 0, 0, 100, 0, 0}), tolerance, 1000)->size() - 1;
  };
  CHECK(edges(29.3) == 4);
  CHECK(edges(29.2) == 8);
  CHECK(edges(7.62) == 8);
  CHECK(edges(7.6) == 16);
  CHECK(edges(0.121) == 64);
  CHECK(edges(0.12) == 128);
  CHECK(only(svg("<circle r='100'/>")).size() == 64);
}

TEST_CASE("an outline the other way round has the same points", "[import][curves]") {
  Outline outline;
  outline.start = {0, 0};
  outline.cubic_to({0, 8}, {6, 10}, {10, 0});
  outline.line_to({20, 5});
  outline.quadratic_to({29, 1}, {30, 12});
  outline.bulge_to({25, 30}, 0.3);
  std::optional<Points> there = flatten(outline, 0.1, 1000),
                        back = flatten(reversed(outline), 0.1, 1000);
  REQUIRE((there && back));
  std::reverse(back->begin(), back->end());
  REQUIRE(there->size() == back->size());
  CHECK(near(*there, *back));
}

TEST_CASE("a bulge makes the arc whose quarter angle has it as its tangent", "[import][curves]") {
  for (const double bulge :
       {0.01, 0.2, 0.41421356237309503, 0.5, 1.0, 3.0, 1e6, -0.3, -1.0, -8.0}) {
    Outline outline;
    outline.start = {2, 1};
    outline.bulge_to({5, 5}, bulge);
    const std::optional<Points> edges = flatten(outline, 1e-4, 1000000);
    REQUIRE(edges);
    CHECK(same_vertices({edges->front(), edges->back()}, {{2, 1}, {5, 5}}));
    // The circle through both ends that sees the chord at half of 4 atan(bulge).
    const Vec2 chord(3, 4), middle(3.5, 3);
    const Vec2 centre = middle + left_normal(chord) * ((1 - bulge * bulge) / (4 * bulge));
    const double radius = length(Vec2(2, 1) - centre);
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const Vec2& p : *edges) {
      CHECK(std::abs(length(p - centre) - radius) < 1e-7 * radius);
      const double beside = dot(p - middle, left_normal(chord)) / 5;
      lowest = std::min(lowest, beside);
      highest = std::max(highest, beside);
    }
    // It goes round the circle once at most.
    double way = 0;
    for (std::size_t i = 1; i < edges->size(); ++i) way += length((*edges)[i] - (*edges)[i - 1]);
    CHECK(way == Approx(radius * 4 * std::atan(std::abs(bulge))).epsilon(1e-3));
    // It sticks out by half the chord times the bulge, to the right if that is positive.
    CHECK(std::abs((bulge > 0 ? -lowest : highest) - std::abs(bulge) * 2.5) <
          1e-3 * std::max(1.0, std::abs(bulge)));
  }
}

// --- SVG

TEST_CASE("SVG: a triangle in all the ways in which it is drawn", "[import][svg]") {
  for (
      const std::string& text :
      {svg("<polygon points='0,0 40,0 10-30.5'/>"), svg("<polyline points='0,0 40,0 10-30.5'/>"),
       svg("<polygon points='0,0 40,0 10-30.5 0 0'/>"), path("M0 0L40 0 10,-30.5Z"),
       path("m0,0h40l-30-30.5z"), path("M0 0H40L1e1-30.5"), path("M10-30.5L0 0h40z M 1 1"),
       std::string("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:polygon s:points='' "
                   "points='0,0 40,0 10-30.5'/></s:svg>"),
       std::string("<svg><polygon points='&#x30;,0&#32;40,0 1&#48;-30.5'/></svg>"),
       svg("<g transform='translate(1 2)'><g transform='scale(2)rotate(90 1 1)'><polygon "
           "transform='translate(-.5,-1) scale(.5) rotate(-90, 2, 2)' points='0,0 40,0 "
           "10,-30.5'/></g></g>"),
       "<?xml version='1.0'?>\n<!DOCTYPE svg [<!ENTITY a 'b'>]><!-- a drawing -->\n" +
           svg("<defs><path d='M0 0C1 1 2 2 3 3'/></defs><title>T</title><polygon points='0 0 40 0 "
               "10 -30.5 0 0'/>")}) {
    const Points points = only(text);
    INFO(text);
    REQUIRE(points.size() == 3);
    Vec2 moved = points[0];
    if (text.find("M10") != std::string::npos) moved = points[1];
    bool found = false;
    for (std::size_t turn = 0; turn < 3; ++turn) {
      Points turned;
      for (std::size_t i = 0; i < 3; ++i)
        turned.push_back(points[(i + turn) % 3] - points[turn % 3]);
      found = found || near(turned, triangle);
    }
    CHECK(found);
  }
}

TEST_CASE("SVG: straight edges are taken to the last bit", "[import][svg]") {
  CHECK(same_vertices(only(path("M.1 .2 12345.6789 0 7e-3 -99.30000000000001z")),
                      {{0.1, -0.2}, {12345.6789, 0}, {0.007, 99.30000000000001}}));
}

TEST_CASE("SVG: layers, labels, holes, and what is left out", "[import][svg]") {
  const Import import = read_data("layers.svg");
  CHECK(import.format == "SVG");
  CHECK(described(import) ==
        std::vector<std::string>{"\"Layer 1\", path, 57 vertices, 1 hole, 130.8 x 122",
                                 "\"wheel\", circle, 64 vertices, 80 x 80",
                                 "\"plate\", rectangle with round corners, 20 vertices, 100 x 50"});
  CHECK(import.notes ==
        std::vector<std::string>{
            "1 text, 1 copy (<use>) without an original and 1 hidden element were left out"});
  CHECK(import.shapes[0].tolerance == 0.1);
  CHECK(import.shapes[1].tolerance == 0.05);
  for (const ImportedShape& shape : import.shapes) {
    INFO(describe(shape));
    CHECK(Polygon::create(shape.document.vertices).ok());
  }
  const Import finer = read_data("layers.svg", {0.001});
  CHECK(finer.shapes[1].tolerance == 0.001);
  CHECK(finer.shapes[1].document.vertices.size() == 512);
  // The wheel is about (60, 70) in user units, with y flipped.
  for (const Vec2& p : finer.shapes[1].document.vertices)
    CHECK(std::abs(length(p - Vec2(60, -70)) - 40) < 1e-9);
}

TEST_CASE("SVG: a size on paper that fits a unit names it, and the coordinates stay as they are",
          "[import][svg]") {
  const auto unit_of = [](const std::string& size) {
    const Import import = read("<svg " + size + "><path d=\"M0 0H30V40z\"/></svg>");
    CHECK(import.shapes.at(0).document.vertices.at(1).x == 30);
    CHECK((import.shapes[0].document.shown.units.length == LengthUnit::none) ==
          import.unit.empty());
    return import.unit;
  };
  CHECK(unit_of(R"(width="210mm" height="297mm" viewBox="0 0 210 297")") == "millimetres");
  CHECK(unit_of(R"(width="21cm" height="29.7cm" viewBox="0 0 210 297")") == "millimetres");
  CHECK(unit_of(R"(width="595.276pt" height="841.890pt" viewBox="0 0 210 297")") == "millimetres");
  CHECK(unit_of(R"(width="8.5in" height="11in" viewBox="0,0 8.5,11")") == "inches");
  CHECK(unit_of(R"(width="210mm" height="297mm" viewBox="-5 -5 21 29.7")") == "centimetres");
  // Without a size on paper above 0.
  CHECK(unit_of(R"(height="105mm" viewBox="0 0 210 105")") == "millimetres");
  CHECK(unit_of(R"(width="210mm" viewBox="0 0 210 105")") == "millimetres");
  CHECK(unit_of(R"(width="793.7" height="1122.52px" viewBox="0 0 210 297")").empty());
  CHECK(unit_of(R"(width="210mm" height="297mm" viewBox="0 0 0 297")").empty());
  CHECK(unit_of(R"(width="-210mm" height="1e999mm" viewBox="0 0 210 none")").empty());
}

TEST_CASE("SVG: smooth curves go on as the ones before, and flags may follow without a space",
          "[import][svg]") {
  const auto same = [](const char* a, const char* b) {
    INFO(a);
    CHECK(near(only(path(a)), only(path(b))));
  };
  same("M0 0C0 10 10 10 10 0S20 -10 20 0V30H0z", "M0 0C0 10 10 10 10 0C10 -10 20 -10 20 0V30H0z");
  same("M0 0q5 10 10 0t10 0v30h-20z", "M0 0Q5 10 10 0Q15 -10 20 0V30H0z");
  same("M0 0s0 10 10 10V30H0z", "M0 0C0 0 0 10 10 10V30H0z");
  same("M0 0a5 5 0 0110 0v9h-10z", "M0 0A5 5 0 0 1 10 0V9H0z");
  // Too small radii grow; 0 makes a line.
  same("M0 0a1 1 0 0110 0v9h-10z", "M0 0A5 5 0 0 1 10 0V9H0z");
  same("M0 0A0 3 0 0 1 10 0V9H0z", "M0 0H10V9H0z");
}

TEST_CASE("SVG: a radius may be negative, and smooth curves follow each other", "[import][svg]") {
  const auto same = [](const char* a, const char* b) {
    INFO(a);
    CHECK(near(only(path(a)), only(path(b))));
  };
  same("M0 0A-5 5 0 0 1 5 5L0 5Z", "M0 0A5 5 0 0 1 5 5L0 5Z");
  same("M0 0A5-5 0 0 1 5 5L0 5Z", "M0 0A5 5 0 0 1 5 5L0 5Z");
  same("M0 0C0 10 10 10 10 0S20-10 20 0S30 10 30 0V40H0z",
       "M0 0C0 10 10 10 10 0C10-10 20-10 20 0C20 10 30 10 30 0V40H0z");
  same("M0 0s0 10 10 10 10 0 10-10V30H0z", "M0 0C0 0 0 10 10 10C20 10 20 10 20 0V30H0z");
  same("M0 0q5 10 10 0t10 0t10 0v30h-30z", "M0 0Q5 10 10 0Q15-10 20 0Q25 10 30 0V30H0z");
}

TEST_CASE("SVG: an inch is as long in every unit", "[import][svg]") {
  for (const char* inch : {"1in", "96px", "96", "72pt", "6pc", "2.54cm", "25.4mm"}) {
    INFO(inch);
    const Points points = only(svg("<rect width='" + std::string(inch) + "' height='1pc'/>"));
    const Vec2 size = bounding_box(points).size();
    CHECK(size.x == Approx(96));
    CHECK(size.y == Approx(16));
  }
}

TEST_CASE("SVG: an arc's flags choose among four", "[import][svg]") {
  // From (0, 5) to (5, 0), radius 5: about (0, 0) or (5, 5), by the short or the long arc.
  const auto check = [](const char* flags, const Vec2& centre, const Vec2& low, const Vec2& high) {
    INFO(flags);
    const Import import = read(path("M0 5A5 5 0 " + std::string(flags) + " 5 0z"), {1e-6});
    const Points& points = import.shapes.at(0).document.vertices;
    for (const Vec2& p : points) CHECK(std::abs(length(Vec2(p.x, -p.y) - centre) - 5) < 1e-9);
    const Box box = bounding_box(points);
    CHECK(length(Vec2(box.low.x, -box.high.y) - low) < 1e-5);
    CHECK(length(Vec2(box.high.x, -box.low.y) - high) < 1e-5);
  };
  check("0 0", {0, 0}, {0, 0}, {5, 5});
  check("0 1", {5, 5}, {0, 0}, {5, 5});
  check("1 0", {5, 5}, {0, 0}, {10, 10});
  check("1 1", {0, 0}, {-5, -5}, {5, 5});
}

TEST_CASE("SVG: what cannot be read is said", "[import][svg]") {
  CHECK(refusal("<html></html>") == "this XML is not SVG: its root element is <html>");
  CHECK(refusal("<svg><g></svg>").find("the SVG is not well-formed XML") != std::string::npos);
  CHECK(refusal("<svg").find("the SVG is not well-formed XML") != std::string::npos);
  CHECK(refusal(svg("")) == "this SVG has no closed shape");
  CHECK(refusal(svg("<text>a</text><text>b</text>")).find("only 2 texts") != std::string::npos);
  CHECK(refusal("<svg>\n <path d='M0 0L4 0 x 4'/></svg>") ==
        "line 2, column 3: the SVG's path, character 10: expected a command here");
  CHECK(refusal(path("L0 0 1 1")).find("a path must begin with M") != std::string::npos);
  CHECK(refusal(path("M0 0L4 0 4")).find("character 11: expected a number") != std::string::npos);
  CHECK(refusal(path("M0 0A5 5 0 2 0 5 5")).find("expected 0 or 1") != std::string::npos);
  CHECK(refusal(svg("<polygon points='0,0 4,0 4'/>")).find("the last point has no y") !=
        std::string::npos);
  CHECK(refusal(svg("<polygon transform='perspective(3)' points='0,0 4,0 4,4'/>"))
            .find("the transform \"perspective(3)\" is not understood") != std::string::npos);
  CHECK(refusal(svg("<rect width='50%' height='3'/>")).find("\"50%\" is a part of a drawing") !=
        std::string::npos);
  CHECK(refusal(svg("<rect width='5em' height='3'/>")).find("unit of \"5em\"") !=
        std::string::npos);
  CHECK(refusal(svg("<style>rect{rotate:9deg}</style><rect width='3' height='3'/>"))
            .find("by the style \"rotate\"") != std::string::npos);
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<g>";
  for (int i = 0; i < 300; ++i) deep += "</g>";
  CHECK(refusal(svg(deep)).find("too deep") != std::string::npos);
  CHECK(refusal(path("M0 0h1e400v1z")).find("too large") != std::string::npos);
  CHECK(refusal(path("M0 0h1e300v1z")).find("beyond 1,000,000,000") != std::string::npos);
  // A bad shape is left out.
  const Import import = read(svg("<path d='M0 0 x'/><rect width='3' height='4'/>"));
  CHECK(described(import) == std::vector<std::string>{"rectangle, 4 vertices, 3 x 4"});
  REQUIRE(import.notes.size() == 1);
  CHECK(import.notes[0].find("1 shape was left out") != std::string::npos);
}

TEST_CASE("a picture that evenlift saved opens again as its document", "[import][svg]") {
  Document document = corpus::polygon("arrow");
  document.settings.teams = 5;
  document.settings.weight = 437.5;
  document.settings.method = Method::distance;
  const Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  const Result<std::string> link = encode_link(document);
  REQUIRE(link.ok());
  const Import import = read(placement_svg(*placement, *link));
  REQUIRE(import.shapes.size() == 1);
  const Document& again = import.shapes.front().document;
  CHECK(same_vertices(again.vertices, document.vertices));
  CHECK(again.centre_of_mass == document.centre_of_mass);
  CHECK(again.settings == document.settings);
}

TEST_CASE("a picture whose metadata has a link opens with all its settings", "[import][svg]") {
  Document document;
  document.vertices = triangle;
  document.settings.method = Method::circle;
  document.settings.teams = 2;
  const std::string link = *encode_link(document);
  for (const std::string& metadata :
       {"<metadata>" + link + "</metadata>",
        "<metadata><a href='https://example.org/#" + link + "'/></metadata>"}) {
    const Import import = read(svg(metadata + "<rect width='3' height='4'/>"));
    CHECK(import.has_settings);
    REQUIRE(import.shapes.size() == 1);
    CHECK(evenlift::testing::same_document(import.shapes[0].document, document));
  }
  const Import other = read(svg("<metadata>1.5</metadata><rect width='3' height='4'/>"));
  CHECK_FALSE(other.has_settings);
}

// --- DXF

TEST_CASE("DXF: polylines with bulges, circles, and chains of lines and arcs", "[import][dxf]") {
  const Import import = read_data("plate.dxf");
  CHECK(import.unit == "millimetres");
  for (const ImportedShape& shape : import.shapes)
    CHECK(shape.document.shown.units.length == LengthUnit::mm);
  CHECK(described(import) ==
        std::vector<std::string>{
            "\"outline\", closed polyline with arcs, 35 vertices, 1 hole, 125 x 50",
            "\"chain\", 3 lines and arcs, joined, 34 vertices, 15 x 10",
            "\"old\", closed polyline with arcs, 64 vertices, 8 x 8"});
  CHECK(import.shapes[0].document.holes.size() == 1);
  REQUIRE(import.notes.size() == 3);
  CHECK(
      import.notes[0] ==
      "1 line or arc does not close and was left out: the nearest open ends, (5, 5) and (6, 6), are 1.414 apart");
  CHECK(import.left_open == std::vector<Points>{{{5, 5}, {6, 6}}});
  CHECK(import.notes[2] ==
        "2 texts, 1 dimension and 1 block (INSERT) that the drawing does not define were left out");
  for (const ImportedShape& shape : import.shapes) {
    INFO(describe(shape));
    CHECK(Polygon::create(shape.document.vertices).ok());
  }
}

namespace {

std::string dxf(const std::string& entities) {
  return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace

TEST_CASE("DXF: a layer names its shapes, but layer 0 does not", "[import][dxf]") {
  const auto name_on = [](const std::string& layer) {
    return read(dxf("0\nCIRCLE\n8\n" + layer + "\n40\n5\n")).shapes.at(0).name;
  };
  CHECK(name_on("lid") == "lid");
  CHECK(name_on("0").empty());
}

TEST_CASE("DXF: what is seen from behind is turned round", "[import][dxf]") {
  const std::string plain =
      "0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n42\n0.5\n10\n4\n20\n4\n";
  const Points seen = only(dxf(plain)), mirrored = only(dxf(plain + "230\n-1\n"));
  REQUIRE(seen.size() == mirrored.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    CHECK(length(mirrored[i] - Vec2(-seen[i].x, seen[i].y)) < 1e-12);
}

TEST_CASE("DXF: of arcs seen from behind the last one turns round, too", "[import][dxf]") {
  const std::string behind = "230\n-1\n";
  // Half circles about (1, 0); from behind, about (-1, 0).
  const std::string circle = "0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n42\n1\n10\n2\n20\n0\n42\n1\n";
  for (const bool mirrored : {false, true}) {
    const Points points = only(dxf(circle + (mirrored ? behind : "")));
    INFO(mirrored);
    REQUIRE(points.size() > 30);
    for (const Vec2& p : points) CHECK(length(p - Vec2(mirrored ? -1 : 1, 0)) == Approx(1));
    CHECK(bounding_box(points).size().y == Approx(2));
  }
  // Half an ellipse above its axis; from behind, below.
  const std::string half =
      "0\nELLIPSE\n10\n0\n20\n0\n11\n1\n21\n0\n40\n1\n41\n0\n42\n3.141592653589793\n";
  const std::string axis = "0\nLINE\n10\n-1\n20\n0\n11\n1\n21\n0\n";
  const Box above = bounding_box(only(dxf(half + axis))),
            below = bounding_box(only(dxf(half + behind + axis)));
  CHECK(std::abs(above.low.y) < 1e-9);
  CHECK(above.high.y == Approx(1));
  CHECK(below.low.y == Approx(-1));
  CHECK(std::abs(below.high.y) < 1e-9);
}

TEST_CASE("DXF: ellipses and elliptical arcs", "[import][dxf]") {
  const std::string ellipse = "0\nELLIPSE\n10\n1\n20\n2\n11\n3\n21\n4\n40\n0.5\n";
  const Import whole = read(dxf(ellipse), {1e-3});
  for (const Vec2& p : whole.shapes[0].document.vertices) {
    const Vec2 q = p - Vec2(1, 2);
    const double along = dot(q, Vec2(3, 4)) / 25, across = cross(Vec2(3, 4), q) / 12.5;
    CHECK(std::abs(along * along + across * across - 1) < 1e-6);
  }
  // Its end is 2 pi with eight decimals, a little beyond the whole turn.
  const Import rounded = read(dxf(ellipse + "41\n0\n42\n6.28318531\n"), {1e-3});
  CHECK(rounded.shapes[0].document.vertices == whole.shapes[0].document.vertices);
  const std::string circle = "10\n1\n20\n2\n40\n5\n";
  CHECK(only(dxf("0\nARC\n" + circle + "50\n90\n51\n450.0000001\n")) ==
        only(dxf("0\nCIRCLE\n" + circle)));
  // Half of it, closed by a line.
  const Import half = read(
      dxf(ellipse + "41\n0\n42\n3.141592653589793\n" + "0\nLINE\n10\n4\n20\n6\n11\n-2\n21\n-2\n"));
  CHECK(half.shapes[0].kind == "2 lines and arcs, joined");
}

TEST_CASE("a B-spline is its pieces", "[import][curves]") {
  // By the recursion that defines its basis functions (de Boor, Cox).
  Rng rng(6);
  for (std::size_t degree = 1; degree <= 3; ++degree)
    for (int i = 0; i < 50; ++i) {
      Points control(degree + 1 + static_cast<std::size_t>(rng.uniform() * 6));
      for (Vec2& p : control) {
        p.x = rng.uniform() * 10;
        p.y = rng.uniform() * 10;
      }
      std::vector<double> knots(control.size() + degree + 1);
      for (double& knot : knots) knot = std::floor(rng.uniform() * 8);
      std::sort(knots.begin(), knots.end());
      const auto basis = [&](auto self, std::size_t k, std::size_t p, double t) -> double {
        if (p == 0) return knots[k] <= t && t < knots[k + 1] ? 1 : 0;
        const double a = knots[k + p] - knots[k], b = knots[k + p + 1] - knots[k + 1];
        return (a > 0 ? (t - knots[k]) / a * self(self, k, p - 1, t) : 0) +
               (b > 0 ? (knots[k + p + 1] - t) / b * self(self, k + 1, p - 1, t) : 0);
      };
      const auto outline = Outline::b_spline(control, knots, degree);
      const double first = knots[degree], last = knots[control.size()];
      bool whole = first < last;
      for (std::size_t k = 1; k + degree < knots.size(); ++k)
        if (knots[k] == knots[k + degree] && knots[k] > first && knots[k] < last) whole = false;
      REQUIRE(outline.has_value() == whole);
      if (!outline) continue;
      const std::optional<Points> edges = flatten(*outline, 1e-3, 100000);
      REQUIRE(edges);
      for (int s = 0; s < 100; ++s) {
        const double t = first + (last - first) * s / 100;
        Vec2 p;
        for (std::size_t k = 0; k < control.size(); ++k)
          p += basis(basis, k, degree, t) * control[k];
        if (distance(*edges, p, false) > 1.001e-3) FAIL("degree " << degree << " at " << t);
      }
    }
}

TEST_CASE("DXF: closed splines, and open ones in chains", "[import][dxf]") {
  const std::string arch =
      "0\nSPLINE\n71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n10\n0"
      "\n20\n9\n10\n9\n20\n9\n10\n9\n20\n0\n";
  const Import chain = read(dxf(arch + "0\nLINE\n11\n9\n"));
  CHECK(chain.shapes[0].kind == "2 lines and arcs, joined");
  CHECK(chain.shapes[0].document.vertices.size() == only(path("M0 0C0-9 9-9 9 0z")).size());
  const Import closed = read(dxf(
      "0\nSPLINE\n71\n2\n40\n0\n40\n1\n40\n2\n40\n3\n40\n4\n40\n5\n40\n6\n40\n7\n10\n0\n20\n0\n10\n9\n20\n0"
      "\n10\n5\n20\n8\n10\n0\n20\n0\n10\n9\n20\n0\n"));
  CHECK(closed.shapes[0].kind == "closed spline");
}

TEST_CASE("DXF: a spline whose ends nearly meet closes by itself", "[import][dxf]") {
  const auto point = [](const char* x, const char* y) {
    return std::string("10\n") + x + "\n20\n" + y + "\n";
  };
  const auto line = [&](const char* x, const char* y, const char* u, const char* v) {
    return "0\nLINE\n" + point(x, y) + "11\n" + u + "\n21\n" + v + "\n";
  };
  // In one piece, and with a gap small in the drawing but not in the spline.
  const std::string square = line("0", "0", "100", "0") + line("100", "0", "100", "100") +
                             line("100", "100", "0", "100") + line("0", "100", "0", "0");
  const std::string loop =
      "0\nSPLINE\n71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n" +
      point("20", "20") + point("30", "20") + point("20", "30") + point("20", "20.0005");
  const Import import = read(dxf(square + loop));
  REQUIRE(import.shapes.size() == 1);
  CHECK(import.shapes[0].kind == "4 lines and arcs, joined");
  CHECK(import.shapes[0].document.holes.size() == 1);
  // A line no longer than the gap makes no loop.
  const Import alone = read(dxf(square + line("20", "20", "20", "20.0005")));
  CHECK(alone.shapes.size() == 1);
}

TEST_CASE("DXF: what has no outline is refused with the reason", "[import][dxf]") {
  CHECK(
      refusal(dxf("0\nLINE\n10\n0\n20\n0\n11\n5\n21\n0\n")) ==
      "this DXF drawing has no closed outline: the nearest open ends, (0, 0) and (5, 0), are 5 apart");
  CHECK(
      refusal(dxf("0\nLINE\n10\n0\n20\n0\n11\n5\n21\n0\n0\nLINE\n10\n9\n20\n0\n11\n7\n21\n1\n")) ==
      "this DXF drawing has no closed outline: the nearest open ends, (5, 0) and (7, 1), are 2.236 apart");
  CHECK(refusal(dxf("0\nINSERT\n2\nbolt\n")) ==
        "this DXF drawing has no closed outline, only 1 block (INSERT) that the drawing does not "
        "define");
  CHECK(refusal(dxf("0\nSPLINE\n70\n1\n")).find("splines must be turned into polylines") !=
        std::string::npos);
  CHECK(
      refusal(dxf("0\nSPLINE\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n41\n1"
                  "\n10\n1\n20\n1\n41\n0.7\n10\n2\n20\n0\n41\n1\n"))
          .find("(0, 0) and (2, 0), are 2 apart") != std::string::npos);
  CHECK(refusal("0\nSECTION\n2\nENTITIES\n0\nLINE\n").find("cut off") != std::string::npos);
  CHECK(refusal("0\nSECTION\n2\nENTITIES\nzero\nLINE\n").find("line 5, column 1: ") == 0);
  CHECK(refusal(dxf("0\nCIRCLE\n40\n1,5\n")).find("line 8, column 1: expected a number") == 0);
  CHECK(refusal(std::string("AutoCAD Binary DXF\r\n\x1a\0", 22)).find("ASCII DXF") !=
        std::string::npos);
}

TEST_CASE("DXF: parts are chained whatever their order and direction", "[import][dxf]") {
  Rng rng(5);
  const Points corners = {{0, 0}, {9, 1}, {12, 7}, {5, 11}, {-3, 6}};
  for (int i = 0; i < 100; ++i) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      Vec2 a = corners[k], b = corners[(k + 1) % corners.size()];
      if (rng.uniform() < 0.5) std::swap(a, b);
      const auto text = [](double v) { return std::to_string(v); };
      lines.push_back("0\nLINE\n10\n" + text(a.x) + "\n20\n" + text(a.y + 4e-5 * rng.uniform()) +
                      "\n11\n" + text(b.x) + "\n21\n" + text(b.y) + "\n");
    }
    for (std::size_t k = lines.size(); k > 1; --k)
      std::swap(lines[k - 1], lines[static_cast<std::size_t>(rng.uniform() * double(k))]);
    std::string text;
    for (const std::string& line : lines) text += line;
    const Points points = only(dxf(text));
    CHECK(points.size() == corners.size());
    CHECK(Polygon::create(points).ok());
  }
}

// --- Columns

TEST_CASE("columns with every usual separator are the same triangle", "[import][columns]") {
  for (const char* text :
       {"0,0\n40,0\n10,30.5\n", "0, 0\r\n40, 0\r\n10, 30.5", "0 0\n40 0\n10 30.5",
        "  0   0\n\t40 0\n10 30.5\n\n", "0\t0\n40\t0\n10\t30.5\n", "0\t0\n40\t0\n10\t30,5\n",
        "0;0\n40;0\n10;30,5\n", "0|0\n40|0\n10|30.5\n", "x,y\n0,0\n40,0\n10,30.5\n",
        "y;x\n0;0\n0;40\n30,5;10\n", "\"X (mm)\",\"Y (mm)\"\n\"0\",\"0\"\n\"40\",\"0\"\n10,30.5\n",
        "name,x,y\nA,0,0\nB,40,0\nC,10,30.5\n", "A 0 0\nB 40 0\nC 10 30.5\n",
        "# a comment\n0,0\n40,0\n# another\n10,30.5\n0,0\n", "x\ty\n0\t0\n40\t0\n10\t30.5\n",
        "\ufeff0;0\n40;0\n10;30.5\n", "[[0,0],[40,0],[10,30.5]]",
        "[{\"x\":0,\"y\":0},{\"y\":0,\"x\":40},{\"x\":10,\"y\":30.5}]",
        "[[[0,0],[40,0],[10,30.5]]]"}) {
    INFO(text);
    CHECK(same_vertices(only(text), triangle));
  }
}

TEST_CASE("columns: a heading chooses, blank lines part, names stand above", "[import][columns]") {
  const Import sheet = read_data("spreadsheet.csv");
  CHECK(same_vertices(sheet.shapes.at(0).document.vertices, {{0.5, 1}, {10.5, 1}, {10.5, 7.25}}));
  const Import two = read("Table\n0 0\n4 0\n4 3\n\nShelf\n0 0\n9 0\n9 2\n0 2\n");
  CHECK(described(two) == std::vector<std::string>{"\"Table\", points, 3 vertices, 4 x 3",
                                                   "\"Shelf\", points, 4 vertices, 9 x 2"});
  const Import heights = read("0 0 7\n4 0 7\n4 3 7\n");
  CHECK(heights.notes ==
        std::vector<std::string>{"the first two columns with numbers were taken as x and y"});
}

TEST_CASE("columns: a heading that names one unit for x and y sets it", "[import][columns]") {
  const auto unit_under = [](const std::string& heading) {
    return read(heading + "\n0;0\n4;0\n4;3\n").shapes.at(0).document.shown.units.length;
  };
  CHECK(unit_under("X (mm);Y (mm)") == LengthUnit::mm);
  CHECK(unit_under("x_cm;y_cm") == LengthUnit::cm);
  CHECK(unit_under("\"x [in]\";\"y [in]\"") == LengthUnit::in);
  CHECK(unit_under("x/M;y/m") == LengthUnit::m);
  CHECK(unit_under("x;y") == LengthUnit::none);
  CHECK(unit_under("x (mm);y") == LengthUnit::none);
  CHECK(unit_under("x (furlongs);y (furlongs)") == LengthUnit::none);
  CHECK(read("x (mm);y (mm)\n0;0\n4;0\n4;3\n").unit == "millimetres");
}

TEST_CASE("columns: what can be read in two ways is refused", "[import][columns]") {
  CHECK(refusal("1,5 2,3\n3,4 5,6\n6,1 1,1\n").find("(1,5; 2,3)") != std::string::npos);
  CHECK(refusal("1.234,5;0\n1;2\n3;4\n").find("no separator between its thousands") !=
        std::string::npos);
  CHECK(refusal("0,0\n4,0\n4,x\n") == "line 3, column 3: \"x\" is not a number");
  CHECK(refusal("x;y\n0; 0\n4; \"abc\"\n") == "line 3, column 5: \"abc\" is not a number");
  CHECK(refusal("0,0\n4\n4,3\n") == "line 2, column 1: the line has no y");
  CHECK(refusal("5\n").find("two numbers, x and y") != std::string::npos);
  CHECK(refusal("hello world\n").find("evenlift reads lines") != std::string::npos);
  for (const char* poses :
       {"{\"frame\": \"object\", \"origin\": \"file\", \"robots\": []}",
        "# geometry_msgs/msg/PoseArray, in metres\nheader:\n  frame_id: \"object\"\nposes:\n"})
    CHECK(refusal(poses).find("the robots of a result") != std::string::npos);
  CHECK(refusal("robot,team,end,x,y,load,share_of_team,load_ratio\n1,1,r1,0,0,1,1,1\n")
            .find("the robots of a result") != std::string::npos);
  CHECK(refusal("set,polygon,method,teams\na,b,area,1\n").find("a table of an experiment") !=
        std::string::npos);
}

// --- JSON

TEST_CASE("GeoJSON: every polygon of a collection, by its name", "[import][geojson]") {
  const Import import = read_data("parcels.geojson");
  CHECK(described(import) ==
        std::vector<std::string>{"\"Lake with an island\", polygon, 3 vertices, 1 hole, 4 x 3",
                                 "\"Lake with an island\", polygon, 3 vertices, 4 x 4",
                                 "\"17\", polygon, 3 vertices, 6 x 6"});
  CHECK(import.shapes[2].document.centre_of_mass == Vec2(1, 1));
  CHECK(import.notes ==
        std::vector<std::string>{"coordinates beyond x and y were left out",
                                 "1 Point and 1 feature without a geometry were left out"});
  CHECK(refusal(R"({"type":"Point","coordinates":[1,2]})") ==
        "this GeoJSON has no polygon, only 1 Point");
  CHECK(refusal("{}").find("neither GeoJSON") != std::string::npos);
}

TEST_CASE("JSON that a script assigns to a variable is read as JSON", "[import][geojson]") {
  const std::string json = R"({"type":"Polygon",
 "coordinates":[[[0,0],[30,0],[30,20.5],[0,0]]]})";
  for (const char* before : {"features = ", "var plate =\n", "const a.b_1 = "})
    for (const char* after : {"", ";", ";\n"}) {
      const Result<Import> import = read_shapes(before + json + after);
      REQUIRE(import);
      CHECK(import->shapes[0].document.vertices == Points{{0, 0}, {30, 0}, {30, 20.5}});
    }
  CHECK(read_shapes("points = [(0, 0), (30, 0), (30, 20.5)]"));
  CHECK_FALSE(read_shapes("f(" + json + ")"));
  CHECK_FALSE(read_shapes("a = " + json + "; b()"));
  CHECK(refusal("a = [[0, 0], [30, 0],\n[30]]").find("line 2, column 4") == 0);
}

TEST_CASE("a result opens again with all its settings", "[import][json]") {
  Document document;
  document.vertices = triangle;
  document.settings = {.teams = 2, .method = Method::random, .min_ratio = 0.7, .weight = 12.5};
  document.settings.seed = 18446744073709551615u;
  for (const auto& centre : {std::optional<Vec2>(), std::optional<Vec2>({17, 9})}) {
    document.centre_of_mass = centre;
    const Result<Placement> placement = place(document);
    REQUIRE(placement.ok());
    Document with_capacity = document;
    with_capacity.shown.capacity = 40;
    const ShownPlacement shown(*placement, with_capacity.shown);
    const Import result = read(placement_json(shown, true, {.plans = true}));
    CHECK(result.has_settings);
    CHECK(evenlift::testing::same_document(result.shapes.at(0).document, with_capacity));
    Document doubted = document;
    doubted.shown.com_radius = 2.5;
    const Import ranges = read(placement_json({*placement, doubted.shown}, false));
    CHECK(evenlift::testing::same_document(ranges.shapes.at(0).document, doubted));
    Document with_picture = document;
    with_picture.shown.overlays = {true, false, false, true, false, true, true};
    with_picture.shown.capacity = 17.5;
    with_picture.shown.com_radius = 0.25;
    with_picture.shown.step = 12;
    with_picture.settings.robot = {1, 0, 2.5, 1e-3, 0};
    with_picture.settings.no_go = {{0, 0.25, 0.5}, {1, 0, 1}};
    with_picture.settings.method = Method::area;
    with_picture.settings.teams.reset();
    const Import decoded = read(document_json(with_picture));
    CHECK(evenlift::testing::same_document(decoded.shapes.at(0).document, with_picture));
  }
  CHECK(refusal(R"({"polygon":[[0,0],[1,0],[1,1]],"metric":"best"})").find("method") !=
        std::string::npos);
}

TEST_CASE("a result with balanced robots opens again with what was asked", "[import][balanced]") {
  Document document;
  document.vertices = triangle;
  document.settings.teams = 1;
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  document.settings.goal = Goal::cover;
  document.settings.min_margin = 0.1;
  document.settings.apart = 0.25;
  document.settings.survive = 1;
  const Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  const Import result = read(placement_json(*placement, false));
  CHECK(result.shapes.at(0).document.settings == document.settings);
  CHECK(read(document_json(document)).shapes.at(0).document.settings == document.settings);
  document.settings.goal.reset();
  document.settings.apart.reset();
  CHECK(read(document_json(document)).shapes.at(0).document.settings == document.settings);
  // Another method afterwards gets the same as from a link: the requested number of teams, the
  // usual goal.
  for (const std::optional<std::uint32_t>& teams :
       {std::optional<std::uint32_t>(3), std::optional<std::uint32_t>(7),
        std::optional<std::uint32_t>()}) {
    document.settings.teams = teams;
    const Import asked = read(placement_json(place(document).value(), false));
    CHECK(asked.shapes.at(0).document.settings == document.settings);
  }
}

TEST_CASE("a result with all teams or with other overlays opens again with these",
          "[import][json]") {
  Document document;
  document.vertices = triangle;
  document.settings.teams.reset();
  document.shown.overlays = {true, false, false, true, false, true, true};
  const Import result = read(placement_json({place(document).value(), document.shown}, false));
  CHECK(evenlift::testing::same_document(result.shapes.at(0).document, document));
}

TEST_CASE("a result of teams that hold in ranges opens again with what was asked", "[import]") {
  Document document;
  document.vertices = triangle;
  document.settings.positions = Positions::range;
  document.settings.goal = Goal::hold;
  document.settings.min_margin = 0.125;
  for (const bool holds : {true, false}) {
    if (!holds) {
      document.settings.goal.reset();
      document.settings.min_margin = Settings{}.min_margin;
    }
    const Result<Placement> placement = place(document);
    REQUIRE(placement.ok());
    CHECK(read(placement_json(*placement, false)).shapes.at(0).document.settings ==
          document.settings);
  }
}

// --- All of them

TEST_CASE("what read_polygon reads is read alike", "[import]") {
  for (const std::string& name : corpus::polygon_names()) {
    const Document document = corpus::polygon(name);
    for (const std::string& text :
         {write_thesis(document), write_geojson(document), corpus::polygon_text(name)}) {
      const Import import = read(text);
      REQUIRE(import.shapes.size() == 1);
      CHECK(evenlift::testing::same_document(import.shapes[0].document, document));
    }
    CHECK(same_vertices(only(write_wkt(document)), document.vertices));
    const Result<std::string> link = encode_link(document);
    CHECK(evenlift::testing::same_document(read(*link + "\n").shapes[0].document, document));
  }
}

TEST_CASE("files of other kinds are refused with what to do", "[import]") {
  CHECK(refusal("%PDF-1.4").find("save it as SVG") != std::string::npos);
  CHECK(refusal("\x89PNG\r\n").find("trace it") != std::string::npos);
  CHECK(refusal("PK\x03\x04").find("CSV") != std::string::npos);
  CHECK(refusal(std::string("\0\0", 2)).find("not text") != std::string::npos);
  CHECK(refusal("Isle of Man\n1\n\t8.1 47.0\n\t8.2 47.0\n\t8.2 47.1\nEND\nEND\n").find("(.poly)") !=
        std::string::npos);
  CHECK(refusal("plate\nouter\n 0 0\n 30 0\n 30 20\nEND PLATE\n") ==
        "line 6, column 1: \"END\" is not a number");
  CHECK(refusal("").find("the text is empty") != std::string::npos);
  CHECK_FALSE(read_shapes("0 0\n1 0\n1 1\n", {-1.0}).ok());
  CHECK_FALSE(read_shapes("0 0\n1 0\n1 1\n", {HUGE_VAL}).ok());
}

TEST_CASE("bounds are kept", "[import][slow]") {
  std::string many;
  for (int i = 0; i < 10001; ++i) many += "<rect width='1' height='1'/>";
  CHECK(refusal(svg(many)).find("more than 10000 shapes") != std::string::npos);
  const Result<Import> fine = read_shapes(svg("<circle r='9'/>"), {1e-300});
  REQUIRE(!fine.ok());
  CHECK(fine.error().code == ErrorCode::too_many_vertices);
  std::string long_path = "M0 0";
  for (int i = 0; i < 1100000; ++i) long_path += i % 2 ? "h1" : "v1";
  CHECK(refusal(path(long_path)).find("1048576 vertices") != std::string::npos);
}

TEST_CASE("names are plain text in one line", "[import]") {
  const auto name = [](const std::string& id) {
    return read(svg("<rect id='" + id + "' width='1' height='1'/>")).shapes.at(0).name;
  };
  CHECK(name("Gr\xc3\xb6\xc3\x9f"
             "e") ==
        "Gr\xc3\xb6\xc3\x9f"
        "e");
  CHECK(name("a\n b\t\tc \x7f") == "a b c");
  CHECK(name("bad\xff\xc3 bytes") == "bad bytes");
  CHECK(name(std::string(500, 'a')).size() == 80);
}

TEST_CASE("results and links of 1.0.0 and 1.0.1 are read as ever", "[import][link]") {
  const std::filesystem::path folder =
      std::filesystem::path(EVENLIFT_TESTS_DIR) / "data" / "results";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    INFO(entry.path());
    const Import result = read(corpus::read_file(entry.path()));
    std::filesystem::path linked = entry.path();
    std::string link = corpus::read_file(linked.replace_extension(".link"));
    const Result<Document> document = decode_link(link.substr(0, link.find('\n')));
    REQUIRE(document.ok());
    const Document& found = result.shapes.at(0).document;
    CHECK(found.vertices == document->vertices);
    CHECK(found.centre_of_mass == document->centre_of_mass);
    // A result always names its goal, of which the usual one counts as unset.
    CHECK(goal_of(found.settings) == goal_of(document->settings));
    for (const SettingRow& row : all_settings()) {
      INFO(row.name);
      if (row.setting != Setting::goal)
        CHECK(text_of(row.setting, found) == text_of(row.setting, *document));
    }
    const auto then = testing::Json::parse(corpus::read_file(entry.path()));
    const Result<Placement> now = place(found);
    REQUIRE(now.ok());
    CHECK(now->requested_teams == then["requested_teams"].whole_number());
  }
  CHECK(files == 10);
}
