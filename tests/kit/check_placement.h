// Checks the rules of algorithm.md on any Placement with short code that shares only public types
// with the core: plain doubles, and bounds with room only for rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift::check {

class Checker {
 public:
  explicit Checker(const Placement& placement) : p_(placement), c_(placement.centre_of_mass) {
    Vec2 low = p_.vertices().front(), high = low;
    double reach = 0;
    for (const Vec2& v : p_.vertices()) {
      low = componentwise_min(low, v);
      high = componentwise_max(high, v);
      reach = std::max(reach, max_norm(v));
    }
    size_ = std::hypot(high.x - low.x, high.y - low.y);
    near_ = 1e-9 * size_;
    // Only positions are rounded, to doubles at their absolute place.
    rounding_ = 1e-11 * size_ + 8 * 0x1p-52 * reach;
    double area = 0;
    for (std::size_t i = 0; i < n(); ++i) area += cross_(v(i) - v(0), v(i + 1) - v(0));
    orientation_ = area > 0 ? 1 : -1;
    area_ = 0.5 * std::fabs(area);
  }

  // A message for each broken rule.
  std::vector<std::string> run() {
    check_candidates();
    check_teams();
    check_loads();
    check_hull();
    check_coverage();
    check_closure();
    return std::move(wrong_);
  }

  // area(P and H) / area(P) by horizontal slabs between all corners and crossings: in a slab the
  // common width changes linearly, so its middle is enough.
  double coverage_by_slabs() const {
    if (p_.lifting_base.size() < 3) return 0;
    std::vector<double> ys;
    for (const Vec2& q : p_.vertices()) ys.push_back(q.y - c_.y);
    for (const Vec2& q : p_.lifting_base) ys.push_back(q.y - c_.y);
    for (std::size_t i = 0; i < n(); ++i) {
      for (std::size_t k = 0; k < p_.lifting_base.size(); ++k) {
        const Vec2 a = v(i) - c_, d = v(i + 1) - v(i), b = h(k) - c_, e = h(k + 1) - h(k);
        const double turn = cross_(d, e);
        if (turn == 0) continue;
        const double s = cross_(b - a, e) / turn, t = cross_(b - a, d) / turn;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) ys.push_back(a.y + s * d.y);
      }
    }
    std::sort(ys.begin(), ys.end());
    double covered = 0;
    for (std::size_t i = 1; i < ys.size(); ++i) {
      if (ys[i] > ys[i - 1])
        covered += (ys[i] - ys[i - 1]) * common_width(0.5 * (ys[i] + ys[i - 1]) + c_.y);
    }
    return covered / area_;
  }

 private:
  static double cross_(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
  static double dot_(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
  static double norm(const Vec2& a) { return std::hypot(a.x, a.y); }
  static double to_segment(const Vec2& q, const Vec2& a, const Vec2& b) {
    const Vec2 d = b - a;
    const double s = std::clamp(dot_(q - a, d) / dot_(d, d), 0.0, 1.0);
    return norm(q - a - s * d);
  }

  std::size_t n() const { return p_.vertices().size(); }
  const Vec2& v(std::size_t i) const { return p_.vertices()[i % n()]; }
  const Vec2& h(std::size_t i) const { return p_.lifting_base[i % p_.lifting_base.size()]; }

  template <class... Parts>
  void expect(bool holds, const Parts&... parts) {
    if (holds || wrong_.size() > 20) return;
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    wrong_.push_back(text.str());
  }

  bool selects_candidates() const {
    return p_.settings.method != Method::distributed && p_.settings.method != Method::random;
  }

  void check_chord(const Chord& chord, const std::string& name) {
    for (const LiftingPoint* r : {&chord.r1, &chord.r2}) {
      expect(r->edge < n(), name, " names no edge");
      if (r->edge >= n()) return;
      const double off = to_segment(r->position, v(r->edge), v(r->edge + 1));
      expect(off <= rounding_, name, " ends ", off, " away from its edge");
    }
    const Vec2 to1 = chord.r1.position - c_, to2 = chord.r2.position - c_;
    const double whole = norm(to2 - to1);
    expect(chord.arm1 > 0 && chord.arm2 > 0 && dot_(to1, to2) < 0, name, " has C not between");
    const double miss = std::fabs(cross_(to1, to2)) / whole;
    // Across from a random point, a radial edge's ends count as met, which is true within
    // tolerance. C is within tolerance of the line of opposite vertices.
    const bool opposite = at_vertex(chord.r1.position) && at_vertex(chord.r2.position);
    const double reach = p_.settings.method == Method::random || opposite ? near_ : 0;
    expect(miss <= reach + rounding_, name, " misses C by ", miss);
    expect(std::fabs(norm(to1) - chord.arm1) <= rounding_, name, " has a wrong arm1");
    expect(std::fabs(norm(to2) - chord.arm2) <= rounding_, name, " has a wrong arm2");
    const double ratio = std::min(chord.arm1, chord.arm2) / std::max(chord.arm1, chord.arm2);
    expect(std::fabs(ratio - chord.ratio) <= 1e-12, name, " has ratio ", chord.ratio,
           ", arms give ", ratio);
    expect(chord.ratio > 0 && chord.ratio <= 1, name, " has ratio ", chord.ratio);
    const Vec2 d = to2 - to1;
    const bool vertical = std::fabs(d.x) <= 1.001e-9 * whole + 2 * rounding_;
    expect(d.x > 0 || (vertical && d.y > 0), name, " runs to the left");
  }

  bool at_vertex(const Vec2& q) const {
    return std::any_of(p_.vertices().begin(), p_.vertices().end(),
                       [&](const Vec2& w) { return norm(w - q) <= rounding_; });
  }

  void check_candidates() {
    std::vector<std::size_t> by_x;
    for (std::size_t i = 0; i < p_.candidates.size(); ++i) {
      const Candidate& candidate = p_.candidates[i];
      const std::string name = "candidate " + std::to_string(i);
      check_chord(candidate.chord, name);
      const double ratio = candidate.chord.ratio;
      expect(ratio >= p_.settings.min_ratio - 1.001e-9, name, " is below the minimum: ", ratio);
      expect(candidate.kind != CandidateKind::bisecting || ratio >= 1 - 1e-9, name, " bisects by ",
             ratio);
      expect(candidate.kind != CandidateKind::vertex || at_vertex(candidate.chord.r1.position) ||
                 at_vertex(candidate.chord.r2.position),
             name, " touches no vertex");
      const Vec2 d = candidate.chord.r2.position - candidate.chord.r1.position;
      expect(std::fabs(candidate.length - norm(d)) <= rounding_, name, " has a wrong length");
      expect(norm(d / norm(d) - candidate.direction / norm(candidate.direction)) <=
                 4 * rounding_ / norm(d) + 1e-12,
             name, " has a wrong direction");
      if (i > 0) {
        // The slope does not fall: there is no turn to the right by less than 180 degrees.
        const Vec2& before = p_.candidates[i - 1].direction;
        const Vec2& here = candidate.direction;
        const bool vertical = std::fabs(before.x) <= 1e-9 * norm(before);
        const double turn = cross_(before, here) / (norm(before) * norm(here));
        // Two chords may agree only through a third one between them.
        const bool agree = std::fabs(turn) <= 2.002e-9;
        const bool both_vertical = vertical && std::fabs(here.x) <= 1.001e-9 * norm(here);
        expect(agree || both_vertical || (turn > 0 && !vertical), name, " is out of order");
      }
      by_x.push_back(i);
    }
    check_that_no_two_agree(by_x);
  }

  void check_that_no_two_agree(std::vector<std::size_t>& by_x) {
    const auto x = [&](std::size_t i) { return p_.candidates[i].chord.r1.position.x; };
    std::sort(by_x.begin(), by_x.end(), [&](std::size_t i, std::size_t j) { return x(i) < x(j); });
    for (std::size_t k = 0; k < by_x.size(); ++k) {
      for (std::size_t l = k + 1; l < by_x.size() && x(by_x[l]) <= x(by_x[k]) + near_; ++l) {
        const Chord &a = p_.candidates[by_x[k]].chord, &b = p_.candidates[by_x[l]].chord;
        // Representatives of different classes are not within the tolerance of each other; half of
        // it leaves room for rounding.
        expect(norm(a.r1.position - b.r1.position) > 0.5 * near_ ||
                   norm(a.r2.position - b.r2.position) > 0.5 * near_,
               "candidates ", by_x[k], " and ", by_x[l], " are the same");
      }
    }
  }

  void check_teams() {
    const std::size_t asked = p_.requested_teams;
    const std::size_t placed = p_.teams.size();
    expect(asked == p_.settings.teams.value_or(static_cast<std::uint32_t>(p_.candidates.size())),
           "asked for ", asked, " teams");
    expect(p_.team_candidates.size() == (selects_candidates() ? placed : 0),
           p_.team_candidates.size(), " candidates of ", placed, " teams");
    if (selects_candidates()) {
      if (p_.team_candidates.size() != placed) return;
      expect(placed == std::min(asked, p_.candidates.size()), placed, " teams placed of ", asked);
    } else {
      expect(placed <= asked, "more teams than asked for");
    }
    std::vector<char> taken(p_.candidates.size());
    for (std::size_t k = 0; k < placed; ++k) {
      const std::string name = "team " + std::to_string(k);
      check_chord(chord_of(p_.teams[k]), name);
      if (!selects_candidates()) continue;
      const std::uint32_t i = p_.team_candidates[k];
      expect(i < taken.size(), name, " took no candidate");
      if (i >= taken.size()) continue;
      expect(!taken[i]++, name, " took candidate ", i, " again");
      const Chord& chord = p_.candidates[i].chord;
      expect(chord.r1.position == chord_of(p_.teams[k]).r1.position &&
                 chord.r2.position == chord_of(p_.teams[k]).r2.position,
             name, " is elsewhere than its candidate");
    }
    if (selects_candidates() && placed > 0) check_first_team();
  }

  // The longest even candidate, else the largest ratio.
  void check_first_team() {
    const Candidate& first = p_.candidates[p_.team_candidates[0]];
    double longest_even = 0, largest_ratio = 0;
    for (const Candidate& candidate : p_.candidates) {
      largest_ratio = std::max(largest_ratio, candidate.chord.ratio);
      if (candidate.chord.ratio >= 1 - 1e-9)
        longest_even = std::max(longest_even, candidate.length);
    }
    if (longest_even > 0) {
      expect(first.chord.ratio >= 1 - 1e-9, "the first team is not even");
      expect(first.length >= longest_even * (1 - 1.001e-9), "the first team is not the longest");
    } else {
      expect(first.chord.ratio >= largest_ratio - 1.001e-9, "the first team is not the most even");
    }
  }

  void check_loads() {
    expect(p_.loads.has_value() == !p_.teams.empty(), "a summary of loads without teams, or none");
    if (!p_.loads || p_.teams.empty()) return;
    const double weight = p_.settings.weight, part = weight / static_cast<double>(p_.teams.size());
    double total = 0, least = weight, most = 0, share = 0;
    for (const Team& team : p_.teams) {
      const double l1 = team.robots[0].load, l2 = team.robots[1].load;
      expect(std::fabs(l1 + l2 - part) <= 1e-12 * part, "a team bears ", l1 + l2, " of ", part);
      const double torque = l1 * team.robots[0].arm - l2 * team.robots[1].arm;
      expect(std::fabs(torque) <= 1e-12 * l1 * team.robots[0].arm,
             "a team's loads turn the object");
      total += l1 + l2;
      least = std::min({least, l1, l2});
      most = std::max({most, l1, l2});
      share = std::max(share, std::max(l1, l2) / part);
    }
    const auto is = [&](double given, double expected, const char* what) {
      expect(std::fabs(given - expected) <= 1e-12 * weight, what, " load is ", given, ", not ",
             expected);
    };
    is(total, weight, "the whole");
    is(p_.loads->min, least, "the least");
    is(p_.loads->max, most, "the greatest");
    is(p_.loads->mean, 0.5 * part, "the mean");
    is(p_.loads->spread, most - least, "the spread of the");
    expect(std::fabs(p_.loads->max_share - share) <= 1e-12, "the greatest share is ",
           p_.loads->max_share, ", not ", share);
  }

  void check_hull() {
    const std::size_t corners = p_.lifting_base.size();
    expect(p_.teams.empty() == (corners == 0), "a hull without teams, or none");
    expect(corners != 1, "a hull of one point");
    for (const Vec2& corner : p_.lifting_base) {
      bool found = false;
      for (const Team& team : p_.teams)
        for (const Robot& robot : team.robots) found = found || robot.point.position == corner;
      expect(found, "a corner of the hull is no lifting point");
    }
    for (std::size_t i = 0; i < corners; ++i) {
      const Vec2 edge = h(i + 1) - h(i);
      if (corners >= 3)
        expect(cross_(edge, h(i + 2) - h(i + 1)) > -1e-14 * size_ * size_, "the hull has a dent");
      for (const Team& team : p_.teams) {
        for (const Robot& robot : team.robots) {
          const Vec2& q = robot.point.position;
          const double beyond =
              corners == 2 ? to_segment(q, h(0), h(1)) : -cross_(edge, q - h(i)) / norm(edge);
          // A segment represents points within tolerance on both sides of it.
          expect(beyond <= (corners == 2 ? 2.02 : 1.01) * near_ + rounding_,
                 "a lifting point lies outside the hull by ", beyond);
        }
      }
    }
  }

  // Of P and H, at a height without corners.
  double common_width(double y) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < p_.lifting_base.size(); ++k) {
      const Vec2 &a = h(k), &b = h(k + 1);
      if ((a.y < y) == (b.y < y)) continue;
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    std::vector<double> xs;
    for (std::size_t i = 0; i < n(); ++i) {
      const Vec2 &a = v(i), &b = v(i + 1);
      if ((a.y < y) == (b.y < y)) continue;
      xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(xs.begin(), xs.end());
    double width = 0;
    for (std::size_t i = 1; i < xs.size(); i += 2)
      width += std::max(0.0, std::min(xs[i], high) - std::max(xs[i - 1], low));
    return width;
  }

  void check_coverage() {
    const double coverage = p_.coverage;
    expect(coverage >= 0 && coverage <= 1, "coverage is ", coverage);
    if (p_.lifting_base.size() < 3)
      return expect(coverage == 0, "coverage without a hull: ", coverage);
    // Where coordinates are coarse, so are both areas.
    const double room = 1e-9 + 8 * rounding_ * size_ / area_;
    const double slabs = coverage_by_slabs();
    expect(std::fabs(coverage - slabs) <= room, "coverage is ", coverage, ", by slabs ", slabs);
  }

  struct Touch {
    Vec2 position, inward;
  };

  std::vector<Touch> touches() const {
    std::vector<Touch> touches;
    const auto touch = [&](const Vec2& q, std::size_t edge) {
      const Vec2 d = v(edge + 1) - v(edge);
      touches.push_back({q, orientation_ * Vec2(-d.y, d.x) / norm(d)});
    };
    for (const Team& team : p_.teams) {
      for (const Robot& robot : team.robots) {
        const LiftingPoint* r = &robot.point;
        std::size_t corner = n();
        for (std::size_t i = 0; i < n(); ++i)
          if (norm(v(i) - r->position) <= near_) corner = i;
        if (corner == n()) {
          touch(r->position, r->edge);
          continue;
        }
        const Vec2 before = v(corner) - v(corner + n() - 1), after = v(corner + 1) - v(corner);
        const double turn = orientation_ * cross_(before, after) / (norm(before) * norm(after));
        // Straight or nearly so: left to exact arithmetic.
        if (std::fabs(turn) < 1e-12) hard_ = true;
        if (turn > 0) continue;
        touch(v(corner), corner);
        if (turn < 0) touch(v(corner), corner + n() - 1);
      }
    }
    return touches;
  }

  void check_closure() {
    const Closure& closure = p_.closure;
    const std::vector<Touch> all = touches();
    expect(closure.form_closure == (!closure.translation_free && !closure.clockwise.exists &&
                                    !closure.counterclockwise.exists),
           "form closure is not that nothing is free");
    expect(closure.translation.has_value() == closure.translation_free, "a translation or none");
    expect(!closure.second_order ||
               (!closure.form_closure && !closure.translation_free && !closure.clockwise.has_area &&
                !closure.counterclockwise.has_area),
           "second order beside form closure or free motions");
    if (hard_) return;
    expect(closure.margin.has_value() == !all.empty(), "a margin without contacts, or none");
    if (closure.translation) {
      expect(std::fabs(norm(*closure.translation) - 1) <= 1e-12,
             "the translation is no unit vector");
      for (const Touch& t : all)
        expect(dot_(t.inward, *closure.translation) >= -1e-9, "the translation is blocked");
    } else {
      expect(!some_tangent_is_free(all), "a free translation was overlooked");
    }
    for (const int sense : {1, -1}) check_region(all, sense);
    if (closure.margin) check_margin(all);
  }

  // Free directions form a cone with tangents as rims. Only a certainly free one counts.
  static bool some_tangent_is_free(const std::vector<Touch>& all) {
    for (const Touch& rim : all) {
      for (const double sign : {1.0, -1.0}) {
        const Vec2 u = sign * Vec2(-rim.inward.y, rim.inward.x);
        const bool free = std::all_of(all.begin(), all.end(), [&](const Touch& t) {
          return dot_(t.inward, u) > 1e-9 || t.inward == rim.inward;
        });
        if (free) return true;
      }
    }
    return all.empty();
  }

  // How far q is on the free side of all normal lines; sense 1 is counter-clockwise.
  static double freedom(const std::vector<Touch>& all, int sense, const Vec2& q) {
    double least = std::numeric_limits<double>::infinity();
    for (const Touch& t : all) least = std::min(least, sense * cross_(t.inward, q - t.position));
    return least;
  }

  void check_region(const std::vector<Touch>& all, int sense) {
    const FreeRegion& region = sense > 0 ? p_.closure.counterclockwise : p_.closure.clockwise;
    const std::string name = sense > 0 ? "the counter-clockwise region" : "the clockwise region";
    expect(region.exists || (!region.has_area && region.clipped.empty()), name, " is and is not");
    for (const Vec2& q : region.clipped) {
      const double reach = max_norm(q - c_);
      expect(reach <= 100 * size_ * (1 + 1e-9), name, " leaves the square");
      // Widened by the tolerance; distant points are less exact. Directions of edges at a straight
      // vertex, and of normal lines beside a region without area, are known within tau.
      const double room = (region.has_area ? 1.01 : 4) * near_ + 1.01e-9 * reach;
      const double known_to = rounding_ * (1 + reach / size_);
      expect(freedom(all, sense, q) >= -room - known_to, name, " has a corner that is blocked by ",
             -freedom(all, sense, q) / near_, " tau L");
    }
    // Points where normal lines cross, and about C.
    bool free = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        const double turn = cross_(all[i].inward, all[j].inward);
        if (std::fabs(turn) < 1e-4) continue;
        const Vec2 q = all[i].position + cross_(all[j].position - all[i].position, all[j].inward) /
                                             turn * all[i].inward;
        free = free || freedom(all, sense, q) >= -1e-2 * near_ - rounding_;
      }
    }
    bool wide = false;
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j)
        wide = wide || freedom(all, sense, c_ + size_ / 8 * Vec2(i, j)) > 2 * near_;
    expect(region.exists || (!free && !wide), name, " was overlooked");
    expect(region.has_area || !wide, name, " is thought to have no area");
  }

  // Every unit vector bounds the margin from above. If the origin is inside, the normal of three
  // wrenches attains it; else that of two, or its opposite, shows that it is outside.
  void check_margin(const std::vector<Touch>& all) {
    using Wrench = std::array<double, 3>;
    double radius = 0;
    for (const Vec2& q : p_.vertices()) radius = std::max(radius, norm(q - c_));
    std::vector<Wrench> w;
    for (const Touch& t : all) {
      w.push_back({t.inward.x, t.inward.y, cross_(t.position - c_, t.inward) / radius});
      if (w.size() == 16) break;
    }
    if (all.size() > w.size()) return;
    const double margin = *p_.closure.margin;
    double least = std::numeric_limits<double>::infinity();
    const auto try_direction = [&](double x, double y, double z) {
      const double size = std::sqrt(x * x + y * y + z * z);
      if (size < 1e-6) return;
      double most = -std::numeric_limits<double>::infinity();
      for (const Wrench& a : w) most = std::max(most, (a[0] * x + a[1] * y + a[2] * z) / size);
      least = std::min(least, most);
    };
    const auto try_both = [&](double x, double y, double z) {
      try_direction(x, y, z);
      try_direction(-x, -y, -z);
    };
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        for (int k = -2; k <= 2; ++k) try_direction(i, j, k);
    for (std::size_t i = 0; i < w.size(); ++i) {
      try_both(w[i][0], w[i][1], w[i][2]);
      // At right angles to a wrench: two opposite wrenches leave these free.
      try_both(0, w[i][2], -w[i][1]);
      try_both(-w[i][2], 0, w[i][0]);
      try_both(w[i][1], -w[i][0], 0);
      for (std::size_t j = i + 1; j < w.size(); ++j) {
        const Wrench &a = w[i], &b = w[j];
        try_both(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
        for (std::size_t k = j + 1; k < w.size(); ++k) {
          Wrench p, q;
          for (std::size_t c = 0; c < 3; ++c) {
            p[c] = w[j][c] - w[i][c];
            q[c] = w[k][c] - w[i][c];
          }
          try_both(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
        }
      }
    }
    expect(margin <= least + 1e-7, "the margin is ", margin, ", a direction gives ", least);
    if (margin > 1e-6 || p_.closure.form_closure)
      expect(std::fabs(margin - least) <= 1e-7, "the margin is ", margin, ", facets give ", least);
    expect(margin < 1e-6 || p_.closure.form_closure, "a positive margin without form closure");
    expect(margin > -1e-6 || !p_.closure.form_closure, "form closure with a negative margin");
  }

  const Placement& p_;
  const Vec2 c_;
  double size_ = 0, near_ = 0, rounding_ = 0, area_ = 0, orientation_ = 1;
  mutable bool hard_ = false;
  std::vector<std::string> wrong_;
};

// Scaled by a power of two, which loses nothing, to keep products of coordinates in the range of
// doubles.
inline Placement in_handy_units(Placement placement) {
  double reach = 0;
  for (const Vec2& v : placement.vertices()) reach = std::max(reach, max_norm(v));
  const int exponent = std::ilogb(reach);
  if (exponent > -100) return placement;
  const auto scale = [&](double& x) { x = std::ldexp(x, -exponent); };
  const auto scale_point = [&](Vec2& q) {
    scale(q.x);
    scale(q.y);
  };
  const auto scale_chord = [&](Chord& chord) {
    scale_point(chord.r1.position);
    scale_point(chord.r2.position);
    scale(chord.arm1);
    scale(chord.arm2);
  };
  Points vertices = placement.vertices();
  for (Points* points : {&vertices, &placement.lifting_base, &placement.closure.clockwise.clipped,
                         &placement.closure.counterclockwise.clipped}) {
    std::for_each(points->begin(), points->end(), scale_point);
  }
  placement.object = PolygonWithHoles(*Polygon::create(std::move(vertices)));
  scale_point(placement.centre_of_mass);
  for (Team& team : placement.teams)
    for (Robot& robot : team.robots) {
      scale_point(robot.point.position);
      scale(robot.arm);
    }
  for (Candidate& candidate : placement.candidates) {
    scale_chord(candidate.chord);
    scale_point(candidate.direction);
    scale(candidate.length);
  }
  return placement;
}

// The broken rules, one a line.
inline std::string check_placement(const Placement& placement) {
  const Placement handy = in_handy_units(placement);
  std::string text;
  for (const std::string& sentence : Checker(handy).run()) text += sentence + "\n";
  return text;
}

}  // namespace evenlift::check
