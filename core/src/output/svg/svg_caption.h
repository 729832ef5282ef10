// The caption below the picture: the verdict, the settings, and a key to the visible colours.
#pragma once

#include <optional>
#include <string>

#include "evenlift/extra_load.h"
#include "evenlift/placement.h"

namespace evenlift::svg {

// The entries of the key that the picture needs.
struct Seen {
  bool hull = false, clockwise = false, counterclockwise = false;
  bool no_go = false, unusable = false, body = false, overload = false, slide = false;
  bool cargo = false, own_centre = false, tilt = false;
  std::optional<ExtraLoad> load = {};
};

struct Caption {
  std::string markup;
  double height = 0;  // in pixels
};

// The caption begins `top` pixels from above and is `width` pixels wide.
Caption make_caption(const ShownPlacement& of, const Seen& seen, double top, double width);

// The fill of a region, hatched at +45 degrees (clockwise) or -45, so that the regions differ even
// without colour and where they overlap. `fills` defines the fills.
std::string region_fill(bool clockwise);
std::string fills();

// The usual sign for a centre of mass: a disc with two opposite quarters filled.
std::string centre_mark(const Vec2& at, double radius);

}  // namespace evenlift::svg
