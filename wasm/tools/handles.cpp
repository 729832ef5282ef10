#include "tools/handles.h"

#include "evenlift/wording.h"

namespace evenlift::view {

std::size_t count_vertices(const Document& document) {
  return first_of_ring(document, document.holes.size() + 1);
}

std::size_t count_handles(const Document& document) {
  return count_vertices(document) + document.settings.cargo.size();
}

std::size_t weight_handle(const Document& document, std::size_t item) {
  return count_vertices(document) + item;
}

std::optional<Handle> handle_of(const Document& document, std::size_t number) {
  std::size_t rest = number;
  for (std::size_t ring = 0; ring <= document.holes.size(); ++ring) {
    const std::size_t size = ring_of(document, ring).size();
    if (rest < size) return Handle{false, ring, rest};
    rest -= size;
  }
  if (rest < document.settings.cargo.size()) return Handle{true, 0, rest};
  return std::nullopt;
}

const Points& ring_of(const Document& document, std::size_t ring) {
  return ring == 0 ? document.vertices : document.holes[ring - 1];
}

Points& ring_of(Document& document, std::size_t ring) {
  return ring == 0 ? document.vertices : document.holes[ring - 1];
}

std::size_t first_of_ring(const Document& document, std::size_t ring) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < ring; ++i) first += ring_of(document, i).size();
  return first;
}

Vec2 place_of(const Document& document, std::size_t number) {
  const Handle handle = *handle_of(document, number);
  return handle.is_weight ? document.settings.cargo[handle.index].at
                          : ring_of(document, handle.ring)[handle.index];
}

void put(Document& document, std::size_t number, const Vec2& at) {
  const Handle handle = *handle_of(document, number);
  Vec2& place = handle.is_weight ? document.settings.cargo[handle.index].at
                                 : ring_of(document, handle.ring)[handle.index];
  place = at;
}

Vec2 before(const Document& document, std::size_t vertex) {
  const Handle handle = *handle_of(document, vertex);
  const Points& ring = ring_of(document, handle.ring);
  return ring[handle.index == 0 ? ring.size() - 1 : handle.index - 1];
}

Vec2 after(const Document& document, std::size_t vertex) {
  const Handle handle = *handle_of(document, vertex);
  const Points& ring = ring_of(document, handle.ring);
  return ring[handle.index + 1 == ring.size() ? 0 : handle.index + 1];
}

std::string name_of(const Document& document, std::size_t number) {
  const std::optional<Handle> handle = handle_of(document, number);
  if (!handle) return {};
  if (!handle->is_weight && handle->ring == 0) return say("Vertex {vertex}", {handle->index + 1});
  if (!handle->is_weight)
    return say("Hole {hole}, vertex {vertex}", {handle->ring, handle->index + 1});
  const std::string& name = document.settings.cargo[handle->index].name;
  return say("Weight {weight}", {handle->index + 1}) + (name.empty() ? "" : ", " + name);
}

PolygonGrip grip_of(const Document& document) {
  return {document.vertices, document.centre_of_mass, document.holes, document.settings.cargo};
}

}  // namespace evenlift::view
