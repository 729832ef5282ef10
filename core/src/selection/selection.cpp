#include "evenlift/selection.h"

#include <algorithm>

#include "chords/radial_view.h"
#include "evenlift/angles.h"
#include "evenlift/random.h"
#include "selection/equal_angles.h"
#include "selection/greedy_selector.h"

namespace evenlift {
namespace {

using Edges = std::vector<std::uint32_t>;

double angle_of(const Polygon& polygon, const Vec2& centre, std::uint32_t vertex, bool forward) {
  const Vec2 u = forward ? polygon.vertex(vertex) - centre : centre - polygon.vertex(vertex);
  return arctangent2(u.y, u.x);
}

Vec2 direction(double angle) { return {cosine(angle), sine(angle)}; }

// An open range of directions, from the angle `from` to `to` in [0, pi], in which lines through C
// meet the same edges ahead of C and behind it.
class Opening {
 public:
  Opening(const RayCaster& rays, double from, double to, const Edges& ahead, const Edges& behind)
      : rays_(rays), from_(from), to_(to), ahead_(&ahead), behind_(&behind) {}

  Chord chord_at(double angle) {
    if (++chords_ == worth_narrowing) {
      narrowed_ahead_ = far_ones(*ahead_, 1);
      narrowed_behind_ = far_ones(*behind_, -1);
      ahead_ = &narrowed_ahead_;
      behind_ = &narrowed_behind_;
    }
    const Vec2 u = direction(angle);
    const RayCaster::Hit first = rays_.farthest(u, *ahead_), second = rays_.farthest(-u, *behind_);
    return order_ends(first.point, first.distance, second.point, second.distance, u);
  }

 private:
  static constexpr int worth_narrowing = 4;  // chords; narrowing costs about two

  // The edges that could be farthest from C on a line of the opening, in the same order. An edge's
  // distance is greatest at an end of the opening, and nowhere less than the lesser distance at an
  // end times the cosine of the width. A margin keeps ties in spite of rounding.
  Edges far_ones(const Edges& edges, double side) const {
    const double width = to_ - from_;
    if (edges.size() < 2 || width > 1) return edges;
    const Vec2 u = side * direction(from_), v = side * direction(to_);
    const auto at = [&](const Vec2& along, std::uint32_t edge) {
      return rays_.hit_on(along, edge).distance;
    };
    double reached = 0;
    for (const std::uint32_t edge : edges)
      reached = std::max(reached, std::min(at(u, edge), at(v, edge)));
    const double least = reached * cosine(width) * (1 - 1e-6);
    Edges far;
    for (const std::uint32_t edge : edges)
      if (std::max(at(u, edge), at(v, edge)) >= least) far.push_back(edge);
    return far;
  }

  const RayCaster& rays_;
  double from_, to_;
  const Edges* ahead_;
  const Edges* behind_;
  Edges narrowed_ahead_, narrowed_behind_;
  int chords_ = 0;
};

}  // namespace

EqualAngles::EqualAngles(const Polygon& polygon, const Vec2& centre)
    : polygon_(polygon), centre_(centre), view_(polygon, centre), rays_(polygon, centre) {
  for_each_opening(
      [&](double from, double to, const Edges&, const Edges&) { measure_ += to - from; });
}

// Calls visit(from, to, edges ahead, edges behind) by ascending angle.
template <class VisitOpening>
void EqualAngles::for_each_opening(VisitOpening visit) const {
  RadialSweep sweep(polygon_, view_);
  double from = 0;
  const auto close_at = [&](double to) {
    if (!sweep.ahead().empty() && !sweep.behind().empty() && to > from)
      visit(from, to, sweep.ahead(), sweep.behind());
    from = to;
  };
  for (std::uint32_t group = 0; group < view_.direction_count(); ++group) {
    const std::uint32_t vertex = view_.order()[view_.group_begin(group)];
    close_at(angle_of(polygon_, centre_, vertex, view_.forward(vertex)));
    sweep.leave(group);
    sweep.enter(group, [](std::uint32_t, bool) {});
  }
  close_at(pi);
}

void EqualAngles::for_each_chord(const std::vector<std::uint32_t>& numbers,
                                 const Visit& visit) const {
  if (!has_chords()) return;
  struct Progress {
    std::size_t i;
    double teams;
    double next = 0;  // the number of the next chord
    bool done = false;
  };
  std::vector<Progress> all;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] > 0) all.push_back({i, static_cast<double>(numbers[i])});

  double before = 0;  // measure of the previous openings
  for_each_opening([&](double from, double to, const Edges& ahead, const Edges& behind) {
    // A target between two openings belongs to the lower one. The last opening takes all that
    // remain, so rounding loses none.
    const double after = before + (to - from);
    Opening opening(rays_, from, to, ahead, behind);
    for (Progress& number : all) {
      while (!number.done) {
        const double target = measure_ * ((number.next + 0.5) / number.teams);
        if (target > after && after < measure_) break;
        const double angle = std::min(from + std::max(0.0, target - before), to);
        const bool goes_on = visit(number.i, opening.chord_at(angle));
        number.done = ++number.next == number.teams || !goes_on;
      }
    }
    std::erase_if(all, [](const Progress& number) { return number.done; });
    before = after;
  });
}

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
