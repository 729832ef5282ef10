#include <cmath>
#include <limits>
#include <string>

#include "evenlift/link.h"
#include "evenlift/random.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/data_table.h"
#include "kit/json.h"
#include "kit/link_checksum.h"
#include "kit/random_documents.h"
#include "link/range_coder.h"
#include "link/records.h"

using namespace evenlift;
using evenlift::testing::any_double;
using evenlift::testing::bits_of;
using evenlift::testing::Json;
using evenlift::testing::link_characters;
using evenlift::testing::mutated;
using evenlift::testing::random_document;
using evenlift::testing::same_document;
using evenlift::testing::with_checksum;

namespace {

std::string encode(const Document& document) {
  const Result<std::string> link = encode_link(document);
  INFO((link ? "" : link.error().message));
  REQUIRE(link.ok());
  return *link;
}

Document decode(const std::string& link) {
  Result<Document> document = decode_link(link);
  INFO(link.substr(0, 200));
  INFO((document ? "" : document.error().message));
  REQUIRE(document.ok());
  return *std::move(document);
}

InputError refusal(const std::string& link) {
  const Result<Document> document = decode_link(link);
  INFO(link.substr(0, 200));
  REQUIRE(!document.ok());
  return document.error();
}

InputError encode_refusal(const Document& document) {
  const Result<std::string> link = encode_link(document);
  REQUIRE(!link.ok());
  return link.error();
}

Document thesis_sample() {
  Document document;
  document.vertices = {{539, 220}, {403, 115}, {386, 219}, {278, 306}, {149, 187}, {263, 124},
                       {88, 101},  {82, 320},  {133, 437}, {546, 446}, {665, 426}};
  document.centre_of_mass = Vec2(278, 227);
  return document;
}

// About (500, 500), with random angles and radii, perhaps rounded to integers.
Document star(std::size_t n, std::uint64_t seed, bool integers) {
  Rng rng(seed);
  std::vector<double> angles(n);
  for (double& angle : angles) angle = rng.uniform() * 6.283185307179586;
  std::sort(angles.begin(), angles.end());
  Document document;
  for (const double angle : angles) {
    const double radius = 150 + 350 * rng.uniform();
    const Vec2 vertex(500 + radius * std::cos(angle), 500 + radius * std::sin(angle));
    document.vertices.emplace_back(integers ? std::round(vertex.x) : vertex.x,
                                   integers ? std::round(vertex.y) : vertex.y);
  }
  return document;
}

std::string without_checksum(const std::string& link) { return link.substr(0, link.size() - 4); }

}  // namespace

// --- length --------------------------------------------------------------------------------------

TEST_CASE("the thesis's sample is a link of 49 characters", "[link][length]") {
  CHECK(encode(thesis_sample()) == "1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd");
}

TEST_CASE("links are shorter than the best known ways of writing polygons", "[link][length]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CHECK(encode(star(20, seed, true)).size() <= 78);
  }
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CHECK(encode(star(100, seed, true)).size() <= 325);
    CHECK(encode(star(100, seed, false)).size() <= 1800);  // 18 characters a vertex
  }
  CHECK(encode(star(1000, 1, true)).size() <= 3000);
  CHECK(encode(star(1000, 1, false)).size() <= 17700);
}

TEST_CASE("a vertex that was dragged off the grid does not spoil the rest", "[link][length]") {
  Document document = thesis_sample();
  const std::size_t before = encode(document).size();
  document.vertices[3] = {278.12345678912, 306.9987654321234};
  CHECK(encode(document).size() <= before + 24);
}

TEST_CASE("a comb and a smooth curve take less than a character a vertex", "[link][length]") {
  Document comb;
  Document curve;
  for (int i = 0; i < 1000; ++i) {
    comb.vertices.emplace_back(20 * (i / 2), i % 4 == 1 || i % 4 == 2 ? 400 : 0);
    const double angle = 6.283185307179586 * i / 1000;
    curve.vertices.emplace_back(std::round(50000 * std::cos(angle)) / 100,
                                std::round(50000 * std::sin(angle)) / 100);
  }
  CHECK(encode(comb).size() < 40);
  CHECK(encode(curve).size() < 1000);
}

TEST_CASE("settings at their default take no room, others little", "[link][length]") {
  const Document usual = thesis_sample();
  const std::size_t length = encode(usual).size();
  const auto more = [&](auto change) {
    Document document = usual;
    if constexpr (std::is_invocable_v<decltype(change), Settings&>)
      change(document.settings);
    else
      change(document.shown);
    const std::string link = encode(document);
    CHECK(same_document(decode(link), document));
    return static_cast<int>(link.size()) - static_cast<int>(length);
  };
  CHECK(more([](Settings&) {}) == 0);
  CHECK(more([](Settings& s) { s.teams = std::nullopt; }) <= 3);
  CHECK(more([](Settings& s) { s.teams = 8; }) <= 5);
  CHECK(more([](Settings& s) { s.teams = max_teams; }) <= 7);
  for (const Method method : pair_methods) {
    CHECK(more([&](Settings& s) { s.method = method; }) <= 3);
  }
  CHECK(more([](Settings& s) { s.min_ratio = 0; }) <= 4);
  CHECK(more([](Settings& s) { s.min_ratio = 0.95; }) <= 5);
  CHECK(more([](Settings& s) { s.min_ratio = 1.0 / 3; }) <= 14);
  CHECK(more([](Settings& s) { s.weight = 2500; }) <= 6);
  CHECK(more([](Settings& s) { s.seed = 0; }) <= 4);
  CHECK(more([](Settings& s) { s.seed = std::numeric_limits<std::uint64_t>::max(); }) <= 14);
  CHECK(more([](Shown& s) { s.overlays.candidates = true; }) <= 4);
  CHECK(more([](Shown& s) { s.overlays = {false, false, false, false, false, true}; }) <= 4);
  CHECK(more([](Shown& s) { s.step = 0; }) <= 4);
  CHECK(more([](Shown& s) { s.step = 12; }) <= 4);
  CHECK(more([](Shown& s) { s.step = std::numeric_limits<std::uint32_t>::max(); }) <= 9);
}

// --- reading back --------------------------------------------------------------------------------

TEST_CASE("every document reads back in every bit, and has one link", "[link][slow]") {
  Rng rng(1);
  for (int i = 0; i < 5000; ++i) {
    const Document document = random_document(rng, i % 100 == 0 ? 600 : 14);
    const Result<std::string> link = encode_link(document);
    if (!link) FAIL(link.error().message);
    const Result<Document> back = decode_link(*link);
    if (!back) FAIL(*link << ": " << back.error().message);
    if (!same_document(*back, document)) FAIL(*link);
    if (*encode_link(*back) != *link) FAIL(*link << " has a second link");
    if (!looks_like_link(*link)) FAIL(*link << " does not look like a link");
  }
}

TEST_CASE("links written before are read for ever", "[link]") {
  // Never change a line: links like these are in use everywhere.
  for (const auto& row : evenlift::testing::read_table("links_version_1.txt", 2)) {
    INFO(row[0]);
    const Document document = decode(row[0]);
    const auto held = Json::parse(row[1]);
    const auto same = [](double value, const Json& expected) {
      return bits_of(value) == bits_of(expected.number());
    };
    REQUIRE(document.vertices.size() == held["vertices"].size());
    for (std::size_t i = 0; i < document.vertices.size(); ++i) {
      CHECK(same(document.vertices[i].x, held["vertices"][i][0]));
      CHECK(same(document.vertices[i].y, held["vertices"][i][1]));
    }
    const auto& centre = held["centre_of_mass"];
    REQUIRE(document.centre_of_mass.has_value() == !centre.is_null());
    if (document.centre_of_mass) {
      CHECK(same(document.centre_of_mass->x, centre[0]));
      CHECK(same(document.centre_of_mass->y, centre[1]));
    }
    const auto& settings = held["settings"];
    if (document.settings.teams) {
      CHECK(*document.settings.teams == settings["teams"].whole_number());
    } else {
      CHECK(settings["teams"] == "max");
    }
    CHECK(settings["metric"] == std::string(name(document.settings.method)));
    CHECK(same(document.settings.min_ratio, settings["min_ratio"]));
    CHECK(same(document.settings.weight, settings["weight"]));
    CHECK(document.settings.seed == settings["seed"].whole_number());
    std::vector<std::string> shown;
    const Overlays& overlays = document.shown.overlays;
    if (overlays.candidates) shown.push_back("candidates");
    if (overlays.chords) shown.push_back("chords");
    if (overlays.lifting_base) shown.push_back("hull");
    if (overlays.clockwise) shown.push_back("clockwise");
    if (overlays.counterclockwise) shown.push_back("counterclockwise");
    if (overlays.tipping) shown.push_back("tipping");
    CHECK(settings["overlays"].texts() == shown);
    REQUIRE(document.shown.step.has_value() == !settings["step"].is_null());
    if (document.shown.step) {
      CHECK(*document.shown.step == settings["step"].whole_number());
    }
  }
}

// On the thesis's sample, with settings of any size.
static Document balanced_document(Rng& rng) {
  Document document = random_document(rng, 14);
  Settings& settings = document.settings;
  settings.method = Method::balanced;
  settings.robots = static_cast<std::uint32_t>(least_robots + rng.below(most_robots - 1));
  if (rng.below(2) == 0) settings.goal = rng.below(2) == 0 ? Goal::cover : Goal::hold;
  if (rng.below(2) == 0) settings.min_margin = rng.below(2) == 0 ? rng.uniform() : -0.0;
  if (rng.below(2) == 0) settings.apart = rng.below(2) == 0 ? max_length * rng.uniform() : 0.0;
  if (rng.below(2) == 0)
    settings.survive = static_cast<std::uint32_t>(rng.below(most_survived + 1));
  return document;
}

TEST_CASE("balanced robots and their settings read back in every bit", "[link]") {
  Rng rng(2);
  for (int i = 0; i < 3000; ++i) {
    const Document document = balanced_document(rng);
    const std::string link = encode(document);
    INFO(link);
    REQUIRE(link.starts_with("2."));
    const Document back = decode(link);
    REQUIRE(same_document(back, document));
    REQUIRE(bits_of(back.settings.min_margin) == bits_of(document.settings.min_margin));
    REQUIRE(back.settings == document.settings);
    REQUIRE(encode(back) == link);
  }
}

TEST_CASE("each overlay alone reads back", "[link]") {
  for (bool Overlays::*overlay :
       {&Overlays::candidates, &Overlays::chords, &Overlays::lifting_base, &Overlays::clockwise,
        &Overlays::counterclockwise, &Overlays::tipping, &Overlays::halo, &Overlays::tilt,
        &Overlays::load}) {
    Document document = thesis_sample();
    document.shown.overlays.*overlay = !(document.shown.overlays.*overlay);
    CHECK(decode(encode(document)).shown.overlays == document.shown.overlays);
  }
}

TEST_CASE("units read back, and the usual ones take no character", "[link]") {
  Document document = thesis_sample();
  const std::string usual = encode(document);
  for (const LengthUnit length : all_length_units)
    for (const WeightUnit weight : all_weight_units) {
      document.shown.units = {length, weight};
      const std::string link = encode(document);
      INFO(link);
      CHECK((link == usual) == (document.shown.units == Units{}));
      CHECK(link.starts_with(document.shown.units == Units{} ? "1." : "2."));
      CHECK(same_document(decode(link), document));
    }
}

TEST_CASE(
    "a C uncertainty, a capacity and the overlay halo read back in every bit, whatever the method",
    "[link]") {
  Rng rng(4);
  for (int i = 0; i < 1000; ++i) {
    Document document = i % 2 == 0 ? balanced_document(rng) : random_document(rng, 14);
    Shown& shown = document.shown;
    if (i % 3 != 0) shown.com_radius = std::fabs(evenlift::testing::any_double(rng, max_length));
    if (i % 5 != 0)
      shown.capacity = min_weight + std::fabs(evenlift::testing::any_double(rng, 1e99));
    shown.overlays.halo = i % 7 != 0;
    shown.units = {all_length_units[i % 5], all_weight_units[i % 4]};
    const std::string link = encode(document);
    INFO(link);
    const Document back = decode(link);
    REQUIRE(same_document(back, document));
    REQUIRE(encode(back) == link);
  }
}

TEST_CASE("positions and the goal to hold of teams of two read back in every bit", "[link]") {
  Rng rng(6);
  for (int i = 0; i < 1000; ++i) {
    Document document = random_document(rng, 14);
    Settings& settings = document.settings;
    if (i % 3 != 0) settings.positions = Positions::range;
    if (i % 5 != 0) settings.goal = Goal::hold;
    if (i % 5 != 0 && i % 2 == 0) settings.min_margin = rng.uniform();
    const std::string link = encode(document);
    INFO(link);
    const Document back = decode(link);
    REQUIRE(back.settings == settings);
    REQUIRE(same_document(back, document));
    REQUIRE(encode(back) == link);
  }
  // Covering is the usual goal of teams of two.
  Document document = thesis_sample();
  const std::string link = encode(document);
  document.settings.goal = Goal::cover;
  document.settings.min_margin = 0.3;
  CHECK(encode(document) == link);
}

TEST_CASE("the size of robots and marked edges read back in every bit", "[link]") {
  Rng rng(4);
  for (int i = 0; i < 1000; ++i) {
    Document document = random_document(rng, 14);
    for (double RobotSize::*value : {&RobotSize::radius, &RobotSize::reach, &RobotSize::depth,
                                     &RobotSize::width, &RobotSize::gap}) {
      const bool there = rng.below(2) == 0;
      const double size = rng.uniform();
      if (there) document.settings.robot.*value = max_length * size;
    }
    const std::uint64_t parts = i == 0 ? most_no_go : rng.below(5);
    for (std::uint64_t k = 0; k < parts; ++k) {
      const auto edge = static_cast<std::uint32_t>(rng.below(max_vertices));
      const double from = rng.uniform() / 2, more = rng.uniform() / 2 + 1e-9;
      document.settings.no_go.push_back({edge, from, from + more});
    }
    const std::string link = encode(document);
    const Document back = decode(link);
    REQUIRE(back.settings == document.settings);
    REQUIRE(encode(back) == link);
  }
}

TEST_CASE("robots that were moved read back in every bit", "[link]") {
  Rng rng(9);
  for (int i = 0; i < 1000; ++i) {
    Document document = random_document(rng, 14);
    const bool balanced = i % 2 == 0;
    if (balanced) document.settings.method = Method::balanced;
    const auto point = [&] {
      const auto edge = static_cast<std::uint32_t>(rng.below(max_vertices));
      return EdgePoint{edge, rng.uniform()};
    };
    const std::uint64_t most = balanced ? most_robots : most_moved_teams;
    for (std::uint64_t k = i < 2 ? most : rng.below(5); k > 0; --k) {
      if (balanced) {
        document.moved.robots.push_back(point());
        continue;
      }
      const auto before = document.moved.teams.empty() ? 0 : document.moved.teams.back().team + 1;
      const auto team = before + static_cast<std::uint32_t>(rng.below(9));
      const EdgePoint end = point();
      document.moved.teams.push_back({team, end, point().edge});
    }
    const std::string link = encode(document);
    const Document back = decode(link);
    REQUIRE(back.moved == document.moved);
    REQUIRE(encode(back) == link);
  }
  // Robots moved under another method are dropped.
  Document document = thesis_sample();
  const std::string link = encode(document);
  document.moved.robots = {{0, 0.5}};
  CHECK(encode(document) == link);
  document.moved.teams = {{0, {0, 0.5}, 3}};
  CHECK(encode_refusal(document).message == "robots moved by hand stand where robots cannot");
  document.moved.robots.clear();
  document.moved.teams[0].end.part = 2;
  CHECK_FALSE(encode_link(document).ok());
}

TEST_CASE("what version 1 holds is written as version 1", "[link]") {
  Rng rng(3);
  for (int i = 0; i < 500; ++i) CHECK(encode(random_document(rng, 14)).starts_with("1."));
  // Other methods have no settings of balanced robots.
  Document document = thesis_sample();
  const std::string link = encode(document);
  document.settings.robots = 9;
  document.settings.survive = 2;
  CHECK(encode(document) == link);
}

TEST_CASE("balanced robots take a few characters more", "[link][length]") {
  Document document = thesis_sample();
  const std::size_t length = encode(document).size();
  document.settings.method = Method::balanced;
  CHECK(encode(document).size() <= length + 5);
  document.settings.goal = Goal::cover;
  CHECK(encode(document).size() <= length + 14);
}

// Version 2 without a polygon: an empty version 1, then these records, valid or not.
static std::string link_with(const std::vector<std::pair<unsigned, std::string>>& records,
                             bool ends) {
  Encoder coder;
  BitModel settings{{15, 1}};
  coder.code_bit(false, settings);
  code_integer(coder, 0, 16);  // vertices
  coder.code_uniform(0, 2);    // no centre of mass
  for (const auto& [tag, payload] : records) {
    code_integer(coder, tag, 8);
    code_integer(coder, payload.size(), 20);
    for (const char byte : payload) coder.code_uniform(static_cast<unsigned char>(byte), 256);
  }
  if (ends) code_integer(coder, 0, 8);
  std::string link = "2.";
  for (const std::uint8_t digit : coder.finish()) link += link_characters[digit];
  return evenlift::testing::with_checksum(link);
}

TEST_CASE("records that no writer makes are refused, and later ones named", "[link][errors]") {
  const Document six = decode(link_with({{1, "6"}}, true));
  CHECK(six.settings.method == Method::balanced);
  CHECK(six.settings.robots == 6);
  const Document held = decode(link_with({{2, "hold"}, {3, "0.125"}, {6, "range"}}, true));
  CHECK(held.settings.goal == Goal::hold);
  CHECK(held.settings.min_margin == 0.125);
  CHECK(held.settings.positions == Positions::range);
  const Document doubted = decode(link_with({{7, "2.5"}, {8, "20"}, {18, "shown"}}, true));
  CHECK(doubted.shown.com_radius == 2.5);
  CHECK(doubted.shown.capacity == 20.0);
  CHECK(doubted.shown.overlays.halo);
  for (const auto& records : std::vector<std::vector<std::pair<unsigned, std::string>>>{
           {},              // version 1 holds it
           {{2, "cover"}},  // the usual goal of teams of two
           {{3, "0.1"}},    // from teams with that goal
           {{6, "best"}},
           {{6, "any"}},
           {{1, "1"}},
           {{1, "65"}},
           {{1, "06"}},
           {{1, ""}},
           {{1, " 6"}},
           {{1, "six"}},
           {{1, "6"}, {1, "6"}},
           {{1, "6"}, {1, "7"}},
           {{2, "hold"}, {1, "6"}},  // out of order
           {{1, "6"}, {3, "0.05"}},  // the default
           {{1, "6"}, {3, "0.10"}},
           {{1, "6"}, {3, "2"}},
           {{1, "6"}, {4, "-1"}},
           {{1, "6"}, {5, "0"}},
           {{7, "0"}},  // the default
           {{7, "-1"}},
           {{8, "none"}},
           {{8, "0"}},
           {{8, "20"}, {7, "1"}},
           {{11, ""}},
           {{11, "none"}},
           {{11, ",kg"}},
           {{11, "mm,kg"}},
           {{11, "mm,"}},
           {{11, ","}},
           {{11, "lb"}},
           {{11, "mm,lb,t"}},
           {{11, " mm"}},
           {{9, "none"}},  // the default
           {{9, "r=0"}},
           {{9, "depth=2,r=1"}},  // out of order
           {{9, "r=-1"}},
           {{9, "r=1" + std::string(160, '0')}},
           {{10, "none"}},
           {{10, "0"}},
           {{10, "3:0-1"}},  // the whole edge
           {{10, "3:0.5"}},
           {{18, ""}},
           {{19, ""}},
           {{19, "3:0.5"}},  // of balanced robots
           {{1, "6"}, {19, "1@3:0.5/2"}},
           {{19, "1@3:0.50/2"}},
           {{19, "2@3:0.5/2,1@3:0.5/2"}},
           {{1, "6"}, {19, "3:-0"}},
           {{1, "6"}, {19, "3:0.5" + std::string(70000, '0')}},
           {{18, "yes"}},
           {{1, "6"}, {4, std::string(33, '1')}},
           {{20, "-1"}},
           {{20, "usual"}},
           {{1, std::string(40000, '6')}}}) {
    CHECK(refusal(link_with(records, true)).code == ErrorCode::bad_link);
  }
  unsigned next = 255;  // the number that the next kind of record gets
  while (!is_known(static_cast<Tag>(next - 1))) --next;
  for (const unsigned later : {16u, next, 255u}) {
    for (const bool ends : {true, false}) {
      const InputError error = refusal(link_with({{1, "6"}, {later, "anything"}}, ends));
      CHECK(error.code == ErrorCode::unknown_version);
      CHECK(error.message.find("newer") != std::string::npos);
    }
  }
}

TEST_CASE("the counts of a binary decision are halved above 255, rounded up", "[link]") {
  BitModel model{{1, 1}};
  for (int i = 0; i < 127; ++i) model.update(false);  // 2 each time
  CHECK(model.count[0] == 128);                       // 255 + 1 is too much
  CHECK(model.count[1] == 1);
  BitModel odd{{126, 128}};
  odd.update(true);
  CHECK(odd.count[0] == 63);
  CHECK(odd.count[1] == 65);
}

TEST_CASE("a link may leave out five digits, but not a sixth", "[link][errors]") {
  // A decoder begins with five digits; a value of 64 takes one more.
  const Digits none, one{0};
  Decoder empty(none);
  CHECK_FALSE(empty.failed());
  empty.code_uniform(0, 64);
  CHECK(empty.failed());
  Decoder decoder(one);
  decoder.code_uniform(0, 64);
  CHECK_FALSE(decoder.failed());
  decoder.code_uniform(0, 64);
  CHECK(decoder.failed());
}

TEST_CASE("links of version 2 written before are read for ever", "[link]") {
  // Never change a line.
  for (const auto& row : evenlift::testing::read_table("links_version_2.txt", 2)) {
    INFO(row[0]);
    const Document document = decode(row[0]);
    CHECK(encode(document) == row[0]);
    const Settings& settings = document.settings;
    const Shown& shown = document.shown;
    const auto held = Json::parse(row[1])["settings"];
    CHECK(document.vertices.size() == 11);
    CHECK(held["metric"] == std::string(name(settings.method)));
    CHECK(settings.robots == held.number_or("robots", 6));
    CHECK(shown.com_radius == held.number_or("com_radius", 0.0));
    const std::string units = held.text_or("units", ",kg");
    CHECK(name(shown.units.length) ==
          (units.front() == ',' ? "none" : units.substr(0, units.find(','))));
    CHECK(name(shown.units.weight) ==
          (units.find(',') == std::string::npos ? "kg" : units.substr(units.find(',') + 1)));
    REQUIRE(shown.capacity.has_value() == held.contains("capacity"));
    if (shown.capacity) CHECK(*shown.capacity == held["capacity"].number());
    const auto& overlays = held["overlays"];
    CHECK(shown.overlays.halo ==
          (std::find(overlays.begin(), overlays.end(), "halo") != overlays.end()));
    CHECK(settings.survive == held.number_or("survive", 0));
    CHECK(name(settings.positions) == held.text_or("positions", "best"));
    CHECK(robot_text(settings.robot) == held.text_or("robot", "none"));
    CHECK(no_go_text(settings.no_go) == held.text_or("no_go", "none"));
    CHECK(moved_text(document.moved) == held.text_or("moved", ""));
    CHECK(settings.min_margin == held.number_or("min_margin", 0.05));
    CHECK(settings.weight == held["weight"].number());
    REQUIRE(settings.goal.has_value() == held.contains("goal"));
    if (settings.goal) CHECK(held["goal"] == std::string(name(*settings.goal)));
    REQUIRE(settings.apart.has_value() == held.contains("apart"));
    if (settings.apart) CHECK(*settings.apart == held["apart"].number());
  }
}

TEST_CASE("a link without settings means the defaults of 1.0.0", "[link]") {
  // If a changed default breaks this, set the old one in defaults_of_links() (link/settings.h).
  Settings settings;
  settings.teams = 3;
  settings.method = Method::area;
  settings.min_ratio = 0.8;
  settings.weight = 100;
  settings.seed = 1;
  settings.goal = std::nullopt;
  settings.min_margin = 0.05;
  settings.apart = std::nullopt;
  settings.clear = std::nullopt;
  settings.survive = 0;
  settings.positions = Positions::best;
  settings.robot = {0, 0, 0, 0, 0};
  settings.no_go = {};
  Shown shown;
  shown.overlays = {false, true, true, true, true, false, false};
  shown.step = std::nullopt;
  shown.com_radius = 0;
  shown.capacity = std::nullopt;
  shown.units = {LengthUnit::none, WeightUnit::kg};
  const Document document = decode("1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd");
  CHECK(document.settings == settings);
  CHECK(document.shown == shown);
}

TEST_CASE("a link may come with its address and white space around", "[link]") {
  const std::string link = encode(thesis_sample());
  for (const std::string& text :
       {link, "#" + link, " \n" + link + "\r\n", "https://example.org/evenlift/index.html#" + link,
        "https://example.org/e/index.html?embed=1#" + link, "\tfile:///home/a/index.html#" + link,
        "index.html#" + link, "#" + link + " ",
        "https://example.org/e/#" + link + "&utm_source=mail&x=%20", link + ".",
        "(https://example.org/e/#" + link + ")", "<https://example.org/e/#" + link + ">,"}) {
    CHECK(same_document(decode(text), thesis_sample()));
    CHECK(looks_like_link(text));
  }
}

TEST_CASE("a document without vertices has a link, too", "[link]") {
  Document document;
  CHECK(same_document(decode(encode(document)), document));
  document.centre_of_mass = Vec2(-0.0, 1e-300);
  document.shown.step = 3;
  CHECK(same_document(decode(encode(document)), document));
}

// --- refusals ------------------------------------------------------------------------------------

TEST_CASE("hostile links are refused with a code and a sentence", "[link][errors]") {
  for (const auto& row : evenlift::testing::read_table("hostile_links.txt", 3)) {
    INFO(row[1] << ": " << row[2]);
    const InputError error = refusal(evenlift::testing::from_json_string(row[1]));
    INFO(error.message);
    CHECK(evenlift::testing::name_of(error.code) == row[0]);
    CHECK(error.place.kind == Place::Kind::link);
    CHECK(evenlift::testing::is_one_sentence(error.message));
  }
}

TEST_CASE("messages name the character that cannot be in a link", "[link][errors]") {
  const std::string link = encode(thesis_sample());
  CHECK(describe(refusal(link + ".A").place) == "link, character 50");
  CHECK(refusal(link + ".A").message == "'.' cannot be in a link");
  CHECK(describe(refusal("  #" + link.substr(0, 9) + " " + link.substr(9)).place) ==
        "link, character 13");
  CHECK(refusal(link.substr(0, 9) + "\n" + link.substr(9)).message ==
        "the link is broken by a space or the end of a line");
  CHECK(refusal("1%2E" + link.substr(2)).message.find("escaped") != std::string::npos);
  CHECK(refusal("3." + link.substr(2)).message.find("newer") != std::string::npos);
}

TEST_CASE("any one character changed, and any cut, is noticed", "[link][errors]") {
  const std::string link = encode(thesis_sample());
  for (std::size_t at = 2; at < link.size(); ++at) {
    for (const char c : link_characters) {
      if (c == link[at]) continue;
      std::string changed = link;
      changed[at] = c;
      if (refusal(changed).code != ErrorCode::bad_checksum) FAIL(changed);
    }
    CHECK(refusal(link.substr(0, at)).code == ErrorCode::bad_checksum);
    CHECK(refusal("1." + link.substr(at + 1)).code == ErrorCode::bad_checksum);
    std::string swapped = link;
    if (at + 1 < link.size()) std::swap(swapped[at], swapped[at + 1]);
    if (swapped != link) CHECK(refusal(swapped).code == ErrorCode::bad_checksum);
  }
}

TEST_CASE("what no link can carry is refused with its place", "[link][errors]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto check = [](auto change, ErrorCode code, const char* place) {
    Document document = thesis_sample();
    change(document);
    const InputError error = encode_refusal(document);
    CHECK(error.code == code);
    CHECK(describe(error.place) == place);
    CHECK(evenlift::testing::is_one_sentence(error.message));
  };
  for (const double bad : {nan, infinity, -infinity, 1.0000000000000002e9, -1e300}) {
    check([&](Document& d) { d.vertices[2].y = bad; }, ErrorCode::bad_coordinate, "vertex 3");
    check([&](Document& d) { d.centre_of_mass = Vec2(bad, 1); }, ErrorCode::bad_coordinate,
          "centre of mass");
  }
  check([](Document& d) { d.settings.teams = 0; }, ErrorCode::bad_setting, "teams");
  check([](Document& d) { d.settings.teams = max_teams + 1; }, ErrorCode::bad_setting, "teams");
  for (const double bad : {nan, infinity, -0.1, 1.0000000000000002}) {
    check([&](Document& d) { d.settings.min_ratio = bad; }, ErrorCode::bad_setting, "min_ratio");
  }
  for (const double bad : {nan, infinity, 0.0, -0.0, -1.0}) {
    check([&](Document& d) { d.settings.weight = bad; }, ErrorCode::bad_setting, "weight");
  }
  check([](Document& d) { d.settings.method = static_cast<Method>(7); }, ErrorCode::bad_setting,
        "metric");
  check([](Document& d) { d.vertices.resize(max_link_vertices + 1, Vec2(1, 2)); },
        ErrorCode::too_many_vertices, "");

  Document document = thesis_sample();
  document.vertices[2] = {max_coordinate, -max_coordinate};
  document.settings.min_ratio = 1;
  document.settings.weight = 5e-324;
  CHECK(same_document(decode(encode(document)), document));
}

TEST_CASE("what looks like a link", "[link]") {
  for (const char* text : {"1.abc", "1.", "12.AZaz09-_", "#1.abc", " 1.abc\n", "http://a/b?c#1.abc",
                           "a.html#1.abc", "1%2Eabc", "1.abc%2D", "1.ab.c", "1.5", "1.txt"}) {
    INFO(text);
    CHECK(looks_like_link(text));
  }
  for (const char* text :
       {"", " ", "#", "abc", "a.txt", "1", "#1", "1,5", "(1,2)", "CoM:(1,2)\n(3,4)",
        "POLYGON((0 0,1 0,1 1))", "{\"type\":\"Polygon\"}", "-", "./1.abc", "1.a b", "1.abc\n1.abc",
        "/home/a/1.txt", "see http://a/b#1.abc", "1.\xc3\xa9"}) {
    INFO(text);
    CHECK(!looks_like_link(text));
  }
}

// --- bounds --------------------------------------------------------------------------------------

TEST_CASE("the longest links fit the bound, whatever the doubles", "[link][bounds][slow]") {
  Rng rng(2);
  for (const double limit : {max_coordinate, 1000.0, 1e-300}) {
    Document document;
    for (std::size_t i = 0; i < max_link_vertices; ++i) {
      const double x = any_double(rng, limit);
      document.vertices.emplace_back(x, any_double(rng, limit));
    }
    const std::string link = encode(document);
    CHECK(link.size() < max_link_bytes);
    CHECK(same_document(decode(link), document));
  }
}

TEST_CASE("a text longer than max_link_bytes is refused unread", "[link][bounds]") {
  CHECK(refusal("1." + std::string(max_link_bytes, 'A')).code == ErrorCode::text_too_long);
  CHECK(refusal(std::string(max_link_bytes + 1, ' ')).code == ErrorCode::text_too_long);
  CHECK(refusal("1." + std::string(max_link_bytes - 2, 'A')).code == ErrorCode::bad_checksum);
}

// Scanning characters repeatedly would take hours.
TEST_CASE("the longest hostile payloads are refused", "[link][bounds]") {
  for (const char fill : {'A', '_', 'g', 'P'}) {
    const std::string text = with_checksum("1." + std::string(max_link_bytes - 6, fill));
    CHECK(refusal(text).code == ErrorCode::bad_link);
  }
}

// --- any bytes -----------------------------------------------------------------------------------

TEST_CASE("any bytes give a document or one sentence", "[link][fuzz]") {
  Rng rng(3);
  const std::string bytes = std::string(link_characters) + "..%# \n\xff";
  int documents = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = *encode_link(random_document(rng, 5));
    if (rng.below(4) == 0) {
      text.clear();
      for (std::uint64_t n = rng.below(30); n > 0; --n) text += bytes[rng.below(bytes.size())];
    }
    text = mutated(rng, text, bytes);
    const Result<Document> document = decode_link(text);
    ++(document.ok() ? documents : refused);
    if (document.ok()) {  // without effect, like a leading space
      const std::string again = encode(*document);
      if (text.find(again) == std::string::npos) FAIL(text << " reads as " << again);
    } else if (!evenlift::testing::is_one_sentence(document.error().message) ||
               document.error().place.kind != Place::Kind::link) {
      FAIL(text << ": " << document.error().message);
    }
  }
  CHECK(documents > 10);
  CHECK(refused > 10000);
}

TEST_CASE("any payload with a good checksum gives a document that a link can carry, or is refused",
          "[link][fuzz]") {
  Rng rng(4);
  int documents = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string payload;
    if (rng.below(2) == 0) {
      for (std::uint64_t n = rng.below(40); n > 0; --n) payload += link_characters[rng.below(64)];
    } else {
      payload = without_checksum(*encode_link(random_document(rng, 5))).substr(2);
      payload = mutated(rng, payload, link_characters);
    }
    const std::string text = with_checksum("1." + payload);
    const Result<Document> document = decode_link(text);
    if (!document.ok()) {
      if (document.error().code != ErrorCode::bad_link) FAIL(text << document.error().message);
      continue;
    }
    ++documents;
    // Perhaps not as we write it, but nothing is lost or added.
    const Result<std::string> again = encode_link(*document);
    if (!again || !same_document(*decode_link(*again), *document)) FAIL(text);
  }
  CHECK(documents > 1000);
}

TEST_CASE("a link keeps holes and cargo, and each is read back in every bit", "[link][cargo]") {
  std::mt19937_64 engine(5);
  const auto number = [&](double size) {
    const double part = static_cast<double>(engine() >> 11) * 0x1p-53;
    return engine() % 2 == 0 ? std::floor(size * part) : size * part;
  };
  for (int i = 0; i < 300; ++i) {
    Document document = corpus::polygon(i % 2 == 0 ? "guitar" : "square");
    for (std::uint64_t holes = engine() % 4; holes > 0; --holes) {
      Points ring;
      for (std::uint64_t k = 1 + engine() % 9; k > 0; --k)
        ring.emplace_back(number(1e3), number(-1e3));
      document.holes.push_back(ring);
    }
    for (std::uint64_t items = engine() % 3; items > 0; --items)
      document.settings.cargo.push_back(
          {Vec2(number(1e4), number(10)), 1 + number(1e3), engine() % 2 == 0 ? "" : "Küche 1"});
    if (i % 3 == 0) {
      document.settings.method = Method::given;
      document.settings.supports = {Vec2(number(5), 1), Vec2(2, number(7))};
    }
    const auto link = encode_link(document);
    REQUIRE(link.ok());
    const auto read = decode_link(*link);
    REQUIRE(read.ok());
    CHECK(read->holes == document.holes);
    CHECK(read->settings.cargo == document.settings.cargo);
    CHECK(read->settings.supports == document.settings.supports);
    CHECK(*encode_link(*read) == *link);
  }
  Document document = corpus::polygon("square");
  document.holes = {{}};
  CHECK(encode_link(document).error().place.kind == Place::Kind::hole);
}
