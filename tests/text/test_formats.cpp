#include <algorithm>
#include <charconv>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>
#include <version>

#include "evenlift/formats.h"
#include "evenlift/numbers.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "kit/data_table.h"
#include "kit/random_documents.h"

using namespace evenlift;
using evenlift::testing::any_double;
using evenlift::testing::bits_of;
using evenlift::testing::double_of;
using evenlift::testing::same_bits;
using evenlift::testing::same_polygon;

namespace {

Document read(const std::string& text) {
  Result<Document> document = read_polygon(text);
  INFO(text.substr(0, 200));
  INFO((document ? "" : document.error().message));
  REQUIRE(document.ok());
  return *std::move(document);
}

InputError refusal(const std::string& text) {
  const Result<Document> document = read_polygon(text);
  INFO(text.substr(0, 200));
  REQUIRE(!document.ok());
  return document.error();
}

bool reads_as(const std::string& text, const Points& vertices) {
  const Document document = read(text);
  return !document.centre_of_mass && evenlift::testing::same_vertices(document.vertices, vertices);
}

const Points triangle = {{0, 0}, {10, -2.5}, {3, 1e3}};

// As WKT and GeoJSON give it back: without vertices at the place of the one before.
Document without_repeated(Document document) {
  std::vector<Points*> rings = {&document.vertices};
  for (Points& hole : document.holes) rings.push_back(&hole);
  for (Points* ring : rings) {
    ring->erase(std::unique(ring->begin(), ring->end()), ring->end());
    if (ring->size() > 1 && ring->front() == ring->back()) ring->pop_back();
  }
  return document;
}

std::string ring_of(std::size_t n, const char* open, const char* between, const char* close,
                    const char* separator) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) text += separator;
    text += open + std::to_string(i) + between + std::to_string(i % 7) + close;
  }
  return text;
}

}  // namespace

// --- numbers -------------------------------------------------------------------------------------

TEST_CASE("numbers are written as ECMAScript writes them, except -0", "[formats][numbers]") {
  const std::pair<double, const char*> numbers[] = {
      {0, "0"},
      {-0.0, "-0.0"},
      {1, "1"},
      {-5, "-5"},
      {0.1, "0.1"},
      {0.30000000000000004, "0.30000000000000004"},
      {100, "100"},
      {1e20, "100000000000000000000"},
      {1e21, "1e+21"},
      {1.5e300, "1.5e+300"},
      {123456789012345680000.0, "123456789012345680000"},
      {1e-6, "0.000001"},
      {1e-7, "1e-7"},
      {1.25e-7, "1.25e-7"},
      {5e-324, "5e-324"},
      {2.2250738585072014e-308, "2.2250738585072014e-308"},
      {1.7976931348623157e308, "1.7976931348623157e+308"},
      {9007199254740993.0, "9007199254740992"},
      {5.684341886080802e-14, "5.684341886080802e-14"},  // 2^-44, where the gap below is half
      {9.5367431640625e-7, "9.5367431640625e-7"},
      {1e23, "1e+23"},
      {4.35, "4.35"},
      {665.0 / 3, "221.66666666666666"}};
  for (const auto& [value, text] : numbers) CHECK(shortest(value) == text);
}

TEST_CASE("any double that is written reads back in every bit", "[formats][numbers]") {
  Rng rng(1);
  for (int i = 0; i < 200000; ++i) {
    const double value = any_double(rng, std::numeric_limits<double>::max());
    const auto back = read_number(shortest(value));
    if (!back || bits_of(*back) != bits_of(value)) FAIL(shortest(value));
  }
  for (std::uint64_t exponent = 0; exponent < 2047;
       ++exponent) {  // powers of 2 and their neighbours
    for (const std::uint64_t fraction : {0ull, 1ull, 0xfffffffffffffull}) {
      const double value = double_of(exponent << 52 | fraction);
      const auto back = read_number(shortest(value));
      if (!back || bits_of(*back) != bits_of(value)) FAIL(shortest(value));
    }
  }
}

#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
TEST_CASE("no shorter digits read back: the standard library finds the same",
          "[formats][numbers]") {
  Rng rng(2);
  const auto digits = [](const std::string& text) {
    std::string found;
    for (const char c : text.substr(0, text.find('e'))) {
      if (c >= '0' && c <= '9' && (c != '0' || !found.empty())) found += c;
    }
    while (!found.empty() && found.back() == '0') found.pop_back();
    return found;
  };
  for (int i = 0; i < 200000; ++i) {
    const double value =
        i % 2 == 0 ? any_double(rng, std::numeric_limits<double>::max()) : rng.uniform() * 1000;
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + 64, value, std::chars_format::scientific);
    const std::string expected(buffer, end.ptr);
    if (digits(expected) != digits(shortest(value))) FAIL(expected << " " << shortest(value));
  }
}

TEST_CASE("numbers of any length read as the nearest double", "[formats][numbers]") {
  Rng rng(3);
  for (int i = 0; i < 100000; ++i) {
    const double value = any_double(rng, std::numeric_limits<double>::max());
    char text[1200];
    const int precision = 1 + static_cast<int>(rng.below(i % 100 == 0 ? 1000 : 30));
    const int length = std::snprintf(text, sizeof text, "%.*e", precision, value);
    double expected = 0;
    const bool in_range = std::from_chars(text, text + length, expected).ec == std::errc();
    const auto back = read_number({text, static_cast<std::size_t>(length)});
    if (in_range && (!back || bits_of(*back) != bits_of(expected))) FAIL(text);
  }
}
#endif

TEST_CASE("a number just between two doubles goes to the even one", "[formats][numbers]") {
  CHECK(read_number("9007199254740993") == 9007199254740992.0);
  CHECK(read_number("9007199254740993.0000000000000000000000000000000000001") ==
        9007199254740994.0);
  CHECK(read_number("9007199254740995") == 9007199254740996.0);
  // Half the smallest subnormal, plus a little in the 800th digit.
  const std::string half =
      "2.470328229206232720882843964341106861825299013071623822127928412503377536351043759326"
      "49918180817996189898282347722858865463328355177969898199387398005390939063150356595155"
      "70226392290858392449105184435931802849936536152500319370457678249219365623669863658480"
      "75700158576926990370631192827955855133292783433840935197801553124659726357957462276646"
      "52728272200563740064854999770965994704540208281662262378573934507363390079677619305775"
      "06740176324673600968951340535537458516661134223766678604162159680461914467291840300530"
      "05753084904876539171138659164623952491262365388187963623937328042389101867234849766823"
      "50898633885879256283027559956575244555072551893136908362547791869486679949683240497058"
      "21028513185451396213837722826145437693412532098591327667236328125";
  CHECK(read_number(half + "e-324") == 0.0);
  CHECK(read_number(half + std::string(200, '0') + "1e-324") == 5e-324);
  CHECK(read_number(std::string(100000, '9') + "e-100000") == 1.0);
  CHECK(read_number("0." + std::string(100000, '0') + "1e100001") == 1.0);
  CHECK(read_number("1" + std::string(100000, '0') + "e-100000") == 1.0);
}

TEST_CASE("numbers have one syntax, whatever the locale", "[formats][numbers]") {
  for (const char* text : {"1", "+1", "1.", "1.0", "01", "1e0", "10E-1", "0.1e+1", "100e-2"}) {
    INFO(text);
    CHECK(read_number(text) == 1.0);
  }
  for (const char* text : {".5", "5e-1", "+.5", "0.50000"}) {
    INFO(text);
    CHECK(read_number(text) == 0.5);
  }
  CHECK(bits_of(*read_number("-0")) == bits_of(-0.0));
  CHECK(bits_of(*read_number("-0e5")) == bits_of(-0.0));
  CHECK(bits_of(*read_number("-1e-400")) == bits_of(-0.0));
  for (const char* text : {"", ".", "-", "e5", "1e", "1e+", "1,5", "0x1", "inf", "nan", "1 ", " 1",
                           "1_000", "--1", "1..2", "1e5.0", "1e400", "-1e400", "1.8e308"}) {
    INFO(text);
    CHECK(!read_number(text));
  }
  CHECK(read_number("1.7976931348623158e308") == std::numeric_limits<double>::max());
}

// --- reading -------------------------------------------------------------------------------------

TEST_CASE("the thesis's sample reads as it stands there", "[formats]") {
  const Document document = read(
      "CoM:(278,227)\n(539,220)\n(403,115)\n(386,219)\n(278,306)\n(149,187)\n(263,124)\n(88,101)\n"
      "(82,320)\n(133,437)\n(546,446)\n(665,426)\n");
  REQUIRE(document.centre_of_mass);
  CHECK(*document.centre_of_mass == Vec2(278, 227));
  REQUIRE(document.vertices.size() == 11);
  CHECK(document.vertices.front() == Vec2(539, 220));
  CHECK(document.vertices.back() == Vec2(665, 426));
  CHECK(document.settings == Settings{});
}

TEST_CASE("spaces, blank lines and line ends do not matter in the thesis's format", "[formats]") {
  CHECK(reads_as("(0,0)\n(10,-2.5)\n(3,1000)\n", triangle));
  CHECK(reads_as("(0,0)\r\n(10,-2.5)\r\n(3,1e3)", triangle));
  CHECK(reads_as("(0,0)\r(10,-2.5)\r(3,1E3)\r", triangle));
  CHECK(reads_as("\n\n \t( 0 ,\t0 )  \n\n\n(10 , -25.e-1)\n  (+3,1000.)\n\n", triangle));
  CHECK(reads_as("\xef\xbb\xbf(0,0)\n(10,-2.5)\n(3,1000)", triangle));
  for (const char* first : {"CoM:(1,2)", "com : ( 1 , 2 )", "\n\n COM:(1,2) \t"}) {
    const Document document = read(std::string(first) + "\n(0,0)\n(10,-2.5)\n(3,1000)");
    REQUIRE(document.centre_of_mass);
    CHECK(*document.centre_of_mass == Vec2(1, 2));
    CHECK(document.vertices == triangle);
  }
}

TEST_CASE("WKT reads in any case, with the first vertex again at the end or not", "[formats]") {
  CHECK(reads_as("POLYGON ((0 0, 10 -2.5, 3 1000, 0 0))", triangle));
  CHECK(reads_as("polygon((0 0,10 -2.5,3 1000))", triangle));
  CHECK(reads_as("\n Polygon\n(\t(\n0\n0 , 10   -2.5,\r\n3 1e3 ,0.0 -0 ) )\n", triangle));
  CHECK(read("POLYGON((1 1))").vertices == Points{{1, 1}});
  // As everywhere in WKT and GeoJSON, a vertex at the place of the one before is left out, and so are
  // further coordinates, a reference system and what follows the end.
  CHECK(read("POLYGON((0 0,0 0,0 0))").vertices == Points{{0, 0}});
  for (const char* text :
       {"POLYGON Z ((0 0 7,10 -2.5 7,3 1000 7))", "SRID=4326;POLYGON((0 0,10 -2.5,3 1000));",
        "MultiPolygon ZM (((0 0 1 2,10 -2.5 1 2,3 1000 1 2)))"})
    CHECK(reads_as(text, triangle));
}

TEST_CASE("GeoJSON reads as a Polygon or a Feature of one, members in any order", "[formats]") {
  const std::string ring = "[[0,0],[10,-2.5],[3,1e3],[0,0]]";
  CHECK(reads_as(R"({"type":"Polygon","coordinates":[)" + ring + "]}", triangle));
  CHECK(reads_as(R"({"coordinates":[)" + ring + R"(],"type":"Polygon"})", triangle));
  CHECK(reads_as(R"({"type":"Polygon","coordinates":[[[0,0],[10,-2.5],[3,1e3]]]})", triangle));
  CHECK(reads_as("\n{ \"bbox\" : [0, [{\"type\": 1}]], \"type\" : \"Polygon\",\n\"coordinates\":[" +
                     ring + "], \"crs\": null }\n",
                 triangle));
  CHECK(reads_as(R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[)" + ring +
                     R"(]},"properties":null})",
                 triangle));
  CHECK(reads_as(R"({"\u0074ype":"Pol\u0079gon","coordinates":[)" + ring + "]}", triangle));
  CHECK(reads_as(R"({"type":"Feature","properties":{"centre_of_mass":null,"name":"a\nb"},)"
                 R"("geometry":{"type":"Polygon","coordinates":[)" +
                     ring + "]}}",
                 triangle));
  CHECK(reads_as(R"({"geometry":{"coordinates":[)" + ring +
                     R"(],"type":"Polygon"},"properties":null,"type":"Feature"})",
                 triangle));
  // From the feature's geometry, not beside it.
  CHECK(reads_as(R"({"type":"Feature","coordinates":[[[7,7]]],"geometry":{"type":"Polygon",)"
                 R"("geometry":{"type":"Point"},"coordinates":[)" +
                     ring + "]}}",
                 triangle));

  const Document feature =
      read(R"({"type":"Feature","geometry":{"coordinates":[)" + ring +
           R"(],"type":"Polygon"},"properties":{"centre_of_mass":[4.5,-0],"x":{"type":"y"}}})");
  CHECK(feature.vertices == triangle);
  REQUIRE(feature.centre_of_mass);
  CHECK(same_bits(*feature.centre_of_mass, Vec2(4.5, -0.0)));
}

TEST_CASE("every number of JSON is the nearest double", "[formats]") {
  const std::pair<const char*, double> numbers[] = {
      {"-0", -0.0},
      {"0", 0.0},
      {"-0.0", -0.0},
      {"-1", -1.0},
      {"9007199254740993", 9007199254740992.0},
      {"-9007199254740993", -9007199254740992.0},
      {"18446744073709551615", 18446744073709551616.0},
      {"18446744073709551616", 18446744073709551616.0},
      {"-9223372036854775809", -9223372036854775808.0},
      {"123456789012345678901234567890", 123456789012345678901234567890.0},
      {"0.1", 0.1},
      {"1E-2", 0.01},
      {"4.9e-324", 5e-324},
      {"1e-400", 0.0}};
  for (const auto& [text, value] : numbers) {
    INFO(text);
    const Document document = read(R"({"type":"Polygon","coordinates":[[[)" + std::string(text) +
                                   ",1],[" + text + "\n,2]]]}");
    REQUIRE(document.vertices.size() == 2);
    CHECK(bits_of(document.vertices[0].x) == bits_of(value));
    CHECK(bits_of(document.vertices[1].x) == bits_of(value));
  }
}

TEST_CASE("what is wrong with a text is said with its line and column", "[formats][errors]") {
  for (const auto& row : evenlift::testing::read_table("bad_polygons.txt", 4)) {
    INFO(row[2] << ": " << row[3]);
    const Result<Document> document = read_polygon(evenlift::testing::from_json_string(row[2]));
    REQUIRE(!document.ok());
    INFO(document.error().message);
    CHECK(evenlift::testing::name_of(document.error().code) == row[0]);
    CHECK(describe(document.error().place) == row[1]);
    CHECK(evenlift::testing::is_one_sentence(document.error().message));
  }
}

TEST_CASE("messages say what was expected and what is there", "[formats][errors]") {
  CHECK(refusal("(1;2)").message == "expected ',' between the coordinates but found ';'");
  CHECK(refusal("(1,2").message ==
        "expected ')' after the coordinates but found the end of the text");
  CHECK(refusal("(1,\n").message == "expected a number but found the end of the line");
  CHECK(refusal("(1,\xff)").message == "expected a number but found the byte 0xff");
  CHECK(refusal("POLYGON((1,2 3))").message ==
        "expected a space between the coordinates but found ','");
  CHECK(refusal(R"({"type":"Polygon","coordinates":[[[1 2]]]})").message ==
        "this is not valid JSON: unexpected number literal; expected ']'");
  CHECK(refusal("{\"a\xff\":1}").message ==
        "this is not valid JSON: invalid string: ill-formed UTF-8 byte; expected string literal");
  // The input's text after such words is not repeated.
  CHECK(refusal(std::string("{\"S'; expected &S\xff\0F", 19)).message ==
        "this is not valid JSON: invalid string: ill-formed UTF-8 byte; expected string literal");
  CHECK(refusal("{\"type\":\"S'; expected &S\xff").message ==
        "this is not valid JSON: invalid string: ill-formed UTF-8 byte");
  CHECK(refusal("").message == "the text is empty");
}

TEST_CASE("a column counts characters, not bytes", "[formats][errors]") {
  const InputError error = refusal("{\"type\":\"Polygon\",\"\xc3\xa9\xe2\x82\xac\":1 2}");
  CHECK(error.place.other == 26);
}

TEST_CASE("a motor's line gives its place, weight and name", "[formats][cargo]") {
  const auto cargo_of = [](const std::string& lines) {
    return read("(0,0)\n(10,-2.5)\n(3,1000)\n" + lines).settings.cargo;
  };
  CHECK(cargo_of("Cargo:(2,300) 12 motor\n") == std::vector<Cargo>{{{2, 300}, 12, "motor"}});
  CHECK(cargo_of(" cargo : ( 2 , 300 )\t1.2e1 \t motor  of 2 kW \r\n") ==
        std::vector<Cargo>{{{2, 300}, 12, "motor  of 2 kW"}});
  CHECK(cargo_of("CARGO:(2100,-3)7\n\nCargo:(0,0) 0.5 5 kg\n") ==
        std::vector<Cargo>{{{2100, -3}, 7, ""}, {{0, 0}, 0.5, "5 kg"}});
  std::string longest;
  for (std::size_t i = 0; i < max_name_characters; ++i) longest += "\u20ac";
  CHECK(cargo_of("Cargo:(0,0) 1 " + longest)[0].name == longest);
  CHECK(cargo_of("Cargo:(0,0) 1e-100")[0].weight == min_weight);
  CHECK(cargo_of("Cargo:(0,0) 1e100")[0].weight == max_weight);

  const auto wrong = [](const std::string& line) {
    const InputError error = refusal("(0,0)\n(10,0)\n(3,9)\n" + line);
    return describe(error.place) + ": " + error.message;
  };
  const std::string weight =
      "line 4, column 13: the weight of cargo must be a number greater than 0, from 1e-100 to 1e100";
  for (const char* line : {"Cargo:(0,0) 0", "Cargo:(0,0) -1 box", "Cargo:(0,0) 1.1e100"})
    CHECK(wrong(line) == weight);
  CHECK(wrong("Cargo:(0,0) 1 " + longest + "x") ==
        "line 4, column 15: a name must have at most 60 characters");
  CHECK(wrong("Cargo:(0,0) 1 a\xff") == "line 4, column 15: a name must be valid UTF-8");
  for (const char* name : {"a\tb", "a\x7f", "a\xc2\x85"})
    CHECK(wrong(std::string("Cargo:(0,0) 1 ") + name) ==
          "line 4, column 15: a name must have no control characters");
  CHECK(wrong("Cargo:(0,0) motor").find("expected a weight after ')'") != std::string::npos);
  CHECK(wrong("Cargo:(0,0)").find("expected a weight after ')'") != std::string::npos);
  CHECK(wrong("Cargo:(0,0) 12kg").find("expected a space or the end of the line") !=
        std::string::npos);
  CHECK(wrong("Cargo:(0,0) 1\nHole:\n(1,1)") ==
        "line 5, column 1: vertices and holes come before the cargo");
  CHECK(wrong("Cargo:(0,0) 1\n(1,1)") ==
        "line 5, column 1: vertices and holes come before the cargo");
}

TEST_CASE("the rings after the first are holes in every format", "[formats][holes]") {
  const std::vector<Points> holes = {{{1, 1}, {2, 1}, {2, 2}}, {{4, 4}, {5, 4}, {5, 5}, {4, 5}}};
  for (
      const char* text :
      {"(0,0)\n(10,-2.5)\n(3,1000)\nHole:\n(1,1)\n(2,1)\n(2,2)\nHole:\n(4,4)\n(5,4)\n(5,5)\n(4,5)",
       "(0,0)\r(10,-2.5)\r(3,1000)\r\r hole :\t\r( 1 , 1 )\r(2,1)\r(2,2)\rHOLE:\r(4,4)\r(5,4)\r\r(5,5)"
       "\r(4,5)\r",
       "POLYGON((0 0,10 -2.5,3 1000,0 0),(1 1,2 1,2 2,1 1),(4 4,5 4,5 5,4 5))",
       "MultiPolygon\n( ( (0 0,10 -2.5,3 1000) , (1 1,2 1,2 2)\n,\n(4 4,5 4,5 5,4 5,4 4) ) ) ",
       R"({"type":"Polygon","coordinates":[[[0,0],[10,-2.5],[3,1000]],[[1,1],[2,1],[2,2],[1,1]],
            [[4,4],[5,4],[5,5],[4,5]]]})",
       R"({"type":"Feature","geometry":{"coordinates":[[[0,0],[10,-2.5],[3,1000]],[[1,1],[2,1],[2,2]],
            [[4,4],[5,4],[5,5],[4,5]]],"type":"Polygon"},"properties":null})"}) {
    INFO(text);
    const Document document = read(text);
    CHECK(document.vertices == triangle);
    CHECK(document.holes == holes);
    CHECK(document.settings == Settings{});
  }
}

// --- bounds --------------------------------------------------------------------------------------

TEST_CASE("a polygon has at most max_vertices in every format", "[formats][bounds][slow]") {
  const std::size_t n = max_vertices;
  const auto check = [](const std::string& at_limit, const std::string& beyond) {
    CHECK(read(at_limit).vertices.size() == max_vertices);
    CHECK(refusal(beyond).code == ErrorCode::too_many_vertices);
  };
  check(ring_of(n, "(", ",", ")", "\n"), ring_of(n + 1, "(", ",", ")", "\n"));
  check("POLYGON((" + ring_of(n, "", " ", "", ",") + ",0 0))",
        "POLYGON((" + ring_of(n + 1, "", " ", "", ",") + "))");
  const std::string start = R"({"type":"Polygon","coordinates":[[)";
  check(start + ring_of(n, "[", ",", "]", ",") + ",[0,0]]]}",
        start + ring_of(n + 1, "[", ",", "]", ",") + "]]}");
}

TEST_CASE("a polygon has at most max_holes holes and max_vertices with them", "[formats][bounds]") {
  const auto times = [](std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string json = R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9]])";
  const auto texts = [&](std::size_t holes) {
    return std::vector<std::string>{
        "(0,0)\n(9,0)\n(0,9)\n" + times(holes, "Hole:\n(1,1)\n(2,1)\n(1,2)\n"),
        "POLYGON((0 0,9 0,0 9)" + times(holes, ",(1 1,2 1,1 2)") + ")",
        json + times(holes, ",[[1,1],[2,1],[1,2]]") + "]}"};
  };
  for (const std::string& text : texts(max_holes)) CHECK(read(text).holes.size() == max_holes);
  for (const std::string& text : texts(max_holes + 1)) {
    CHECK(refusal(text).code == ErrorCode::too_many_vertices);
    CHECK(refusal(text).message == "the polygon has more than 1000 holes");
  }
  const std::size_t n = max_vertices - 3;
  for (const std::size_t more : {0u, 1u})
    for (const std::string& text :
         {"(0,0)\n(9,0)\n(0,9)\nHole:\n" + ring_of(n + more, "(", ",", ")", "\n"),
          "POLYGON((0 0,9 0,0 9,0 0),(" + ring_of(n + more, "", " ", "", ",") + "))",
          json + ",[" + ring_of(n + more, "[", ",", "]", ",") + "]]}"}) {
      const Result<Document> document = read_polygon(text);
      CHECK(document.ok() == (more == 0));
      if (!document) CHECK(document.error().code == ErrorCode::too_many_vertices);
    }
  const std::string cargo = "(0,0)\n(9,0)\n(0,9)\n" + times(max_cargo, "Cargo:(1,1) 2 box\n");
  CHECK(read(cargo).settings.cargo.size() == max_cargo);
  CHECK(refusal(cargo + "Cargo:(1,1) 2").message == "there are more than 1000 items of cargo");
}

TEST_CASE("a text longer than max_text_bytes is refused unread", "[formats][bounds]") {
  const InputError error = refusal(std::string(max_text_bytes + 1, ' '));
  CHECK(error.code == ErrorCode::text_too_long);
  CHECK(describe(error.place).empty());
}

TEST_CASE("deep nesting is refused, not followed", "[formats][bounds]") {
  CHECK(refusal("{\"a\":" + std::string(1000000, '[')).code == ErrorCode::bad_syntax);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  CHECK(refusal(objects).code == ErrorCode::bad_syntax);
  const std::string deep = std::string(63, '[') + std::string(63, ']');
  CHECK(reads_as(
      R"({"a":)" + deep + R"(,"type":"Polygon","coordinates":[[[0,0],[10,-2.5],[3,1e3]]]})",
      triangle));
}

// --- writing -------------------------------------------------------------------------------------

TEST_CASE("the three formats look like this", "[formats]") {
  Document document;
  document.vertices = triangle;
  CHECK(write_thesis(document) == "(0,0)\n(10,-2.5)\n(3,1000)\n");
  CHECK(write_wkt(document) == "POLYGON ((0 0, 10 -2.5, 3 1000, 0 0))\n");
  CHECK(write_geojson(document) ==
        "{\"type\": \"Feature\", \"properties\": {\"centre_of_mass\": null}, \"geometry\":\n"
        "{\"type\": \"Polygon\", \"coordinates\": [[\n  [0, 0],\n  [10, -2.5],\n  [3, 1000],\n"
        "  [0, 0]\n]]}}\n");
  document.centre_of_mass = Vec2(4, 0.1);
  CHECK(write_thesis(document) == "CoM:(4,0.1)\n(0,0)\n(10,-2.5)\n(3,1000)\n");
  CHECK(write_wkt(document) == "POLYGON ((0 0, 10 -2.5, 3 1000, 0 0))\n");
  CHECK(write_geojson(document) ==
        "{\"type\": \"Feature\", \"properties\": {\"centre_of_mass\": [4, 0.1]}, \"geometry\":\n"
        "{\"type\": \"Polygon\", \"coordinates\": [[\n  [0, 0],\n  [10, -2.5],\n  [3, 1000],\n"
        "  [0, 0]\n]]}}\n");
}

TEST_CASE("holes and cargo look like this", "[formats][holes][cargo]") {
  Document document;
  document.vertices = triangle;
  document.holes = {{{1, 1}, {2, 1}, {2, 2.5}}, {{4, 4}, {5, 4}, {5, 5}}};
  document.settings.cargo = {{{2100, 0.5}, 12, "motor"}, {{-1, 8}, 0.1, ""}};
  CHECK(write_thesis(document) ==
        "(0,0)\n(10,-2.5)\n(3,1000)\nHole:\n(1,1)\n(2,1)\n(2,2.5)\nHole:\n(4,4)\n(5,4)\n(5,5)\n"
        "Cargo:(2100,0.5) 12 motor\nCargo:(-1,8) 0.1\n");
  CHECK(write_wkt(document) ==
        "POLYGON ((0 0, 10 -2.5, 3 1000, 0 0), (1 1, 2 1, 2 2.5, 1 1), (4 4, 5 4, 5 5, 4 4))\n");
  document.holes.pop_back();
  CHECK(write_geojson(document) ==
        "{\"type\": \"Feature\", \"properties\": {\"centre_of_mass\": null}, \"geometry\":\n"
        "{\"type\": \"Polygon\", \"coordinates\": [[\n  [0, 0],\n  [10, -2.5],\n  [3, 1000],\n"
        "  [0, 0]\n], [\n  [1, 1],\n  [2, 1],\n  [2, 2.5],\n  [1, 1]\n]]}}\n");
}

TEST_CASE("what is written reads back in every bit", "[formats][holes][cargo]") {
  Rng rng(4);
  for (int i = 0; i < 5000; ++i) {
    Document document = evenlift::testing::random_document(rng, i % 100 == 0 ? 400 : 12);
    document.settings = {};
    if (i % 2 == 0) {
      evenlift::testing::take_random_holes(rng, document);
      evenlift::testing::take_random_cargo(rng, document);
    }
    if (document.vertices.empty()) continue;
    const Document back = read(write_thesis(document));
    Document plain = without_repeated(document);
    const bool same = same_polygon(back, document) && back.settings == document.settings &&
                      same_polygon(read(write_geojson(document)), plain);
    plain.centre_of_mass.reset();
    if (!same || !same_polygon(read(write_wkt(document)), plain)) FAIL(write_thesis(document));
  }
}

TEST_CASE("a polygon without vertices is written, and refused by the reader", "[formats]") {
  Document document;
  CHECK(write_thesis(document).empty());
  CHECK(refusal(write_wkt(document)).code == ErrorCode::too_few_vertices);
  CHECK(refusal(write_geojson(document)).code == ErrorCode::too_few_vertices);
  document.centre_of_mass = Vec2(1, 2);
  CHECK(refusal(write_thesis(document)).code == ErrorCode::too_few_vertices);
  CHECK(refusal(write_geojson(document)).code == ErrorCode::too_few_vertices);
}

// --- any bytes -----------------------------------------------------------------------------------

TEST_CASE("any bytes give a document of finite numbers or one sentence", "[formats][fuzz]") {
  Rng rng(5);
  constexpr std::string_view bytes = "()[]{},:;.+-eE0123456789 \n\r\t\"\\PpCcZ#%\xff\x80\0null";
  int documents = 0;
  for (int i = 0; i < 20000; ++i) {
    Document good = evenlift::testing::random_document(rng, 6);
    if (i % 2 == 0) evenlift::testing::take_random_holes(rng, good);
    if (i % 2 == 0) evenlift::testing::take_random_cargo(rng, good);
    std::string text;
    switch (rng.below(4)) {
      case 0:
        text = write_thesis(good);
        break;
      case 1:
        text = write_wkt(good);
        break;
      case 2:
        text = write_geojson(good);
        break;
      default:
        for (std::uint64_t n = rng.below(40); n > 0; --n) text += bytes[rng.below(bytes.size())];
    }
    text = evenlift::testing::mutated(rng, text, bytes);
    const Result<Document> document = read_polygon(text);
    if (document.ok()) {
      ++documents;
      for (const Vec2& vertex : document->vertices) REQUIRE(is_finite(vertex));
      if (document->centre_of_mass) REQUIRE(is_finite(*document->centre_of_mass));
      REQUIRE(same_polygon(read(write_geojson(*document)), without_repeated(*document)));
      const Document again = read(write_thesis(*document));
      REQUIRE((same_polygon(again, *document) && again.settings == document->settings));
    } else if (!evenlift::testing::is_one_sentence(document.error().message) ||
               (document.error().place.kind != Place::Kind::line &&
                document.error().code != ErrorCode::unsupported)) {
      FAIL(text << ": " << document.error().message);
    }
  }
  CHECK(documents > 1000);  // some mutated texts are valid
}
