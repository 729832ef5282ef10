// Everything of a fixed size on a picture.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/report.h"
#include "picture/canvas_view.h"
#include "picture/painter.h"
#include "tools/picture_marks.h"

namespace evenlift::view {

// --- Draws the weights and, once there are any, the object's own centre of mass.

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

// From the centre of mass, in pixels; only if a translation is free.
Segment slide_arrow(const CanvasView& view);

// Draws an arrow from the centre of mass in a direction in which the object can slide, with a label
// if there is room.
void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied);

// For each shown region of free rotation that lies outside the window, draws an arrow at the
// window's edge, towards the region, with a label if there is room. O(corners of the regions).
void draw_far_regions(const Painter& painter, const CanvasView& view, Occupied* occupied);

// --- Draws a robot as a disc with its number, or as a dot among very many robots.

// The radii of a robot's disc and ring, in pixels: smaller for many robots.
struct DiscSize {
  float disc, ring;
  bool numbered;
};
inline constexpr std::size_t most_labelled = 50;
DiscSize robot_size(std::size_t teams);

// The radius of a robot's disc with its ring, in pixels.
float mark_radius(const std::vector<Team>& teams);

// The distance from a robot, in pixels, to the outer end of its team's mark or, if robots have no
// numbers, to just outside its ring.
double mark_reach(const DiscSize& size);

// Draws the pale body of a robot without a size. The body is not to scale. Call this before any
// robot's disc is drawn.
void draw_small_body(const Painter& painter, const Theme& theme, const DiscSize& size,
                     const Vec2& world);

// The number of teams of two, or of teams that balanced robots would make: half the number of
// robots, rounded up.
std::size_t pairs_of(const std::vector<Team>& teams);

// The number of robots in the first `teams` teams of `all`.
std::size_t robots_of(const std::vector<Team>& all, std::size_t teams);

// The sizes of the robots in the first `teams` teams of `all`. A robot near another is smaller, and
// a robot very near another also has no number. O(m^2) for m robots; with more than most_labelled
// pairs, no distances are examined.
std::vector<DiscSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                  std::size_t teams);

// A failed robot is hollow. The robots of a team of two have a common mark (evenlift::tally) on the
// side away from C.
struct RobotLook {
  std::size_t number = 1;
  std::size_t team = 0;  // from 1; 0 if it has no mark
  Vec2 outward;          // away from C, in polygon coordinates
  double share = 1;      // its load as a share of the greatest load
  bool over = false, failed = false;
  bool marked = false;   // its card is open, or it is pointed at
  bool beneath = false;  // stands beneath the object, and touches nothing sideways
};
void draw_robot(const Painter& painter, const Theme& theme, const DiscSize& size, const Vec2& world,
                const RobotLook& look);

// Draws thousands of robots as dots. Robots in the same spot share a dot, so that the window bounds
// the cost of a frame.
void draw_swarm(const Painter& painter, const CanvasView& view, std::size_t teams);

// --- A text in a box, over the picture.

// Draws the text beside a spot, and moves it if necessary to keep it inside the window.
void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text);

// Fractions of a line's length, the best first.
using SharesOfLine = std::array<double, 6>;
inline constexpr SharesOfLine from_middle = {0.5, 0.32, 0.68, 0.18, 0.82, 0.9};

// The box of a text on a line, at the first fraction where the box covers none of `before`; nullopt
// if no fraction works. Adds the box to `before`. All values are in pixels.
std::optional<Rect> clear_box_on_line(const Vec2& from, const Vec2& to, const Vec2& size,
                                      const SharesOfLine& shares, std::vector<Rect>& before);

// The box of a text that must appear: if no fraction works, the box is at the first one. Adds the
// box to `before`.
Rect box_on_line(const Vec2& from, const Vec2& to, const Vec2& size, const SharesOfLine& shares,
                 std::vector<Rect>& before);

// The text with a capital at its beginning, if it begins with a letter from a to z.
std::string capitalised(std::string text);

// --- Numbers in the picture: the robots' loads, and the coverage.

// The place of the coverage's number, in pixels; nothing if it is hidden or has no room.
std::optional<Rect> coverage_box(const CanvasView& view);
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

// --- Draws a placement's robots and their loads.

void draw_robots(const Painter& painter, const CanvasView& view);

// --- The stands of robots with a size, and the unusable parts of the boundary.

// Draws the unusable parts in grey, and no-go parts in amber. Call it only if robots have a size,
// or if there are no-go parts. O(parts).
void draw_unusable(const Painter& painter, const Placement& placement, const Theme& theme);

// All robots, if their bodies look at least as large as their discs; none otherwise, or for very
// many robots. O(robots).
std::vector<PlacedRobot> drawn_bodies(const CanvasView& view);

// Whether the robots have a size, which is then drawn to scale.
bool draws_sizes(const Placement& placement);

// Draws the unusable parts and, if robots have a size, their bodies, arms and hands to scale,
// beneath their marks. O(parts + robots).
void draw_stands(const Painter& painter, const CanvasView& view);

// The reason why no robot can stand at the hovered place of an edge; nullopt if a robot can stand
// there, or if the document is refused. O(log n).
std::optional<WhyUnusable> why_unusable(const AppState& state, const Pick& at);

// Writes that reason at the pointer.
void draw_why_unusable(const Painter& painter, const CanvasView& view);

// The labels of the loads, once all loads are known. Names keep clear of these labels
// (canvas_walkthrough.cpp).
std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view);

// Draws the robots placed up to the current step.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

// --- The tools' drawings: the polygon being drawn, and the frame for moving, turning and scaling.

// Words stay within `free`.
void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme,
                  const Rect& free);
void draw_frame_grips(const Painter& painter, const CanvasView& view);

struct NumberedEdge {
  Vec2 a, b;
  std::size_t edge;
};
// Draws the numbers of edges, from 1, as in messages and settings. If an edge has room, its number
// covers neither an earlier number nor one of the boxes `before`, which are in pixels.
void draw_edge_numbers(const Painter& painter, const Theme& theme, Colour colour,
                       const std::vector<NumberedEdge>& edges, std::vector<Rect> before = {});

// --- Explains a mark of the first picture.

// The mark where the pointer rests, if that is explained (tools/picture_marks.h). O(n + m).
std::optional<PictureMark> rested_mark(const CanvasView& view);

// Draws the words of the mark for which a key asked or, without one, of the mark where the pointer
// rests. O(n + m).
void draw_explained(ImDrawList& list, const CanvasView& view);

// --- Draws everything of a fixed size on a picture: grips, robots, the centre of mass, numbers.

void draw_marks(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
