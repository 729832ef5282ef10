// The search for balanced robots. The picture shows its start at once, and later results as long as
// the document stays the same.
#pragma once

#include "state/state.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
