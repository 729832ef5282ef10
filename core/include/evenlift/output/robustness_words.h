// Who bears what, failures and doubt about C, in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"

namespace evenlift {

// What the robots bear by a model: "If all robots are equally stiff and level and the object does
// not bend, they bear 15.9–17.5 kg each. Robots 2 and 5 let go." Empty for the plan, of which
// loads_in_words speaks. Robots count from 1.
std::string model_in_words(LoadModel model, const ModelLoads& loads, const Units& units = {});

// "It can tip: the centre of mass may be off by 200 mm, and 177 mm in one direction is enough."
// Empty if it cannot. O(1).
std::string tipping_in_words(const Robustness& robustness, double com_radius, const Units& units);

// How the loads change while C is anywhere within the radius, from where on the object tips, and
// whether some robot lets go before.
std::string doubt_in_words(const ModelLoads& loads, const Robustness& robustness, double com_radius,
                           const Units& units = {});

// How far C may be off so that no robot bears more than the capacity by springs.
std::string doubt_of_capacity_in_words(const ModelLoads& loads, const Robustness& robustness,
                                       double capacity, const Units& units = {});

// Which robots the object cannot do without, what the others bear at most, and with a capacity
// whose failure leaves some robot with more than that.
std::string failures_in_words(const std::vector<std::optional<RestOfRobots>>& failures,
                              const Units& units = {},
                              const std::optional<double>& capacity = std::nullopt);

// "Robot 3 fails: carried by the other five, at most 21.3 kg." What it bears is by springs. If that
// is more than the capacity, it says so.
std::string failure_in_words(std::size_t robot, std::size_t robots,
                             const std::optional<RestOfRobots>& rest,
                             const std::optional<double>& capacity = std::nullopt,
                             const Units& units = {});

// What holds while a robot fails, beside failure_in_words(): coverage and closure, or why the
// others cannot hold the object. `failing` comes from with_failure().
std::string rest_in_words(const ShownPlacement& failing);

// How many robots may fail, and how far C may be off. While one of them fails (`failing`) the
// robustness is that of the others, of whom it is not counted how many more may fail.
std::vector<Fact> robustness_facts(const ShownPlacement& of, const Robustness& robustness,
                                   bool failing = false);

}  // namespace evenlift
