#include <cmath>
#include <string>

#include "edits/undo.h"
#include "evenlift/output/verdict.h"
#include "evenlift/output/words.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "state/method.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

AppState state_of(const std::string& sample, Method method, std::uint32_t teams) {
  Document document = corpus::polygon(sample);
  document.settings.method = method;
  document.settings.teams = teams;
  AppState state;
  begin(state, placed(document));
  frame_view(state);
  return state;
}

Judgement judged(const AppState& state) {
  return judge({*state.derived().placement, shown(state)});
}

}  // namespace

TEST_CASE("an offer has fewer faults, gives what it says, and is one step of undo",
          "[view][offer][slow]") {
  constexpr Method methods[] = {Method::area, Method::distance, Method::random};
  std::size_t offers = 0, samples = 0;
  for (const std::string& sample : corpus::polygon_names()) {
    const Method method = methods[samples++ % std::size(methods)];
    for (const std::uint32_t teams : {1u, 2u, 3u}) {
      AppState state = state_of(sample, method, teams);
      const Judgement before = judged(state);
      const auto offer = state.derived().offer;
      if (before.kind == VerdictKind::good) CHECK_FALSE(offer);
      if (!offer) continue;
      ++offers;
      CAPTURE(sample, name(method), teams, offer->label);
      const Settings own = settings(state);
      const double covered = state.derived().placement->coverage;
      const std::size_t depth = state.work.history.depth();
      give(state, SetSettings{offer->settings});
      const Judgement after = judged(state);
      const bool lowers = offer->label.starts_with("Lower the ratio");
      if (!lowers) CHECK(after.reasons.size() < before.reasons.size());
      if (lowers) CHECK_FALSE(state.derived().placement->teams.empty());
      const Placement& placed = *state.derived().placement;
      if (offer->label.find("not held") != std::string::npos) CHECK_FALSE(is_held(placed));
      if (offer->label.find("holds") != std::string::npos ||
          offer->label.starts_with("Make it hold"))
        CHECK(is_held(placed));
      // The price is told in both directions.
      const std::string says_before =
          percentage(covered).substr(0, percentage(covered).find("\u00A0%"));
      const bool tells = offer->label.find(says_before + " → ") != std::string::npos;
      if (std::abs(placed.coverage - covered) > 0.011) CHECK(tells);
      if (tells && placed.search_ended)
        CHECK(offer->label.find("→ " + percentage(placed.coverage) + " covered") !=
              std::string::npos);
      CHECK(state.work.history.depth() == depth + 1);
      give(state, Undo{});
      CHECK(settings(state) == own);
      CHECK(state.derived().offer);
    }
  }
  CHECK(offers > 20);
}

TEST_CASE("another method is tried with the weight and C that readings told", "[view][offer]") {
  Document weighed = corpus::polygon("grand-piano");
  weighed.settings = with_method(weighed.settings, Method::given, 1);
  weighed.settings.supports = {{200, 300}, {450, 300}, {450, 600}, {200, 600}};
  weighed.settings.weighed.readings = {100, 150, 130, 100};
  AppState state;
  begin(state, placed(weighed));
  frame_view(state);
  const Placement placement = *state.derived().placement;
  REQUIRE(placement.weighing);
  give(state, Compare{Method::balanced});
  REQUIRE(state.derived().second);
  CHECK(state.derived().second->weight() == 480);
  CHECK(state.derived().second->centre_of_mass == placement.centre_of_mass);
  give(state, Compare{});
  REQUIRE(state.derived().offer);
  const std::string label = state.derived().offer->label;
  CAPTURE(label);
  give(state, SetSettings{state.derived().offer->settings});
  const Placement& after = *state.derived().placement;
  CHECK(after.weight() == 480);
  if (label.find("≥") == std::string::npos)
    CHECK(label.find("→ " + percentage(after.coverage)) != std::string::npos);
}

TEST_CASE("an offer waits for the end of a drag, and a challenge gives none", "[view][offer]") {
  AppState state = state_of("grand-piano", Method::random, 2);
  REQUIRE(state.derived().offer);
  const std::uint64_t placements = computed().placements;
  Settings changed = settings(state);
  changed.weight = 60;
  give(state, SetSettings{changed, true});
  CHECK_FALSE(state.derived().offer);
  CHECK(computed().placements == placements + 1);
  give(state, EndEdit{});
  CHECK(state.derived().offer);
  give(state, SetChallenge{true});
  CHECK_FALSE(state.derived().offer);
  give(state, SetChallenge{false});
  CHECK(state.derived().offer);
}

TEST_CASE("where no chord is even enough, a lower ratio is offered", "[view][offer]") {
  Document document;
  document.vertices = {{0, 0}, {400, 0}, {400, 150}, {150, 150}, {150, 300}, {0, 300}};
  document.centre_of_mass = Vec2(330, 190);  // outside the object
  document.settings.min_ratio = 1;
  AppState state;
  begin(state, placed(document));
  REQUIRE(state.derived().offer);
  CHECK(state.derived().offer->label.starts_with("Lower the ratio to 0."));
  give(state, SetSettings{state.derived().offer->settings});
  CHECK_FALSE(state.derived().placement->teams.empty());
}

TEST_CASE("what tips or is overloaded under conditions has an offer, whose price is told",
          "[view][offer]") {
  AppState state = state_of("puzzle-piece", Method::area, 1);
  Shown slope = shown(state);
  slope.carrying.com_height = 700;
  slope.carrying.slope = 0.3;
  give(state, SetShown{slope});
  REQUIRE(judged(state).kind == VerdictKind::bad);
  REQUIRE(state.derived().offer);
  CHECK(state.derived().offer->label.find("it stays") != std::string::npos);
  give(state, SetSettings{state.derived().offer->settings});
  CHECK(judged(state).kind != VerdictKind::bad);

  // Where no robots help, a gentler slope does.
  slope.carrying.slope = 0.9;
  give(state, SetShown{slope});
  REQUIRE(state.derived().offer);
  REQUIRE(state.derived().offer->shown);
  CHECK(state.derived().offer->label.starts_with("Slope "));
  const double gentler = state.derived().offer->shown->carrying.slope;
  CHECK(gentler < 0.9);
  CHECK(gentler > 0.3);
  const Settings before = settings(state);
  give(state, SetShown{*state.derived().offer->shown});
  CHECK(judged(state).kind != VerdictKind::bad);
  CHECK(settings(state) == before);

  state = state_of("puzzle-piece", Method::area, 3);
  Shown capacity = shown(state);
  capacity.capacity = 15;
  give(state, SetShown{capacity});
  REQUIRE(judged(state).kind == VerdictKind::bad);
  REQUIRE(state.derived().offer);
  CHECK(state.derived().offer->label.find("none is overloaded") != std::string::npos);
}
