// Teams at equal angles (algorithm.md, Selection: distributed; thesis 5.2), for several numbers of
// teams in one sweep.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "chords/radial_view.h"
#include "evenlift/chords.h"
#include "evenlift/tolerance.h"

namespace evenlift {

// Finds the chords of teams at equal angles. The polygon must outlive this object.
class EqualAngles {
 public:
  // O(n log n).
  EqualAngles(const Polygon& polygon, const Vec2& centre);

  // The total angle of the directions in [0, pi) whose lines through C meet the boundary on both
  // sides of C. Directions along radial edges do not count.
  double measure_rad() const { return measure_; }

  // Whether measure_rad() is above 0. A value up to tau counts as 0, since rounding may leave gaps
  // between radial edges.
  bool has_chords() const { return measure_ > tau; }

  // For each i, calls visit(i, chord) for the chords of numbers[i] teams, by ascending angle, until
  // visit returns false. O(n), and O(e) for each chord whose line meets e edges; if there are many
  // chords, mostly O(1) for each.
  using Visit = std::function<bool(std::size_t i, const Chord& chord)>;
  void for_each_chord(const std::vector<std::uint32_t>& numbers, const Visit& visit) const;

 private:
  template <class VisitOpening>
  void for_each_opening(VisitOpening visit) const;

  const Polygon& polygon_;
  Vec2 centre_;
  RadialView view_;
  RayCaster rays_;
  double measure_ = 0;
};

}  // namespace evenlift
