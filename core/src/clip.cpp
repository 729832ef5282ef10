#include "clip.h"

namespace evenlift {

Points clip_left(const Points& chain, const Vec2& a, const Vec2& b) {
  Points kept;
  if (chain.empty()) return kept;
  kept.reserve(chain.size() + 4);
  const Vec2 line = b - a;
  const auto side_of = [&](const Vec2& v) { return cross(line, v - a); };
  Vec2 from = chain.back();
  double from_side = side_of(from);
  for (const Vec2& to : chain) {
    const double to_side = side_of(to);
    if ((from_side < 0) != (to_side < 0)) {
      kept.push_back(from + (from_side / (from_side - to_side)) * (to - from));
    }
    if (to_side >= 0) kept.push_back(to);
    from = to;
    from_side = to_side;
  }
  return kept;
}

}  // namespace evenlift
