#include <algorithm>
#include <limits>

#include "evenlift/stands.h"
#include "polygon/outline_walk.h"

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

}  // namespace evenlift
