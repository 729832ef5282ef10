// Below the picture: the verdict, what was asked for, and a key to the colours that are seen.
#pragma once

#include <string>

#include "evenlift/placement.h"

namespace evenlift::svg {

// What of the key is in the picture.
struct Seen {
  bool hull = false, clockwise = false, counterclockwise = false;
  bool no_go = false, unusable = false, body = false, overload = false, slide = false;
};

struct Caption {
  std::string markup;
  double height = 0;  // in pixels
};

// Its top is `top` pixels from above, and it is `width` pixels wide.
Caption make_caption(const ShownPlacement& of, const Seen& seen, double top, double width);

// The fill of a region: hatched at +45 degrees (clockwise) or -45, so that they differ without
// colour too, also where they overlap. `fills` defines them.
std::string region_fill(bool clockwise);
std::string fills();

// The usual sign for a centre of mass: a disc with two opposite quarters filled.
std::string centre_mark(const Vec2& at, double radius);

}  // namespace evenlift::svg
