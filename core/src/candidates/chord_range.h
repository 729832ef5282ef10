// The chords between two lines on which robots with a size lift, and where two robots can stand.
#pragma once

#include <optional>
#include <vector>

#include "candidates/stand_lines.h"

namespace evenlift {

// The chords about C between two lines, by t along a. The ratio q = |C r_a| / |C r_b| is linear in
// t. The lines must outlive it, and neither may pass through C.
class ChordRange {
 public:
  ChordRange(const StandLine& a, const StandLine& b) : a_(a), b_(b) {
    q0_ = -cross(a.start, b.along) / b.height;
    slope_ = -cross(a.along, b.along) / b.height;
  }

  double q(double t) const { return q0_ + t * slope_; }
  double slope() const { return slope_; }
  double q0() const { return q0_; }

  // The position on b of the chord at t along a. O(1).
  double on_b(double t) const { return dot(-a_.at(t) / q(t) - b_.start, b_.along); }

  // The part of a piece of a whose chords end in a piece of b, at any load ratio. O(1).
  std::optional<Stretch> common(const Stretch& of_a, const Stretch& of_b) const;

  // The parts of a where robots can stand on both lines with at least the minimum ratio, within
  // tolerance, in order of the usable ranges of a. O(stretches of a times those of b).
  std::vector<Stretch> pieces(double min_ratio) const;

 private:
  std::optional<Stretch> with_ratio(Stretch stretch, double low, double high) const;
  std::optional<Stretch> that_reach(const Stretch& stretch, const Stretch& of_b) const;
  double on_a(double t_b) const;

  const StandLine &a_, &b_;
  double q0_ = 0, slope_ = 0;
};

}  // namespace evenlift
