#include "picture/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "evenlift/plane.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

constexpr double margin = 40;  // pixels drawn beyond the window: line widths, fringes

// Dear ImGui keeps 40 bytes on the stack for each point of a line, and a polygon may have a
// million. So lines are drawn in pieces of at most this number of points.
constexpr std::size_t most_at_once = 4096;

// Of a polygon with more points, only points farther apart than this share of a device pixel are
// drawn.
constexpr std::size_t few = 2048;
constexpr double same_spot = 0.25;

}  // namespace

ImVec2 Painter::at(const Vec2& world) const { return vec(camera_.to_screen(world)); }

void Painter::fill(const Points& corners, const std::vector<std::uint32_t>& triangles,
                   Colour colour) const {
  if (triangles.empty()) return;
  const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
  const ImU32 packed = colour.at(strength_).packed();
  list_.PrimReserve(static_cast<int>(triangles.size()), static_cast<int>(corners.size()));
  const unsigned first = list_._VtxCurrentIdx;
  for (std::uint32_t corner : triangles) list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + corner));
  for (const Vec2& p : corners) list_.PrimWriteVtx(at(p), uv, packed);
}

RowFill Painter::rows(const Points& polygon, const std::vector<Points>& holes) const {
  return fill_rows(polygon, holes, camera_, window_, static_cast<double>(list_._FringeScale));
}

std::vector<std::pair<float, float>> Painter::reach(const Points& convex, float row_height) const {
  const double height = static_cast<double>(row_height);
  const auto count = static_cast<std::size_t>(window_.height() / height) + 2;
  std::vector<std::pair<float, float>> rows(count, {1e9f, -1e9f});
  for (std::size_t i = 0; i < convex.size(); ++i) {
    Vec2 a = camera_.to_screen(convex[i]),
         b = camera_.to_screen(convex[i + 1 == convex.size() ? 0 : i + 1]);
    if (a.y > b.y) std::swap(a, b);
    const auto row_after = [&](double y) {
      return static_cast<std::size_t>(
          std::clamp(std::ceil((y - window_.top) / height - 0.5), 0.0, static_cast<double>(count)));
    };
    for (std::size_t row = row_after(a.y); row < row_after(b.y); ++row) {
      const double y = window_.top + (static_cast<double>(row) + 0.5) * height;
      const auto x = static_cast<float>(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      rows[row] = {std::min(rows[row].first, x), std::max(rows[row].second, x)};
    }
  }
  return rows;
}

void Painter::fill(const RowFill& rows, Colour colour, const Points& within) const {
  const ImU32 packed = colour.at(strength_).packed();
  const std::vector<std::pair<float, float>> limits =
      within.empty() ? std::vector<std::pair<float, float>>() : reach(within, rows.height);
  for (const RowSpan& span : rows.spans) {
    float left = span.left, right = span.right;
    if (!limits.empty()) {
      const auto row = static_cast<std::size_t>(std::lround(
          (static_cast<double>(span.top) - window_.top) / static_cast<double>(rows.height)));
      left = std::max(left, limits[row].first);
      right = std::min(right, limits[row].second);
    }
    if (!(left < right)) continue;
    list_.PrimReserve(6, 4);
    list_.PrimRect(ImVec2(left, span.top), ImVec2(right, span.top + rows.height), packed);
  }
}

void Painter::heat(const std::vector<HeatBand>& bands, const RowFill& rows,
                   const Theme& theme) const {
  for (const HeatBand& band : bands) {
    triangles(band.triangles, heat_colour(theme, band.share));
    fill(rows, heat_colour(theme, band.share), band.region);
  }
}

void Painter::triangles(const std::vector<Vec2>& corners, Colour colour) const {
  // In pieces: Dear ImGui's indices may have 16 bits.
  constexpr std::size_t most = 3 * 4096;
  const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
  const ImU32 packed = colour.at(strength_).packed();
  for (std::size_t from = 0; from < corners.size(); from += most) {
    const std::size_t to = std::min(corners.size(), from + most);
    const int count = static_cast<int>(to - from);
    list_.PrimReserve(count, count);
    for (std::size_t i = from; i < to; ++i) {
      list_.PrimWriteIdx(static_cast<ImDrawIdx>(list_._VtxCurrentIdx));
      list_.PrimWriteVtx(at(corners[i]), uv, packed);
    }
  }
}

Points Painter::clipped(const Points& counter_clockwise) const {
  Points area;
  area.reserve(counter_clockwise.size() + 4);
  for (auto p = counter_clockwise.rbegin(); p != counter_clockwise.rend(); ++p)
    area.push_back(camera_.to_screen(*p));
  const Vec2 around(margin, margin);
  return evenlift::clip(std::move(area), Box{Vec2(window_.left, window_.top) - around,
                                             Vec2(window_.right, window_.bottom) + around});
}

double Painter::least_step() const { return same_spot * static_cast<double>(list_._FringeScale); }

void Painter::fill_convex(const Points& counter_clockwise, Colour colour) const {
  const Points area = clipped(counter_clockwise);
  if (area.size() < 3) return;
  // Points in one spot are drawn once, so the window bounds their number.
  const double least = area.size() > few ? least_step() : -1;
  Vec2 last = area.back();
  for (const Vec2& p : area) {
    if (!(length(p - last) > least)) continue;
    list_.PathLineTo(vec(p));
    last = p;
  }
  list_.PathFillConvex(colour.at(strength_).packed());
}

void Painter::fill_around(const std::vector<Points>& holes, const Points& counter_clockwise,
                          Colour colour) const {
  if (holes.empty()) return fill_convex(counter_clockwise, colour);
  if (counter_clockwise.size() < 3) return;
  // Holes may extend beyond the area, so this fills, by rows, the window within the area and
  // outside the holes.
  const Vec2 low = camera_.to_world(Vec2(window_.left, window_.bottom) + Vec2(-margin, margin)),
             high = camera_.to_world(Vec2(window_.right, window_.top) + Vec2(margin, -margin));
  const Points window{low, {high.x, low.y}, high, {low.x, high.y}};
  fill(rows(window, holes), colour, counter_clockwise);
}

void Painter::outlines(const Points& polygon, const std::vector<Points>& holes, Colour colour,
                       float width) const {
  outline(polygon, colour, width);
  for (const Points& hole : holes) outline(hole, colour, width);
}

void Painter::outline(const Points& polygon, Colour colour, float width, bool closed) const {
  if (polygon.empty()) return;
  if (polygon.size() > few) return long_outline(polygon, colour, width, closed);
  Points screen;
  screen.reserve(polygon.size());
  for (const Vec2& p : polygon) screen.push_back(camera_.to_screen(p));
  const ImU32 packed = colour.at(strength_).packed();
  const std::size_t n = screen.size();
  // Dear ImGui thins two lines towards a sharp corner, so the line is split there, with a round
  // joint at its ends.
  const auto is_sharp = [&](std::size_t i) {
    if (!closed && (i == 0 || i + 1 == n)) return false;
    const Vec2 in = screen[i] - screen[(i + n - 1) % n], out = screen[(i + 1) % n] - screen[i];
    return dot(in, out) < -0.7 * length(in) * length(out);
  };
  std::size_t first = 0;
  while (first < n && !is_sharp(first)) ++first;
  const bool parted = first < n;
  if (!parted || !closed) first = 0;
  for (std::size_t k = 0; k < n + (parted && closed ? 1 : 0); ++k) {
    const std::size_t i = (first + k) % n;
    list_.PathLineTo(vec(screen[i]));
    if (k == 0 || !parted || !is_sharp(i)) continue;
    list_.PathStroke(packed, ImDrawFlags_None, width);
    list_.AddCircleFilled(vec(screen[i]), width / 2, packed, 12);
    list_.PathLineTo(vec(screen[i]));
  }
  if (list_._Path.Size > 1)
    list_.PathStroke(packed, closed && !parted ? ImDrawFlags_Closed : ImDrawFlags_None, width);
  list_.PathClear();
}

// Each piece begins where the preceding one ended; parts outside the window are left out.
void Painter::long_outline(const Points& polygon, Colour colour, float width, bool closed) const {
  const ImU32 packed = colour.at(strength_).packed();
  const double least = least_step();
  const auto stroke = [&] { list_.PathStroke(packed, ImDrawFlags_None, width); };
  Vec2 last = camera_.to_screen(polygon[0]), before = last;
  const std::size_t edges = closed ? polygon.size() : polygon.size() - 1;
  for (std::size_t i = 1; i <= edges; ++i) {
    const Vec2 next = camera_.to_screen(polygon[i == polygon.size() ? 0 : i]);
    if (i < edges && length(next - last) < least) continue;
    // Dear ImGui draws a sharp reversal as a spike, so the line is split there.
    const bool back = dot(last - before, next - last) < 0;
    before = last;
    if (seen(last, next)) {
      if (back && list_._Path.Size > 1) stroke();
      if (list_._Path.Size == 0) list_.PathLineTo(vec(last));
      list_.PathLineTo(vec(next));
      if (static_cast<std::size_t>(list_._Path.Size) >= most_at_once) stroke();
    } else if (list_._Path.Size > 0) {
      stroke();
    }
    last = next;
  }
  if (list_._Path.Size > 0) stroke();
}

bool Painter::seen(const Vec2& a, const Vec2& b) const {
  return std::max(a.x, b.x) >= window_.left - margin &&
         std::min(a.x, b.x) <= window_.right + margin &&
         std::max(a.y, b.y) >= window_.top - margin &&
         std::min(a.y, b.y) <= window_.bottom + margin;
}

bool Painter::clip(Vec2& a, Vec2& b) const {
  const Rect drawn{window_.left - margin, window_.top - margin, window_.right + margin,
                   window_.bottom + margin};
  const std::optional<PartOfSegment> part = part_within(drawn, a, b);
  if (!part) return false;
  const Vec2 start = a, along = b - a;
  a = start + along * part->from;
  b = start + along * part->to;
  return true;
}

void Painter::line(const Vec2& a, const Vec2& b, Colour colour, float width) const {
  Vec2 from = camera_.to_screen(a), to = camera_.to_screen(b);
  if (clip(from, to)) list_.AddLine(vec(from), vec(to), colour.at(strength_).packed(), width);
}

void Painter::dashes(const Vec2& a, const Vec2& b, Colour colour, float width) const {
  Vec2 from = camera_.to_screen(a), to = camera_.to_screen(b);
  if (!clip(from, to)) return;
  constexpr double dash = 5, period = 9;
  const double all = length(to - from);
  const Vec2 along = (to - from) / std::max(all, 1e-9);
  const ImU32 packed = colour.at(strength_).packed();
  const int dashes = static_cast<int>(std::ceil(all / period));
  for (int i = 0; i < dashes; ++i) {
    const double s = i * period;
    list_.AddLine(vec(from + along * s), vec(from + along * std::min(s + dash, all)), packed,
                  width);
  }
}

void Painter::candidate(const Vec2& a, const Vec2& b, Colour colour, std::size_t count) const {
  if (count <= most_dashed)
    dashes(a, b, colour, 1.2f);
  else
    line(a, b, colour.at(0.5f), 1);
}

void Painter::region(const Points& counter_clockwise, Colour fill, Colour line_colour,
                     bool rising) const {
  // Two regions that shrank to the same place both remain visible.
  if (counter_clockwise.size() == 1) {
    list_.AddCircle(at(counter_clockwise[0]), rising ? 6.0f : 9.0f, line_colour.packed(), 24, 2);
  } else if (counter_clockwise.size() == 2) {
    if (rising)
      line(counter_clockwise[0], counter_clockwise[1], line_colour, 3);
    else
      dashes(counter_clockwise[0], counter_clockwise[1], line_colour, 3);
  } else {
    fill_convex(counter_clockwise, fill);
    hatch_convex(counter_clockwise, rising, line_colour.at(0.55f));
    outline(counter_clockwise, line_colour.at(0.7f), 1.2f);
  }
}

void Painter::arrow(const Vec2& tail, const Vec2& head, Colour colour, float width) const {
  const Vec2 along = (head - tail) / length(head - tail), aside(-along.y, along.x);
  const ImU32 packed = colour.at(strength_).packed();
  list_.AddLine(vec(tail), vec(head), packed, width);
  const ImVec2 barbs[] = {vec(head - along * 11 + aside * 8), vec(head),
                          vec(head - along * 11 - aside * 8)};
  list_.AddPolyline(barbs, 3, packed, 0, width);
}

void Painter::hatch_convex(const Points& counter_clockwise, bool rising, Colour colour) const {
  const Points area = clipped(counter_clockwise);
  if (area.size() < 3) return;
  // On a line, x + y (rising: y grows downwards) or x − y is a constant c.
  const double sign = rising ? 1 : -1;
  const auto c_of = [&](const Vec2& p) { return p.x + sign * p.y; };
  double low = c_of(area[0]), high = low;
  for (const Vec2& p : area) {
    low = std::min(low, c_of(p));
    high = std::max(high, c_of(p));
  }
  constexpr double period = 13;
  const double phase = std::fmod(c_of(camera_.to_screen(Vec2(0, 0))), period);
  const ImU32 packed = colour.at(strength_).packed();
  const double first = std::floor((low - phase) / period) * period + phase;
  const int lines = static_cast<int>(std::floor((high - first) / period)) + 1;
  for (int k = 0; k < lines; ++k) {
    const double c = first + k * period;
    Points ends;
    for (std::size_t i = 0; i < area.size() && ends.size() < 2; ++i) {
      const Vec2 &a = area[i], &b = area[i + 1 == area.size() ? 0 : i + 1];
      const double at_a = c_of(a) - c, at_b = c_of(b) - c;
      if ((at_a < 0) != (at_b < 0)) ends.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    if (ends.size() == 2) list_.AddLine(vec(ends[0]), vec(ends[1]), packed, 1.2f);
  }
}

}  // namespace evenlift::view
