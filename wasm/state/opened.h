// Opens documents. Opening a document also computes its placement, because that validates the
// document. Callers pass the placement on (Given), so that nothing is computed twice.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "evenlift/capacity.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"

namespace evenlift::view {

struct Opened {
  Document document;
  Placement placement;
  std::optional<Trace> trace;  // the placement's trace, if a check needed it
};

// Opens the document, or returns why it is refused. Costs as much as place().
Result<Opened> opened(Document document);

// Opens another polygon. The settings and `shown` come from `before`, except those that belong
// to the polygon of `before`: the step, the shown lengths and the no-go edges.
Result<Opened> opened_after(Document polygon, const Document& before);

// read_link() reads and opens a document from a link, and read_document() from a link or a
// polygon's text. Both return the first error.
Result<Opened> read_link(std::string_view link);
Result<Opened> read_document(std::string_view text);

// Reads a document from a link or a polygon's text, without computing its placement.
Result<Document> parse_document(std::string_view text);

// How urgently a placement is needed. With the goal *hold*, swaps among all candidates improve the
// teams, but can take seconds. If the swaps would take too long, the teams stay as the metric
// selects them, and the placement's `search_ended` is false. The limit is about a twentieth of a
// second during a drag, and a few seconds at rest.
enum class Haste : std::uint8_t { at_rest, drag };

// The view computes placements and traces only here. These functions count their calls, so that a
// test can check that an action computes one placement, or none if it changes only the picture. A
// placement `before` of the same object saves checking the object. Of a search for balanced robots,
// this computes only the start (derive/search.h); compute_trace() may complete it.
Result<Placement> compute_placement(const Document& document,
                                    const std::optional<Placement>& before = std::nullopt,
                                    Haste haste = Haste::at_rest);

// Computes the placement with a worker's choice of teams (place_as_chosen()), without swaps.
Result<Placement> compute_as_chosen(const Document& document, const Placement& before,
                                    Choice choice);

// Computes a placement for an offer (derive/derive.h) with Haste::drag, and counts it in `tries`.
Result<Placement> try_placement(const Document& document, const Placement& before);

// Returns whether the teams have the goal *hold*, and teams and candidates are few enough for swaps
// in a drag. O(1).
bool swaps_in_a_drag(const Placement& placement);

// Returns whether the teams should be swapped until they hold, but are still as the metric selects
// them. O(1).
bool waits_for_swap(const Placement& placement);

// Computes the placement's trace. Costs as much as make_trace().
Result<Trace> compute_trace(const Placement& placement, const Units& units,
                            HistoryLength length = HistoryLength::whole);

// Computes and counts a plan. Costs as much as plan_capacity().
CapacityPlan compute_plan(const Placement& placement, double capacity);

struct Computed {
  std::uint64_t placements = 0, tries = 0, traces = 0, plans = 0;
};
Computed computed();  // the numbers since the start

}  // namespace evenlift::view
