// The search for balanced robots: the picture shows its start at once, and what it finds later as long
// as it is about the document on the screen.
#pragma once

#include <string_view>

#include "state/state.h"

namespace evenlift::view {

// Ends the search, since the robots on the screen are others now; a new one is due.
void drop_search(AppState& state);

// Begins the search that is due, unless a drag is under way, which it would slow down.
void begin_search(AppState& state);

// Begins to count how many balanced robots it takes if any one may fail, if that is wanted and not known,
// once those on the screen have settled. O(1) if there is nothing to begin.
void begin_count(AppState& state);

// Forgets how many it takes, and ends the count.
void drop_count(AppState& state);

// Takes over robots that the search of this number found, or how many were counted (robots_text.h). Returns
// false, and changes nothing, if that search is not the one under way or the text is wrong.
bool take_robots(AppState& state, std::uint64_t number, std::string_view robots, bool ended);

// The search of this number cannot go on: the robots stay as they are, and a notice says so.
void stop_search(AppState& state, std::uint64_t number);

}  // namespace evenlift::view
