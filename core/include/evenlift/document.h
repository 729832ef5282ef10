// The content of a file or a link. All its numbers are finite, but the polygon and the settings may
// still be invalid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// Limits on all input, inclusive. Input beyond them is refused.
inline constexpr double max_coordinate = 1e9;             // absolute value of a coordinate
inline constexpr double min_coordinate = 1e-100;          // absolute value of a coordinate unless 0
inline constexpr double min_diagonal = 1e-9;              // diagonal of a polygon's bounding box
inline constexpr double max_length = max_coordinate;      // a given size or distance
inline constexpr double min_length = 1e-100;              // a given length above 0
inline constexpr double max_slope = 1;                    // slope of the ground, 45 degrees
inline constexpr double max_acceleration = 10;            // acceleration along the ground, in g
inline constexpr double max_dynamic = 10;                 // factor on loads
inline constexpr double max_weight = 1e100;               // a weight or a capacity
inline constexpr double min_weight = 1e-100;              // a weight or a capacity
inline constexpr std::size_t max_vertices = 1u << 20;     // vertices of a polygon with its holes
inline constexpr std::size_t max_holes = 1000;            // holes in a polygon
inline constexpr std::size_t max_cargo = 1000;            // items of cargo
inline constexpr std::size_t max_name_characters = 60;    // characters of a cargo item's name
inline constexpr std::size_t max_link_vertices = 32768;   // vertices of a polygon in a link
inline constexpr std::size_t max_text_bytes = 64u << 20;  // bytes of a file
inline constexpr std::size_t max_link_bytes = 1u << 20;   // bytes of a link
inline constexpr std::uint32_t max_teams = 1u << 20;      // teams, if given as a number
inline constexpr std::uint32_t least_robots = 2;          // balanced robots
inline constexpr std::uint32_t most_robots = 64;          // balanced robots
inline constexpr std::uint32_t most_survived = 30;        // failures to survive (Settings::survive)
inline constexpr std::size_t most_no_go = 1000;           // no-go parts of edges
inline constexpr std::size_t most_supports = 1000;        // supports for Method::given
inline constexpr std::size_t most_moved_teams = 1000;     // teams moved by hand

// How places are chosen (algorithm.md, Selection; thesis 3.3, 5.2).
enum class Method : std::uint8_t { area, circle, distance, distributed, random, balanced, given };

// The methods that find places. The places of Method::given are settings.
inline constexpr Method all_methods[] = {Method::area,        Method::circle, Method::distance,
                                         Method::distributed, Method::random, Method::balanced};

// All methods, including Method::given.
inline constexpr Method named_methods[] = {Method::area,        Method::circle, Method::distance,
                                           Method::distributed, Method::random, Method::balanced,
                                           Method::given};

// Whether all robots form one team, instead of teams of two. O(1).
constexpr bool is_one_team(Method method) {
  return method == Method::balanced || method == Method::given;
}

// The methods of the thesis, with teams of two.
inline constexpr Method pair_methods[] = {Method::area, Method::circle, Method::distance,
                                          Method::distributed, Method::random};

// The methods that choose teams among the candidates.
inline constexpr Method candidate_methods[] = {Method::area, Method::circle, Method::distance};

// The measure of how much a candidate's two ends add to the lifting base.
enum class Metric : std::uint8_t { area, circle, distance };

// The metric of a method; nothing if it does not choose among candidates. O(1).
constexpr std::optional<Metric> metric_of(Method method) {
  switch (method) {
    case Method::area:
      return Metric::area;
    case Method::circle:
      return Metric::circle;
    case Method::distance:
      return Metric::distance;
    case Method::distributed:
    case Method::random:
    case Method::balanced:
    case Method::given:
      break;
  }
  return std::nullopt;
}
constexpr bool selects_candidates(Method method) { return metric_of(method).has_value(); }

// Whether scores are lengths; otherwise they are areas.
constexpr bool scores_are_lengths(Metric metric) { return metric == Metric::distance; }

// The first aim of a placement: the greatest coverage, or a hold with at least the minimum margin.
enum class Goal : std::uint8_t { cover, hold };
inline constexpr Goal all_goals[] = {Goal::cover, Goal::hold};
std::string_view name(Goal goal);
std::optional<Goal> goal_from_name(std::string_view text);

// Where a team may stand on two facing edges: at the best place only, or anywhere in their range
// (PairRange in candidates.h).
enum class Positions : std::uint8_t { best, range };
inline constexpr Positions all_positions[] = {Positions::best, Positions::range};
std::string_view name(Positions positions);
std::optional<Positions> positions_from_name(std::string_view text);

// name() returns a method's name in JSON and options, such as "area"; method_from_name() returns
// the method with a name, or nothing if the name is unknown. O(1).
std::string_view name(Method method);
std::optional<Method> method_from_name(std::string_view text);

// The units of all lengths and weights below. They are labels and change no number, except that
// robot poses for ROS 2 are in metres.
enum class LengthUnit : std::uint8_t { none, m, cm, mm, in };
enum class WeightUnit : std::uint8_t { kg, t, N, lb };
inline constexpr LengthUnit all_length_units[] = {LengthUnit::none, LengthUnit::m, LengthUnit::cm,
                                                  LengthUnit::mm, LengthUnit::in};
inline constexpr WeightUnit all_weight_units[] = {WeightUnit::kg, WeightUnit::t, WeightUnit::N,
                                                  WeightUnit::lb};
struct Units {
  LengthUnit length = LengthUnit::none;  // of coordinates and distances
  WeightUnit weight = WeightUnit::kg;    // of the object and of loads
  bool operator==(const Units&) const = default;
};
std::string_view name(LengthUnit unit);  // such as "mm", or "none"
std::string_view name(WeightUnit unit);  // such as "kg"

// A length in metres. It is rounded only once if the unit is a decimal fraction of a metre. Without
// a unit, the number stays the same. O(1).
double in_metres(double length, LengthUnit unit);
// A weight in kilograms, with standard gravity. O(1).
double in_kilograms(double weight, WeightUnit unit);

// What the picture shows in addition to the polygon and its robots.
struct Overlays {
  bool candidates = false;       // chords that are not selected
  bool chords = true;            // chords of the teams
  bool lifting_base = true;      // H and coverage
  bool clockwise = true;         // rotation centres free for clockwise turns
  bool counterclockwise = true;  // those free for counter-clockwise turns
  bool tipping = false;          // heat map of the tipping force
  bool halo = false;             // the tipping distance (uncertainty.h)
  bool tilt = false;             // slopes at which the object tips, by direction (tilt.h)
  bool load = false;             // where a further load may stand (extra_load.h)
  bool operator==(const Overlays&) const = default;
};

// The sizes of a robot, each 0 .. max_length (stands.h). If all but the gap are 0, it is a point.
struct RobotSize {
  double radius = 0;  // radius of the round body
  double reach = 0;   // length of the arm, from the body's rim to the contact
  double depth = 0;   // length of the hand, from the contact to the lifting point
  double width = 0;   // width of the hand
  double gap = 0;     // free distance between two bodies
  // Whether the robot is more than a point. Points, too, must stand at least the gap apart.
  bool has_body() const { return radius > 0 || reach > 0 || depth > 0 || width > 0; }
  bool operator==(const RobotSize&) const = default;
};

// A part of an edge, 0 <= from < to <= 1. `from` and `to` are fractions of the edge's length,
// measured from its first vertex.
struct EdgePart {
  std::uint32_t edge = 0;  // from 0
  double from = 0, to = 1;
  bool operator==(const EdgePart&) const = default;
};

// The default of Settings::clear, in units of R (polygon.h).
inline constexpr double usual_clear = 0.02;

// The default of Settings::apart, in units of R.
inline constexpr double usual_apart = 0.12;

// The default of Settings::snap, in units of L: more than the rounding of places in tables.
inline constexpr double usual_snap = 1e-4;

// A rigid load that is fixed to the object. It acts at its own centre of mass and may overhang.
struct Cargo {
  Vec2 at;
  double weight = 0;  // min_weight .. max_weight
  std::string name;   // at most max_name_characters of UTF-8, no control characters
  bool operator==(const Cargo&) const = default;
};

// How far the reading of a support may be off: a percentage of it, 0 .. 100, or a weight,
// 0 .. max_weight. Only one of them is above 0.
struct ReadingError {
  double percent = 0, weight = 0;
  bool operator==(const ReadingError&) const = default;
};

// What the supports read while they carry the object (weighing.h). With readings, the weight and the
// centre of mass of the object are what follows from these, and must not be given.
struct Weighed {
  std::vector<double> readings;  // of each support, 0 .. max_weight, without tare; empty if none
  ReadingError error;            // of each reading
  double level_error = 0;  // how far the plane of the lifting points may be from level, as a slope,
                           // 0 .. max_slope
  // A second weighing on a slope: its readings, the slope, 0 .. max_slope, and a vector uphill.
  std::vector<double> tilted_readings;
  double tilted = 0;
  std::optional<Vec2> heading;
  bool operator==(const Weighed&) const = default;
};

// Why a weight beside readings is refused.
extern const char weight_is_weighed[];

// The inputs of a placement except the polygon and the centre of mass.
struct Settings {
  // The number of teams, 1 .. max_teams. For methods that choose among candidates, empty ("max")
  // means every candidate.
  std::optional<std::uint32_t> teams = 3;
  Method method = Method::area;
  double min_ratio = 0.8;       // minimum load ratio, 0 .. 1
  double weight = 100;          // weight of the object alone, min_weight .. max_weight
  std::uint64_t seed = 1;       // seed of Method::random
  std::uint32_t robots = 6;     // number of balanced robots, least_robots .. most_robots
  std::optional<Goal> goal;     // empty means the default of goal_of()
  double min_margin = 0.05;     // minimum margin of a hold, 0 .. 1
  std::optional<double> apart;  // preferred distance between robots, >= 0; empty means 0.12 R
  // For a hold, searches rely on no contact nearer than this to a corner; after a failure, C should
  // be at least this far inside the lifting base. >= 0; empty means usual_clear times R.
  std::optional<double> clear;
  // Each robot may be off its place by up to this, along its edge or, beneath the object, in any
  // direction (accuracy.h). 0 .. max_length; empty means 0.
  std::optional<double> accuracy;
  std::uint32_t survive = 0;  // the number of balanced robots whose failure should leave the object
                              // steady; F failures need at least 2 F + 3 robots
  Positions positions = Positions::best;  // of teams of two; balanced robots may stand anywhere
  RobotSize robot;
  std::vector<EdgePart> no_go;  // no robot may touch these parts; at most most_no_go, in any order
  std::vector<Cargo> cargo;     // at most max_cargo items
  Points supports;              // for Method::given, 1 .. most_supports (supports.h)
  // For Method::given, what people call each support: at most max_name_characters of UTF-8, no control
  // characters; "" for one without a name. The list may be empty.
  std::vector<std::string> support_names;
  std::optional<double> snap;  // supports within this distance of the outline stand at the edge,
                               // 0 .. max_length; empty means 1e-4 L
  Weighed weighed;             // for Method::given
  bool operator==(const Settings&) const = default;
};

// Conditions that affect the loads and whether the object tips, but not where robots stand (tilt.h,
// extra_load.h).
struct Carrying {
  double com_height = 0;  // height of C, of the object with its cargo, above the lifting points,
                          // 0 .. max_length
  double slope = 0;  // greatest slope of the plane of the lifting points in any direction, as a
                     // ratio, 0 .. max_slope
  double acceleration = 0;     // greatest acceleration along the ground in any direction, in g,
                               // 0 .. max_acceleration
  std::optional<double> give;  // how far a robot gives way under the mean load,
                               // min_length .. max_length; empty means that it may be very little
  double uneven = 0;  // greatest error of the ground or of a robot's height, 0 .. max_length
  std::optional<double> extra;  // a further weight that may stand on the object, such as a person,
                                // min_weight .. max_weight
  double dynamic = 1;  // factor on the greatest loads before they meet a capacity, 1 .. max_dynamic
  double weight_doubt = 0;  // how far the weight may be off, as a part of it, 0 .. 1

  // What loads are multiplied by before they meet a capacity.
  double load_factor() const { return dynamic * (1 + weight_doubt); }
  // Whether the height of C is known.
  bool has_height() const { return com_height > 0; }
  bool operator==(const Carrying&) const = default;
};

// Display options, and questions about a placement. They never change the placement, which does not
// store them.
struct Shown {
  Overlays overlays;
  std::optional<std::uint32_t> step;  // step of the walkthrough, if it is open
  double com_radius = 0;  // C uncertainty: the radius within which C is known, 0 .. max_length
  std::optional<double> capacity;  // greatest load of a robot, min_weight .. max_weight; empty
                                   // means no limit
  // For Method::given, the capacity of each support, where an empty entry means the common
  // capacity. The list may be empty.
  std::vector<std::optional<double>> support_capacities;
  Carrying carrying;
  Units units;
  bool operator==(const Shown&) const = default;
};

// The name of a given support, "" if it has none; and what people call it: its number from 1 and, in
// brackets, its name if it has one, such as "4 (north)". O(bytes).
std::string_view name_of_support(const Settings& settings, std::size_t support);
std::string support_called(const Settings& settings, std::size_t support);

// The given goal, or else the default: `hold` for four or more balanced robots, otherwise `cover`.
// (For two or three balanced robots, a hold would cost too much of the lifting base.) With
// Method::given the goal is always `cover`. O(1).
Goal goal_of(const Settings& settings);

// Whether teams of two are swapped until they hold (swaps.h). O(1).
bool swaps_teams(const Settings& settings);

// A point on an edge. `part`, 0 .. 1, is a fraction of the edge's length, measured from its first
// vertex.
struct EdgePoint {
  std::uint32_t edge = 0;  // from 0
  double part = 0;
  bool operator==(const EdgePoint&) const = default;
};

// A team of two moved by hand along its range. Its chord runs from `end` through C to another edge.
struct MovedTeam {
  std::uint32_t team = 0;  // from 0
  EdgePoint end;
  std::uint32_t opposite = 0;  // the other edge, from 0
  bool operator==(const MovedTeam&) const = default;
};

// Robots moved by hand (moved.h). If a balanced robot was moved, `robots` has the contact points of
// all balanced robots. `teams` has only the teams of two that were moved, in ascending order. At
// most one of the lists has entries.
struct Moved {
  std::vector<EdgePoint> robots;  // at most most_robots
  std::vector<MovedTeam> teams;   // at most most_moved_teams
  bool any() const { return !robots.empty() || !teams.empty(); }
  bool operator==(const Moved&) const = default;
};

// A polygon with all that belongs to it.
struct Document {
  Points vertices;  // of the outline in the given order, in either orientation
  // Of the object without cargo; empty means the centroid of the area that the holes leave.
  std::optional<Vec2> centre_of_mass;
  Settings settings = {};
  Shown shown = {};
  Moved moved = {};
  std::vector<Points> holes = {};  // the vertices of each, in either orientation
};

// The weight of the object with its cargo. O(items).
double total_weight(const Settings& settings);

}  // namespace evenlift
