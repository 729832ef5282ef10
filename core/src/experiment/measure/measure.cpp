#include "evenlift/experiment/measure.h"

#include <algorithm>
#include <utility>

#include "evenlift/balanced.h"
#include "evenlift/centre_of_mass.h"
#include "evenlift/closure.h"
#include "evenlift/hull.h"
#include "evenlift/loads.h"
#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/stability.h"
#include "evenlift/tolerance.h"
#include "experiment/measure/csv.h"

namespace evenlift::experiment {
namespace {

// Measures a placement while teams are added one by one.
class Growing {
 public:
  Growing(const Subject& subject, double weight)
      : subject_(subject),
        weight_(weight),
        near_(near_distance(subject.object.outline().diameter())) {}

  void add(const Chord& chord) {
    for (const LiftingPoint& end : {chord.r1, chord.r2}) points_.push_back(end);
    chords_.push_back(chord);
    Points hull = widened(chord);
    if (hull == hull_) return;
    hull_ = std::move(hull);
    coverage_.reset();
  }

  const std::vector<LiftingPoint>& points() const { return points_; }

  // All measurements except form closure.
  Measurement measured() {
    Measurement m;
    m.robots = static_cast<std::uint32_t>(points_.size());
    if (!coverage_) coverage_ = coverage(subject_.object, hull_);
    m.coverage = *coverage_;
    const LoadSummary loads = *summarize_loads(distribute_weight(chords_, weight_));
    m.load_min = loads.min;
    m.load_mean = loads.mean;
    m.load_max = loads.max;
    m.spread = loads.spread;
    m.max_share = loads.max_share;
    return m;
  }

 private:
  Points widened(const Chord& chord) const {
    const Vec2 &p = chord.r1.position, &q = chord.r2.position;
    if (hull_.size() >= 3) return widen_hull(hull_, p, q, near_);
    // While H is a segment, points beside it within tolerance are not among its corners.
    return lifting_base(subject_.object, points_);
  }

  const Subject& subject_;
  double weight_;
  double near_;
  std::vector<Chord> chords_;
  std::vector<LiftingPoint> points_;
  Points hull_;
  std::optional<double> coverage_;  // of this hull, once computed
};

using Test = bool (*)(const Polygon&, const Vec2&, const std::vector<LiftingPoint>&);

std::size_t most_teams(const Subject& subject, const ExperimentSettings& settings) {
  return std::min<std::size_t>(subject.candidates.size(), settings.most_teams);
}

std::vector<Measurement> measure_selected(const Subject& subject, Method method,
                                          const ExperimentSettings& settings) {
  std::vector<Measurement> rows;
  Growing placement(subject, settings.weight);
  for (const std::uint32_t i : select_teams(subject.object, subject.centre, subject.candidates,
                                            *metric_of(method), most_teams(subject, settings))) {
    placement.add(subject.candidates[i].chord);
    Measurement m = placement.measured();
    m.method = method;
    test_closure(subject, placement.points(), m);
    m.chosen = i;
    rows.push_back(m);
  }
  return rows;
}

// With equal angles, each number of teams has its own placement.
std::vector<Measurement> measure_distributed(const Subject& subject,
                                             const ExperimentSettings& settings) {
  std::vector<Measurement> rows;
  for (std::size_t teams = 1; teams <= most_teams(subject, settings); ++teams) {
    const std::vector<Chord> chords = distributed_teams(subject.object, subject.centre, teams);
    if (chords.size() < teams) break;
    Growing placement(subject, settings.weight);
    for (const Chord& chord : chords) placement.add(chord);
    Measurement m = placement.measured();
    m.method = Method::distributed;
    test_closure(subject, placement.points(), m);
    rows.push_back(m);
  }
  return rows;
}

// The smallest number of teams that passes the test; one more than all if all together fail. Adding
// teams never ends a pass, so bisection finds the number.
std::size_t first_passing(const Subject& subject, const std::vector<LiftingPoint>& points,
                          Test test) {
  std::size_t fails = 0, passes = points.size() / 2 + 1;
  if (!test(subject.object, subject.centre, points)) return passes;
  --passes;
  while (passes - fails > 1) {
    const std::size_t middle = fails + (passes - fails) / 2;
    const auto end = points.begin() + static_cast<std::ptrdiff_t>(2 * middle);
    const bool passed = test(subject.object, subject.centre, {points.begin(), end});
    (passed ? passes : fails) = middle;
  }
  return passes;
}

void add_sample(const Subject& subject, double weight, const std::vector<Chord>& chords,
                std::vector<Measurement>& sums) {
  Growing placement(subject, weight);
  for (std::size_t t = 0; t < chords.size(); ++t) {
    placement.add(chords[t]);
    const Measurement m = placement.measured();
    Measurement& sum = sums[t];
    ++sum.samples;
    for (const auto& [column, value] : measured_values) sum.*value += m.*value;
  }
  const std::size_t closed = first_passing(subject, placement.points(), in_form_closure);
  for (std::size_t t = closed; t <= chords.size(); ++t) sums[t - 1].form_closure += 1;
  const std::size_t no_area = first_passing(subject, placement.points(), no_region_has_area);
  for (std::size_t t = no_area; t <= chords.size(); ++t) sums[t - 1].no_area += 1;
  const std::size_t clear = first_passing(subject, placement.points(), holds_clearly);
  for (std::size_t t = clear; t <= chords.size(); ++t) sums[t - 1].held_clear += 1;
}

std::vector<Measurement> measure_random(const Subject& subject,
                                        const ExperimentSettings& settings) {
  const std::size_t teams = most_teams(subject, settings);
  Measurement none;
  none.method = Method::random;
  none.samples = 0;
  none.max_share = 0;
  std::vector<Measurement> sums(teams, none);
  for (std::uint32_t seed = 1; seed <= settings.samples; ++seed)
    add_sample(subject, settings.weight, random_teams(subject.object, subject.centre, teams, seed),
               sums);
  for (std::size_t t = 0; t < teams; ++t) {
    Measurement& m = sums[t];
    m.robots = static_cast<std::uint32_t>(2 * (t + 1));
    for (const auto& [column, value] : measured_values) m.*value /= m.samples;
  }
  std::erase_if(sums, [](const Measurement& m) { return m.samples == 0; });
  return sums;
}

}  // namespace

std::optional<InputError> check_settings(const ExperimentSettings& settings) {
  if (!is_in_range(Setting::min_ratio, settings.min_ratio))
    return setting_error(Setting::min_ratio);
  if (settings.samples < 1 || settings.samples > max_samples)
    return bad_setting("samples", "the number of random samples must be from 1 to 100000");
  if (settings.most_teams < 1 || settings.most_teams > max_experiment_teams)
    return bad_setting("max_teams", "the greatest number of teams must be from 1 to 10000");
  if (settings.most_balanced < least_robots || settings.most_balanced > most_robots)
    return bad_setting("max_balanced",
                       "the greatest number of balanced robots must be from 2 to 64");
  if (!is_in_range(Setting::weight, settings.weight)) return setting_error(Setting::weight);
  return std::nullopt;
}

Result<Subject> prepare(const Document& document, double min_ratio) {
  auto object = object_of(document);
  if (!object) return object.error();
  const auto centre = centre_of_mass(*object, document.centre_of_mass, document.settings);
  if (!centre) return centre.error();
  auto candidates = find_candidates(*object, centre->all, min_ratio);
  if (!candidates) return candidates.error();
  return Subject{*std::move(object), centre->all, *std::move(candidates)};
}

std::uint32_t teams_of(Method method, std::uint32_t robots) {
  return method == Method::balanced ? 1 : robots / 2;
}

std::vector<Measurement> measure(const Subject& subject, Method method,
                                 const ExperimentSettings& settings) {
  switch (method) {
    case Method::distributed:
      return measure_distributed(subject, settings);
    case Method::random:
      return measure_random(subject, settings);
    case Method::balanced:
      return measure_balanced(subject, settings);
    case Method::given:  // not a method that can be compared
      return {};
    case Method::area:
    case Method::circle:
    case Method::distance:
      break;
  }
  return measure_selected(subject, method, settings);
}

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
