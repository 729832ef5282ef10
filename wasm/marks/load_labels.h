// Numbers in the picture: what the robots bear, and how much of the object the lifting base covers.
#pragma once

#include <vector>

#include "marks/robot_discs.h"
#include "picture/canvas_view.h"
#include "picture/labels.h"

namespace evenlift::view {

void draw_coverage(const Painter& painter, const CanvasView& view);

// What labels keep clear of: robots, the centre of mass, vertices that can be dragged, the coverage, and lines.
Occupied occupied_by_marks(const CanvasView& view, double reach);

// Writes beside the robots what they bear; nothing at one that fails, nor where nobody bears anything.
void draw_loads(const Painter& painter, const CanvasView& view, const RobotSize& size,
                const Outlook& outlook, Occupied& occupied);

// The same of what they bear as planned, with nothing in doubt: the loads of a lesson.
void draw_planned_loads(const Painter& painter, const CanvasView& view, const RobotSize& size,
                        Occupied& occupied);

// The load ratio of the chord that is pointed at, on it, where there is room.
void draw_ratio(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
