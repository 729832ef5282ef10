// Numbers in the picture: the robots' loads, and the coverage.
#pragma once

#include <string>
#include <vector>

#include "marks/object.h"
#include "marks/robot_discs.h"
#include "picture/canvas_view.h"
#include "picture/labels.h"

namespace evenlift::view {

void draw_coverage(const Painter& painter, const CanvasView& view);

// The places that labels avoid: robots, the centre of mass, cargo with its labels, vertices that
// can be dragged, the coverage, and lines. Labels keep `reach` pixels away from robots.
Occupied occupied_by_marks(const CanvasView& view, double reach);

// The labels of cargo. They avoid the other places in the list above; all other labels avoid them.
std::vector<CargoLabel> labels_of_cargo(const CanvasView& view);

// The text beside a robot.
struct LoadLabel {
  Rect box;  // in pixels
  std::string text;
  bool over;  // the load exceeds the capacity
};

// The loads beside the robots, except a failed robot's and those without room; empty if no robot
// carries anything. Adds the boxes to `occupied`. O(robots).
std::vector<LoadLabel> load_labels(const CanvasView& view, const DiscSize& size,
                                   const Report& report, Occupied& occupied);

// The labels of the planned loads, without uncertainty, for the walkthrough.
std::vector<LoadLabel> planned_load_labels(const CanvasView& view, const DiscSize& size);

void draw_loads(const Painter& painter, const CanvasView& view,
                const std::vector<LoadLabel>& labels);

// Writes the load ratio of the hovered chord on the chord, if there is room.
void draw_ratio(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
