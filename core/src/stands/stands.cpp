#include "evenlift/stands.h"

#include <algorithm>
#include <utility>

#include "evenlift/tolerance.h"
#include "stands/survey.h"

namespace evenlift {
namespace {

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
  switch (why) {
    case WhyUnusable::no_go:
      return "no_go";
    case WhyUnusable::body:
      return "body";
    case WhyUnusable::arm:
      return "arm";
    case WhyUnusable::corner:
      return "corner";
    case WhyUnusable::hand:
      return "hand";
    case WhyUnusable::hole:
      return "hole";
    case WhyUnusable::near_no_go:
      return "near_no_go";
    case WhyUnusable::narrow:
      return "narrow";
  }
  return {};
}

Stands::Stands(const PolygonWithHoles& object, const RobotSize& robot,
               const std::vector<EdgePart>& no_go, const StandReserve& reserve)
    : robot_(robot), near_(near_distance(object.outline().diameter())) {
  const Polygon& polygon = object.outline();
  const Surveyor surveyor(object, robot, no_go);
  const std::vector<char> forbidden = forbidden_vertices(polygon, no_go, near_);
  // The distance of robots from a vertex where none may stand.
  const auto margin_at = [&](std::size_t vertex) {
    return has_body() || forbidden[vertex] ? 2 * near_ : 0;
  };
  room_.begins.push_back(0);
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const EdgeFrame frame = frame_of(polygon, edge);
    frames_.push_back(frame);
    const double low = margin_at(edge), high = frame.length - margin_at(polygon.next(edge));
    for (const Losses::Part& part : surveyor.survey(edge, frame).parts(frame.length)) {
      const Stretch left{std::max(part.part.from, low), std::min(part.part.to, high)};
      if (part.why)
        unusable_.push_back({edge, part.part, *part.why});
      else if (left.to - left.from < near_)
        unusable_.push_back({edge, part.part, WhyUnusable::narrow});
      else
        room_.parts.push_back(left);
    }
    room_.begins.push_back(static_cast<std::uint32_t>(room_.parts.size()));
  }
  if (has_body() && reserve.accuracy > 0) drifts_ = drifts(polygon, reserve.accuracy);
  usable_ = reserve.part > 0 || reserve.accuracy > 0 ? usable_parts(polygon, reserve) : room_;
}

std::optional<WhyUnusable> Stands::why_not(std::uint32_t edge, double t) const {
  for (const Stretch& stretch : room(edge))
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
  if (robot_.depth == 0 || point.edge == beneath) return point.position;
  return point.position + robot_.depth * frames_[point.edge].outward;
}

Vec2 Stands::stand(const LiftingPoint& point) const {
  if (!has_body() || point.edge == beneath) return point.position;
  return point.position +
         (robot_.depth + robot_.radius + robot_.reach) * frames_[point.edge].outward;
}

LiftingPoint Stands::lifting_point(const LiftingPoint& contact) const {
  if (robot_.depth == 0 || contact.edge == beneath) return contact;
  return {contact.position - robot_.depth * frames_[contact.edge].outward, contact.edge};
}

LiftingPoint Stands::beside_vertex(const Polygon& polygon, const LiftingPoint& contact) const {
  if (!has_body() || contact.edge == beneath) return contact;
  const double t = along(contact), left = frames_[contact.edge].length - t;
  const std::size_t vertex = t < left ? contact.edge : polygon.next(contact.edge);
  if (std::min(t, left) > near_ || polygon.is_corner(vertex) || polygon.is_notch(vertex))
    return contact;
  const auto after = static_cast<std::uint32_t>(vertex),
             before = static_cast<std::uint32_t>(polygon.previous(vertex));
  const double aside = 2 * near_;
  const auto place = [&](std::uint32_t edge, double at) {
    return LiftingPoint{frames_[edge].start + at * frames_[edge].along, edge};
  };
  for (const LiftingPoint& other :
       {place(after, aside), place(before, frames_[before].length - aside)})
    if (!why_not(other.edge, along(other))) return other;
  return contact;
}

double Stands::along(const LiftingPoint& point) const {
  const EdgeFrame& frame = frames_[point.edge];
  return std::clamp(dot(point.position - frame.start, frame.along), 0.0, frame.length);
}

bool Stands::can_lift(const LiftingPoint& point) const {
  return !why_not(point.edge, along(point)).has_value();
}

bool Stands::can_use(const LiftingPoint& point) const {
  const double t = along(point);
  const Stretches parts = usable(point.edge);
  return std::any_of(parts.begin(), parts.end(), [&](const Stretch& part) {
    return t >= part.from - near_ && t <= part.to + near_;
  });
}

std::vector<LiftingPoint> contact_points(const Stands* stands, std::vector<LiftingPoint> points) {
  if (stands)
    for (LiftingPoint& point : points) point.position = stands->contact(point);
  return points;
}

}  // namespace evenlift
