// Whether a robot can stand at a place, by the four conditions alone: every edge is checked, also
// of holes, and counted crossings decide whether a point is in the object. Also whether robots
// collide, by bodies, arms and hands.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "evenlift/stands.h"

namespace evenlift::testing {

class StandOracle {
 public:
  // Beyond `slack` from its bound, a condition is surely broken or kept.
  StandOracle(const Polygon& polygon, const RobotSize& robot, const std::vector<EdgePart>& no_go,
              const std::vector<Polygon>& holes = {})
      : polygon_(polygon),
        robot_(robot),
        no_go_(no_go),
        holes_(holes),
        slack_(1e-7 * polygon.diagonal()) {}

  enum class Verdict { stands, cannot, unsure };

  Verdict at(std::size_t edge, double part) const {
    const Vec2 p = polygon_.edge_start(edge), q = polygon_.edge_end(edge);
    const double size = length(q - p);
    const Vec2 along = (q - p) / size, out = outward(edge);
    const Vec2 c = p + part * (q - p);
    Verdict verdict = Verdict::stands;
    const auto keep = [&](double room) { this->keep(verdict, room); };
    for (const EdgePart& no : no_go_)
      if (no.edge == edge)
        keep(std::max(no.from - part, part - no.to) * size - robot_.width / 2);
      else if (robot_.width > 0)
        keep(room_beside(no, c, along, out));
    check_body(edge, c + (robot_.radius + robot_.reach) * out, keep);
    check_arm(edge, c, out, keep);
    check_hand(edge, c, along, out, keep);
    return verdict;
  }

  // Whether robots that can stand alone, given by their contacts, can stand beside each other.
  // Collisions of bodies, arms and hands are counted separately for the tests.
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
  // From the hand to the no-go part of another edge, within the strip w/10 deep beneath the hand's
  // edge; 0 where that depends on the strip's bounds.
  double room_beside(const EdgePart& no, const Vec2& c, const Vec2& along, const Vec2& out) const {
    const Vec2 p = polygon_.edge_start(no.edge), way = polygon_.edge_end(no.edge) - p;
    const auto room = [&](double slack) {
      const double low = -robot_.width / 10 - slack, high = slack;
      double from = no.from, to = no.to;
      const double y = dot(p - c, out), rise = dot(way, out);
      for (const double sign :
           {1.0, -1.0}) {  // keeps the part of the segment above low and below high
        const double start = sign * y - (sign > 0 ? low : -high), climb = sign * rise;
        if (climb == 0 && start < 0) to = -1;
        if (climb > 0) from = std::max(from, -start / climb);
        if (climb < 0) to = std::min(to, -start / climb);
      }
      if (from > to) return 1e9;
      const double a = dot(p + from * way - c, along), b = dot(p + to * way - c, along);
      return std::max(std::min(a, b), -std::max(a, b)) - robot_.width / 2;
    };
    const double widest = room(slack_), narrowest = room(-slack_);
    return widest > 0 ? widest : std::min(narrowest, 0.0);
  }

  Vec2 outward(std::size_t edge) const {
    const Vec2 p = polygon_.edge_start(edge), q = polygon_.edge_end(edge);
    const Vec2 along = (q - p) / length(q - p);
    return polygon_.counter_clockwise() ? Vec2(along.y, -along.x) : Vec2(-along.y, along.x);
  }

  // Above 0, the condition is kept.
  void keep(Verdict& verdict, double room) const {
    if (room < -slack_) verdict = Verdict::cannot;
    if (std::fabs(room) <= slack_ && verdict == Verdict::stands) verdict = Verdict::unsure;
  }

  // How far the segments p + [0, 1] u and q + [0, 1] v are from crossing; negative by how much they
  // cross. Nearly parallel ones are unsure if they overlap.
  double between(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v) const {
    const double side = cross(u, v), sizes = length(u) * length(v);
    if (!(sizes > 0)) return 2 * slack_;
    if (std::fabs(side) < 1e-5 * sizes) return distance(p, u, q, v) > slack_ ? 2 * slack_ : 0;
    const double x = cross(q - p, v) / side, y = cross(q - p, u) / side;
    const double out_x = std::max(-x, x - 1) * length(u), out_y = std::max(-y, y - 1) * length(v);
    // Seen from the side, an end slightly beyond the other segment is near it.
    return std::max(out_x, out_y) * std::fabs(side) / sizes;
  }

  // If they do not cross.
  static double distance(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v) {
    return std::min(std::min(to_segment(p, q, q + v), to_segment(p + u, q, q + v)),
                    std::min(to_segment(q, p, p + u), to_segment(q + v, p, p + u)));
  }

  static double to_segment(const Vec2& s, const Vec2& a, const Vec2& b) {
    const double squared = dot(b - a, b - a);
    const double part = squared > 0 ? std::clamp(dot(s - a, b - a) / squared, 0.0, 1.0) : 0;
    return length(s - a - part * (b - a));
  }

  template <class Keep>
  void check_body(std::size_t edge, const Vec2& s, Keep keep) const {
    for (std::size_t f = 0; f < polygon_.size() && robot_.radius > 0; ++f)
      if (f != edge)
        keep(to_segment(s, polygon_.edge_start(f), polygon_.edge_end(f)) - robot_.radius);
  }

  // All edges except one of the outline.
  template <class Visit>
  void for_each_edge_but(std::size_t edge, Visit visit) const {
    for (std::size_t f = 0; f < polygon_.size(); ++f)
      if (f != edge) visit(polygon_.edge_start(f), polygon_.edge_end(f));
    for (const Polygon& hole : holes_)
      for (std::size_t f = 0; f < hole.size(); ++f) visit(hole.edge_start(f), hole.edge_end(f));
  }

  // Below 0 outside and in a hole.
  double depth(const Vec2& s) const {
    bool inside = false;
    double nearest = 1e300;
    for_each_edge_but(polygon_.size(), [&](const Vec2& a, const Vec2& b) {
      nearest = std::min(nearest, to_segment(s, a, b));
      if ((a.y > s.y) != (b.y > s.y) && s.x < a.x + (s.y - a.y) / (b.y - a.y) * (b.x - a.x))
        inside = !inside;
    });
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

  // Positive where it is convex.
  double turn_in_degrees(std::size_t vertex) const {
    const Vec2 in = polygon_.vertex(vertex) - polygon_.vertex(polygon_.previous(vertex)),
               out = polygon_.vertex(polygon_.next(vertex)) - polygon_.vertex(vertex);
    const double turn = std::atan2(cross(in, out), dot(in, out)) * 180 / std::acos(-1.0);
    return polygon_.counter_clockwise() ? turn : -turn;
  }

  // Extra vertices on straight sides change nothing.
  template <class Keep>
  void check_corners(std::size_t edge, const Vec2& c, Keep keep) const {
    for (const bool at_end : {false, true}) {
      std::size_t vertex = at_end ? polygon_.next(edge) : edge;
      while (polygon_.turn(vertex) == Turn::straight)
        vertex = at_end ? polygon_.next(vertex) : polygon_.previous(vertex);
      const double room = length(polygon_.vertex(vertex) - c) - robot_.width / 2;
      const double beyond = turn_in_degrees(vertex) - 15;
      if (beyond > -1e-6) keep(beyond < 1e-6 ? std::max(room, 0.0) : room);
    }
  }

  template <class Keep>
  void check_hand(std::size_t edge, const Vec2& c, const Vec2& along, const Vec2& out,
                  Keep keep) const {
    check_corners(edge, c, keep);
    const double half = robot_.width / 2, from = robot_.width / 10, to = robot_.depth;
    if (from >= to) return;
    // Parts thinner than the spacing of the samples below. A deeper search meets a slanting edge
    // slightly farther along.
    const double aside = 20 * slack_;
    for_each_edge_but(edge, [&](const Vec2& start, const Vec2& end) {
      const auto seen = [&](const Vec2& p) { return Vec2(dot(p - c, along), -dot(p - c, out)); };
      const Vec2 p = seen(start), q = seen(end);
      if (is_met(p, q, std::max(half - aside, 0.0), from + slack_, to - slack_))
        keep(-1);
      else if (meets(p, q, half + aside, std::max(from - slack_, slack_), to + slack_))
        keep(0);
    });
    const int across = robot_.width > 0 ? samples : 0;
    for (int i = 0; i <= across; ++i)
      for (int j = 0; j <= samples; ++j) {
        const double x = across > 0 ? (2.0 * i / across - 1) * half : 0;
        const double y = from + double(j) / samples * (to - from);
        keep(depth(c + x * along - y * out) + 2 * slack_);
      }
  }

  // By Y.-D. Liang and B. Barsky, 1984.
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
    clip(p.x, q.x - p.x, -half, half);
    clip(p.y, q.y - p.y, low_y, high_y);
    return begin <= end;
  }

  // Surely meets it: a line that only touches the segment's end may be free.
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
  std::vector<Polygon> holes_;
  double slack_;
};

}  // namespace evenlift::testing
