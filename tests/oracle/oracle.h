// The exact oracle computes evenlift's results by brute force, straight from the definitions.
//
// It shares nothing with the core: own points, own arithmetic (rationals, and binary floats of 100
// digits for roots). Given doubles are taken as exact. It is slow on purpose: for "every pair" it
// tries every pair.
//
// Two ways in:
//   find_candidates(problem) -> select -> judge: computes everything from the polygon, unrounded.
//   given_candidates(...) -> select -> judge: for another program's chords in doubles, so that
//   their rounding does not matter.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
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
  std::vector<Ring> holes{};  // in either orientation
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
  bad_hole,      // no valid polygon alone
  rings_meet,    // two rings share a point
  hole_outside,  // or in another hole
};

/// `none` if the input is valid.
Refusal refusal(const Problem& problem);

/// Exact, then rounded to the nearest doubles. The area must not be 0.
Point centroid(const std::vector<Point>& vertices);

/// Without the holes, rounded to the nearest doubles.
double area(const Problem& problem);
Point centroid(const Problem& problem);

/// Of the object within the convex polygon of these corners, counter-clockwise.
double covered_share(const Problem& problem, const std::vector<Point>& corners);

/// Whether two segments, or the edges of two rings, share a point.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d);
bool rings_meet(const Ring& a, const Ring& b);

/// For a point that is not on the ring.
bool contains(const Ring& ring, const Point& p);

/// Why the ring alone is no valid polygon.
Refusal refusal_of_ring(const Ring& ring);

/// Why a valid polygon cannot have these holes: the first of the last three refusals, or `none`.
/// Tries every pair of edges and rings.
Refusal refusal_of_holes(const Ring& outline, const std::vector<Ring>& holes);

/// Whether a hole fits among valid ones.
bool fits(const Ring& outline, const std::vector<Ring>& holes, const Ring& hole);

/// The centre of mass with cargo: exact, rounded to the nearest doubles.
struct Cargo {
  Point at;
  double weight;
};
Point centre_with_cargo(const Point& own, double weight, const std::vector<Cargo>& cargo);

/// The nearest decision of a tolerance: |value / threshold - 1|. At 0.001, a thousandth of the
/// threshold more or less would have changed it.
struct ClosestCall {
  double distance = std::numeric_limits<double>::infinity();
  std::string what;

  void merge(const ClosestCall& other) {
    if (other.distance < distance) *this = other;
  }
};

struct Candidate {
  std::array<Point, 2> ends;  // in no order
  double ratio = 0;           // (0, 1]
  Kind kind = Kind::vertex;
  // Over its merged duplicates: how far their ratios are below its own, and the greatest distance
  // of their ends. Both are below the tolerance; rounding chooses among equal ratios.
  double ratio_slack = 0, ends_slack = 0;
};

struct ExactShape;   // relative to C, in rationals
struct ExactChords;  // in rationals

struct CandidateList {
  std::vector<Candidate> candidates;  // in candidate order, rounded to doubles
  std::size_t pairs = 0;              // the edge pairs that they come from
  ClosestCall closest_call;
  // The smallest |g - 1| above 0 at a section end, and an edge pair's thinnest open range of
  // directions (as a sine): exact here, hard in doubles.
  double nearest_unit_g = std::numeric_limits<double>::infinity();
  double thinnest_range = std::numeric_limits<double>::infinity();

  std::shared_ptr<const ExactShape> shape;
  std::shared_ptr<const ExactChords> chords;
};

/// Of every edge pair, merged and in candidate order. The problem must be valid.
CandidateList find_candidates(const Problem& problem);

/// In the given order, with ends taken as exact.
CandidateList given_candidates(const Problem& problem, const std::vector<Candidate>& given);

/// Unordered, each once.
std::vector<std::array<Point, 2>> vertex_chords(const Problem& problem);

struct Selection {
  std::vector<std::size_t> teams;  // indices of candidates, in the order selected
  std::vector<double> scores;      // at selection; 0 for the first
  ClosestCall closest_call;
};

/// With all ties, by the problem's metric.
Selection select(const Problem& problem, const CandidateList& list);

/// Every candidate's, against these teams' lifting base, by the problem's metric.
struct Scores {
  std::vector<double> values;
  ClosestCall closest_call;
};
Scores scores(const Problem& problem, const CandidateList& list,
              const std::vector<std::size_t>& teams);

struct DistributedTeams {
  std::vector<std::array<Point, 2>> chords;
  // Each team's least sine against the direction of a vertex (where the farthest point may jump),
  // and against an edge that it meets (where the point is sensitive to the angle).
  std::vector<double> nearest_vertex, flattest_hit;
  double measure = 0;  // of the directions V, in radians
};

/// Ignores `metric` and `min_ratio`.
DistributedTeams distributed(const Problem& problem);

struct Loads {
  std::vector<std::array<double, 2>> of_teams;  // at each team's two ends
  double min = 0, mean = 0, max = 0, spread = 0, max_share = 0;
};

struct Closure {
  std::size_t contacts = 0;
  bool clockwise = true, counterclockwise = true, translation = true;  // free to first order
  bool form_closure = false;
  bool second_order = false;
  std::optional<double> margin;  // absent without contacts
  // How precisely robots must be placed, in units of length; 0 without form closure, and infinite
  // if the hold needs no contact beside a corner.
  double clearance = 0;
  // In form closure: whether the hold surely persists if robots are off by this error.
  std::function<bool(double)> hold_within;
  bool clearance_is_unsure = false;  // rounding may decide it
  ClosestCall closest_call;
  // The least sine, above the tolerance, between opposite normals. If it is small, the centre of a
  // region without area is where nearly equal lines cross, and no earlier step may round.
  double flattest_crossing = 1;
};

struct Judgement {
  std::vector<Point> hull;  // corners, counter-clockwise
  double coverage = 0;      // [0, 1]
  std::optional<Loads> loads;
  Closure closure;
};

/// Of robots at these points.
Closure immobilization(const Problem& problem, const std::vector<Point>& lifting_points);

/// Of the teams that `teams` lists.
Judgement judge(const Problem& problem, const CandidateList& list,
                const std::vector<std::size_t>& teams);

}  // namespace oracle
