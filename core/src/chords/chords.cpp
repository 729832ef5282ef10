#include "evenlift/chords.h"

#include "chords/opposite_vertices.h"
#include "chords/radial_view.h"
#include "chords/section.h"

namespace evenlift {
namespace {

struct Group {
  std::vector<std::uint32_t> ahead, behind;
  void fill(const RadialView& view, std::uint32_t group) {
    ahead.clear();
    behind.clear();
    for (std::uint32_t k = view.group_begin(group); k < view.group_begin(group + 1); ++k) {
      const std::uint32_t vertex = view.order()[k];
      (view.forward(vertex) ? ahead : behind).push_back(vertex);
    }
  }
};

VertexChord chord_between(const Polygon& polygon, const Vec2& centre, std::uint32_t v,
                          std::uint32_t w) {
  const double arm_v = length(polygon.vertex(v) - centre),
               arm_w = length(polygon.vertex(w) - centre);
  const Across across{arm_w / arm_v, (arm_w > arm_v) - (arm_w < arm_v)};
  return {v, w, chord_from_vertex(polygon, centre, v, v, across, w, w)};
}

VertexChord chord_into(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                       std::uint32_t v, std::uint32_t edge) {
  const Across across = look_across(centre, polygon.vertex(v), polygon.vertex(view.first(edge)),
                                    polygon.vertex(view.last(edge)), view.doubled_area(edge));
  return {v, inside_edge, chord_from_vertex(polygon, centre, v, v, across, edge, inside_edge)};
}

}  // namespace

Points positions(const std::vector<LiftingPoint>& points) {
  Points positions;
  positions.reserve(points.size());
  for (const LiftingPoint& point : points) positions.push_back(point.position);
  return positions;
}

std::vector<bool> radial_edges(const Polygon& polygon, const Vec2& centre) {
  const RadialView view(polygon, centre);
  std::vector<bool> radial(polygon.size());
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) radial[edge] = view.radial(edge);
  return radial;
}

Result<std::vector<VertexChord>> vertex_chords(const Polygon& polygon, const Vec2& centre) {
  const RadialView view(polygon, centre);
  RadialSweep sweep(polygon, view);
  std::vector<VertexChord> chords;
  Group group;
  for (std::uint32_t direction = 0; direction < view.direction_count(); ++direction) {
    sweep.leave(direction);
    // Between leaving and entering, the line meets the active edges in their interior.
    group.fill(view, direction);
    const std::uint64_t number =
        chords.size() + group.ahead.size() * (sweep.behind().size() + group.behind.size()) +
        group.behind.size() * sweep.ahead().size();
    if (auto error = check_number(number, "vertex-chords or more")) return *error;
    for (const std::uint32_t v : group.ahead) {
      for (const std::uint32_t w : group.behind)
        chords.push_back(chord_between(polygon, centre, v, w));
      for (const std::uint32_t edge : sweep.behind())
        chords.push_back(chord_into(polygon, centre, view, v, edge));
    }
    for (const std::uint32_t v : group.behind) {
      for (const std::uint32_t edge : sweep.ahead())
        chords.push_back(chord_into(polygon, centre, view, v, edge));
    }
    sweep.enter(direction, [](std::uint32_t, bool) {});
  }
  return chords;
}

std::uint64_t count_edge_pairs(const Polygon& polygon, const Vec2& centre) {
  return count_edge_pairs(polygon, RadialView(polygon, centre));
}

Result<std::vector<EdgePair>> edge_pairs(const Polygon& polygon, const Vec2& centre) {
  const RadialView view(polygon, centre);
  const std::uint64_t number = count_edge_pairs(polygon, view);
  if (auto error = check_number(number, "edge pairs")) return *error;
  std::vector<EdgePair> pairs;
  pairs.reserve(static_cast<std::size_t>(number));
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) { pairs.push_back(pair); });
  return pairs;
}

Result<std::vector<OppositeVertices>> opposite_vertices(const Polygon& polygon,
                                                        const Vec2& centre) {
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge pairs")) return *error;
  auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();
  return *std::move(opposite);
}

}  // namespace evenlift
