// The oracle's numbers, vectors, and tolerance. Only the oracle's own files include it, since its
// numbers take seconds to compile; other tests have rational.h.
#pragma once

#include "oracle/oracle.h"
#include "oracle/vec.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>

namespace oracle {

namespace mp = boost::multiprecision;

/// Used where a sign decides without a tolerance.
using Exact = mp::number<mp::cpp_rational_backend, mp::et_off>;
/// 100 digits, for roots, and for quantities compared with a tolerance or reported.
using Real = mp::number<mp::cpp_bin_float<100>, mp::et_off>;

using ExactVec = Vec<Exact>;
using RealVec = Vec<Real>;

inline Real length(const RealVec& v) { return sqrt(dot(v, v)); }
inline RealVec real(const ExactVec& v) { return {Real(v.x), Real(v.y)}; }
inline ExactVec exact(const Point& p) { return {Exact(p[0]), Exact(p[1])}; }

/// The tolerance, exactly 1e-9.
inline const Real tau = Real(1) / 1000000000;

/// Records the decisions of a tolerance.
class Calls {
 public:
  /// value <= threshold; both of one unit, the threshold positive.
  bool within(const Real& value, const Real& threshold, const char* what) {
    note(static_cast<double>(value / threshold), what);
    return value <= threshold;
  }
  /// Records a comparison of value / threshold with 1.
  void note(double quotient, const char* what) {
    const double distance = std::fabs(quotient - 1);
    if (distance < closest_.distance) closest_ = {distance, what};
  }
  /// Nearness is not transitive where a rule needs it, or the rounding of doubles may decide
  /// otherwise.
  void either_is_right(const char* what) { closest_ = {0, what}; }
  const ClosestCall& closest() const { return closest_; }

 private:
  ClosestCall closest_;
};

/// In the frame with origin C, so that no large coordinates are subtracted later.
struct ExactShape {
  std::vector<ExactVec> vertices;           // counter-clockwise, relative to C
  std::vector<RealVec> real_vertices;       // the same
  ExactVec centre;                          // C itself
  Real size;                                // L, the diameter
  Real area;                                // of P without its holes, positive
  std::vector<std::vector<RealVec>> holes;  // counter-clockwise, relative to C
};

struct ExactChord {
  std::array<ExactVec, 2> ends;  // relative to C
  std::array<RealVec, 2> real_ends;
  Real ratio;
  Real length;
  RealVec direction;  // from end to end, pointing right, or up if exactly vertical
  Kind kind = Kind::vertex;
  Real ratio_slack, ends_slack;
  bool between_vertices = false;  // between opposite vertices
};

struct ExactChords {
  std::vector<ExactChord> chords;
};

std::vector<ExactVec> exact_points(const std::vector<Point>& points);
Exact doubled_area(const std::vector<ExactVec>& ring);

/// Whether two closed segments share a point.
bool meet(const ExactVec& a, const ExactVec& b, const ExactVec& c, const ExactVec& d);

std::shared_ptr<const ExactShape> exact_shape(const Problem& problem);
ExactChord exact_chord(const ExactVec& end0, const ExactVec& end1, Kind kind, const Real& ratio);

/// Nearest double, ties to even.
double nearest_double(const Exact& value);

/// Corners only, counter-clockwise; two points if all are collinear, one if all agree.
std::vector<ExactVec> convex_hull(std::vector<ExactVec> points);

/// Of points that do not all coincide: corners that stick out by more than the tolerance, or a
/// segment's ends if all points are within the tolerance of one line.
std::vector<RealVec> lifting_base(const std::vector<ExactVec>& points, const Real& size,
                                  Calls& calls);

/// Signed distance from the line p -> q, positive to the right: outside counter-clockwise H.
Real outside(const RealVec& v, const RealVec& p, const RealVec& q);

/// Of a simple and a convex polygon, both counter-clockwise.
Real common_area(const std::vector<RealVec>& polygon, const std::vector<RealVec>& convex);
Real signed_area(const std::vector<RealVec>& polygon);

/// Of the object without holes within a convex polygon, counter-clockwise.
Real area_within(const ExactShape& shape, const std::vector<RealVec>& convex);

/// From p to the segment a b.
Real distance_to_segment(const RealVec& p, const RealVec& a, const RealVec& b);

Closure immobilization(const ExactShape& shape, const std::vector<RealVec>& lifting_points);

}  // namespace oracle
