// Draws areas, outlines, dashes and hatching in polygon coordinates through a camera.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "picture/scene.h"
#include "picture/triangulate.h"
#include "state/camera.h"
#include "ui/theme.h"

namespace evenlift::view {

// If there are more candidates than this, their chords are not dashed, because tens of thousands of
// dashes are slow to draw.
inline constexpr std::size_t most_dashed = 300;

class Painter {
 public:
  // A `strength` below 1 fades everything, to show that the result is out of date.
  Painter(ImDrawList& list, const Camera& camera, const Rect& window, float strength = 1)
      : list_(list), camera_(camera), window_(window), strength_(strength) {}

  ImDrawList& list() const { return list_; }
  ImVec2 at(const Vec2& world) const;  // the point on the screen, in pixels

  void fill(const Points& corners, const std::vector<std::uint32_t>& triangles,
            Colour colour) const;
  // rows() finds the rows of the visible part of a large polygon. fill() fills these rows or, if
  // `within` is not empty, only their part in this convex area.
  RowFill rows(const Points& polygon, const std::vector<Points>& holes = {}) const;
  void fill(const RowFill& rows, Colour colour, const Points& within = {}) const;
  void triangles(const std::vector<Vec2>& corners, Colour colour) const;
  // Fills the bands' triangles or, for a large polygon, the rows within the bands' regions.
  void heat(const std::vector<HeatBand>& bands, const RowFill& rows, const Theme& theme) const;
  void fill_convex(const Points& counter_clockwise, Colour colour) const;
  // Fills a convex area without the holes in it.
  void fill_around(const std::vector<Points>& holes, const Points& counter_clockwise,
                   Colour colour) const;
  void outline(const Points& polygon, Colour colour, float width, bool closed = true) const;
  void outlines(const Points& polygon, const std::vector<Points>& holes, Colour colour,
                float width) const;
  void line(const Vec2& a, const Vec2& b, Colour colour, float width) const;
  void dashes(const Vec2& a, const Vec2& b, Colour colour, float width) const;
  // Draws the chord of one of `count` candidates: dashed, or as a thin line if `count` is more than
  // most_dashed.
  void candidate(const Vec2& a, const Vec2& b, Colour colour, std::size_t count) const;
  // Draws a region of rotation centres, which may be as small as a segment or a point.
  void region(const Points& counter_clockwise, Colour fill, Colour line, bool rising) const;
  // Draws an arrow between points on the screen, in pixels.
  void arrow(const Vec2& tail, const Vec2& head, Colour colour, float width) const;
  // Hatches a convex area with lines at +45° (rising) or −45°. The lines move with the polygon.
  void hatch_convex(const Points& counter_clockwise, bool rising, Colour colour) const;

 private:
  // Returns the part of a convex area near the window, in pixels, clockwise on the screen.
  Points clipped(const Points& counter_clockwise) const;
  // Shortens a segment on the screen to its part near the window. Returns false if there is no such
  // part.
  bool clip(Vec2& a, Vec2& b) const;
  // Returns whether part of a segment on the screen may be visible. O(1).
  bool seen(const Vec2& a, const Vec2& b) const;
  void long_outline(const Points& polygon, Colour colour, float width, bool closed) const;
  // The distance in pixels below which two points look like one.
  double least_step() const;
  // Returns the left and right end of a convex area in each row, in pixels.
  std::vector<std::pair<float, float>> reach(const Points& convex, float row_height) const;

  ImDrawList& list_;
  const Camera& camera_;
  Rect window_;
  float strength_;
};

}  // namespace evenlift::view
