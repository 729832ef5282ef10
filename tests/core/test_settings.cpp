// One grammar for the program, scripts, lessons and the texts that the page keeps.
#include "evenlift/settings.h"

#include <cstdlib>
#include <limits>
#include <set>

#include "app/update.h"
#include "evenlift/lesson.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "fuzz/any_numbers.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/data_table.h"
#include "kit/random_documents.h"

using namespace evenlift;

namespace {

struct Text {
  Setting setting;
  const char* text;
};

constexpr Text good[] = {
    {Setting::teams, "1"},
    {Setting::teams, "1048576"},
    {Setting::teams, "007"},
    {Setting::teams, "max"},
    {Setting::method, "area"},
    {Setting::method, "random"},
    {Setting::min_ratio, "0"},
    {Setting::min_ratio, "1"},
    {Setting::min_ratio, "+.5"},
    {Setting::min_ratio, "8e-1"},
    {Setting::com, "centroid"},
    {Setting::com, "1,2"},
    {Setting::com, "-1e3,+.5"},
    {Setting::com, "1, 2"},
    {Setting::com, "1 ,\t2"},
    {Setting::weight, "100"},
    {Setting::weight, "1e-100"},
    {Setting::weight, "1e100"},
    {Setting::seed, "0"},
    {Setting::seed, "18446744073709551615"},
    {Setting::overlays, "none"},
    {Setting::overlays, "chords"},
    {Setting::overlays, "tipping,candidates"},
    {Setting::step, "none"},
    {Setting::step, "4294967295"},
    {Setting::method, "balanced"},
    {Setting::robots, "2"},
    {Setting::robots, "64"},
    {Setting::goal, "cover"},
    {Setting::goal, "hold"},
    {Setting::min_margin, "0"},
    {Setting::min_margin, "1"},
    {Setting::apart, "0"},
    {Setting::apart, "1e6"},
    {Setting::apart, "1e9"},
    {Setting::survive, "0"},
    {Setting::survive, "30"},
    {Setting::capacity, "12.5"},
    {Setting::capacity, "1e-9"},
    {Setting::capacity, "1e-100"},
    {Setting::capacity, "1e100"},
    {Setting::capacity, "none"},
    {Setting::com_radius, "0"},
    {Setting::com_radius, "12.5"},
    {Setting::com_radius, "5e-324"},
    {Setting::com_radius, "1e9"},
    {Setting::unit, "mm"},
    {Setting::unit, "m"},
    {Setting::unit, "none"},
    {Setting::weight_unit, "lb"},
    {Setting::weight_unit, "t"},
    {Setting::positions, "range"},
    {Setting::robot, "r=1e-3,depth=0.01"},
    {Setting::robot_radius, "0.001"},
    {Setting::robot_gap, "2"},
    {Setting::robot_gap, "1e9"},
    {Setting::no_go, "2:0.25-0.75"},
};

constexpr Text bad[] = {
    {Setting::teams, ""},
    {Setting::teams, "0"},
    {Setting::teams, "-1"},
    {Setting::teams, "+1"},
    {Setting::teams, " 1"},
    {Setting::teams, "1 "},
    {Setting::teams, "2.5"},
    {Setting::teams, "2e0"},
    {Setting::teams, "0x2"},
    {Setting::teams, "Max"},
    {Setting::teams, "1048577"},
    {Setting::teams, "4294967297"},
    {Setting::teams, "99999999999999999999"},
    {Setting::method, ""},
    {Setting::method, "Area"},
    {Setting::method, "area "},
    {Setting::min_ratio, ""},
    {Setting::min_ratio, "-0.1"},
    {Setting::min_ratio, "1.0000000000000002"},
    {Setting::min_ratio, "nan"},
    {Setting::min_ratio, "0,5"},
    {Setting::min_ratio, "80%"},
    {Setting::com, ""},
    {Setting::com, ","},
    {Setting::com, "1"},
    {Setting::com, "1,"},
    {Setting::com, ",1"},
    {Setting::com, "1,2,3"},
    {Setting::com, "(1,2)"},
    {Setting::com, " 1,2"},
    {Setting::com, "1,2 "},
    {Setting::com, "1\n,2"},
    {Setting::com, "1,inf"},
    {Setting::com, "Centroid"},
    {Setting::weight, "0"},
    {Setting::weight, "-1"},
    {Setting::weight, "0x10"},
    {Setting::weight, " 3"},
    {Setting::weight, "3 "},
    {Setting::weight, "3kg"},
    {Setting::weight, "inf"},
    {Setting::weight, "1e999"},
    {Setting::weight, "1e-999"},
    {Setting::weight, "1.797e308"},
    {Setting::weight, "1.0001e100"},
    {Setting::weight, "9.999e-101"},
    {Setting::weight, "5e-324"},
    {Setting::seed, "-1"},
    {Setting::seed, "1.0"},
    {Setting::seed, "1e3"},
    {Setting::seed, "18446744073709551616"},
    {Setting::overlays, ""},
    {Setting::overlays, "chords,"},
    {Setting::overlays, "chords,none"},
    {Setting::overlays, "chords, hull"},
    {Setting::overlays, "chords,chords"},
    {Setting::overlays, "all"},
    {Setting::step, ""},
    {Setting::step, "-1"},
    {Setting::step, "4294967296"},
    {Setting::robots, "1"},
    {Setting::robots, "65"},
    {Setting::robots, "max"},
    {Setting::positions, "anywhere"},
    {Setting::positions, ""},
    {Setting::goal, "Hold"},
    {Setting::goal, ""},
    {Setting::min_margin, "-0.1"},
    {Setting::min_margin, "1.1"},
    {Setting::apart, "-1"},
    {Setting::apart, "inf"},
    {Setting::apart, "1.0000001e9"},
    {Setting::survive, "31"},
    {Setting::survive, "-1"},
    {Setting::capacity, ""},
    {Setting::capacity, "0"},
    {Setting::capacity, "-1"},
    {Setting::capacity, "inf"},
    {Setting::capacity, "0x10"},
    {Setting::capacity, "1e101"},
    {Setting::capacity, "5e-324"},
    {Setting::unit, ""},
    {Setting::unit, "MM"},
    {Setting::unit, "kg"},
    {Setting::unit, "mm,kg"},
    {Setting::weight_unit, ""},
    {Setting::weight_unit, "none"},
    {Setting::weight_unit, "mm"},
    {Setting::weight_unit, "n"},
    {Setting::com_radius, ""},
    {Setting::com_radius, "-1e-9"},
    {Setting::com_radius, "nan"},
    {Setting::com_radius, "1e999"},
    {Setting::com_radius, "1e308"},
    {Setting::com_radius, "none"},
    {Setting::robot, ""},
    {Setting::robot, "r=-1"},
    {Setting::robot, "r=1,r=1"},
    {Setting::robot, "r=1e308,reach=1e308"},
    {Setting::robot_radius, "-1"},
    {Setting::robot_radius, "1.0000001e9"},
    {Setting::robot_depth, "none"},
    {Setting::no_go, ""},
    {Setting::no_go, "0"},
    {Setting::no_go, "1:0.75-0.25"},
    {Setting::loads, "plan"},  // not a setting of the document
};

bool same(const Document& a, const Document& b) {
  return a.settings == b.settings && a.shown == b.shown && a.centre_of_mass == b.centre_of_mass &&
         a.vertices == b.vertices;
}

Document unusual() {
  Document document;
  document.vertices = {{0, 0}, {1, 0}, {0, 1}};
  document.centre_of_mass = Vec2(0.25, 0.25);
  document.settings.teams = 17;
  document.settings.method = Method::circle;
  document.settings.min_ratio = 0.125;
  document.settings.weight = 12;
  document.settings.seed = 99;
  document.shown.overlays = {true, false, true, false, true, true};
  document.shown.step = 4;
  document.settings.survive = 1;
  document.shown.capacity = 20;
  document.shown.com_radius = 3;
  document.shown.units = {LengthUnit::in, WeightUnit::N};
  return document;
}

bool is_lesson_setting(Setting setting) {
  return setting == Setting::overlays || row_of(setting).option.group != OptionGroup::none;
}

// A lesson with one setting.
Result<Lesson> lesson_with(const Text& given) {
  return parse_lesson("title: T\npolygon: square\n" + hyphened(name(given.setting)) + ":" +
                      given.text + "\n[end]\nWords.\n");
}

// Changes the settings of the placement, or of the view.
void change_part(Document& document, const auto& change) {
  if constexpr (std::is_invocable_v<decltype(change), Settings&>)
    change(document.settings);
  else
    change(document.shown);
}

// Random settings of every kind.
Document any_document(Rng& rng) {
  Document document = testing::random_document(rng, 0);
  for (const Text& given : good)
    if (rng.below(8) == 0) REQUIRE_FALSE(read_setting(given.setting, given.text, document));
  for (const SettingRow& row : all_settings()) {
    if (!row.access.is_number || rng.below(2) == 0) continue;
    const double value = row.range.least + (row.range.most - row.range.least) * rng.uniform();
    if (read_setting(row.setting, shortest(value), document)) {
      const auto whole = static_cast<std::uint64_t>(value);
      REQUIRE_FALSE(read_setting(row.setting, std::to_string(whole), document));
    }
  }
  for (std::uint64_t parts = rng.below(4); parts > 0; --parts) {
    const auto edge = static_cast<std::uint32_t>(rng.below(max_vertices));
    const double from = rng.uniform() / 2;
    document.settings.no_go.push_back({edge, from, 0.5 + rng.uniform() / 2});
  }
  return document;
}

std::string trimmed(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.erase(0, 1);
  while (!text.empty() && blank(text.back())) text.pop_back();
  return text;
}

}  // namespace

TEST_CASE("every setting has a name that leads back to it and a sentence", "[settings]") {
  for (const SettingRow& row : all_settings()) {
    const Setting setting = row.setting;
    INFO(name(setting));
    CHECK(setting_from_name(name(setting)) == setting);
    CHECK(testing::is_one_sentence(requirement(setting)));
    const InputError error = setting_error(setting);
    CHECK(error.code == ErrorCode::bad_setting);
    CHECK(error.place.option == name(setting));
  }
  CHECK(setting_from_name("method") == Setting::method);
  CHECK_FALSE(setting_from_name("min-ratio"));
  CHECK_FALSE(setting_from_name(""));
}

// Users know these messages, and scripts search for them.
TEST_CASE("what each setting may be is said as ever", "[settings][expected]") {
  std::string sentences;
  for (const SettingRow& row : all_settings())
    sentences += std::string(row.name) + ": " + requirement(row.setting) + '\n';
  std::string path(EVENLIFT_TESTS_DIR);
  path += "/expected/settings.txt";
  if (std::getenv("EVENLIFT_UPDATE_EXPECTED") != nullptr) corpus::write_file(path, sentences);
  CHECK(corpus::read_file(path) == sentences);
}

TEST_CASE("a row has what its doors need", "[settings]") {
  std::set<int> records;
  for (const SettingRow& row : all_settings()) {
    INFO(row.name);
    const SettingRow::Option& option = row.option;
    const bool is_option = option.group != OptionGroup::none;
    CHECK(option.value.empty() != is_option);
    if (row.changes != Changes::view) CHECK_FALSE(option.help.empty());
    CHECK(row.range.least <= row.range.most);
    CHECK((row.access.read && row.access.text && row.access.allowed));
    CHECK(row.rule.empty() == (row.access.kind != nullptr));
    if (row.record == 0) continue;
    CHECK(records.insert(row.record).second);
  }
}

TEST_CASE("the texts of a document's settings read back as the document", "[settings]") {
  Rng rng(28);
  int read = 0;
  for (int i = 0; i < 5000; ++i) {
    const Document document = any_document(rng);
    if (check_ranges(document.settings, document.shown))
      continue;  // allowed in a link, but not in
                 // a text
    Document back;
    for (const SettingRow& row : all_settings()) {
      const std::string text = text_of(row.setting, document);
      if (row.changes == Changes::view || text.empty()) continue;
      INFO(row.name << "=" << text);
      REQUIRE(read_setting(row.setting, text, back) == std::nullopt);
      REQUIRE(text_of(row.setting, back) == text);
    }
    REQUIRE(testing::same_document(back, document));
    ++read;
  }
  CHECK(read > 4000);
}

TEST_CASE("a setting is read from text, or refused with its sentence and nothing changed",
          "[settings]") {
  for (const Text& given : good) {
    INFO(name(given.setting) << "=" << given.text);
    Document document = unusual();
    CHECK(read_setting(given.setting, given.text, document) == std::nullopt);
    CHECK_FALSE(same(document, unusual()));
    CHECK(check_ranges(document.settings, document.shown) == std::nullopt);
  }
  for (const Text& given : bad) {
    INFO(name(given.setting) << "=" << given.text);
    Document document = unusual();
    const auto error = read_setting(given.setting, given.text, document);
    REQUIRE(error);
    CHECK(error->message.starts_with(requirement(given.setting)));
    CHECK(error->place.option == name(given.setting));
    CHECK(same(document, unusual()));
  }
}

TEST_CASE("of marked edges the one that is wrong is quoted, if that is short", "[settings]") {
  const auto refused = [](const std::string& text) {
    Document document;
    return read_setting(Setting::no_go, text, document).value().message;
  };
  const std::string rule = requirement(Setting::no_go);
  CHECK(refused("1,5:2-3,7") == rule + ", not \"5:2-3\"");
  CHECK(refused("1," + std::string(41, 'x')) == rule);
  CHECK(refused("1,\n") == rule);
}

TEST_CASE("settings read from text have the values that are written", "[settings]") {
  Document document = unusual();
  const auto read = [&](Setting setting, const char* text) {
    REQUIRE(read_setting(setting, text, document) == std::nullopt);
  };
  read(Setting::teams, "12");
  CHECK(document.settings.teams == 12u);
  read(Setting::teams, "max");
  CHECK_FALSE(document.settings.teams);
  read(Setting::com, "-1e3, .5");
  CHECK(document.centre_of_mass == Vec2(-1000, 0.5));
  read(Setting::com, "centroid");
  CHECK_FALSE(document.centre_of_mass);
  read(Setting::overlays, "hull,tipping");
  CHECK(document.shown.overlays == Overlays{false, false, true, false, false, true});
  read(Setting::overlays, "none");
  CHECK(document.shown.overlays == Overlays{false, false, false, false, false, false});
  read(Setting::step, "none");
  CHECK_FALSE(document.shown.step);
}

TEST_CASE("the robot that fails is a number from 1, or none", "[settings]") {
  CHECK(read_failed("none") == 0u);
  CHECK(read_failed("3") == 3u);
  for (const char* text : {"", "0", "-1", "2.5", "three", " 3"}) CHECK_FALSE(read_failed(text));
}

TEST_CASE("scripts and lessons take and refuse the same texts for a setting", "[settings][view]") {
  const auto script = [](const Text& given) {
    // Two robots survive no failure.
    const bool of_balanced = row_of(given.setting).counts_for == CountsFor::balanced;
    std::string method;
    if (of_balanced) method = "metric=balanced\n";
    if (of_balanced) method += given.setting == Setting::survive ? "robots=64\n" : "survive=0\n";
    return view::with_settings({unusual()},
                               method + std::string(name(given.setting)) + "=" + given.text);
  };
  for (const Text& given : good) {
    INFO(name(given.setting) << "=" << given.text);
    CHECK(script(given).ok());
    if (is_lesson_setting(given.setting)) CHECK(lesson_with(given).ok());
  }
  for (const Text& given : bad) {
    if (given.setting == Setting::loads) continue;  // which scripts can set
    INFO(name(given.setting) << "=" << given.text);
    const auto refused = script(given);
    // A line end makes two lines for a script.
    CHECK_FALSE(refused.ok());
    // Spaces around a lesson's value do not count.
    if (!is_lesson_setting(given.setting) || trimmed(given.text) != given.text) continue;
    CHECK_FALSE(lesson_with(given).ok());
  }
}

TEST_CASE("a script's settings change together or say which is wrong", "[settings][view]") {
  const view::Changeable before{unusual()};
  const auto changed = view::with_settings(
      before,
      "teams=max\nmin_ratio=0.25\nmetric=distance\ncom=12.5,-3e-1\nstep=4\ncapacity=7\n"
      "loads=springs\nfailed=3");
  REQUIRE(changed.ok());
  CHECK_FALSE(changed->document.settings.teams);
  CHECK(changed->document.settings.min_ratio == 0.25);
  CHECK(changed->document.settings.method == Method::distance);
  CHECK(changed->document.centre_of_mass == Vec2(12.5, -0.3));
  CHECK(changed->document.shown.step == 4u);
  CHECK(changed->document.shown.capacity == 7.0);
  CHECK(changed->load_model == LoadModel::springs);
  CHECK(changed->failed == 3u);
  CHECK(view::with_settings(before, "")->document.shown.capacity == 20.0);
  CHECK_FALSE(view::with_settings(before, "")->failed);
  CHECK_FALSE(view::with_settings(before, "capacity=none")->document.shown.capacity);
  for (const char* bad : {"teams", "x=1", "=", "Teams=3", "min-ratio=0.5", "capacity=0",
                          "capacity=", "loads=", "loads=most", "failed=0", "failed=x",
                          "teams=max\nmetric=random", "teams=3\n\nseed=1"}) {
    INFO(bad);
    CHECK_FALSE(view::with_settings(before, bad).ok());
  }
}

TEST_CASE("what the browser keeps reads back, and nonsense is left out", "[settings][view]") {
  for (const bool motion : {false, true})
    CHECK(view::read_kept(view::kept_text({motion})).motion == motion);
  CHECK(view::read_kept("").motion);
  CHECK_FALSE(view::read_kept("later=1\nmotion=0\ncapacity=7\n").motion);
}

TEST_CASE("each range holds for settings as values, in links and placements alike",
          "[settings][link]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto check = [](auto change, Setting setting) {
    Document document = unusual();
    change_part(document, change);
    const auto error = check_ranges(document.settings, document.shown);
    REQUIRE(error);
    CHECK(error->message == requirement(setting));
    CHECK(check_settings(document.settings, document.shown)->message == error->message);
    CHECK(encode_link(document).error().message == error->message);
    CHECK(place(document).error().message == error->message);
  };
  const double too_long = std::nextafter(max_length, infinity);
  for (const double length : {-1e-9, infinity, std::nan("")})
    check([&](Shown& s) { s.com_radius = length; }, Setting::com_radius);
  for (const double load : {0.0, -1.0, infinity, std::nan("")})
    check([&](Shown& s) { s.capacity = load; }, Setting::capacity);
  check([](Settings& s) { s.teams = 0; }, Setting::teams);
  check([](Settings& s) { s.teams = max_teams + 1; }, Setting::teams);
  check([](Settings& s) { s.method = static_cast<Method>(7); }, Setting::method);
  for (const double ratio : {-0.1, 1.1, infinity, std::nan("")})
    check([&](Settings& s) { s.min_ratio = ratio; }, Setting::min_ratio);
  for (const double weight : {0.0, -1.0, infinity, std::nan("")})
    check([&](Settings& s) { s.weight = weight; }, Setting::weight);
  for (const std::uint32_t robots : {0u, 1u, 65u})
    check([&](Settings& s) { s.robots = robots; }, Setting::robots);
  for (const double margin : {-0.1, 1.1, infinity, std::nan("")})
    check([&](Settings& s) { s.min_margin = margin; }, Setting::min_margin);
  for (const double apart : {-1.0, infinity, std::nan("")})
    check([&](Settings& s) { s.apart = apart; }, Setting::apart);
  check([](Settings& s) { s.survive = 31; }, Setting::survive);
  for (const double clear : {-1.0, too_long, infinity, std::nan("")})
    check([&](Settings& s) { s.clear = clear; }, Setting::clear);
  for (const double size : {-1.0, too_long, infinity, std::nan("")})
    for (double RobotSize::*part : {&RobotSize::radius, &RobotSize::reach, &RobotSize::depth,
                                    &RobotSize::width, &RobotSize::gap})
      check([&](Settings& s) { s.robot.*part = size; }, Setting::robot);
  check([](Settings& s) { s.no_go = {{0, 0.5, 0.5}}; }, Setting::no_go);
  check([](Settings& s) { s.no_go = {{0, 0, 1.5}}; }, Setting::no_go);
  check([](Settings& s) { s.supports.assign(most_supports + 1, Vec2(0, 0)); }, Setting::supports);
  check([](Settings& s) { s.supports = {{0, 2e9}}; }, Setting::supports);
  for (const double snap : {-1.0, too_long, infinity, std::nan("")})
    check([&](Settings& s) { s.snap = snap; }, Setting::snap);
  check([](Shown& s) { s.support_capacities = {0.0}; }, Setting::support_capacities);
  check([](Shown& s) { s.units.length = static_cast<LengthUnit>(5); }, Setting::unit);
  check([](Shown& s) { s.units.weight = static_cast<WeightUnit>(4); }, Setting::weight_unit);
}

// Older links contain such numbers, and must remain readable for ever (link.h).
TEST_CASE("a number out of bounds stays in a link, and is refused where robots are placed",
          "[settings][link]") {
  const auto check = [](auto change, Setting setting) {
    Document document = unusual();
    document.settings.method = Method::balanced;
    document.settings.robots = 6;
    document.settings.survive = 0;
    change_part(document, change);
    const auto link = encode_link(document);
    REQUIRE(link.ok());
    const auto back = decode_link(*link);
    REQUIRE(back.ok());
    CHECK(same(*back, document));
    CHECK(check_ranges(back->settings, back->shown)->message == requirement(setting));
    CHECK(place(*back).error().place.option == name(setting));
  };
  for (const double number : {5e-324, std::nextafter(min_weight, 0), 1e101, 1.797e308}) {
    INFO(number);
    check([&](Settings& s) { s.weight = number; }, Setting::weight);
    check([&](Shown& s) { s.capacity = number; }, Setting::capacity);
  }
  for (const double number : {std::nextafter(max_length, 1e10), 1e300}) {
    INFO(number);
    check([&](Settings& s) { s.apart = number; }, Setting::apart);
    check([&](Shown& s) { s.com_radius = number; }, Setting::com_radius);
  }
}

TEST_CASE("nothing overflows at the ends of the ranges", "[settings]") {
  for (const double weight : {min_weight, max_weight})
    for (const double scale : {1e-9, 1e9})
      for (const double length : {5e-324, 1.0, max_length})
        for (const Method method : all_methods) {
          INFO(name(method) << ", weight " << weight << ", size " << scale << ", " << length);
          Document document;
          document.vertices = {{0, 0}, {scale, 0}, {scale, scale}, {0.25 * scale, 0.75 * scale}};
          Settings& settings = document.settings;
          settings.method = method;
          settings.robots = 3;
          settings.weight = weight;
          document.shown.capacity = weight == min_weight ? max_weight : min_weight;
          document.shown.com_radius = length;
          settings.apart = length;
          settings.clear = length;
          const bool sized = selects_candidates(method) || method == Method::balanced;
          for (const double size : {0.0, length}) {
            if (sized) settings.robot = {size, size, size, size, size};
            int placed = 0;
            CHECK(testing::keeps_its_word(document, placed));
          }
        }
}

TEST_CASE("whatever doubles are given, they are refused or written with finite numbers",
          "[settings][fuzz][slow]") {
  Rng rng(21);
  int placed = 0;
  for (int i = 0; i < 3500; ++i) {
    std::vector<std::uint8_t> bytes(160);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.below(256));
    testing::AnyNumbers any(bytes.data(), bytes.size());
    INFO("number " << i);
    CHECK(testing::keeps_its_word(testing::document_with(any), placed));
  }
  CHECK(placed > 150);
}
