#include "import/chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace evenlift {
namespace {

// The greatest number of ends of one cell to compare. If more ends meet, there is no unique
// outline.
constexpr std::size_t most_in_cell = 64;

struct End {
  std::int64_t x, y;  // the cell of a grid whose cells are `near` wide
  std::size_t part;
  bool last;  // the part's end, not its start
  auto cell() const { return std::pair(x, y); }
};

class Ends {
 public:
  Ends(const std::vector<Outline>& parts, double near) : parts_(parts), near_(near) {
    Points all;
    for (const Outline& part : parts) {
      all.push_back(part.start);
      all.push_back(part.end());
    }
    low_ = bounding_box(all).low;
    used_.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const bool last : {false, true}) {
        const auto [x, y] = cell_of(last ? parts[i].end() : parts[i].start);
        ends_.push_back({x, y, i, last});
      }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return std::tie(a.x, a.y, a.part, a.last) < std::tie(b.x, b.y, b.part, b.last);
    });
    // The first end of each cell that may still be unused.
    skip_.resize(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) skip_[i] = i;
  }

  bool used(std::size_t part) const { return used_[part] != 0; }
  void use(std::size_t part) { used_[part] = 1; }

  // The nearest end of an unused part.
  std::optional<End> nearest(const Vec2& point) {
    std::optional<End> best;
    double best_square = near_ * near_;
    const auto [x, y] = cell_of(point);
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j) look(i, j, point, best, best_square);
    return best;
  }

 private:
  std::pair<std::int64_t, std::int64_t> cell_of(const Vec2& point) const {
    const Vec2 at = (point - low_) / near_;
    return {static_cast<std::int64_t>(std::floor(at.x())),
            static_cast<std::int64_t>(std::floor(at.y()))};
  }

  void look(std::int64_t x, std::int64_t y, const Vec2& point, std::optional<End>& best,
            double& best_square) {
    const auto begin =
        std::lower_bound(ends_.begin(), ends_.end(), std::pair(x, y),
                         [](const End& end, const auto& cell) { return end.cell() < cell; });
    const auto first = static_cast<std::size_t>(begin - ends_.begin());
    if (first == ends_.size() || ends_[first].cell() != std::pair(x, y)) return;
    std::size_t at = skip_[first];
    while (at < ends_.size() && ends_[at].cell() == std::pair(x, y) && used(ends_[at].part)) ++at;
    skip_[first] = at;
    for (std::size_t seen = 0;
         seen < most_in_cell && at < ends_.size() && ends_[at].cell() == std::pair(x, y);
         ++at, ++seen) {
      const End& end = ends_[at];
      if (used(end.part)) continue;
      const Outline& part = parts_[end.part];
      const Vec2 apart = (end.last ? part.end() : part.start) - point;
      const double square = dot(apart, apart);
      const bool better =
          square < best_square || (square == best_square && (!best || end.part < best->part));
      if (better) {
        best = end;
        best_square = square;
      }
    }
  }

  const std::vector<Outline>& parts_;
  double near_;
  Vec2 low_ = Vec2::Zero();
  std::vector<End> ends_;
  std::vector<std::size_t> skip_;
  std::vector<char> used_;
};

bool are_near(const Vec2& a, const Vec2& b, double near) { return length(b - a) <= near; }

}  // namespace

std::vector<Chain> chained(const std::vector<Outline>& parts, double near) {
  std::vector<Chain> chains;
  Ends ends(parts, near);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (ends.used(i)) continue;
    ends.use(i);
    Chain chain{parts[i], 1, false};
    for (;;) {
      Outline& outline = chain.outline;
      // A part no longer than `near` is not a closed outline by itself.
      const bool back = chain.parts > 1 || outline.curved() || outline.pieces.size() > 1;
      if (back && are_near(outline.end(), outline.start, near)) {
        outline.pieces.back().end = outline.start;
        chain.closed = true;
        break;
      }
      const std::optional<End> next = ends.nearest(outline.end());
      if (!next) break;
      ends.use(next->part);
      const Outline& part = parts[next->part];
      const Outline onward = next->last ? reversed(part) : part;
      outline.pieces.insert(outline.pieces.end(), onward.pieces.begin(), onward.pieces.end());
      ++chain.parts;
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace evenlift
