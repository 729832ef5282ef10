// Numbers in the picture: what the robots bear, and how much of the object the lifting base covers.
#pragma once

#include <string>
#include <vector>

#include "marks/robot_discs.h"
#include "picture/canvas_view.h"
#include "picture/labels.h"

namespace evenlift::view {

void draw_coverage(const Painter& painter, const CanvasView& view);

// What labels keep clear of: robots, the centre of mass, vertices that can be dragged, the
// coverage, and lines.
Occupied occupied_by_marks(const CanvasView& view, double reach);

// What is written beside a robot.
struct LoadLabel {
  Rect box;  // in pixels
  std::string text;
  bool over;  // more than it can carry
};

// What the robots bear, beside them; nothing at one that fails, nor where nobody bears anything.
// The boxes are entered as taken. O(robots).
std::vector<LoadLabel> load_labels(const CanvasView& view, const RobotSize& size,
                                   const Outlook& outlook, Occupied& occupied);

// The same of what they bear as planned, with nothing in doubt: the loads of a lesson.
std::vector<LoadLabel> planned_load_labels(const CanvasView& view, const RobotSize& size);

void draw_loads(const Painter& painter, const CanvasView& view,
                const std::vector<LoadLabel>& labels);

// The load ratio of the chord that is pointed at, on it, where there is room.
void draw_ratio(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
