// Selection (algorithm.md): the first team, f(p) of each metric, and every tie.
#include "oracle/exact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>

namespace oracle {
namespace {

/// From C, within the tolerance.
bool same_direction(const RealVec& u, const RealVec& v, Calls& calls) {
  if (dot(u, v) <= 0) return false;
  return calls.within(abs(cross(u, v)) / (length(u) * length(v)), tau, "directions from C");
}

/// Whether v is counter-clockwise of `from` and clockwise of `to`, at most 180 degrees apart. It
/// must agree with neither.
bool strictly_between(const RealVec& from, const RealVec& v, const RealVec& to) {
  return cross(from, v) > 0 && cross(v, to) > 0;
}

/// Between the two, or in the direction of one of them.
bool seen_in(const RealVec& h1, const RealVec& v, const RealVec& h2, Calls& calls) {
  return same_direction(h1, v, calls) || same_direction(h2, v, calls) ||
         strictly_between(h1, v, h2);
}

/// H before the candidate.
class Base {
 public:
  Base(const std::vector<ExactVec>& points, const Real& size, Calls& calls)
      : corners_(lifting_base(points, size, calls)),
        size_(size),
        calls_(calls),
        segment_(corners_.size() < 3) {}

  /// The edges to which p belongs: one, two in a corner's direction, or none if p adds nothing.
  using Edge = std::array<RealVec, 2>;
  std::vector<Edge> edges_of(const RealVec& p) {
    const std::size_t n = corners_.size();
    if (segment_) {
      const RealVec &a = corners_[0], &b = corners_[1];
      const Real side = outside(p, a, b);
      if (calls_.within(abs(side), tau * size_, "on the line of H")) return {};
      return {side > 0 ? Edge{a, b} : Edge{b, a}};
    }
    if (in_or_near(p)) return {};
    for (std::size_t i = 0; i < n; ++i)
      if (same_direction(corners_[i], p, calls_))
        return {Edge{corners_[i], corners_[(i + 1) % n]},
                Edge{corners_[(i + n - 1) % n], corners_[i]}};
    for (std::size_t i = 0; i < n; ++i)
      if (strictly_between(corners_[i], p, corners_[(i + 1) % n]))
        return {Edge{corners_[i], corners_[(i + 1) % n]}};
    return {};
  }

  Real shortest_edge() const {
    Real shortest = length(corners_[1] - corners_[0]);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      shortest =
          std::min<Real>(shortest, length(corners_[(i + 1) % corners_.size()] - corners_[i]));
    return shortest;
  }

 private:
  bool in_or_near(const RealVec& p) {
    bool inside = true;
    Real distance = -1;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const RealVec &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      inside = inside && outside(p, a, b) <= 0;
      const Real d = distance_to_segment(p, a, b);
      if (distance < 0 || d < distance) distance = d;
    }
    return inside || calls_.within(distance, tau * size_, "within tolerance of H");
  }

  std::vector<RealVec> corners_;
  Real size_;
  Calls& calls_;
  bool segment_;
};

Real area_metric(const ExactShape& shape, const RealVec& h1, const RealVec& h2, const RealVec& p) {
  return area_within(shape, {h1, p, h2});  // p is right of h1 -> h2
}

Real circle_metric(const RealVec& h1, const RealVec& h2, const RealVec& p) {
  const Real perimeter = length(h1 - h2) + length(h2 - p) + length(p - h1);
  const Real radius = 2 * abs(signed_area({h1, p, h2})) / perimeter;
  return boost::math::constants::pi<Real>() * radius * radius;
}

/// Adds to `rounding` how the sum may change if positions are off by `unit`: a shorter edge's line
/// turns more.
Real distance_metric(const ExactShape& shape, const RealVec& h1, const RealVec& h2,
                     const RealVec& p, const Real& unit, Real& rounding, Calls& calls) {
  Real sum = 0;
  const auto lever = [](const RealVec& v, const RealVec& from, const RealVec& to) {
    return length(v - from) / length(to - from);
  };
  const auto arm = [](const RealVec& v, const RealVec& a, const RealVec& b) {
    return std::max<Real>(0, outside(v, a, b));
  };
  for (const RealVec& v : shape.real_vertices) {
    if (v == RealVec{0, 0} || !seen_in(h1, v, h2, calls)) continue;
    const Real up_to_p = arm(v, h1, p), from_p = arm(v, p, h2);
    const bool before_p = same_direction(h1, v, calls) || strictly_between(h1, v, p);
    sum += arm(v, h1, h2) - (same_direction(p, v, calls) ? std::max<Real>(up_to_p, from_p)
                             : before_p                  ? up_to_p
                                                         : from_p);
    rounding += unit * (2 + lever(v, h1, h2) + (before_p ? lever(v, h1, p) : lever(v, h2, p)));
  }
  return sum;
}

/// Keeps the elements of `remaining` whose key ties with the best. `doubt` is how far rounding in
/// doubles may change the difference of two keys.
using Key = std::function<Real(std::size_t)>;
using Tie = std::function<Real(const Real& best)>;  // how far below the best a tie may be
void keep_best(std::vector<std::size_t>& remaining, const Key& key, const Tie& tie, Calls& calls,
               const char* what, const Real& doubt = 0) {
  std::vector<Real> keys;
  keys.reserve(remaining.size());
  for (std::size_t i : remaining) keys.push_back(key(i));
  const auto first = std::max_element(keys.begin(), keys.end());
  const Real best = *first, allowed = tie(best);
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < remaining.size(); ++k) {
    const Real behind = best - keys[k];
    if (calls.within(behind, allowed, what)) kept.push_back(remaining[k]);
    if (keys.begin() + static_cast<std::ptrdiff_t>(k) != first && abs(behind - allowed) < doubt)
      calls.either_is_right(what);
  }
  remaining = kept;
}

class Selector {
 public:
  Selector(const Problem& problem, const CandidateList& list)
      : problem_(problem), shape_(*list.shape), chords_(list.chords->chords) {
    Real largest = 0;
    for (const Point& vertex : problem.vertices)
      for (const double coordinate : vertex)
        largest = std::max<Real>(largest, std::fabs(coordinate));
    unit_ = largest * std::numeric_limits<double>::epsilon();
  }

  Selection run() {
    for (std::size_t i = 0; i < chords_.size(); ++i) left_.push_back(i);
    const std::size_t asked = static_cast<std::size_t>(problem_.teams);
    while (!left_.empty() && result_.teams.size() < asked) {
      if (result_.teams.empty())
        take(first_team(), 0);
      else
        take_further();
    }
    result_.closest_call = calls_.closest();
    return result_;
  }

  Scores scores_after(const std::vector<std::size_t>& teams) {
    std::vector<std::size_t> all(chords_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    Base base = base_of(teams);
    Real doubt = 0;
    Scores scores;
    for (const Real& score : scores_of(all, base, doubt))
      scores.values.push_back(static_cast<double>(score));
    scores.closest_call = calls_.closest();
    return scores;
  }

 private:
  void keep_by_ratio(std::vector<std::size_t>& r) {
    keep_best(
        r, [&](std::size_t i) { return chords_[i].ratio; }, [](const Real&) { return tau; }, calls_,
        "ratio key");
  }
  void keep_by_length(std::vector<std::size_t>& r) {
    keep_best(
        r, [&](std::size_t i) { return chords_[i].length; },
        [](const Real& best) { return tau * best; }, calls_, "length key");
  }

  std::size_t first_team() {
    std::vector<std::size_t> remaining;
    for (std::size_t i : left_)
      if (calls_.within(1 - chords_[i].ratio, tau, "even")) remaining.push_back(i);
    if (!remaining.empty()) {
      keep_by_length(remaining);
      keep_by_ratio(remaining);
    } else {
      remaining = left_;
      keep_by_ratio(remaining);
      keep_by_length(remaining);
    }
    return remaining.front();
  }

  void take_further() {
    Base base = base_of(result_.teams);
    Real doubt = 0;
    const std::vector<Real> scores = scores_of(left_, base, doubt);

    const Real& size = shape_.size;
    const Real absolute =
        (problem_.metric == Metric::distance
             ? Real(size * std::max<Real>(1, size / (1000 * base.shortest_edge())))
             : Real(size * size)) /
        Real("1e12");
    std::vector<std::size_t> remaining = left_;
    keep_best(
        remaining, [&](std::size_t i) { return scores[i]; },
        [&](const Real& best) { return std::max<Real>(tau * abs(best), absolute); }, calls_,
        "score key", doubt);
    keep_by_ratio(remaining);
    keep_by_length(remaining);
    take(remaining.front(), static_cast<double>(scores[remaining.front()]));
  }

  Base base_of(const std::vector<std::size_t>& teams) {
    std::vector<ExactVec> points;
    for (std::size_t i : teams)
      for (const ExactVec& end : chords_[i].ends) points.push_back(end);
    return Base(points, shape_.size, calls_);
  }

  /// `doubt` grows to the possible change by rounding.
  std::vector<Real> scores_of(const std::vector<std::size_t>& candidates, Base& base, Real& doubt) {
    std::vector<Real> scores(chords_.size());
    for (std::size_t i : candidates) {
      rounding_ = 0;
      scores[i] = gain(base, chords_[i].real_ends[0]) + gain(base, chords_[i].real_ends[1]);
      doubt = std::max<Real>(doubt, 2 * rounding_);
    }
    return scores;
  }

  /// f(p): the larger value of two edges.
  Real gain(Base& base, const RealVec& p) {
    std::optional<Real> largest;
    for (const auto& [h1, h2] : base.edges_of(p)) {
      const Real by_edge = gain(h1, h2, p);
      if (!largest || by_edge > *largest) largest = by_edge;
    }
    return largest.value_or(0);
  }
  Real gain(const RealVec& h1, const RealVec& h2, const RealVec& p) {
    switch (problem_.metric) {
      case Metric::area:
        return area_metric(shape_, h1, h2, p);
      case Metric::circle:
        return circle_metric(h1, h2, p);
      case Metric::distance:
        break;
    }
    return distance_metric(shape_, h1, h2, p, unit_, rounding_, calls_);
  }

  void take(std::size_t i, double score) {
    result_.teams.push_back(i);
    result_.scores.push_back(score);
    left_.erase(std::find(left_.begin(), left_.end(), i));
  }

  const Problem& problem_;
  const ExactShape& shape_;
  const std::vector<ExactChord>& chords_;
  std::vector<std::size_t> left_;
  Selection result_;
  Calls calls_;
  Real unit_;          // the rounding error of a position
  Real rounding_ = 0;  // the resulting error of the current score
};

}  // namespace

Selection select(const Problem& problem, const CandidateList& list) {
  return Selector(problem, list).run();
}

Scores scores(const Problem& problem, const CandidateList& list,
              const std::vector<std::size_t>& teams) {
  return Selector(problem, list).scores_after(teams);
}

}  // namespace oracle
