// In drawings, WKT, GeoJSON, Esri JSON and results.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/formats.h"
#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "kit/imported.h"

using namespace evenlift;
using evenlift::testing::read;
using evenlift::testing::refusal;

namespace {

using Words = std::vector<std::string>;

Words described(const Import& import) {
  Words words;
  for (const ImportedShape& shape : import.shapes) words.push_back(describe(shape));
  return words;
}

// "vertices + holes", such as "4" or "4+1".
Words counts(const std::string& text) {
  Words words;
  for (const ImportedShape& shape : read(text).shapes) {
    words.push_back(std::to_string(shape.document.vertices.size()));
    if (!shape.document.holes.empty())
      words.back() += "+" + std::to_string(shape.document.holes.size());
  }
  return words;
}

std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + content + "</svg>";
}

std::string dxf(const std::string& entities) {
  return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

std::string circle(double x, double y, double radius) {
  return "0\nCIRCLE\n10\n" + shortest(x) + "\n20\n" + shortest(y) + "\n40\n" + shortest(radius) +
         "\n";
}

std::string polyline(const Points& points) {
  std::string text = "0\nLWPOLYLINE\n70\n1\n";
  for (const Vec2& p : points) text += "10\n" + shortest(p.x) + "\n20\n" + shortest(p.y) + "\n";
  return text;
}

// From (x, x), in the direction of the numbers, or with '-' against it.
std::string ring(double x, double side, char direction = '+') {
  const std::string low = shortest(x), across = shortest(side), back = shortest(-side);
  return direction == '+' ? "M" + low + " " + low + "h" + across + "v" + across + "h" + back + "z"
                          : "M" + low + " " + low + "v" + across + "h" + across + "v" + back + "z";
}

Points square(double x, double side) {
  return {{x, x}, {x + side, x}, {x + side, x + side}, {x, x + side}};
}

// From its least vertex on, counter-clockwise.
Points in_order(Points points) {
  if (signed_area(points) < 0) std::reverse(points.begin(), points.end());
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::rotate(points.begin(), std::min_element(points.begin(), points.end(), before), points.end());
  return points;
}

std::vector<Points> in_order(const std::vector<Points>& rings) {
  std::vector<Points> all;
  for (const Points& one : rings) all.push_back(in_order(one));
  std::sort(all.begin(), all.end(), [](const Points& a, const Points& b) {
    return std::pair(a[0].x, a[0].y) < std::pair(b[0].x, b[0].y);
  });
  return all;
}

bool same_object(const Document& a, const Document& b) {
  return in_order(a.vertices) == in_order(b.vertices) && in_order(a.holes) == in_order(b.holes);
}

// With a jagged boundary, and stars as holes in some cells.
Document random_sheet(Rng& rng) {
  constexpr double cell = 10;
  const auto cells = static_cast<int>(1 + rng.below(4));
  const double side = cell * cells;
  Document sheet;
  const auto add = [&](const Vec2& from, const Vec2& along, const Vec2& out) {
    for (int i = 0; i < 2 * cells; ++i)
      sheet.vertices.push_back(from + along * (0.5 * cell * i) + out * (1 + 4 * rng.uniform()));
  };
  add({0, 0}, {1, 0}, {0, -1});
  add({side, 0}, {0, 1}, {1, 0});
  add({side, side}, {-1, 0}, {0, 1});
  add({0, side}, {0, -1}, {-1, 0});
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y) {
      if (rng.below(3) == 0) continue;
      const auto n = static_cast<std::uint32_t>(3 + rng.below(12));
      Points hole = *generate(Family::star, n, rng.below(1u << 30));
      const Box box = bounding_box(hole);
      const double scale = 8 / std::max(box.size().x, box.size().y);
      for (Vec2& p : hole) p = Vec2(cell * x + 1, cell * y + 1) + (p - box.low) * scale;
      if (rng.below(2) == 0) std::reverse(hole.begin(), hole.end());
      sheet.holes.push_back(std::move(hole));
    }
  return sheet;
}

std::string path_of(const Points& points) {
  std::string text;
  for (const Vec2& p : points)
    text += (text.empty() ? "M" : "L") + shortest(p.x) + " " + shortest(-p.y);
  return text + "z";
}

// Holes by a fill-rule, by paths without a fill, and by loops.
Words drawings_of(const Document& sheet) {
  std::string one = path_of(sheet.vertices), against = one, lines, dxf_loops;
  const bool turns = signed_area(sheet.vertices) > 0;
  dxf_loops = polyline(sheet.vertices);
  lines = "<path d='" + one + "'/>";
  for (Points hole : sheet.holes) {
    one += path_of(hole);
    lines += "<path d='" + path_of(hole) + "'/>";
    dxf_loops = polyline(hole) + dxf_loops;
    if ((signed_area(hole) > 0) == turns) std::reverse(hole.begin(), hole.end());
    against = path_of(hole) + against;
  }
  return {svg("<path fill-rule='evenodd' d='" + one + "'/>"), svg("<path d='" + against + "'/>"),
          svg("<path d='" + one + "'/>", "fill='none' stroke='red'"),
          svg(lines, "style='fill:none;stroke:red'"), dxf(dxf_loops)};
}

}  // namespace

TEST_CASE("thousands of sheets with holes come back from every format", "[import][holes][slow]") {
  Rng rng(20261127);
  for (int i = 0; i < 2000; ++i) {
    const Document sheet = random_sheet(rng);
    REQUIRE(object_of(sheet).ok());
    Words texts = drawings_of(sheet);
    texts.insert(texts.end(), {write_thesis(sheet), write_wkt(sheet), write_geojson(sheet)});
    for (const std::string& text : texts) {
      const Import import = read(text);
      REQUIRE(import.shapes.size() == 1);
      if (!same_object(import.shapes[0].document, sheet)) FAIL(text);
    }
    // A file of several: its shapes are ordered by area.
    const Import two = read(write_wkt(sheet) + write_wkt(sheet));
    REQUIRE(two.shapes.size() == 2);
    CHECK(same_object(two.shapes[1].document, sheet));
  }
}

TEST_CASE("SVG: a filled path has the holes that its fill-rule leaves", "[import][svg][holes]") {
  const std::string outer = ring(0, 90), hole = ring(10, 60, '-'), same = ring(10, 60),
                    island = ring(20, 30);
  struct Row {
    std::string content;
    Words shapes;
    bool noted = false;
  };
  const std::string odd = "fill-rule='evenodd'";
  const Row rows[] = {
      {"<path d='" + outer + hole + "'/>", {"4+1"}},
      {"<path d='" + hole + outer + "'/>", {"4+1"}},
      // The same direction changes nothing in the picture, so a hole was meant; this is told.
      {"<path d='" + outer + same + "'/>", {"4+1"}, true},
      {"<path d='" + outer + same + island + "'/>", {"4+1", "4"}, true},
      {"<path d='" + outer + hole + island + "'/>", {"4+1", "4"}},
      {"<path d='" + outer + same + "' " + odd + "/>", {"4+1"}},
      {"<path d='" + outer + same + island + "' " + odd + "/>", {"4+1", "4"}},
      {"<path d='" + outer + same + "' style='stroke:red;fill-rule:evenodd'/>", {"4+1"}},
      {"<style>.a{fill-rule:evenodd}</style><path class='a' d='" + outer + same + "'/>", {"4+1"}},
      {"<g " + odd + "><path d='" + outer + same + "'/></g>", {"4+1"}},
      {"<g " + odd + "><path d='" + outer + same + "' fill-rule='nonzero'/></g>", {"4+1"}, true},
      {"<g " + odd + "><path d='" + outer + same + "' fill-rule='inherit'/></g>", {"4+1"}},
      {"<g " + odd + "><path d='" + outer + same + "' style='fill-rule:initial'/></g>",
       {"4+1"},
       true},
      // Mirrored, turned and copied.
      {"<path transform='scale(-1 2)' d='" + outer + hole + "'/>", {"4+1"}},
      {"<defs><path id='p' d='" + outer + hole + "'/></defs><use href='#p' x='5'/>", {"4+1"}},
      // Neighbouring holes, and two shapes in a path.
      {"<path d='" + outer + ring(10, 20, '-') + ring(40, 20, '-') + "'/>", {"4+2"}},
      {"<path d='" + outer + hole + ring(100, 20) + ring(105, 5, '-') + "'/>", {"4+1", "4+1"}}};
  for (const Row& row : rows) {
    INFO(row.content);
    CHECK(counts(svg(row.content)) == row.shapes);
    CHECK(read(svg(row.content)).notes.empty() == !row.noted);
  }
}

TEST_CASE("SVG: shapes without a fill inside another are holes, filled ones are shapes",
          "[import][svg][holes]") {
  const std::string rect = "<rect width='90' height='90'", inner = "<path d='" + ring(10, 60) + "'",
                    line = " fill='none' stroke='red'/>",
                    innermost = "<path d='" + ring(20, 9) + "'";
  const auto shapes = [&](const std::string& content) { return counts(svg(content)); };
  CHECK(shapes(rect + line + inner + line) == Words{"4+1"});
  CHECK(shapes(inner + line + rect + line) == Words{"4+1"});
  CHECK(shapes(rect + "/>" + inner + line) == Words{"4+1"});
  CHECK(shapes(rect + "/>" + inner + "/>") == Words{"4", "4"});
  CHECK(shapes(rect + line + inner + "/>") == Words{"4", "4"});
  CHECK(shapes(rect + line + inner + line + innermost + line) == Words{"4+1", "4"});
  CHECK(shapes(rect + line + inner + "/>" + innermost + line) == Words{"4", "4+1"});
  CHECK(shapes(rect + line + inner + line + innermost + "/>") == Words{"4+1", "4"});
  // In the hole that a fill-rule leaves.
  const std::string plate = "<path d='" + ring(0, 90) + ring(10, 60, '-') + "'";
  CHECK(shapes(plate + "/>" + innermost + line) == Words{"4+1", "4"});
  CHECK(shapes(plate + "/>" + innermost + "/>") == Words{"4+1", "4"});
  CHECK(shapes(plate + "/>" + "<path d='" + ring(75, 9) + "'" + line) == Words{"4+2"});
  // A stroke repeats a fill with its holes, and the part cut out of it.
  CHECK(shapes(plate + "/>" + rect + line + inner + line) == Words{"4+1"});
  CHECK(shapes(plate + "/>" + inner + "/>") == Words{"4+1", "4"});
  CHECK(shapes(plate + "/>" + plate + "/>") == Words{"4+1"});
  // What no program shows is read as lines.
  CHECK(shapes(rect + " fill='none'/>" + inner + " fill='none'/>") == Words{"4+1"});
  CHECK(read(svg(rect + line + inner + line)).notes ==
        Words{"1 outline inside another was read as a hole"});
}

TEST_CASE("parts of a path have numbers if several are shapes", "[import][svg][holes]") {
  const auto words = [](const std::string& d, const std::string& fill) {
    return described(read(svg("<path id='a' d='" + d + "' " + fill + "/>")));
  };
  const std::string plate = ring(0, 90) + ring(10, 60, '-');
  const std::string line = "fill='none' stroke='red'";
  for (const std::string& fill : {std::string(), line}) {
    CHECK(words(plate, fill) == Words{"\"a\", path, 4 vertices, 1 hole, 90 x 90"});
    CHECK(words(plate + ring(100, 20), fill) ==
          Words{"\"a, part 1\", path, 4 vertices, 1 hole, 90 x 90",
                "\"a, part 3\", path, 4 vertices, 20 x 20"});
  }
}

TEST_CASE("the distance between edges and curves is that of the holes, too",
          "[import][svg][holes]") {
  const Import import = read(
      svg("<g fill='none' stroke='red'><path d='M0 0H120V80H0Z'/><circle cx='60' cy='40' r='5'/>"
          "<circle cx='60' cy='60' r='9'/></g>"));
  REQUIRE(import.shapes.size() == 1);
  CHECK(import.shapes[0].document.holes.size() == 2);
  CHECK(import.shapes[0].tolerance == 0.01);
  CHECK(import.notes == Words{"2 outlines inside others were read as holes"});
}

TEST_CASE("DXF: closed loops inside another are holes by their depth", "[import][dxf][holes]") {
  const std::string plate = polyline({{0, 0}, {120, 0}, {120, 80}, {0, 80}});
  std::string screws;
  for (const double x : {10.0, 110.0})
    for (const double y : {10.0, 70.0}) screws += circle(x, y, 3);
  const Import import = read(dxf(screws + plate));
  CHECK(described(import) == Words{"closed polyline, 4 vertices, 4 holes, 120 x 80"});
  CHECK(import.notes == Words{"4 outlines inside others were read as holes"});
  CHECK(object_of(import.shapes[0].document)->area() == Approx(9600 - 4 * 28.27).epsilon(1e-3));
  // A washer in a plate's hole is a shape with a hole.
  CHECK(counts(dxf(plate + circle(60, 40, 30) + circle(60, 40, 20) + circle(60, 40, 10))) ==
        Words{"4+1", "128+1"});
  // Crossing or touching loops are shapes.
  CHECK(counts(dxf(plate + circle(0, 40, 3))).size() == 2);
  CHECK(counts(dxf(plate + polyline(square(0, 20)))).size() == 2);
}

TEST_CASE("Esri JSON: a ring in another is its hole, with a notice if it runs the same way",
          "[import][json][holes]") {
  const std::string outer = "[[0,0],[0,90],[90,90],[90,0],[0,0]]",
                    hole = "[[10,10],[70,10],[70,70],[10,70],[10,10]]",
                    island = "[[20,20],[20,30],[30,30],[20,20]]",
                    other = "[[100,0],[100,9],[109,0],[100,0]]",
                    against = "[[100,0],[109,0],[100,9],[100,0]]";
  const auto shapes = [](const std::string& rings) {
    return counts("{\"rings\":[" + rings + "]}");
  };
  CHECK(shapes(outer + "," + hole) == Words{"4+1"});
  CHECK(shapes(hole + "," + other + "," + outer) == Words{"4+1", "3"});
  CHECK(shapes(outer + "," + hole + "," + island) == Words{"4+1", "3"});
  CHECK(shapes(outer + "," + island) == Words{"4+1"});
  CHECK(
      read("{\"rings\":[" + outer + "," + island + "]}").notes ==
      Words{
          "1 ring that runs the same way round as the ring around it was read as a hole, although "
          "the file fills it"});
  CHECK(shapes(outer + "," + against) == Words{"4", "3"});
  // A hole that touches the outline stays one, and is refused by name.
  const Import import = read("{\"rings\":[" + outer + ",[[0,10],[70,10],[70,70],[10,70],[0,10]]]}");
  REQUIRE(import.shapes.size() == 1);
  REQUIRE_FALSE(object_of(import.shapes[0].document).ok());
  CHECK(describe(object_of(import.shapes[0].document).error().place).find("hole 1") == 0);
}

TEST_CASE("rings of WKT and GeoJSON lose repeated vertices and heights", "[import][holes]") {
  const Import wkt =
      read("SRID=25832;POLYGON Z ((0 0 1,9 0 1,9 9 1,0 0 1),(6 1 2,8 1 2,8 1 2,8 3 2,6 1 2))");
  CHECK(wkt.shapes[0].document.holes == std::vector<Points>{{{6, 1}, {8, 1}, {8, 3}}});
  CHECK(wkt.notes.size() == 3);
  const Import json = read(
      R"({"type":"Feature","properties":{"centre_of_mass":[5,2]},"geometry":{"type":"MultiPolygon","coordinates":
      [[[[0,0,1],[9,0,1],[9,9,1],[0,0,1]],[[6,1,0],[8,1,0],[8,1,0],[8,3,0],[6,1,0]]]]}})");
  CHECK(json.shapes[0].document.holes == wkt.shapes[0].document.holes);
  CHECK(json.shapes[0].document.centre_of_mass == Vec2(5, 2));
  CHECK(refusal("POLYGON((0 0,9 0,9 9),(1 1,2 x))").find("line 1, column 30") == 0);
  CHECK(refusal(R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9]],[]]})") ==
        "line 1, column 54: the hole has no vertices");
}

TEST_CASE("holes can be left out, and a note says how many", "[import][holes]") {
  ImportOptions without;
  without.holes = false;
  const Document sheet = {.vertices = square(0, 90), .holes = {square(10, 9), square(30, 9)}};
  Words texts = drawings_of(sheet);
  texts.insert(texts.end(), {write_thesis(sheet), write_wkt(sheet), write_geojson(sheet)});
  for (const std::string& text : texts) {
    INFO(text);
    const Import import = read(text, without);
    REQUIRE(import.shapes.size() == 1);
    CHECK(import.shapes[0].document.holes.empty());
    CHECK(in_order(import.shapes[0].document.vertices) == square(0, 90));
    REQUIRE_FALSE(import.notes.empty());
    CHECK(import.notes[0].find("as holes") == std::string::npos);
    CHECK(std::count(import.notes.begin(), import.notes.end(), "2 holes are left out") == 1);
  }
  CHECK(read("POLYGON((0 0,9 0,9 9),(6 1,8 1,8 3))", without).notes == Words{"1 hole is left out"});
  CHECK(read("POLYGON((0 0,9 0,9 9))", without).notes.empty());
  // More holes than permitted.
  std::string many = "POLYGON((0 0,9 0,9 9)";
  for (std::size_t i = 0; i <= max_holes; ++i) many += ",(6 1,8 1,8 3)";
  CHECK(read(many + ")", without).notes == Words{"1001 holes are left out"});
  CHECK(refusal(many + ")").find("more than 1000 holes") != std::string::npos);
}

TEST_CASE("a result with holes and cargo is read back", "[import][json][holes][cargo]") {
  const std::string start = R"({"polygon":[[0,0],[10,0],[10,10],[0,10]],)";
  const std::string holes = R"("holes":[[[2,2],[4,2],[4,4],[2,4]]],)";
  const std::string cargo =
      R"("cargo":[{"at":[8,8],"weight":24,"name":"motor"},{"at":[21,0.5],"weight":0.5}],)";
  const auto document = [](const std::string& text) { return read(text).shapes[0].document; };
  const Document all = document(
      start + holes + cargo + R"("own_centre_of_mass":[5,6],"centre_of_mass":[7,7],"weight":96})");
  CHECK(all.holes == std::vector<Points>{square(2, 2)});
  CHECK(all.settings.cargo == std::vector<Cargo>{{{8, 8}, 24, "motor"}, {{21, 0.5}, 0.5, ""}});
  CHECK(all.settings.weight == 96);
  CHECK(all.centre_of_mass == Vec2(5, 6));
  // The object's centroid with holes, in every bit, counts as none given.
  const Vec2 centroid = object_of(all)->centroid();
  const std::string pair = "[" + shortest(centroid.x) + "," + shortest(centroid.y) + "]";
  CHECK_FALSE(
      document(start + holes + "\"own_centre_of_mass\":" + pair + ",\"centre_of_mass\":[7,7]}")
          .centre_of_mass);
  CHECK_FALSE(document(start + holes + "\"centre_of_mass\":" + pair + "}").centre_of_mass);
  CHECK(document(start + holes + R"("centre_of_mass":[5,5]})").centre_of_mass == Vec2(5, 5));
  CHECK_FALSE(document(start + R"("centre_of_mass":[5,5]})").centre_of_mass);
  CHECK_FALSE(
      document(start + R"("own_centre_of_mass":null,"centre_of_mass":[7,7]})").centre_of_mass);

  const auto wrong = [&](const std::string& member) {
    return refusal("{\"polygon\":[[0,0],[9,0],[9,9]],\n" + member + "}");
  };
  CHECK(wrong(R"("holes":3)").find("line 2, column 9: the holes must be an array") == 0);
  CHECK(wrong(R"("holes":[[]])") == "line 2, column 10: the hole has no vertices");
  CHECK(wrong(R"("holes":[[[1,"2"]]])").find("line 2, column 11: a point must be") == 0);
  CHECK(wrong(R"("cargo":{})").find("line 2, column 9: the cargo must be an array of loads like") ==
        0);
  for (const char* item : {"3", "{}", R"({"at":[1,1]})", R"({"at":[1,1],"weight":"3"})",
                           R"({"at":[1,1],"weight":3,"name":4})"})
    CHECK(wrong(std::string("\"cargo\":[") + item + "]").find("line 2, column ") == 0);
  CHECK(wrong(R"("cargo":[{"at":[1,1],"weight":0}])").find("must be a number greater than 0") !=
        std::string::npos);
  CHECK(wrong(R"("cargo":[{"at":[1,1],"weight":1,"name":"a\nb"}])").find("no control characters") !=
        std::string::npos);
  CHECK(wrong(R"("cargo":[{"at":[1,1],"weight":1,"name":")" + std::string(61, 'x') + R"("}])")
            .find("at most 60 characters") != std::string::npos);
}

TEST_CASE("degrees of holes and cargo are converted with the outline", "[import][holes]") {
  ImportOptions project;
  project.project = true;
  const Import import = read(
      "(8.541,47.376)\n(8.543,47.376)\n(8.543,47.378)\n(8.541,47.378)\nHole:\n(8.5415,47.3765)\n"
      "(8.542,47.3765)\n(8.542,47.377)\nCargo:(8.542,47.377) 3\n",
      project);
  const Document& document = import.shapes[0].document;
  CHECK(max_norm(document.settings.cargo[0].at) < 1e-6);
  CHECK(document.holes[0][2] == document.settings.cargo[0].at);
  CHECK(object_of(document).ok());
}

namespace {

std::string rectangle(double x, double y, double width, double height,
                      const std::string& more = "") {
  return "<rect x='" + shortest(x) + "' y='" + shortest(y) + "' width='" + shortest(width) +
         "' height='" + shortest(height) + "' " +
         (more.empty() ? "fill='none' stroke='red'" : more) + "/>";
}

Points square_at(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

std::string on_layer(const std::string& layer, std::string entity) {
  return entity.insert(entity.find('\n', 2) + 1, "8\n" + layer + "\n");
}

std::size_t sheets(const Import& import) {
  std::size_t count = 0;
  for (const ImportedShape& shape : import.shapes) count += shape.sheet;
  return count;
}

}  // namespace

TEST_CASE("a white page, or one as large as the view box, is no plate", "[import][holes]") {
  const std::string plate = rectangle(20, 20, 120, 80) + rectangle(40, 40, 10, 10);
  const std::string size = "viewBox='0 0 600 400'";
  for (const std::string& page :
       {rectangle(0, 0, 600, 400, "fill='white'"), rectangle(0, 0, 600, 400, "fill='#FFFFFF'"),
        rectangle(0, 0, 600, 400, "fill='#eee'"), rectangle(0, 0, 600, 400),
        rectangle(1, 1, 598, 398), std::string("<path fill='#ffffff' d='M0 0H600V400H0Z'/>")}) {
    INFO(page);
    const Import import = read(svg(page + plate, size));
    REQUIRE(import.shapes.size() == 2);
    CHECK(bounding_box(import.shapes[0].document.vertices).size() == Vec2(120, 80));
    CHECK(import.shapes[0].document.holes.size() == 1);
    CHECK(sheets(import) == 1);
  }
  const Import import = read(svg(rectangle(0, 0, 600, 400, "fill='white'") + plate, size));
  CHECK(import.notes.at(0) == "1 rectangle around all else was read as the sheet, and comes last");
  CHECK(describe(import.shapes[1]) == "sheet, rectangle, 4 vertices, 600 x 400");
  // A single outline on the page.
  CHECK(counts(svg(rectangle(0, 0, 600, 400, "fill='white'") + rectangle(20, 20, 120, 80), size)) ==
        Words{"4", "4"});
  // Filled parts, also with holes, on a page that is not white.
  const std::string filled =
      "<path fill='blue' fill-rule='evenodd' d='M20 20h90v90h-90zM40 40h9v9h-9z'/>";
  CHECK(counts(svg(rectangle(0, 0, 600, 400, "fill='gray'") + filled, size)) == Words{"4+1", "4"});
  // A plate that fills the page stays one, with its holes.
  const std::string hole = rectangle(40, 40, 10, 10);
  for (const char* look :
       {"fill='none' stroke='red'", "fill='white' stroke='black'", "fill='blue'"}) {
    INFO(look);
    CHECK(counts(svg(rectangle(0, 0, 600, 400, look) + hole, size)) == Words{"4+1"});
  }
  // Alone it is what there is.
  CHECK(sheets(read(svg(rectangle(0, 0, 600, 400, "fill='white'"), size))) == 0);
}

TEST_CASE("a frame, by its layer or by parts with holes in it, is no plate", "[import][holes]") {
  const std::string frame = polyline(square_at(0, 0, 300)), part = polyline(square_at(60, 60, 100));
  for (const char* layer : {"FRAME", "Border", "title block", "A3-Rahmen", "SHEET_1"}) {
    INFO(layer);
    CHECK(sheets(read(dxf(on_layer(layer, frame) + on_layer("PART", part)))) == 1);
  }
  CHECK(sheets(read(dxf(on_layer("Framework", frame) + on_layer("PART", part)))) == 0);
  // A plate with its hole, both on one layer, is a plate whatever the layer's name.
  const Import plate = read(dxf(on_layer("FRAME", frame) + on_layer("FRAME", part)));
  REQUIRE(plate.shapes.size() == 1);
  CHECK_FALSE(plate.shapes[0].sheet);
  CHECK(plate.shapes[0].document.holes.size() == 1);
  // If the hole is on a layer of its own, the sheet can still be chosen, with the hole.
  const Import apart = read(dxf(on_layer("FRAME", frame) + on_layer("CUT", part)));
  REQUIRE(apart.shapes.size() == 2);
  CHECK(apart.shapes[1].sheet);
  CHECK(apart.shapes[1].document.holes.size() == 1);
  // Without a name, a part with a hole of its own tells it; the parts are then its holes, too.
  const Import nested =
      read(dxf(frame + part + circle(100, 100, 20) + polyline(square_at(200, 200, 50))));
  REQUIRE(nested.shapes.size() == 3);
  CHECK(nested.shapes[0].document.holes.size() == 1);
  CHECK(nested.shapes[2].sheet);
  CHECK(nested.shapes[2].document.holes.size() == 2);
  // With a single part, it may be a plate with a ring in its hole.
  CHECK(sheets(read(dxf(frame + part + circle(100, 100, 20)))) == 0);
  // A second border within the first.
  const Import two = read(dxf(frame + polyline(square_at(10, 10, 280)) + part +
                              polyline(square_at(200, 200, 50)) + circle(100, 100, 20)));
  REQUIRE(two.shapes.size() == 4);
  CHECK(two.shapes[0].document.holes.size() == 1);
  CHECK(sheets(two) == 2);
}

TEST_CASE("a plate with holes stays one, however many they are", "[import][holes]") {
  const std::string plate = polyline(square_at(0, 0, 300));
  std::string holes;
  for (const double x : {30.0, 130.0, 230.0})
    for (const double y : {30.0, 130.0, 230.0}) holes += circle(x, y, 20);
  const Import drilled = read(dxf(plate + holes));
  REQUIRE(drilled.shapes.size() == 1);
  CHECK(drilled.shapes[0].document.holes.size() == 9);
  // Not a rectangle, or not around everything: no sheet.
  CHECK(sheets(read(dxf(polyline({{0, 0}, {300, 0}, {300, 310}, {0, 300}}) +
                        polyline(square_at(60, 60, 100)) + circle(100, 100, 20)))) == 0);
  CHECK(sheets(read(dxf(plate + polyline(square_at(60, 60, 100)) + circle(100, 100, 20) +
                        polyline(square_at(400, 0, 10))))) == 0);
}

TEST_CASE("outlines nested at any depth are each a shape or a hole of one", "[import][holes]") {
  Rng rng(8);
  for (int round = 0; round < 200; ++round) {
    // Squares in each other, some with a neighbour.
    std::string drawing;
    double at = 0, side = 1000;
    std::size_t outlines = 0;
    const std::size_t depth = 1 + rng.below(8);
    for (std::size_t level = 0; level < depth; ++level) {
      drawing += polyline(square_at(at, at, side));
      ++outlines;
      if (rng.below(3) == 0) {
        drawing += polyline(square_at(at + side * 0.8, at + side * 0.8, side * 0.1));
        ++outlines;
      }
      at += side * 0.1;
      side *= 0.5;
    }
    const Import import = read(dxf(drawing));
    INFO(drawing);
    std::size_t found = 0;
    for (const ImportedShape& shape : import.shapes) {
      found += 1 + (shape.sheet ? 0 : shape.document.holes.size());
      CHECK(
          PolygonWithHoles::create(*Polygon::create(shape.document.vertices), shape.document.holes)
              .ok());
    }
    CHECK(found == outlines);
    // Sheets come last.
    CHECK(std::is_partitioned(import.shapes.begin(), import.shapes.end(),
                              [](const ImportedShape& shape) { return !shape.sheet; }));
  }
}

TEST_CASE("a spike of no width is left out of a drawing", "[import]") {
  const auto vertices = [](const std::string& d) {
    return counts(svg("<path fill='none' stroke='red' d='" + d + "'/>"));
  };
  const Words four{"4"}, five{"5"};
  CHECK(vertices("M0 0H120V40H150H120V80H0Z") == five);  // its foot stays, on an edge
  CHECK(vertices("M0 0H120V80H0V-30Z") == four);         // at the first vertex
  CHECK(vertices("M0 0H150H120V80H0Z") == four);         // on from an edge
  CHECK(vertices("M0 0H120V40L150 50L180 60L120 40V80H0Z") == five);
  CHECK(vertices("M0 0H120V40L150 50L180 60L150 50L120 40V80H0Z") == five);
  // Nothing but spikes has no area.
  CHECK(
      refusal(svg("<path fill='none' stroke='red' d='M0 0H120H2000Z'/>")).find("no closed shape") !=
      std::string::npos);
  CHECK(vertices("M0 0H9V9Z M0 0H120H2000Z") == Words{"3"});
  // A narrow tooth is none.
  CHECK(vertices("M0 0H120V40H150V40.01H120V80H0Z") == Words{"8"});
  CHECK(read(svg("<path fill='none' stroke='red' d='M0 0H150H120V80H0Z'/>")).notes.at(0) ==
        "1 spike without a width was left out");
}
