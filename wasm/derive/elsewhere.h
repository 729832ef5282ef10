// During a drag, a worker chooses the teams of an object that would take too long to place within a
// frame. Documents and choices pass between the page and the worker as numbers, bit for bit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift::view {

// Whether a worker should choose the teams of the document during a drag: `before`, the placement
// on the screen, has many vertices and candidates, the method chooses among candidates, and robots
// are points where the method places them. O(holes).
bool is_for_a_worker(const Document& document, const Placement& before);

// The rings of the document: their number, the number of vertices of each, and then all
// coordinates. The outline comes first.
std::vector<double> rings_as_numbers(const Document& document);

// The document's settings (settings_text.h), without supports, which its method does not use. Teams
// stay as the metric selects them.
std::string settings_as_selected(const Document& document);

// The document with these rings and settings; nothing if either is malformed.
// O(numbers + bytes).
std::optional<Document> read_task(std::span<const double> rings, std::string_view settings);

// The placement's candidates and teams.
std::vector<double> choice_as_numbers(const Placement& placement);

// Nothing if choice_as_numbers() does not write such numbers for a polygon with this many edges.
// O(numbers).
std::optional<Choice> read_choice(std::span<const double> numbers, std::size_t edges);

}  // namespace evenlift::view
