// During drags of large objects a worker, here the tests, chooses teams (derive/derive.h).
#include <limits>

#include "derive/derive.h"
#include "evenlift/generate.h"
#include "evenlift/output/json.h"
#include "view/view_page.h"

using namespace view_page;

namespace {

Document generated(Family family, std::size_t vertices, std::uint64_t seed) {
  Document document;
  document.vertices = *generate(family, vertices, seed);
  return document;
}

// The choice, or nothing for a refused document.
std::vector<double> answer(const ChooseElsewhere& task) {
  const auto document = read_task(task.rings, task.settings);
  REQUIRE(document);
  const auto placement = place(*document);
  return placement ? choice_as_numbers(*placement) : std::vector<double>{};
}

std::string result(const Placement& placement) { return placement_json(placement, true); }

// Whether the last commands change the address and storage.
bool tells_of_a_document(const AppState& state) {
  return std::any_of(
      state.session.effects.begin(), state.session.effects.end(),
      [](const Effect& effect) { return std::holds_alternative<DocumentChanged>(effect); });
}

// With a star whose placement takes longer than a frame.
struct LargePage {
  LargePage() { begin(state, placed(generated(Family::star, 9000, 1))); }

  const Document& document() const { return state.work.document(); }
  const Placement& shown_now() const { return *state.derived().placement; }

  // Moves the first vertex like a drag, and returns the worker's task, if any.
  std::optional<ChooseElsewhere> drag(const Vec2& by) {
    return asked_by(MoveVertex{0, document().vertices[0] + by});
  }
  std::optional<ChooseElsewhere> take(std::uint64_t number,
                                      std::optional<std::vector<double>> choice) {
    return asked_by(TakeChoice{number, std::move(choice)});
  }
  std::optional<ChooseElsewhere> asked_by(Command command) {
    state.session.effects.clear();
    give(state, std::move(command));
    std::optional<ChooseElsewhere> asked;
    for (const Effect& effect : state.session.effects)
      if (const auto* task = std::get_if<ChooseElsewhere>(&effect)) {
        CHECK_FALSE(asked);
        asked = *task;
      }
    return asked;
  }

  AppState state;
};

}  // namespace

TEST_CASE("a choice that was made elsewhere gives the placement with the same bits",
          "[view][choosing]") {
  for (const Family family : {Family::star, Family::random, Family::comb})
    for (const Method method : candidate_methods)
      for (const Positions positions : {Positions::best, Positions::range}) {
        Document document = generated(family, 240, 7);
        document.settings.method = method;
        document.settings.positions = positions;
        document.settings.teams = 12;
        document.settings.weight = 480.1;
        document.settings.supports = {Vec2(1, 2)};  // of another method
        document.settings.cargo = {{Vec2(500.1, 500.3), 24.7, "motor"}};
        const Placement whole = placed(document).placement;
        const auto sent = read_task(rings_as_numbers(document), settings_as_selected(document));
        REQUIRE(sent);
        auto choice = read_choice(choice_as_numbers(*place(*sent)), document.vertices.size());
        REQUIRE(choice);
        const auto again = compute_as_chosen(document, whole, *std::move(choice));
        REQUIRE(again);
        CHECK(result(*again) == result(whole));
      }
}

TEST_CASE("documents with holes pass to the worker whole", "[view][choosing]") {
  Document document =
      view_page::document("(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n");
  document.holes = {{Vec2(20, 20), Vec2(40, 20), Vec2(30, 41.1)},
                    {Vec2(60, 20), Vec2(80, 20), Vec2(70, 40)}};
  document.centre_of_mass = Vec2(133.3, 101.7);
  const auto sent = read_task(rings_as_numbers(document), settings_as_selected(document));
  REQUIRE(sent);
  CHECK(sent->vertices == document.vertices);
  CHECK(sent->holes == document.holes);
  CHECK(sent->centre_of_mass == document.centre_of_mass);
  CHECK(sent->settings == document.settings);
}

TEST_CASE("numbers that no page or worker writes are refused", "[view][choosing]") {
  const Document document = view_page::document(l_shape);
  const std::size_t edges = document.vertices.size();
  const std::vector<double> rings = rings_as_numbers(document),
                            choice = choice_as_numbers(*place(document));
  REQUIRE(read_task(rings, ""));
  REQUIRE(read_choice(choice, edges));
  CHECK_FALSE(read_task(rings, "teams=many\n"));
  CHECK_FALSE(read_task(rings, "nothing"));
  for (std::size_t size = 0; size < rings.size(); ++size)
    CHECK_FALSE(read_task(std::span(rings).first(size), ""));
  for (std::size_t size = 0; size < choice.size(); ++size)
    CHECK_FALSE(read_choice(std::span(choice).first(size), edges));
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < choice.size(); ++i)
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinity}) {
      std::vector<double> changed = choice;
      changed[i] = wrong;
      CHECK_FALSE(read_choice(changed, edges));
    }
  // Invalid edges, kinds, numbers and indices.
  for (const std::size_t i : {0u, 1u, 4u, 7u, 11u})
    for (const double wrong : {-1.0, 0.5, 1e9}) {
      std::vector<double> changed = choice;
      changed[i] = wrong;
      CHECK_FALSE(read_choice(changed, edges));
    }
  std::vector<double> changed = choice;
  changed.back() = changed.front();  // one more than the last candidate
  CHECK_FALSE(read_choice(changed, edges));
  changed = choice;
  changed.push_back(0);
  CHECK_FALSE(read_choice(changed, edges));
}

TEST_CASE("a drag of a large object places nothing itself, and skips what is overtaken",
          "[view][choosing]") {
  LargePage page;
  const std::string before = result(page.shown_now());
  const std::uint64_t placements = computed().placements;
  const auto first = page.drag({0.01, 0});
  REQUIRE(first);
  CHECK(lags(page.state));
  CHECK(computed().placements == placements);
  CHECK(result(page.shown_now()) == before);
  const Document overtaken = page.document();
  CHECK_FALSE(page.drag({0.01, 0}));
  CHECK_FALSE(page.drag({0.01, 0}));
  CHECK(computed().placements == placements);

  // The answer appears, and the worker gets the newest document.
  const auto second = page.take(first->number, answer(*first));
  REQUIRE(second);
  CHECK(result(page.shown_now()) == result(placed(overtaken).placement));
  CHECK(read_task(second->rings, second->settings)->vertices == page.document().vertices);
  CHECK(lags(page.state));

  // Then nothing is left to ask, and the drag's end places nothing.
  CHECK_FALSE(page.take(second->number, answer(*second)));
  CHECK_FALSE(lags(page.state));
  CHECK_FALSE(tells_of_a_document(page.state));
  const std::string newest = result(placed(page.document()).placement);
  CHECK(result(page.shown_now()) == newest);
  const std::uint64_t at_end = computed().placements;
  CHECK_FALSE(page.asked_by(EndEdit{}));
  CHECK(computed().placements == at_end);
  CHECK(tells_of_a_document(page.state));
  CHECK(result(page.shown_now()) == newest);
}

TEST_CASE("a drag that ends before the worker's answer places its document at once",
          "[view][choosing]") {
  LargePage page;
  const auto task = page.drag({0.02, 0});
  REQUIRE(task);
  CHECK_FALSE(page.asked_by(EndEdit{}));
  CHECK_FALSE(lags(page.state));
  const std::string newest = result(placed(page.document()).placement);
  CHECK(result(page.shown_now()) == newest);
  // The late answer changes nothing, even during another drag.
  CHECK_FALSE(page.take(task->number, answer(*task)));
  CHECK(result(page.shown_now()) == newest);
  const auto next = page.drag({0.02, 0});
  REQUIRE(next);
  CHECK_FALSE(page.take(task->number, answer(*task)));
  CHECK(lags(page.state));
  CHECK(result(page.shown_now()) == newest);
}

TEST_CASE("a large object that is dragged into a wrong shape is refused with the reason",
          "[view][choosing]") {
  LargePage page;
  const Vec2 far = page.document().vertices[4000] - page.document().vertices[0];
  const auto task = page.drag(far * 2);
  REQUIRE(task);
  CHECK_FALSE(page.take(task->number, answer(*task)));
  REQUIRE(page.state.derived().refusal);
  CHECK(page.state.derived().refusal->message == place(page.document()).error().message);
  // Back again, the worker is asked again.
  const auto back = page.drag(far * -2);
  REQUIRE(back);
  CHECK_FALSE(page.take(back->number, answer(*back)));
  CHECK_FALSE(page.state.derived().refusal);
}

TEST_CASE("what builds on the robots during a drag builds on those of the present shape",
          "[view][choosing]") {
  LargePage page;
  const auto vertices_after = [&](Command command) {
    const auto task = page.drag({0.01, 0});
    REQUIRE(task);
    const Points dragged = page.document().vertices;
    give(page.state, std::move(command));
    give(page.state, EndEdit{});
    CHECK(page.document().vertices == dragged);
    CHECK(page.state.derived().placed.vertices == dragged);
    CHECK(page.shown_now().vertices() == dragged);
    CHECK_FALSE(lags(page.state));
  };
  const Vec2 robot = page.shown_now().teams[0].robots[0].point.position;
  vertices_after(MoveRobot{0, robot + Vec2(3, 3)});
  CHECK(result(page.shown_now()) == result(placed(page.document()).placement));
  vertices_after(SetMethod{Method::given});
  CHECK(page.shown_now().settings.method == Method::given);
}

TEST_CASE("a few teams are swapped for a hold even while a large object is dragged",
          "[view][choosing]") {
  Document document = generated(Family::star, 6000, 1);
  document.settings.goal = Goal::hold;
  document.settings.teams = 2;
  AppState state;
  begin(state, placed(document));
  state.session.effects.clear();
  give(state, MoveVertex{0, document.vertices[0] + Vec2(0.01, 0)});
  CHECK_FALSE(lags(state));
  CHECK(state.derived().placement->search_ended);
}

TEST_CASE("without a worker, a drag places each document itself", "[view][choosing]") {
  LargePage page;
  const auto task = page.drag({0.01, 0});
  REQUIRE(task);
  CHECK_FALSE(page.take(task->number, std::nullopt));
  CHECK_FALSE(lags(page.state));
  CHECK(result(page.shown_now()) == result(placed(page.document()).placement));
  CHECK_FALSE(page.drag({0.01, 0}));
  CHECK(result(page.shown_now()) == result(placed(page.document()).placement));
}

TEST_CASE("small objects, robots with a size and comparisons need no worker", "[view][choosing]") {
  const Document large = generated(Family::star, 9000, 1);
  const Placement shown = placed(large).placement;
  CHECK(is_for_a_worker(large, shown));
  const Document small = generated(Family::star, 200, 1);
  CHECK_FALSE(is_for_a_worker(small, placed(small).placement));
  Document other = large;
  other.settings.method = Method::distributed;
  CHECK_FALSE(is_for_a_worker(other, shown));
  other = large;
  other.settings.robot.radius = 1;
  CHECK_FALSE(is_for_a_worker(other, shown));
  other = large;
  other.vertices.pop_back();
  CHECK_FALSE(is_for_a_worker(other, shown));
}
