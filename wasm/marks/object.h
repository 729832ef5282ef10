// Draws the weights and, once there are any, the object's own centre of mass.
#pragma once

#include <string>
#include <vector>

#include "picture/canvas_view.h"
#include "picture/labels.h"
#include "picture/painter.h"

namespace evenlift::view {

// The disc of a weight, in pixels. Its area shows the weight's share of the total weight, as far as
// the least and greatest size allow.
struct CargoDisc {
  Vec2 middle;
  double radius;
};
std::vector<CargoDisc> cargo_discs(const CanvasView& view);

// The label of a weight: its name or, without a name, how heavy it is.
struct CargoLabel {
  Rect box;  // in pixels
  std::string text;
};

// The labels that have room beside their discs, clear of everything in `occupied`; none for very
// many weights. Adds the labels to `occupied`. O(items).
std::vector<CargoLabel> cargo_labels(const CanvasView& view, Occupied& occupied);

// Adds to `occupied` the discs, the object's own centre of mass, and the line from it to C.
void occupy_by_cargo(const CanvasView& view, Occupied& occupied);

void draw_cargo(const Painter& painter, const CanvasView& view);

// Draws the object's own centre of mass, and the line from it to C, along which cargo moves C.
void draw_own_centre(const Painter& painter, const CanvasView& view);

// Shows in green the region where a further load may stand, and draws stripes over the rest of the
// object. Draws nothing if the overlay is hidden, or if the user does not ask about a load.
void draw_load_region(const Painter& painter, const CanvasView& view);

// Draws circles about C, each for one slope. On that slope, under the assumptions of tilt.h, the
// object tips downhill if the circle reaches beyond the lifting base in that direction.
void draw_tilt(const Painter& painter, const CanvasView& view);

// Writes the load's effect at the pointer, or the slope at which the object tips towards the
// pointer. Returns whether it wrote anything.
bool draw_carrying_here(const Painter& painter, const CanvasView& view);

// --- Draws the centre of mass, and its possible error.

void draw_centre(const Painter& painter, const CanvasView& view);

// Draws the tipping distance as a dashed circle, and a ring within which the weight may act
// (DisturbanceEffect::reach), because of the C uncertainty, slopes or acceleration. In the first picture,
// the ring has the grip for the C uncertainty.
void draw_halo(const Painter& painter, const CanvasView& view);

// --- Arrows for free motions that the picture's regions do not show.

// Draws an arrow from the centre of mass in a direction in which the object can slide, with a label
// if there is room.
void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied);

// For each shown region of free rotation that lies outside the window, draws an arrow at the
// window's edge, towards the region, with a label if there is room. O(corners of the regions).
void draw_far_regions(const Painter& painter, const CanvasView& view, Occupied* occupied);

}  // namespace evenlift::view
