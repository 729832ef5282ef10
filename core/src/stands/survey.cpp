#include "stands/survey.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::vector<LineEnds> edges_of_holes(const PolygonWithHoles& object) {
  std::vector<LineEnds> edges;
  for (const Polygon& hole : object.holes()) {
    const std::vector<LineEnds> more = edges_of(hole.vertices());
    edges.insert(edges.end(), more.begin(), more.end());
  }
  return edges;
}

SeenObstacle seen_from(const EdgeFrame& frame, const LineEnds& line) {
  const auto seen = [&](const Vec2& p) {
    const Vec2 offset = p - frame.start;
    return Vec2(dot(offset, frame.along), dot(offset, frame.outward));
  };
  return {seen(line.start), seen(line.end)};
}

// A hand that meets no edge is outside the object if an odd number of edges separates it from the
// contact.
void add_parted(std::vector<double> parted, WhyUnusable why, Losses& losses) {
  std::sort(parted.begin(), parted.end());
  for (std::size_t i = 0; i < parted.size(); i += 2) losses.add(why, {parted[i], parted[i + 1]});
}

}  // namespace

EdgeFrame frame_of(const Polygon& polygon, std::uint32_t edge) {
  const Vec2 &start = polygon.edge_start(edge), &end = polygon.edge_end(edge);
  const double size = length(end - start);
  const Vec2 along = (end - start) / size;
  return {start, along,
          polygon.counter_clockwise() ? Vec2(-left_normal(along)) : left_normal(along), size};
}

Surveyor::Surveyor(const PolygonWithHoles& object, const RobotSize& robot,
                   const std::vector<EdgePart>& no_go)
    : polygon_(object.outline()),
      robot_(robot),
      near_(near_distance(polygon_.diameter())),
      edges_(edges_of(polygon_.vertices())),
      holes_(edges_of_holes(object)),
      corners_(polygon_),
      no_go_(no_go) {
  sort_items(no_go_, [](const EdgePart& a, const EdgePart& b) {
    return std::array{double(a.edge), a.from, a.to} < std::array{double(b.edge), b.from, b.to};
  });
}

Losses Surveyor::survey(std::uint32_t edge, const EdgeFrame& frame) const {
  Losses losses;
  add_no_go(edge, frame.length, losses);
  if (robot_.has_body()) add_obstacles(edge, frame, losses);
  if (robot_.width > 0) add_corners(edge, frame, losses);
  return losses;
}

std::span<const EdgePart> Surveyor::marked_on(std::uint32_t edge) const {
  struct Before {
    bool operator()(const EdgePart& part, std::uint32_t e) const { return part.edge < e; }
    bool operator()(std::uint32_t e, const EdgePart& part) const { return e < part.edge; }
  };
  const auto [first, last] = std::equal_range(no_go_.begin(), no_go_.end(), edge, Before());
  return std::span(no_go_).subspan(static_cast<std::size_t>(first - no_go_.begin()),
                                   static_cast<std::size_t>(last - first));
}

void Surveyor::add_no_go(std::uint32_t edge, double size, Losses& losses) const {
  const double half = robot_.width / 2;
  for (const EdgePart& part : marked_on(edge)) {
    const Stretch marked{part.from == 0 ? -unbounded : part.from * size,
                         part.to == 1 ? unbounded : part.to * size};
    losses.add(WhyUnusable::no_go, marked);
    if (half > 0) losses.add(WhyUnusable::near_no_go, {marked.from - half, marked.to + half});
  }
}

void Surveyor::add_corners(std::uint32_t edge, const EdgeFrame& frame, Losses& losses) const {
  const double half = robot_.width / 2;
  const auto way = [&](const Vec2& from, std::uint32_t corner) {
    return dot(polygon_.vertex(corner) - from, frame.along);
  };
  if (const auto corner = corners_.before(edge); corner && corners_.is_corner(*corner))
    losses.add(WhyUnusable::corner, {-unbounded, way(polygon_.edge_start(edge), *corner) + half});
  if (const auto corner = corners_.after(edge); corner && corners_.is_corner(*corner))
    losses.add(WhyUnusable::corner,
               {frame.length + way(polygon_.edge_end(edge), *corner) - half, unbounded});
}

void Surveyor::add_obstacles(std::uint32_t edge, const EdgeFrame& frame, Losses& losses) const {
  const double aside = std::max(robot_.radius, robot_.width / 2) + 2 * near_;
  const Surrounding around{.start = frame.start,
                           .along = frame.along,
                           .outward = frame.outward,
                           .x_low = -aside,
                           .x_high = frame.length + aside,
                           .y_low = -(std::max(robot_.depth, robot_.width / 10) + 2 * near_),
                           .y_high = 2 * robot_.radius + robot_.reach + 2 * near_};
  std::vector<double> parted;
  edges_.for_each(around, [&](std::uint32_t other) {
    if (other == edge) return;
    const SeenObstacle obstacle = seen_from(edge, frame, other);
    add_obstacle(obstacle, losses);
    // On a curve the hand may reach beneath the edges next to its own.
    for (const EdgePart& part : marked_on(other))
      if (const auto lost = lost_to_mark(obstacle, part, robot_, near_))
        losses.add(WhyUnusable::near_no_go, *lost);
    if (const auto stretch = parted_from_hand(obstacle, robot_, near_))
      parted.insert(parted.end(), {stretch->from, stretch->to});
  });
  add_parted(std::move(parted), WhyUnusable::hand, losses);
  add_holes(around, frame, losses);
}

// Only a hand can reach a hole.
void Surveyor::add_holes(const Surrounding& around, const EdgeFrame& frame, Losses& losses) const {
  std::vector<double> parted;
  holes_.for_each(around, [&](std::uint32_t edge) {
    const SeenObstacle obstacle = evenlift::seen_from(frame, holes_.edge(edge));
    if (const auto lost = lost_to_hand(obstacle, robot_, near_))
      losses.add(WhyUnusable::hole, *lost);
    if (const auto stretch = parted_from_hand(obstacle, robot_, near_))
      parted.insert(parted.end(), {stretch->from, stretch->to});
  });
  add_parted(std::move(parted), WhyUnusable::hole, losses);
}

SeenObstacle Surveyor::seen_from(std::uint32_t edge, const EdgeFrame& frame,
                                 std::uint32_t other) const {
  SeenObstacle obstacle = evenlift::seen_from(frame, edges_.edge(other));
  // Exact: a projection would be rounded.
  if (other == polygon_.next(edge)) obstacle.p = {frame.length, 0};
  if (other == polygon_.previous(edge)) obstacle.q = {0, 0};
  return obstacle;
}

void Surveyor::add_obstacle(const SeenObstacle& obstacle, Losses& losses) const {
  if (const auto lost = lost_to_body(obstacle, robot_, near_)) losses.add(WhyUnusable::body, *lost);
  if (const auto lost = lost_to_arm(obstacle, robot_)) losses.add(WhyUnusable::arm, *lost);
  if (const auto lost = lost_to_hand(obstacle, robot_, near_)) losses.add(WhyUnusable::hand, *lost);
}

}  // namespace evenlift
