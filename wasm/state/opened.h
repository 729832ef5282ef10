// A document together with its placement. A document is validated by placing it, so both are done
// at once, and the placement is carried along to where it is shown: nothing is computed twice.
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
  std::optional<Trace> trace;  // if it was needed for a check
};

// Places the document, or says why it is refused. Costs as much as place().
Result<Opened> opened(Document document);

// The same for another polygon, with all of the document before that is not about its own polygon.
Result<Opened> opened_after(Document polygon, const Document& before);

// Reads and places the document of a link; and of a link or a polygon's text. Returns the first
// error, if there is one.
Result<Opened> read_link(std::string_view link);
Result<Opened> read_document(std::string_view text);

// Like read_document(), but does not place it.
Result<Document> parse_document(std::string_view text);

// How soon a placement is wanted. Teams that are to hold are exchanged among all candidates, which
// can take seconds among very many of them. Where that would hold up the page, the teams stay as
// the metric selects them, and `search_ended` of the placement is false: during a drag where it
// takes more than about a twentieth of a second, and at rest where it takes more than some seconds.
enum class Haste : std::uint8_t { at_rest, drag };

// The view computes placements and traces only through these two functions. They count, so that a
// test can check that an action computes one placement, and none if it changes only the picture.
// With a placement of the same vertices their check is spared. Balanced robots are those of the
// start: a search goes on from there (search.h), unless their whole search is traced.
Result<Placement> compute_placement(const Document& document,
                                    const std::optional<Placement>& before = std::nullopt,
                                    Haste haste = Haste::at_rest);

// Whether its teams are to hold, but were left as the metric selects them. O(1).
bool waits_for_exchange(const Placement& placement);
Result<Trace> compute_trace(const Placement& placement, const Units& units,
                            HistoryLength length = HistoryLength::whole);

// How many teams a capacity needs; counted, too. Costs as much as plan_capacity().
CapacityPlan compute_plan(const Placement& placement, double capacity);

struct Computed {
  std::uint64_t placements = 0, traces = 0, plans = 0;
};
Computed computed();  // since the start

}  // namespace evenlift::view
