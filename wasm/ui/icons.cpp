#include "ui/icons.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace evenlift::view {
namespace {

constexpr float pi = 3.14159265f;

// The side of an icon's square, with y down (web/kit/icons.js).
constexpr float side = 20;
constexpr float stroke_width = 1.7f, dot_radius = 1.35f;

// In hundredths of a unit.
struct Point {
  std::int16_t x, y;
};
// A single point is a dot.
struct Stroke {
  std::int16_t first, count;
  bool closed;
};
struct Strokes {
  Icon icon;
  std::int16_t first, count;
};
#include "icon_strokes.inc"

static_assert(std::size(icons) == icon_count, "web/kit/icons.js has a stroke for each icon");

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size, Colour colour) {
  const Strokes* found = std::find_if(std::begin(icons), std::end(icons),
                                      [&](const Strokes& s) { return s.icon == icon; });
  if (found == std::end(icons)) return;  // Icon::none
  const float unit = size / side;
  const auto at = [&](const Point& p) {
    return ImVec2(middle.x + (p.x / 100.0f - side / 2) * unit,
                  middle.y + (p.y / 100.0f - side / 2) * unit);
  };
  for (const Stroke* s = strokes + found->first; s != strokes + found->first + found->count; ++s) {
    if (s->count == 1) {
      list.AddCircleFilled(at(points[s->first]), dot_radius * unit, colour.packed(), 16);
      continue;
    }
    for (int i = 0; i < s->count; ++i) list.PathLineTo(at(points[s->first + i]));
    list.PathStroke(colour.packed(), s->closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                    stroke_width * unit);
  }
}

void draw_centre_mark(ImDrawList& list, ImVec2 middle, float radius, Colour dark, Colour light) {
  list.AddCircleFilled(middle, radius, light.packed(), 32);
  for (float start : {0.0f, pi}) {
    list.PathLineTo(middle);
    list.PathArcTo(middle, radius, start, start + pi / 2, 10);
    list.PathFillConvex(dark.packed());
  }
  list.AddCircle(middle, radius, dark.packed(), 32, radius / 5);
}

}  // namespace evenlift::view
