// Reports about the placements on the screen, completed as there is time.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Renews the reports about both placements and about the failed robot, all by the shown load model.
// Keeps the effects of failures unless they are due. Costs as much as report_of() (report.h).
void renew_reports(Derived& facts, LoadModel model, const Shown& shown);

// Completes the report with the effect of each robot's failure, if due, but not for more than
// `most_failures_known` robots. If that would take long, puts it off while `move` is true, that is,
// while robots are moved by hand or by a search.
inline constexpr std::size_t most_failures_known = 128;
void renew_failures(Derived& facts, const Shown& shown, bool move);

// Adds the numbers of robots needed to the reports, unless they are still those of the former object.
void tell_plans(Derived& facts);

// Marks the robot with this number, from 0, as failed; if there is no such robot, marks none. The
// other robots stay where they are. If the effects of failures are not known, this costs as much as
// computing one of them.
void let_fail(Derived& facts, std::size_t robot, const Shown& shown);

}  // namespace evenlift::view
