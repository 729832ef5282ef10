// Loads by each model, failures and C uncertainty, in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"

namespace evenlift {

// "If all robots are equally stiff and level and the object does not bend, they carry 15.9–17.5 kg
// each. Robots 2 and 5 go slack." Empty for the plan; use loads_in_words() for it. Robots count
// from 1.
std::string model_in_words(LoadModel model, const ModelLoads& loads, const Units& units = {});

// How the loads of equally stiff robots change within the disturbance of `loads`, which must be
// that of `shown`: "If C is off by up to 3 cm and the ground slopes by up to 8 %, …"; the distance
// at which the object can tip, if only C is uncertain and by that much; and whether robots may go
// slack. Empty without a disturbance. O(m).
std::string uncertainty_in_words(const ModelLoads& loads, const Robustness& robustness,
                                 const Shown& shown);

// How far C may be off before a robot exceeds its capacity by springs, under the other given
// conditions. Some robot must have a capacity. Costs as much as model_loads().
std::string uncertainty_for_capacity_in_words(const ModelLoads& loads, const ShownPlacement& of);

// The indispensable robots, the greatest load if any other fails, and the failures that tip the
// object or overload a robot (overloads_after() of capacity.h), with the `limit` in words: "20 kg"
// or "its capacity".
std::string failures_in_words(const std::vector<std::optional<RestOfRobots>>& failures,
                              const Units& units = {}, const std::vector<bool>& overloads = {},
                              const std::string& limit = {});

// "Robot 3 fails: the other five carry the object, at most 21.3 kg each." Loads are by springs; a
// capacity that they exceed is added.
std::string failure_in_words(std::size_t robot, std::size_t robots,
                             const std::optional<RestOfRobots>& rest,
                             const std::optional<double>& capacity = std::nullopt,
                             const Units& units = {});

// In addition to failure_in_words(): coverage and closure, or why the others cannot carry the
// object. `failing` comes from with_failure().
std::string rest_in_words(const ShownPlacement& failing);

// The number of robots that may fail, and the tipping distance; while one fails (`failing`), those
// of the others, without further failures.
std::vector<Fact> robustness_facts(const ShownPlacement& of, const Robustness& robustness,
                                   bool failing = false);

}  // namespace evenlift
