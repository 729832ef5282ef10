// The parts of an SVG picture.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/plane.h"
#include "evenlift/report.h"
#include "evenlift/vec.h"

namespace evenlift::svg {

// --- The picture's colours, and its sizes in CSS pixels at the picture's natural size.

inline constexpr double largest_width = 720, largest_height = 520;    // of the object
inline constexpr double smallest_width = 680, smallest_height = 300;  // of the ground around it
inline constexpr double margin = 72;          // width of ground around the object; loads fit there
inline constexpr double caption_margin = 24;  // width of the panel around the caption

inline constexpr std::string_view ground_colour = "#EEF1F4";
inline constexpr std::string_view panel_colour = "#FFFFFF";
inline constexpr std::string_view line_colour = "#D5DBE1";
inline constexpr std::string_view text_colour = "#1B232B";
inline constexpr std::string_view second_text_colour = "#55616D";
inline constexpr std::string_view object_colour = "#FFFFFF";
inline constexpr std::string_view outline_colour = "#2B3540";
inline constexpr std::string_view hull_colour = "#2FA36B";
inline constexpr std::string_view hull_outline_colour = "#1F7A4E";
inline constexpr std::string_view clockwise_colour = "#D1495B";
inline constexpr std::string_view counterclockwise_colour = "#2D6CDF";
inline constexpr std::string_view chord_colour = "#55616D";
inline constexpr std::string_view overload_colour = "#9A5B00";
inline constexpr std::string_view unusable_colour = "#8592A0";
inline constexpr std::string_view no_go_colour = "#9A5B00";
inline constexpr std::string_view slide_colour = "#9A5B00";
inline constexpr std::string_view body_colour = "#1B232B";
inline constexpr std::string_view cargo_colour = "#55616D";
inline constexpr std::string_view candidate_colour = "#66727E";

// --- Pieces of SVG, with numbers in pixels. Attributes have the form ` name="value"`, with a leading
// blank.

std::string px(double value);  // to a hundredth, without trailing zeros

std::string attribute(std::string_view name, std::string_view value);
std::string attribute(std::string_view name, double value);

std::string element(std::string_view tag, std::string_view attributes);  // <tag .../>

std::string path(const Points& points, bool closed);  // the attribute d
std::string path(const std::vector<Points>& rings);   // the attribute d of closed rings

// Draws an arrow with a white border, which separates it from the shapes below.
std::string arrow(const Vec2& tail, const Vec2& head, std::string_view colour);

// Writes words whose baseline is at `at`.
std::string text(const Vec2& at, double size, std::string_view words,
                 std::string_view attributes = "");

// A generous estimate of the text's width, since the reader's font is unknown. `average` is the
// average width of a character in units of the size.
double text_width(std::string_view words, double size, double average = 0.56);

// Breaks words at blanks into lines of at most `width`. A longer word gets a line of its own.
std::vector<std::string> wrapped(std::string_view words, double size, double width);

// --- Places in the picture, in pixels with y down.

// Maps polygon coordinates (y up) to pixels. The ground is the coloured area behind the object, and
// the object's box is in its middle.
struct Paper {
  // The object has `share` times its usual size (svg_style.h).
  Paper(const Points& vertices, double share);

  double width = 0, height = 0;  // the size of the ground
  double scale = 1;              // pixels per unit of length
  Vec2 middle;                   // the middle of the object's box, in polygon coordinates

  Vec2 operator()(const Vec2& p) const;
  Points operator()(const Points& points) const;
};

// The part of a convex area, segment or point that is on the ground. All are in pixels. O(points).
Points clipped(Points area, const Paper& paper);

// The outline, in pixels, without vertices that a reader cannot tell from the last one kept. O(n).
Points visible(const Points& outline);

// --- The discs of the robots; robots at almost the same place share one.

struct Stand {
  Vec2 at;                          // in pixels
  std::string numbers;              // "3", "1·4", "×5" for five robots
  std::size_t team = 0;             // from 1; 0 if robots share it or are not in teams of two
  std::vector<LoadRange> loads;     // the robots' loads
  std::vector<std::size_t> robots;  // their numbers (loads.h)
  std::optional<Box> body;          // the first robot's, if robots have a size
  bool beneath = false;             // beneath the object (supports.h)
  std::string name = {};            // of a single robot
};

// Robots closer than `apart` pixels share a stand, but a robot beneath the object never shares one
// with a robot at the edge. Stands are in the order of the teams. `sized` contains all robots if
// they have a size; otherwise it is empty. `loads` is empty if the object falls.
// O(robots * stands); a picture has room for a few thousand stands.
std::vector<Stand> find_stands(const Placement& placement, const std::vector<PlacedRobot>& sized,
                               const std::vector<LoadRange>& loads, const Paper& paper,
                               double apart);

// Writes a stand's load: "16.7 kg" or "14.2–19.2 kg"; for several robots "2 × 16.7 kg", "16.7 +
// 15.9 kg" or the sum, "Σ 50.1 kg". `largest` sets the number of decimals, as for amount()
// (words.h).
std::string load_text(const Stand& stand, double largest, const Units& units);

// --- Draws the unusable boundary, and robots to scale.

// The robots of all teams in turn; empty if the robots have no size. O(n + robots).
std::vector<PlacedRobot> robots_with_size(const Placement& placement);

// Points that must fit on the paper: the vertices, and corners of the boxes around these robots'
// bodies and the discs of cargo. O(n + robots + items).
Points extent(const Placement& placement, const std::vector<PlacedRobot>& robots);

// Draws the unusable boundary; empty if robots may stand anywhere. O(parts).
std::string unusable_boundary(const Placement& placement, const Paper& paper);

// Draws the robots to scale. O(robots).
std::string bodies(const std::vector<PlacedRobot>& robots, const RobotSize& size,
                   const Paper& paper);

// The box around the robot's body, in pixels. O(1).
Box body_box(const PlacedRobot& robot, const RobotSize& size, const Paper& paper);

// --- Draws discs of cargo, whose areas show the weights, and the object's own centre of mass.

// Adds corners of the boxes around the discs. Leaves out items whose middle is more than L/2
// outside the object's box, since the picture would otherwise show a small object. O(n + items).
void add_discs_of_cargo(const Placement& placement, Points& points);

// Draw the disc of an item, and the hollow mark of the centre of mass without cargo. O(1).
std::string cargo_disc(const Vec2& at, double radius);
std::string own_centre_mark(const Vec2& at, double radius);

// The item's name, cut if it is long; its weight if it has no name. O(1).
std::string cargo_label(const Cargo& item, const Units& units);

// --- Draws the slopes at which the object tips, and the region where a further load may stand.

// Fills the region where the load may stand with green, and the rest of the object with stripes.
// `rings`, the object's boundary, and `region` are in pixels.
std::string load_region(const std::vector<Points>& rings, const Points& region);
std::string load_swatch();

// Draws the circles of tilt_circles() (placed_robots.h) with their slopes. Empty if there are none.
std::string tilt_marks(const ShownPlacement& of, const Paper& paper);
std::string tilt_swatch();

// --- The verdict, the settings, and a key to the visible colours, below the picture.

// The parts of the picture that its key must explain.
struct Seen {
  bool hull = false, clockwise = false, counterclockwise = false;
  bool no_go = false, unusable = false, body = false, overload = false, slide = false;
  bool cargo = false, own_centre = false, tilt = false, load = false;
};

struct Caption {
  std::string markup;
  double height = 0;  // in pixels
};

// `top` and `width` are in pixels.
Caption make_caption(const Reported& of, const Seen& seen, double top, double width);

// The fill of a region of free rotations: hatching that rises to the right if they are clockwise,
// otherwise to the left. So the regions can be told apart without colour, even where they overlap.
// fills() defines both fills.
std::string region_fill(bool clockwise);
std::string fills();

// The usual sign of a centre of mass: a disc with two opposite quarters filled.
std::string centre_mark(const Vec2& at, double radius);

}  // namespace evenlift::svg
