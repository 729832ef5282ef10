// During a drag, a worker chooses the teams of an object that takes longer than a frame to place.
// Documents and choices pass between page and worker as numbers, bit for bit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
