#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/main_steps.h"
#include "evenlift/output/trace_json.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/traced.h"

using namespace evenlift;
using evenlift::testing::number_if_any;
using evenlift::testing::number_of;
using evenlift::testing::placed;
using evenlift::testing::traced;

namespace {

// A square 0 … 10 with the hole 2 … 4: area 96, centroid (500 − 12) / 96 in x and y.
Document square_with_hole() {
  Document document;
  document.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  document.holes = {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}};
  document.settings.weight = 96;
  return document;
}

Document with_motor() {
  Document document = square_with_hole();
  document.settings.cargo = {{{8, 8}, 24, "motor"}};
  return document;
}

StepDetail step_of(const Trace& trace, StepKind kind, std::uint32_t item = 0) {
  const auto step = trace.find(kind, item);
  REQUIRE(step);
  return look_at(trace, *step);
}

std::vector<Figure> of_kind(const Trace& trace, StepKind step, FigureKind kind,
                            std::uint32_t item = 0) {
  std::vector<Figure> found = figures(trace, step_of(trace, step, item));
  std::erase_if(found, [&](const Figure& figure) { return figure.kind != kind; });
  return found;
}

void check_in_words(const Trace& trace, StepKind kind, const std::string& words,
                    const std::string& calculated, std::uint32_t item = 0) {
  const StepDetail detail = step_of(trace, kind, item);
  CHECK(caption(trace, detail) == words);
  CHECK(formula(trace, detail) == calculated);
}

double area_of(const Points& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) twice += cross(p[i], p[(i + 1) % p.size()]);
  return std::fabs(twice) / 2;
}

}  // namespace

TEST_CASE("the first steps count a hole and the cargo, in words", "[trace][holes][cargo]") {
  const Trace trace = traced(placed(with_motor()));
  check_in_words(
      trace, StepKind::polygon,
      "The object: a polygon with 4 vertices and an area of 96.00. It has 1 hole, whose area does not count. Its outline is convex.",
      "area = |x1·y2 − x2·y1 + x2·y3 − …| / 2 − Σ holes = 100.00 − 4.00 = 96.00");
  check_in_words(
      trace, StepKind::centroid,
      "The centroid is the point where the area balances. Cut the polygon into triangles that share vertex 1 and average their centroids, weighted by area, minus the triangles of the hole; triangles that fold back count with the opposite sign. The centroid is (5.08, 5.08).",
      "sum of area × centroid / sum of areas, both minus those of the holes = (5.08, 5.08)");
  check_in_words(
      trace, StepKind::cargo,
      "Cargo 1, “motor”, weighs 24\u00A0kg at (8.00, 8.00), to the upper right of the centre of mass, which moves towards it from (5.08, 5.08) to (5.67, 5.67).",
      "C := (W C + w q) / (W + w) = (96 × (5.08, 5.08) + 24 × (8.00, 8.00)) / 120 = (5.67, 5.67)");
  check_in_words(
      trace, StepKind::centre,
      "With its cargo the object weighs 120\u00A0kg. Its centre of mass C is at (5.67, 5.67), 0.82 from that of the object alone. Two robots carry the object without tipping it only if C is between them: a team stands at the two ends of a chord through C.",
      "");
}

TEST_CASE("the first steps count a hole and the cargo, in numbers", "[trace][holes][cargo]") {
  const Trace trace = traced(placed(with_motor()));
  const StepDetail polygon = step_of(trace, StepKind::polygon),
                   centroid = step_of(trace, StepKind::centroid),
                   cargo = step_of(trace, StepKind::cargo),
                   centre = step_of(trace, StepKind::centre);
  CHECK(number_of(trace, polygon, "vertices") == 4);
  CHECK(number_of(trace, polygon, "holes") == 1);
  CHECK(number_of(trace, polygon, "outline_area") == 100);
  CHECK(number_of(trace, polygon, "area") == 96);
  CHECK(number_of(trace, centroid, "centroid_x") == Approx(488.0 / 96));
  CHECK(number_of(trace, cargo, "weight") == 24);
  CHECK(number_of(trace, cargo, "total_weight") == 120);
  CHECK(number_of(trace, cargo, "x") == 8);
  CHECK(number_of(trace, cargo, "centre_y") == Approx(680.0 / 120));
  CHECK(number_of(trace, cargo, "moved_by") == Approx(std::sqrt(2.0) * (680.0 / 120 - 488.0 / 96)));
  CHECK(number_of(trace, centre, "own_x") == Approx(488.0 / 96));
  CHECK(pseudo_code(trace.placement.settings)[pseudo_line(trace, cargo)] ==
        "for each item of cargo: C := (W C + w q) / (W + w), W := W + w");
  CHECK_FALSE(formula_letters(trace, cargo).empty());
}

TEST_CASE("the triangles of the centroid have the area of the object", "[trace][holes]") {
  Document document = square_with_hole();
  // A hole whose fan folds back, in the other orientation.
  document.holes.push_back({{6, 6}, {7.5, 9}, {9, 6}, {7.5, 7}});
  for (const bool reversed : {false, true}) {
    CAPTURE(reversed);
    if (reversed) std::reverse(document.vertices.begin(), document.vertices.end());
    const Trace trace = traced(placed(document));
    double shares = 0;
    Vec2 centroid;
    const auto add = [&](FigureKind kind) {
      for (const Figure& figure : of_kind(trace, StepKind::centroid, kind)) {
        CHECK(std::fabs(figure.value) ==
              Approx(area_of(figure.points) / trace.object().area()).margin(1e-12));
        shares += figure.value;
        centroid += figure.value * (figure.points[0] + figure.points[1] + figure.points[2]) / 3;
      }
    };
    add(FigureKind::triangle);
    CHECK(shares == Approx(100 / trace.object().area()));
    add(FigureKind::hole_part);
    CHECK(shares == Approx(1));
    CHECK(length(centroid - trace.object().centroid()) < 1e-9);
    const std::vector<Figure> parts = of_kind(trace, StepKind::centroid, FigureKind::hole_part);
    CHECK(parts.size() == 4);
    CHECK(std::count_if(parts.begin(), parts.end(),
                        [](const Figure& part) { return part.item == 1u; }) == 2);
    CHECK(of_kind(trace, StepKind::polygon, FigureKind::hole).size() == 2);
    const StepDetail detail = step_of(trace, StepKind::centroid);
    CHECK(figure_text(trace, detail, parts.front()) == "Triangle of hole 1: −2\u00A0% of the area");
  }
  const Trace trace = traced(placed(document));
  CHECK(caption(trace, step_of(trace, StepKind::polygon))
            .find("It has 2 holes, and their area does not count.") != std::string::npos);
}

TEST_CASE("each item of cargo moves the centre of mass, the last to C", "[trace][cargo]") {
  Document document = square_with_hole();
  document.centre_of_mass = Vec2(4.5, 5.5);
  document.settings.cargo = {
      {{8, 8}, 24, "motor"}, {{14, 1}, 6, ""}, {{5, 5}, 0.001, "screw #4"}, {{0, 9}, 1, ""}};
  for (const Method method : {Method::area, Method::balanced, Method::random}) {
    CAPTURE(name(method));
    document.settings.method = method;
    const Trace trace = traced(placed(document));
    REQUIRE(trace.count(StepKind::cargo) == 4);
    Vec2 before(4.5, 5.5);
    double weight = 96;
    for (std::uint32_t i = 0; i < 4; ++i) {
      CAPTURE(i);
      const Cargo& item = document.settings.cargo[i];
      const StepDetail detail = step_of(trace, StepKind::cargo, i);
      const Vec2 after(number_of(trace, detail, "centre_x"), number_of(trace, detail, "centre_y"));
      // The law of the lever.
      CHECK(length(weight * (before - after) + item.weight * (item.at - after)) < 1e-9);
      weight += item.weight;
      CHECK(number_of(trace, detail, "total_weight") == weight);
      const auto lever = of_kind(trace, StepKind::cargo, FigureKind::lever, i);
      REQUIRE(lever.size() == 1);
      CHECK(length(lever[0].points[0] - before) < 1e-9);
      CHECK(lever[0].points[1] == item.at);
      CHECK(of_kind(trace, StepKind::cargo, FigureKind::cargo, i).at(0).value == item.weight);
      CHECK(of_kind(trace, StepKind::cargo, FigureKind::centre, i).at(0).points[0] == after);
      before = after;
    }
    CHECK(before == trace.centre);
    CHECK(before == trace.placement.centre_of_mass);
    CHECK(weight == trace.placement.weight());
    CHECK(trace.step(2).kind == StepKind::cargo);
    CHECK(trace.step(6).kind == StepKind::centre);
  }
  const Trace trace = traced(placed(document));
  CHECK(caption(trace, step_of(trace, StepKind::cargo))
            .starts_with("The object alone has its centre of mass at (4.50, 5.50), 0.72 from the "
                         "centroid: it is heavier on that side. Cargo 1, “motor”, weighs 24"));
  CHECK(caption(trace, step_of(trace, StepKind::cargo, 1))
            .starts_with("Cargo 2 weighs 6\u00A0kg at (14.00, 1.00), to the lower right of"));
  CHECK(caption(trace, step_of(trace, StepKind::cargo, 2)).find("by only 0.0000") !=
        std::string::npos);
  const StepDetail third = step_of(trace, StepKind::cargo, 2);
  for (const Figure& figure : figures(trace, third))
    if (figure.kind == FigureKind::cargo)
      CHECK(figure_text(trace, third, figure) == "Cargo 3, “screw #4”, weighs 0.001\u00A0kg");
}

TEST_CASE("an item of cargo at the centre of mass does not move it", "[trace][cargo]") {
  Document document = square_with_hole();
  document.holes.clear();
  document.settings.cargo = {{{5, 5}, 10, ""}};
  const Trace trace = traced(placed(document));
  CHECK(
      caption(trace, step_of(trace, StepKind::cargo)) ==
      "Cargo 1 weighs 10\u00A0kg at (5.00, 5.00), at the centre of mass, which stays where it is.");
  CHECK(number_of(trace, step_of(trace, StepKind::cargo), "moved_by") == 0);
}

TEST_CASE("the main steps show the first three items of cargo", "[trace][cargo]") {
  Document document = square_with_hole();
  for (int i = 0; i < 5; ++i)
    document.settings.cargo.push_back({{3 + 0.25 * i, 6}, 1, std::to_string(i)});
  const Trace trace = traced(placed(document));
  const std::vector<std::uint32_t> steps = main_steps(trace);
  CHECK(std::is_sorted(steps.begin(), steps.end()));
  CHECK(steps.size() <= most_main_steps);
  std::uint32_t shown = 0;
  for (const std::uint32_t k : steps) {
    const Step step = trace.step(k);
    if (step.kind != StepKind::cargo) continue;
    CHECK(further_like(trace, step) == (++shown == 3 ? 2u : 0u));
  }
  CHECK(shown == 3);
}

TEST_CASE("with neither holes nor cargo the trace does not mention them", "[trace][holes][cargo]") {
  for (const std::string& name : corpus::polygon_names()) {
    CAPTURE(name);
    const Trace trace = traced(placed(corpus::polygon(name), Method::distributed));
    CHECK(trace.count(StepKind::cargo) == 0);
    const StepDetail polygon = step_of(trace, StepKind::polygon);
    CHECK_FALSE(number_if_any(trace, polygon, "holes"));
    CHECK_FALSE(number_if_any(trace, step_of(trace, StepKind::centre), "own_x"));
    const std::string text = trace_json(trace);
    CHECK(text.find("hole") == std::string::npos);
    CHECK(text.find("cargo") == std::string::npos);
  }
}

TEST_CASE("a centre of mass in a hole is said to lie there", "[trace][holes]") {
  Document document = square_with_hole();
  document.centre_of_mass = Vec2(3, 3);
  const Trace trace = traced(placed(document));
  CHECK(caption(trace, step_of(trace, StepKind::centre)).find("It lies in a hole.") !=
        std::string::npos);
}
