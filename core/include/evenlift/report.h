// Every fact about a placement, computed once. Words, JSON, tables, panels, pictures and conditions
// read a report and compute nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "evenlift/accuracy.h"
#include "evenlift/capacity.h"
#include "evenlift/extra_load.h"
#include "evenlift/placed_robots.h"
#include "evenlift/tilt.h"

namespace evenlift {

// What a report tells beside what it always tells.
struct Asked {
  LoadModel model = LoadModel::plan;  // that of Report::loads
  bool models = false;    // the loads by every model, even if the plan is shown without conditions
  bool failures = false;  // the effect of each robot's failure
  bool plans = false;     // the robots needed for the common capacity, if there is one
};

// Robots are counted from 0, as in find_robot() (loads.h). Without robots, facts about them have
// their defaults. "Under the given conditions" means within `disturbance`.
struct Report {
  Asked known;  // what was asked for so far

  // The given conditions, what they amount to for these robots (uncertainty.h), and whether the
  // object can tip under them: whether they may move the weight out of the lifting base by more than tau L.
  Disturbance disturbance;
  DisturbanceEffect effect;
  bool tips = false;

  Equilibrium equilibrium;
  Robustness robustness;
  std::optional<TippingLine> tipping_line;  // empty if the object falls
  std::optional<Tilt> tilt;
  // Whether the object stands clearly (algorithm.md, Upright): C stays inside the lifting base by
  // the setting `clear` at least, and does not leave it under the given conditions, within tau L.
  bool upright = false;
  bool firm = false;  // hold_firmly() of placement.h
  bool held = false;  // is_held() of placement.h
  std::vector<Misfit> misfits;
  // The values that settings have here, whether or not they are set: lengths.
  struct Effective {
    double clear = 0, apart = 0, snap = 0;
  };
  Effective effective;

  // Loads by all models under the given conditions: if asked, if `model` is not the plan, or if there
  // are conditions. Empty if the object falls.
  std::optional<ModelLoads> models;
  // The same with robots that are off (with_inaccuracy()); only if `models` are asked for.
  std::optional<ModelLoads> inexact_models;
  std::vector<LoadRange>
      planned;  // as planned, under the given conditions, or without them if it tips
  // As shown (shown_loads()): by the model that was asked for, or as planned if the object falls.
  LoadModel model = LoadModel::plan;
  std::vector<LoadRange> loads;
  double greatest = 0;                       // the greatest of `loads`
  bool loads_are_determined = false;         // by equilibrium alone
  std::optional<std::vector<double>> worst;  // that statics allows, under the given conditions

  bool has_capacities = false, has_own_capacities = false;  // see capacity.h
  // What each robot can carry, and limits_of() these; empty if no robot has a capacity.
  std::vector<std::optional<double>> capacities, limits;
  // How much of each robot is used: its greatest planned load under the given conditions, times the
  // dynamic factor and 1 + the uncertainty of the weight, divided by its capacity. An entry is empty
  // without a capacity, or if the object falls or can tip; the list is if no robot has a capacity.
  std::vector<std::optional<double>> use;
  // The greatest use, and whose it is; nothing without any use. O(robots).
  std::optional<std::size_t> most_used() const;
  std::vector<std::size_t> overloaded, overloaded_as_planned;  // by `loads`, and by `planned`
  std::vector<std::size_t> overloaded_at_rest;                 // as planned, without any conditions
  std::vector<std::size_t> overloaded_at_worst;                // by `worst`
  // How far C may be off, at most, before any robot's load by springs may exceed its capacity, under
  // the other given conditions (radius_within_capacity() of uncertainty.h); empty if one may exceed
  // it even with C at its place. And how far the loads are known at all. Only with capacities and
  // `models`.
  struct ComRadius {
    std::optional<double> within, known;
  };
  std::optional<ComRadius> com_radius;

  Accuracy accuracy;
  std::optional<ExtraLoad> extra;
  std::optional<ReadingsFit> readings_fit;  // if the object was weighed

  // Of robots with the common capacity; if each has only its own, no number is possible.
  std::optional<CapacityPlan> plan;
  std::optional<FailurePlan> if_one_fails;

  std::vector<std::optional<RestOfRobots>> failures;  // one for each robot, or empty
  // overloaded_after(): one list for each failure; empty without capacities.
  std::vector<std::vector<std::size_t>> overloaded_after;

  // Whether the robot carries more than its capacity by the loads that are shown.
  bool is_overloaded(std::size_t robot) const {
    return std::binary_search(overloaded.begin(), overloaded.end(), robot);
  }

  // If the placement is that after a failure (with_failure()), the robot that failed.
  std::optional<std::size_t> failed;
};

// Makes a report. Costs O(n + m log m) for m robots, and the cost of accuracy (accuracy.h), of
// misfits for given supports, of model_loads() if it is made, of extra_load(), and of what is asked.
Report report_of(const ShownPlacement& of, const Asked& asked = {});

// Adds what is asked for and not yet known. The report must be of this placement. Loads are then
// told by asked.model. Costs only what is added.
void complete(Report& report, const ShownPlacement& of, const Asked& asked);

// The report of a placement after a failure (with_failure()): how the others stand and hold the
// object, their loads, accuracy and capacities. `rest` is the effect of the failure,
// and `loads` those of the others (ranges_without()), or empty if they are those of the placement.
Report report_of_failure(const ShownPlacement& failing, std::size_t robot,
                         const std::optional<RestOfRobots>& rest, std::vector<LoadRange> loads);

// A placement, how to show it, and its report, for functions that write words, pictures or files. It
// refers to the first two, and to a report that is given: pass it to functions, but do not store it.
// Without a report, it makes one.
class Reported : public ShownPlacement {
 public:
  Reported(const ShownPlacement& of) : Reported(of, Asked{}) {}
  Reported(const Placement& of) : Reported(ShownPlacement(of)) {}
  Reported(const Placement& of, const Shown& how) : Reported(ShownPlacement(of, how)) {}
  Reported(const ShownPlacement& of, const Asked& asked)
      : Reported(of, std::make_shared<const Report>(report_of(of, asked))) {}
  Reported(const ShownPlacement& of, const Report& known)
      : Reported(of, std::shared_ptr<const Report>(std::shared_ptr<void>(), &known)) {}

 private:
  Reported(const ShownPlacement& of, std::shared_ptr<const Report> known)
      : ShownPlacement(of), owned_(std::move(known)), report(*owned_) {}
  std::shared_ptr<const Report> owned_;

 public:
  const Report& report;
};

}  // namespace evenlift
