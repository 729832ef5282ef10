// Draws the weights and, once there are any, the object's own centre of mass.
#pragma once

#include <string>
#include <vector>

#include "picture/canvas_view.h"
#include "picture/labels.h"

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

}  // namespace evenlift::view
