#include "candidates/pair_range.h"

#include <algorithm>

#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

// A corner of an edge of the range, and the direction away from it.
struct EdgeCorner {
  std::uint32_t edge;
  bool on_a;
  Vec2 at, away;
};

Vec2 end_of(const Vec2& centre, const PairRange& range, double x, bool on_a) {
  const Vec2 offset = (1 - x) * range.a0 + x * range.a1;
  return on_a ? Vec2(centre + offset) : Vec2(centre - offset / range.q(x));
}

class Part {
 public:
  Part(const FromCorners& from, const Vec2& centre, const PairRange& range)
      : from_(from), centre_(centre), range_(range), part_(range) {}

  std::optional<PairRange> find() {
    const Polygon& polygon = from_.polygon;
    for (const bool on_a : {true, false}) {
      const std::uint32_t edge = on_a ? range_.a : range_.b;
      const Vec2 along = polygon.edge_end(edge) - polygon.edge_start(edge);
      const Vec2 unit = along / length(along);
      if (const auto corner = from_.corners.before(edge))
        keep_off({edge, on_a, polygon.vertex(*corner), unit});
      if (const auto corner = from_.corners.after(edge))
        keep_off({edge, on_a, polygon.vertex(*corner), -unit});
    }
    if (part_.first > part_.last || !clear_) return std::nullopt;
    return evenlift::is_one_place(part_, near_distance(polygon.diameter())) ? std::nullopt
                                                                            : std::optional(part_);
  }

 private:
  // Narrows the part to places far enough from a corner.
  void keep_off(const EdgeCorner& corner) {
    const Vec2 at = lifting_point(corner.at, corner.edge);
    const auto is_clear = [&](double x) {
      const double distance = dot(end_of(centre_, range_, x, corner.on_a) - at, corner.away);
      return distance >= from_.clear - near_distance(from_.polygon.diameter());
    };
    const bool first = is_clear(range_.first), last = is_clear(range_.last);
    if (!first && !last) clear_ = false;
    if (first == last) return;
    const Vec2 nearest = at + from_.clear * corner.away;
    const Vec2 direction = corner.on_a ? Vec2(nearest - centre_) : Vec2(centre_ - nearest);
    const double x = place_towards(range_, direction);
    if (last)
      part_.first = std::max(part_.first, x);
    else
      part_.last = std::min(part_.last, x);
  }

  Vec2 lifting_point(const Vec2& contact, std::uint32_t edge) const {
    return from_.stands ? from_.stands->lifting_point({contact, edge}).position : contact;
  }

  const FromCorners& from_;
  Vec2 centre_;
  const PairRange& range_;
  PairRange part_;
  bool clear_ = true;
};

}  // namespace

std::optional<PairRange> clear_part(const FromCorners& from, const Vec2& centre,
                                    const PairRange& range) {
  return from.clear > 0 ? Part(from, centre, range).find() : std::nullopt;
}

double clear_place_at(const PairRange& range, const std::optional<PairRange>& clear, double s) {
  const double x = place_at(range, s);
  return clear ? std::clamp(x, clear->first, clear->last) : x;
}

}  // namespace evenlift
