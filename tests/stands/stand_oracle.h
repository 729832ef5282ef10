// Whether a robot can stand at a place, by the four conditions and nothing else: every edge is looked at,
// and what lies within the object is decided by counting crossings. And whether two robots get into
// each other's way, by bodies, arms and hands.
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
    const Vec2 along = (q - p) / size, out = outward(edge);
    const Vec2 c = p + part * (q - p);
    Verdict verdict = Verdict::stands;
    const auto keep = [&](double room) { this->keep(verdict, room); };
    for (const EdgePart& no : no_go_)
      if (no.edge == edge) keep(std::max(no.from - part, part - no.to) * size - robot_.width / 2);
    check_body(edge, c + (robot_.radius + robot_.reach) * out, keep);
    check_arm(edge, c, out, keep);
    check_hand(edge, part * size, size, c, along, out, keep);
    return verdict;
  }

  // Two robots by their contacts: whether they stand beside each other, each alone being able to.
  // What they do is counted for the tests: which of bodies, arms and hands was in the way.
  struct Clashes {
    int bodies = 0, arms = 0, hands = 0;
  };
  Verdict beside(const LiftingPoint& a, const LiftingPoint& b, Clashes& clashes) const {
    const Vec2 out_a = outward(a.edge), out_b = outward(b.edge);
    const double way = robot_.radius + robot_.reach;
    const Vec2 s = a.position + way * out_a, t = b.position + way * out_b;
    const double r = robot_.radius, k = robot_.gap;
    Verdict bodies = Verdict::stands, arms = Verdict::stands, hands = Verdict::stands;
    if (r > 0 || k > 0) keep(bodies, length(s - t) - (2 * r + k));
    if (robot_.reach > 0) {
      if (r > 0 || k > 0)
        keep(arms, std::min(to_segment(s, b.position, t), to_segment(t, a.position, s)) - (r + k));
      keep(arms, between(a.position, way * out_a, b.position, way * out_b));
    }
    const Vec2 in_a = -robot_.depth * out_a, in_b = -robot_.depth * out_b;
    if (robot_.width > 0) {
      const double crossing = between(a.position, in_a, b.position, in_b);
      const double room = crossing < 0 ? 0 : distance(a.position, in_a, b.position, in_b);
      keep(hands, room - robot_.width);
    }
    clashes.bodies += bodies == Verdict::cannot;
    clashes.arms += arms == Verdict::cannot && bodies == Verdict::stands;
    clashes.hands += hands == Verdict::cannot;
    for (const Verdict verdict : {Verdict::cannot, Verdict::unsure})
      if (bodies == verdict || arms == verdict || hands == verdict) return verdict;
    return Verdict::stands;
  }

 private:
  Vec2 outward(std::size_t edge) const {
    const Vec2 p = polygon_.edge_start(edge), q = polygon_.edge_end(edge);
    const Vec2 along = (q - p) / length(q - p);
    return polygon_.counter_clockwise() ? Vec2(along.y(), -along.x()) : Vec2(-along.y(), along.x());
  }

  // Keeps the verdict up to date with how much room there is for a condition: above 0 it is kept.
  void keep(Verdict& verdict, double room) const {
    if (room < -slack_) verdict = Verdict::cannot;
    if (std::fabs(room) <= slack_ && verdict == Verdict::stands) verdict = Verdict::unsure;
  }

  // How far the segments p + [0, 1] u and q + [0, 1] v are from crossing: below 0 by how much they
  // cross. Segments that are nearly parallel count as unsure if they overlap.
  double between(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v) const {
    const double side = cross(u, v), sizes = length(u) * length(v);
    if (!(sizes > 0)) return 2 * slack_;
    if (std::fabs(side) < 1e-5 * sizes) return distance(p, u, q, v) > slack_ ? 2 * slack_ : 0;
    const double x = cross(q - p, v) / side, y = cross(q - p, u) / side;
    const double out_x = std::max(-x, x - 1) * length(u), out_y = std::max(-y, y - 1) * length(v);
    // From the side, an end that goes beyond the other segment by little is near to it.
    return std::max(out_x, out_y) * std::fabs(side) / sizes;
  }

  // Of segments that do not cross.
  static double distance(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v) {
    return std::min(std::min(to_segment(p, q, q + v), to_segment(p + u, q, q + v)),
                    std::min(to_segment(q, p, p + u), to_segment(q + v, p, p + u)));
  }

  static double to_segment(const Vec2& s, const Vec2& a, const Vec2& b) {
    const double square = dot(b - a, b - a);
    const double part = square > 0 ? std::clamp(dot(s - a, b - a) / square, 0.0, 1.0) : 0;
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
