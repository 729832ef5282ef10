// The verdict, the settings, and a key to the visible colours, below the picture.
#pragma once

#include <string>

#include "evenlift/report.h"

namespace evenlift::svg {

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
