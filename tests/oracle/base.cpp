#include "oracle/exact.h"

#include <algorithm>

namespace oracle {

std::vector<ExactVec> convex_hull(std::vector<ExactVec> points) {
  const auto before = [](const ExactVec& a, const ExactVec& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // The lower chain left to right, then the upper one back; a corner is a strict left turn.
  const auto chain = [](auto first, auto last) {
    std::vector<ExactVec> c;
    for (auto p = first; p != last; ++p) {
      while (c.size() >= 2 && orient(c[c.size() - 2], c.back(), *p) <= 0) c.pop_back();
      c.push_back(*p);
    }
    c.pop_back();
    return c;
  };
  std::vector<ExactVec> hull = chain(points.begin(), points.end());
  const std::vector<ExactVec> upper = chain(points.rbegin(), points.rend());
  hull.insert(hull.end(), upper.begin(), upper.end());
  return hull;
}

Real outside(const RealVec& v, const RealVec& p, const RealVec& q) {
  return cross(v - p, q - p) / length(q - p);
}

namespace {

using Corners = std::vector<RealVec>;

bool within_one_line(const Corners& corners, const Real& size, Calls& calls) {
  if (corners.size() < 3) return true;
  // A convex polygon's least width is attained with an edge on one side.
  Real width = -1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Real extent = 0;
    for (const RealVec& c : corners)
      extent = std::max(extent, Real(-outside(c, corners[i], corners[(i + 1) % corners.size()])));
    if (width < 0 || extent < width) width = extent;
  }
  return calls.within(width, 2 * tau * size, "H is a segment");
}

Corners farthest_two(const Corners& corners) {
  Corners ends{corners[0], corners[0]};
  for (const RealVec& a : corners)
    for (const RealVec& b : corners)
      if (length(a - b) > length(ends[0] - ends[1])) ends = {a, b};
  return ends;
}

/// Whether corner i is one only by rounding: at a neighbour's place, or straight. A thin hull's tip
/// is near the line of its neighbours, but not between them.
bool is_superfluous(const Corners& corners, std::size_t i, const Real& size, Calls& calls) {
  const std::size_t n = corners.size();
  const RealVec &a = corners[(i + n - 1) % n], &b = corners[(i + 1) % n];
  for (const RealVec& neighbour : {a, b})
    if (calls.within(length(corners[i] - neighbour), tau * size, "two corners of H at one place"))
      return true;
  const Real along = dot(corners[i] - a, b - a);
  return along >= 0 && along <= dot(b - a, b - a) &&
         calls.within(abs(outside(corners[i], a, b)), tau * length(b - a), "straight corner of H");
}

}  // namespace

std::vector<RealVec> lifting_base(const std::vector<ExactVec>& points, const Real& size,
                                  Calls& calls) {
  Corners corners;
  for (const ExactVec& corner : convex_hull(points)) corners.push_back(real(corner));
  if (within_one_line(corners, size, calls)) return farthest_two(corners);
  for (std::size_t i = 0; i < corners.size() && corners.size() > 3;) {
    if (is_superfluous(corners, i, size, calls)) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
  return corners;
}

Real signed_area(const std::vector<RealVec>& polygon) {
  Real sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum / 2;
}

Real common_area(const std::vector<RealVec>& polygon, const std::vector<RealVec>& convex) {
  // Cut by half-planes in turn. Separated parts stay joined by edges traversed both ways, without
  // area.
  std::vector<RealVec> rest = polygon;
  for (std::size_t i = 0; i < convex.size() && !rest.empty(); ++i) {
    const RealVec& a = convex[i];
    const RealVec along = convex[(i + 1) % convex.size()] - a;
    std::vector<RealVec> kept;
    RealVec p = rest.back();
    Real p_side = cross(along, p - a);
    for (const RealVec& q : rest) {
      const Real q_side = cross(along, q - a);
      if ((p_side > 0 && q_side < 0) || (p_side < 0 && q_side > 0))
        kept.push_back(p + (q - p) * (p_side / (p_side - q_side)));
      if (q_side >= 0) kept.push_back(q);
      p = q;
      p_side = q_side;
    }
    rest = std::move(kept);
  }
  return rest.size() < 3 ? Real(0) : signed_area(rest);
}

Real area_within(const ExactShape& shape, const std::vector<RealVec>& convex) {
  Real area = common_area(shape.real_vertices, convex);
  for (const std::vector<RealVec>& hole : shape.holes) area -= common_area(hole, convex);
  return area;
}

Real distance_to_segment(const RealVec& p, const RealVec& a, const RealVec& b) {
  const RealVec along = b - a;
  const Real squared = dot(along, along);
  if (squared == 0) return length(p - a);
  const Real where = std::clamp<Real>(dot(p - a, along) / squared, 0, 1);
  return length(p - (a + along * where));
}

namespace {

std::optional<Loads> loads(const Problem& problem, const std::vector<const ExactChord*>& teams) {
  if (teams.empty()) return std::nullopt;
  Loads result;
  const Real each = Real(problem.weight) / static_cast<int>(teams.size());
  Real least = -1, most = 0, sum = 0, share = 0;
  for (const ExactChord* team : teams) {
    // By the arms: between opposite vertices C is near the chord, and the arms need not add up to
    // its length.
    const Real arm0 = length(team->real_ends[0]), arm1 = length(team->real_ends[1]);
    const Real fraction = arm1 / (arm0 + arm1), other = 1 - fraction;  // of the first end
    result.of_teams.push_back(
        {static_cast<double>(each * fraction), static_cast<double>(each * other)});
    for (const Real& f : {fraction, other}) {
      least = least < 0 ? each * f : std::min<Real>(least, each * f);
      most = std::max<Real>(most, each * f);
      share = std::max(share, f);
      sum += each * f;
    }
  }
  result.min = static_cast<double>(least);
  result.mean = static_cast<double>(sum / static_cast<int>(2 * teams.size()));
  result.max = static_cast<double>(most);
  result.spread = static_cast<double>(most - least);
  result.max_share = static_cast<double>(share);
  return result;
}

}  // namespace

Judgement judge(const Problem& problem, const CandidateList& list,
                const std::vector<std::size_t>& teams) {
  const ExactShape& shape = *list.shape;
  std::vector<const ExactChord*> placed;
  std::vector<ExactVec> points;
  std::vector<RealVec> real_points;
  for (std::size_t i : teams) {
    placed.push_back(&list.chords->chords[i]);
    for (std::size_t e : {0u, 1u}) {
      points.push_back(placed.back()->ends[e]);
      real_points.push_back(placed.back()->real_ends[e]);
    }
  }
  Judgement result;
  Calls calls;
  const std::vector<RealVec> base =
      points.empty() ? Corners{} : lifting_base(points, shape.size, calls);
  for (const RealVec& corner : base)
    result.hull.push_back({static_cast<double>(corner.x + Real(shape.centre.x)),
                           static_cast<double>(corner.y + Real(shape.centre.y))});
  if (base.size() >= 3)
    result.coverage = static_cast<double>(area_within(shape, base) / shape.area);
  result.loads = loads(problem, placed);
  result.closure = immobilization(shape, real_points);
  result.closure.closest_call.merge(calls.closest());
  return result;
}

}  // namespace oracle
