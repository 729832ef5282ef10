#include "import/joining/joining.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/plane.h"

namespace evenlift {
namespace {

// Counter-clockwise from the least vertex, so that repeated outlines are equal.
Points in_order(Points points) {
  if (signed_area(points) < 0) std::reverse(points.begin(), points.end());
  std::rotate(points.begin(), std::min_element(points.begin(), points.end(), is_before),
              points.end());
  return points;
}

// An outline's role for those inside it. A shape sorts after an equal hole, so it is nearer.
enum class Role : std::uint8_t { hole, shape, line };

struct OutlineInOrder {
  std::size_t number = 0;
  Role role = Role::line;
  Points key;
  Box box;
  double area = 0;
};

bool before(const OutlineInOrder& a, const OutlineInOrder& b) {
  if (a.area != b.area) return a.area > b.area;
  if (a.key != b.key)
    return std::lexicographical_compare(a.key.begin(), a.key.end(), b.key.begin(), b.key.end(),
                                        is_before);
  return a.role < b.role;
}

OutlineInOrder in_order(std::size_t number, Role role, const Points& points) {
  OutlineInOrder outline{number, role, in_order(points), {}, 0};
  outline.box = bounding_box(outline.key);
  outline.area = signed_area(outline.key);
  return outline;
}

bool is_on_boundary(const OutlineInOrder& outline, const Vec2& p) {
  const double touching = 1e-9 * outline.box.diagonal();
  for (std::size_t j = 0; j < outline.key.size(); ++j) {
    const Vec2& next = outline.key[j + 1 == outline.key.size() ? 0 : j + 1];
    if (length(p - nearest_on_segment(outline.key[j], next, p)) <= touching) return true;
  }
  return false;
}

// Whether the inner outline lies in the outer one, which it may touch only if `touching` is
// `perhaps`.
enum class Touching : std::uint8_t { no, perhaps };
bool contains(const OutlineInOrder& outer, const OutlineInOrder& inner, Touching touching) {
  if (inner.box.low.x < outer.box.low.x || inner.box.low.y < outer.box.low.y ||
      inner.box.high.x > outer.box.high.x || inner.box.high.y > outer.box.high.y)
    return false;
  constexpr std::size_t most_looked_at = 256;
  const std::size_t step = inner.key.size() / most_looked_at + 1;
  bool some_inside = false;
  for (std::size_t i = 0; i < inner.key.size(); i += step) {
    const bool in = inside(outer.key, inner.key[i]);
    if (!in && touching == Touching::no) return false;
    const bool on = is_on_boundary(outer, inner.key[i]);
    if (on ? touching == Touching::no : !in) return false;
    some_inside = some_inside || !on;
  }
  // If all are on the boundary, the middle of an edge decides.
  for (std::size_t i = step; i < inner.key.size() && !some_inside; i += step) {
    const Vec2 middle = (inner.key[i - 1] + inner.key[i]) / 2;
    if (is_on_boundary(outer, middle)) continue;
    if (!inside(outer.key, middle)) return false;
    some_inside = true;
  }
  return some_inside;
}

// The smallest outline around each: the last of those before it that contain it.
constexpr std::size_t none = static_cast<std::size_t>(-1);
std::vector<std::size_t> outlines_around(const std::vector<OutlineInOrder>& sorted,
                                         Touching touching) {
  std::vector<std::size_t> around(sorted.size(), none);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = i; j-- > 0 && around[i] == none;)
      if (contains(sorted[j], sorted[i], touching)) around[i] = j;
  return around;
}

bool is_filled(int winding, Fill fill) {
  return fill == Fill::even_odd ? winding % 2 != 0 : winding != 0;
}

std::vector<OutlineInOrder> all_in_order(const std::vector<ClosedOutline>& outlines) {
  std::vector<OutlineInOrder> all;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    all.push_back(in_order(i, outlines[i].filled ? Role::shape : Role::line, *outlines[i].points));
    if (!outlines[i].holes) continue;
    for (const Points& hole : *outlines[i].holes) all.push_back(in_order(i, Role::hole, hole));
  }
  std::stable_sort(all.begin(), all.end(), before);
  return all;
}

// A shape of the same form as a hole is not a repetition, nor is one with different holes.
bool repeats(const OutlineInOrder& first, const OutlineInOrder& second,
             const std::vector<ClosedOutline>& outlines) {
  if (first.key != second.key || second.role == Role::hole) return false;
  if (second.role == Role::line) return true;
  const auto holes_of = [&](const OutlineInOrder& outline) {
    const std::vector<Points>* holes = outlines[outline.number].holes;
    return holes ? *holes : std::vector<Points>();
  };
  return first.role == Role::shape && holes_of(first) == holes_of(second);
}

bool is_rectangle(const OutlineInOrder& outline) {
  const Box& box = outline.box;
  const double exact = 1e-6 * box.diagonal();
  const auto is_corner = [&](const Vec2& p) {
    return std::min(std::abs(p.x - box.low.x), std::abs(p.x - box.high.x)) <= exact &&
           std::min(std::abs(p.y - box.low.y), std::abs(p.y - box.high.y)) <= exact;
  };
  return outline.key.size() == 4 && outline.area > 0 &&
         std::all_of(outline.key.begin(), outline.key.end(), is_corner);
}

// The sheets among outlines that are sorted by area, outermost first.
class Sheets {
 public:
  Sheets(const std::vector<OutlineInOrder>& sorted, const std::vector<std::size_t>& around,
         const std::vector<ClosedOutline>& outlines)
      : sorted_(sorted), around_(around) {
    const auto is_sheet = [&](const ClosedOutline& outline) {
      return outline.looks_like_sheet || has_parts(end_) || (outline.fills_page && has_solid());
    };
    while (end_ + 1 < sorted.size() && encloses_the_rest() &&
           is_sheet(outlines[sorted[end_].number]))
      ++end_;
  }

  bool contain(std::size_t i) const { return i < end_; }
  std::size_t size() const { return end_; }

 private:
  // Boxes suffice for a rectangle. An outline may touch the sheet.
  bool encloses_the_rest() const {
    const OutlineInOrder& sheet = sorted_[end_];
    return sheet.role != Role::hole && is_rectangle(sheet) &&
           std::all_of(sorted_.begin() + static_cast<std::ptrdiff_t>(end_) + 1, sorted_.end(),
                       [&](const OutlineInOrder& each) {
                         return each.area < sheet.area && each.box.low.x >= sheet.box.low.x &&
                                each.box.low.y >= sheet.box.low.y &&
                                each.box.high.x <= sheet.box.high.x &&
                                each.box.high.y <= sheet.box.high.y;
                       });
  }

  // Whether what lies on it is more than holes: a filled shape, or a line with a line inside.
  bool has_solid() const {
    for (std::size_t i = end_ + 1; i < sorted_.size(); ++i)
      if (sorted_[i].role == Role::shape ||
          (sorted_[i].role == Role::line && around_[i] != none && around_[i] != end_))
        return true;
    return false;
  }

  // Whether several lines lie directly on it, one of them with a line of its own inside; or whether
  // it is a border close around such a sheet.
  bool has_parts(std::size_t sheet) const {
    if (sorted_[sheet].role != Role::line) return false;
    std::size_t parts = 0;
    bool is_drilled = false;
    for (std::size_t i = sheet + 1; i < sorted_.size(); ++i) {
      if (sorted_[i].role != Role::line || around_[i] == none) continue;
      parts += around_[i] == sheet;
      is_drilled = is_drilled || (around_[i] != sheet && around_[around_[i]] == sheet);
    }
    if (parts != 1) return parts > 1 && is_drilled;
    const std::size_t inner = sheet + 1;
    return is_rectangle(sorted_[inner]) && sorted_[inner].area > 0.6 * sorted_[sheet].area &&
           has_parts(inner);
  }

  const std::vector<OutlineInOrder>& sorted_;
  const std::vector<std::size_t>& around_;
  std::size_t end_ = 0;
};

}  // namespace

std::vector<OutlineWithHoles> filled_shapes(const std::vector<const Points*>& rings, Fill fill) {
  std::vector<OutlineInOrder> sorted;
  for (std::size_t i = 0; i < rings.size(); ++i)
    sorted.push_back(in_order(i, Role::shape, *rings[i]));
  std::stable_sort(sorted.begin(), sorted.end(), before);
  const std::vector<std::size_t> around = outlines_around(sorted, Touching::perhaps);
  std::vector<OutlineWithHoles> shapes;
  std::vector<int> winding(sorted.size());              // just inside each ring
  std::vector<std::size_t> shape(sorted.size(), none);  // the shape filled there
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::size_t number = sorted[i].number, outer = around[i];
    const int outside = outer == none ? 0 : winding[outer];
    winding[i] = outside + (signed_area(*rings[number]) < 0 ? -1 : 1);
    if (is_filled(outside, fill) && !is_filled(winding[i], fill)) {
      shapes[shape[outer]].holes.push_back(number);
      continue;
    }
    shape[i] = is_filled(outside, fill) ? shape[outer] : shapes.size();
    shapes.push_back({number, {}});
  }
  return shapes;
}

Nesting nest(const std::vector<ClosedOutline>& outlines) {
  Nesting nesting;
  std::vector<OutlineInOrder> kept;
  for (OutlineInOrder& outline : all_in_order(outlines)) {
    if (!kept.empty() && repeats(kept.back(), outline, outlines))
      ++nesting.repeated;
    else
      kept.push_back(std::move(outline));
  }
  const std::vector<std::size_t> around = outlines_around(kept, Touching::no);
  std::vector<std::size_t> shape(kept.size(), none);  // that the outline bounds
  const Sheets sheets(kept, around, outlines);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i].role == Role::hole || sheets.contain(i)) continue;
    const bool in_shape = around[i] != none && shape[around[i]] != none;
    if (kept[i].role == Role::line && in_shape) {
      nesting.shapes[shape[around[i]]].holes.push_back(kept[i].number);
      ++nesting.holes;
      continue;
    }
    shape[i] = nesting.shapes.size();
    nesting.shapes.push_back({kept[i].number, {}});
  }
  // Sheets follow, the innermost first.
  for (std::size_t i = 0; i < sheets.size(); ++i)
    shape[i] = nesting.shapes.size() + sheets.size() - 1 - i;
  const auto shape_around = [&](std::size_t i) -> std::optional<std::size_t> {
    while (around[i] != none && shape[around[i]] == none) i = around[i];  // by holes
    return around[i] == none ? std::nullopt : std::optional(shape[around[i]]);
  };
  for (std::size_t i = sheets.size(); i < kept.size(); ++i)
    if (shape[i] != none) nesting.shapes[shape[i]].within = shape_around(i);
  for (std::size_t i = sheets.size(); i-- > 0;) {
    OutlineWithHoles sheet{kept[i].number, {}, shape_around(i)};
    // Whoever chooses it all the same has a plate, except for a page that is painted.
    const bool is_page = outlines[sheet.outline].looks_like_sheet && kept[i].role != Role::line;
    for (std::size_t j = i + 1; j < kept.size(); ++j)
      if (!is_page && around[j] == i && kept[j].role == Role::line)
        sheet.holes.push_back(kept[j].number);
    nesting.shapes.push_back(std::move(sheet));
  }
  nesting.sheets = sheets.size();
  return nesting;
}

}  // namespace evenlift
