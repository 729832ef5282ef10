// Visibility, style sheets, copies, size on paper.
#include <algorithm>
#include <cmath>

#include "evenlift/hull.h"
#include "evenlift/import.h"
#include "evenlift/polygon_with_holes.h"
#include "kit/catch.h"
#include "kit/imported.h"

using namespace evenlift;
using evenlift::testing::read;

namespace {

std::string refusal(const std::string& text) {
  return evenlift::testing::import_error(text).message;
}

std::string svg(const std::string& inside, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + inside + "</svg>";
}

// The widths of all shapes, which tell them apart, the least first.
std::vector<double> widths(const Import& import) {
  std::vector<double> all;
  for (const ImportedShape& shape : import.shapes)
    all.push_back(bounding_box(shape.document.vertices).size().x);
  std::sort(all.begin(), all.end());
  return all;
}
std::vector<double> widths(const std::string& text) { return widths(read(text)); }

std::string rect(int width, const std::string& attributes = "") {
  return "<rect width='" + std::to_string(width) + "' height='1' " + attributes + "/>";
}

// Of the only shape, with y downwards.
Box box_of(const std::string& text) {
  const Import import = read(text);
  INFO(text.substr(0, 400));
  REQUIRE(import.shapes.size() == 1);
  const Box box = bounding_box(import.shapes[0].document.vertices);
  return {{box.low.x, -box.high.y}, {box.high.x, -box.low.y}};
}

bool is_box(const Box& box, double left, double top, double right, double bottom) {
  INFO(box.low.x << " " << box.low.y << " " << box.high.x << " " << box.high.y);
  CHECK(box.low.x == Approx(left).margin(1e-9));
  CHECK(box.low.y == Approx(top).margin(1e-9));
  CHECK(box.high.x == Approx(right).margin(1e-9));
  CHECK(box.high.y == Approx(bottom).margin(1e-9));
  return true;
}

using Widths = std::vector<double>;

}  // namespace

// --- What is seen

TEST_CASE("SVG: what is hidden by an attribute, a style or a class is left out", "[import][svg]") {
  for (const char* hidden :
       {"display='none'", "style='display:none'", "style='DISPLAY : none ;'", "visibility='hidden'",
        "visibility='collapse'", "style='visibility:hidden'", "opacity='0'", "style='opacity:0%'",
        "style='fill:red;opacity:0.0'", "class='off'", "class='x off'", "id='gone'"}) {
    INFO(hidden);
    const Import import = read(svg("<style>.off{display:none} #gone{visibility:hidden}</style>" +
                                   rect(2) + rect(3, hidden)));
    CHECK(widths(import) == Widths{2});
    REQUIRE(import.notes.size() == 1);
    CHECK(import.notes[0].find("1 hidden element") != std::string::npos);
  }
  for (const char* seen :
       {"display='inline'", "style='display:inline'", "opacity='0.01'", "visibility='visible'",
        "style='-x-display:none'", "style='x:url(a;display:none)'", "style='x:\"display:none\"'"})
    CHECK(widths(svg(rect(2) + rect(3, seen))) == Widths{2, 3});
}

TEST_CASE("SVG: display and opacity hide all that is inside, but visibility is inherited",
          "[import][svg]") {
  CHECK(widths(svg("<g display='none'>" + rect(3, "display='inline'") + "</g>" + rect(2))) ==
        Widths{2});
  CHECK(widths(svg("<g opacity='0'>" + rect(3, "opacity='1'") + "</g>" + rect(2))) == Widths{2});
  CHECK(widths(svg("<g visibility='hidden'><g>" + rect(3) + rect(4, "visibility='visible'") +
                   "</g></g>")) == Widths{4});
}

TEST_CASE("SVG: hidden elements are counted and named", "[import][svg]") {
  const Import import = read(
      svg("<g inkscape:label='Guides' display='none'/><g id='b' display='none'>" + rect(9) +
          "</g>" + rect(2) + rect(3, "visibility='hidden'") + "<text display='none'>t</text>"));
  CHECK(import.notes ==
        std::vector<std::string>{"4 hidden elements (\"Guides\" and \"b\") were left out"});
  CHECK(refusal(svg("<g inkscape:label='Cut' display='none'>" + rect(9) + "</g>")) ==
        "this SVG has no closed shape, only 1 hidden element (\"Cut\")");
  std::string many;
  for (const char* name : {"a", "b", "c", "d", "e"})
    many += "<g display='none' id='" + std::string(name) + "'/>";
  CHECK(read(svg(many + rect(2))).notes[0] ==
        "5 hidden elements (\"a\", \"b\", \"c\" and others) were left out");
}

TEST_CASE("SVG: a shape without fill and stroke is left out if another one is seen",
          "[import][svg]") {
  for (const char* nothing : {"fill='none'", "style='fill:none;stroke:none'", "fill='transparent'",
                              "fill-opacity='0'", "fill='none' stroke='red' stroke-width='0'",
                              "fill='none' stroke='red' stroke-opacity='0'", "class='none'"}) {
    INFO(nothing);
    const std::string style = "<style>.none{fill:none}</style>";
    const Import import = read(svg(style + rect(2) + rect(3, nothing)));
    CHECK(widths(import) == Widths{2});
    REQUIRE(import.notes.size() == 1);
    CHECK(import.notes[0] == "1 shape without fill and stroke was left out");
    // Alone, it is read, with a note.
    const Import alone = read(svg(style + rect(3, nothing)));
    CHECK(widths(alone) == Widths{3});
    REQUIRE(alone.notes.size() == 1);
    CHECK(alone.notes[0].find("nothing in the drawing has a fill or a stroke") == 0);
  }
  CHECK(widths(svg("<g fill='none'>" + rect(2, "fill='red'") + rect(3) + rect(4, "stroke='black'") +
                   "</g>")) == Widths{2, 4});
  CHECK(widths(svg(rect(2, "fill='#fff'") + rect(3), "fill='none'")) == Widths{2});
}

TEST_CASE("SVG: a stroke that repeats the fill before it is no second shape", "[import][svg]") {
  const std::string d = " d='M0 0H7V3H0z'/>";
  CHECK(widths(svg("<path fill='red'" + d + "<path fill='none' stroke='red'" + d)) == Widths{7});
  CHECK(widths(svg("<path fill='red'" + d + "<path fill='red'" + d)) == Widths{7});  // once
  CHECK(widths(svg("<path fill='red'" + d + "<path transform='scale(2)' fill='none' stroke='red'" +
                   d)) == Widths{7, 14});
}

// --- Style sheets

TEST_CASE("SVG: of the rules of a style sheet the last of the highest specificity wins",
          "[import][svg]") {
  const auto is_seen = [](const std::string& css, const std::string& attributes) {
    INFO(css << " / " << attributes);
    return widths(svg("<style>" + css +
                      "</style><circle r='1' style='fill:red;visibility:visible "
                      "!important'/>" +
                      rect(3, attributes)))
               .size() == 2;
  };
  CHECK_FALSE(is_seen(".a{visibility:hidden}", "class='a'"));
  CHECK_FALSE(is_seen("rect{visibility:hidden}", ""));
  CHECK_FALSE(is_seen("*{visibility:hidden}", ""));
  CHECK_FALSE(is_seen("rect.a{visibility:hidden}", "class='b a'"));
  CHECK_FALSE(is_seen("rect#a{visibility:hidden}", "id='a'"));
  CHECK_FALSE(is_seen("x,.b , .a\n{visibility:hidden}", "class='a'"));
  CHECK(is_seen("circle.a,.A,#a,rec{visibility:hidden}", "class='a'"));
  // Above an attribute, below a style.
  CHECK_FALSE(is_seen("*{visibility:hidden}", "visibility='visible'"));
  CHECK(is_seen("#a{visibility:hidden}", "id='a' style='visibility:visible'"));
  // The last, the highest, the important one.
  CHECK(is_seen(".a{visibility:hidden}.b{visibility:visible}", "class='b a'"));
  CHECK_FALSE(is_seen(".b{visibility:visible}.a{visibility:hidden}", "class='b a'"));
  CHECK_FALSE(is_seen("rect.a{visibility:hidden}.a{visibility:visible}rect{visibility:visible}",
                      "class='a'"));
  CHECK_FALSE(is_seen("#a{visibility:hidden}rect.a{visibility:visible}", "id='a' class='a'"));
  CHECK_FALSE(is_seen("*{visibility:hidden!important}#a{visibility:visible}",
                      "id='a' style='visibility:visible'"));
  CHECK(is_seen("*{visibility:hidden ! important}", "style='visibility:visible!important'"));
  CHECK(is_seen(".a{visibility:hidden;visibility:visible}", "class='a'"));
  CHECK_FALSE(is_seen(".a{visibility:hidden!important;visibility:visible}", "class='a'"));
}

TEST_CASE("SVG: at-rules, comments and other selectors of a style sheet are skipped",
          "[import][svg]") {
  const auto count = [](const std::string& css) {
    INFO(css);
    return widths(svg("<style>" + css + "</style>" + rect(2) + rect(3, "class='a'"))).size();
  };
  CHECK(count("/* .a{display:none} */") == 2);
  CHECK(count("@media print{.a{display:none}}") == 2);
  CHECK(count("@import url('a;b{');@charset \"x\";") == 2);
  CHECK(count("@font-face{font-family:x}.a{display:none}") == 1);
  CHECK(count("@import url(x);/**/.a{/* { */display:/**/none}") == 1);
  CHECK(count("svg .a,g>.a,.a:hover,.a.a,[x],.a+.a{display:none}") == 2);
  CHECK(count("<![CDATA[ .a > .b {} .a{display:none} ]]>") == 1);
  CHECK(count(".a{display:none") == 1);
  CHECK(count("}}{{.a{display:none}") == 2);
  // If another selector gives paint, a shape without paint stays.
  CHECK(count("rect{fill:none}") == 2);
  CHECK(count(".a{stroke:red}rect{fill:none}") == 1);
  CHECK(count(".a{stroke:red}rect{fill:none} g rect{stroke:red}") == 2);
  CHECK(widths(svg("<style media='print'>.a{display:none}</style>" + rect(3, "class='a'"))) ==
        Widths{3});
}

TEST_CASE("SVG: style sheets are bounded", "[import][svg][slow]") {
  std::string selectors = ".a0";
  for (int i = 1; i < 100000; ++i) selectors += ",.a" + std::to_string(i);
  CHECK(
      read(svg("<style>" + selectors + "{fill:red;stroke:red}</style>" + rect(1))).shapes.size() ==
      1);
  CHECK(refusal(svg("<style>" + selectors + "{fill:red;stroke:red;opacity:1}</style>" + rect(1)))
            .find("262144 declarations") != std::string::npos);
}

// --- Transforms

TEST_CASE("SVG: properties that only contain the word transform move nothing", "[import][svg]") {
  for (const char* style :
       {"text-transform:none", "transform-origin:center", "transform-box:fill-box",
        "-inkscape-transform:scale(2)", "transform:none", "translate:none", "color-scale:2"}) {
    CHECK(widths(svg(rect(3, "style='" + std::string(style) + "'"))) == Widths{3});
    CHECK(widths(svg("<style>rect{" + std::string(style) + "}</style>" + rect(3))) == Widths{3});
  }
}

TEST_CASE("SVG: transforms of CSS are read as those of the attribute", "[import][svg]") {
  const std::pair<const char*, const char*> pairs[] = {
      {"translate(3px, 4px)", "translate(3 4)"},
      {"translateX(1in) translateY(-.5in)", "translate(96) translate(0,-48)"},
      {"rotate(90deg)", "rotate(90)"},
      {"rotate(0.25turn)", "rotate(90)"},
      {"rotate(100grad)", "rotate(90)"},
      {"scale(2) scaleX(3) scaleY(50%)", "scale(2)scale(3 1)scale(1 .5)"},
      {"matrix(1, 2, 3, 4, 5, 6)", "matrix(1 2 3 4 5 6)"},
      {"skewX(20deg) skewY(5deg)", "skewX(20)skewY(5)"},
      {"skew(20deg)", "skewX(20)"}};
  for (const auto& [css, attribute] : pairs) {
    INFO(css);
    const Box wanted = box_of(svg(rect(3, "transform='" + std::string(attribute) + "'")));
    for (const std::string& text :
         {svg(rect(3, "transform='scale(9)' style='transform:" + std::string(css) + "'")),
          svg("<style>rect{transform:" + std::string(css) + "}</style>" + rect(3))})
      CHECK(is_box(box_of(text), wanted.low.x, wanted.low.y, wanted.high.x, wanted.high.y));
  }
  for (const char* wrong :
       {"translate(50%)", "rotate(3mm)", "matrix(1px,0,0,1,0,0)", "scale3d(1)", "translate(1px"})
    CHECK(refusal(svg(rect(3, "style='transform:" + std::string(wrong) + "'")))
              .find("is not understood") != std::string::npos);
  CHECK(refusal(svg(rect(3, "style='rotate:9deg'"))).find("by the style \"rotate\"") !=
        std::string::npos);
}

TEST_CASE("SVG: a transform has the origin that transform-origin says", "[import][svg]") {
  const std::string turned = "transform='rotate(180)' ", view = "viewBox='0 0 20 10'";
  is_box(box_of(svg(rect(3, turned + "transform-origin='2 1'"), view)), 1, 1, 4, 2);
  is_box(box_of(svg(rect(3, turned + "style='transform-origin:2px'"), view)), 1, 9, 4, 10);
  is_box(box_of(svg(rect(3, turned + "style='transform-origin:center'"), view)), 17, 9, 20, 10);
  is_box(box_of(svg(rect(3, turned + "style='transform-origin:bottom 10%'"), view)), 1, 19, 4, 20);
  CHECK(refusal(svg(rect(3, turned + "transform-origin='center'"))).find("without a size") !=
        std::string::npos);
  CHECK(refusal(svg(rect(3, turned + "style='transform-origin:0 0;transform-box:fill-box'")))
            .find("transform-box") != std::string::npos);
}

// --- Copies and viewports

TEST_CASE("SVG: copies are drawn where they are, with the look around them", "[import][svg]") {
  const std::string original = "<defs><rect id='r' width='3' height='1'/></defs>";
  is_box(box_of(svg(original + "<use href='#r' x='5' y='6'/>")), 5, 6, 8, 7);
  is_box(box_of(svg(original + "<use xlink:href='#r' x='5' transform='scale(2)'/>")), 10, 0, 16, 2);
  is_box(box_of(svg(original + "<g transform='translate(1 1)'><use href=' #r '/></g>")), 1, 1, 4,
         2);
  is_box(box_of(svg(original + "<use href='#r' xlink:href='#none'/>")), 0, 0, 3, 1);
  // Of a copy, of a group, and before the original.
  is_box(box_of(svg("<use href='#b' x='1'/><defs><use id='b' href='#r' y='1'/></defs>" + original)),
         1, 1, 4, 2);
  CHECK(widths(svg("<defs><g id='g'>" + rect(1) + rect(2) + "</g></defs><use href='#g'/>")) ==
        Widths{1, 2});
  CHECK(widths(svg(original + rect(2) +
                   "<use href='#r' visibility='hidden'/><use href='#r' "
                   "fill='none'/>")) == Widths{2});
  const Import named =
      read(svg(rect(1, "id='a'") + "<use href='#a' id='b' x='5'/><use href='#a' x='9'/>"));
  REQUIRE(named.shapes.size() == 3);
  CHECK(named.shapes[1].name == "b");
  CHECK(named.shapes[2].name == "a");
}

TEST_CASE("SVG: copies of nothing, of other files and of themselves are left out",
          "[import][svg]") {
  CHECK(read(svg(rect(1) + "<use href='#x'/><use href='a.svg#x'/><use/>")).notes ==
        std::vector<std::string>{"2 copies (<use>) without an original and 1 copy (<use>) from "
                                 "another file were left out"});
  for (const char* circle :
       {"<g id='a'><use href='#a'/></g>", "<use id='a' href='#a'/>",
        "<use id='a' href='#b'/><use id='b' href='#a'/>",
        "<symbol id='a'><use href='#b'/></symbol><g id='b'><use href='#a'/></g>"}) {
    CHECK(refusal(svg(circle)) == "the SVG's copies (<use>) contain themselves");
    CHECK(widths(svg(circle + rect(2))) == Widths{2});
  }
}

TEST_CASE("SVG: copies are bounded", "[import][svg][slow]") {
  for (const std::string& leaf : {rect(0), rect(1), rect(1, "display='none'"), std::string()}) {
    std::string text = "<g id='a0'>" + leaf + "</g>";
    for (int i = 1; i < 20; ++i) {
      text += "<g id='a" + std::to_string(i) + "'>";
      for (int k = 0; k < 10; ++k) text += "<use href='#a" + std::to_string(i - 1) + "'/>";
      text += "</g>";
    }
    const std::string message = refusal(svg("<defs>" + text + "</defs><use href='#a19'/>"));
    CHECK((message.find("64 MiB") != std::string::npos ||
           message.find("10000 shapes") != std::string::npos));
  }
  std::string chain = "<rect id='a0' width='1' height='1'/>";
  for (int i = 1; i < 300; ++i)
    chain += "<use id='a" + std::to_string(i) + "' href='#a" + std::to_string(i - 1) + "'/>";
  CHECK(refusal(svg("<defs>" + chain + "</defs><use href='#a299'/>")).find("too deep") !=
        std::string::npos);
}

TEST_CASE("SVG: symbols and drawings in the drawing have their own viewports", "[import][svg]") {
  const std::string all = "viewBox='0 0 100 50'";
  const std::string symbol =
      "<symbol id='s' viewBox='0 0 10 20'><path d='M0 0H10V20H0z'/></symbol>";
  // In the middle by default.
  is_box(box_of(svg(symbol + "<use href='#s' x='1' y='2' width='40' height='40'/>", all)), 11, 2,
         31, 42);
  is_box(box_of(svg(symbol + "<use href='#s'/>", all)), 37.5, 0, 62.5, 50);
  is_box(box_of(svg(symbol + "<use href='#s' width='50%' height='20%'/>", all)), 22.5, 0, 27.5, 10);
  const auto aspect = [&](const std::string& value) {
    return box_of(
        svg("<svg x='10' y='10' width='40' height='20' viewBox='5 5 10 10' "
            "preserveAspectRatio='" +
                value +
                "'><rect x='5' y='5' width='10' "
                "height='10'/></svg>",
            all));
  };
  is_box(aspect(""), 20, 10, 40, 30);
  is_box(aspect("xMinYMin"), 10, 10, 30, 30);
  is_box(aspect("xMaxYMid meet"), 30, 10, 50, 30);
  is_box(aspect("none"), 10, 10, 50, 30);
  is_box(aspect("xMidYMin slice"), 10, 10, 50, 50);
  is_box(aspect("xMidYMax slice"), 10, -10, 50, 30);
  // Per cent of the nearest viewport.
  is_box(box_of(svg("<svg x='10%' y='10%' width='50%' height='40%'><rect x='50%' width='50%' "
                    "height='100%'/></svg>",
                    all)),
         35, 5, 60, 25);
  CHECK(widths(svg("<circle r='50%'/>", "viewBox='0 0 30 40'"))[0] == Approx(std::sqrt(1250.0)));
  CHECK(refusal(svg("<svg width='0' height='9'>" + rect(1) + "</svg>")) ==
        "this SVG has no closed shape");
  CHECK(widths(svg("<svg viewBox='0 0 10 10'>" + rect(1) + "</svg>")) == Widths{1});
}

TEST_CASE("SVG: a switch draws the first child that all programs can read", "[import][svg]") {
  CHECK(widths(svg("<switch><foreignObject requiredExtensions='x'>" + rect(1) +
                   "</foreignObject><g requiredExtensions='y'>" + rect(2) + "</g><g>" + rect(3) +
                   "</g><g>" + rect(4) + "</g></switch>")) == Widths{3});
  CHECK(widths(svg("<switch><g systemLanguage='fr'>" + rect(1) + "</g><g systemLanguage='en'>" +
                   rect(2) + "</g></switch>")) == Widths{2});
  CHECK(widths(svg("<a href='x'><g>" + rect(3) + "</g></a>")) == Widths{3});
}

// --- Paper

TEST_CASE("SVG: the size on paper decides the unit and the scale", "[import][svg]") {
  const auto check = [](const std::string& size, const char* unit, double width, double height) {
    INFO(size);
    const Import import = read(svg("<path d='M0 0H30V40H0z'/>", size));
    REQUIRE(import.shapes.size() == 1);
    CHECK(import.unit == unit);
    CHECK((import.shapes[0].document.shown.units.length == LengthUnit::none) ==
          import.unit.empty());
    const Vec2 extent = bounding_box(import.shapes[0].document.vertices).size();
    CHECK(extent.x == Approx(width));
    CHECK(extent.y == Approx(height));
  };
  // User units of 1/90 inch, 1/100 mm, 1/10000 inch, and points.
  check("width='1000mm' height='500mm' viewBox='0 0 3543.3071 1771.6535'", "millimetres", 8.466667,
        11.288889);
  check("width='297mm' height='210mm' viewBox='0 0 29700 21000'", "millimetres", 0.3, 0.4);
  check("width='29.7cm' height='21cm' viewBox='0 0 116929 82677'", "centimetres", 0.00762, 0.01016);
  check("width='8.5in' height='11in' viewBox='0 0 85 110'", "inches", 3, 4);
  check("width='612pt' height='792pt' viewBox='0 0 612 792'", "millimetres", 10.583333, 14.111111);
  check("width='51pc' height='66pc' viewBox='0 0 612 792'", "millimetres", 10.583333, 14.111111);
  check("width='840Q' height='400Q' viewBox='0 0 420 200'", "millimetres", 15, 20);
  check("width=' 210MM ' height='297 mm' viewBox='0 0 105 148.5'", "millimetres", 60, 80);
  // Without a view box, a user unit is 1/96 inch.
  check("width='210mm' height='297mm'", "millimetres", 7.9375, 10.583333);
  check("width='6in' height='6in'", "inches", 0.3125, 0.4166667);
  check("width='210mm'", "millimetres", 7.9375, 10.583333);
  // One side is enough; the smaller scale counts, or both without an aspect ratio.
  check("width='210mm' viewBox='0 0 105 148.5'", "millimetres", 60, 80);
  check("height='297mm' width='100%' viewBox='0 0 105 148.5'", "millimetres", 60, 80);
  check("width='200mm' height='100mm' viewBox='0 0 50 50'", "millimetres", 60, 80);
  check("width='200mm' height='100mm' viewBox='0 0 50 50' preserveAspectRatio='xMinYMin slice'",
        "millimetres", 120, 160);
  check("width='200mm' height='100mm' viewBox='0 0 50 50' preserveAspectRatio='none'",
        "millimetres", 120, 80);
  // No size on paper.
  check("width='500' height='200px' viewBox='0 0 50 20'", "", 30, 40);
  check("width='100%' height='100%' viewBox='0 0 50 20'", "", 30, 40);
  check("viewBox='0 0 50 20'", "", 30, 40);
  check("width='100mm' height='100mm' viewBox='0 0 0 20'", "", 30, 40);
  check("width='-100mm' height='0mm'", "", 30, 40);
}

TEST_CASE("SVG: on paper, curves are flattened in the unit of the paper", "[import][svg]") {
  const Import import = read(
      svg("<circle r='5000'/>", "width='297mm' height='210mm' viewBox='0 0 29700 21000'"), {0.1});
  CHECK(import.shapes.at(0).tolerance == 0.1);
  CHECK(import.shapes[0].document.vertices.size() == 64);
}

// --- Hairs

TEST_CASE("SVG: a curve of a hair that ends where it began is dropped", "[import][svg]") {
  for (const char* loop : {"c0.1 0 0-0.1 0 0", "C90.1 0 90 -0.1 90 0.0000001", "q.2 .2 0 0",
                           "a.1 .1 0 0 1 .1 -.1 a.1 .1 0 0 1 -.1 .1", "a.05 .05 0 1 1 0 .00001"}) {
    INFO(loop);
    const Import import = read(svg("<path d='M0 0H90" + std::string(loop) + "V60H0z'/>"));
    REQUIRE(import.shapes.size() == 1);
    CHECK(import.shapes[0].document.vertices.size() == 4);
    CHECK_FALSE(import.shapes[0].tolerance);
    CHECK(Polygon::create(import.shapes[0].document.vertices).ok());
    CHECK(import.notes == std::vector<std::string>{"1 loop of a hair was left out"});
  }
  // Not hairs: a fillet, a half turn whose arc ends in a curve without length, a small shape of one
  // curve.
  for (const char* whole : {"M0 0H90a.1 .1 0 0 1 .1 .1V60H0z", "M6 0a3 3 0 1 0 0 6 3 3 0 0 0 0-6z",
                            "M0 0c.1 0 0-.1 0 0z", "M5 5c9 0 9 9 0 0"})
    CHECK(read(svg("<path d='" + std::string(whole) + "'/>")).notes.empty());
  // A vanishing part of a path.
  CHECK(widths(svg("<path d='M0 0H90V60H0zM5 5h.0001v.0001z M7 7q.01 0 .01 .01z'/>")) ==
        Widths{90});
}

TEST_CASE("an open line without a fill encloses nothing beside closed shapes", "[import][svg]") {
  const auto svg = [](const std::string& inside) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 120 80" fill="none" stroke="red">)" +
           inside + "</svg>";
  };
  const std::string plate = R"(<path d="M0 0H120V80H0Z"/>)",
                    mark = R"(<polyline points="20,20 50,60 80,20"/>)",
                    across = R"(<path d="M-10 20 L50 60 L130 20"/>)";
  const Import marked = read_shapes(svg(plate + mark)).value();
  REQUIRE(marked.shapes.size() == 1);
  CHECK(marked.shapes[0].document.holes.empty());
  CHECK(marked.left_open.size() == 1);
  CHECK(read_shapes(svg(plate + across)).value().shapes.size() == 1);
  // Alone, it is closed by a straight edge; with a fill, it is an outline.
  CHECK(read_shapes(svg(mark)).value().shapes.size() == 1);
  const std::string filled = R"(<polyline fill="blue" points="0,0 50,70 110,0"/>)";
  CHECK(read_shapes(svg(filled + mark)).value().shapes.size() == 1);
}

TEST_CASE("elements of other namespaces are left out of an SVG", "[import][svg]") {
  const Import found =
      read_shapes(
          R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:cad="urn:cad" viewBox="0 0 300 400">)"
          R"(<cad:rect width="200" height="200"/><rect width="120" height="80"/></svg>)")
          .value();
  CHECK(found.shapes.size() == 1);
  // Another prefix for SVG's own.
  const Import prefixed =
      read_shapes(R"(<s:svg xmlns:s="http://www.w3.org/2000/svg" viewBox="0 0 300 400">)"
                  R"(<s:rect width="120" height="80"/></s:svg>)")
          .value();
  CHECK(prefixed.shapes.size() == 1);
}

TEST_CASE("an SVG's own entities are put in their places, within bounds", "[import][svg]") {
  const auto svg = [](const std::string& declared, const std::string& inside) {
    return "<?xml version='1.0'?>\n<!DOCTYPE svg [" + declared +
           "]>\n<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 200'>" + inside + "</svg>";
  };
  const std::string plate = R"(<!ENTITY plate "<rect x='150' width='120' height='80'/>">)",
                    width = "<!ENTITY wide '120'>";
  CHECK(read_shapes(svg(plate, "<rect width='50' height='50'/><g>&plate;</g>"))
            .value()
            .shapes.size() == 2);
  CHECK(
      read_shapes(svg(plate + "<!ENTITY both '<g>&plate;</g>'>", "&both;")).value().shapes.size() ==
      1);
  const Import wide = read_shapes(svg(width, "<rect width='&wide;' height='80'/>")).value();
  CHECK(wide.shapes[0].document.vertices[2].x == Approx(120).margin(1e-9));
  // Entities of other files are not read.
  CHECK(read_shapes(svg("<!ENTITY far SYSTEM 'far.svg'>", "<rect width='5' height='8'/>&far;"))
            .value()
            .shapes.size() == 1);
  const auto why = [](const std::string& text) { return read_shapes(text).error().message; };
  CHECK(why(svg("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "&a;")).find("more than eight deep") !=
        std::string::npos);
  std::string laughs = "<!ENTITY l0 '" + std::string(1000, 'x') + "'>";
  for (int i = 1; i < 8; ++i) {
    laughs += "<!ENTITY l" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) laughs += "&l" + std::to_string(i - 1) + ";";
    laughs += "'>";
  }
  CHECK(why(svg(laughs, "&l7;")).find("64 MiB") != std::string::npos);
  // Entities that leave nothing behind are counted, too.
  std::string silence = "<!ENTITY s0 ''>";
  for (int i = 1; i < 8; ++i) {
    silence += "<!ENTITY s" + std::to_string(i) + " '";
    for (int k = 0; k < 40; ++k) silence += "&s" + std::to_string(i - 1) + ";";
    silence += "'>";
  }
  CHECK(why(svg(silence, "&s7;")).find("64 MiB") != std::string::npos);
}

TEST_CASE("SVG: the size and place of shapes may be a style", "[import][svg]") {
  const auto sizes = [](const std::string& content) {
    std::string text;
    for (const ImportedShape& shape :
         evenlift::testing::read("<svg>" + content + "</svg>").shapes) {
      const Vec2 size = bounding_box(shape.document.vertices).size();
      text += std::to_string(std::lround(size.x)) + "x" + std::to_string(std::lround(size.y)) + " ";
    }
    return text;
  };
  CHECK(sizes("<rect style='width: 120px; height:80px'/>") == "120x80 ");
  CHECK(sizes("<style>.p{width:120px;height:80px;x:5;y:7}</style><rect class='p' width='3'/>") ==
        "120x80 ");
  CHECK(sizes("<circle style='r:40;cx:1;cy:2'/>") == "80x80 ");
  CHECK(sizes("<ellipse style='rx:40;ry:20'/>") == "80x40 ");
  CHECK(sizes("<path style='d: path(\"M0 0H120V80H0Z\")'/>") == "120x80 ");
  CHECK(sizes("<rect width='120' height='80' style='rx:auto'/>") == "120x80 ");
  // Lines have no such styles.
  CHECK(
      sizes(
          "<g stroke='red'><line x2='9' style='x2:4'/><line x2='9' y2='9'/><line x1='9' x2='9' y2='9'/></g>") ==
      "9x9 ");
}

namespace {

std::vector<std::string> names_in(const Import& import) {
  std::vector<std::string> names;
  for (const ImportedShape& shape : import.shapes) names.push_back(shape.name);
  return names;
}

}  // namespace

TEST_CASE("SVG: the title of a group names its shapes, unless they have a label or title",
          "[import][svg]") {
  const Import import = read(
      "<svg><g><title>lid</title><rect id='path12' width='4' height='4'/>"
      "<rect id='path13' data-name='handle' x='10' width='3' height='3'/>"
      "<g><rect x='20' width='2' height='2'><title>knob</title></rect></g></g>"
      "<rect id='path14' x='30' width='1' height='1'/></svg>");
  CHECK(names_in(import) == std::vector<std::string>{"lid", "handle", "knob", "path14"});
}

TEST_CASE("SVG: parts are named by the texts in them or beside them", "[import][svg]") {
  const Import import = read(
      "<svg><rect id='a' width='10' height='10'/><rect id='b' x='20' width='10' height='10'/>"
      "<rect id='c' x='40' width='10' height='10'/><rect id='d' x='60' width='10' height='10'/>"
      "<text x='2' y='5'>P1</text><text transform='translate(20 5)'><tspan x='3'>P</tspan>2</text>"
      "<text x='41 45' y='13'>P3<tspan dy='1'>left</tspan></text><text x='200' y='5'>title</text></svg>");
  CHECK(names_in(import) == std::vector<std::string>{"P1", "P2", "P3 left", "d"});
  CHECK(import.notes == std::vector<std::string>{"1 text was left out"});
}

TEST_CASE("SVG: round corners take at most half of each side", "[import][svg]") {
  for (const auto& [size, area] :
       {std::pair("width='100' height='20'", 2000 - (4 - 3.14159265) * 30 * 10),
        std::pair("width='20' height='100'", 2000 - (4 - 3.14159265) * 10 * 30)}) {
    const Import import = read("<svg xmlns='http://www.w3.org/2000/svg'><rect " +
                                   std::string(size) + " rx='30' ry='30'/></svg>",
                               {1e-4});
    INFO(size);
    REQUIRE(import.shapes.size() == 1);
    REQUIRE(object_of(import.shapes[0].document).ok());
    CHECK(std::abs(signed_area(import.shapes[0].document.vertices)) == Approx(area).epsilon(1e-4));
  }
}

TEST_CASE("SVG: in a copied group, shapes keep names of their own", "[import][svg]") {
  const Import import = read(
      "<svg xmlns='http://www.w3.org/2000/svg'><defs><g id='group'><rect id='plate' width='40' height='30'/>"
      "<circle cx='100' r='9'/></g></defs><use id='copy' href='#group'/></svg>");
  CHECK(names_in(import) == std::vector<std::string>{"plate", "copy"});
}

TEST_CASE("SVG: an outline joined from parts of one path has the path's name", "[import][svg]") {
  const Import joined = read(svg(R"(<g id="layer"><path id="bracket" fill="none" stroke="red"
      d="M0 0L9 0M9 0L9 9M9 9L0 0"/></g>)"));
  REQUIRE(joined.shapes.size() == 1);
  CHECK(joined.shapes[0].name == "bracket");
}

TEST_CASE("SVG: a shape that a clip path or a mask cuts is named, since it is read whole",
          "[import][svg]") {
  const auto notes = [](const std::string& clip, const std::string& shape) {
    return read("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><defs>" + clip +
                "</defs>" + shape + "</svg>")
        .notes;
  };
  const std::string window = "<clipPath id='c'><rect width='100' height='50'/></clipPath>",
                    cut = "1 shape is cut by a clip path or a mask, which is not applied: \"a\"";
  using Notes = std::vector<std::string>;
  CHECK(notes(window, "<rect id='a' width='200' height='40' clip-path='url(#c)'/>") == Notes{cut});
  CHECK(notes(window,
              "<g style='clip-path: url(\"#c\")'><rect id='a' width='20' height='60'/></g>") ==
        Notes{cut});
  CHECK(
      notes(window,
            "<rect id='a' width='90' height='50' clip-path='url(#c)' transform='translate(20 0)'/>")
          .empty());
  CHECK(notes("<mask id='m'><circle r='9'/></mask>",
              "<rect id='a' width='9' height='9' mask='url(#m)'/>") == Notes{cut});
  // Programs clip all to the page, and one clip path to another's rectangle.
  CHECK(
      notes(
          window,
          "<g clip-path='url(#c)'><rect width='100' height='50'/><circle cx='20' cy='20' r='5'/></g>")
          .empty());
  CHECK(notes("<rect id='r' width='300' height='200'/><clipPath id='c'><use href='#r'/></clipPath>",
              "<rect width='300' height='200' clip-path='url(#c)'/>")
            .empty());
  CHECK(notes(window, "<rect width='200' height='40' clip-path='url(#none)'/>").empty());
  CHECK(notes(window, "<path id='a' d='M1 1H9V9Z M60 1H250V9Z' clip-path='url(#c)'/>") ==
        Notes{cut});
  CHECK(notes("<clipPath id='c'><rect width='100%' height='200px'/></clipPath>",
              "<rect width='300' height='200' clip-path='url(#c)'/>")
            .empty());
  CHECK(
      notes(
          window + "<clipPath id='d'><rect width='60' height='60'/></clipPath>",
          "<g clip-path='url(#c)'><g clip-path='url(#d)'><rect id='a' width='80' height='40'/></g></g>") ==
      Notes{cut});
}

TEST_CASE("SVG: rules for screens count, and the first that is not understood is named",
          "[import][svg]") {
  const auto svg = [](const std::string& style) {
    return "<svg xmlns='http://www.w3.org/2000/svg'><style>" + style +
           "</style><rect width='40' height='30'/><circle r='5' cx='100'/></svg>";
  };
  CHECK(read(svg("@media screen { circle { display: none } }")).shapes.size() == 1);
  CHECK(read(svg("@media all{circle{display:none}}rect{width:50px}")).shapes.size() == 1);
  CHECK(read(svg("@media print { circle { display: none } }")).shapes.size() == 2);
  CHECK(read(svg("@font-face { font-family: x }")).notes.empty());
  const auto note = [&](const std::string& style) {
    const Import import = read(svg(style));
    CHECK(import.shapes.size() == 2);
    for (const std::string& each : import.notes)
      if (each.find("not understood") != std::string::npos) return each;
    return std::string();
  };
  CHECK(note("rect:nth-child(2) { display: none }") ==
        "the style of \"rect:nth-child(2)\" was left out: it is not understood");
  CHECK(note("@media (min-width: 1px) { circle { display: none } }") ==
        "the style of \"@media (min-width: 1px)\" was left out: it is not understood");
  CHECK(note("g > circle { fill: red }, .a .b { stroke: none }").find("\"g > circle\"") !=
        std::string::npos);
  CHECK(note("a:hover { cursor: pointer }").empty());  // nothing of shapes
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "@media screen{";
  CHECK(read(svg(deep)).shapes.size() == 2);
}
