#include "evenlift/stands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "evenlift/numbers.h"
#include "evenlift/tolerance.h"
#include "polygon/segments.h"
#include "stands/losses.h"
#include "stands/near_edges.h"
#include "stands/obstacles.h"

namespace evenlift {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto sides_differ = [](const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    return (cross(q - p, r - p) > 0) != (cross(q - p, s - p) > 0);
  };
  return sides_differ(a, b, c, d) && sides_differ(c, d, a, b);
}

double distance_of_segments(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (cross_each_other(a, b, c, d)) return 0;
  return std::min({distance_to_segment(c, d, a), distance_to_segment(c, d, b),
                   distance_to_segment(a, b, c), distance_to_segment(a, b, d)});
}

InputError refused(const char* setting, std::string why) {
  return {ErrorCode::bad_setting, std::move(why), {Place::Kind::option, 0, 0, setting}};
}

InputError no_room(const Settings& settings) {
  const RobotSize& robot = settings.robot;
  if (robot.radius > 0)
    return refused("robot", "no edge has room for a robot of radius " + shortest(robot.radius));
  if (robot.depth > 0 || robot.width > 0)
    return refused("robot", "no edge has room for a hand of depth " + shortest(robot.depth) +
                                " and width " + shortest(robot.width));
  return refused("no_go", "no edge is left that a robot may touch");
}

// Whether a vertex is in a part that must not be touched.
std::vector<char> forbidden_vertices(const Polygon& polygon, const std::vector<EdgePart>& no_go,
                                     double near) {
  std::vector<char> forbidden(polygon.size(), 0);
  for (const EdgePart& part : no_go) {
    const double size = length(polygon.edge_end(part.edge) - polygon.edge_start(part.edge));
    if (part.from * size <= near) forbidden[part.edge] = 1;
    if ((1 - part.to) * size <= near) forbidden[polygon.next(part.edge)] = 1;
  }
  return forbidden;
}

}  // namespace

std::string_view name(WhyUnusable why) {
  constexpr std::string_view names[] = {"no_go", "body", "arm", "corner", "hand", "narrow"};
  return names[static_cast<std::size_t>(why)];
}

bool stands_anywhere(const Settings& settings) {
  return settings.robot == RobotSize{} && settings.no_go.empty();
}

namespace {

// Finds what each edge loses.
class Surveyor {
 public:
  Surveyor(const Polygon& polygon, const RobotSize& robot, const std::vector<EdgePart>& no_go)
      : polygon_(polygon),
        robot_(robot),
        near_(near_distance(polygon.diagonal())),
        edges_(polygon),
        no_go_(no_go) {
    std::sort(no_go_.begin(), no_go_.end(), [](const EdgePart& a, const EdgePart& b) {
      return std::array{double(a.edge), a.from, a.to} < std::array{double(b.edge), b.from, b.to};
    });
  }

  // The edge's start, direction and outward normal, and its length.
  Losses survey(std::uint32_t edge, const Vec2& start, const Vec2& along, const Vec2& outward,
                double size) const {
    Losses losses;
    add_no_go(edge, size, losses);
    if (robot_.radius > 0 || robot_.reach > 0 || robot_.depth > 0 || robot_.width > 0)
      add_obstacles(edge, {start, along, outward, 0, size, 0, 0}, losses);
    if (robot_.width > 0) {
      if (polygon_.turn(edge) == Turn::convex)
        losses.add(WhyUnusable::corner, {-infinity, robot_.width / 2});
      if (polygon_.turn(polygon_.next(edge)) == Turn::convex)
        losses.add(WhyUnusable::corner, {size - robot_.width / 2, infinity});
    }
    return losses;
  }

 private:
  void add_no_go(std::uint32_t edge, double size, Losses& losses) const {
    const auto first =
        std::lower_bound(no_go_.begin(), no_go_.end(), edge,
                         [](const EdgePart& part, std::uint32_t e) { return part.edge < e; });
    for (auto part = first; part != no_go_.end() && part->edge == edge; ++part)
      losses.add(WhyUnusable::no_go, {part->from == 0 ? -infinity : part->from * size,
                                      part->to == 1 ? infinity : part->to * size});
  }

  void add_obstacles(std::uint32_t edge, Surrounding around, Losses& losses) const {
    const double aside = std::max(robot_.radius, robot_.width / 2) + 2 * near_;
    const double size = around.x_high;
    around.x_low -= aside;
    around.x_high += aside;
    around.y_low = -(robot_.depth + 2 * near_);
    around.y_high = 2 * robot_.radius + robot_.reach + 2 * near_;
    edges_.for_each(around, [&](std::uint32_t other) {
      if (other != edge) add_obstacle(edge, other, around, size, losses);
    });
  }

  void add_obstacle(std::uint32_t edge, std::uint32_t other, const Surrounding& around, double size,
                    Losses& losses) const {
    const auto seen = [&](const Vec2& p) {
      const Vec2 offset = p - around.start;
      return Vec2(dot(offset, around.along), dot(offset, around.outward));
    };
    SeenObstacle obstacle{seen(polygon_.edge_start(other)), seen(polygon_.edge_end(other))};
    // A common vertex is at its place without rounding.
    if (other == polygon_.next(edge)) {
      obstacle.p = {size, 0};
      obstacle.convex_at_end = polygon_.turn(other) == Turn::convex;
    }
    if (other == polygon_.previous(edge)) {
      obstacle.q = {0, 0};
      obstacle.convex_at_begin = polygon_.turn(edge) == Turn::convex;
    }
    if (const auto lost = lost_to_body(obstacle, robot_, near_))
      losses.add(WhyUnusable::body, *lost);
    if (const auto lost = lost_to_arm(obstacle, robot_)) losses.add(WhyUnusable::arm, *lost);
    if (const auto lost = lost_to_hand(obstacle, robot_, near_))
      losses.add(WhyUnusable::hand, *lost);
  }

  const Polygon& polygon_;
  RobotSize robot_;
  double near_;
  NearEdges edges_;
  std::vector<EdgePart> no_go_;
};

}  // namespace

Stands::Stands(const Polygon& polygon, const RobotSize& robot, const std::vector<EdgePart>& no_go)
    : robot_(robot),
      has_body_(robot.radius > 0 || robot.reach > 0 || robot.depth > 0 || robot.width > 0),
      near_(near_distance(polygon.diagonal())) {
  const Surveyor surveyor(polygon, robot, no_go);
  const std::vector<char> forbidden = forbidden_vertices(polygon, no_go, near_);
  begins_.push_back(0);
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const Vec2 &start = polygon.edge_start(edge), &end = polygon.edge_end(edge);
    const double size = length(end - start);
    const Vec2 along = (end - start) / size;
    const Vec2 outward =
        polygon.counter_clockwise() ? Vec2(-left_normal(along)) : left_normal(along);
    frames_.push_back({start, along, outward, size});
    // Where nobody stands at a vertex.
    const double low = has_body_ || forbidden[edge] ? 2 * near_ : 0;
    const double high = size - (has_body_ || forbidden[polygon.next(edge)] ? 2 * near_ : 0);
    for (const Losses::Part& part :
         surveyor.survey(edge, start, along, outward, size).parts(size)) {
      const Stretch left{std::max(part.part.from, low), std::min(part.part.to, high)};
      if (part.why)
        unusable_.push_back({edge, part.part, *part.why});
      else if (left.to - left.from < near_)
        unusable_.push_back({edge, part.part, WhyUnusable::narrow});
      else
        usable_.push_back(left);
    }
    begins_.push_back(static_cast<std::uint32_t>(usable_.size()));
  }
}

std::optional<WhyUnusable> Stands::why_not(std::uint32_t edge, double t) const {
  for (const Stretch& stretch : usable(edge))
    if (t >= stretch.from - near_ && t <= stretch.to + near_) return std::nullopt;
  const auto after = std::upper_bound(unusable_.begin(), unusable_.end(), std::pair(edge, t),
                                      [](const auto& at, const UnusablePart& part) {
                                        return at.first != part.edge ? at.first < part.edge
                                                                     : at.second < part.part.from;
                                      });
  if (after != unusable_.begin() && (after - 1)->edge == edge && t <= (after - 1)->part.to)
    return (after - 1)->why;
  return WhyUnusable::corner;
}

Vec2 Stands::contact(const LiftingPoint& point) const {
  if (robot_.depth == 0) return point.position;
  return point.position + robot_.depth * frames_[point.edge].outward;
}

Vec2 Stands::stand(const LiftingPoint& point) const {
  if (!has_body_) return point.position;
  return point.position +
         (robot_.depth + robot_.radius + robot_.reach) * frames_[point.edge].outward;
}

LiftingPoint Stands::lifting_point(const LiftingPoint& contact) const {
  if (robot_.depth == 0) return contact;
  return {contact.position - robot_.depth * frames_[contact.edge].outward, contact.edge};
}

double Stands::along(const LiftingPoint& point) const {
  const Frame& frame = frames_[point.edge];
  return std::clamp(dot(point.position - frame.start, frame.along), 0.0, frame.length);
}

bool Stands::can_lift(const LiftingPoint& point) const {
  return !why_not(point.edge, along(point)).has_value();
}

bool Stands::collide(const LiftingPoint& a, const LiftingPoint& b) const {
  const double apart = 2 * robot_.radius + robot_.gap - near_;
  if (apart > 0 && length(stand(a) - stand(b)) < apart) return true;
  if (robot_.width <= near_) return false;
  return distance_of_segments(contact(a), a.position, contact(b), b.position) <
         robot_.width - near_;
}

bool Stands::any_collide(const std::vector<LiftingPoint>& points) const {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (collide(points[i], points[j])) return true;
  return false;
}

Result<std::shared_ptr<const Stands>> make_stands(const Polygon& polygon,
                                                  const Settings& settings) {
  if (stands_anywhere(settings)) return std::shared_ptr<const Stands>();
  for (const EdgePart& part : settings.no_go)
    if (part.edge >= polygon.size())
      return refused("no_go", "there is no edge " + std::to_string(part.edge + 1) +
                                  "; the polygon has " + std::to_string(polygon.size()));
  auto stands = std::make_shared<const Stands>(polygon, settings.robot, settings.no_go);
  if (!stands->any()) return no_room(settings);
  return std::shared_ptr<const Stands>(std::move(stands));
}

}  // namespace evenlift
