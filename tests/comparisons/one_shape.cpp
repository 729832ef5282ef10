#include "comparisons/one_shape.h"
#include "kit/solid.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include "evenlift/angles.h"
#include "evenlift/closure.h"
#include "evenlift/hull.h"
#include "evenlift/loads.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"

namespace one_shape {
namespace {

using namespace evenlift;

Vec2 moved(const Vec2& p, const Motion& motion) {
  const double c = std::cos(motion.angle_rad), s = std::sin(motion.angle_rad);
  const double x = motion.mirrored ? -p.x : p.x;
  return motion.scale * Vec2(c * x - s * p.y, s * x + c * p.y) + motion.shift;
}

// The reported numbers of teams.
struct Numbers {
  double coverage = 0, least_load = 0, greatest_load = 0;
  std::optional<double> margin;
  bool form_closure = false, second_order = false, slides = false;
  bool clockwise = false, counterclockwise = false;
};

class Shape {
 public:
  explicit Shape(const Document& document)
      : placement_(*place(document)), polygon_(*Polygon::create(document.vertices)) {}

  const Placement& placement() const { return placement_; }
  const std::vector<Candidate>& candidates() const { return placement_.candidates; }
  const Vec2& centre() const { return placement_.centre_of_mass; }
  double size() const { return polygon_.diagonal(); }

  Numbers numbers(const std::vector<std::uint32_t>& teams) const {
    std::vector<Chord> chords;
    std::vector<LiftingPoint> points;
    Points positions;
    for (const std::uint32_t i : teams) {
      const Chord& chord = candidates()[i].chord;
      chords.push_back(chord);
      for (const LiftingPoint& point : {chord.r1, chord.r2}) {
        points.push_back(point);
        positions.push_back(point.position);
      }
    }
    const Closure closure = analyse_closure(polygon_, centre(), points);
    const auto loads = summarize_loads(distribute_weight(chords, 1));
    Numbers numbers;
    numbers.coverage = coverage(solid(polygon_), convex_hull(positions, 1e-9 * size()));
    numbers.least_load = loads->min;
    numbers.greatest_load = loads->max;
    numbers.margin = closure.margin;
    numbers.form_closure = closure.form_closure;
    numbers.second_order = closure.second_order;
    numbers.slides = closure.translation_free;
    numbers.clockwise = closure.clockwise.exists;
    numbers.counterclockwise = closure.counterclockwise.exists;
    return numbers;
  }

  // By definition: the candidates that tie in every key but candidate order.
  std::vector<std::uint32_t> best_next(const std::vector<std::uint32_t>& taken) const {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < candidates().size(); ++i)
      if (std::find(taken.begin(), taken.end(), i) == taken.end()) left.push_back(i);
    const auto ratio = [&](std::uint32_t i) { return candidates()[i].chord.ratio; };
    const auto length_of = [&](std::uint32_t i) { return candidates()[i].length; };
    const auto absolute = [](double) { return room * tau; };
    const auto relative = [](double best) { return room * tau * best; };
    if (!taken.empty()) {
      const std::vector<double> score = scores(solid(polygon_), centre(), candidates(), taken,
                                               *metric_of(placement_.settings.method));
      const double across = polygon_.diameter();
      const double floor =
          1e-12 * (placement_.settings.method == Method::distance ? across : across * across);
      keep_best(
          left, [&](std::uint32_t i) { return score[i]; },
          [&](double best) { return room * std::max(tau * std::fabs(best), floor); });
      keep_best(left, ratio, absolute);
      keep_best(left, length_of, relative);
      return left;
    }
    std::vector<std::uint32_t> even;
    const bool any_ratio = placement_.settings.positions == Positions::range;
    for (const std::uint32_t i : left)
      if (any_ratio || is_even(candidates()[i].chord)) even.push_back(i);
    if (even.empty()) {
      keep_best(left, ratio, absolute);
      keep_best(left, length_of, relative);
      return left;
    }
    keep_best(even, length_of, relative);
    keep_best(even, ratio, absolute);
    return even;
  }

 private:
  static constexpr double tau = 1e-9;
  static constexpr double room = 1.001;  // where rounding decides at the limit of a tie

  template <class Key, class Slack>
  static void keep_best(std::vector<std::uint32_t>& indices, Key key, Slack slack) {
    double best = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : indices) best = std::max(best, key(i));
    std::erase_if(indices, [&](std::uint32_t i) { return !(key(i) >= best - slack(best)); });
  }

  Placement placement_;
  Polygon polygon_;
};

class Comparer {
 public:
  Comparer(const Document& document, const Motion& motion)
      : motion_(motion), before_(document), after_(one_shape::moved(document, motion)) {
    out_ << std::setprecision(17);
  }

  Comparison run(std::uint32_t teams) {
    same("number of candidates", before_.candidates().size(), after_.candidates().size());
    if (alike() && match()) compare_teams(teams);
    return {out_.str(), ties_};
  }

 private:
  template <class T>
  void same(const char* what, const T& before, const T& after) {
    if (!(before == after)) out_ << what << ": " << before << " and now " << after << "\n";
  }
  void near(const char* what, double before, double after) {
    if (!(std::fabs(before - after) <= allowed))
      out_ << what << ": " << before << " and now " << after << "\n";
  }
  bool alike() const { return out_.str().empty(); }

  double apart(const Chord& before, const Chord& after) const {
    const auto gap = [](const Vec2& p, const Vec2& q) { return length(p - q); };
    const Vec2 r1 = moved(before.r1.position, motion_), r2 = moved(before.r2.position, motion_);
    const Vec2 &s1 = after.r1.position, &s2 = after.r2.position;
    return std::min(std::max(gap(r1, s1), gap(r2, s2)), std::max(gap(r1, s2), gap(r2, s1)));
  }

  // Finds each candidate's counterpart in the copy.
  bool match() {
    std::vector<char> used(after_.candidates().size());
    for (std::uint32_t i = 0; i < before_.candidates().size(); ++i) {
      const Candidate& mine = before_.candidates()[i];
      std::uint32_t best = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t j = 0; j < used.size(); ++j) {
        const double gap = used[j] ? least : apart(mine.chord, after_.candidates()[j].chord);
        if (gap < least) {
          least = gap;
          best = j;
        }
      }
      if (!(least <= allowed * after_.size())) {
        out_ << "candidate " << i << " has no like, the nearest is off by " << least / after_.size()
             << " L\n";
        return false;
      }
      used[best] = 1;
      became_.push_back(best);
      const Candidate& other = after_.candidates()[best];
      near("ratio of a candidate", mine.chord.ratio, other.chord.ratio);
      same("kind of a candidate", name(mine.kind), name(other.kind));
    }
    return alike();
  }

  void compare_teams(std::uint32_t teams) {
    const auto number =
        static_cast<std::uint32_t>(std::min<std::size_t>(teams, before_.candidates().size()));
    std::vector<std::uint32_t> mine, theirs;
    for (std::uint32_t k = 0; k < number && alike(); ++k) {
      const std::uint32_t next = before_.placement().team_candidates[k];
      const std::uint32_t expected = became_[next];
      // Once the copy was forced to follow, its own later teams prove nothing.
      const bool follows = ties_ == 0 && after_.placement().team_candidates[k] == expected;
      if (!follows && !is_tie(theirs, expected, k)) return;
      mine.push_back(next);
      theirs.push_back(expected);
      compare_numbers(before_.numbers(mine), after_.numbers(theirs));
      if (!alike()) out_ << "with " << k + 1 << " teams\n";
    }
  }

  // Whether `expected` is among the copy's best by every key but order.
  bool is_tie(const std::vector<std::uint32_t>& taken, std::uint32_t expected, std::uint32_t k) {
    const std::vector<std::uint32_t> best = after_.best_next(taken);
    if (std::find(best.begin(), best.end(), expected) != best.end()) {
      ties_ += best.size() > 1;
      return true;
    }
    out_ << "team " << k << " of the copy cannot be candidate " << expected << ": candidate "
         << best.front() << " is better by more than a tie\n";
    return false;
  }

  void compare_numbers(const Numbers& a, const Numbers& b) {
    near("coverage", a.coverage, b.coverage);
    near("least load", a.least_load, b.least_load);
    near("greatest load", a.greatest_load, b.greatest_load);
    same("form closure", a.form_closure, b.form_closure);
    same("second order", a.second_order, b.second_order);
    same("free translation", a.slides, b.slides);
    same("free clockwise", a.clockwise, motion_.mirrored ? b.counterclockwise : b.clockwise);
    same("free counter-clockwise", a.counterclockwise,
         motion_.mirrored ? b.clockwise : b.counterclockwise);
    same("a margin", a.margin.has_value(), b.margin.has_value());
    if (a.margin && b.margin) near("margin", *a.margin, *b.margin);
  }

  Motion motion_;
  Shape before_, after_;
  std::vector<std::uint32_t> became_;
  std::ostringstream out_;
  int ties_ = 0;
};

}  // namespace

Motion any_motion(const evenlift::Document& document, evenlift::Rng& rng) {
  Motion motion;
  motion.mirrored = rng.below(2) == 1;
  motion.angle_rad = 2 * evenlift::pi * rng.uniform();
  motion.scale = std::exp(6 * rng.uniform() - 3);
  const double far = 20 * motion.scale * Polygon::create(document.vertices)->diagonal();
  const double x = far * (2 * rng.uniform() - 1);
  motion.shift = Vec2(x, far * (2 * rng.uniform() - 1));
  return motion;
}

evenlift::Document moved(const evenlift::Document& document, const Motion& motion) {
  evenlift::Document result = document;
  for (Vec2& v : result.vertices) v = moved(v, motion);
  if (result.centre_of_mass) result.centre_of_mass = moved(*result.centre_of_mass, motion);
  return result;
}

Comparison compare(const evenlift::Document& document, const Motion& motion, std::uint32_t teams) {
  evenlift::Document asked = document;
  asked.settings.teams = teams;
  return Comparer(asked, motion).run(teams);
}

bool is_clear_of_refusal(const evenlift::Document& document) {
  const auto polygon = Polygon::create(document.vertices);
  if (!polygon) return false;
  const Vec2 centre = document.centre_of_mass.value_or(polygon->centroid());
  const Points& hull = polygon->hull();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (!(cross(b - a, centre - a) > 1e-8 * polygon->diagonal() * length(b - a))) return false;
  }
  return true;
}

std::string text(const evenlift::Document& document, const Motion& motion) {
  std::ostringstream s;
  s << std::setprecision(17) << (motion.mirrored ? "mirrored, " : "") << "turned by "
    << motion.angle_rad << " rad, scaled by " << motion.scale << ", moved by (" << motion.shift.x
    << "," << motion.shift.y << ")\n";
  if (document.centre_of_mass)
    s << "CoM:(" << document.centre_of_mass->x << "," << document.centre_of_mass->y << ")\n";
  for (const Vec2& v : document.vertices) s << "(" << v.x << "," << v.y << ")\n";
  s << name(document.settings.method) << ", minimum load ratio " << document.settings.min_ratio;
  return s.str();
}

}  // namespace one_shape
