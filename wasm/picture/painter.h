// Draws areas, outlines, dashes and hatching in polygon coordinates through a camera.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "picture/fill_rows.h"
#include "picture/heat.h"
#include "state/camera.h"
#include "ui/theme.h"

namespace evenlift::view {

// More lines are not dashed: tens of thousands of dashes are slow to draw.
inline constexpr std::size_t most_dashed = 300;

class Painter {
 public:
  // `strength` below 1 fades everything, since the result is out of date.
  Painter(ImDrawList& list, const Camera& camera, const Rect& window, float strength = 1)
      : list_(list), camera_(camera), window_(window), strength_(strength) {}

  ImDrawList& list() const { return list_; }
  ImVec2 at(const Vec2& world) const;

  void fill(const Points& corners, const std::vector<std::uint32_t>& triangles,
            Colour colour) const;
  // Fills the visible part of a large polygon by rows, or only its part `within` a convex area.
  RowFill rows(const Points& polygon, const std::vector<Points>& holes = {}) const;
  void fill(const RowFill& rows, Colour colour, const Points& within = {}) const;
  void triangles(const std::vector<Vec2>& corners, Colour colour) const;
  // By triangles or, for a large polygon, by rows.
  void heat(const std::vector<HeatBand>& bands, const RowFill& rows, const Theme& theme) const;
  void fill_convex(const Points& counter_clockwise, Colour colour) const;
  // A convex area without the holes in it.
  void fill_around(const std::vector<Points>& holes, const Points& counter_clockwise,
                   Colour colour) const;
  void outline(const Points& polygon, Colour colour, float width, bool closed = true) const;
  // Also those of the holes.
  void outlines(const Points& polygon, const std::vector<Points>& holes, Colour colour,
                float width) const;
  void line(const Vec2& a, const Vec2& b, Colour colour, float width) const;
  void dashes(const Vec2& a, const Vec2& b, Colour colour, float width) const;
  // A chord of `count` candidates: dashed, or a thin line if there are more than most_dashed.
  void candidate(const Vec2& a, const Vec2& b, Colour colour, std::size_t count) const;
  // Of rotation centres. It may be as small as a segment or a point.
  void region(const Points& counter_clockwise, Colour fill, Colour line, bool rising) const;
  // Between points on the screen, in pixels.
  void arrow(const Vec2& tail, const Vec2& head, Colour colour, float width) const;
  // With lines at +45° (rising) or −45°, which move with the plane.
  void hatch_convex(const Points& counter_clockwise, bool rising, Colour colour) const;

 private:
  // Of a convex area, in pixels, clockwise on the screen.
  Points clipped(const Points& counter_clockwise) const;
  // To the part near the window; returns false if there is none.
  bool clip(Vec2& a, Vec2& b) const;
  // Whether part of the segment may be visible. O(1).
  bool seen(const Vec2& a, const Vec2& b) const;
  void long_outline(const Points& polygon, Colour colour, float width, bool closed) const;
  // Closer points look like one, in pixels.
  double least_step() const;
  // The left and right end in each row.
  std::vector<std::pair<float, float>> reach(const Points& convex, float row_height) const;

  ImDrawList& list_;
  const Camera& camera_;
  Rect window_;
  float strength_;
};

}  // namespace evenlift::view
