// Describes loads by each model, failures and C uncertainty in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"

namespace evenlift {

// Describes the loads by a model: "If all robots are equally stiff and level and the object does
// not bend, they carry 15.9–17.5 kg each. Robots 2 and 5 go slack." The text is empty for
// LoadModel::plan, which loads_in_words() describes. Robots are counted from 1.
std::string model_in_words(LoadModel model, const ModelLoads& loads, const Units& units = {});

// Says how the loads of equally stiff robots change within the disturbance of `loads`, which must
// be that of `shown`: "If C is off by up to 3 cm and the ground slopes by up to 8 %, …". If a
// robot may go slack, the text gives the greatest load instead. If only C is uncertain, and the C
// uncertainty reaches the tipping distance, it gives that distance. Without a disturbance, or if
// the object tips under other conditions, the text is empty. O(m).
std::string uncertainty_in_words(const ModelLoads& loads, const Robustness& robustness,
                                 const Shown& shown);

// Says how far C may be off before some robot's load by springs exceeds its capacity, under the
// other given conditions. Some robot must have a capacity. The cost is that of model_loads().
std::string uncertainty_for_capacity_in_words(const ModelLoads& loads, const ShownPlacement& of);

// Names the robots without which the object falls, or tips under the given conditions, the greatest
// load if another robot fails, and the failures after which the object can tip or a robot is
// overloaded. `overloads` comes from overloads_after() (capacity.h). `limit` is the capacity in
// words: "20 kg" or "its capacity". `conditions` are those of conditions_in_words().
std::string failures_in_words(const std::vector<std::optional<RestOfRobots>>& failures,
                              const Units& units = {}, const std::vector<bool>& overloads = {},
                              const std::string& limit = {}, const std::string& conditions = {});

// Describes one failure: "Robot 3 fails: the other five carry the object, at most 21.3 kg each."
// The loads are by springs; if one exceeds the capacity, the text also gives the capacity. `robot`
// counts from 0. `conditions` are those of conditions_in_words().
std::string failure_in_words(std::size_t robot, std::size_t robots,
                             const std::optional<RestOfRobots>& rest,
                             const std::optional<double>& capacity = std::nullopt,
                             const Units& units = {}, const std::string& conditions = {});

// Returns the text that follows failure_in_words(): coverage and form closure, or the reason why
// the others cannot carry the object. `failing` comes from with_failure().
std::string rest_in_words(const ShownPlacement& failing);

// Says how far robots may be off while all that was told of the placement stays true: "All of this
// holds if robots stand within 8.1 mm of their places, and robots 1 and 5 in their inward corners."
// The text is empty if there is no such limit, if it is 0 within tolerance, or if it is that of a
// hold that is not firm, which closure_in_words() describes.
// With the setting `accuracy`, it says whether all of it holds with robots that are off by that, and
// the greatest load then, or inaccuracy_in_words().
std::string accuracy_in_words(const ShownPlacement& of);

// Says what ends within the setting `accuracy`, and from where on: "With robots off by 7 mm or more,
// the robots may no longer hold it." Empty if nothing does.
std::string inaccuracy_in_words(const ShownPlacement& of);

// The same as a fact, with what may end first; nothing if there is no limit.
std::optional<Fact> accuracy_fact(const ShownPlacement& of);

// Says that C is too near to the edge of the lifting base (is_upright() of accuracy.h): "C is only
// 3 mm inside the line from robot 1 to robot 2." The text is empty if it is not, if all robots
// stand on one line, or if the object falls.
std::string upright_in_words(const ShownPlacement& of);

// Returns the number of robots that may fail, the tipping distance and, if the height of C is above
// 0, the slope at which the object tips. If one robot has failed (`failing`), `robustness` must be
// that of the others, and the first fact only says that one robot fails.
std::vector<Fact> robustness_facts(const ShownPlacement& of, const Robustness& robustness,
                                   bool failing = false);

}  // namespace evenlift
