#include "evenlift/selection.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/predicates.h"
#include "evenlift/random.h"
#include "evenlift/tolerance.h"
#include "radial_view.h"
#include "ray_caster.h"
#include "section.h"
#include "selector.h"

namespace evenlift {
namespace {

Chord make_chord(const RayCaster::Hit& ahead, const RayCaster::Hit& behind, const Vec2& direction) {
  return order_ends(ahead.point, ahead.distance, behind.point, behind.distance, direction);
}

double angle_of(const Polygon& polygon, const Vec2& centre, std::uint32_t vertex, bool forward) {
  const Vec2 u = forward ? polygon.vertex(vertex) - centre : centre - polygon.vertex(vertex);
  return arctangent2(u.y(), u.x());
}

// Visits, by rising angle within [0, pi], the open ranges of directions whose lines through C meet
// the same edges, on both sides of C, as visit(from, to, edges ahead, edges behind).
template <class Visit>
void for_each_opening(const Polygon& polygon, const Vec2& centre, Visit visit) {
  const RadialView view(polygon, centre);
  RadialSweep sweep(polygon, view);
  double from = 0;
  const auto close_at = [&](double to) {
    if (!sweep.ahead().empty() && !sweep.behind().empty() && to > from)
      visit(from, to, sweep.ahead(), sweep.behind());
    from = to;
  };
  for (std::uint32_t group = 0; group < view.turns(); ++group) {
    const std::uint32_t vertex = view.order()[view.group_begin(group)];
    close_at(angle_of(polygon, centre, vertex, view.forward(vertex)));
    sweep.leave(group);
    sweep.enter(group, [](std::uint32_t, bool) {});
  }
  close_at(pi);
}

}  // namespace

std::vector<std::uint32_t> select_teams(const Polygon& polygon, const Vec2& centre,
                                        const std::vector<Candidate>& candidates, Metric metric,
                                        std::size_t teams) {
  Selector selector(polygon, centre, candidates, metric);
  while (selector.taken().size() < teams && selector.take_next()) {
  }
  return selector.taken();
}

std::vector<double> scores(const Polygon& polygon, const Vec2& centre,
                           const std::vector<Candidate>& candidates,
                           const std::vector<std::uint32_t>& selected, Metric metric) {
  Selector selector(polygon, centre, candidates, metric);
  for (const std::uint32_t candidate : selected) selector.take(candidate);
  std::vector<double> scores(candidates.size());
  for (std::uint32_t i = 0; i < candidates.size(); ++i) scores[i] = selector.score(i);
  return scores;
}

double open_directions_rad(const Polygon& polygon, const Vec2& centre) {
  double measure = 0;
  for_each_opening(polygon, centre,
                   [&](double from, double to, const auto&, const auto&) { measure += to - from; });
  return measure;
}

std::vector<Chord> distributed_teams(const Polygon& polygon, const Vec2& centre,
                                     std::size_t teams) {
  const double measure = open_directions_rad(polygon, centre);
  if (measure <= tau) return {};  // nothing but what rounding leaves between radial edges

  const RayCaster rays(polygon, centre);
  std::vector<Chord> chords;
  chords.reserve(teams);
  double before = 0;  // measure of the openings before the current one
  for_each_opening(
      polygon, centre, [&](double from, double to, const auto& ahead, const auto& behind) {
        // A target on the rim between two openings belongs to the lower one. Rounding of the sums
        // must not lose the last.
        const double after = before + (to - from);
        for (; chords.size() < teams;) {
          const double target =
              measure * ((static_cast<double>(chords.size()) + 0.5) / static_cast<double>(teams));
          if (target > after && after < measure) break;
          const double angle = std::min(from + std::max(0.0, target - before), to);
          const Vec2 u(cosine(angle), sine(angle));
          chords.push_back(make_chord(rays.farthest(u, ahead), rays.farthest(-u, behind), u));
        }
        before = after;
      });
  return chords;
}

std::vector<Chord> random_teams(const Polygon& polygon, const Vec2& centre, std::size_t teams,
                                std::uint64_t seed) {
  std::vector<double> ends;  // of each edge, along the perimeter
  ends.reserve(polygon.size());
  double perimeter = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    perimeter += length(polygon.edge_end(i) - polygon.edge_start(i));
    ends.push_back(perimeter);
  }
  const RayCaster rays(polygon, centre);
  Rng rng(seed);
  std::vector<Chord> chords;
  chords.reserve(teams);
  constexpr int most_draws = 100000;
  for (int draws = 0; chords.size() < teams && draws < most_draws; ++draws) {
    const double along = rng.uniform() * perimeter;
    const auto edge = static_cast<std::uint32_t>(
        std::min<std::ptrdiff_t>(std::upper_bound(ends.begin(), ends.end(), along) - ends.begin(),
                                 static_cast<std::ptrdiff_t>(ends.size()) - 1));
    const double before = edge == 0 ? 0 : ends[edge - 1];
    const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
    const Vec2 offset = (p - centre) + ((along - before) / (ends[edge] - before)) * (q - p);
    const double arm = length(offset);
    if (arm == 0) continue;  // on C itself
    const auto across = rays.hits(-offset);
    if (across.empty()) continue;
    const auto choice = static_cast<std::size_t>(rng.below(across.size()));
    chords.push_back(make_chord({arm, {centre + offset, edge}}, across[choice], offset));
    draws = 0;
  }
  return chords;
}

}  // namespace evenlift
