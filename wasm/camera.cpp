#include "camera.h"

#include <algorithm>
#include <cmath>

namespace evenlift::view {

Vec2 Camera::to_screen(const Vec2& world) const {
  return {anchor.x() + (world.x() - centre.x()) * scale,
          anchor.y() - (world.y() - centre.y()) * scale};
}

Vec2 Camera::to_world(const Vec2& screen) const {
  return {centre.x() + (screen.x() - anchor.x()) / scale,
          centre.y() - (screen.y() - anchor.y()) / scale};
}

Camera fit(const Points& points, const Rect& room) {
  Camera camera;
  camera.anchor = room.middle();
  if (points.empty()) return camera;
  Vec2 low = points[0], high = points[0];
  for (const Vec2& p : points) {
    low = {std::min(low.x(), p.x()), std::min(low.y(), p.y())};
    high = {std::max(high.x(), p.x()), std::max(high.y(), p.y())};
  }
  camera.centre = low + (high - low) / 2;
  // A shape without extent (an edit passes through such states) is shown as if it had some.
  const double width = std::max(high.x() - low.x(), 1e-9),
               height = std::max(high.y() - low.y(), 1e-9);
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
  // Back to the old anchor, which is where the next fit or resize expects the centre.
  zoomed.centre = zoomed.to_world(camera.anchor);
  zoomed.anchor = camera.anchor;
  return zoomed;
}

Camera pan(const Camera& camera, const Vec2& pixels) {
  Camera panned = camera;
  panned.centre = camera.to_world(camera.anchor - pixels);
  return panned;
}

Vec2 rounded_to_pixels(const Camera& camera, const Vec2& world) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(std::log10(camera.scale))), -6, 12);
  const double power = std::pow(10.0, std::abs(decimals));
  // A quotient of two integers is rounded once, so it is the double nearest to the decimal.
  const auto round = [&](double value) {
    const double rounded =
        decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return rounded == 0 ? 0.0 : rounded;  // no -0
  };
  return {round(world.x()), round(world.y())};
}

}  // namespace evenlift::view
