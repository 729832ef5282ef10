// Derives what follows from the state: placements, reports, searches and offers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/settings.h"
#include "state/state.h"

namespace evenlift::view {

// --- Texts that pass robots between the page and the search for balanced robots, bit for bit. Each
// robot is the number of an edge and two coordinates, separated by spaces. The text of a plan for
// failures is the number of robots and the greatest load of a robot or, if no plan was found, only
// the greatest number of robots tried.

std::string robots_text(const std::vector<LiftingPoint>& robots);

// Reads robots. Returns nullopt unless the text has this form and exactly `number` robots, each on
// an edge of the polygon. O(bytes).
std::optional<std::vector<LiftingPoint>> read_robots(std::string_view text, std::size_t number,
                                                     const Polygon& polygon);

std::string plan_text(const FailurePlan& plan);

// Reads a plan. Returns nullopt if the text has another form. O(bytes).
std::optional<FailurePlan> read_plan(std::string_view text);

// --- The settings on which robots and their loads depend, as text for the page's workers.

// A setting's line `name=value`, as read_lines() reads it; empty if the setting has no text.
std::string setting_line(Setting setting, const Document& document);

// The lines of all these settings, including the centre of mass.
std::string settings_text(const Document& document);

// The lines of the settings that also fit other objects: the method (area for supports), the number of
// robots, their capacity and size, units and conditions, but no place on this object.
std::string settings_for_others(const Document& document);

// Reads lines `name=value` into the document. Returns false at the first invalid one. O(bytes).
bool read_lines(std::string_view lines, Document& document);

// --- The search for balanced robots. The picture shows its start at once, and later results as long as
// the document stays the same.

// Ends the search, because the robots on the screen changed; a new search is due.
void drop_search(Derived& facts, Effects& effects);

// Ends the search, without a new one: its last robots stay on the screen.
void end_search(Derived& facts, Effects& effects);

// Begins the search if one is due, in O(n).
void begin_search(Derived& facts, Effects& effects);

// Begins to count the balanced robots of this capacity that are needed if any one robot may fail
// (FailurePlan). Does nothing, in O(1), if there is no capacity, if the search for the robots on
// the screen has not ended, or if the count is known or under way.
void begin_count(Derived& facts, const Shown& shown, Effects& effects);

// Forgets the count, and ends the counting if it is under way.
void drop_count(Derived& facts, Effects& effects);

// Takes the robots or the count that a search found (robots_text.h). Ignores invalid texts, and the
// results of any search but the last one. Returns the kind of result that it took.
enum class Taken : std::uint8_t { nothing, count, same_robots, other_robots };
Taken take(Derived& facts, const Given::Found& found);

// --- During a drag, a worker chooses the teams of an object that takes longer than a frame to place.
// Documents and choices pass between page and worker as numbers, bit for bit.

// Whether a worker should choose the teams during a drag. All of these conditions must hold: there
// are many vertices and candidates; `before`, the placement on the screen, has the document's
// numbers of vertices and holes; the method chooses among candidates; and the robots are points
// that may stand anywhere and were not moved by hand. O(holes).
bool is_for_a_worker(const Document& document, const Placement& before);

// Returns the number of rings, the number of vertices of each ring, and all coordinates, in this
// order. The outline is the first ring.
std::vector<double> rings_as_numbers(const Document& document);

// The settings as text (settings_text.h). The text leaves out the supports, which a metric does not
// use. If the goal would swap teams, the text has the goal `cover` instead.
std::string settings_as_selected(const Document& document);

// Reads a document; nullopt if the rings or settings are malformed. O(numbers + bytes).
std::optional<Document> read_task(std::span<const double> rings, std::string_view settings);

// The placement's candidates and teams as numbers.
std::vector<double> choice_as_numbers(const Placement& placement);

// Reads candidates and teams. Returns nullopt if choice_as_numbers() cannot have written these
// numbers for a polygon with this number of edges. O(numbers).
std::optional<Choice> read_choice(std::span<const double> numbers, std::size_t edges);

// --- Computes the document's placement by its method and, while two methods are compared, by the
// second.

// Takes over the document's placement, or the reason why it was refused.
void adopt(Derived& facts, const Document& document, Result<Placement> placement);

// The placed document with this method and the same number of robots, which is rounded to an even
// number for teams.
Document by_other_method(const Derived& facts, Method method);

// The document as it would be after an edit: with the weight and C that readings told, if they no
// longer apply (settled_after_edit() of weighing.h). O(document).
Document settled(const Derived& facts, Document document);

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
// to hold, teams by area, or balanced robots; if it falls, tips or overloads a robot, also the goal
// to cover, or more robots. It is the first of those with the fewest faults, if these are fewer than
// the placement's. If it still tips on the given slope, the offer is a gentler slope. There is no
// alternative for more than 2,000 vertices or 16 robots, because the search would take long. Costs
// at most seven placements, each as in a drag (Haste::drag).
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
