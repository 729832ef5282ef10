// A document together with its placement. Placing a document validates it, so both happen at once;
// the placement is then passed on to where it is shown, so that nothing is computed twice.
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
  std::optional<Trace> trace;  // if a check needed it
};

// Places the document, or returns why it is refused. Costs the same as place().
Result<Opened> opened(Document document);

// Like opened(), for another polygon. Everything that does not concern the polygon comes from
// `before`.
Result<Opened> opened_after(Document polygon, const Document& before);

// Reads and places a document: from a link, or from a link or a polygon's text. Returns the first
// error.
Result<Opened> read_link(std::string_view link);
Result<Opened> read_document(std::string_view text);

// Like read_document(), but does not place it.
Result<Document> parse_document(std::string_view text);

// How urgently a placement is needed. Teams with the goal *hold* are improved by swaps among all
// candidates, which can take seconds if there are very many. Where swaps would hold up the page,
// the teams stay as the metric selects them, and the placement's `search_ended` is false. The limit
// is about a twentieth of a second during a drag, and some seconds at rest.
enum class Haste : std::uint8_t { at_rest, drag };

// The view computes placements and traces only through these functions. They count, so that a
// test can check that an action computes one placement, and none if it changes only the picture. A
// known placement of the same vertices saves checking them. Balanced robots are the start of a
// search, which continues from there (search.h), unless the whole search is traced.
Result<Placement> compute_placement(const Document& document,
                                    const std::optional<Placement>& before = std::nullopt,
                                    Haste haste = Haste::at_rest);

// The same with a choice that was made elsewhere (place_as_chosen()), without swaps.
Result<Placement> compute_as_chosen(const Document& document, const Placement& before,
                                    Choice choice);

// The same in the haste of a drag, for a placement that is only offered; counted separately.
Result<Placement> try_placement(const Document& document, const Placement& before);

// Whether its teams are few enough to be swapped even during a drag. O(1).
bool swaps_in_a_drag(const Placement& placement);

// Whether its teams should be swapped until they hold, but are as the metric selects them. O(1).
bool waits_for_swap(const Placement& placement);
Result<Trace> compute_trace(const Placement& placement, const Units& units,
                            HistoryLength length = HistoryLength::whole);

// The number of teams that a capacity needs; also counted. Costs the same as plan_capacity().
CapacityPlan compute_plan(const Placement& placement, double capacity);

struct Computed {
  std::uint64_t placements = 0, tries = 0, traces = 0, plans = 0;
};
Computed computed();  // since the start

}  // namespace evenlift::view
