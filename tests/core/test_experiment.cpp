// One polygon's measures against place(), and their text.
#include "evenlift/experiment/measure.h"

#include "evenlift/closure.h"
#include "evenlift/experiment/aggregates.h"
#include "evenlift/experiment/outputs.h"
#include "evenlift/experiment/results.h"
#include "evenlift/experiment/shard_list.h"
#include "evenlift/placement.h"
#include "evenlift/report.h"
#include "evenlift/selection.h"
#include "experiment/measure/csv.h"
#include "kit/corpus.h"
#include "kit/placed.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

const std::vector<std::string> some = {"thesis-sample",  "thesis-sample-centroid",
                                       "square",         "star",
                                       "letter-e-moved", "comb",
                                       "horseshoe",      "gear"};

experiment::Subject subject_of(const Document& document, double min_ratio = 0.8) {
  Result<experiment::Subject> subject = experiment::prepare(document, {.min_ratio = min_ratio});
  REQUIRE(subject.ok());
  return *std::move(subject);
}

experiment::Part some_part() {
  experiment::Part part;
  part.settings = {0.75, 3, 50, 6, 480};
  part.settings.failures = true;
  const Document document = corpus::polygon("thesis-sample-centroid");
  part.fingerprint = experiment::fingerprint(document, part.settings);
  const experiment::Subject subject = subject_of(document, part.settings.min_ratio);
  part.result = experiment::result_of("a set", "a name, with \"quotes\"\nand two lines", subject);
  for (const Method method : all_methods)
    for (const experiment::Measurement& m : experiment::measure(subject, method, part.settings))
      part.result.measurements.push_back(m);
  part.times = {{"candidates", 0.1}, {"area", 1e-7}};
  return part;
}

}  // namespace

TEST_CASE("every measure is the one that place reports", "[experiment][slow]") {
  int compared = 0;
  for (const std::string& name : some) {
    INFO(name);
    const Document document = corpus::polygon(name);
    const experiment::Subject subject = subject_of(document);
    for (const Method method :
         {Method::area, Method::circle, Method::distance, Method::distributed}) {
      const std::vector<experiment::Measurement> rows = experiment::measure(subject, method, {});
      CHECK(rows.size() == subject.candidates.size());
      // All small numbers and some others, because each takes a new placement.
      for (std::uint32_t teams = 1; teams <= rows.size(); teams += teams < 12 ? 1 : 17) {
        INFO(evenlift::name(method) << ", " << teams << " teams");
        const experiment::Measurement& m = rows[teams - 1];
        const Placement p = placed(document, method, teams);
        CHECK(m.method == method);
        CHECK(m.robots == 2 * teams);
        CHECK(m.samples == 1);
        CHECK(m.coverage == p.coverage);
        CHECK(m.load_min == p.loads->min);
        CHECK(m.load_mean == p.loads->mean);
        CHECK(m.load_max == p.loads->max);
        CHECK(m.spread == p.loads->spread);
        CHECK(m.max_share == p.loads->max_share);
        CHECK((m.form_closure == 1) == p.closure.form_closure);
        CHECK((m.no_area == 1) ==
              !(p.closure.clockwise.has_area || p.closure.counterclockwise.has_area));
        const bool selected = method != Method::distributed;
        REQUIRE(m.chosen.has_value() == selected);
        if (selected) CHECK(*m.chosen == p.team_candidates.back());
        ++compared;
      }
    }
  }
  CHECK(compared > 100);
}

TEST_CASE("balanced robots are measured with every number of them, as place finds them",
          "[experiment][balanced][slow]") {
  for (const char* name : {"thesis-sample", "square", "star-moved", "letter-e-moved"}) {
    INFO(name);
    Document document = corpus::polygon(name);
    document.settings.method = Method::balanced;
    document.settings.weight = 480;
    const experiment::ExperimentSettings settings{.most_balanced = 7, .weight = 480};
    std::uint32_t number = 2;
    for (const experiment::Measurement& m :
         experiment::measure(subject_of(document), Method::balanced, settings)) {
      INFO(number << " robots");
      document.settings.robots = number;
      const Result<Placement> p = place(document);
      REQUIRE(p.ok());
      CHECK(m.method == Method::balanced);
      CHECK(m.robots == number++);
      CHECK(m.samples == 1);
      CHECK(m.coverage == p->coverage);
      CHECK(m.load_min == p->loads->min);
      CHECK(m.load_mean == p->loads->mean);
      CHECK(m.load_max == p->loads->max);
      CHECK(m.spread == 0);
      CHECK((m.form_closure == 1) == p->closure.form_closure);
      CHECK((m.no_area == 1) ==
            !(p->closure.clockwise.has_area || p->closure.counterclockwise.has_area));
      CHECK(m.max_share == 0.5);
      CHECK_FALSE(m.chosen.has_value());
      CHECK(experiment::teams_of(m.method, m.robots) == 1);
    }
    CHECK(number == 8);
  }
}

TEST_CASE("robots with a size, cargo and failures are measured as place and its report tell them",
          "[experiment][slow]") {
  experiment::ExperimentSettings settings{
      .most_teams = 5, .most_balanced = 5, .weight = {}, .failures = true};
  for (const double radius : {0.0, 12.0}) {
    settings.robot.radius = radius;
    for (const char* name : {"thesis-sample", "comb"}) {
      INFO(name << ", " << radius);
      Document document = corpus::polygon(name);
      document.settings.weight = 70;
      document.settings.robot.radius = radius;
      const Box box = bounding_box(document.vertices);
      document.settings.cargo = {{box.middle(), 30, ""}};
      const Result<experiment::Subject> subject = experiment::prepare(document, settings);
      REQUIRE(subject.ok());
      for (const Method method : all_methods) {
        const auto rows = experiment::measure(*subject, method, settings);
        const bool is_of_points = method == Method::distributed || method == Method::random;
        CHECK(rows.empty() == (is_of_points && radius > 0));
        if (method == Method::random) continue;
        for (const experiment::Measurement& m : rows) {
          INFO(evenlift::name(method) << ", " << m.robots);
          document.settings.method = method;
          document.settings.teams = m.robots / 2;
          document.settings.robots = m.robots;
          const Result<Placement> p = place(document);
          REQUIRE(p.ok());
          CHECK(count_robots(p->teams) == m.robots);
          CHECK(m.coverage == p->coverage);
          CHECK(m.load_max == p->loads->max);
          CHECK((m.form_closure == 1) == p->closure.form_closure);
          const Report report = report_of({*p, {}}, {.failures = true});
          CHECK((*m.steady == 1) == (report.robustness.failures_clear >= 1));
          std::optional<double> greatest = 0;
          for (const auto& rest : report.failures)
            greatest = rest && greatest
                           ? std::optional(std::max(*greatest, rest->greatest_by_springs))
                           : std::nullopt;
          CHECK(m.after_failure == greatest);
        }
      }
    }
  }
}

TEST_CASE("averages count the loads of each polygon as those of the thesis's object",
          "[experiment]") {
  const auto averages = [](double weight) {
    const Document document = corpus::polygon("thesis-sample");
    const experiment::ExperimentSettings settings{
        .samples = 2, .most_balanced = 2, .weight = weight};
    const auto subject = experiment::prepare(document, settings);
    experiment::PolygonResult result = experiment::result_of("set", "one", *subject);
    result.measurements = experiment::measure(*subject, Method::area, settings);
    return experiment::make_outputs({{"set", {result}}});
  };
  const experiment::Outputs usual = averages(100), heavy = averages(800);
  CHECK(usual.measurements_csv != heavy.measurements_csv);
  CHECK(experiment::few_robots_markdown(usual.few_robots) ==
        experiment::few_robots_markdown(heavy.few_robots));
  CHECK(experiment::claims_markdown(usual.claims) == experiment::claims_markdown(heavy.claims));
}

TEST_CASE("balanced robots are measured where no team of two can be placed",
          "[experiment][balanced][slow]") {
  const Document document = corpus::polygon("letter-e-moved");
  const experiment::Subject subject = [&] {
    experiment::Subject without = subject_of(document);
    without.candidates.clear();
    return without;
  }();
  for (const Method method : pair_methods) CHECK(experiment::measure(subject, method, {}).empty());
  CHECK(experiment::measure(subject, Method::balanced, {.most_balanced = 6}) ==
        experiment::measure(subject_of(document), Method::balanced, {.most_balanced = 6}));
}

TEST_CASE("random measures are averages over the seeds 1, 2, ...", "[experiment][slow]") {
  for (const std::string& name : some) {
    INFO(name);
    const Document document = corpus::polygon(name);
    const std::vector<experiment::Measurement> rows =
        experiment::measure(subject_of(document), Method::random, {.samples = 3});
    for (std::uint32_t teams = 1; teams <= rows.size(); teams += teams < 8 ? 1 : 23) {
      INFO(teams << " teams");
      double coverage = 0, spread = 0, share = 0, closed = 0;
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Placement p = placed(document, Method::random, teams, seed);
        coverage += p.coverage;
        spread += p.loads->spread;
        share += p.loads->max_share;
        closed += p.closure.form_closure;
      }
      const experiment::Measurement& m = rows[teams - 1];
      CHECK(m.robots == 2 * teams);
      CHECK(m.samples == 3);
      CHECK(m.coverage == coverage / 3);
      CHECK(m.spread == spread / 3);
      CHECK(m.max_share == share / 3);
      CHECK(m.form_closure == closed / 3);
      CHECK_FALSE(m.chosen.has_value());
    }
  }
}

TEST_CASE("closure alone is decided as with all that is said of it",
          "[experiment][closure][slow]") {
  std::size_t closed = 0, no_area_only = 0, open = 0;
  for (const std::string& name : some) {
    const Document document = corpus::polygon(name);
    const experiment::Subject subject = subject_of(document);
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const std::vector<LiftingPoint> points = lifting_points(
          placed(document, Method::random, static_cast<std::uint32_t>(1 + seed % 5), seed).teams);
      const Closure all = analyse_closure(subject.object, subject.centre, points);
      const bool no_area = !all.clockwise.has_area && !all.counterclockwise.has_area;
      CHECK(in_form_closure(subject.object, subject.centre, points) == all.form_closure);
      CHECK(no_region_has_area(subject.object, subject.centre, points) == no_area);
      ++(all.form_closure ? closed : no_area ? no_area_only : open);
    }
  }
  CHECK(closed > 20);
  CHECK(open > 20);
  // The thesis's test accepts a square held on two sides, which can slide.
  const Document square = corpus::polygon("square");
  const experiment::Subject subject = subject_of(square);
  const Chord level = placed(square, Method::area, 1).candidates[1].chord;
  const std::vector<LiftingPoint> points{level.r1, level.r2};
  CHECK(no_region_has_area(subject.object, subject.centre, points));
  CHECK_FALSE(in_form_closure(subject.object, subject.centre, points));
}

TEST_CASE("a limit on teams measures the same, only less", "[experiment][slow]") {
  const experiment::Subject subject = subject_of(corpus::polygon("comb"));
  for (const Method method : pair_methods) {
    const std::vector<experiment::Measurement> all = experiment::measure(subject, method,
                                                                         {.samples = 2}),
                                               few = experiment::measure(
                                                   subject, method,
                                                   {.samples = 2, .most_teams = 4});
    REQUIRE(few.size() == 4);
    CHECK(few == std::vector<experiment::Measurement>(all.begin(), all.begin() + 4));
  }
}

TEST_CASE("a polygon of any size has the same measures, bit for bit", "[experiment]") {
  const Document document = corpus::polygon("star-moved");
  Document tiny = document;
  const double scale = 0x1p-38;
  for (Vec2& v : tiny.vertices) v *= scale;
  *tiny.centre_of_mass *= scale;
  for (const Method method : pair_methods)
    CHECK(experiment::measure(subject_of(tiny), method, {.samples = 2}) ==
          experiment::measure(subject_of(document), method, {.samples = 2}));
}

TEST_CASE("what is not a polygon is refused as place does", "[experiment]") {
  Document document;
  document.vertices = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  document.centre_of_mass = Vec2(5, 5);
  const Result<experiment::Subject> subject = experiment::prepare(document, {});
  REQUIRE_FALSE(subject.ok());
  CHECK(subject.error().message == place(document).error().message);
  CHECK(experiment::check_settings(experiment::ExperimentSettings{}) == std::nullopt);
  CHECK(
      experiment::check_settings(experiment::ExperimentSettings{.min_ratio = 1.1})->place.option ==
      "min_ratio");
  CHECK(experiment::check_settings(experiment::ExperimentSettings{.samples = 0})->place.option ==
        "samples");
  CHECK(experiment::check_settings(experiment::ExperimentSettings{.most_teams = 0})->place.option ==
        "max_teams");
  for (const std::uint32_t most : {least_robots - 1, most_robots + 1})
    CHECK(experiment::check_settings(experiment::ExperimentSettings{.most_balanced = most})
              ->place.option == "max_balanced");
  CHECK(experiment::check_settings(experiment::ExperimentSettings{.weight = 0})->place.option ==
        "weight");
}

TEST_CASE("a part reads back exactly, and only whole", "[experiment][slow]") {
  const experiment::Part part = some_part();
  const std::string text = experiment::write_part(part);
  REQUIRE(experiment::read_part(text).has_value());
  CHECK(*experiment::read_part(text) == part);
  for (std::size_t length = 0; length < text.size(); ++length)
    if (experiment::read_part(text.substr(0, length))) FAIL("cut off after " << length << " bytes");
  CHECK_FALSE(experiment::read_part(text + "more\n").has_value());

  experiment::Part refused;
  refused.fingerprint = experiment::refused_fingerprint;
  refused.result.polygon = "bad";
  refused.result.problem = "line 3: expected ','";
  CHECK(*experiment::read_part(experiment::write_part(refused)) == refused);

  const experiment::ShardList list{
      {2, 3},
      part.settings,
      {{"x", "a, b", "0123"}, {"y, z", "c", experiment::refused_fingerprint}}};
  const std::string listed = experiment::write_shard_list(list);
  CHECK(experiment::write_shard_list(*experiment::read_shard_list(listed)) == listed);
  for (std::size_t length = 0; length < listed.size(); ++length)
    CHECK_FALSE(experiment::read_shard_list(listed.substr(0, length)).has_value());
}

TEST_CASE("a part is read as it was written only, not in other ways to write its numbers",
          "[experiment]") {
  const experiment::Part part = some_part();
  const std::string text = experiment::write_part(part);
  REQUIRE(experiment::read_part(text).has_value());
  const std::string head = text.substr(0, text.find('\n'));
  const auto with = [&](const std::string& before, const std::string& after) {
    std::string changed = text;
    const std::size_t at = changed.find(before);
    REQUIRE(at != std::string::npos);
    return changed.replace(at, before.size(), after);
  };
  REQUIRE(head.find(",0.75,3,50,") != std::string::npos);
  for (const char* samples : {"3e0", "+3", "3.0", "03", " 3"})
    CHECK_FALSE(
        experiment::read_part(with(",3,50,", std::string(",") + samples + ",50,")).has_value());
  for (const char* most : {"5e1", "+50.0", "50 ", "0x32"})
    CHECK_FALSE(experiment::read_part(with(",3,50,", std::string(",3,") + most + ",")).has_value());
  for (const char* ratio : {"0.750", "75e-2", "+0.75", ".75"})
    CHECK_FALSE(experiment::read_part(with(",0.75,", std::string(",") + ratio + ",")).has_value());
  CHECK_FALSE(experiment::read_part(with("\nend\n", "\r\nend\n")).has_value());
}

TEST_CASE("the fingerprint tells inputs and settings apart", "[experiment]") {
  const Document document = corpus::polygon("square");
  Document moved = document;
  moved.centre_of_mass = Vec2(400, 500);
  Document longer = document;
  longer.vertices[1].x += 1e-9;
  std::vector<std::string> all = {experiment::fingerprint(document, {}),
                                  experiment::fingerprint(moved, {}),
                                  experiment::fingerprint(longer, {}),
                                  experiment::fingerprint(document, {.min_ratio = 0.7}),
                                  experiment::fingerprint(document, {.samples = 100}),
                                  experiment::fingerprint(document, {.most_teams = 5}),
                                  experiment::fingerprint(document, {.most_balanced = 5}),
                                  experiment::fingerprint(document, {.weight = 480}),
                                  experiment::fingerprint(document, {.weight = {}}),
                                  experiment::fingerprint(document, {.robot = {.radius = 1}}),
                                  experiment::fingerprint(document, {.failures = true})};
  CHECK(experiment::fingerprint(document, {}) == all[0]);
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
  Document loaded = document;
  loaded.settings.cargo = {{{500, 500}, 7, ""}};
  Document heavier = loaded;
  heavier.settings.weight = 200;
  CHECK(experiment::fingerprint(loaded, {}) != experiment::fingerprint(heavier, {}));
  CHECK(experiment::fingerprint("") == "cbf29ce484222325");  // from the test vectors of FNV-1a
  CHECK(experiment::fingerprint("foobar") == "85944171f73967e8");
}

TEST_CASE("comma-separated values read back whatever a name holds", "[experiment]") {
  const experiment::csv::Row row = {"", "a,b", "\"", "x\"\"y", "two\nlines", "\r", "end"};
  const auto rows =
      experiment::csv::read(experiment::csv::line(row) + experiment::csv::line({"1"}));
  REQUIRE(rows.has_value());
  CHECK(*rows == std::vector<experiment::csv::Row>{row, {"1"}});
  for (const char* bad : {"a", "a,b", "\"a\n", "\"a\"b\n", "\"a\"\"\n", "a,"})
    CHECK_FALSE(experiment::csv::read(bad).has_value());
}

TEST_CASE("mean and deviation of a sample", "[experiment]") {
  const experiment::Statistics s = experiment::statistics({2, 4, 4, 4, 5, 5, 7, 9});
  CHECK(s.mean == 5);
  CHECK(*s.deviation == Approx(2.13809));
  CHECK_FALSE(experiment::statistics({3}).deviation.has_value());
}
