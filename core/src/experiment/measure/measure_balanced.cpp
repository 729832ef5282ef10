#include "experiment/measure/measure_balanced.h"

#include <utility>

#include "evenlift/balanced.h"
#include "evenlift/closure.h"
#include "evenlift/loads.h"
#include "evenlift/stability.h"

namespace evenlift::experiment {
namespace {

// The robots that place() finds; empty if there is no such placement.
std::vector<LiftingPoint> find_balanced(const Subject& subject, std::uint32_t robots) {
  Settings settings;
  settings.method = Method::balanced;
  settings.robots = robots;
  const BalancedProblem problem(subject.object, subject.centre, settings);
  std::optional<BalancedSearch> search = start_balanced(problem);
  if (!search) return {};
  return finish_search(problem, *std::move(search)).robots;
}

Measurement measured(const Subject& subject, const std::vector<LiftingPoint>& points,
                     double weight) {
  Measurement m;
  m.method = Method::balanced;
  m.robots = static_cast<std::uint32_t>(points.size());
  m.coverage = coverage(subject.object, lifting_base(subject.object, points));
  const LoadSummary loads = *summarize_loads({share_evenly(points, subject.centre, weight)});
  m.load_min = loads.min;
  m.load_mean = loads.mean;
  m.load_max = loads.max;
  m.spread = loads.spread;
  test_closure(subject, points, m);
  return m;
}

}  // namespace

bool holds_clearly(const Polygon& polygon, const Vec2& centre,
                   const std::vector<LiftingPoint>& points) {
  const double clear = hold_requirements(polygon, centre, {}).clear;
  return in_form_closure(polygon, centre,
                         clear_contacts(polygon, contacts(polygon, points), clear));
}

void test_closure(const Subject& subject, const std::vector<LiftingPoint>& points, Measurement& m) {
  m.form_closure = in_form_closure(subject.object, subject.centre, points) ? 1 : 0;
  m.no_area = no_region_has_area(subject.object, subject.centre, points) ? 1 : 0;
  m.held_clear = holds_clearly(subject.object, subject.centre, points) ? 1 : 0;
}

std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings) {
  std::vector<Measurement> rows;
  for (std::uint32_t robots = least_robots; robots <= settings.most_balanced; ++robots) {
    const std::vector<LiftingPoint> points = find_balanced(subject, robots);
    if (!points.empty()) rows.push_back(measured(subject, points, settings.weight));
  }
  return rows;
}

}  // namespace evenlift::experiment
