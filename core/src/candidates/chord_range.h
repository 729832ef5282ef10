// The chords between two lines on which robots with a size lift, and the parts of the lines in
// which two robots can stand at the ends of a chord.
#pragma once

#include <optional>
#include <vector>

#include "candidates/stand_lines.h"

namespace evenlift {

// The chords through C between two lines `a` and `b`, with the end r_a on `a` and r_b on `b`. The
// place t of r_a along `a` determines a chord; the ratio q = |C r_a| / |C r_b| is linear in t. The
// lines must outlive the ChordRange, and neither may pass through C.
class ChordRange {
 public:
  ChordRange(const StandLine& a, const StandLine& b) : a_(a), b_(b) {
    q0_ = -cross(a.start, b.along) / b.height;
    slope_ = -cross(a.along, b.along) / b.height;
  }

  double q(double t) const { return q0_ + t * slope_; }
  double slope() const { return slope_; }
  double q0() const { return q0_; }

  // The place of r_b along `b`, for the chord whose end r_a is at `t` along `a`. O(1).
  double on_b(double t) const { return dot(-a_.at(t) / q(t) - b_.start, b_.along); }

  // Returns the part of `of_a` whose chords end in `of_b`, whatever their load ratio; nothing if
  // there are no such chords. `of_a` is a piece of `a`, and `of_b` a piece of `b`. O(1).
  std::optional<Stretch> common(const Stretch& of_a, const Stretch& of_b) const;

  // The parts of `a` whose chords have at least the minimum load ratio, within tolerance, and two
  // ends where robots can stand. These parts are in the order of the usable intervals of `a`.
  // O(usable intervals of `a` times those of `b`).
  std::vector<Stretch> pieces(double min_ratio) const;

 private:
  std::optional<Stretch> with_ratio(Stretch stretch, double low, double high) const;
  std::optional<Stretch> that_reach(const Stretch& stretch, const Stretch& of_b) const;
  double on_a(double t_b) const;

  const StandLine &a_, &b_;
  double q0_ = 0, slope_ = 0;
};

}  // namespace evenlift
