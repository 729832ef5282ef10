#include "evenlift/experiment/measure.h"

#include <algorithm>
#include <utility>

#include "evenlift/balanced.h"
#include "evenlift/centre_of_mass.h"
#include "evenlift/closure.h"
#include "evenlift/failures.h"
#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/loads.h"
#include "evenlift/placement.h"
#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/stability.h"
#include "evenlift/swaps.h"
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

double weight_of(const Subject& subject, const ExperimentSettings& settings) {
  return settings.weight.value_or(subject.weight);
}

void test_failures(const Subject& subject, const std::vector<LiftingPoint>& points, double weight,
                   Measurement& m) {
  const double diameter = subject.object.outline().diameter();
  const double clear = hold_requirements(subject.object, subject.centre, {}).clear;
  const Points all = positions(points);
  m.steady = failures_steady(all, subject.centre, diameter, clear) >= 1 ? 1 : 0;
  double greatest = 0;
  for (std::size_t failed = 0; failed < all.size(); ++failed) {
    Points rest = all;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(failed));
    const auto springs = spring_loads(rest, subject.centre, diameter, weight);
    if (!springs) return;
    greatest = std::max(greatest, *std::max_element(springs->loads.begin(), springs->loads.end()));
  }
  m.after_failure = greatest;
}

// Everything about these robots but their loads and coverage.
void examine(const Subject& subject, const std::vector<LiftingPoint>& points,
             const ExperimentSettings& settings, Measurement& m) {
  test_closure(subject, points, m);
  if (settings.failures) test_failures(subject, points, weight_of(subject, settings), m);
}

// The candidates in the order in which they are chosen; of robots with a size, those that have room.
std::vector<std::uint32_t> chosen(const Subject& subject, Method method,
                                  const ExperimentSettings& settings, std::size_t teams) {
  if (!subject.stands)
    return select_teams(subject.object, subject.centre, subject.candidates, *metric_of(method),
                        teams);
  Settings of_place;
  of_place.method = method;
  of_place.min_ratio = settings.min_ratio;
  of_place.robot = settings.robot;
  return choose_candidates(subject.object, subject.centre, subject.candidates, of_place, teams,
                           subject.stands.get())
      .taken;
}

std::size_t most_teams(const Subject& subject, const ExperimentSettings& settings) {
  return std::min<std::size_t>(subject.candidates.size(), settings.most_teams);
}

std::vector<Measurement> measure_selected(const Subject& subject, Method method,
                                          const ExperimentSettings& settings) {
  std::vector<Measurement> rows;
  Growing placement(subject, weight_of(subject, settings));
  for (const std::uint32_t i : chosen(subject, method, settings, most_teams(subject, settings))) {
    placement.add(subject.candidates[i].chord);
    Measurement m = placement.measured();
    m.method = method;
    examine(subject, placement.points(), settings, m);
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
    Growing placement(subject, weight_of(subject, settings));
    for (const Chord& chord : chords) placement.add(chord);
    Measurement m = placement.measured();
    m.method = Method::distributed;
    examine(subject, placement.points(), settings, m);
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

// `survived` counts the samples that do not fall after a failure.
struct Sum : Measurement {
  std::uint32_t survived = 0;
};

void add_failures(const Measurement& m, Sum& sum) {
  sum.steady = sum.steady.value_or(0) + *m.steady;
  if (!m.after_failure) return;
  sum.after_failure = sum.after_failure.value_or(0) + *m.after_failure;
  ++sum.survived;
}

void add_sample(const Subject& subject, const ExperimentSettings& settings,
                const std::vector<Chord>& chords, std::vector<Sum>& sums) {
  const double weight = weight_of(subject, settings);
  Growing placement(subject, weight);
  for (std::size_t t = 0; t < chords.size(); ++t) {
    placement.add(chords[t]);
    Measurement m = placement.measured();
    Sum& sum = sums[t];
    ++sum.samples;
    for (const auto& [column, value] : measured_values) sum.*value += m.*value;
    if (!settings.failures) continue;
    test_failures(subject, placement.points(), weight, m);
    add_failures(m, sum);
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
  Sum none;
  none.method = Method::random;
  none.samples = 0;
  none.max_share = 0;
  std::vector<Sum> sums(teams, none);
  for (std::uint32_t seed = 1; seed <= settings.samples; ++seed)
    add_sample(subject, settings, random_teams(subject.object, subject.centre, teams, seed), sums);
  std::vector<Measurement> rows;
  for (std::size_t t = 0; t < teams; ++t) {
    Sum& m = sums[t];
    if (m.samples == 0) continue;
    m.robots = static_cast<std::uint32_t>(2 * (t + 1));
    for (const auto& [column, value] : measured_values) m.*value /= m.samples;
    if (m.steady) *m.steady /= m.samples;
    if (m.after_failure) *m.after_failure /= m.survived;
    rows.push_back(m);
  }
  return rows;
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
  if (settings.weight && !is_in_range(Setting::weight, *settings.weight))
    return setting_error(Setting::weight);
  return std::nullopt;
}

Result<Subject> prepare(const Document& document, const ExperimentSettings& settings) {
  auto object = object_of(document);
  if (!object) return object.error();
  const auto centre = centre_of_mass(*object, document.centre_of_mass, document.settings);
  if (!centre) return centre.error();
  Settings of_place;
  of_place.min_ratio = settings.min_ratio;
  of_place.robot = settings.robot;
  auto stands = make_stands(*object, centre->all, of_place);
  if (!stands) return stands.error();
  auto candidates = candidates_of(*object, centre->all, of_place, stands->get());
  if (!candidates) return candidates.error();
  return Subject{*std::move(object), centre->all, *std::move(candidates),
                 total_weight(document.settings), *std::move(stands)};
}

std::uint32_t teams_of(Method method, std::uint32_t robots) {
  return method == Method::balanced ? 1 : robots / 2;
}

std::vector<Measurement> measure(const Subject& subject, Method method,
                                 const ExperimentSettings& settings) {
  switch (method) {
    case Method::distributed:
      return subject.stands ? std::vector<Measurement>() : measure_distributed(subject, settings);
    case Method::random:
      return subject.stands ? std::vector<Measurement>() : measure_random(subject, settings);
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
std::vector<LiftingPoint> find_balanced(const Subject& subject, std::uint32_t robots,
                                        const RobotSize& size) {
  Settings settings;
  settings.method = Method::balanced;
  settings.robots = robots;
  settings.robot = size;
  const BalancedProblem problem(subject.object, subject.centre, settings);
  std::optional<BalancedSearch> search = start_balanced(problem);
  if (!search) return {};
  return finish_search(problem, *std::move(search)).robots;
}

Measurement measured(const Subject& subject, const std::vector<LiftingPoint>& points,
                     const ExperimentSettings& settings) {
  const double weight = weight_of(subject, settings);
  Measurement m;
  m.method = Method::balanced;
  m.robots = static_cast<std::uint32_t>(points.size());
  m.coverage = coverage(subject.object, lifting_base(subject.object, points));
  const LoadSummary loads = *summarize_loads({share_evenly(points, subject.centre, weight)});
  m.load_min = loads.min;
  m.load_mean = loads.mean;
  m.load_max = loads.max;
  m.spread = loads.spread;
  examine(subject, points, settings, m);
  return m;
}

}  // namespace

bool holds_clearly(const Polygon& polygon, const Vec2& centre,
                   const std::vector<LiftingPoint>& points) {
  const double clear = hold_requirements(polygon, centre, {}).clear;
  return in_form_closure(polygon, centre,
                         clear_contacts(polygon, contacts(polygon, points), clear));
}

void test_closure(const Subject& subject, const std::vector<LiftingPoint>& lifting,
                  Measurement& m) {
  const std::vector<LiftingPoint> points = contact_points(subject.stands.get(), lifting);
  m.form_closure = in_form_closure(subject.object, subject.centre, points) ? 1 : 0;
  m.no_area = no_region_has_area(subject.object, subject.centre, points) ? 1 : 0;
  m.held_clear = holds_clearly(subject.object, subject.centre, points) ? 1 : 0;
}

std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings) {
  std::vector<Measurement> rows;
  for (std::uint32_t robots = least_robots; robots <= settings.most_balanced; ++robots) {
    const std::vector<LiftingPoint> points = find_balanced(subject, robots, settings.robot);
    if (!points.empty()) rows.push_back(measured(subject, points, settings));
  }
  return rows;
}

}  // namespace evenlift::experiment
