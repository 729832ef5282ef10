#include "picture/fill_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace evenlift::view {
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
