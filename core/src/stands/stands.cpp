#include "evenlift/stands.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"
#include "stands/survey.h"

namespace evenlift {

Stands::Way Stands::way_to_end(const Polygon& polygon, std::uint32_t edge, double t, bool on,
                               bool past_corners, double most) const {
  double at = t, way = 0;
  for (std::size_t passed = 0; passed < polygon.size() && !(way > most); ++passed) {
    const Stretches parts = room(edge);
    const Stretch* part = std::find_if(parts.begin(), parts.end(), [&](const Stretch& each) {
      return at >= each.from - 3 * near_ && at <= each.to + 3 * near_;
    });
    if (part == parts.end()) return {way, std::nullopt};
    way += std::max(0.0, on ? part->to - at : at - part->from);
    if (on ? part->to < frames_[edge].length - 3 * near_ : part->from > 3 * near_)
      return {way, std::nullopt};
    const std::size_t vertex = on ? polygon.next(edge) : edge;
    if (!past_corners && (polygon.is_corner(vertex) || polygon.is_notch(vertex)))
      return {way, vertex};
    edge = static_cast<std::uint32_t>(on ? vertex : polygon.previous(edge));
    at = on ? 0 : frames_[edge].length;
  }
  return {std::numeric_limits<double>::infinity(), std::nullopt};
}

std::vector<double> Stands::drifts(const Polygon& polygon, double accuracy) const {
  const double arm = std::max(robot_.radius + robot_.reach, robot_.depth);
  std::vector<double> drifts;
  drifts.reserve(polygon.size());
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge)
    drifts.push_back(
        accuracy + arm * std::max(greatest_turn(polygon, polygon.edge_start(edge), edge, accuracy),
                                  greatest_turn(polygon, polygon.edge_end(edge), edge, accuracy)));
  return drifts;
}

Stands::Parts Stands::usable_parts(const Polygon& polygon, const StandReserve& reserve) const {
  const auto of_digits = [&](double room) { return std::min(reserve.length, room / 4); };
  // What must be left free at an end of a part.
  const auto kept = [&](std::uint32_t edge, const Stretch& part, bool on) {
    const double to_vertex = on ? frames_[edge].length - part.to : part.from;
    const std::size_t vertex = on ? polygon.next(edge) : edge;
    const Way beyond = way_to_end(polygon, edge, on ? part.to : part.from, on, false,
                                  std::max(reserve.accuracy, reserve.from_corner));
    double needed = reserve.accuracy;
    if (beyond.vertex && polygon.is_corner(*beyond.vertex)) needed = reserve.from_corner;
    // A robot without a body is pressed into the notch.
    if (beyond.vertex && polygon.is_notch(*beyond.vertex) && !has_body()) return 0.0;
    double least = std::max(0.0, needed - beyond.length);
    // Also at a bend, so that a place that is typed stays on its side.
    if (has_body()) least = std::max(least, of_digits(part.to - part.from));
    if (beyond.length == 0 && has_body())
      least = std::max({least, reserve.accuracy, reserve.part * (part.to - part.from)});
    return polygon.is_corner(vertex) ? std::max(least, reserve.from_corner - to_vertex) : least;
  };
  Parts usable;
  usable.begins.push_back(0);
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    for (const Stretch& part : room(edge)) {
      const Stretch left{part.from + kept(edge, part, false), part.to - kept(edge, part, true)};
      if (left.to - left.from >= near_) usable.parts.push_back(left);
    }
    usable.begins.push_back(static_cast<std::uint32_t>(usable.parts.size()));
  }
  return usable;
}

namespace {

bool comes_first(const EdgePart& a, const EdgePart& b) {
  return a.edge != b.edge ? a.edge < b.edge : a.from < b.from;
}

// Sorted, and joined where they meet.
std::vector<EdgePart> united(std::vector<EdgePart> parts) {
  sort_items(parts, comes_first);
  std::vector<EdgePart> joined;
  for (const EdgePart& part : parts) {
    if (!joined.empty() && joined.back().edge == part.edge && part.from <= joined.back().to)
      joined.back().to = std::max(joined.back().to, part.to);
    else
      joined.push_back(part);
  }
  return joined;
}

}  // namespace

std::vector<EdgePart> with_part(std::vector<EdgePart> no_go, const EdgePart& part) {
  no_go.push_back(part);
  return united(std::move(no_go));
}

std::vector<EdgePart> without_part(std::vector<EdgePart> no_go, const EdgePart& part) {
  std::vector<EdgePart> left;
  for (const EdgePart& marked : united(std::move(no_go))) {
    if (marked.edge != part.edge) {
      left.push_back(marked);
      continue;
    }
    if (marked.from < part.from)
      left.push_back({marked.edge, marked.from, std::min(marked.to, part.from)});
    if (marked.to > part.to)
      left.push_back({marked.edge, std::max(marked.from, part.to), marked.to});
  }
  return left;
}

bool is_marked(const std::vector<EdgePart>& no_go, std::uint32_t edge, double at) {
  return std::any_of(no_go.begin(), no_go.end(), [&](const EdgePart& part) {
    return part.edge == edge && at >= part.from && at <= part.to;
  });
}

std::vector<EdgePart> after_split(const std::vector<EdgePart>& no_go, std::uint32_t edge,
                                  double at) {
  std::vector<EdgePart> parts;
  for (EdgePart part : no_go) {
    if (part.edge != edge) {
      if (part.edge > edge) ++part.edge;
      parts.push_back(part);
      continue;
    }
    if (part.from < at && at > 0)
      parts.push_back({edge, part.from / at, std::min(part.to / at, 1.0)});
    if (part.to > at && at < 1)
      parts.push_back(
          {edge + 1, std::max((part.from - at) / (1 - at), 0.0), (part.to - at) / (1 - at)});
  }
  return united(std::move(parts));
}

std::vector<EdgePart> after_removal(const std::vector<EdgePart>& no_go, const Points& vertices,
                                    std::uint32_t vertex) {
  const auto n = static_cast<std::uint32_t>(vertices.size());
  const std::uint32_t before = (vertex + n - 1) % n, next = (vertex + 1) % n;
  const double first = length(vertices[vertex] - vertices[before]),
               second = length(vertices[next] - vertices[vertex]);
  const double at = first / (first + second);
  const std::uint32_t joined = vertex == 0 ? n - 2 : vertex - 1;
  std::vector<EdgePart> parts;
  for (const EdgePart& part : no_go) {
    if (part.edge == before)
      parts.push_back({joined, part.from * at, part.to * at});
    else if (part.edge == vertex)
      parts.push_back(
          {joined, at + part.from * (1 - at), part.to == 1 ? 1 : at + part.to * (1 - at)});
    else
      parts.push_back({part.edge > vertex ? part.edge - 1 : part.edge, part.from, part.to});
  }
  return united(std::move(parts));
}

namespace {

// Names the whole size, since the radius need not be the reason.
InputError no_room(const Settings& settings) {
  const RobotSize& robot = settings.robot;
  const bool arm = robot.reach > 0, body = robot.radius > 0 || arm,
             hand = robot.depth > 0 || robot.width > 0;
  if (!body && !hand)
    return setting_error(Setting::no_go, "the no-go edges leave no edge for the robots");
  constexpr const char* messages[2][2] = {
      {"no edge has room for a robot of radius {radius}",
       "no edge has room for a robot of radius {radius}, with a hand of depth {depth} and width "
       "{width}"},
      {"no edge has room for a robot of radius {radius} and reach {reach}",
       "no edge has room for a robot of radius {radius} and reach {reach}, with a hand of depth "
       "{depth} and width {width}"}};
  std::vector<std::string> sizes;
  if (body) sizes.push_back(as_read(shortest(robot.radius)));
  if (arm) sizes.push_back(as_read(shortest(robot.reach)));
  if (hand)
    sizes.insert(sizes.end(), {as_read(shortest(robot.depth)), as_read(shortest(robot.width))});
  const char* message = body ? messages[arm ? 1 : 0][hand ? 1 : 0]
                             : "no edge has room for a hand of depth {depth} and width {width}";
  return setting_error(Setting::robot, say_written(message, sizes.data(), sizes.size()));
}

}  // namespace

bool stands_anywhere(const Settings& settings) {
  const bool is_searched =
      selects_candidates(settings.method) || settings.method == Method::balanced;
  return settings.robot == RobotSize{} && settings.no_go.empty() &&
         !(is_searched && settings.accuracy.value_or(0) > 0);
}

Result<std::shared_ptr<const Stands>> make_stands(const PolygonWithHoles& object,
                                                  const Vec2& centre, const Settings& settings) {
  if (stands_anywhere(settings)) return std::shared_ptr<const Stands>();
  for (const EdgePart& part : settings.no_go)
    if (part.edge >= object.outline().size())
      return setting_error(Setting::no_go, say("there is no edge {edge}; the polygon has {edges}",
                                               {part.edge + 1, object.outline().size()}));
  // Given supports stay where they are, however accurate they are.
  StandReserve reserve;
  const double accuracy = settings.accuracy.value_or(0);
  if (accuracy > 0 && settings.method != Method::given)
    reserve = {accuracy,
               std::max(accuracy, settings.clear.value_or(
                                      usual_clear * farthest_vertex(object.outline(), centre)))};
  // Then places that are typed with a few digits fit again.
  if (settings.robot.has_body()) {
    reserve.part = 1e-3;
    reserve.length = usual_snap * object.outline().diameter();
  }
  auto stands = std::make_shared<const Stands>(object, settings.robot, settings.no_go, reserve);
  if (!stands->any() && settings.method != Method::given) return no_room(settings);
  if (!stands->any_usable() && settings.method != Method::given)
    return setting_error(Setting::accuracy,
                         say("no edge has room for robots that may be off by {accuracy}",
                             {as_read(shortest(accuracy))}));
  return std::shared_ptr<const Stands>(std::move(stands));
}

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
