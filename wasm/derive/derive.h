// Computes the document's placement by its method and, while two methods are compared, by the
// second.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Takes over the document's placement, or the reason why it was refused.
void adopt(Derived& facts, const Document& document, Result<Placement> placement);

// The placed document with this method and the same number of robots, which is rounded to an even
// number for teams.
Document by_other_method(const Derived& facts, Method method);

// Places the document by the second method, if any. Costs a placement.
void renew_second(Derived& facts, const Work& work, Haste haste);

// The best load ratio of any chord, rounded down to hundredths, if the method chooses among
// candidates but no team was placed; otherwise nullopt. Costs as much as find_candidates().
std::optional<double> best_ratio_if_none(const Placement& placement);

// --- Reports about the placements on the screen, completed as there is time.

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

// --- The offer on a button: other settings that improve a placement that is not good.

// Renews the offer. If no chord meets the minimum load ratio, the offer is a lower ratio.
// Otherwise, if the placement is not good, the offer is one of a few alternatives: ranges, the goal
// to hold, teams by area, or balanced robots. It is the first of those with the fewest faults, if
// these are fewer than the placement's. There is no alternative for more than 2,000 vertices or 16
// robots, because the search would take long. Costs at most four placements, each as in a drag
// (Haste::drag).
void renew_offer(Derived& facts, const Shown& shown);

// --- Derives AppState::derived(), which no other code writes.

// Brings the facts up to date. Call it once after each batch of commands. Derives only the facts
// whose basis (state/derived.h) changed, and the facts that follow from them. Slow work waits for
// the end of a drag. Takes the values that commands passed on (AppState::given), and appends
// requests to the browser, such as to search or to announce, to Session::effects. Changes nothing
// else. Costs at most one placement for the document, one for the second method and, if no drag is
// under way, the offer (offer.h) and the plan for a capacity. Costs O(overlays) if all is current.
void derive(AppState& state);

}  // namespace evenlift::view
