#include "selection/gain_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"

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

}  // namespace evenlift
