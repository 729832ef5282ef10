#include "evenlift/selection.h"

#include <algorithm>

#include "chords/ray_caster.h"
#include "chords/section.h"
#include "evenlift/random.h"
#include "selection/equal_angles.h"
#include "selection/greedy_selector.h"

namespace evenlift {
namespace {

Chord make_chord(const RayCaster::Hit& ahead, const RayCaster::Hit& behind, const Vec2& direction) {
  return order_ends(ahead.point, ahead.distance, behind.point, behind.distance, direction);
}

}  // namespace

std::vector<std::uint32_t> select_teams(const PolygonWithHoles& object, const Vec2& centre,
                                        const std::vector<Candidate>& candidates, Metric metric,
                                        std::size_t teams, FirstTeam first, const Stands* stands) {
  Selector selector(object, centre, candidates, metric, first, stands);
  while (selector.taken().size() < teams && selector.take_next()) {
  }
  return selector.taken();
}

std::vector<double> scores(const PolygonWithHoles& object, const Vec2& centre,
                           const std::vector<Candidate>& candidates,
                           const std::vector<std::uint32_t>& selected, Metric metric) {
  Selector selector(object, centre, candidates, metric);
  for (const std::uint32_t candidate : selected) selector.take(candidate);
  std::vector<double> scores(candidates.size());
  for (std::uint32_t i = 0; i < candidates.size(); ++i) scores[i] = selector.score(i);
  return scores;
}

double open_directions_rad(const Polygon& polygon, const Vec2& centre) {
  return EqualAngles(polygon, centre).measure_rad();
}

std::vector<Chord> distributed_teams(const Polygon& polygon, const Vec2& centre,
                                     std::size_t teams) {
  std::vector<Chord> chords;
  chords.reserve(teams);
  EqualAngles(polygon, centre)
      .for_each_chord({static_cast<std::uint32_t>(teams)}, [&](std::size_t, const Chord& chord) {
        chords.push_back(chord);
        return true;
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
    if (arm == 0) continue;  // at C itself
    const auto across = rays.hits(-offset);
    if (across.empty()) continue;
    const auto choice = static_cast<std::size_t>(rng.below(across.size()));
    chords.push_back(make_chord({arm, {centre + offset, edge}}, across[choice], offset));
    draws = 0;
  }
  return chords;
}

}  // namespace evenlift
