#include "state/camera.h"

#include <algorithm>
#include <cmath>

#include "evenlift/plane.h"

namespace evenlift::view {

std::optional<PartOfSegment> part_within(const Rect& rect, const Vec2& a, const Vec2& b) {
  PartOfSegment part;
  const auto bound = [&part](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    const double first = (low - start) / step, second = (high - start) / step;
    part.from = std::max(part.from, std::min(first, second));
    part.to = std::min(part.to, std::max(first, second));
    return part.from <= part.to;
  };
  const Vec2 along = b - a;
  if (!bound(a.x, along.x, rect.left, rect.right) || !bound(a.y, along.y, rect.top, rect.bottom))
    return std::nullopt;
  return part;
}

Vec2 Camera::to_screen(const Vec2& world) const {
  return {anchor.x + (world.x - centre.x) * scale, anchor.y - (world.y - centre.y) * scale};
}

Vec2 Camera::to_world(const Vec2& screen) const {
  return {centre.x + (screen.x - anchor.x) / scale, centre.y - (screen.y - anchor.y) / scale};
}

Camera fit(const Points& points, const Rect& room) {
  Camera camera;
  camera.anchor = room.middle();
  if (points.empty()) return camera;
  const Box box = bounding_box(points);
  camera.centre = box.middle();
  // An edit may pass through a shape without extent: it is shown with a minimal one.
  const double width = std::max(box.size().x, 1e-9), height = std::max(box.size().y, 1e-9);
  camera.scale =
      std::min(std::max(room.width(), 40.0) / width, std::max(room.height(), 40.0) / height);
  return camera;
}

Camera zoom(const Camera& camera, const Vec2& about, double factor, double smallest,
            double largest) {
  Camera zoomed = camera;
  zoomed.centre = camera.to_world(about);
  zoomed.anchor = about;
  zoomed.scale = std::clamp(camera.scale * factor, smallest, largest);
  // Back to the old anchor, where the next fit or resize expects the centre.
  zoomed.centre = zoomed.to_world(camera.anchor);
  zoomed.anchor = camera.anchor;
  return zoomed;
}

Camera pan(const Camera& camera, const Vec2& pixels) {
  Camera panned = camera;
  panned.centre = camera.to_world(camera.anchor - pixels);
  return panned;
}

double grid_step(const Camera& camera) {
  const double wanted = 22 / camera.scale, power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (double nice : {1.0, 2.0, 5.0}) {
    if (nice * power >= wanted) return nice * power;
  }
  return 10 * power;
}

Vec2 nearest_dot(const Camera& camera, const Vec2& world) {
  const double step = grid_step(camera), inverse = std::round(1 / step);
  // A quotient or product of integers is rounded once, to the double nearest to the decimal.
  const auto nearest = [&](double value) {
    const double dots = std::round(value / step);
    const double at = step < 1 ? dots / inverse : dots * step;
    return at == 0 ? 0.0 : at;  // no -0
  };
  return {nearest(world.x), nearest(world.y)};
}

namespace {

Vec2 rounded(const Camera& camera, const Vec2& world, int more) {
  const int decimals =
      std::clamp(static_cast<int>(std::ceil(std::log10(camera.scale))) + more, -6, 12);
  const double power = std::pow(10.0, std::abs(decimals));
  const auto round = [&](double value) {
    const double nearest =
        decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return nearest == 0 ? 0.0 : nearest;
  };
  return {round(world.x), round(world.y)};
}

}  // namespace

Vec2 rounded_to_pixels(const Camera& camera, const Vec2& world) {
  return rounded(camera, world, 0);
}

Vec2 rounded_finely(const Camera& camera, const Vec2& world) { return rounded(camera, world, 2); }

}  // namespace evenlift::view
