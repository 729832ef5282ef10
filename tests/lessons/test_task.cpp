#include <cmath>
#include <set>

#include "evenlift/link.h"
#include "evenlift/placement.h"
#include "evenlift/supports.h"
#include "evenlift/task.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/data_table.h"
#include "kit/lessons.h"
#include "kit/placed.h"

using namespace evenlift;
using testing::lesson_of, testing::placed, testing::ready_made, testing::refused;

namespace {

const std::string heading = "title: T\npolygon: square\n";
const std::string asked = "require: max<=30, robots<=4\nmove: robots\n";

Exercise begun(const Lesson& lesson, std::uint64_t number = 1) {
  const Result<Exercise> made = exercise(lesson, testing::sample_of(lesson), number);
  INFO((made ? "" : made.error().message));
  REQUIRE(made.ok());
  return *made;
}

Attempt attempt(const Lesson& lesson, const Exercise& exercise, const Document& document) {
  const Placement placement = placed(document);
  return check_task(*lesson.task, exercise, document, {placement, document.shown});
}

Attempt attempt(const Lesson& lesson, const Document& document) {
  return attempt(lesson, begun(lesson), document);
}

Document with_supports(Document document, const Points& supports) {
  document.settings.method = Method::given;
  document.settings.supports = supports;
  return document;
}

}  // namespace

TEST_CASE("a task is read with its conditions and with what may be moved", "[task]") {
  const Lesson lesson =
      lesson_of(heading + "require: max<=30 , held\nmove: teams,robots\nplace: 5\n" +
                "[task]\nOne\nline.\n\nMore.\n[question]\nQ\n[answer]\nA\n");
  CHECK(lesson.steps.empty());
  REQUIRE(lesson.task);
  CHECK(lesson.task->words == "One line.\nMore.");
  CHECK(lesson.task->conditions.size() == 2);
  CHECK(lesson.task->may == std::vector<Movable>{Movable::robots, Movable::teams});
  CHECK(lesson.task->place == 5);
  CHECK_FALSE(lesson.task->find_centre);
  CHECK(movable_in_words(*lesson.task) == "Only the robots and the teams may be changed.");
  // It may follow steps.
  CHECK(lesson_of(heading + asked + "[end]\nWords.\n[task]\nT.\n").steps.size() == 1);
}

TEST_CASE("a polygon of a lesson may be generated from the learner's number", "[task]") {
  const auto generated = [](const std::string& words) {
    return lesson_of("title: T\ngenerate: " + words + "\n" + asked + "[task]\nT.\n");
  };
  const Lesson own = generated("star n=9 seed={number}");
  CHECK(is_numbered(own));
  CHECK(begun(own, 5).start.vertices == *generate(Family::star, 9, 5));
  CHECK(begun(own, 6).start.vertices != begun(own, 5).start.vertices);
  CHECK(begun(own, max_learner).start.vertices.size() == 9);
  const Lesson same = generated("convex seed=7");
  CHECK_FALSE(is_numbered(same));
  CHECK(begun(same, 5).start.vertices == *generate(Family::convex, 12, 7));
}

TEST_CASE("a wrong task is refused with its line", "[task]") {
  const std::string task = "[task]\nT.\n";
  refused(heading + task, 3, "no conditions");
  refused(heading + "require: held\n" + task, 4, "what may be moved");
  refused(heading + asked + "[task]\n", 5, "has no text");
  refused(heading + asked + "[end]\nWords.\n", 3, "write it below [task]");
  refused(heading + asked + task + task, 7, "at most one task");
  refused(heading + asked + task + "[end]\nWords.\n", 7, "after the task");
  refused(heading + asked + "[end]\nW.\n[question]\nQ\n[answer]\nA\n" + task, 11,
          "before the question");
  refused(heading + "require: weight<=3\n", 3, "a condition must be");
  refused(heading + "move: cargo, sofa\n", 3, "robots, teams, centre, vertices and cargo");
  refused(heading + "place: 0\n", 3, "from 1 to 64");
  refused(heading + "place: 65\n", 3, "from 1 to 64");
  refused(heading + "find: weight\n", 3, "find: centre");
  refused(heading + asked + "[task]\n" + std::string(301, 'a') + "\n", 5, "longer than 300 bytes");
  for (const char* wrong : {"blob n=9", "star 9", "star n=x", "star n=9 seed=-1", "star m=9",
                            "star n=99999999", "star seed={other}"})
    refused("title: T\ngenerate: " + std::string(wrong) + "\n", 2, "expected a family");
  refused(heading + "generate: star\n" + asked + task, 7, "give only one");
}

TEST_CASE("an exercise that cannot be made says why", "[task]") {
  const auto why = [](const std::string& text) {
    const Lesson lesson = lesson_of(text);
    const Result<Exercise> made = exercise(lesson, corpus::polygon("square"));
    REQUIRE_FALSE(made.ok());
    CHECK(testing::is_one_sentence(made.error().message));
    return made.error().message;
  };
  const std::string find = "find: centre\nmove: centre\n", task = "[task]\nT.\n";
  CHECK(why(heading + find + task).find("three or more supports") != std::string::npos);
  CHECK(why(heading + find + "supports: 10,10 20,20 30,30\n" + task).find("in a line") !=
        std::string::npos);
  CHECK(why(heading + find + "supports: 10,10 20,10 10,20\ncom: 90,90\n" + task).find("falls") !=
        std::string::npos);
  CHECK(why("title: T\ngenerate: comb n=5\n" + asked + task).find("vertices") != std::string::npos);
}

TEST_CASE("no ready-made task is done at its start, and each says what is to be reached",
          "[task]") {
  for (const char* name : {"place-yourself", "task-thirty", "task-motor", "task-where-is-c",
                           "task-beat-balanced", "task-closed", "task-steady"}) {
    INFO(name);
    const Lesson lesson = ready_made(name);
    REQUIRE(lesson.task);
    for (const std::uint64_t number : {1u, 2u, 3u, 4711u}) {
      const Exercise exercise = begun(lesson, number);
      const Attempt at_start = attempt(lesson, exercise, exercise.start);
      CHECK_FALSE(at_start.kept);
      CHECK(at_start.changed.empty());
      REQUIRE_FALSE(at_start.goals.empty());
      for (const Goalpost& goal : at_start.goals) CHECK_FALSE(goal.words.empty());
      // The start's link holds the start.
      CHECK(attempt(lesson, exercise, *decode_link(*encode_link(exercise.start))).changed.empty());
    }
  }
}

TEST_CASE("each ready-made task can be done", "[task]") {
  {
    const Lesson lesson = ready_made("place-yourself");
    CHECK(attempt(lesson, with_supports(begun(lesson).start,
                                        {{200, 200}, {800, 150}, {850, 600}, {200, 600}}))
              .kept);
  }
  {
    const Lesson lesson = ready_made("task-motor");
    Document document = begun(lesson).start;
    document.settings.cargo[0].at = Vec2(381.4, 389.6);
    CHECK(attempt(lesson, document).kept);
  }
  {
    const Lesson lesson = ready_made("task-beat-balanced");
    Document document = begun(lesson).start;
    document.settings.min_ratio = 0.6;
    CHECK(attempt(lesson, document).kept);
    Document balanced = document;
    balanced.settings.method = Method::balanced;
    const Placement six = placed(balanced);
    CHECK(count_robots(six.teams) == 6);
    CHECK(std::fabs(six.coverage - 0.72) < 0.005);
    CHECK(attempt(lesson, balanced).changed == std::vector<std::string>{"the method"});
  }
  {
    const Lesson lesson = ready_made("task-steady");
    Document document = begun(lesson).start;
    const Vec2 centre = placed(document).centre_of_mass;
    Points five;
    for (const Vec2& to :
         {Vec2(300, 0), Vec2(93, 285), Vec2(-243, 176), Vec2(-243, -176), Vec2(93, -285)})
      five.push_back(centre + to);
    CHECK(attempt(lesson, with_supports(document, five)).kept);
  }
  for (const std::uint64_t number : {1u, 2u, 3u}) {
    INFO(number);
    // Balanced robots on the same object show that four are enough.
    for (const char* name : {"task-thirty", "task-closed"}) {
      const Lesson lesson = ready_made(name);
      const Exercise exercise = begun(lesson, number);
      Document balanced = exercise.start;
      balanced.settings.method = Method::balanced;
      balanced.settings.robots = 4;
      balanced.settings.goal = Goal::hold;
      Points four;
      for (const PlacedRobot& robot : placed_robots(placed(balanced))) four.push_back(robot.at);
      CHECK(attempt(lesson, exercise, with_supports(exercise.start, four)).kept);
    }
  }
}

TEST_CASE("C is found where the robots carry what the scales show", "[task]") {
  const Lesson lesson = ready_made("task-where-is-c");
  std::set<double> first_readings;
  for (std::uint64_t number = 1; number <= 50; ++number) {
    const Exercise exercise = begun(lesson, number);
    CHECK_FALSE(exercise.start.centre_of_mass);
    REQUIRE(exercise.readings.size() == 3);
    first_readings.insert(exercise.readings[0]);
    double total = 0;
    Vec2 moment;
    for (std::size_t i = 0; i < 3; ++i) {
      total += exercise.readings[i];
      moment += exercise.readings[i] * exercise.start.settings.supports[i];
    }
    CHECK(total == Approx(480));
    Document document = exercise.start;
    const Vec2 centre = moment / total;
    document.centre_of_mass = centre;
    const Attempt right = attempt(lesson, exercise, document);
    CHECK(right.kept);
    CHECK(right.goals[0].words.find("Robot 1 should carry ") == 0);
    // Within 1 % of the weight, however little a robot carries.
    const Points& at = exercise.start.settings.supports;
    const double across = cross(at[1] - at[0], at[2] - at[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 side = at[(k + 2) % 3] - at[(k + 1) % 3],
                 away(Vec2(-side.y, side.x) / dot(side, side) * across);
      for (const double part : {0.009, 0.011}) {
        document.centre_of_mass = centre + part * away;
        CHECK(attempt(lesson, exercise, document).goals[k].kept == (part < 0.01));
      }
    }
    document.centre_of_mass = Vec2(centre + Vec2(40, 0));
    CHECK_FALSE(attempt(lesson, exercise, document).kept);
  }
  CHECK(first_readings.size() == 50);
}

TEST_CASE("only what a task allows may be changed", "[task]") {
  const auto changed = [](const std::string& may, auto change) {
    const Lesson lesson =
        lesson_of(heading + "teams: 2\nrequire: held\nmove: " + may + "\n[task]\nT.\n");
    const Exercise exercise = begun(lesson);
    Document document = exercise.start;
    change(document);
    return attempt(lesson, exercise, document).changed;
  };
  using Names = std::vector<std::string>;
  const auto move_vertex = [](Document& d) { d.vertices[0] -= Vec2(1, 1); };
  const auto move_centre = [](Document& d) { d.centre_of_mass = Vec2(400, 400); };
  const auto add_cargo = [](Document& d) { d.settings.cargo = {{Vec2(400, 400), 5, "box"}}; };
  const auto more_teams = [](Document& d) { d.settings.teams = 3; };
  const auto other_weight = [](Document& d) { d.settings.weight = 50; };
  const auto cut_hole = [](Document& d) { d.holes = {{{400, 400}, {450, 400}, {450, 450}}}; };
  const auto stand = [](Document& d) {
    d = with_supports(d, {{400, 400}, {600, 400}, {500, 600}});
  };
  const auto balanced = [](Document& d) { d.settings.method = Method::balanced; };
  const auto look = [](Document& d) {
    d.shown.overlays.tipping = true;
    d.shown.units = {LengthUnit::mm, WeightUnit::t};
    d.shown.step = 3;
  };
  CHECK(changed("robots", move_vertex) == Names{"the outline"});
  const auto replace = [](Document& d) { d = corpus::polygon("guitar"); };
  CHECK(changed("robots", replace) ==
        Names{"the whole object, as if it were of another lesson or number"});
  CHECK(changed("vertices", move_vertex).empty());
  CHECK(changed("robots", cut_hole) == Names{"the holes"});
  CHECK(changed("teams", move_centre) == Names{"the centre of mass"});
  CHECK(changed("centre", move_centre).empty());
  CHECK(changed("centre", add_cargo) == Names{"the cargo"});
  CHECK(changed("cargo", add_cargo).empty());
  CHECK(changed("robots", more_teams) == Names{"the number of teams"});
  CHECK(changed("teams", more_teams).empty());
  CHECK(changed("teams", other_weight) == Names{"the weight"});
  CHECK(changed("robots", stand).empty());
  CHECK(changed("teams", stand).size() == 2);
  const auto move_robot = [](Document& d) { d.moved.teams = {{0, {0, 0.4}, 2}}; };
  CHECK(changed("robots\npositions: range", move_robot).empty());
  CHECK(changed("teams\npositions: range", move_robot).empty());
  CHECK(changed("centre\npositions: range", move_robot) == Names{"where robots stand"});
  CHECK(changed("teams", balanced) == Names{"the method"});
  CHECK(changed("robots", look).empty());
}

TEST_CASE("robots to be placed stand beneath every sample", "[task][supports]") {
  for (const std::string& name : corpus::polygon_names()) {
    const Document document = corpus::polygon(name);
    const Result<Placement> placement = place(document);
    if (!placement) continue;
    for (const std::size_t robots : {1u, 3u, 4u, 9u, 64u}) {
      const Points supports =
          supports_to_place(placement->object, placement->centre_of_mass, robots, {});
      CHECK(supports.size() == robots);
      const SupportPlacer placer(placement->object, {});
      for (const Vec2& support : supports) CHECK(placer.place(support));
    }
  }
}
