// Whether a robot can stand at a place, by the four conditions and nothing else: every edge is looked at,
// and what lies within the object is decided by counting crossings.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "evenlift/stands.h"

namespace evenlift::testing {

class StandOracle {
 public:
  // `slack` is how far from its bound a condition must be to count as broken or kept.
  StandOracle(const Polygon& polygon, const RobotSize& robot, const std::vector<EdgePart>& no_go)
      : polygon_(polygon), robot_(robot), no_go_(no_go), slack_(1e-7 * polygon.diagonal()) {}

  enum class Verdict { stands, cannot, unsure };

  Verdict at(std::size_t edge, double part) const {
    const Vec2 p = polygon_.edge_start(edge), q = polygon_.edge_end(edge);
    const double size = length(q - p);
    const Vec2 along = (q - p) / size;
    const Vec2 out =
        polygon_.counter_clockwise() ? Vec2(along.y(), -along.x()) : Vec2(-along.y(), along.x());
    const Vec2 c = p + part * (q - p);
    Verdict verdict = Verdict::stands;
    const auto keep = [&](double room) {  // above 0: kept
      if (room < -slack_) verdict = Verdict::cannot;
      if (std::fabs(room) <= slack_ && verdict == Verdict::stands) verdict = Verdict::unsure;
    };
    for (const EdgePart& no : no_go_)
      if (no.edge == edge) keep(std::max(no.from - part, part - no.to) * size);
    check_body(edge, c + (robot_.radius + robot_.reach) * out, keep);
    check_arm(edge, c, out, keep);
    check_hand(edge, part * size, size, c, along, out, keep);
    return verdict;
  }

 private:
  static double to_segment(const Vec2& s, const Vec2& a, const Vec2& b) {
    const double part = std::clamp(dot(s - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return length(s - a - part * (b - a));
  }

  template <class Keep>
  void check_body(std::size_t edge, const Vec2& s, Keep keep) const {
    for (std::size_t f = 0; f < polygon_.size() && robot_.radius > 0; ++f)
      if (f != edge)
        keep(to_segment(s, polygon_.edge_start(f), polygon_.edge_end(f)) - robot_.radius);
  }

  // How far inside the object a point is; below 0 outside.
  double depth(const Vec2& s) const {
    bool inside = false;
    double nearest = 1e300;
    for (std::size_t f = 0; f < polygon_.size(); ++f) {
      const Vec2 a = polygon_.edge_start(f), b = polygon_.edge_end(f);
      nearest = std::min(nearest, to_segment(s, a, b));
      if ((a.y() > s.y()) != (b.y() > s.y()) &&
          s.x() < a.x() + (s.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        inside = !inside;
    }
    return inside ? nearest : -nearest;
  }

  template <class Keep>
  void check_arm(std::size_t edge, const Vec2& c, const Vec2& out, Keep keep) const {
    if (robot_.reach <= 0) return;
    const double way = robot_.reach + robot_.radius;
    const auto seen = [&](const Vec2& p) { return Vec2(cross(out, p - c), dot(p - c, out)); };
    for (std::size_t f = 0; f < polygon_.size(); ++f)
      if (f != edge &&
          is_met(seen(polygon_.edge_start(f)), seen(polygon_.edge_end(f)), 0, slack_, way))
        keep(-1);
    for (int k = 1; k <= samples; ++k) keep(-depth(c + k * way / samples * out));
  }

  template <class Keep>
  void check_hand(std::size_t edge, double t, double size, const Vec2& c, const Vec2& along,
                  const Vec2& out, Keep keep) const {
    const double half = robot_.width / 2;
    if (polygon_.turn(edge) == Turn::convex) keep(t - half);
    if (polygon_.turn(polygon_.next(edge)) == Turn::convex) keep(size - half - t);
    if (robot_.depth <= 0 && robot_.width <= 0) return;
    // What is thinner than the samples below are apart.
    for (std::size_t f = 0; f < polygon_.size(); ++f) {
      const auto seen = [&](const Vec2& p) { return Vec2(dot(p - c, along), -dot(p - c, out)); };
      // A slanting edge is met a little farther on where it is looked for deeper.
      const double room = std::max(half - 20 * slack_, 0.0);
      if (f != edge && is_met(seen(polygon_.edge_start(f)), seen(polygon_.edge_end(f)), room,
                              slack_, std::max(robot_.depth - slack_, slack_)))
        keep(-1);
    }
    const int across = robot_.width > 0 ? samples : 0, down = robot_.depth > 0 ? samples : 0;
    for (int i = 0; i <= across; ++i)
      for (int j = 0; j <= down; ++j) {
        const double x = across > 0 ? (2.0 * i / across - 1) * half : 0;
        const double y = down > 0 ? double(j) / down * robot_.depth : 0;
        keep(depth(c + x * along - y * out) + 2 * slack_);
      }
  }

  // Whether a segment meets a rectangle (Y.-D. Liang and B. Barsky, 1984).
  static bool meets(const Vec2& p, const Vec2& q, double half, double low_y, double high_y) {
    double begin = 0, end = 1;
    const auto clip = [&](double at, double way, double low, double high) {
      if (way == 0) {
        if (at < low || at > high) end = -1;
        return;
      }
      const double first = (low - at) / way, last = (high - at) / way;
      begin = std::max(begin, std::min(first, last));
      end = std::min(end, std::max(first, last));
    };
    clip(p.x(), q.x() - p.x(), -half, half);
    clip(p.y(), q.y() - p.y(), low_y, high_y);
    return begin <= end;
  }

  // The same, surely: a line that only touches the end of the segment may be free.
  bool is_met(const Vec2& p, const Vec2& q, double half, double low_y, double high_y) const {
    if (half > 0) return meets(p, q, half, low_y, high_y);
    const Vec2 aside(slack_, 0);
    return meets(p + aside, q + aside, 0, low_y, high_y) &&
           meets(p - aside, q - aside, 0, low_y, high_y);
  }

  static constexpr int samples = 7;
  const Polygon& polygon_;
  RobotSize robot_;
  std::vector<EdgePart> no_go_;
  double slack_;
};

}  // namespace evenlift::testing
