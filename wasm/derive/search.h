// The search for balanced robots. The picture shows its start at once, and later results as long as
// they belong to the document on the screen.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Ends the search, because other robots are on the screen now; a new search is due.
void drop_search(Derived& facts, Effects& effects);

// Ends the search for good, because its last robots are on the screen.
void end_search(Derived& facts, Effects& effects);

// Begins the search that is due, if any. O(n) if one is.
void begin_search(Derived& facts, Effects& effects);

// Once the robots on the screen have settled, begins to count the balanced robots needed so that
// each can carry the `capacity` if any one may fail, unless the count is known. O(1) if there is
// nothing to begin.
void begin_count(Derived& facts, const std::optional<double>& capacity, Effects& effects);

// Forgets the number of robots needed, and ends the count.
void drop_count(Derived& facts, Effects& effects);

// Takes over the robots or the count that the search with this number found (robots_text.h).
// Changes nothing if that search is not the present one, or if the text is invalid.
enum class Taken : std::uint8_t { nothing, count, same_robots, other_robots };
Taken take(Derived& facts, const Given::Found& found);

}  // namespace evenlift::view
