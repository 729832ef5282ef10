#include "polygon/clip.h"

#include <optional>

namespace evenlift {
namespace {

// Clips a ring by a half-plane, point by point. Outputs each point inside and, before it, where the
// ring crossed the line since the last point.
class HalfPlaneClipper {
 public:
  HalfPlaneClipper(const Vec2& a, const Vec2& direction) : a_(a), line_(direction) {}

  double side(const Vec2& v) const { return cross(line_, v - a_); }

  void begin_after(const Vec2& last) {
    from_ = last;
    from_side_ = side(last);
  }

  template <class Emit>
  void advance(const Vec2& to, Emit emit) {
    const double to_side = side(to);
    if ((from_side_ < 0) != (to_side < 0)) {
      emit(Vec2(from_ + (from_side_ / (from_side_ - to_side)) * (to - from_)));
    }
    if (to_side >= 0) emit(to);
    from_ = to;
    from_side_ = to_side;
  }

  // The last output point for the whole ring, if any.
  std::optional<Vec2> find_last(const Points& ring) const {
    for (std::size_t i = ring.size(); i-- > 0;) {
      const Vec2 &from = ring[i == 0 ? ring.size() - 1 : i - 1], &to = ring[i];
      const double from_side = side(from), to_side = side(to);
      if (to_side < 0 && from_side < 0) continue;
      if (to_side >= 0) return to;
      return Vec2(from + (from_side / (from_side - to_side)) * (to - from));
    }
    return std::nullopt;
  }

 private:
  Vec2 a_, line_;
  Vec2 from_;
  double from_side_ = 0;
};

// Computes signed_area() from points one by one.
class RunningArea {
 public:
  void add(const Vec2& v) {
    if (number_++ == 0) {
      first_ = v;
      return;
    }
    const Vec2 arm = v - first_;
    if (number_ > 2) doubled_area_ += cross(arm_, arm);
    arm_ = arm;
  }
  double area() const { return 0.5 * doubled_area_; }

 private:
  std::size_t number_ = 0;
  Vec2 first_, arm_;
  double doubled_area_ = 0;
};

}  // namespace

Points clip_left(const Points& ring, const Vec2& a, const Vec2& b) {
  return clip_left_of_ray(ring, a, b - a);
}

Points clip_left_of_ray(const Points& ring, const Vec2& from, const Vec2& direction) {
  Points kept;
  if (ring.empty()) return kept;
  kept.reserve(ring.size() + 4);
  HalfPlaneClipper clipper(from, direction);
  clipper.begin_after(ring.back());
  for (const Vec2& v : ring) clipper.advance(v, [&](const Vec2& point) { kept.push_back(point); });
  return kept;
}

double area_left_of_both(const Points& ring, const Vec2& a, const Vec2& b, const Vec2& c) {
  HalfPlaneClipper first(a, b - a), second(b, c - b);
  const std::optional<Vec2> last = first.find_last(ring);
  if (!last) return 0;
  first.begin_after(ring.back());
  second.begin_after(*last);
  RunningArea area;
  for (const Vec2& v : ring) {
    first.advance(v, [&](const Vec2& point) {
      second.advance(point, [&](const Vec2& kept) { area.add(kept); });
    });
  }
  return area.area();
}

}  // namespace evenlift
