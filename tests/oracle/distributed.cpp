// Equal angles (algorithm.md, "Distributed"), over directions whose line meets the boundary on both
// sides of C. Sines and arctangents have 100 digits.
#include "oracle/exact.h"

#include <algorithm>

namespace oracle {
namespace {

class Spread {
 public:
  explicit Spread(const ExactShape& shape) : shape_(shape) {
    const std::size_t n = shape.real_vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const RealVec &p = shape.real_vertices[i], &q = shape.real_vertices[(i + 1) % n];
      const Real turn = cross(p, q);
      if (abs(turn) <= tau * shape.size * length(q - p)) continue;  // radial
      edges_.push_back(turn > 0 ? std::array<RealVec, 2>{p, q} : std::array<RealVec, 2>{q, p});
    }
  }

  DistributedTeams teams(int count) const {
    std::vector<Real> breaks{0, pi()};
    for (const RealVec& v : shape_.real_vertices) {
      if (v == RealVec{0, 0}) continue;
      Real angle = atan2(v.y, v.x);
      if (angle < 0) angle += pi();
      breaks.push_back(angle);
    }
    std::sort(breaks.begin(), breaks.end());
    std::vector<std::array<Real, 2>> parts;  // of V, upward
    Real measure = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const RealVec u = direction((breaks[i] + breaks[i + 1]) / 2);
      if (breaks[i] == breaks[i + 1] || !farthest(u) || !farthest(-u)) continue;
      parts.push_back({breaks[i], breaks[i + 1]});
      measure += breaks[i + 1] - breaks[i];
    }
    DistributedTeams result;
    result.measure = static_cast<double>(measure);
    for (int k = 0; k < count; ++k) {
      Real left = measure * (2 * k + 1) / (2 * count);
      for (const auto& [from, to] : parts) {
        if (left > to - from + slip) {
          left -= to - from;
          continue;
        }
        add(result,
            direction(from +
                      left));  // if a target is where two parts of V meet, the end of the lower one
        break;
      }
    }
    return result;
  }

 private:
  inline static const Real slip =
      Real("1e-60");  // far above the rounding of 100 digits: a part includes its rim
  static Real pi() { return boost::math::constants::pi<Real>(); }
  static RealVec direction(const Real& angle) { return {cos(angle), sin(angle)}; }

  /// How far the boundary reaches from C in direction u.
  std::optional<Real> farthest(const RealVec& u) const {
    std::optional<Real> best;
    for (const auto& [p, q] : edges_) {
      if (cross(p, u) < -slip * shape_.size || cross(u, q) < -slip * shape_.size) continue;
      const Real distance = cross(p, q - p) / cross(u, q - p);
      if (distance > 0 && (!best || distance > *best)) best = distance;
    }
    return best;
  }

  void add(DistributedTeams& result, const RealVec& u) const {
    const std::optional<Real> ahead = farthest(u), behind = farthest(-u);
    if (!ahead || !behind) return;
    const RealVec centre = real(shape_.centre), p = centre + u * *ahead, q = centre - u * *behind;
    result.chords.push_back({Point{static_cast<double>(p.x), static_cast<double>(p.y)},
                             Point{static_cast<double>(q.x), static_cast<double>(q.y)}});
    Real nearest = 1, steepest = 1;
    for (const RealVec& v : shape_.real_vertices)
      if (!(v == RealVec{0, 0})) nearest = std::min<Real>(nearest, abs(cross(u, v)) / length(v));
    for (const auto& [a, b] : edges_)
      if (const RealVec along = b - a; cross(a, u) * cross(b, u) <= 0)
        steepest = std::min<Real>(steepest, abs(cross(u, along)) / length(along));
    result.nearest_vertex.push_back(static_cast<double>(nearest));
    result.flattest_hit.push_back(static_cast<double>(steepest));
  }

  const ExactShape& shape_;
  std::vector<std::array<RealVec, 2>> edges_;
};

}  // namespace

DistributedTeams distributed(const Problem& problem) {
  return Spread(*exact_shape(problem)).teams(problem.teams);
}

}  // namespace oracle
