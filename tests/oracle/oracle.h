// The exact oracle: computes evenlift's results by brute force, straight from the definitions.
//
// It shares nothing with the core: own points, own arithmetic (rationals, and binary floats of 100
// digits for roots). Every coordinate is the given double, taken as exact. It is slow on purpose:
// where a rule says "every pair", it tries every pair.
//
// Two ways in:
//   find_candidates(problem) -> select -> judge: everything is computed from the polygon, and
//   nothing is rounded on the way.
//   given_candidates(...) -> select -> judge: for chords given in doubles, as another program found
//   them, so that their rounding does not matter.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace oracle {

using Point = std::array<double, 2>;
using Ring = std::vector<Point>;

enum class Metric { area, circle, distance };
enum class Kind { bisecting, midpoint, vertex };  // in the order of precedence

struct Problem {
  std::vector<Point> vertices;            // either orientation
  std::optional<Point> centre_of_mass{};  // absent: the area centroid
  double min_ratio = 0.8;                 // rho, in [0, 1]
  int teams = 3;                          // t, at least 1
  Metric metric = Metric::area;
  double weight = 100;        // W
  std::vector<Ring> holes{};  // in the polygon, each in either orientation
};

enum class Refusal {
  none,
  too_few_vertices,
  bad_coordinate,
  repeated_vertex,
  no_area,
  not_simple,
  too_small,
  centre_outside,
  bad_ratio,
  bad_teams,
  bad_hole,      // no valid polygon by itself
  rings_meet,    // a hole and another ring have a common point
  hole_outside,  // of the polygon, or in another hole
};

/// Why the input is refused; `none` if it is valid.
Refusal refusal(const Problem& problem);

/// The area centroid, computed exactly and rounded to the nearest doubles. The area must not be 0.
Point centroid(const std::vector<Point>& vertices);

/// The area and the centroid of the polygon without its holes, rounded to the nearest doubles.
double area(const Problem& problem);
Point centroid(const Problem& problem);

/// The share of the object within the convex polygon with these corners, counter-clockwise.
double covered_share(const Problem& problem, const std::vector<Point>& corners);

/// Whether two closed segments, or the edges of two rings, have a common point.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d);
bool rings_meet(const Ring& a, const Ring& b);

/// Whether a point that is not on the ring is inside it.
bool contains(const Ring& ring, const Point& p);

/// Why the ring by itself is no valid polygon.
Refusal refusal_of_ring(const Ring& ring);

/// Why the polygon, known to be valid, cannot have these holes: the first of the last three
/// refusals, or `none`. Every pair of edges and of rings is tried.
Refusal refusal_of_holes(const Ring& outline, const std::vector<Ring>& holes);

/// Whether a further hole fits among valid ones.
bool fits(const Ring& outline, const std::vector<Ring>& holes, const Ring& hole);

/// Cargo of a weight at a place, and the centre of mass of an object with it: exact, rounded to the
/// nearest doubles.
struct Cargo {
  Point at;
  double weight;
};
Point centre_with_cargo(const Point& own, double weight, const std::vector<Cargo>& cargo);

/// The nearest decision that a tolerance made: |value / threshold - 1|, so 0.001 means that a
/// change of the value by a thousandth of its threshold would have changed the decision.
struct ClosestCall {
  double distance = std::numeric_limits<double>::infinity();
  std::string what;

  void merge(const ClosestCall& other) {
    if (other.distance < distance) *this = other;
  }
};

struct Candidate {
  std::array<Point, 2> ends;  // the order of the ends has no meaning
  double ratio = 0;           // (0, 1]
  Kind kind = Kind::vertex;
  // Over the duplicates merged into it: the greatest difference of their ratios below its own, and
  // the greatest distance of their ends. Both are less than the tolerance, and rounding chooses
  // among equal ratios.
  double ratio_slack = 0, ends_slack = 0;
};

struct ExactShape;   // the polygon relative to C, in rationals
struct ExactChords;  // the chords of a CandidateList, in rationals

struct CandidateList {
  std::vector<Candidate> candidates;  // in candidate order; exact values rounded to doubles
  std::size_t pairs = 0;              // the number of edge pairs that they come from
  ClosestCall closest_call;
  // Smallest |g - 1|, other than 0, at a section end, and the thinnest open range of directions of
  // an edge pair (as a sine): decided exactly here, and hard to compute in doubles.
  double nearest_unit_g = std::numeric_limits<double>::infinity();
  double thinnest_range = std::numeric_limits<double>::infinity();

  std::shared_ptr<const ExactShape> shape;
  std::shared_ptr<const ExactChords> chords;
};

/// The candidates of every edge pair, merged and in candidate order. The problem must be valid.
CandidateList find_candidates(const Problem& problem);

/// The given chords, in the given order, their ends taken as exact.
CandidateList given_candidates(const Problem& problem, const std::vector<Candidate>& given);

/// All vertex-chords: unordered, each once.
std::vector<std::array<Point, 2>> vertex_chords(const Problem& problem);

struct Selection {
  std::vector<std::size_t> teams;  // indices into the candidates, in the order selected
  std::vector<double> scores;      // of each team at its selection; 0 for the first
  ClosestCall closest_call;
};

/// First team and further teams, with all ties, by the problem's metric.
Selection select(const Problem& problem, const CandidateList& list);

/// The score of every candidate against the lifting base of these teams, by the problem's metric.
struct Scores {
  std::vector<double> values;
  ClosestCall closest_call;
};
Scores scores(const Problem& problem, const CandidateList& list,
              const std::vector<std::size_t>& teams);

struct DistributedTeams {
  std::vector<std::array<Point, 2>> chords;
  // For each team: the least sine between its line and the direction of a vertex (where the
  // farthest point may jump), and between its line and an edge that it meets (where the point is
  // sensitive to the angle).
  std::vector<double> nearest_vertex, flattest_hit;
  double measure = 0;  // of the directions V, in radians
};

/// Teams at equal angles; `metric` and `min_ratio` have no effect.
DistributedTeams distributed(const Problem& problem);

struct Loads {
  std::vector<std::array<double, 2>> of_teams;  // the loads at the two ends of each team
  double min = 0, mean = 0, max = 0, spread = 0, max_share = 0;
};

struct Closure {
  std::size_t contacts = 0;
  bool clockwise = true, counterclockwise = true, translation = true;  // free to first order
  bool form_closure = false;
  bool second_order = false;
  std::optional<double> margin;  // absent without contacts
  // The precision that the robots' places need, in units of length; both are 0 without form
  // closure. The clearance is infinite if the hold needs no contact beside a corner.
  double clearance = 0, tolerance = 0;
  bool clearance_is_unsure = false;  // rounding may decide it
  ClosestCall closest_call;
  // The least sine, above the tolerance, between two opposite normals. If it is small, the centre
  // of a region without area is where two nearly equal lines cross, and no earlier step may round.
  double flattest_crossing = 1;
};

struct Judgement {
  std::vector<Point> hull;  // corners, counter-clockwise
  double coverage = 0;      // [0, 1]
  std::optional<Loads> loads;
  Closure closure;
};

/// Hull, coverage, loads and immobilization of the teams that `teams` lists.
Judgement judge(const Problem& problem, const CandidateList& list,
                const std::vector<std::size_t>& teams);

}  // namespace oracle
