// The points of a document that the user selects, drags, nudges and removes, in one numbering: the
// vertices of the outline, then those of each hole, and the weights. Edges have the numbers of the
// vertices at which they begin.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evenlift/document.h"
#include "state/view_state.h"

namespace evenlift::view {

struct Handle {
  bool is_weight = false;
  std::size_t ring = 0;   // 0 is the outline, and k hole k
  std::size_t index = 0;  // of the vertex in its ring, or of the weight
};

// O(holes).
std::size_t count_vertices(const Document& document);
std::size_t count_handles(const Document& document);

// O(holes).
std::size_t weight_handle(const Document& document, std::size_t item);

// Nothing if there are fewer. O(holes).
std::optional<Handle> handle_of(const Document& document, std::size_t number);

// O(1).
const Points& ring_of(const Document& document, std::size_t ring);
Points& ring_of(Document& document, std::size_t ring);

// O(holes).
std::size_t first_of_ring(const Document& document, std::size_t ring);

// The place of a handle, which must exist; and moves it there. O(holes).
Vec2 place_of(const Document& document, std::size_t number);
void put(Document& document, std::size_t number, const Vec2& at);

// In the vertex's ring. O(holes).
Vec2 before(const Document& document, std::size_t vertex);
Vec2 after(const Document& document, std::size_t vertex);

// "Vertex 3", "Hole 2, vertex 3", "Weight 1" or "Weight 1, motor". O(holes).
std::string name_of(const Document& document, std::size_t number);

// All that moves with the polygon. O(n).
PolygonGrip grip_of(const Document& document);

// visit(ring, number of its first vertex) is called for the outline and each hole.
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
