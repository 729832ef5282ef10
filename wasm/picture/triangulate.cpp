#include "picture/triangulate.h"

#include <algorithm>
#include <cmath>

namespace evenlift::view {
namespace {

// A vertex in the ring of the remaining ones, and in the list sorted along the Z-order curve.
struct Node {
  Vec2 at;
  std::uint32_t vertex = 0, previous = 0, next = 0;
  std::uint32_t z = 0;
  std::int64_t z_previous = -1, z_next = -1;
};

double turn(const Node& a, const Node& b, const Node& c) { return cross(b.at - a.at, c.at - b.at); }

// Spreads the bits of x to every second bit.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 8)) & 0x00FF00FFu;
  x = (x | (x << 4)) & 0x0F0F0F0Fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

class Ears {
 public:
  explicit Ears(const Points& vertices) : nodes_(vertices.size()) {
    double area = 0;
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i < n; ++i)
      area += cross(vertices[i] - vertices[0], vertices[(i + 1) % n] - vertices[0]);
    for (std::size_t i = 0; i < n; ++i) {
      Node& node = nodes_[i];
      node.vertex = static_cast<std::uint32_t>(area >= 0 ? i : n - 1 - i);
      node.at = vertices[node.vertex];
      node.previous = static_cast<std::uint32_t>(i == 0 ? n - 1 : i - 1);
      node.next = static_cast<std::uint32_t>(i + 1 == n ? 0 : i + 1);
    }
    sort_along_z();
  }

  std::vector<std::uint32_t> cut() {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(3 * nodes_.size());
    std::size_t left = nodes_.size(), without_ear = 0;
    std::uint32_t i = 0;
    while (left > 2) {
      // Rounding may leave no ear; then any corner is cut off.
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
  std::uint32_t z_of(const Vec2& p) const {
    const auto bits = [&](double value, double low) {
      return static_cast<std::uint32_t>(std::clamp((value - low) * to_grid_, 0.0, 32767.0));
    };
    return spread(bits(p.x(), low_.x())) | (spread(bits(p.y(), low_.y())) << 1);
  }

  void sort_along_z() {
    Vec2 high = low_ = nodes_[0].at;
    for (const Node& node : nodes_) {
      low_ = {std::min(low_.x(), node.at.x()), std::min(low_.y(), node.at.y())};
      high = {std::max(high.x(), node.at.x()), std::max(high.y(), node.at.y())};
    }
    const double size = std::max(high.x() - low_.x(), high.y() - low_.y());
    to_grid_ = size > 0 ? 32767 / size : 0;
    // Position on the curve and index in one integer, which sorts fast.
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

  // Whether this is an ear: a convex corner whose triangle contains no other vertex of the ring.
  bool is_ear(std::uint32_t i) const {
    const Node &b = nodes_[i], &a = nodes_[b.previous], &c = nodes_[b.next];
    if (!(turn(a, b, c) > 0)) return false;
    const Vec2 low(std::min({a.at.x(), b.at.x(), c.at.x()}),
                   std::min({a.at.y(), b.at.y(), c.at.y()}));
    const Vec2 high(std::max({a.at.x(), b.at.x(), c.at.x()}),
                    std::max({a.at.y(), b.at.y(), c.at.y()}));
    const std::uint32_t z_low = z_of(low), z_high = z_of(high);
    const auto blocks = [&](const Node& p) {
      if (&p == &a || &p == &b || &p == &c) return false;
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 &&
             turn(nodes_[p.previous], p, nodes_[p.next]) <= 0;
    };
    // All points in the triangle's box are between its corners' places on the curve.
    for (std::int64_t k = b.z_next; k >= 0 && at(k).z <= z_high; k = at(k).z_next) {
      if (blocks(at(k))) return false;
    }
    for (std::int64_t k = b.z_previous; k >= 0 && at(k).z >= z_low; k = at(k).z_previous) {
      if (blocks(at(k))) return false;
    }
    return true;
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
  Vec2 low_ = Vec2::Zero();
  double to_grid_ = 0;
};

}  // namespace

std::vector<std::uint32_t> triangulate(const Points& vertices) {
  if (vertices.size() < 3) return {};
  return Ears(vertices).cut();
}

}  // namespace evenlift::view
