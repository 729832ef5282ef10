// Describes loads by each model, failures, C uncertainty and accuracy in words. Robots are counted
// from 1. All O(m).
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evenlift/output/words.h"

namespace evenlift {

// Describes the loads by the model that is shown: "If all robots are equally stiff and level and the
// object does not bend, they carry 15.9–17.5 kg each. Robots 2 and 5 go slack." The text is empty for
// LoadModel::plan, which loads_in_words() describes.
std::string model_in_words(const Reported& of);

// Says how the loads of equally stiff robots change under the given conditions: "If C is off by up to
// 3 cm and the ground slopes by up to 8 %, …". If a robot may go slack, the text gives the greatest
// load instead. If only C is uncertain, and the C uncertainty reaches the tipping distance, it gives
// that distance. With capacities, it adds how far C may be off before some robot's load by springs
// exceeds its capacity. Without conditions, or if the object tips under others than the C
// uncertainty, the text is empty.
std::string uncertainty_in_words(const Reported& of);

// Names the robots without which the object falls, or tips under the given conditions, the greatest
// load if another robot fails, and the failures after which the object can tip or a robot is
// overloaded. The text is empty if the report has no failures.
std::string failures_in_words(const Reported& of);

// Describes one failure: "Robot 3 fails: the other five carry the object, at most 21.3 kg each."
// The loads are by springs; if one exceeds the common capacity, the text also gives the capacity.
// `robot` counts from 0, and `of` is the placement with all its robots.
std::string failure_in_words(const ShownPlacement& of, std::size_t robot,
                             const std::optional<RestOfRobots>& rest);

// Returns the text that follows failure_in_words(): coverage and form closure, or the reason why
// the others cannot carry the object. `failing` comes from with_failure().
std::string rest_in_words(const Reported& failing);

// Says how far robots may be off while all that was told of the placement stays true: "All of this
// holds if robots stand within 8.1 mm of their places, and robots 1 and 5 in their inward corners."
// The text is empty if there is no such limit, if it is 0 within tolerance, or if it is that of a
// hold that is not firm, which closure_in_words() describes.
// With the setting `accuracy`, it says whether all of it holds with robots that are off by that, and
// the greatest load then, or inaccuracy_in_words().
std::string accuracy_in_words(const Reported& of);

// Says what ends within the setting `accuracy`, and from where on: "With robots off by 7 mm or more,
// the robots may no longer hold it." Empty if nothing does.
std::string inaccuracy_in_words(const Reported& of);

// Says that C is too near to the edge of the lifting base (Report::upright): "C is only 3 mm inside
// the line from robot 1 to robot 2." The text is empty if it is not, if all robots stand on one line,
// or if the object falls.
std::string upright_in_words(const Reported& of);

}  // namespace evenlift
