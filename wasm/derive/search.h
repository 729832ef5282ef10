// The search for balanced robots: the picture shows its start at once, and what it finds later as
// long as it is about the document on the screen.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Ends the search, since the robots on the screen are others now; a new one is due.
void drop_search(Derived& facts, Effects& effects);

// Ends it for good, since the robots on the screen are its last ones.
void end_search(Derived& facts, Effects& effects);

// Begins the search that is due. O(n) if one is.
void begin_search(Derived& facts, Effects& effects);

// Begins to count how many balanced robots it takes so that each can bear the `capacity` if any one
// may fail, if that is not known, once those on the screen have settled. O(1) if there is nothing
// to begin.
void begin_count(Derived& facts, const std::optional<double>& capacity, Effects& effects);

// Forgets how many it takes, and ends the count.
void drop_count(Derived& facts, Effects& effects);

// Takes over robots that the search of this number found, or how many were counted (robots_text.h).
// Changes nothing if that search is not the one under way or the text is wrong.
enum class Taken : std::uint8_t { nothing, count, same_robots, other_robots };
Taken take(Derived& facts, const Given::Found& found);

}  // namespace evenlift::view
