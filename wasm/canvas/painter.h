// Draws geometry in polygon coordinates through a camera: areas, outlines, dashes, hatching.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "canvas/fill_rows.h"
#include "state/camera.h"
#include "ui/theme.h"

namespace evenlift::view {

class Painter {
 public:
  // `strength` fades everything, for a result that is no longer current.
  Painter(ImDrawList& list, const Camera& camera, const Rect& window, float strength = 1)
      : list_(list), camera_(camera), window_(window), strength_(strength) {}

  ImDrawList& list() const { return list_; }
  ImVec2 at(const Vec2& world) const;

  void fill(const Points& polygon, const std::vector<std::uint32_t>& triangles,
            Colour colour) const;
  // What of a large polygon the window shows, filled by rows; `within` a convex area, if given.
  RowFill rows(const Points& polygon) const;
  void fill(const RowFill& rows, Colour colour, const Points& within = {}) const;
  void triangles(const std::vector<Vec2>& corners, Colour colour) const;
  void fill_convex(const Points& counter_clockwise, Colour colour) const;
  void outline(const Points& polygon, Colour colour, float width, bool closed = true) const;
  void line(const Vec2& a, const Vec2& b, Colour colour, float width) const;
  void dashes(const Vec2& a, const Vec2& b, Colour colour, float width) const;
  // Lines at +45° (rising) or −45°, fixed to the plane, so that they do not swim when it is moved.
  void hatch_convex(const Points& counter_clockwise, bool rising, Colour colour) const;

 private:
  // The part of a convex area, in CSS pixels, that the window shows, clockwise on the screen.
  Points clipped(const Points& counter_clockwise) const;
  // The part of a segment near the window; false if there is none.
  bool clip(Vec2& a, Vec2& b) const;
  // Whether the window may show something of a segment. O(1).
  bool seen(const Vec2& a, const Vec2& b) const;
  void long_outline(const Points& polygon, Colour colour, float width, bool closed) const;
  // Points closer together, in CSS pixels, look like one.
  double least_step() const;
  // From where to where a convex area reaches in each of the rows.
  std::vector<std::pair<float, float>> reach(const Points& convex, float row_height) const;

  ImDrawList& list_;
  const Camera& camera_;
  Rect window_;
  float strength_;
};

}  // namespace evenlift::view
