// The search for balanced robots. The picture shows its start at once, and later results while the
// document stays.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Ends the search, because the robots on the screen changed; a new search is due.
void drop_search(Derived& facts, Effects& effects);

// Ends the search for good: its last robots are on the screen.
void end_search(Derived& facts, Effects& effects);

// Begins the search if one is due, in O(n).
void begin_search(Derived& facts, Effects& effects);

// Once the robots on the screen have settled, begins to count the balanced robots that can carry
// the `capacity` each if any one fails, unless the count is known. O(1) if there is nothing to
// begin.
void begin_count(Derived& facts, const std::optional<double>& capacity, Effects& effects);

// Also ends the count.
void drop_count(Derived& facts, Effects& effects);

// Takes what the search with this number found (robots_text.h). Ignores any search but the present
// one, and an invalid text.
enum class Taken : std::uint8_t { nothing, count, same_robots, other_robots };
Taken take(Derived& facts, const Given::Found& found);

}  // namespace evenlift::view
