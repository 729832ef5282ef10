#include "trace/step_rows.h"

#include <algorithm>

namespace evenlift {

std::vector<Figure> StepFigures::take() && {
  add(FigureKind::centre, Points{centre_.value_or(trace_.centre)});
  return std::move(figures_);
}

void StepFigures::add(FigureKind kind, Points points, std::optional<std::uint32_t> item,
                      double value) {
  if (!points.empty()) figures_.push_back({kind, std::move(points), item, value});
}

void StepFigures::add(FigureKind kind, const Chord& chord, std::optional<std::uint32_t> item,
                      double value) {
  add(kind, Points{chord.r1.position, chord.r2.position}, item, value);
}

void StepFigures::add_edge(FigureKind kind, std::uint32_t edge) {
  add(kind, Points{trace_.polygon().edge_start(edge), trace_.polygon().edge_end(edge)}, edge);
}

// --- The object ----------------------------------------------------------------------------------

void StepFigures::polygon() {
  add(FigureKind::object, trace_.polygon().vertices());
  const std::vector<Polygon>& holes = trace_.object().holes();
  for (std::uint32_t i = 0; i < holes.size(); ++i) add(FigureKind::hole, holes[i].vertices(), i);
}

// Fans of triangles, whose areas add up to the object's.
void StepFigures::centroid() {
  const std::vector<Polygon>& holes = trace_.object().holes();
  add_fan(trace_.polygon(), {});
  for (std::uint32_t i = 0; i < holes.size(); ++i) add_fan(holes[i], i);
  centre();
}

// From vertex 1 of the outline or a hole. Triangles of the outline that fold back are subtracted,
// as are those of a hole that do not.
void StepFigures::add_fan(const Polygon& ring, std::optional<std::uint32_t> hole) {
  const Points& v = ring.vertices();
  const bool adds = ring.counter_clockwise() != hole.has_value();
  const double whole = (adds ? 2 : -2) * trace_.object().area();
  for (std::uint32_t i = 1; i + 1 < v.size(); ++i)
    add(hole ? FigureKind::hole_part : FigureKind::triangle, Points{v[0], v[i], v[i + 1]},
        hole.value_or(i), cross(v[i] - v[0], v[i + 1] - v[0]) / whole);
}

void StepFigures::centre() { add(FigureKind::centroid, Points{trace_.object().centroid()}); }

// --- Chords from the vertices --------------------------------------------------------------------

void StepFigures::radial() {
  for (const std::uint32_t edge : trace_.radial_edges) add_edge(FigureKind::radial_edge, edge);
}

void StepFigures::ray() {
  const Trace::Rays& rays = trace_.rays;
  const std::uint32_t vertex = rays.vertices[item_];
  const Vec2 &from = trace_.polygon().vertex(vertex), away = trace_.centre - from;
  const Vec2 end = trace_.centre + trace_.polygon().diagonal() / length(away) * away;
  add(FigureKind::ray, Points{from, end}, vertex);
  for (std::uint32_t i = rays.begins[item_]; i < rays.begins[item_ + 1]; ++i) add_vertex_chord(i);
  add(FigureKind::vertex, Points{from}, vertex);
}

void StepFigures::add_vertex_chord(std::uint32_t index) {
  const Chord& chord = trace_.rays.chords[index].chord;
  add(FigureKind::chord, chord, index, chord.ratio);
}

void StepFigures::slopes() {
  for (const std::uint32_t chord : chords_by_slope(trace_)) add_vertex_chord(chord);
}

// --- Pairs and candidates ------------------------------------------------------------------------

void StepFigures::sections() { add_pair(false); }

void StepFigures::outcome() {
  const PairDetail& pair = *detail_.pair;
  add_pair(true);
  if (pair.meeting)
    add(FigureKind::bisecting, Points{*pair.meeting, 2 * trace_.centre - *pair.meeting}, {}, 1);
  add(FigureKind::chosen, pair.chosen, pair.candidate, pair.chosen.ratio);
}

void StepFigures::add_pair(bool reflected) {
  const PairDetail& pair = *detail_.pair;
  add_edge(FigureKind::edge, pair.pair.a);
  add_edge(FigureKind::edge, pair.pair.b);
  add(FigureKind::section, Points{pair.a[0], pair.a[1]}, pair.pair.a);
  add(FigureKind::section, Points{pair.b[0], pair.b[1]}, pair.pair.b);
  if (reflected)
    add(FigureKind::reflected, Points{pair.reflected[0], pair.reflected[1]}, pair.pair.b);
  for (std::uint32_t end = 0; end < 2; ++end)
    add(FigureKind::section_end, pair.ends[end], end, pair.ends[end].ratio);
}

void StepFigures::opposite() {
  const OppositeDetail& opposite = *detail_.opposite;
  add(FigureKind::chosen, opposite.chord, opposite.candidate, opposite.chord.ratio);
  for (const std::uint32_t vertex : {opposite.vertices.v, opposite.vertices.w})
    add(FigureKind::vertex, Points{trace_.polygon().vertex(vertex)}, vertex);
}

void StepFigures::candidates() {
  const std::vector<Candidate>& all = placement_.candidates;
  for (std::uint32_t i = 0; i < all.size(); ++i)
    add(FigureKind::candidate, all[i].chord, i, all[i].chord.ratio);
}

// --- Teams ---------------------------------------------------------------------------------------

void StepFigures::scores() {
  add(FigureKind::base_before, detail_.base_before);
  for (std::uint32_t i = 0; i < placement_.candidates.size(); ++i) {
    const Score& score = detail_.scores->of_candidate[i];
    if (!score.taken) add(FigureKind::candidate, placement_.candidates[i].chord, i, score.value);
  }
}

void StepFigures::team() {
  add(FigureKind::base_before, detail_.base_before);
  if (detail_.scores && item_ > 0) {
    const std::uint32_t winner = trace_.selected()[item_];
    for (Figure& figure : gain_figures(trace_, *detail_.scores, winner))
      figures_.push_back(std::move(figure));
  }
  add_team(item_, false);
}

void StepFigures::base() {
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_team(item_, false);
}

void StepFigures::range() {
  const RangeDetail& range = *detail_.range;
  add_edge(FigureKind::edge, range.pair.a);
  add_edge(FigureKind::edge, range.pair.b);
  const Vec2 &c = trace_.centre, first = range.range.a0, last = range.range.a1;
  const auto on_a = [&](double x) { return Vec2((1 - x) * first + x * last); };
  const double from = range.range.first, to = range.range.last;
  add(FigureKind::range, Points{c, c + on_a(from), c + on_a(to)}, range.pair.a);
  add(FigureKind::range,
      Points{c, c - on_a(from) / range.range.q(from), c - on_a(to) / range.range.q(to)},
      range.pair.b);
  for (std::uint32_t end = 0; end < 2; ++end)
    add(FigureKind::range_end, range.ends[end], end, range.ends[end].ratio);
  for (const std::uint32_t i : range.candidates)
    if (i != no_index)
      add(FigureKind::candidate, placement_.candidates[i].chord, i,
          placement_.candidates[i].chord.ratio);
}

void StepFigures::swap() {
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  for (const std::uint32_t i : detail_.swap->from) {
    const Chord& chord = placement_.candidates[i].chord;
    add(FigureKind::former, chord, i, chord.ratio);
  }
  add_teams(trace_.stages[item_ + 1]);
}

void StepFigures::held() { add_teams(placement_.teams); }

void StepFigures::add_teams(const std::vector<Team>& teams) {
  std::uint32_t number = 0;
  for (std::uint32_t i = 0; i < teams.size(); ++i) {
    add(FigureKind::team, chord_of(teams[i]), i, teams[i].ratio);
    for (const Robot& robot : teams[i].robots)
      add(FigureKind::robot, Points{robot.point.position}, number++, 0);
  }
}

void StepFigures::share() { add_team(item_, true); }

void StepFigures::loads() {
  if (trace_.given()) return add_supports(placement_.loads.has_value());
  if (trace_.balanced()) {
    if (!detail_.balanced) return;  // no robots
    add_arms();
    return add_balanced(placement_.loads->max);
  }
  for (std::uint32_t i = 0; i < placement_.teams.size(); ++i) add_team(i, true);
}

void StepFigures::add_team(std::uint32_t index, bool loaded) {
  const Team& team = (loaded ? placement_.teams : trace_.selected_teams())[index];
  add(FigureKind::team, chord_of(team), index, team.ratio);
  auto number = static_cast<std::uint32_t>(index * team.robots.size());
  for (const Robot& robot : team.robots)
    add(FigureKind::robot, Points{robot.point.position}, number++, loaded ? robot.load : 0);
}

// --- What holds the object -----------------------------------------------------------------------

void StepFigures::coverage() {
  polygon();
  add(FigureKind::base, placement_.lifting_base);
}

void StepFigures::contacts() {
  add_regions(detail_.clockwise, detail_.counterclockwise);
  add_contacts(trace_.contacts.size());
}

// The contacts up to the one that cuts, with its edge and normal line.
void StepFigures::cut() {
  const Contact& contact = trace_.contacts[item_];
  add_regions(detail_.clockwise, detail_.counterclockwise);
  add_contacts(item_);
  add_edge(FigureKind::edge, contact.edge);
  const Vec2 reach =
      100 * trace_.polygon().diagonal() * inward_normal(trace_.polygon(), contact.edge);
  add(FigureKind::normal, Points{contact.position - reach, contact.position + reach}, item_);
  add(FigureKind::contact, Points{contact.position}, item_);
}

void StepFigures::slide() {
  add_contacts(trace_.contacts.size());
  if (const auto& way = placement_.closure.translation)
    add(FigureKind::translation,
        Points{trace_.centre, trace_.centre + 0.25 * trace_.polygon().diagonal() * *way});
}

void StepFigures::closure() {
  add_regions(placement_.closure.clockwise, placement_.closure.counterclockwise);
  add_contacts(trace_.contacts.size());
}

void StepFigures::result() {
  coverage();
  add_regions(placement_.closure.clockwise, placement_.closure.counterclockwise);
  loads();
}

void StepFigures::add_regions(const FreeRegion& clockwise, const FreeRegion& counterclockwise) {
  add(FigureKind::clockwise, clockwise.clipped);
  add(FigureKind::counterclockwise, counterclockwise.clipped);
}

void StepFigures::add_contacts(std::size_t number) {
  for (std::uint32_t i = 0; i < number; ++i)
    add(FigureKind::contact, Points{trace_.contacts[i].position}, i);
}

void StepFigures::add_balanced(double load) {
  const BalancedDetail& balanced = *detail_.balanced;
  for (std::size_t i = 0; i < balanced.robots.size(); ++i)
    add(FigureKind::robot, Points{balanced.robots[i].position}, balanced.numbers[i], load);
}

void StepFigures::add_arms() {
  const BalancedDetail& balanced = *detail_.balanced;
  for (std::size_t i = 0; i < balanced.robots.size(); ++i)
    add(FigureKind::arm, Points{trace_.centre, balanced.robots[i].position}, balanced.numbers[i]);
}

void StepFigures::lever() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  add(FigureKind::lever, positions(robots));
  add_balanced(placement_.weight() / 2);
}

void StepFigures::three() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const Vec2 middle = (robots[0].position + robots[1].position) / 2;
  add(FigureKind::side, Points{robots[0].position, robots[1].position});
  add(FigureKind::lever, Points{robots[2].position, middle});
  add(FigureKind::middle, Points{middle});
  add_balanced(placement_.weight() / 3);
}

// The arms; then the arms, divided by the number of robots, end to end.
void StepFigures::many() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const auto number = static_cast<double>(robots.size());
  Points sum{trace_.centre};
  for (std::size_t i = 0; i + 1 < robots.size(); ++i)
    sum.push_back(sum.back() + (robots[i].position - trace_.centre) / number);
  add_arms();
  add(FigureKind::sum, std::move(sum));
  add_balanced(placement_.weight() / number);
}

void StepFigures::rest() {
  const BalancedDetail& balanced = *detail_.balanced;
  add_balanced(0);
  if (balanced.stand) add(FigureKind::stand, Points{balanced.stand->position});
  add(FigureKind::middle, Points{balanced.middle});
}

void StepFigures::mirror() {
  const Vec2& middle = detail_.balanced->middle;
  Points turned;
  for (const Vec2& vertex : trace_.polygon().vertices()) turned.push_back(2 * middle - vertex);
  add(FigureKind::mirrored, std::move(turned));
  add_even_chords();
  rest();
}

void StepFigures::completion() {
  add(FigureKind::base, detail_.base);
  add_completion();
}

void StepFigures::add_completion() {
  add_even_chords();
  const BalancedDetail& balanced = *detail_.balanced;
  if (balanced.chords.empty()) return;  // the set was found at once
  const Chord& chosen = balanced.chords[balanced.chosen];
  add(FigureKind::chosen, chosen, balanced.chosen, chosen.ratio);
  rest();
}

void StepFigures::add_even_chords() {
  const std::vector<Chord>& chords = detail_.balanced->chords;
  for (std::uint32_t i = 0; i < chords.size(); ++i)
    add(FigureKind::even_chord, chords[i], i, chords[i].ratio);
}

void StepFigures::start() {
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_arms();
  add_completion();
}

void StepFigures::exchange() {
  const BalancedDetail& balanced = *detail_.balanced;
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_arms();
  for (std::size_t i = 0; i < balanced.moved.size(); ++i) {
    add(FigureKind::way, Points{balanced.ways[2 * i], balanced.ways[2 * i + 1]});
    add(FigureKind::left, Points{balanced.ways[2 * i]}, balanced.moved[i]);
  }
  add_balanced(0);
}

void StepFigures::round() {
  add(FigureKind::base, detail_.base);
  add_arms();
  add_balanced(0);
}

void StepFigures::failure() {
  const BalancedDetail& balanced = *detail_.balanced;
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  add_arms();
  const Robot& failed = placement_.teams[0].robots[*balanced.failed];
  add(FigureKind::left, Points{failed.point.position}, balanced.failed);
  for (std::size_t i = 0; i < balanced.robots.size(); ++i)
    add(FigureKind::robot, Points{balanced.robots[i].position}, balanced.numbers[i],
        balanced.loads.empty() ? 0 : balanced.loads[i]);
}

void StepFigures::pairs() {
  const Placement& pairs = *trace_.in_pairs;
  add(FigureKind::base_before, detail_.base_before);
  add(FigureKind::base, detail_.base);
  for (std::uint32_t i = 0; i < pairs.teams.size(); ++i)
    add(FigureKind::team, chord_of(pairs.teams[i]), i, pairs.teams[i].ratio);
}

}  // namespace evenlift
