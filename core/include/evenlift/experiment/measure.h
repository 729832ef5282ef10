// Measures one polygon as in chapter 5 of the thesis: every method with every number of teams.
// Balanced robots, with every number of robots, go beyond the thesis.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/result.h"
#include "evenlift/stands.h"

namespace evenlift::experiment {

// The weight in the thesis (5.2, 5.3).
inline constexpr double experiment_weight = 100;  // of an object, in kg

// Limits of settings.
inline constexpr std::uint32_t max_samples = 100000;
inline constexpr std::uint32_t max_experiment_teams = 10000;

struct ExperimentSettings {
  double min_ratio = 0.8;       // minimum load ratio, 0 .. 1
  std::uint32_t samples = 200;  // random placements of each polygon, 1 .. max_samples
  // The greatest number of teams, 1 .. max_experiment_teams. The time grows with its square.
  std::uint32_t most_teams = 1000;
  // The greatest number of balanced robots, least_robots .. most_robots. Searching for them takes
  // most of the time; more robots take longer.
  std::uint32_t most_balanced = 12;
  // Of the object with its cargo, above 0; nothing for each document's own.
  std::optional<double> weight = experiment_weight;
  WeightUnit weight_unit = WeightUnit::kg;  // in the figures of a single polygon
  RobotSize robot;        // with a size, only the methods that let robots have one are measured
  bool failures = false;  // also measure what any one failure does
  bool operator==(const ExperimentSettings&) const = default;
};

// Returns an error, whose place names the option, if a setting is out of range. O(1).
std::optional<InputError> check_settings(const ExperimentSettings& settings);

// A polygon ready to be measured.
struct Subject {
  PolygonWithHoles object;
  Vec2 centre;
  std::vector<Candidate> candidates;          // their number is the greatest number of teams
  double weight = experiment_weight;          // the document's own, with cargo
  std::shared_ptr<const Stands> stands = {};  // null if robots are points
};

// Validates a document and finds its candidates, for robots of this size. Of the document's settings,
// only weight and cargo matter, since C depends on them. The errors are those of place() about the polygon, C and the
// candidates. O(n log n + K log K) for K edge pairs.
Result<Subject> prepare(const Document& document, const ExperimentSettings& settings);

// The values of one method with one number of robots. For random placements they are averages.
struct Measurement {
  Method method = Method::area;
  std::uint32_t robots = 0;   // 2, 4, 6, .. in teams of two; 2, 3, 4, .. balanced robots
  std::uint32_t samples = 1;  // number of averaged placements; 1 except for `random`
  double coverage = 0;        // 0 .. 1
  double form_closure = 0;    // share of placements in form closure, 0 .. 1
  double no_area = 0;         // share that passes the thesis's own test of form closure: no region
                              // of free rotation centres has an area
  double held_clear = 0;      // `form_closure` without contacts nearer than `usual_clear` times R
                              // to a corner
  double load_min = 0, load_mean = 0, load_max = 0;  // over the robots, in the unit of the weight
  double spread = 0;                                 // load_max - load_min (figure 5.3)
  double max_share = 0.5;  // greatest share of a team's load on one robot (figure 5.5); 0.5 for
                           // balanced robots, as if any two were a team
  std::optional<std::uint32_t> chosen;  // the candidate of the last team, from 0; empty for methods
                                        // that do not choose among candidates
  // If failures are measured: the share of placements that are steady, with C clearly inside, after
  // any one failure (Robustness::failures_clear), and the greatest load by springs after any one; empty
  // if the object then falls. For random placements, the mean over those that do not fall.
  std::optional<double> steady, after_failure;
  bool operator==(const Measurement&) const = default;
};

// The values that are averaged, in the order of the columns of CSV.
struct MeasuredValue {
  std::string_view column;
  double Measurement::*value;
};
inline constexpr MeasuredValue measured_values[] = {
    {"coverage", &Measurement::coverage},  {"form_closure", &Measurement::form_closure},
    {"no_area", &Measurement::no_area},    {"held_clear", &Measurement::held_clear},
    {"load_min", &Measurement::load_min},  {"load_mean", &Measurement::load_mean},
    {"load_max", &Measurement::load_max},  {"spread", &Measurement::spread},
    {"max_share", &Measurement::max_share}};

// The number of teams: 1 for balanced robots, otherwise one for every two robots. O(1).
std::uint32_t teams_of(Method method, std::uint32_t robots);

// Measures one method with 1, 2, ... teams, up to the smaller of `most_teams` and the number of
// candidates (also for equal angles and `random`). A number of teams that the method cannot place
// is omitted; with these two methods, this may happen if C is on the boundary. Sample k = 1, 2, ...
// of `random` is random_teams() with seed k; its first t teams are the placement of t teams. Up to
// t teams (of a sample) cost O(t^2) loads, at most t coverages and t tests of each kind of closure.
//
// Balanced robots are measured with 2, 3, ... up to `most_balanced` robots, even without
// candidates. A number is omitted if place() finds no placement with the other settings at their
// defaults. Each number costs one search (balanced.h).
//
// Robots with a size may collide, so fewer teams may have room; `distributed` and `random` are then
// not measured. Failures cost O(m^2) for each placement of m robots.
//
// The values are those of place(), except for the max_share of balanced robots.
std::vector<Measurement> measure(const Subject& subject, Method method,
                                 const ExperimentSettings& settings);

}  // namespace evenlift::experiment
