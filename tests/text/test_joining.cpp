// Pieces of drawings, joined into outlines.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "evenlift/import.h"
#include "evenlift/numbers.h"
#include "evenlift/plane.h"
#include "evenlift/random.h"
#include "import/joining/joining.h"
#include "kit/catch.h"

using namespace evenlift;

namespace {

DrawnPiece line(const Vec2& from, const Vec2& to, const std::string& layer = "") {
  Outline outline;
  outline.start = from;
  outline.line_to(to);
  return {outline, layer};
}

std::vector<DrawnPiece> sides(const Points& corners, const std::string& layer = "") {
  std::vector<DrawnPiece> pieces;
  for (std::size_t i = 0; i < corners.size(); ++i)
    pieces.push_back(line(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1], layer));
  return pieces;
}

Points corners_of(const Outline& outline) {
  Points corners;
  for (const CurvePiece& piece : outline.pieces) corners.push_back(piece.end);
  return corners;
}

// The largest first.
std::vector<double> areas(const Joining& joining) {
  std::vector<double> all;
  for (const JoinedOutline& joined : joining.outlines)
    all.push_back(signed_area(corners_of(joined.outline)));
  std::sort(all.rbegin(), all.rend());
  return all;
}

std::vector<DrawnPiece> operator+(std::vector<DrawnPiece> a, const std::vector<DrawnPiece>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// From its least corner on, counter-clockwise.
Points in_order(Points ring) {
  if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), before), ring.end());
  return ring;
}

const Points plate = {{0, 0}, {120, 0}, {120, 80}, {0, 80}};

template <class T>
void shuffle(std::vector<T>& all, Rng& random) {
  for (std::size_t i = all.size(); i > 1; --i)
    std::swap(all[i - 1], all[static_cast<std::size_t>(random.below(i))]);
}

}  // namespace

TEST_CASE("outlines that close alone stay whole where one's corners touch the other's edges",
          "[joining][import]") {
  // One corner touches an edge that two others cross; and a hole with two corners on the edges.
  const Points pentagon = {{10, 80}, {15, 83}, {18, 81}, {18, 79}, {15, 77}};
  const Points diamond = {{0, 40}, {60, 0}, {115, 40}, {60, 75}};
  for (const Points& other : {pentagon, diamond}) {
    const double area = signed_area(other) < 0 ? -signed_area(other) : signed_area(other);
    const Joining joining = join(sides(plate) + sides(other));
    CHECK(areas(joining) == std::vector<double>{120 * 80, area});
    CHECK(joining.open.empty());
  }
  // So it is where ends of the other have a gap that is joined.
  std::vector<DrawnPiece> gapped = sides(pentagon);
  gapped[0] = line({10, 80.001}, {15, 83});
  CHECK(areas(join(sides(plate) + gapped)).size() == 2);
  // Two outlines that share a part of a line are two shapes, and neither has the other's area.
  CHECK(areas(join(sides(plate) + sides({{20, 0}, {50, 0}, {50, 20}, {20, 20}}))) ==
        std::vector<double>{120 * 80 - 30 * 20, 30 * 20});
  // A line between two edges still cuts the plate.
  CHECK(areas(join(sides(plate) + std::vector<DrawnPiece>{line({50, 0}, {50, 80})})) ==
        std::vector<double>{70 * 80, 50 * 80});
}

TEST_CASE("lines become the outline that they draw, in whatever order and direction",
          "[joining][import]") {
  std::vector<DrawnPiece> pieces = sides(plate);
  std::swap(pieces[0], pieces[2]);
  pieces[1].outline = reversed(pieces[1].outline);
  const Joining joining = join(pieces);
  REQUIRE(joining.outlines.size() == 1);
  CHECK(joining.outlines[0].parts == 4);
  CHECK(joining.outlines[0].outline.start == Vec2(0, 0));
  CHECK(corners_of(joining.outlines[0].outline) == Points{{120, 0}, {120, 80}, {0, 80}, {0, 0}});
  CHECK(joining.open.empty());
  CHECK(joining.gap == 0);
}

TEST_CASE("stray lines, doubled lines and lines between outlines are left out",
          "[joining][import]") {
  const auto stray = std::vector{line({120, 0}, {60, 40}), line({60, 40}, {50, 40})};
  CHECK(areas(join(stray + sides(plate))) == std::vector{9600.0});
  CHECK(join(stray + sides(plate)).open == std::vector<std::size_t>{0, 1});
  const Joining doubled = join(sides(plate) + sides(plate) + sides(plate));
  CHECK(areas(doubled) == std::vector{9600.0});
  CHECK(doubled.repeated == 8);
  CHECK(doubled.open.empty());
  // A line to another outline, and a part of a side drawn again.
  const Points far = {{200, 0}, {240, 0}, {240, 40}, {200, 40}};
  const Joining bridged = join(
      sides(plate) + std::vector{line({120, 0}, {200, 0}), line({30, 0}, {90, 0})} + sides(far));
  CHECK(areas(bridged) == std::vector{9600.0, 1600.0});
}

TEST_CASE(
    "parts that share a line are shapes of their own, also where it ends in the middle of a side",
    "[joining][import]") {
  const std::vector<DrawnPiece> cut = {line({50, 0}, {50, 80})};
  CHECK(areas(join(sides(plate) + cut)) == std::vector{5600.0, 4000.0});
  // The end divides the side, but a stray one leaves no vertex.
  const Joining stray = join(sides(plate) + std::vector{line({50, 0}, {50, 30})});
  REQUIRE(stray.outlines.size() == 1);
  CHECK(stray.outlines[0].outline.pieces.size() == 4);
}

TEST_CASE("gaps are closed where something stays open, and told", "[joining][import]") {
  for (const double gap : {1e-9, 1e-6, 0.0005, 0.002, 0.1}) {
    CAPTURE(gap);
    std::vector<DrawnPiece> pieces = sides(plate);
    pieces[0].outline.pieces[0].end.x -= gap;
    const Joining joining = join(pieces);
    REQUIRE(joining.outlines.size() == 1);
    CHECK(areas(joining)[0] == Approx(9600).epsilon(1e-3));
    CHECK(joining.gap_is_seen == (gap > 0.0018));
    if (joining.gap_is_seen) CHECK(joining.gap == Approx(gap));
  }
  std::vector<DrawnPiece> wide = sides(plate);
  wide[0].outline.pieces[0].end.x -= 1;
  CHECK(join(wide).outlines.empty());
  REQUIRE(join(wide).apart);
  CHECK(length(join(wide).apart->first - join(wide).apart->second) == 1);
  CHECK(areas(join(wide, 1.5)).size() == 1);
  // A straight line bridges a wide gap; no corner moves.
  const Joining open =
      join({line({0, 0}, {120, 0}), line({120, 0}, {120, 80}), line({120, 80}, {0, 80})}, 90.0);
  CHECK(areas(open) == std::vector{9600.0});
  CHECK(open.gap == 80);
  wide[0].outline.pieces[0].end.x += 0.998;
  CHECK(join(wide, 0.001).outlines.empty());  // finer than usual
}

TEST_CASE("layers are joined apart, and together only where nothing closes otherwise",
          "[joining][import]") {
  std::vector<DrawnPiece> pieces = sides(plate);
  pieces[2].layer = pieces[3].layer = "EDGE";
  Joining joining = join(pieces);
  REQUIRE(joining.outlines.size() == 1);
  CHECK(joining.outlines[0].across_layers);
  // Touching outlines on two layers keep apart.
  joining = join(sides(plate, "A") + sides({{60, 0}, {180, 0}, {180, 80}, {60, 80}}, "B"));
  CHECK(areas(joining) == std::vector{9600.0, 9600.0});
  for (const JoinedOutline& joined : joining.outlines) CHECK_FALSE(joined.across_layers);
}

TEST_CASE("arcs bound faces with lines, and between the same ends", "[joining][import]") {
  Outline arc;
  arc.start = {0, 0};
  arc.bulge_to({10, 0}, 1);  // half a circle below
  Outline upper;
  upper.start = {10, 0};
  upper.bulge_to({0, 0}, 1);
  const std::vector<DrawnPiece> circle = {{arc, ""}, {upper, ""}};
  CHECK(join(circle).outlines.size() == 1);
  CHECK(join(circle + std::vector{line({0, 0}, {10, 0})}).outlines.size() == 2);
}

TEST_CASE("any polygon with holes, in pieces, comes back", "[joining][import][slow]") {
  Rng random(20261126);
  for (int number = 0; number < 2000; ++number) {
    const auto n = static_cast<std::uint32_t>(4 + random.below(30));
    const Points outline = *generate(Family::star, n, random.below(1u << 30));
    const Box box = bounding_box(outline);
    const double side = std::max(box.size().x, box.size().y);
    CAPTURE(number, n);
    std::vector<DrawnPiece> pieces = sides(outline);
    // Split in the middle, repeated, reversed, perhaps on two layers, and shuffled.
    const std::size_t whole = pieces.size();
    for (std::size_t i = 0; i < whole; ++i) {
      if (random.below(4) == 0) pieces.push_back(pieces[i]);
      if (random.below(3) == 0) pieces[i].outline = reversed(pieces[i].outline);
      if (random.below(5) > 0) continue;
      const Vec2 from = pieces[i].outline.start, to = pieces[i].outline.end();
      const Vec2 middle = from + (to - from) / 4;
      pieces[i] = line(from, middle);
      pieces.push_back(line(middle, to));
    }
    shuffle(pieces, random);
    const Joining joining = join(pieces);
    REQUIRE(joining.outlines.size() == 1);
    CHECK(joining.open.empty());
    CHECK(areas(joining)[0] == Approx(std::abs(signed_area(outline))).epsilon(1e-9));
    for (int again = 0; again < 3; ++again) {
      std::vector<DrawnPiece> other = pieces;
      shuffle(other, random);
      const Joining same = join(other);
      REQUIRE(same.outlines.size() == 1);
      CHECK(corners_of(same.outlines[0].outline) == corners_of(joining.outlines[0].outline));
    }
    // Ends shaken within the safe distance.
    for (DrawnPiece& piece : pieces) {
      const auto shake = [&](Vec2& end) {
        end.x += (random.uniform() - 0.5) * 1e-6 * side;
        end.y += (random.uniform() - 0.5) * 1e-6 * side;
      };
      shake(piece.outline.start);
      shake(piece.outline.pieces[0].end);
    }
    const Joining shaken = join(pieces);
    REQUIRE(shaken.outlines.size() >= 1);
    CHECK(areas(shaken)[0] == Approx(std::abs(signed_area(outline))).epsilon(1e-3));
  }
}

TEST_CASE("a polygon with holes, drawn in pieces, is read from SVG and DXF",
          "[joining][import][slow]") {
  Rng random(31);
  const auto number = [](double value) { return shortest(value); };
  for (int round = 0; round < 400; ++round) {
    const auto n = static_cast<std::uint32_t>(5 + random.below(20));
    const Points outline = *generate(Family::convex, n, random.below(1u << 30));
    // Two small holes about the middle, within a convex polygon.
    Vec2 middle;
    for (const Vec2& corner : outline) middle += corner / static_cast<double>(outline.size());
    double room = 1e300;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2& next = outline[i + 1 == outline.size() ? 0 : i + 1];
      room = std::min(room, length(nearest_on_segment(outline[i], next, middle) - middle));
    }
    std::vector<Points> loops = {outline};
    for (const double side : {-0.4, 0.4}) {
      Points hole;
      for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        hole.push_back(middle + room * Vec2(side, 0) + 0.2 * room * corner);
      loops.push_back(hole);
    }
    std::vector<std::string> svg_parts, dxf_parts;
    for (const Points& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        Vec2 a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (random.below(2) == 0) std::swap(a, b);
        svg_parts.push_back(random.below(2) == 0
                                ? "<line x1='" + number(a.x) + "' y1='" + number(-a.y) + "' x2='" +
                                      number(b.x) + "' y2='" + number(-b.y) + "'/>"
                                : "<path d='M" + number(a.x) + " " + number(-a.y) + "L" +
                                      number(b.x) + " " + number(-b.y) + "'/>");
        dxf_parts.push_back("0\nLINE\n8\nCUT\n10\n" + number(a.x) + "\n20\n" + number(a.y) +
                            "\n11\n" + number(b.x) + "\n21\n" + number(b.y) + "\n");
        if (random.below(5) == 0) dxf_parts.push_back(dxf_parts.back());
      }
    shuffle(svg_parts, random);
    shuffle(dxf_parts, random);
    std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' stroke='black'>", dxf;
    for (const std::string& part : svg_parts) svg += part;
    for (const std::string& part : dxf_parts) dxf += part;
    // Perhaps the lines are in a block, inserted where it was drawn.
    const bool in_block = random.below(2) == 0;
    const std::string header = "0\nSECTION\n2\n", end = "0\nENDSEC\n";
    const std::string drawing = in_block ? header + "BLOCKS\n0\nBLOCK\n2\nPART\n10\n0\n20\n0\n" +
                                               dxf + "0\nENDBLK\n" + end + header +
                                               "ENTITIES\n0\nINSERT\n2\nPART\n10\n0\n20\n0\n" + end
                                         : header + "ENTITIES\n" + dxf + end;
    for (const std::string& text : {svg + "</svg>", drawing + "0\nEOF\n"}) {
      const Result<Import> import = read_shapes(text);
      INFO(text.substr(0, 300));
      REQUIRE(import.ok());
      REQUIRE(import->shapes.size() == 1);
      const Document& read = import->shapes[0].document;
      CHECK(in_order(read.vertices) == in_order(outline));
      REQUIRE(read.holes.size() == 2);
      CHECK((in_order(read.holes[0]) == in_order(loops[1]) ||
             in_order(read.holes[0]) == in_order(loops[2])));
      CHECK((in_order(read.holes[1]) == in_order(loops[1]) ||
             in_order(read.holes[1]) == in_order(loops[2])));
      CHECK(in_order(read.holes[0]) != in_order(read.holes[1]));
      CHECK(import->notes.back() == "2 outlines inside others were read as holes");
    }
  }
}

TEST_CASE("outlines nest by depth, whatever their order", "[joining][import]") {
  const auto square = [](double x, double y, double side) {
    return Points{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  };
  const std::vector<Points> all = {square(0, 0, 100),  square(10, 10, 60), square(20, 20, 10),
                                   square(50, 50, 10), square(80, 80, 10), square(200, 0, 50),
                                   square(0, 0, 100)};
  std::vector<std::size_t> order = {0, 1, 2, 3, 4, 5, 6};
  do {
    std::vector<ClosedOutline> outlines;
    for (const std::size_t i : order) outlines.push_back({&all[i]});
    const Nesting nesting = nest(outlines);
    CHECK(nesting.repeated == 1);
    CHECK(nesting.holes == 2);
    REQUIRE(nesting.shapes.size() == 4);
    const auto at = [&](std::size_t i) { return order[nesting.shapes[i].outline] % 6; };
    CHECK((at(0) == 0 && at(1) == 5 && at(2) == 2 && at(3) == 3));
    CHECK(nesting.shapes[0].holes.size() == 2);
  } while (std::next_permutation(order.begin(), order.end()) && order[0] < 2);
}

TEST_CASE("a filled outline is a shape in whatever it lies, and may bring holes",
          "[joining][import][holes]") {
  const auto square = [](double at, double side) {
    return Points{{at, at}, {at + side, at}, {at + side, at + side}, {at, at + side}};
  };
  const Points whole = square(0, 100), middle = square(10, 60), inner = square(20, 10);
  const std::vector<Points> hole = {middle};
  const auto shapes = [](const std::vector<ClosedOutline>& outlines) {
    std::vector<std::pair<std::size_t, std::size_t>> all;  // the outline, and how many holes
    for (const OutlineWithHoles& shape : nest(outlines).shapes)
      all.emplace_back(shape.outline, shape.holes.size());
    return all;
  };
  using Shapes = std::vector<std::pair<std::size_t, std::size_t>>;
  CHECK(shapes({{&whole}, {&middle, nullptr, true}, {&inner}}) == Shapes{{0, 0}, {1, 1}});
  CHECK(shapes({{&inner}, {&whole, &hole, true}}) == Shapes{{1, 0}, {0, 0}});
  // A hole in the form of the shape in it, and as a line.
  CHECK(shapes({{&whole, &hole, true}, {&middle, nullptr, true}, {&inner}}) ==
        Shapes{{0, 0}, {1, 1}});
  CHECK(shapes({{&middle}, {&whole, &hole, true}, {&inner}, {&whole}}) == Shapes{{1, 0}, {2, 0}});
  // Other holes make another shape.
  CHECK(shapes({{&whole, &hole, true}, {&whole, nullptr, true}}).size() == 2);
  CHECK(shapes({{&whole, &hole, true}, {&whole, &hole, true}}).size() == 1);
}

TEST_CASE("where what stays open is larger than every shape, a person should choose",
          "[joining][import]") {
  const std::string open = "<path d='M0 0H120V80H0'/>";
  const auto drawing = [&](const std::string& more) {
    const Result<Import> import =
        read_shapes("<svg xmlns='http://www.w3.org/2000/svg' stroke='black'>" + more + "</svg>");
    REQUIRE(import.ok());
    return import->doubtful;
  };
  // An open path alone is closed; a stray line at its end keeps it open.
  CHECK_FALSE(drawing("<circle cx='60' cy='40' r='5'/>" + open));
  CHECK(drawing("<circle cx='60' cy='40' r='5'/>" + open + "<path d='M0 80L-9 90'/>"));
  // Centre lines are longer than the part.
  CHECK_FALSE(
      drawing("<circle r='5'/><path d='M-9 0H9'/><path d='M0 -9V9'/><path d='M-9 -9L9 9'/>"));
  CHECK_FALSE(drawing("<circle cx='60' cy='40' r='90'/>" + open + "<path d='M0 80L-9 90'/>"));
}

TEST_CASE("50,000 lines that end on the middles of two are joined", "[joining][import][slow]") {
  std::vector<DrawnPiece> pieces = sides({{0, 0}, {100000, 0}, {100000, 10}, {0, 10}});
  for (int i = 1; i < 50000; ++i) pieces.push_back(line({2.0 * i, 0}, {2.0 * i, 10}));
  const Joining joining = join(pieces);
  CHECK(joining.outlines.size() == 50000);
}

TEST_CASE("a drawing of 100,000 lines is joined", "[joining][import][slow]") {
  std::vector<DrawnPiece> pieces;
  for (int x = 0; x < 158; ++x)
    for (int y = 0; y < 158; ++y) {
      const Vec2 low(3.0 * x, 3.0 * y);
      for (const DrawnPiece& side :
           sides({low, low + Vec2(2, 0), low + Vec2(2, 2), low + Vec2(0, 2)}))
        pieces.push_back(side);
    }
  const Joining joining = join(pieces);
  CHECK(joining.outlines.size() == 158 * 158);
}
