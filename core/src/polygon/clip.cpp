#include "polygon/clip.h"

namespace evenlift {
namespace {

// One half-plane's part in clipping: of the chain's points, one after another, it passes on those
// that are inside, and before each where the chain crossed the line since the last.
class Clip {
 public:
  Clip(const Vec2& a, const Vec2& direction) : a_(a), line_(direction) {}

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

  // The last point that it will pass on of the whole chain; false if there is none.
  bool find_last(const Points& chain, Vec2& last) const {
    for (std::size_t i = chain.size(); i-- > 0;) {
      const Vec2 &from = chain[i == 0 ? chain.size() - 1 : i - 1], &to = chain[i];
      const double from_side = side(from), to_side = side(to);
      if (to_side < 0 && from_side < 0) continue;
      last = to_side >= 0 ? to : Vec2(from + (from_side / (from_side - to_side)) * (to - from));
      return true;
    }
    return false;
  }

 private:
  Vec2 a_, line_;
  Vec2 from_ = Vec2::Zero();
  double from_side_ = 0;
};

// signed_area of points that come one by one.
class RunningArea {
 public:
  void add(const Vec2& v) {
    if (number_++ == 0) {
      first_ = v;
      return;
    }
    const Vec2 arm = v - first_;
    if (number_ > 2) twice_ += cross(arm_, arm);
    arm_ = arm;
  }
  double area() const { return 0.5 * twice_; }

 private:
  std::size_t number_ = 0;
  Vec2 first_ = Vec2::Zero(), arm_ = Vec2::Zero();
  double twice_ = 0;
};

}  // namespace

Points clip_left(const Points& chain, const Vec2& a, const Vec2& b) {
  return clip_left_of_ray(chain, a, b - a);
}

Points clip_left_of_ray(const Points& chain, const Vec2& from, const Vec2& direction) {
  Points kept;
  if (chain.empty()) return kept;
  kept.reserve(chain.size() + 4);
  Clip clip(from, direction);
  clip.begin_after(chain.back());
  for (const Vec2& v : chain) clip.advance(v, [&](const Vec2& point) { kept.push_back(point); });
  return kept;
}

double area_left_of_both(const Points& chain, const Vec2& a, const Vec2& b, const Vec2& c) {
  Clip first(a, b - a), second(b, c - b);
  Vec2 last = Vec2::Zero();
  if (!first.find_last(chain, last)) return 0;
  first.begin_after(chain.back());
  second.begin_after(last);
  RunningArea area;
  for (const Vec2& v : chain) {
    first.advance(v, [&](const Vec2& point) {
      second.advance(point, [&](const Vec2& kept) { area.add(kept); });
    });
  }
  return area.area();
}

}  // namespace evenlift
