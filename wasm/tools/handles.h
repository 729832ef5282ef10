// The handles of a document are the points that the user selects, drags, nudges and removes. They
// are numbered in one sequence: the vertices of the outline, then those of each hole, then the
// weights. An edge has the number of the vertex at which it begins.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evenlift/document.h"
#include "state/view_state.h"

namespace evenlift::view {

struct Handle {
  bool is_weight = false;
  std::size_t ring = 0;   // 0 is the outline; k is hole k, counted from 1
  std::size_t index = 0;  // of the vertex in its ring, or of the weight
};

// Return the number of all vertices, and of all handles. O(holes).
std::size_t count_vertices(const Document& document);
std::size_t count_handles(const Document& document);

// Returns the number of a weight's handle. O(holes).
std::size_t weight_handle(const Document& document, std::size_t item);

// Returns the handle with this number; nothing if there are fewer handles. O(holes).
std::optional<Handle> handle_of(const Document& document, std::size_t number);

// Return the vertices of a ring. O(1).
const Points& ring_of(const Document& document, std::size_t ring);
Points& ring_of(Document& document, std::size_t ring);

// Returns the number of the ring's first vertex. O(holes).
std::size_t first_of_ring(const Document& document, std::size_t ring);

// place_of() returns the place of a handle, and put() moves the handle to a place. Precondition:
// the handle exists. O(holes).
Vec2 place_of(const Document& document, std::size_t number);
void put(Document& document, std::size_t number, const Vec2& at);

// Return the vertices before and after this one in its ring. O(holes).
Vec2 before(const Document& document, std::size_t vertex);
Vec2 after(const Document& document, std::size_t vertex);

// Returns the handle's name: "Vertex 3", "Hole 2, vertex 3", "Weight 1" or "Weight 1, motor"; empty
// if there is no such handle. O(holes).
std::string name_of(const Document& document, std::size_t number);

// Returns all points that move with the polygon. O(n).
PolygonGrip grip_of(const Document& document);

// Calls visit(ring, number of its first vertex) for the outline and each hole.
template <class Visit>
void for_each_ring(const Document& document, Visit visit) {
  visit(document.vertices, std::size_t{0});
  std::size_t first = document.vertices.size();
  for (const Points& hole : document.holes) {
    visit(hole, first);
    first += hole.size();
  }
}

}  // namespace evenlift::view
