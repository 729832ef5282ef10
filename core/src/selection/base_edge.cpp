#include "selection/greedy_selector.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/angles.h"
#include "evenlift/hull.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"

namespace evenlift {
namespace {

// The inverse of pseudo_angle, with |x| + |y| = 1.
Vec2 direction_with_pseudo_angle(double angle) {
  if (angle >= 4) angle -= 4;
  if (angle < 1) return {1 - angle, angle};
  if (angle < 2) return {1 - angle, 2 - angle};
  if (angle < 3) return {angle - 3, 2 - angle};
  return {angle - 3, angle - 4};
}

// The share of the area between C and a segment with ends at levels s and t.
double share_up_to(double level, double s, double t) {
  if (s > t) std::swap(s, t);
  if (t <= level) return 1;
  if (s >= level) return level > 0 ? (level / s) * (level / t) : 0;
  const double along = (level - s) / (t - s);
  return along + (1 - along) * (level / t);
}

// About as many parts as each has items. In measurements, more than a few dozen bins made bounds no
// cheaper.
std::size_t number_of_parts(std::size_t m, std::size_t most) {
  return std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(m))), std::size_t{1},
                    most);
}

}  // namespace

struct AreaBins::Piece {
  std::size_t bin;
  double area;  // from C to the piece, positive counter-clockwise
  double level_from, level_to;
};

AreaBins::AreaBins(const Points& region, const Vec2& h1, const Vec2& h2, double diameter)
    : h1_(h1),
      h2_(h2),
      pseudo_angle1_(pseudo_angle(h1)),
      width_(pseudo_angle_from(pseudo_angle1_, pseudo_angle(h2))) {
  make_bins(number_of_parts(region.size(), 64));
  const std::vector<Piece> pieces = split(region);
  measure_levels(pieces);
  // A sum has at most a term for each piece and bin, each off by about 1e-16 L^2. Measuring a piece
  // adds a few dozen roundings (`before`).
  constexpr double per_term = 1e-14, before = 100;
  error_bound_ =
      per_term * diameter * diameter * (static_cast<double>(pieces.size() + bins_.size()) + before);
}

void AreaBins::make_bins(std::size_t number) {
  bins_.resize(number);
  rims_.reserve(number + 1);
  rims_.push_back(h1_ / one_norm(h1_));
  for (std::size_t k = 1; k < number; ++k) {
    rims_.push_back(direction_with_pseudo_angle(
        pseudo_angle1_ + width_ * (static_cast<double>(k) / static_cast<double>(number))));
  }
  rims_.push_back(h2_ / one_norm(h2_));
  for (std::size_t k = 0; k < number; ++k) {
    const Vec2 &u = rims_[k], &v = rims_[k + 1];
    const double doubled_area = cross(u, v);
    bins_[k].unit = 0.5 * doubled_area;
    bins_[k].outward = -left_normal(v - u) / doubled_area;
    bins_[k].base = bins_[k].unit * level_at_rim(h1_, h2_, k) * level_at_rim(h1_, h2_, k + 1);
  }
}

std::size_t AreaBins::bin_of(const Vec2& v) const {
  const double part = pseudo_angle_from(pseudo_angle1_, pseudo_angle(v)) / width_ *
                      static_cast<double>(bins_.size());
  return static_cast<std::size_t>(std::clamp(part, 0.0, static_cast<double>(bins_.size() - 1)));
}

// Where the line a -> b meets a rim, in units of the rim's vector. The line goes through h1 at the
// first rim and h2 at the last.
double AreaBins::level_at_rim(const Vec2& a, const Vec2& b, std::size_t rim) const {
  if (rim == 0) return one_norm(h1_);
  if (rim == bins_.size()) return one_norm(h2_);
  const Vec2 line = b - a;
  return cross(line, a) / cross(line, rims_[rim]);
}

std::vector<AreaBins::Piece> AreaBins::split(const Points& region) const {
  std::vector<Piece> pieces;
  pieces.reserve(region.size() + 4 * bins_.size());
  const auto add = [&](std::size_t bin, const Vec2& from, const Vec2& to) {
    const Vec2& outward = bins_[bin].outward;
    pieces.push_back({bin, 0.5 * cross(from, to), dot(outward, from), dot(outward, to)});
  };
  Vec2 from = region.back();
  std::size_t from_bin = bin_of(from);
  for (const Vec2& to : region) {
    const std::size_t to_bin = bin_of(to);
    Vec2 at = from;
    for (std::size_t bin = from_bin; bin != to_bin;) {
      const bool onward = bin < to_bin;
      const Vec2& rim = rims_[onward ? bin + 1 : bin];
      const double side_from = cross(rim, from), side_to = cross(rim, to);
      const double along = std::clamp(side_from / (side_from - side_to), 0.0, 1.0);
      const Vec2 crossing = from + along * (to - from);
      add(bin, at, crossing);
      at = crossing;
      bin = onward ? bin + 1 : bin - 1;
    }
    add(to_bin, at, to);
    from = to;
    from_bin = to_bin;
  }
  return pieces;
}

void AreaBins::measure_levels(const std::vector<Piece>& pieces) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> highest(bins_.size(), -infinity);
  for (Bin& bin : bins_) bin.lowest = infinity;
  for (const Piece& piece : pieces) {
    Bin& bin = bins_[piece.bin];
    // A clockwise piece bounds the region towards C, where the triangle is the better bound.
    if (piece.area > 0) bin.lowest = std::min({bin.lowest, piece.level_from, piece.level_to});
    highest[piece.bin] = std::max({highest[piece.bin], piece.level_from, piece.level_to});
  }
  for (std::size_t k = 0; k < bins_.size(); ++k) {
    Bin& bin = bins_[k];
    bin.lowest = std::clamp(bin.lowest, 0.0, std::max(0.0, highest[k]));
    bin.step = std::max(0.0, highest[k] - bin.lowest) / levels;
  }
  for (const Piece& piece : pieces) {
    Bin& bin = bins_[piece.bin];
    for (int j = 0; j < levels; ++j) {
      bin.inside[static_cast<std::size_t>(j)] +=
          piece.area * share_up_to(bin.lowest + j * bin.step, piece.level_from, piece.level_to);
    }
    bin.inside[levels] += piece.area;
  }
}

// As if the region filled the bin between known levels.
double AreaBins::Bin::inside_at_most(double level) const {
  const double steps = (level - lowest) / step;
  if (!(steps < levels)) return inside[levels];
  if (steps <= 0) return inside[0];
  const auto j = static_cast<std::size_t>(steps);
  const double below = lowest + static_cast<double>(j) * step;
  return std::min(inside[j + 1], inside[j] + unit * (level + below) * (level - below));
}

double AreaBins::bound(const Vec2& p) const {
  const std::size_t split = bin_of(p);
  const auto part = [](const Bin& bin, double triangle, double low, double high) {
    const double region = std::min(bin.inside_at_most(high),
                                   bin.inside_at_most(low) + (triangle - bin.unit * low * low));
    return std::min(triangle - bin.base, region);
  };
  double sum = 0;
  double from = one_norm(h1_);
  for (std::size_t k = 0; k < bins_.size(); ++k) {
    const Bin& bin = bins_[k];
    if (k == split) {
      const double to = level_at_rim(p, h2_, k + 1), top = dot(bin.outward, p);
      const double triangle = 0.5 * (from * cross(rims_[k], p) + to * cross(p, rims_[k + 1]));
      sum += part(bin, triangle, std::min({from, top, to}), std::max({from, top, to}));
      from = to;
      continue;
    }
    const double to = k < split ? level_at_rim(h1_, p, k + 1) : level_at_rim(p, h2_, k + 1);
    sum += part(bin, bin.unit * from * to, std::min(from, to), std::max(from, to));
    from = to;
  }
  return sum + error_bound_;
}

struct DistanceBlocks::Line {
  Vec2 start, along;
  double length;
  double side;  // along x start
};

DistanceBlocks::DistanceBlocks(Points points) : points_(std::move(points)) {
  const std::size_t n = points_.size();
  size_ = std::max(std::size_t{16}, n / number_of_parts(n, 256));
  levels_.reserve(n);
  sums_.resize(n);
  for (std::size_t begin = 0; begin < n; begin += size_) {
    const std::size_t end = std::min(begin + size_, n);
    const Vec2& ahead = aheads_.emplace_back(points_[begin + (end - begin) / 2]);
    const auto level = [&](std::size_t k) { return dot(ahead, points_[begin + k]); };
    const SortedIndices order = sorted_indices(
        end - begin, [&](std::uint32_t i, std::uint32_t j) { return level(i) < level(j); });
    for (const std::uint32_t i : order) levels_.push_back(level(i));
    Vec2 sum;
    for (std::size_t k = end; k-- > begin;) sums_[k] = sum += points_[begin + order[k - begin]];
  }
}

double DistanceBlocks::least_sum_beyond(const Vec2& a, const Vec2& b, std::size_t first,
                                        std::size_t last) const {
  const Vec2 along = b - a;
  const Line line{a, along, length(along), cross(along, a)};
  double sum = 0;  // times the line's length
  for (std::size_t i = first; i < last;) {
    const std::size_t block = i / size_, end = std::min((block + 1) * size_, points_.size());
    if (i == block * size_ && end <= last) {
      sum += least_sum_of_block(line, block);
      i = end;
      continue;
    }
    sum += std::max(0.0, line.side - cross(along, points_[i]));
    ++i;
  }
  return sum / line.length;
}

// Any subset of the points gives a lower bound. This takes those at or above the level where the
// line meets the block's middle direction.
double DistanceBlocks::least_sum_of_block(const Line& line, std::size_t block) const {
  const Vec2& ahead = aheads_[block];
  const double level = dot(ahead, ahead) * (line.side / cross(line.along, ahead));
  const auto begin = levels_.begin() + static_cast<std::ptrdiff_t>(block * size_);
  const auto end =
      levels_.begin() + static_cast<std::ptrdiff_t>(std::min((block + 1) * size_, levels_.size()));
  const auto found = std::lower_bound(begin, end, level);
  if (found == end) return 0;
  const Vec2& sum = sums_[static_cast<std::size_t>(found - levels_.begin())];
  return std::max(0.0, static_cast<double>(end - found) * line.side - cross(line.along, sum));
}

namespace {

// Bounds are raised by these, so that rounding cannot make them too low: the area of a clipped
// polygon (in units of L^2), each summed distance (in units of L), and areas (by a factor). Each is
// at least a thousand times the error; the only cost is a few more full evaluations.
constexpr double clipping = 1e-13, per_distance = 1e-12, rounded_up = 1 + 1e-9;

// The signed distance of v from the line a -> b, positive to the right: outside, for an edge of H.
double distance_outside(const Vec2& a, const Vec2& b, const Vec2& v) {
  const Vec2 line = b - a;
  return -cross(line, v - a) / length(line);
}

// distance_outside() for one line and many points.
class Outside {
 public:
  Outside(const Vec2& a, const Vec2& b) : start_(a), line_(b - a), length_(length(line_)) {}
  double distance(const Vec2& v) const { return -cross(line_, v - start_) / length_; }

 private:
  Vec2 start_, line_;
  double length_;
};

double triangle_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return 0.5 * std::fabs(cross(b - a, c - a));
}

double inscribed_circle_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double perimeter = length(b - a) + length(c - b) + length(a - c);
  const double radius = 2 * triangle_area(a, b, c) / perimeter;
  return pi * radius * radius;
}

}  // namespace

Surroundings::Surroundings(const PolygonWithHoles& object, const Vec2& centre)
    : convex(object.convex()), diameter(object.outline().diameter()) {
  const Polygon& polygon = object.outline();
  boundary.reserve(object.boundary().size());
  for (const Vec2& v : object.boundary()) boundary.push_back(v - centre);
  vertices.reserve(polygon.size());
  for (const Vec2& v : polygon.vertices()) {
    const Vec2 relative = v - centre;
    if (v != centre) vertices.push_back({relative, pseudo_angle(relative)});
  }
  if (!polygon.counter_clockwise()) std::reverse(boundary.begin(), boundary.end());
  sort_items(vertices, [](const Seen& a, const Seen& b) {
    if (a.pseudo_angle != b.pseudo_angle) return a.pseudo_angle < b.pseudo_angle;
    if (a.position.x != b.position.x) return a.position.x < b.position.x;
    return a.position.y < b.position.y;
  });
}

Wedge::Wedge(const Surroundings& surroundings, Metric metric, const Vec2& h1, const Vec2& h2)
    : surroundings_(&surroundings),
      metric_(metric),
      h1_(h1),
      h2_(h2),
      pseudo_angle1_(pseudo_angle(h1)) {
  if (metric == Metric::area && !surroundings.convex) collect_area();
  if (metric == Metric::distance) collect_outer_vertices();
}

// Only the area in the triangle h1 h2 p counts in the end. To save time, this removes the area that
// C does not see between h1 and h2, except for a rim: p in a corner's direction may miss it by half
// the rim's width.
void Wedge::collect_area() {
  outside_ = clip_left(surroundings_->boundary, h2_, h1_);
  if (is_convex()) {
    const auto clip = [&](const Vec2& direction) {
      const Vec2 outward = -left_normal(direction) / length(direction);
      const double rim = 2 * near_distance(surroundings_->diameter);
      outside_ = clip_left_of_ray(outside_, rim * outward, direction);
    };
    clip(h1_);
    clip(-h2_);
  }
  outside_area_ = signed_area(outside_);
}

// If C is on the edge, rounding decides its side; the result is still true.
bool Wedge::is_convex() const {
  const double past_180 = -cross(h1_, h2_) / std::min(length(h1_), length(h2_));
  constexpr double rounding = 0x1p-44;
  return past_180 <= rounding * surroundings_->diameter;
}

void Wedge::collect_outer_vertices() {
  sums_.push_back(Vec2{});
  const auto seen = [](const Surroundings::Seen& item) -> const Surroundings::Seen& {
    return item;
  };
  const auto note = [&](const Surroundings::Seen& vertex, SeenAt seen_at) {
    // A vertex within H adds nothing. But if H is a segment, a vertex in a corner's direction may
    // be beyond it on the segment's line: not outside that line, yet outside the new edge.
    const double distance = std::max(0.0, this->distance(vertex.position));
    if (distance == 0 && seen_at == SeenAt::between) return;
    outer_.push_back(
        {vertex.position, pseudo_angle_from(pseudo_angle1_, vertex.pseudo_angle), distance});
    sums_.push_back(sums_.back() + vertex.position);
    distance_sum_ += distance;
  };
  for_each_between(surroundings_->vertices, seen, h1_, h2_, note);
}

double Wedge::distance(const Vec2& p) const { return distance_outside(h1_, h2_, p); }

Gain Wedge::estimate(const Vec2& p) const {
  switch (metric_) {
    case Metric::circle:
      return {inscribed_circle_area(h1_, h2_, p), Certainty::exact};
    case Metric::distance:
      return {distance_bound(p), Certainty::bound};
    case Metric::area:
      break;
  }
  const double triangle = triangle_area(h1_, h2_, p);
  if (surroundings_->convex) return {triangle, Certainty::exact};
  const double error = clipping * surroundings_->diameter * surroundings_->diameter;
  return {std::min(triangle, outside_area_) * rounded_up + error, Certainty::bound};
}

double Wedge::evaluate(const Vec2& p) const {
  switch (metric_) {
    case Metric::circle:
      return inscribed_circle_area(h1_, h2_, p);
    case Metric::distance:
      return distance_gain(p);
    case Metric::area:
      break;
  }
  return surroundings_->convex ? triangle_area(h1_, h2_, p) : area_gain(p);
}

double Wedge::area_gain(const Vec2& p) const { return area_left_of_both(outside_, h1_, p, h2_); }

Wedge::Split Wedge::split_at(const Vec2& p) const {
  const double angle = pseudo_angle_from(pseudo_angle1_, pseudo_angle(p));
  const auto at =
      std::upper_bound(outer_.begin(), outer_.end(), angle,
                       [](double value, const Outer& outer) { return value < outer.pseudo_angle; });
  auto begin = at, end = at;
  while (begin != outer_.begin() && directions_agree(p, (begin - 1)->position)) --begin;
  while (end != outer_.end() && directions_agree(p, end->position)) ++end;
  return {static_cast<std::size_t>(begin - outer_.begin()),
          static_cast<std::size_t>(end - outer_.begin())};
}

// Calls visit(vertex, distance outside the new edge, whether this edge is h1 p). A vertex in the
// direction of p keeps its longer arm, so that mirror images have the same sum.
template <class Visit>
void Wedge::for_each_arm(const Vec2& p, Visit visit) const {
  const Split split = split_at(p);
  const Outside before(h1_, p), behind(p, h2_);
  std::size_t k = 0;
  for (; k < split.begin; ++k) visit(outer_[k], before.distance(outer_[k].position), true);
  for (; k < split.end; ++k) {
    const double up_to_p = before.distance(outer_[k].position);
    const double from_p = behind.distance(outer_[k].position);
    visit(outer_[k], std::max(up_to_p, from_p), up_to_p >= from_p);
  }
  for (; k < outer_.size(); ++k) visit(outer_[k], behind.distance(outer_[k].position), false);
}

double Wedge::distance_gain(const Vec2& p) const {
  double gain = 0;
  for_each_arm(p, [&](const Outer& outer, double left, bool) {
    gain += outer.distance - std::max(0.0, left);
  });
  return gain;
}

std::vector<Wedge::Arm> Wedge::arms(const Vec2& p) const {
  std::vector<Arm> arms;
  for_each_arm(p, [&](const Outer& outer, double left, bool up_to_p) {
    arms.push_back({outer.position, outer.distance, std::max(0.0, left), up_to_p});
  });
  return arms;
}

double Wedge::distance_bound(const Vec2& p) const {
  // The sum of positive parts is at least the positive part of the sum. The sum of distances from a
  // line follows from the sum of positions.
  const auto sum_outside = [](const Vec2& a, const Vec2& b, const Vec2& sum, std::size_t number) {
    const Vec2 line = b - a;
    return -cross(line, sum - static_cast<double>(number) * a) / length(line);
  };
  const std::size_t split = split_at(p).end, n = outer_.size();
  const double left1 = sum_outside(h1_, p, sums_[split], split);
  const double left2 = sum_outside(p, h2_, sums_[n] - sums_[split], n - split);
  return distance_sum_ - std::max(0.0, left1) - std::max(0.0, left2) + distance_error_bound();
}

double Wedge::distance_error_bound() const {
  return per_distance * surroundings_->diameter * static_cast<double>(outer_.size() + 1);
}

Gain Wedge::sharpen(const Vec2& p, const Gain& known) {
  if (known.certainty == Certainty::bound && prepare_close_bounds()) {
    return {std::min(known.value, close_bound(p)), Certainty::close_bound};
  }
  return {evaluate(p), Certainty::exact};
}

// Makes the close bounds once they are likely to save time. Returns whether they exist.
bool Wedge::prepare_close_bounds() {
  if (area_bins_ || distance_blocks_) return true;
  constexpr std::size_t few_vertices = 48;
  constexpr int few_evaluations = 4;
  constexpr double narrow = 1e-3;  // rounding would spoil narrower wedges
  if (std::max(outside_.size(), outer_.size()) < few_vertices || ++evaluations_ <= few_evaluations)
    return false;
  switch (metric_) {
    case Metric::area:
      if (!is_convex() || pseudo_angle_from(pseudo_angle1_, pseudo_angle(h2_)) < narrow)
        return false;
      area_bins_.emplace(outside_, h1_, h2_, surroundings_->diameter);
      return true;
    case Metric::distance: {
      Points positions;
      positions.reserve(outer_.size());
      for (const Outer& outer : outer_) positions.push_back(outer.position);
      distance_blocks_.emplace(std::move(positions));
      return true;
    }
    case Metric::circle:  // estimated exactly
      break;
  }
  return false;
}

double Wedge::close_bound(const Vec2& p) const {
  if (area_bins_) return area_bins_->bound(p) * rounded_up;
  const std::size_t split = split_at(p).end;
  return distance_sum_ - distance_blocks_->least_sum_beyond(h1_, p, 0, split) -
         distance_blocks_->least_sum_beyond(p, h2_, split, outer_.size()) + distance_error_bound();
}

}  // namespace evenlift
