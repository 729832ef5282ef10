#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/lesson.h"
#include "evenlift/main_steps.h"
#include "evenlift/output/json.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/traced.h"
#include "stands/stand_oracle.h"

using namespace evenlift;
using evenlift::testing::number_if_any;
using evenlift::testing::number_of;
using evenlift::testing::placed;
using evenlift::testing::traced;

namespace {

Document sized(const std::string& name, const RobotSize& parts, std::vector<EdgePart> no_go = {}) {
  Document document = corpus::polygon(name);
  const double d = Polygon::create(document.vertices)->diagonal();
  document.settings.robot = {parts.radius * d, parts.reach * d, parts.depth * d, parts.width * d,
                             parts.gap * d};
  document.settings.no_go = std::move(no_go);
  return document;
}

}  // namespace

TEST_CASE("traces of points have no step about stands", "[stands][trace]") {
  for (const Method method : {Method::area, Method::balanced, Method::distributed}) {
    Document document = corpus::polygon("boomerang");
    document.settings.method = method;
    const Trace trace = traced(placed(document));
    CHECK(trace.count(StepKind::stands) == 0);
    CHECK_FALSE(progress_at(trace, trace.size() - 1).stands);
    for (const std::string_view line : pseudo_code(document.settings))
      CHECK(line.find("a robot can stand") == std::string_view::npos);
  }
}

TEST_CASE("the step about stands says how much is lost to each reason", "[stands][trace][slow]") {
  const RobotSize sizes[] = {{0.03, 0, 0, 0, 0},
                             {0.02, 0.02, 0, 0.04, 0.01},
                             {0.02, 0.01, 0.05, 0.03, 0},
                             {0, 0, 0, 0, 0}};
  int misfits = 0, reasons = 0;
  for (const std::string& name : corpus::polygon_names()) {
    if (corpus::polygon(name).vertices.size() > 60) continue;
    for (const RobotSize& size : sizes) {
      const Document document = sized(name, size, {{1, 0.25, 0.5}});
      const auto placement = place(document);
      if (!placement) continue;
      INFO(name << ", radius " << size.radius);
      const Trace trace = traced(*placement);
      REQUIRE(trace.count(StepKind::stands) == 1);
      const std::uint32_t k = *trace.find(StepKind::stands, 0);
      CHECK(trace.step(k - 1).kind == StepKind::centre);
      CHECK_FALSE(progress_at(trace, k - 1).stands);
      CHECK(progress_at(trace, k).stands);
      const std::vector<std::uint32_t> main = main_steps(trace);
      CHECK(std::find(main.begin(), main.end(), k) != main.end());
      const StepDetail detail = look_at(trace, k);
      // All but the bits before the vertices.
      double sum = number_of(trace, detail, "usable");
      for (const char* why : {"no_go", "body", "arm", "corner", "hand", "near_no_go", "narrow"}) {
        // Reasons that exclude nothing are not named.
        const double share = number_if_any(trace, detail, why).value_or(0);
        sum += share;
        reasons += share > 0;
      }
      CHECK(sum == Approx(1).margin(1e-6));
      CHECK(number_of(trace, detail, "no_go") > 0);
      const Stands& stands = *trace.placement.stands;
      const testing::StandOracle oracle(trace.polygon(), document.settings.robot,
                                        document.settings.no_go);
      const auto verdict = [&](const LiftingPoint& contact) {
        const Vec2 &p = trace.polygon().edge_start(contact.edge),
                   &q = trace.polygon().edge_end(contact.edge);
        return oracle.at(contact.edge, dot(contact.position - p, q - p) / dot(q - p, q - p));
      };
      for (const auto& [part, contact] : detail.stands->misfits) {
        CHECK(stands.unusable()[part].edge == contact.edge);
        CHECK(verdict(contact) != testing::StandOracle::Verdict::stands);
        ++misfits;
      }
      CHECK(detail.stands->fits.has_value() == stands.has_body());
      if (detail.stands->fits)
        CHECK(verdict(*detail.stands->fits) != testing::StandOracle::Verdict::cannot);
      const std::vector<Figure> shown = figures(trace, detail);
      const auto parts = std::count_if(shown.begin(), shown.end(), [](const Figure& figure) {
        return figure.kind == FigureKind::unusable;
      });
      CHECK(static_cast<std::size_t>(parts) == stands.unusable().size());
      for (const Figure& figure : shown) {
        const std::string text = figure_text(trace, detail, figure);
        CHECK_FALSE(text.empty());
        CHECK(text.find('#') == std::string::npos);
        if (figure.kind == FigureKind::body) CHECK(figure.value == document.settings.robot.radius);
      }
      const std::string text = caption(trace, detail);
      CHECK(text.find("Robots take room: ") == 0);
      CHECK(text.find(" is no-go, and no robot may touch it") != std::string::npos);
      CHECK(text.find('#') == std::string::npos);
      CHECK(formula(trace, detail).empty() == !stands.has_body());
      CHECK(formula_letters(trace, detail).empty() == !stands.has_body());
      CHECK(pseudo_code(document.settings)[pseudo_line(trace, detail)].find("can stand") !=
            std::string_view::npos);
    }
  }
  CHECK(misfits > 100);
  CHECK(reasons > 300);
}

TEST_CASE("the step about stands is told of balanced robots, too, and has an address",
          "[stands][trace][lesson][slow]") {
  Document document = sized("boomerang", {0.03, 0.01, 0.02, 0.02, 0});
  document.settings.method = Method::balanced;
  document.settings.robots = 4;
  const Trace trace = traced(placed(document));
  const auto found = find_step(trace, at::Kind{StepKind::stands, 0});
  REQUIRE(found);
  const auto lesson = parse_lesson(
      "title: T\npolygon: boomerang\nrobot: r=2,depth=1\nno-go: 1:0-0.5\n\n[stands]\nWords.\n");
  REQUIRE(lesson.ok());
  CHECK(find_step(trace, lesson->steps[0].address) == found);
  const auto told = lesson_document(*lesson, corpus::polygon("boomerang"));
  REQUIRE(told.ok());
  CHECK(told->settings.robot == RobotSize{2, 0, 1, 0, 0});
  CHECK(told->settings.no_go.size() == 1);
  const StepDetail detail = look_at(trace, *found);
  CHECK(detail.step.chapter == Chapter::object);
  CHECK(formula(trace, detail).find("s = c + (radius + reach) n") == 0);
  CHECK(formula(trace, detail).find("p = c − depth n") != std::string::npos);
  CHECK(caption(trace, detail).find(" The middles of two robots stay at least ") !=
        std::string::npos);
}

TEST_CASE("a start that was found at once is no completion, and each of its steps can be shown",
          "[stands][trace]") {
  Document document;  // a comb with little room, from the search for differences
  document.vertices = {{0, 0},
                       {1000, 0},
                       {1000, 939.147},
                       {957.498, 202.92},
                       {898.994, 908.911},
                       {872.679, 151.128},
                       {809.699, 893.452},
                       {783.842, 173.133},
                       {716.303, 945.823},
                       {686.638, 210.3},
                       {622.948, 892.596},
                       {592.057, 192.851},
                       {545, 966.172},
                       {455, 892.462},
                       {411.704, 146.2},
                       {347.478, 893.304},
                       {297.867, 205.066},
                       {247.617, 885.918},
                       {214.846, 186.857},
                       {139.221, 907.84},
                       {87.491, 198.375},
                       {47.324, 975.56},
                       {0, 186.42}};
  document.centre_of_mass = Vec2(285.6743333333333, 623.004);
  document.settings.method = Method::balanced;
  document.settings.robots = 8;
  document.settings.goal = Goal::cover;
  document.settings.robot = {22.23741862902558, 22.23741862902558, 11.11870931451279,
                             22.23741862902558, 0};
  const Trace trace = traced(placed(document));
  REQUIRE(trace.history.start.size() == 1);
  CHECK(trace.history.start.front().at_once);
  CHECK(trace.count(StepKind::rest) == 0);
  CHECK(trace.count(StepKind::mirror) == 0);
  CHECK(trace.count(StepKind::completion) == 0);
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    const StepDetail detail = look_at(trace, k);
    CHECK_FALSE(caption(trace, detail).empty());
    CHECK_FALSE(figures(trace, detail).empty());
  }
}
