#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/load_models.h"
#include "evenlift/tolerance.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// Within tolerance of this line through the centroid.
bool on_one_line(const Vec2& direction, const Points& offsets) {
  return std::all_of(offsets.begin(), offsets.end(), [&](const Vec2& d) {
    return std::fabs(cross(direction, d)) <= tau * length(direction);
  });
}

Vec2 with_mean_square_1(const Vec2& axis, const Points& offsets) {
  double square = 0;
  for (const Vec2& d : offsets) square += dot(axis, d) * dot(axis, d);
  return axis / std::sqrt(square / static_cast<double>(offsets.size()));
}

}  // namespace

StandardFrame standard_frame(const Points& points) {
  StandardFrame frame;
  for (const Vec2& p : points) frame.mean += p;
  frame.mean /= static_cast<double>(points.size());
  Points offsets;
  Vec2 farthest;
  for (const Vec2& p : points) {
    offsets.push_back(p - frame.mean);
    if (length(offsets.back()) > length(farthest)) farthest = offsets.back();
  }
  if (length(farthest) <= tau) return frame;
  frame.axis[0] = with_mean_square_1(farthest, offsets);
  if (on_one_line(farthest, offsets)) return frame;
  const Vec2 across = with_mean_square_1(left_normal(farthest), offsets);
  double together = 0;  // the coordinates' mean product, removed from the second axis
  for (const Vec2& d : offsets) together += dot(frame.axis[0], d) * dot(across, d);
  together /= static_cast<double>(points.size());
  frame.axis[1] = with_mean_square_1(across - together * frame.axis[0], offsets);
  return frame;
}

// --- The loads of equally stiff robots that cannot pull.
//
// Of all loads f >= 0 that balance the weight, those with the least sum of squares are max(0, g)
// for a function g(q) = a + b . q of the robot's place. It minimizes 1/2 sum max(0, g)^2 - m g(C),
// in units of weight / m: a convex function of (a, b) whose gradient is the lack of balance.
// Newton's step leads to the g that balances the weight with the robots that carry load at present.
// Those that would have to pull go slack, others start to carry, and so on until the loads settle.

namespace {

// Of places relative to C.
struct Linear {
  double at_centre = 0;
  Vec2 slope;
  double operator()(const Vec2& q) const { return at_centre + dot(slope, q); }
};

// Has this value at the centroid and these slopes along the frame's axes.
Linear in_frame(const StandardFrame& frame, double at_mean, const Vec2& along_axes) {
  const Vec2 slope = along_axes.x * frame.axis[0] + along_axes.y * frame.axis[1];
  return {at_mean - dot(slope, frame.mean), slope};
}

class Springs {
 public:
  explicit Springs(const Points& robots)
      : robots_(robots), m_(static_cast<double>(robots.size())), frame_(standard_frame(robots)) {
    pressure_ = in_frame(frame_, 1, frame_(Vec2{}));  // if no robot goes slack
    settle();
  }

  // In units of weight / m, and 0 within tolerance. A robot with a negative value carries no load.
  double pressure(std::size_t i) const {
    const double value = pressure_(robots_[i]);
    return std::fabs(value) <= tau ? 0 : value;
  }

 private:
  // The error in balance of the loads max(0, g), for a weight of 1 in the robots' frame.
  double lack_of_balance() const {
    double sum = 0;
    Vec2 moment;
    for (const Vec2& q : robots_) {
      const double load = std::max(0.0, pressure_(q));
      sum += load;
      moment += load * frame_(q);
    }
    const Vec2 off = moment / m_ - frame_(Vec2{});
    return std::max(std::fabs(sum / m_ - 1), max_norm(off));
  }

  // The convex function's slope along the step, at `times` times the step.
  double slope_along(const Linear& step, double times) const {
    double sum = 0;
    for (const Vec2& q : robots_) {
      const double change = step(q);
      sum += std::max(0.0, pressure_(q) + times * change) * change;
    }
    return sum - m_ * step.at_centre;
  }

  // The step to the function that balances the weight with the loaded robots.
  Linear newton_step(const Points& bearing, const StandardFrame& frame) const {
    double sum = 0;
    Vec2 moment;
    for (const Vec2& q : bearing) {
      sum += pressure_(q);
      moment += pressure_(q) * frame(q);
    }
    const double k = static_cast<double>(bearing.size());
    return in_frame(frame, (m_ - sum) / k, (m_ * frame(Vec2{}) - moment) / k);
  }

  // Loaded robots on one line, or at one place, cannot balance the weight if C is elsewhere. The
  // function then turns about them, rising towards C, until others start to carry.
  static std::optional<Linear> turn(const StandardFrame& frame) {
    if (frame.axis[1] != Vec2{}) return std::nullopt;
    Vec2 beside = -frame.mean;  // from the line or place to C
    if (frame.axis[0] != Vec2{}) {
      const Vec2 along = frame.axis[0] / length(frame.axis[0]);
      beside -= dot(beside, along) * along;
    }
    const double distance = length(beside);
    if (distance <= tau) return std::nullopt;
    return Linear{distance, beside / distance};
  }

  Linear next_step(const Points& bearing) const {
    if (bearing.empty()) return {1, Vec2{}};
    const StandardFrame frame = standard_frame(bearing);
    return turn(frame).value_or(newton_step(bearing, frame));
  }

  // The multiple of the step that at least halves the size of the slope along it.
  double stride(const Linear& step, double slope) const {
    double low = 0, high = std::numeric_limits<double>::infinity(), times = 1;
    for (int i = 0; i < 100; ++i) {
      const double here = slope_along(step, times);
      if (here < slope / 2) {
        low = times;
      } else if (here > -slope / 2) {
        high = times;
      } else {
        break;
      }
      times = std::isfinite(high) ? low + (high - low) / 2 : 2 * times;
    }
    return times;
  }

  void settle() {
    constexpr int most_steps = 200;
    constexpr double settled = 0x1p-42;
    for (int i = 0; i < most_steps && lack_of_balance() > settled; ++i) {
      Points bearing;
      for (const Vec2& q : robots_)
        if (pressure_(q) > 0) bearing.push_back(q);
      const Linear step = next_step(bearing);
      const double slope = slope_along(step, 0);
      if (!(slope < 0)) break;
      const double times = stride(step, slope);
      pressure_.at_centre += times * step.at_centre;
      pressure_.slope += times * step.slope;
    }
  }

  const Points& robots_;
  double m_;
  StandardFrame frame_;
  Linear pressure_;
};

// The change of loads as C moves, for a weight of 1.
class LoadsAsCMoves {
 public:
  // `bearing` are the loaded robots.
  LoadsAsCMoves(const Points& bearing, bool on_a_line)
      : frame_(standard_frame(bearing)),
        parts_(static_cast<double>(bearing.size())),
        determined_(frame_.axis[on_a_line ? 0 : 1] != Vec2{}) {}

  // Whether the loaded robots resist every motion of C. If not, others start to carry.
  bool determined() const { return determined_; }

  // |S^-1 (p - mean)|, where S is the sum of (p - mean) (p - mean)' over the loaded robots.
  double per_length(const Vec2& p) const {
    const Vec2 q = frame_(p);
    return length(q.x * frame_.axis[0] + q.y * frame_.axis[1]) / parts_;
  }

 private:
  StandardFrame frame_;
  double parts_;
  bool determined_;
};

double finite(double value) { return std::min(value, std::numeric_limits<double>::max()); }

}  // namespace

std::optional<SpringLoads> spring_loads(const Points& robots, const Vec2& centre, double diameter,
                                        double weight) {
  const std::optional<Support> support = find_support(robots, centre, diameter);
  if (!support) return std::nullopt;
  const Springs springs(support->at);
  const std::size_t m = support->at.size();
  const double even = 1 / static_cast<double>(m);
  Points bearing;
  for (std::size_t i = 0; i < m; ++i)
    if (springs.pressure(i) > 0) bearing.push_back(support->at[i]);
  const LoadsAsCMoves changes(bearing, support->on_a_line);

  std::vector<double> loads, per_length;
  double same_within = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < m; ++i) {
    const double share = springs.pressure(i) * even, rate = changes.per_length(support->at[i]);
    loads.push_back(weight * std::max(0.0, share));
    per_length.push_back(share > 0 ? finite(rate / support->unit * weight) : 0);
    if (rate > 0) same_within = std::min(same_within, std::fabs(share) / rate);
  }
  return SpringLoads{spread_out(*support, loads, robots.size()),
                     spread_out(*support, per_length, robots.size()),
                     changes.determined() ? finite(same_within * support->unit) : 0};
}

std::string_view name(LoadModel model) {
  switch (model) {
    case LoadModel::plan:
      return "plan";
    case LoadModel::springs:
      return "springs";
    case LoadModel::best:
      return "best";
    case LoadModel::worst:
      return "worst";
  }
  return {};
}

std::optional<LoadModel> load_model_from_name(std::string_view text) {
  for (const LoadModel model : all_load_models)
    if (text == name(model)) return model;
  return std::nullopt;
}

}  // namespace evenlift
