#include "stands/reserve.h"

#include <algorithm>

#include "stands/survey.h"

namespace evenlift {

std::vector<double> drifts(const Polygon& polygon, double arm, double accuracy) {
  std::vector<double> drifts;
  drifts.reserve(polygon.size());
  for (std::uint32_t own = 0; own < polygon.size(); ++own) {
    double turn = 0;
    for (const bool on : {true, false}) {
      std::size_t edge = own;
      double left = accuracy;
      for (std::size_t passed = 0; passed < polygon.size() && left >= 0; ++passed) {
        edge = on ? polygon.next(edge) : polygon.previous(edge);
        const auto beyond = static_cast<std::uint32_t>(edge);
        turn = std::max(turn,
                        length(frame_of(polygon, beyond).outward - frame_of(polygon, own).outward));
        left -= length(polygon.edge_end(edge) - polygon.edge_start(edge));
      }
    }
    drifts.push_back(accuracy + arm * turn);
  }
  return drifts;
}

RoomBeyond::Kept RoomBeyond::kept(std::size_t vertex, bool on) const {
  double way = 0;
  for (std::size_t passed = 0; passed < polygon_.size(); ++passed) {
    double needed = reserve_.accuracy;
    bool ends = false;
    if (polygon_.is_corner(vertex)) {
      needed = reserve_.from_corner;
      ends = true;
    } else if (polygon_.is_notch(vertex)) {
      // A robot without a body is pressed into the notch.
      if (!stands_.has_body()) return {};
      ends = true;
    }
    const auto edge = static_cast<std::uint32_t>(on ? vertex : polygon_.previous(vertex));
    const double size = length(polygon_.edge_end(edge) - polygon_.edge_start(edge));
    const auto parts = stands_.room(edge);
    const Stretch* beside = parts.empty() ? nullptr : on ? parts.begin() : parts.end() - 1;
    if (!beside || (on ? beside->from > 3 * near_ : beside->to < size - 3 * near_)) ends = true;
    if (ends) return {std::max(0.0, needed - way), way == 0};
    way += on ? beside->to : size - beside->from;
    if (on ? beside->to < size - 3 * near_ : beside->from > 3 * near_)
      return {std::max(0.0, reserve_.accuracy - way), false};
    if (way >= std::max(reserve_.accuracy, reserve_.from_corner)) return {};
    vertex = on ? polygon_.next(edge) : edge;
  }
  return {};
}

Stands::Parts Stands::usable_parts(const Polygon& polygon, const StandReserve& reserve) const {
  const RoomBeyond beyond(polygon, *this, reserve, near_);
  Parts usable;
  usable.begins.push_back(0);
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const double size = frames_[edge].length;
    for (const Stretch& part : room(edge)) {
      const double kept = has_body() ? reserve.part * (part.to - part.from) : 0;
      const auto cut = [&](bool at_begin) {
        const double to_vertex = at_begin ? part.from : size - part.to;
        const std::size_t vertex = at_begin ? edge : polygon.next(edge);
        if (to_vertex > 3 * near_)
          return std::max({reserve.accuracy, kept,
                           polygon.is_corner(vertex) ? reserve.from_corner - to_vertex : 0});
        const RoomBeyond::Kept at = beyond.kept(vertex, !at_begin);
        const double end = at.is_end && has_body() ? std::max(reserve.accuracy, kept) : 0;
        return std::max(end, at.length - to_vertex);
      };
      Stretch left{part.from + cut(true), part.to - cut(false)};
      if (left.to - left.from < near_) continue;
      usable.parts.push_back(left);
    }
    usable.begins.push_back(static_cast<std::uint32_t>(usable.parts.size()));
  }
  return usable;
}

}  // namespace evenlift
