// Handles, and what is under the pointer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evenlift/document.h"
#include "state/session.h"
#include "state/state.h"
#include "state/view_state.h"

namespace evenlift::view {

// --- The handles of a document are the points that the user selects, drags, nudges and removes. They
// are numbered in one sequence: the vertices of the outline, then those of each hole, then the
// weights. An edge has the number of the vertex at which it begins.

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

// --- Finds the part under the pointer. The pointer need only be near a part, and a finger may be
// farther away.

// Returns the part at `screen`, in pixels. The nearest vertex, weight, centre of mass, uncertainty
// grip or robot has priority. Among these, a movable robot comes first if it was placed by hand or
// its card is open. Next come edges, chords and shown candidates, and the object comes last. In the
// second method's picture, robots, chords and candidates are that method's.
// O(vertices + teams + candidates).
Pick pick(const AppState& state, const Vec2& screen, bool second = false);

// Returns the object, whatever other part is at `screen`; the kind is `none` outside the object, in
// a hole, and while the document is refused. O(vertices).
Pick object_at(const AppState& state, const Vec2& screen, bool second = false);

// Returns whether the part is a robot that the user can move. This is any robot of the first
// picture, unless the document is refused, a walkthrough is open or a robot fails.
bool can_take_robot(const AppState& state, const Pick& pick);

// Returns the part that a press grabs, perhaps to drag it. A vertex, a weight, the centre of mass
// or the uncertainty grip within reach precedes a robot that cannot be moved. O(vertices + teams +
// candidates).
Pick pick_to_hold(const AppState& state, const Vec2& screen, bool second = false);

// Returns the robot, team's chord or shown candidate at `screen`, whatever other part is there. The
// kind is `none` if there is no such part. O(teams + candidates).
Pick pick_explained(const AppState& state, const Vec2& screen, bool second = false);

// Returns the place, in pixels, of the grip that sets the C uncertainty. Returns nothing while no
// robots are placed, or while the ring of the uncertainty is hidden or cannot be edited. The grip
// is at a distance from the ring, so that the user can grab it even if the ring is small.
// uncertainty_for_grip() returns the uncertainty that a grip at `screen` sets, in the unit of the
// polygon's coordinates.
std::optional<Vec2> uncertainty_grip(const AppState& state);
double uncertainty_for_grip(const AppState& state, const Vec2& screen);

// Returns whether the pointer holds this part or, if it holds no part, whether the pointer is over
// this one. False while a shape or a hole is being drawn.
bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index);

// Returns the robot, chord or candidate under the pointer. If there is none, returns the part with
// an open card or, if no card is open, any other part under the pointer.
Pick marked_part(const AppState& state);

// Returns the chord of a robot's team, of a team or of a candidate; nothing for other parts and for
// parts that the placement does not have. Precondition for robots: they are in teams of two.
std::optional<Chord> chord_of_part(const Placement& placement, const Pick& part);

// own_centre() returns the centre of mass of the object without cargo: that of the document, or
// else of the last placement, or else the first vertex. centre_of_mass() returns the centre of mass
// with the cargo. O(items).
Vec2 own_centre(const AppState& state);
Vec2 centre_of_mass(const AppState& state);

// Returns the centroid of the object without its holes; nothing while the document is refused.
// O(1).
std::optional<Vec2> own_centroid(const AppState& state);

// Returns the support at `screen` that is left out of the first picture; the kind is `none` if there
// is none. O(m).
Pick left_out_at(const AppState& state, const Vec2& screen);

// Returns the weight at `screen`; the kind is `none` if no weight is there. O(items).
Pick weight_at(const AppState& state, const Vec2& screen);

// Returns the shown placement of the first or the second method; null if it does not exist or the
// document is refused.
const Placement* current_placement(const AppState& state, bool second);

// --- Chooses the pointer's shape, which shows what a press on the drawing would do.

Cursor cursor(const AppState& state);

}  // namespace evenlift::view
