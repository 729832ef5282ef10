#include "picture/labels.h"
#include "picture/canvas_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/angles.h"
#include "evenlift/output/picture.h"
#include "evenlift/plane.h"

namespace evenlift::view {
namespace {

constexpr double cell = 4;  // pixels

Rect around(const Vec2& middle, const Vec2& size) {
  return {middle.x - size.x / 2, middle.y - size.y / 2, middle.x + size.x / 2,
          middle.y + size.y / 2};
}

Vec2 turned(const Vec2& v, double degrees) {
  const double a = degrees * pi / 180, c = std::cos(a), s = std::sin(a);
  return {v.x * c - v.y * s, v.x * s + v.y * c};
}

// The middle of a box in direction `u` that just clears a disc of radius `reach`.
Vec2 beside(const Vec2& robot, const Vec2& u, const Vec2& size, double reach) {
  const double x = std::abs(u.x) * size.x / 2, y = std::abs(u.y) * size.y / 2;
  return robot + u * (reach + x + y);
}

bool inside_convex(const Points& hull, const Vec2& p) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[i + 1 == hull.size() ? 0 : i + 1];
    if (cross(b - a, p - a) < 0) return false;
  }
  return true;
}

double away(const Vec2& a, const Vec2& b, const Vec2& p) {
  return length(p - nearest_on_segment(a, b, p));
}

double away(const Points& ring, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, away(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], p));
  return least;
}

// The room at `p` for the coverage's number; 0 outside the object or the lifting base.
double clearance(const Placement& placement, const Vec2& p) {
  if (!inside_convex(placement.lifting_base, p) || !inside(placement.vertices(), p) ||
      placement.object.hole_around(p))
    return 0;
  double room = std::min(length(p - placement.centre_of_mass), away(placement.lifting_base, p));
  for (const Team& team : placement.teams) {
    for (const Segment& line : joining_lines(team, placement.centre_of_mass))
      room = std::min(room, away(line.from, line.to, p));
  }
  for (const Cargo& item : placement.settings.cargo) room = std::min(room, length(p - item.at));
  for (const Polygon& hole : placement.object.holes())
    room = std::min(room, away(hole.vertices(), p));
  return std::min(room, away(placement.vertices(), p));
}

}  // namespace

Occupied::Occupied(const Rect& window)
    : window_(window),
      across_(std::max(0, static_cast<int>(window.width() / cell) + 1)),
      down_(std::max(0, static_cast<int>(window.height() / cell) + 1)),
      boxes_(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_)),
      lines_(boxes_.size()) {}

Occupied::Cells Occupied::cells(const Rect& area) const {
  const auto index = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at / cell), -1.0, static_cast<double>(count)));
  };
  return {std::max(0, index(area.left - window_.left, across_)),
          std::max(0, index(area.top - window_.top, down_)),
          std::min(across_, index(area.right - window_.left, across_) + 1),
          std::min(down_, index(area.bottom - window_.top, down_) + 1)};
}

std::size_t Occupied::index_of(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) +
         static_cast<std::size_t>(x);
}

void Occupied::box(const Rect& taken) {
  const Cells c = cells(taken);
  for (int y = c.top; y < c.bottom; ++y)
    for (int x = c.left; x < c.right; ++x) boxes_[index_of(x, y)] = 1;
}

void Occupied::disc(const Vec2& middle, double radius) {
  // Only rows near the window are visited, since a disc may be far larger than the window.
  const double first = std::max(-radius, window_.top - middle.y - cell),
               last = std::min(radius, window_.bottom - middle.y + cell);
  const int rows = static_cast<int>(std::ceil((last - first) / cell));
  for (int row = 0; row < rows; ++row) {
    const double y = first + row * cell;
    const double inner = std::min(std::fabs(y), std::fabs(y + cell)),
                 half = y < 0 && y + cell > 0 ? radius : std::sqrt(radius * radius - inner * inner);
    box({middle.x - half, middle.y + y, middle.x + half, middle.y + y + cell});
  }
}

void Occupied::line(const Vec2& a, const Vec2& b) {
  const auto column = [&](const Vec2& p) { return static_cast<int>((p.x - window_.left) / cell); };
  const auto row = [&](const Vec2& p) { return static_cast<int>((p.y - window_.top) / cell); };
  // Most edges of an outline with many vertices lie within one cell.
  if (window_.contains(a) && window_.contains(b) && column(a) == column(b) && row(a) == row(b)) {
    lines_[index_of(column(a), row(a))] = 1;
    return;
  }
  const std::optional<PartOfSegment> part = part_within(window_, a, b);  // only this part has cells
  if (!part) return;
  const double share = part->to - part->from;
  const Vec2 along = b - a;
  const int steps = static_cast<int>(length(along) * share / cell) + 1;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = a + along * (part->from + share * i / steps);
    const int x = column(p), y = row(p);
    if (x >= 0 && y >= 0 && x < across_ && y < down_) lines_[index_of(x, y)] = 1;
  }
}

bool Occupied::is_free(const Rect& wanted) const {
  if (wanted.left < window_.left || wanted.right > window_.right || wanted.top < window_.top ||
      wanted.bottom > window_.bottom)
    return false;
  const Cells c = cells(wanted);
  for (int y = c.top; y < c.bottom; ++y)
    for (int x = c.left; x < c.right; ++x)
      if (boxes_[index_of(x, y)]) return false;
  return true;
}

int Occupied::crossed(const Rect& wanted) const {
  const Cells c = cells(wanted);
  int count = 0;
  for (int y = c.top; y < c.bottom; ++y)
    for (int x = c.left; x < c.right; ++x) count += lines_[index_of(x, y)];
  return count;
}

std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              Occupied& occupied, double reach, int most_crossed) {
  std::vector<std::optional<Rect>> places(requests.size());
  constexpr double turns[] = {0, 25, -25, 50, -50, 75, -75, 100, -100, 130, -130, 180};
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const LabelRequest& request = requests[i];
    int fewest = most_crossed + 1;
    // Places farther away are used only if they cover fewer lines.
    for (const double farther : {0.0, 9.0}) {
      for (const double turn : turns) {
        if (fewest == 0) break;
        const Rect box = around(beside(request.robot, turned(request.outward, turn), request.size,
                                       std::max(reach, request.reach) + farther),
                                request.size);
        if (!occupied.is_free(box)) continue;
        const int crossed = occupied.crossed(box);
        if (crossed >= fewest) continue;
        fewest = crossed;
        places[i] = box;
      }
    }
    if (places[i]) occupied.box(*places[i]);
  }
  return places;
}

CoveragePlace place_coverage(const Placement& placement, const Vec2& before) {
  // With more parts, a number has no room anyway, and the search would take long.
  if (placement.lifting_base.size() < 3 || placement.teams.size() > 40 ||
      placement.object.boundary().size() > 400 || placement.settings.cargo.size() > 40)
    return {};
  const Box box = bounding_box(placement.lifting_base);
  CoveragePlace best{before, clearance(placement, before)};
  double to_beat = best.room * 1.3;
  constexpr int steps = 28;
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; j < steps; ++j) {
      const Vec2 p(box.low.x + box.size().x * i / steps, box.low.y + box.size().y * j / steps);
      const double room = clearance(placement, p);
      if (room > to_beat) {
        to_beat = room;
        best = {p, room};
      }
    }
  }
  return best;
}

}  // namespace evenlift::view
