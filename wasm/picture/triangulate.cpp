#include "picture/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace evenlift::view {
namespace {

// A member of the ring of remaining vertices and of the list along the Z-order curve.
struct Node {
  Vec2 at;
  std::uint32_t vertex = 0, previous = 0, next = 0;
  std::uint32_t z = 0;
  std::int64_t z_previous = -1, z_next = -1;
};

double turn(const Node& a, const Node& b, const Node& c) { return cross(b.at - a.at, c.at - b.at); }

// Strictly, counter-clockwise from `from` to `to`, less than half a turn apart.
bool is_between(const Vec2& way, const Vec2& from, const Vec2& to) {
  return cross(from, way) > 0 && cross(way, to) > 0;
}

double doubled_area(const Points& vertices) {
  double area = 0;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i)
    area += cross(vertices[i] - vertices[0], vertices[(i + 1) % n] - vertices[0]);
  return area;
}

// Moves bit i to bit 2i.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 8)) & 0x00FF00FFu;
  x = (x | (x << 4)) & 0x0F0F0F0Fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

class Ears {
 public:
  Ears(const Points& vertices, const std::vector<Points>& holes) {
    add_ring(vertices, true);
    std::vector<std::uint32_t> leftmost;
    for (const Points& hole : holes)
      if (!hole.empty()) leftmost.push_back(leftmost_of(add_ring(hole, false)));
    // From left to right, so that each hole's left neighbours are joined first.
    std::stable_sort(leftmost.begin(), leftmost.end(), [&](std::uint32_t a, std::uint32_t b) {
      return nodes_[a].at.x < nodes_[b].at.x;
    });
    for (const std::uint32_t node : leftmost) join(seen_from(node), node);
    sort_along_z();
  }

  std::vector<std::uint32_t> cut() {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(3 * nodes_.size());
    std::size_t left = nodes_.size(), without_ear = 0;
    std::uint32_t i = 0;
    while (left > 2) {
      // Rounding may leave no ear: then any corner is cut off.
      const bool forced = without_ear > left;
      if (forced || is_ear(i)) {
        const Node ear = nodes_[i];
        for (std::uint32_t corner : {ear.previous, i, ear.next})
          triangles.push_back(nodes_[corner].vertex);
        remove(i);
        --left;
        without_ear = 0;
        i = nodes_[ear.next]
                .next;  // not the direct neighbour: slivers would fan out from one vertex
      } else {
        ++without_ear;
        i = nodes_[i].next;
      }
    }
    return triangles;
  }

 private:
  // Returns the first new node.
  std::uint32_t add_ring(const Points& vertices, bool counter_clockwise) {
    const auto first = static_cast<std::uint32_t>(nodes_.size()),
               n = static_cast<std::uint32_t>(vertices.size());
    const bool as_given = (doubled_area(vertices) >= 0) == counter_clockwise;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t vertex = as_given ? i : n - 1 - i;
      nodes_.push_back({vertices[vertex], vertices_ + vertex, first + (i == 0 ? n - 1 : i - 1),
                        first + (i + 1 == n ? 0 : i + 1)});
    }
    vertices_ += n;
    return first;
  }

  std::uint32_t leftmost_of(std::uint32_t ring) const {
    std::uint32_t found = ring;
    for (std::uint32_t i = nodes_[ring].next; i != ring; i = nodes_[i].next)
      if (nodes_[i].at.x < nodes_[found].at.x) found = i;
    return found;
  }

  // Whether the segment from this node of the outer ring begins inside.
  bool begins_inside(std::uint32_t i, const Vec2& to) const {
    const Node &node = nodes_[i], &before = nodes_[node.previous], &after = nodes_[node.next];
    const Vec2 way = to - node.at, in = before.at - node.at, out = after.at - node.at;
    if (turn(before, node, after) > 0) return is_between(way, out, in);
    return !(cross(in, way) >= 0 && cross(way, out) >= 0);
  }

  // A node of the outer ring that a hole's leftmost vertex sees (Eberly, Triangulation by Ear
  // Clipping): the left end of the edge that its ray to the left meets or, if vertices in the
  // triangle between ray and end hide it, the one in the flattest direction.
  std::uint32_t seen_from(std::uint32_t hole) const {
    const Vec2& from = nodes_[hole].at;
    std::optional<std::uint32_t> met;
    Vec2 meets = from;
    std::uint32_t i = 0;
    do {
      const Vec2 &a = nodes_[i].at, &b = nodes_[nodes_[i].next].at;
      if (a.y >= from.y && from.y >= b.y && a.y > b.y) {
        const double x = a.x + (b.x - a.x) * ((from.y - a.y) / (b.y - a.y));
        if (x <= from.x && (!met || x > meets.x)) {
          met = a.x < b.x ? i : nodes_[i].next;
          meets.x = x;
        }
      }
      i = nodes_[i].next;
    } while (i != 0);
    return met ? nearest_to_ray(from, meets, *met) : 0;
  }

  std::uint32_t nearest_to_ray(const Vec2& from, const Vec2& meets, std::uint32_t end) const {
    const Vec2 corner = nodes_[end].at;
    const double side = corner.y < from.y ? 1 : -1;  // the sign of the triangle's area
    std::uint32_t found = end;
    double flattest = std::numeric_limits<double>::infinity(), farthest_right = 0;
    std::uint32_t i = 0;
    do {
      const Vec2& p = nodes_[i].at;
      const bool within = p.x < from.x && side * cross(meets - from, p - from) >= 0 &&
                          side * cross(corner - meets, p - meets) >= 0 &&
                          side * cross(from - corner, p - corner) >= 0;
      if (within && begins_inside(i, from)) {
        const double slope = std::abs(p.y - from.y) / (from.x - p.x);
        if (slope < flattest || (slope == flattest && p.x > farthest_right)) {
          found = i;
          flattest = slope;
          farthest_right = p.x;
        }
      }
      i = nodes_[i].next;
    } while (i != 0);
    return found;
  }

  // The outer ring then leads from `a` to the hole's node `b`, around the hole and back. Both occur
  // twice.
  void join(std::uint32_t a, std::uint32_t b) {
    const auto back_at_b = static_cast<std::uint32_t>(nodes_.size()), back_at_a = back_at_b + 1;
    nodes_.push_back(nodes_[b]);
    nodes_.push_back(nodes_[a]);
    link(nodes_[b].previous, back_at_b);
    link(back_at_b, back_at_a);
    link(back_at_a, nodes_[a].next);
    link(a, b);
  }

  void link(std::uint32_t before, std::uint32_t after) {
    nodes_[before].next = after;
    nodes_[after].previous = before;
  }

  std::uint32_t z_of(const Vec2& p) const {
    const auto bits = [&](double value, double low) {
      return static_cast<std::uint32_t>(std::clamp((value - low) * to_grid_, 0.0, 32767.0));
    };
    return spread(bits(p.x, low_.x)) | (spread(bits(p.y, low_.y)) << 1);
  }

  void sort_along_z() {
    Vec2 high = low_ = nodes_[0].at;
    for (const Node& node : nodes_) {
      low_ = {std::min(low_.x, node.at.x), std::min(low_.y, node.at.y)};
      high = {std::max(high.x, node.at.x), std::max(high.y, node.at.y)};
    }
    const double size = std::max(high.x - low_.x, high.y - low_.y);
    to_grid_ = size > 0 ? 32767 / size : 0;
    // Position on the curve and index in one integer: fast to sort.
    std::vector<unsigned long long> order(nodes_.size());
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      nodes_[i].z = z_of(nodes_[i].at);
      order[i] = (static_cast<unsigned long long>(nodes_[i].z) << 32) | i;
    }
    std::sort(order.begin(), order.end());
    for (std::size_t k = 1; k < order.size(); ++k) {
      const auto before = static_cast<std::uint32_t>(order[k - 1]);
      const auto after = static_cast<std::uint32_t>(order[k]);
      nodes_[after].z_previous = before;
      nodes_[before].z_next = after;
    }
  }

  // A convex corner whose triangle contains no other vertex of the ring.
  bool is_ear(std::uint32_t i) const {
    const Node &b = nodes_[i], &a = nodes_[b.previous], &c = nodes_[b.next];
    if (!(turn(a, b, c) > 0)) return false;
    const Vec2 low(std::min({a.at.x, b.at.x, c.at.x}), std::min({a.at.y, b.at.y, c.at.y}));
    const Vec2 high(std::max({a.at.x, b.at.x, c.at.x}), std::max({a.at.y, b.at.y, c.at.y}));
    const std::uint32_t z_low = z_of(low), z_high = z_of(high);
    const auto blocks = [&](const Node& p) {
      if (&p == &a || &p == &b || &p == &c) return false;
      // Where a hole is joined, other nodes share a corner's place.
      if (p.at == a.at) return leads_between(p, b.at - a.at, c.at - a.at);
      if (p.at == b.at) return leads_between(p, c.at - b.at, a.at - b.at);
      if (p.at == c.at) return leads_between(p, a.at - c.at, b.at - c.at);
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 &&
             turn(nodes_[p.previous], p, nodes_[p.next]) <= 0;
    };
    // On the curve, the triangle's box lies between `z_low` and `z_high`.
    for (std::int64_t k = b.z_next; k >= 0 && at(k).z <= z_high; k = at(k).z_next) {
      if (blocks(at(k))) return false;
    }
    for (std::int64_t k = b.z_previous; k >= 0 && at(k).z >= z_low; k = at(k).z_previous) {
      if (blocks(at(k))) return false;
    }
    return true;
  }

  // Whether an edge leaves the node between two directions.
  bool leads_between(const Node& p, const Vec2& from, const Vec2& to) const {
    return is_between(nodes_[p.previous].at - p.at, from, to) ||
           is_between(nodes_[p.next].at - p.at, from, to);
  }

  const Node& at(std::int64_t k) const { return nodes_[static_cast<std::size_t>(k)]; }
  Node& at(std::int64_t k) { return nodes_[static_cast<std::size_t>(k)]; }

  void remove(std::uint32_t i) {
    const Node& node = nodes_[i];
    nodes_[node.previous].next = node.next;
    nodes_[node.next].previous = node.previous;
    if (node.z_previous >= 0) at(node.z_previous).z_next = node.z_next;
    if (node.z_next >= 0) at(node.z_next).z_previous = node.z_previous;
  }

  std::vector<Node> nodes_;
  std::uint32_t vertices_ = 0;
  Vec2 low_;
  double to_grid_ = 0;
};

}  // namespace

std::vector<std::uint32_t> triangulate(const Points& vertices, const std::vector<Points>& holes) {
  if (vertices.size() < 3) return {};
  return Ears(vertices, holes).cut();
}

Points joined(const Points& vertices, const std::vector<Points>& holes) {
  Points all = vertices;
  for (const Points& hole : holes) all.insert(all.end(), hole.begin(), hole.end());
  return all;
}

namespace {

constexpr std::size_t most_spans = 400000;

// A bit for each pixel: whether the outline crosses the row an odd number of times between the
// preceding pixel and this one.
class Crossings {
 public:
  Crossings(const Rect& window, double pixel)
      : window_(window),
        pixel_(pixel),
        columns_(std::max<std::int64_t>(1, static_cast<std::int64_t>(window.width() / pixel) + 1)),
        rows_(std::max<std::int64_t>(1, static_cast<std::int64_t>(window.height() / pixel) + 1)),
        words_((columns_ + 63) / 64),
        bits_(static_cast<std::size_t>(rows_ * words_)) {}

  void add_ring(const Points& ring, const Camera& camera) {
    Vec2 before = camera.to_screen(ring.back());
    for (const Vec2& p : ring) {
      const Vec2 here = camera.to_screen(p);
      // Downwards, so that rounding does not depend on the direction.
      if (before.y < here.y)
        add_edge(before, here);
      else
        add_edge(here, before);
      before = here;
    }
  }

  std::vector<RowSpan> spans(std::size_t most) const {
    std::vector<RowSpan> found;
    for (std::int64_t row = 0; row < rows_ && found.size() <= most; ++row) {
      std::optional<std::int64_t> begin;
      for (std::int64_t word = 0; word < words_; ++word) {
        std::uint64_t left = bits_[static_cast<std::size_t>(row * words_ + word)];
        for (; left != 0; left &= left - 1) {
          const std::int64_t column = word * 64 + lowest(left);
          if (begin) found.push_back(span(row, *begin, column));
          begin = begin ? std::nullopt : std::optional(column);
        }
      }
      if (begin) found.push_back(span(row, *begin, columns_));
    }
    return found;
  }

 private:
  void add_edge(const Vec2& a, const Vec2& b) {
    const std::int64_t first = middle_after(a.y - window_.top, rows_),
                       last = middle_after(b.y - window_.top, rows_);
    if (first == last) return;
    const double slope = (b.x - a.x) / (b.y - a.y);
    for (std::int64_t row = first; row < last; ++row) {
      const double y = window_.top + (static_cast<double>(row) + 0.5) * pixel_;
      const std::int64_t column = middle_after(a.x + (y - a.y) * slope - window_.left, columns_);
      if (column < columns_)
        bits_[static_cast<std::size_t>(row * words_ + column / 64)] ^= std::uint64_t{1}
                                                                       << (column % 64);
    }
  }

  static std::int64_t lowest(std::uint64_t bits) {
    std::int64_t at = 0;
    for (; (bits & 1) == 0; bits >>= 1) ++at;
    return at;
  }

  // The first of `count` pixels whose middle is not left of `offset`.
  std::int64_t middle_after(double offset, std::int64_t count) const {
    return static_cast<std::int64_t>(
        std::clamp(std::ceil(offset / pixel_ - 0.5), 0.0, static_cast<double>(count)));
  }

  RowSpan span(std::int64_t row, std::int64_t begin, std::int64_t end) const {
    return {static_cast<float>(window_.left + static_cast<double>(begin) * pixel_),
            static_cast<float>(window_.left + static_cast<double>(end) * pixel_),
            static_cast<float>(window_.top + static_cast<double>(row) * pixel_)};
  }

  Rect window_;
  double pixel_;
  std::int64_t columns_, rows_, words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace

RowFill fill_rows(const Points& polygon, const std::vector<Points>& holes, const Camera& camera,
                  const Rect& window, double pixel) {
  for (double size = pixel;; size *= 2) {
    Crossings crossings(window, size);
    crossings.add_ring(polygon, camera);
    for (const Points& hole : holes) crossings.add_ring(hole, camera);
    RowFill fill{crossings.spans(most_spans), static_cast<float>(size)};
    if (fill.spans.size() <= most_spans) return fill;
  }
}

}  // namespace evenlift::view
