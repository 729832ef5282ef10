#include "stands/survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Extent {
  double low = infinity, high = -infinity;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool empty() const { return low > high; }
  std::optional<Stretch> stretch() const {
    return empty() ? std::nullopt : std::optional(Stretch{low, high});
  }
};

double x_at(const Vec2& p, const Vec2& q, double y) {
  const double part = (y - p.y) / (q.y - p.y);
  return p.x + std::clamp(part, 0.0, 1.0) * (q.x - p.x);
}

// The x of a segment where `low` <= y <= `high`.
Extent within(const Vec2& p, const Vec2& q, double low, double high) {
  Extent extent;
  for (const Vec2& end : {p, q})
    if (end.y >= low && end.y <= high) extent.add(end.x);
  for (const double y : {low, high})
    if ((p.y < y) != (q.y < y) && p.y != q.y) extent.add(x_at(p, q, y));
  return extent;
}

// Where the segment crosses height y. Upper ends count, lower ones do not.
Extent crossing(const Vec2& p, const Vec2& q, double y) {
  Extent extent;
  if ((p.y < y) != (q.y < y)) extent.add(x_at(p, q, y));
  return extent;
}

Vec2 upside_down(const Vec2& v) { return {v.x, -v.y}; }

// Where the hand must be beneath the object, within tau L. Empty if its depth is less than a tenth
// of its width.
struct HandDepths {
  double from, to;
  HandDepths(const RobotSize& robot, double near)
      : from(robot.width / 10 + near), to(robot.depth - near) {}
  bool empty() const { return from > to; }
};

}  // namespace

// Intersects the line of the body's middle with the capsule of its radius about the other edge. A
// capsule is convex, so this is one interval. Its ends are on the discs about the vertices or on
// the straight sides.
std::optional<Stretch> lost_to_body(const SeenObstacle& other, const RobotSize& robot,
                                    double near) {
  const double radius = robot.radius - near, height = robot.radius + robot.reach;
  if (radius <= 0) return std::nullopt;
  const Vec2 &p = other.p, &q = other.q;
  if (std::min(p.y, q.y) >= height + radius || std::max(p.y, q.y) <= height - radius)
    return std::nullopt;
  Extent extent;
  for (const Vec2& end : {p, q}) {
    const double rise = height - end.y;
    if (std::fabs(rise) >= radius) continue;
    const double half = std::sqrt((radius - rise) * (radius + rise));
    extent.add(end.x - half);
    extent.add(end.x + half);
  }
  const Vec2 along = q - p;
  const double size = length(along);
  if (size > 0) {
    const Vec2 aside = left_normal(along) * (radius / size);
    for (const Vec2& offset : {aside, Vec2(-aside)}) {
      const Extent side = crossing(p + offset, q + offset, height);
      if (!side.empty()) extent.add(side.low);
    }
  }
  return extent.stretch();
}

// On the object's side of the line, the other edge does not obstruct the arm.
std::optional<Stretch> lost_to_arm(const SeenObstacle& other, const RobotSize& robot) {
  const Vec2 &p = other.p, &q = other.q;
  if (robot.reach <= 0 || std::max(p.y, q.y) <= 0) return std::nullopt;
  return within(p, q, 0, robot.radius + robot.reach).stretch();
}

// The hand at these depths, narrower by tau L on each side, must not meet the other edge.
std::optional<Stretch> lost_to_hand(const SeenObstacle& other, const RobotSize& robot,
                                    double near) {
  const HandDepths depths(robot, near);
  if (depths.empty()) return std::nullopt;
  const Extent met = within(upside_down(other.p), upside_down(other.q), depths.from, depths.to);
  if (met.empty()) return std::nullopt;
  const double half = std::max(robot.width / 2 - near, 0.0);
  return Stretch{met.low - half, met.high + half};
}

std::optional<Stretch> lost_to_mark(const SeenObstacle& other, const EdgePart& part,
                                    const RobotSize& robot, double near) {
  const double half = robot.width / 2;
  if (half <= 0) return std::nullopt;
  const Vec2 way = other.q - other.p;
  const Extent marked =
      within(other.p + part.from * way, other.p + part.to * way, -(robot.width / 10 + near), near);
  if (marked.empty()) return std::nullopt;
  return Stretch{marked.low - half, marked.high + half};
}

std::optional<Stretch> parted_from_hand(const SeenObstacle& other, const RobotSize& robot,
                                        double near) {
  const HandDepths depths(robot, near);
  if (depths.empty()) return std::nullopt;
  return within(upside_down(other.p), upside_down(other.q), 0, depths.from).stretch();
}

namespace {

void unite(std::vector<Stretch>& stretches, double length) {
  for (Stretch& s : stretches) s = {std::clamp(s.from, 0.0, length), std::clamp(s.to, 0.0, length)};
  std::erase_if(stretches, [](const Stretch& s) { return !(s.from < s.to); });
  sort_items(stretches, [](const Stretch& a, const Stretch& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  std::size_t kept = 0;
  for (const Stretch& s : stretches) {
    if (kept > 0 && s.from <= stretches[kept - 1].to)
      stretches[kept - 1].to = std::max(stretches[kept - 1].to, s.to);
    else
      stretches[kept++] = s;
  }
  stretches.resize(kept);
}

bool contain(const std::vector<Stretch>& stretches, double t) {
  const auto after = std::upper_bound(stretches.begin(), stretches.end(), t,
                                      [](double x, const Stretch& s) { return x < s.from; });
  return after != stretches.begin() && t < (after - 1)->to;
}

}  // namespace

std::vector<Losses::Part> Losses::parts(double length) {
  std::vector<double> ends{0, length};
  for (std::vector<Stretch>& stretches : lost_) {
    unite(stretches, length);
    for (const Stretch& s : stretches) {
      ends.push_back(s.from);
      ends.push_back(s.to);
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Part> parts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = ends[i] + (ends[i + 1] - ends[i]) / 2;
    std::optional<WhyUnusable> why;
    for (std::size_t reason = 0; reason < reasons_to_lose && !why; ++reason)
      if (contain(lost_[reason], middle)) why = static_cast<WhyUnusable>(reason);
    if (!parts.empty() && parts.back().why == why)
      parts.back().part.to = ends[i + 1];
    else
      parts.push_back({{ends[i], ends[i + 1]}, why});
  }
  return parts;
}

// Rectangles are apart if their projections onto some side's normal are. Rounding is harmless:
// `around` includes a margin.
bool NearEdges::meets(const Surrounding& around, const Box& box) {
  const Vec2 half = box.size() / 2, middle = box.middle() - around.start;
  const auto apart = [&](const Vec2& axis, double low, double high) {
    const double at = dot(middle, axis);
    const double reach = half.x * std::fabs(axis.x) + half.y * std::fabs(axis.y);
    return at + reach < low || at - reach > high;
  };
  if (apart(around.along, around.x_low, around.x_high)) return false;
  if (apart(around.outward, around.y_low, around.y_high)) return false;
  const Vec2 own_middle = around.along * ((around.x_low + around.x_high) / 2) +
                          around.outward * ((around.y_low + around.y_high) / 2);
  const double width = (around.x_high - around.x_low) / 2,
               height = (around.y_high - around.y_low) / 2;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double reach = width * std::fabs(around.along[axis]) +
                         height * std::fabs(around.outward[axis]) + half[axis];
    if (std::fabs(own_middle[axis] - middle[axis]) > reach) return false;
  }
  return true;
}

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

namespace {

struct Segment {
  Vec2 from, to;
};

// Whether the other's ends are on different sides of the line, by more than `near`.
bool parts_ends(const Segment& line, const Segment& other, double near) {
  const double close = near * length(line.to - line.from);
  const double a = orient(line.from, line.to, other.from), b = orient(line.from, line.to, other.to);
  return std::fabs(a) > close && std::fabs(b) > close && (a > 0) != (b > 0);
}

// By more than `near`; segments that touch do not cross.
bool cross_each_other(const Segment& a, const Segment& b, double near) {
  return parts_ends(a, b, near) && parts_ends(b, a, near);
}

double distance_of_segments(const Segment& a, const Segment& b) {
  if (cross_each_other(a, b, 0)) return 0;
  return std::min(
      {distance_to_segment(b.from, b.to, a.from), distance_to_segment(b.from, b.to, a.to),
       distance_to_segment(a.from, a.to, b.from), distance_to_segment(a.from, a.to, b.to)});
}

}  // namespace

bool Stands::bodies_collide(const LiftingPoint& a, const LiftingPoint& b) const {
  const double apart = 2 * robot_.radius + robot_.gap + reserve_between(a, b) - near_;
  return apart > 0 && length(stand(a) - stand(b)) < apart;
}

// Without a reach, an arm is inside its body, which keeps others away.
bool Stands::arms_collide(const LiftingPoint& a, const LiftingPoint& b) const {
  if (robot_.reach <= 0) return false;
  const Segment arm_a{contact(a), stand(a)}, arm_b{contact(b), stand(b)};
  const double reserve = reserve_between(a, b),
               clear = robot_.radius + robot_.gap + reserve - near_;
  return (reserve > 0 && distance_of_segments(arm_a, arm_b) < reserve) ||
         (clear > 0 && (distance_to_segment(arm_a.from, arm_a.to, arm_b.to) < clear ||
                        distance_to_segment(arm_b.from, arm_b.to, arm_a.to) < clear)) ||
         cross_each_other(arm_a, arm_b, near_);
}

bool Stands::hands_collide(const LiftingPoint& a, const LiftingPoint& b) const {
  if (a.edge == beneath || b.edge == beneath) return false;
  return robot_.width > near_ &&
         distance_of_segments({contact(a), a.position}, {contact(b), b.position}) <
             robot_.width + reserve_between(a, b) - near_;
}

double Stands::reserve_between(const LiftingPoint& a, const LiftingPoint& b) const {
  return drifts_.empty() || a.edge == beneath || b.edge == beneath
             ? 0
             : drifts_[a.edge] + drifts_[b.edge];
}

bool Stands::collide(const LiftingPoint& a, const LiftingPoint& b) const {
  return bodies_collide(a, b) || arms_collide(a, b) || hands_collide(a, b);
}

double Stands::room_between(const LiftingPoint& a, const LiftingPoint& b) const {
  double room = std::numeric_limits<double>::infinity();
  if (const double apart = 2 * robot_.radius + robot_.gap; apart > 0)
    room = length(stand(a) - stand(b)) - apart;
  if (robot_.reach > 0) {
    const Segment arm_a{contact(a), stand(a)}, arm_b{contact(b), stand(b)};
    const double clear = robot_.radius + robot_.gap;
    room = std::min({room, distance_to_segment(arm_a.from, arm_a.to, arm_b.to) - clear,
                     distance_to_segment(arm_b.from, arm_b.to, arm_a.to) - clear,
                     distance_of_segments(arm_a, arm_b)});
  }
  if (robot_.width > near_ && a.edge != beneath && b.edge != beneath)
    room = std::min(room, distance_of_segments({contact(a), a.position}, {contact(b), b.position}) -
                              robot_.width);
  return room;
}

bool Stands::any_collide(const std::vector<LiftingPoint>& points) const {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (collide(points[i], points[j])) return true;
  return false;
}

}  // namespace evenlift
