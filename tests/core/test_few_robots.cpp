// On a tiny set: the table, and averages that balanced robots must not change.
#include "evenlift/experiment/few_robots.h"

#include "evenlift/experiment/claims.h"
#include "evenlift/experiment/figures.h"
#include "evenlift/placement.h"
#include "kit/catch.h"
#include "kit/corpus.h"

using namespace evenlift;

namespace {

const std::vector<std::string> tiny = {"square", "star-moved", "letter-e-moved"};

experiment::PolygonResult measured(const std::string& name) {
  const Result<experiment::Subject> subject = experiment::prepare(corpus::polygon(name), {});
  REQUIRE(subject.ok());
  experiment::PolygonResult result = experiment::result_of("tiny", name, *subject);
  for (const Method method : all_methods)
    for (const experiment::Measurement& m :
         experiment::measure(*subject, method, {.samples = 2, .most_balanced = 5}))
      result.measurements.push_back(m);
  return result;
}

std::vector<experiment::PolygonResult> tiny_set() {
  std::vector<experiment::PolygonResult> results;
  for (const std::string& name : tiny) results.push_back(measured(name));
  return results;
}

// A new placement on each polygon.
std::vector<Placement> placed(Method method, std::uint32_t robots) {
  std::vector<Placement> placements;
  for (const std::string& name : tiny) {
    Document document = corpus::polygon(name);
    document.settings.method = method;
    document.settings.robots = robots;
    document.settings.teams = robots / 2;
    Result<Placement> placement = place(document);
    REQUIRE(placement.ok());
    REQUIRE(count_robots(placement->teams) == robots);
    placements.push_back(*std::move(placement));
  }
  return placements;
}

double mean_over(const std::vector<Placement>& placements, double (*value)(const Placement&)) {
  double sum = 0;
  for (const Placement& placement : placements) sum += value(placement);
  return sum / static_cast<double>(placements.size());
}

const std::string& cell(const experiment::FewRobots& table, const std::string& what,
                        std::uint32_t robots, Method method) {
  for (const experiment::FewRobotsRow& row : table.rows)
    if (row.what == what && row.robots == robots)
      return row.cells.at(static_cast<std::size_t>(method));
  FAIL("no row of " << what << " with " << robots << " robots");
  return table.set;
}

void check_cells(const experiment::FewRobots& table, Method method, std::uint32_t robots) {
  INFO(name(method) << ", " << robots << " robots");
  const std::vector<Placement> all = placed(method, robots);
  const double coverage = mean_over(all, [](const Placement& p) { return p.coverage; });
  const double closed =
      mean_over(all, [](const Placement& p) { return p.closure.form_closure ? 1.0 : 0.0; });
  const double spread = mean_over(all, [](const Placement& p) { return p.loads->spread; });
  CHECK(std::stod(cell(table, "coverage, %", robots, method)) ==
        Approx(100 * coverage).margin(0.0501));
  CHECK(std::stod(cell(table, "in form closure, %", robots, method)) ==
        Approx(100 * closed).margin(0.0501));
  CHECK(std::stod(cell(table, "spread of loads, kg of 100 kg", robots, method)) ==
        Approx(spread).margin(0.00501));
  CHECK(cell(table, "number of polygons", robots, method) == std::to_string(all.size()));
}

}  // namespace

TEST_CASE("the table of few robots has the means of placements made anew",
          "[experiment][balanced][slow]") {
  const experiment::FewRobots table =
      experiment::few_robots({"tiny", experiment::aggregate(tiny_set())});
  for (const Method method : {Method::area, Method::distance, Method::distributed})
    for (const std::uint32_t robots : {4u, 6u}) check_cells(table, method, robots);
  for (const std::uint32_t robots : {3u, 4u, 5u}) check_cells(table, Method::balanced, robots);
}

TEST_CASE("the table of few robots has a dash where a method has no such number of robots",
          "[experiment][balanced][slow]") {
  const experiment::FewRobots table =
      experiment::few_robots({"tiny", experiment::aggregate(tiny_set())});
  CHECK(table.rows.size() == 5 * 10);
  for (const experiment::FewRobotsRow& row : table.rows) {
    INFO(row.what << ", " << row.robots << " robots");
    REQUIRE(row.cells.size() == std::size(all_methods));
    for (const Method method : pair_methods)
      if (row.robots % 2 == 1) CHECK(row.cells.at(static_cast<std::size_t>(method)) == "–");
    const std::string& balanced = row.cells.at(static_cast<std::size_t>(Method::balanced));
    CHECK((balanced == "–") == (row.robots > 5));
  }
}

TEST_CASE("the table of few robots is the same in Markdown and as JSON, set by set",
          "[experiment][balanced]") {
  const experiment::FewRobots of_nothing = experiment::few_robots({"a | b", {}});
  const std::string markdown = experiment::few_robots_markdown({of_nothing, of_nothing});
  const std::string head =
      "| a \\| b | robots | area | circle | distance | distributed | random | balanced |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n"
      "| coverage, % | 3 | – | – | – | – | – | – |\n";
  CHECK(markdown.rfind(head, 0) == 0);
  CHECK(markdown.find("\n\n" + head) != std::string::npos);
  const std::string json = experiment::few_robots_json({of_nothing});
  CHECK(json.find(R"("set": "a | b")") != std::string::npos);
  CHECK(json.find(
            R"({"what": "coverage, %", "robots": 3, "cells": ["–", "–", "–", "–", "–", "–"]})") !=
        std::string::npos);
}

TEST_CASE("names with HTML or Markdown in them are shown as they are in tables", "[experiment]") {
  const std::string name = "<img src=x onerror=alert(1)> [a](b) *c* _d_ `e` & f\\";
  const std::string shown =
      "&lt;img src=x onerror=alert(1)&gt; \\[a\\](b) \\*c\\* \\_d\\_ \\`e\\` &amp; f\\\\";
  const std::string robots = experiment::few_robots_markdown({experiment::few_robots({name, {}})});
  CHECK(robots.rfind("| " + shown + " | robots |", 0) == 0);
  CHECK(robots.find('<') == std::string::npos);
  const std::string thesis =
      experiment::claims_markdown({{name, {{"5.1", "what", "the thesis", "best of " + name}}}});
  CHECK(thesis.find(" " + shown + " |\n") != std::string::npos);
  CHECK(thesis.find("best of " + shown) != std::string::npos);
  CHECK(thesis.find('<') == std::string::npos);
}

TEST_CASE("balanced robots change nothing of what is averaged of teams of two",
          "[experiment][balanced][slow]") {
  std::vector<experiment::PolygonResult> with = tiny_set(), without = with;
  for (experiment::PolygonResult& result : without)
    std::erase_if(result.measurements,
                  [](const experiment::Measurement& m) { return m.method == Method::balanced; });
  // Here only balanced robots have form closure.
  for (std::vector<experiment::PolygonResult>* results : {&with, &without})
    for (experiment::Measurement& m : results->front().measurements)
      if (m.method != Method::balanced) m.form_closure = 0;
  const auto rows = [](const std::vector<experiment::PolygonResult>& results) {
    std::vector<experiment::Aggregate> teams = experiment::aggregate(results);
    std::erase_if(teams,
                  [](const experiment::Aggregate& a) { return a.method == Method::balanced; });
    return experiment::aggregates_csv({{"tiny", teams}});
  };
  CHECK(rows(with) == rows(without));
  CHECK_FALSE(experiment::can_close(with.front(), &experiment::Measurement::form_closure));
}

TEST_CASE("averages by the thesis's own test are over the polygons that can pass it",
          "[experiment]") {
  // On the first, no placement is in form closure, but one of two leaves no area to turn about.
  std::vector<experiment::PolygonResult> results(2);
  const auto measure = [](Method method, double form_closure, double no_area) {
    experiment::Measurement m;
    m.method = method;
    m.robots = 4;
    m.form_closure = form_closure;
    m.no_area = no_area;
    return m;
  };
  results[0].measurements = {measure(Method::area, 0, 1), measure(Method::circle, 0, 0)};
  results[1].measurements = {measure(Method::area, 1, 1), measure(Method::circle, 1, 1)};
  const std::vector<experiment::Aggregate> aggregates = experiment::aggregate(results);
  const experiment::Aggregate* circle = experiment::find(aggregates, Method::circle, 4);
  REQUIRE(circle);
  CHECK(circle->closable == 1);
  CHECK(circle->form_closure == 1);
  CHECK(circle->no_area_possible == 2);
  CHECK(circle->no_area == 0.5);
}

TEST_CASE("the charts have balanced robots at every number of them",
          "[experiment][balanced][slow]") {
  for (const experiment::Figure& figure :
       experiment::make_figures({"tiny", experiment::aggregate(tiny_set())})) {
    INFO(figure.id);
    REQUIRE(figure.series.size() == std::size(all_methods));
    const experiment::FigureSeries& series = figure.series.back();
    CHECK(series.method == Method::balanced);
    REQUIRE(series.points.size() == 4);
    for (std::uint32_t i = 0; i < 4; ++i) CHECK(series.points[i].robots == i + 2);
  }
}

TEST_CASE("the charts have balanced robots even if two of them stand nowhere",
          "[experiment][balanced]") {
  experiment::PolygonResult result;
  for (const std::uint32_t robots : {3u, 4u, 6u}) {
    experiment::Measurement m;
    m.method = Method::balanced;
    m.robots = robots;
    result.measurements.push_back(m);
  }
  const std::vector<experiment::Aggregate> rows = experiment::aggregate({result});
  CHECK(experiment::most_robots_shown(rows, Method::balanced) == 6);
  CHECK(experiment::most_robots_shown(rows, Method::area) == 0);
}
