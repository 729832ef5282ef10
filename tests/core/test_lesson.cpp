// The reader, and the ready-made lessons.
#include <algorithm>
#include <set>
#include <sstream>

#include "evenlift/lesson.h"
#include "evenlift/link.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/lessons.h"
#include "kit/placed.h"
#include "kit/traced.h"

using namespace evenlift;
using testing::lesson_of, testing::lessons_folder, testing::ready_made, testing::refused;

namespace {

const std::string good =
    "# A comment.\n"
    "title: Équal arms\r\n"
    "polygon: square-moved\n"
    "teams: max\n"
    "metric: circle\n"
    "min-ratio: 0.5\n"
    "com: 100, -20.5\n"
    "weight: 7\n"
    "seed: 18446744073709551615\n"
    "predict: yes\n"
    "\n"
    "[centre]\n"
    "Two lines\n"
    "  that are one.\n"
    "\n"
    "# Not shown.\n"
    "Another paragraph.\n"
    "\n"
    "[team 2]\nTwo.\n[vertex 3]\nThree.\n[pair 4]\nFour.\n[edges 5 6]\nFive.\n[step 7]\nSix.\n"
    "[ cut   8 ]\nSeven.\n[end]\nEight.\n"
    "[question]\nWhy\neight?\n\n[ answer ]\nThat is\n\nas many as there are.\n";

// Names and titles.
std::vector<std::pair<std::string, std::string>> index() {
  std::istringstream lines(corpus::read_file(lessons_folder() / "index.txt"));
  std::vector<std::pair<std::string, std::string>> entries;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t end = line.find(' ');
    REQUIRE(end != std::string::npos);
    entries.emplace_back(line.substr(0, end), line.substr(line.find_first_not_of(' ', end)));
  }
  return entries;
}

Trace trace_of(const Lesson& lesson) {
  const Result<Document> document = lesson_document(lesson, testing::sample_of(lesson));
  REQUIRE(document.ok());
  return testing::traced(testing::placed(*document));
}

}  // namespace

TEST_CASE("a lesson is read with its settings, addresses and words", "[lesson]") {
  const Lesson lesson = lesson_of(good);
  CHECK(lesson.title == "Équal arms");
  CHECK(lesson.polygon == "square-moved");
  CHECK(lesson.link.empty());
  CHECK(lesson.settings.size() == 6);
  CHECK(lesson.predict);
  REQUIRE(lesson.steps.size() == 8);
  CHECK(lesson.steps[0].words == "Two lines that are one.\nAnother paragraph.");
  CHECK(lesson.steps[0].line == 12);
  CHECK(lesson.steps[7].words == "Eight.");
  CHECK(lesson.question == "Why eight?");
  CHECK(lesson.answer == "That is\nas many as there are.");
  const StepAddress expected[] = {at::Kind{StepKind::centre, 0},
                                  at::Kind{StepKind::team, 1},
                                  at::Vertex{2},
                                  at::Kind{StepKind::outcome, 3},
                                  at::Edges{4, 5},
                                  at::Number{6},
                                  at::Kind{StepKind::cut, 7},
                                  at::End{}};
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    CHECK((lesson.steps[i].address == expected[i]));

  Document sample = corpus::polygon("square");
  const Result<Document> document = lesson_document(lesson, sample);
  REQUIRE(document.ok());
  CHECK_FALSE(document->settings.teams);
  CHECK(document->settings.method == Method::circle);
  CHECK(document->settings.min_ratio == 0.5);
  CHECK(document->settings.weight == 7.0);
  CHECK(document->settings.seed == ~std::uint64_t{0});
  CHECK(*document->centre_of_mass == Vec2(100, -20.5));
}

TEST_CASE("each option of the program that sets something is a lesson's key, too",
          "[lesson][settings]") {
  Document document;
  document.settings.goal = Goal::hold;
  document.settings.apart = document.settings.clear = document.settings.snap =
      document.settings.accuracy = 1;
  for (const SettingRow& row : all_settings()) {
    if (row.option.group == OptionGroup::none) continue;
    const Lesson lesson = lesson_of("title: T\npolygon: square\n" + hyphened(row.name) + ": " +
                                    text_of(row.setting, document) + "\n[end]\nWords.\n");
    REQUIRE(lesson.settings.size() == 1);
    CHECK(lesson.settings[0].setting == row.setting);
  }
  const Lesson lesson = lesson_of("title: T\npolygon: square\nmethod: circle\n[end]\nWords.\n");
  REQUIRE(lesson.settings.size() == 1);
  CHECK(lesson.settings[0].setting == Setting::method);
}

TEST_CASE("a lesson's own settings go before those of its link", "[lesson]") {
  Document document = corpus::polygon("hexagon");
  document.settings.method = Method::distance;
  document.settings.teams = 2;
  const std::string link = *encode_link(document);
  const Lesson lesson = lesson_of("title: T\nlink: " + link + "\nteams: 1\n[end]\nWords.");
  const Result<Document> opened = lesson_document(lesson, {});
  REQUIRE(opened.ok());
  CHECK(opened->vertices == document.vertices);
  CHECK(opened->settings.method == Method::distance);
  CHECK(opened->settings.teams == 1u);
  CHECK_FALSE(lesson_document(lesson_of("title: T\nlink: 1.xyz\n[end]\nWords."), {}).ok());
}

TEST_CASE("what is wrong in a lesson is said with its line", "[lesson]") {
  refused("", 1, "no title");
  refused("polygon: square\n[end]\nWords.", 3, "no title");
  refused("title: T\n[end]\nWords.", 3, "neither a polygon nor a link");
  refused("title: T\npolygon: square\nlink: 1.x\n[end]\nWords.", 5, "give only one");
  refused("title: T\npolygon: square\n", 2, "has no steps");
  refused("title: T\ntitle: U\n", 2, "twice");
  refused("title:\n", 1, "no value");
  refused("title: " + std::string(101, 'x') + "\n", 1, "longer than 100");
  refused("title: T\npolygon: ../square\n", 2, "lower-case letters");
  refused(
      "title: T\npolygn: square\n", 2,
      "unknown setting; the settings are title, polygon, link, generate, predict, loads, failed, "
      "require, move, place, find, teams, metric, min-ratio, com, ");
  refused("title: T\n: 3\n", 2, "unknown setting");
  refused("title: T\nmin_ratio: 0.5\n", 2, "unknown setting");
  refused("metric: area\nmethod: circle\n", 2, "twice");
  refused("title: T\nHello\n", 2, "expected a setting");
  refused("teams: 0\n", 1, "teams");
  refused("teams: 1048577\n", 1, "teams");
  refused("teams: -1\n", 1, "teams");
  refused("metric: volume\n", 1, "area");
  refused("min-ratio: 1.01\n", 1, "0 to 1");
  refused("min-ratio: nan\n", 1, "0 to 1");
  refused("com: 1\n", 1, "X,Y");
  refused("com: 1,2,3\n", 1, "X,Y");
  refused("weight: 0\n", 1, "greater than 0");
  refused("seed: 18446744073709551616\n", 1, "whole number");
  refused("predict: maybe\n", 1, "yes or no");
  const std::string head = "title: T\npolygon: square\n";
  for (const char* address :
       {"[]", "[ ]", "[nothing]", "[team 0]", "[team -1]", "[team 1 2]", "[team x]", "[edges 1]",
        "[edges 1 2 3]", "[vertex]", "[step]", "[end 1]", "[team 99999999999]"})
    refused(head + address + "\nWords.", 3, "address of a step");
  refused(head + "[team 2\nWords.", 3, "must end in ]");
  refused(head + "[team 2]\n\n[end]\nWords.", 3, "no text");
  refused(head + "[team 2]\n", 3, "no text");
  refused(head + "[end]\n" + std::string(1001, 'x'), 3, "more than 1000");
  refused(head + "[end]\nA \xff byte.", 4, "not readable");
  refused(head + "[end]\nA \xed\xa0\x80 surrogate.", 4, "not readable");
  refused(head + "[end]\nCut \xc3", 4, "not readable");
  refused(head + "[end]\nA " + std::string(1, '\0') + " byte.", 4, "not readable");
  const std::string one = head + "[end]\nWords.\n";
  refused(head + "[question]\nWhy?\n", 3, "after the steps");
  refused(one + "[question]\n", 5, "no text");
  refused(one + "[question]\nWhy?\n", 5, "no answer");
  refused(one + "[question]\nWhy?\n[answer]\n", 7, "no text");
  refused(one + "[answer]\nSo.\n", 5, "without a question");
  refused(one + "[question]\nWhy?\n[question]\nHow?\n", 7, "one question");
  refused(one + "[question]\nWhy?\n[answer]\nSo.\n[answer]\nOr so.\n", 9, "one answer");
  refused(one + "[question]\nWhy?\n[end]\nWords.\n", 7, "after the question");
  refused(one + "[question]\nWhy?\n[answer]\nSo.\n[end]\nWords.\n", 9, "after the question");
  refused(one + "[question]\n" + std::string(301, 'x'), 5, "longer than 300");
  refused(one + "[question]\nWhy?\n[answer]\n" + std::string(601, 'x'), 7, "longer than 600");
  std::string many = head;
  for (int i = 0; i < 201; ++i) many += "[end]\nWords.\n";
  refused(many, 403, "at most 200");
  const Result<Lesson> huge = parse_lesson(std::string(max_lesson_bytes + 1, '#'));
  REQUIRE_FALSE(huge.ok());
  CHECK(huge.error().code == ErrorCode::text_too_long);
}

TEST_CASE("any bytes give a lesson or an error", "[lesson]") {
  Rng rng(1);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = good;
    const std::uint64_t changes = 1 + rng.below(4);
    for (std::uint64_t k = 0; k < changes; ++k) {
      const auto at = static_cast<std::size_t>(rng.below(text.size()));
      const auto way = rng.below(3);
      const char byte = static_cast<char>(rng.below(256));
      if (way == 0) text[at] = byte;
      if (way == 1) text.erase(at, static_cast<std::size_t>(rng.below(20)));
      if (way == 2) text.insert(at, 1, byte);
      if (text.empty()) text = "x";
    }
    const Result<Lesson> lesson = parse_lesson(text);
    accepted += lesson.ok();
    if (!lesson && !testing::is_one_sentence(lesson.error().message)) FAIL(lesson.error().message);
    if (lesson && (lesson->title.empty() || lesson->steps.empty())) FAIL(text);
  }
  CHECK(accepted > 1000);
  CHECK(accepted < 19000);
}

TEST_CASE("a step is found by its address, and a missing one named by its line", "[lesson]") {
  const Lesson lesson = lesson_of(
      "title: T\npolygon: stone-slab\n[vertex 4]\na\n[edges 3 7]\nb\n[edges 7 3]\nc\n[step "
      "2]\nd\n[team 3]\ne\n[end]\nf\n");
  const Trace trace = trace_of(lesson);
  const auto step = [&](std::size_t i) {
    const auto at = find_step(trace, lesson.steps[i].address);
    REQUIRE(at);
    return trace.step(*at);
  };
  CHECK(trace.rays.vertices[step(0).item] == 3);
  CHECK(step(1).kind == StepKind::outcome);
  CHECK(trace.pairs[step(1).item].a + trace.pairs[step(1).item].b == 8);
  CHECK(step(2) == step(1));
  CHECK(step(3).kind == StepKind::centroid);
  CHECK(step(4) == Step{StepKind::team, Chapter::further_teams, 2});
  CHECK(step(5).kind == StepKind::result);
  CHECK_FALSE(check_lesson(lesson, trace));

  for (const char* address : {"vertex 9", "edges 1 2", "step 54", "team 4", "radial", "fewer"}) {
    const auto error = check_lesson(
        lesson_of("title: T\npolygon: stone-slab\n[end]\na\n[" + std::string(address) + "]\nb\n"),
        trace);
    INFO(address);
    REQUIRE(error);
    CHECK(error->place.index == 5);
  }
  const auto told = [&](const std::string& address) {
    return check_lesson(lesson_of("title: T\npolygon: stone-slab\n[" + address + "]\nb\n"), trace)
        ->message;
  };
  const std::string with = " with this polygon and these settings";
  CHECK(told("team 4") == "there is no step [team 4]:" + with + " there are [team 1] to [team 3]");
  CHECK(told("radial") == "there is no step [radial]" + with);
  CHECK(told("vertex 99").find("there is no vertex 99: the polygon has ") == 0);
  CHECK(told("edges 1 2").find("edges 1 and 2 are not examined together") == 0);
  CHECK(told("step 54") == "there is no step 54: there are " + std::to_string(trace.size()));
}

TEST_CASE("what a lesson's own settings make impossible is told at their line", "[lesson]") {
  const Lesson lesson = lesson_of("title: T\npolygon: square\nteams: 2\ncom: 9,9\n[end]\na\n");
  const InputError of_centre{
      ErrorCode::centre_outside_hull, "it lies outside", {Place::Kind::centre_of_mass, 0, 0, {}}};
  CHECK(describe(at_line(of_centre, lesson).place) == "line 4");
  CHECK(describe(at_line(bad_setting("teams", "too many"), lesson).place) == "line 3");
  CHECK(describe(at_line(bad_setting("weight", "too much"), lesson).place) == "weight");
}

TEST_CASE("every ready-made lesson opens and has its steps", "[lesson]") {
  const auto entries = index();
  CHECK(entries.size() >= 8);
  std::set<std::string> listed{"index"};
  for (const auto& [name, title] : entries) {
    INFO(name);
    listed.insert(name);
    const Lesson lesson = ready_made(name);
    CHECK(lesson.title == title);
    CHECK((lesson.task || lesson.steps.size() >= 4));
    CHECK_FALSE(lesson.question.empty());
    const Trace trace = trace_of(lesson);
    const auto missing = check_lesson(lesson, trace);
    INFO((missing ? describe(missing->place) : ""));
    CHECK_FALSE(missing);
    // Steps are in the algorithm's order.
    std::uint32_t before = 0;
    for (const LessonStep& step : lesson.steps) {
      const std::uint32_t at = find_step(trace, step.address).value_or(0);
      INFO("line " << step.line);
      CHECK(at >= before);
      before = at;
    }
  }
  for (const auto& file : std::filesystem::directory_iterator(lessons_folder()))
    if (file.is_regular_file()) CHECK(listed.count(file.path().stem().string()) == 1);
}

// tests/words/check_lessons.py compares them with the English ones.
TEST_CASE("every lesson in another language is a lesson", "[lesson][words]") {
  for (const auto& [name, title] : index()) {
    INFO(name);
    const Lesson german = ready_made("de/" + name);
    CHECK(german.steps.size() == ready_made(name).steps.size());
    CHECK(german.title != title);
  }
}

TEST_CASE("the example in docs/lessons.md is a lesson", "[lesson]") {
  const std::string page = corpus::read_file(
      std::filesystem::path(EVENLIFT_ASSETS_DIR).parent_path() / "docs" / "lessons.md");
  const std::size_t begin = page.find("```text\n");
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find("```", begin + 8);
  const Lesson lesson = lesson_of(page.substr(begin + 8, end - begin - 8));
  const Trace trace = trace_of(lesson);
  CHECK_FALSE(check_lesson(lesson, trace));
  CHECK(lesson.steps.back().words ==
        "Lines of one paragraph are joined when they are shown, wherever you break them.\n"
        "An empty line begins a new paragraph.");
  CHECK(is_even(chord_of(trace.placement.teams[0])));
}

TEST_CASE("what the ready-made lessons claim is so", "[lesson]") {
  const auto trace = [](const char* name) { return trace_of(ready_made(name)); };
  const auto ratio_of_vertex = [](const Trace& t, std::uint32_t vertex) {
    const auto at = std::find(t.rays.vertices.begin(), t.rays.vertices.end(), vertex - 1);
    REQUIRE(at != t.rays.vertices.end());
    return t.rays.chords[t.rays.begins[static_cast<std::size_t>(at - t.rays.vertices.begin())]]
        .chord.ratio;
  };
  {
    const Trace t = trace("equal-arms");
    CHECK(t.placement.candidates.size() == 9);
    CHECK(std::count_if(t.placement.candidates.begin(), t.placement.candidates.end(),
                        [](const Candidate& c) { return is_even(c.chord); }) == 5);
    CHECK(std::fabs(t.placement.teams[1].ratio - 0.895) < 5e-4);
    CHECK(is_even(chord_of(t.placement.teams[0])));
    CHECK(t.placement.loads->spread < 2);
    const PairDetail uneven = look_at_pair(t, t.step(*find_step(t, at::Edges{9, 3})).item);
    CHECK(std::fabs(uneven.ends[0].ratio - 0.293) < 5e-4);
    CHECK(std::fabs(uneven.ends[1].ratio - 0.936) < 5e-4);
    CHECK(uneven.outcome == Outcome::nearer_end);
  }
  {
    const Trace t = trace("convex");
    CHECK(t.polygon().convex());
    CHECK(look_at_pair(t, 0).outcome == Outcome::bisecting);
    CHECK(look_at_pair(t, 5).outcome == Outcome::nearer_end);
    CHECK(std::fabs(look_at_pair(t, 5).chosen.ratio - ratio_of_vertex(t, 4)) < 1e-12);
    CHECK_FALSE(look_at_pair(t, 6).stands);
    CHECK(t.placement.candidates.size() == 7);
    CHECK(t.placement.coverage > 0.8);
    CHECK(t.placement.closure.form_closure);
  }
  {
    const Trace area = trace("metrics-area"), arms = trace("metrics-arms");
    using Teams = std::vector<std::uint32_t>;
    CHECK(area.placement.team_candidates == Teams{4, 0, 2});
    CHECK(arms.placement.team_candidates == Teams{4, 1, 6});
    CHECK(std::fabs(area.placement.coverage - 0.82) < 0.005);
    CHECK(std::fabs(arms.placement.coverage - 0.80) < 0.005);
    const TeamScores scores = look_at_scores(area, 1);
    CHECK(scores.of_candidate[scores.ranking[0]].value <
          1.01 * scores.of_candidate[scores.ranking[1]].value);
  }
  {
    const Trace t = trace("not-convex");
    const auto reflex = [&](std::size_t i) { return t.polygon().turn(i) == Turn::reflex; };
    int inwards = 0;
    for (std::size_t i = 0; i < t.polygon().size(); ++i) inwards += reflex(i);
    CHECK(inwards == 4);
    CHECK(t.contacts.size() == 4);
    CHECK(t.placement.teams.size() == 3);
  }
  {
    const Trace t = trace("outside");
    CHECK(centre_is_outside(t));
    CHECK(t.placement.candidates.size() == 3);
    CHECK(std::fabs(t.placement.coverage - 1.0 / 12) < 0.002);
  }
  {
    const Trace t = trace("moved");
    CHECK(t.placement.candidates.size() == 3);
    CHECK(std::fabs(ratio_of_vertex(t, 2) - 0.716) < 5e-4);
    CHECK(std::fabs(ratio_of_vertex(trace("convex"), 2) - 0.970) < 5e-4);
    CHECK(std::fabs(t.placement.coverage - 0.49) < 0.005);
    CHECK(look_at_pair(t, 0).outcome == Outcome::too_uneven);
    Document easier{t.placement.vertices(), t.centre, t.placement.settings};
    easier.settings.min_ratio = 0.7;
    const Result<Placement> placed = place(easier);
    REQUIRE(placed.ok());
    CHECK(placed->teams.size() == 6);
    CHECK(std::fabs(placed->coverage - 0.94) < 0.005);
    CHECK(std::fabs(placed->loads->min - 7.0) < 0.05);
    CHECK(std::fabs(placed->loads->max - 9.7) < 0.05);
    easier.settings.min_ratio = 0.8;
    easier.centre_of_mass.reset();
    CHECK(std::fabs(place(easier)->coverage - 0.94) < 0.005);
  }
  {
    const Trace t = trace("form-closure");
    CHECK(t.placement.closure.form_closure);
    const StepDetail third = look_at(t, *t.find(StepKind::cut, 2));
    const StepDetail fourth = look_at(t, *t.find(StepKind::cut, 3));
    CHECK((third.clockwise.exists && third.counterclockwise.exists));
    CHECK_FALSE((fourth.clockwise.exists || fourth.counterclockwise.exists));
    CHECK(t.contacts[0].edge == t.contacts[2].edge);
  }
  {
    const Trace t = trace("slides");
    const Closure& closure = t.placement.closure;
    CHECK_FALSE((closure.clockwise.exists || closure.counterclockwise.exists));
    CHECK(closure.translation_free);
    CHECK_FALSE(look_at(t, *t.find(StepKind::cut, 1)).counterclockwise.exists);
  }
  {
    const Trace t = trace("second-order");
    CHECK(t.placement.closure.second_order);
    CHECK(look_at(t, *t.find(StepKind::cut, 1)).clockwise.clipped.size() == 2);
    CHECK(look_at(t, *t.find(StepKind::cut, 3)).clockwise.clipped.size() == 1);
  }
}

// The answers to the questions at the lessons' ends.
TEST_CASE("what the ready-made lessons answer is so", "[lesson][slow]") {
  const auto placed = [](const char* name, auto change) {
    const Lesson lesson = ready_made(name);
    Document document = *lesson_document(lesson, testing::sample_of(lesson));
    change(document);
    const Result<Placement> placement = place(document);
    REQUIRE(placement.ok());
    return *placement;
  };
  const auto with_teams = [&](const char* name, std::uint32_t teams) {
    return placed(name, [&](Document& d) { d.settings.teams = teams; });
  };
  const auto near = [](double value, double said, double within = 0.005) {
    return std::fabs(value - said) < within;
  };
  {
    const Placement heavy = placed("opposite", [](Document& d) { d.settings.weight = 300; });
    CHECK(heavy.teams[0].robots[0].load == 150);
    const Placement light = with_teams("opposite", 1);
    CHECK(chord_of(heavy.teams[0]).r1.position == chord_of(light.teams[0]).r1.position);
    CHECK(chord_of(heavy.teams[0]).r2.position == chord_of(light.teams[0]).r2.position);
  }
  {
    const auto evens = [&](Vec2 by) {
      const Placement moved =
          placed("convex", [&](Document& d) { d.centre_of_mass = Vec2(516.6, 377.8) + by; });
      return std::count_if(moved.candidates.begin(), moved.candidates.end(),
                           [](const Candidate& c) { return is_even(c.chord); });
    };
    CHECK(evens({0, 0}) == 5);
    CHECK(evens({10, 0}) == 5);
    CHECK(evens({0, 20}) == 5);
    CHECK(evens({0, 40}) == 1);
  }
  for (const auto& [teams, area, arms] : {std::tuple{2u, 0.605, 0.600},
                                          {3u, 0.82, 0.80},
                                          {4u, 0.883, 0.880},
                                          {5u, 0.934, 0.934},
                                          {7u, 0.949, 0.949}}) {
    CHECK(near(with_teams("metrics-area", teams).coverage, area));
    CHECK(near(with_teams("metrics-arms", teams).coverage, arms));
  }
  {
    const Placement ten = with_teams("how-many", 5);
    CHECK(ten.loads->max == 10);
    CHECK(ten.loads->min == 10);
    const Placement all = with_teams("how-many", 14);
    CHECK(all.candidates.size() == 14);
    CHECK(near(all.coverage, 0.82));
    CHECK(near(with_teams("how-many", 11).coverage, 0.82));
  }
  {
    const Placement three = with_teams("not-convex", 3), four = with_teams("not-convex", 4);
    CHECK(three.closure.second_order);
    CHECK_FALSE(three.closure.form_closure);
    CHECK(four.closure.form_closure);
    CHECK(near(three.coverage, 0.90, 0.006));
    CHECK(near(four.coverage, 0.90, 0.006));
  }
  {
    const Placement lower = placed("outside", [](Document& d) { d.settings.min_ratio = 0.5; });
    CHECK(near(lower.coverage, 0.76));
    CHECK(near(lower.loads->min, 12.5, 0.05));
    CHECK(near(lower.loads->max, 20.9, 0.05));
  }
  {
    const auto moved_back = [&](double part) {
      return placed("moved", [&](Document& d) {
        d.centre_of_mass = *d.centre_of_mass + part * (Vec2(516.6, 377.8) - *d.centre_of_mass);
      });
    };
    CHECK(moved_back(0.3).teams.size() == 5);
    CHECK(near(moved_back(0.3).coverage, 0.80));
    CHECK(moved_back(0.35).teams.size() == 6);
    CHECK(near(moved_back(0.35).coverage, 0.94));
  }
  {
    const Closure one = with_teams("form-closure", 1).closure;
    CHECK((one.clockwise.exists && one.counterclockwise.exists && one.translation_free));
    CHECK(near(with_teams("form-closure", 2).closure.margin.value_or(0), 0.090, 5e-4));
    CHECK(near(with_teams("form-closure", 3).closure.margin.value_or(0), 0.289, 5e-4));
  }
  {
    for (const std::uint32_t teams : {3u, 4u})
      CHECK(with_teams("slides", teams).closure.translation_free);
    const Placement by_area = placed("slides", [](Document& d) {
      d.settings.method = Method::area;
      d.settings.teams = 4;
    });
    CHECK(by_area.closure.second_order);
    const Placement longer = placed("second-order", [](Document& d) {
      d.vertices = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    });
    CHECK(longer.closure.second_order);
    CHECK_FALSE(longer.closure.form_closure);
  }
  {
    const auto coverage = [&](std::uint32_t robots, std::uint32_t failures) {
      return placed("robot-fails",
                    [&](Document& d) {
                      d.settings.robots = robots;
                      d.settings.survive = failures;
                    })
          .coverage;
    };
    CHECK(near(coverage(5, 1), 0.73));
    CHECK(near(coverage(6, 1), 0.94));
    CHECK(near(coverage(6, 0), 0.96));
    CHECK(near(coverage(7, 0), 0.98));
  }
}
