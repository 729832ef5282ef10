// Joins pieces of drawings into outlines, and finds which outlines are holes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "curves/outline.h"
#include "evenlift/vec.h"

namespace evenlift {

// --- Finds the points near a place or a segment by means of a square grid.

class PointGrid {
 public:
  // The points must outlive the grid. `cell` is the side of a cell and must be above 0. O(n log n).
  PointGrid(const Points& points, double cell) : points_(points), cell_(cell) {
    low_ = bounding_box(points).low;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [x, y] = cell_of(points[i]);
      entries_.push_back({x, y, i});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.x, a.y, a.point) < std::tie(b.x, b.y, b.point);
    });
  }

  // Visits the points i within `near` of `at`, including a point at `at` itself. It looks at no
  // more than most_visited points in each column of cells, so it may miss some points where very
  // many are near. O(log n + visits) if `near` is about `cell`.
  template <class Visit>
  void for_each_near(const Vec2& at, double near, Visit visit) const {
    const auto [x0, y0] = cell_of(at - Vec2(near, near));
    const auto [x1, y1] = cell_of(at + Vec2(near, near));
    for (std::int64_t x = x0; x <= x1; ++x)
      for_each_in_column(x, y0, y1, most_visited, [&](std::size_t i) {
        if (length(points_[i] - at) <= near) visit(i);
      });
  }

  // Visits the points i within `near` of the segment from a to b, and perhaps others close to the
  // segment. O(c log n + visits) for c columns of cells.
  template <class Visit>
  void for_each_along(const Vec2& a, const Vec2& b, double near, Visit visit) const {
    const Vec2 &left = a.x <= b.x ? a : b, &right = a.x <= b.x ? b : a;
    const std::int64_t x0 = cell_of(left - Vec2(near, near)).first,
                       x1 = cell_of(right + Vec2(near, near)).first;
    const double width = right.x - left.x;
    for (std::int64_t x = x0; x <= x1; ++x) {
      // The column's range of x, widened by `near`, and the segment's y at a given x.
      const double from = low_.x + static_cast<double>(x) * cell_ - near,
                   to = from + cell_ + 2 * near;
      const auto height = [&](double at) {
        const double part = width > 0 ? std::clamp((at - left.x) / width, 0.0, 1.0) : 0;
        return left.y + part * (right.y - left.y);
      };
      double low = height(from), high = width > 0 ? height(to) : right.y;
      if (low > high) std::swap(low, high);
      const std::int64_t y0 = cell_of({from, low - near}).second,
                         y1 = cell_of({from, high + near}).second;
      for_each_in_column(x, y0, y1, points_.size(), visit);
    }
  }

 private:
  static constexpr std::size_t most_visited = 256;  // points in a column of cells
  struct Entry {
    std::int64_t x, y;
    std::size_t point;
  };

  std::pair<std::int64_t, std::int64_t> cell_of(const Vec2& point) const {
    constexpr double most = 1e15;
    const auto whole = [&](double value) {
      return static_cast<std::int64_t>(std::clamp(std::floor(value / cell_), -most, most));
    };
    return {whole(point.x - low_.x), whole(point.y - low_.y)};
  }

  template <class Visit>
  void for_each_in_column(std::int64_t x, std::int64_t y0, std::int64_t y1, std::size_t most,
                          Visit visit) const {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(x, y0),
                                  [](const Entry& e, const auto& cell) {
                                    return std::tie(e.x, e.y) < std::tie(cell.first, cell.second);
                                  });
    for (std::size_t seen = 0;
         entry != entries_.end() && entry->x == x && entry->y <= y1 && seen < most; ++entry, ++seen)
      visit(entry->point);
  }

  const Points& points_;
  double cell_;
  Vec2 low_;
  std::vector<Entry> entries_;
};

// --- An order of points that depends only on their coordinates.

// Whether a comes before b in order of x, then of y.
inline bool is_before(const Vec2& a, const Vec2& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// --- The faces of a planar graph of lines and curves.

struct GraphEdge {
  std::size_t from, to;  // indices of nodes
  CurvePiece curve;      // its end is the node `to`
  std::size_t line;      // edges of one straight line have the same number
  std::size_t piece;     // its piece, or a piece that it joins: an index in the list of join()
};

// Drops each edge that repeats another between the same nodes. A straight line repeats any other
// straight line there, and a curve repeats a curve of its kind if their control points are within
// `near` of each other. Of repeated lines, the one with the least `line` stays. The order of the
// edges does not matter. O(edges log edges) if few curves join the same two nodes.
void drop_repeated(std::vector<GraphEdge>& edges, double near);

struct HalfEdge {
  std::size_t edge;
  bool back;  // runs from `to` to `from`
};

// A bounded face as a simple counter-clockwise cycle, from the corner that is first by x, then y.
struct Face {
  std::vector<HalfEdge> boundary;
};

// The bounded faces, in the order of the first nodes of their boundaries. `nodes` must be in order
// of x, then y. Edges that lead nowhere, and edges that are the only link between two parts of the
// graph, bound no face. O(edges log edges).
std::vector<Face> faces_of(const std::vector<GraphEdge>& edges, const Points& nodes);

// The face's outline. Parts of one straight line become one edge. O(edges of the face).
Outline outline_of(const Face& face, const std::vector<GraphEdge>& edges, const Points& nodes);

// --- Finds holes among outlines.

// How a drawing fills an outline: not at all, or by a rule of SVG.
enum class Fill : std::uint8_t { none, nonzero, even_odd };

// A shape and its holes, by the indices of their outlines.
struct OutlineWithHoles {
  std::size_t outline;
  std::vector<std::size_t> holes;
  // Of nest(): the smallest shape or sheet around it, by its index among the shapes.
  std::optional<std::size_t> within = std::nullopt;
};

// The shapes that a path of several rings fills, the largest first. A ring is a hole if the area
// just outside the ring is filled but the area just inside it is not. If both are filled, the ring
// is a shape of its own. Rings may touch. Rings that cross are separate shapes. O(k^2 + n) for k
// rings of n vertices in all. In addition, for each ring whose box lies in the box of another ring
// with m vertices, up to 256 vertices of the inner ring take O(m) each.
std::vector<OutlineWithHoles> filled_shapes(const std::vector<const Points*>& rings, Fill fill);

// An outline to nest. A filled outline may have holes that come from its fill.
struct ClosedOutline {
  const Points* points = nullptr;
  const std::vector<Points>* holes = nullptr;  // null if there are no holes
  bool filled = false;
  bool looks_like_sheet = false;  // by its name or its paint
  bool fills_page = false;        // as large as the page
};

struct Nesting {
  std::vector<OutlineWithHoles>
      shapes;                // the largest first; equal areas by coordinates; sheets last
  std::size_t sheets = 0;    // the number of sheets. Their holes are also shapes
  std::size_t holes = 0;     // the number of holes, except those of filled outlines
  std::size_t repeated = 0;  // the number of exact repetitions that were dropped
};

// Decides which outlines are holes. A filled outline is always a shape. An outline without a fill
// is a hole if it is directly inside a shape. Otherwise it is a shape, even inside a hole. Outlines
// that cross or touch are separate shapes. A rectangle that encloses all other outlines is a sheet if
// it looks like one, or if it holds several outlines, one of them with a hole of its own; what lies on it is
// nested as if it were not there. The order of the outlines does not matter. The complexity is that of
// filled_shapes().
Nesting nest(const std::vector<ClosedOutline>& outlines);

// --- Unites holes that touch or cross.

struct Uniting {
  std::vector<Points> rings;
  std::size_t united = 0;  // the number of rings that became part of a union, or fell out with it
};

// Replaces rings that touch or cross one another by the outline of their union, counter-clockwise. What a
// union encloses belongs to it, since it falls out. Where the outline would pass a point twice, it is moved
// there by a millionth of its size, so that it is simple. Decisions are exact; crossings are rounded. Rings
// whose union is not simple all the same stay as they are, and so do all rings if they have more than 200,000
// meetings or the work exceeds 20 million: O(m) for each two of k rings whose boxes overlap, with m vertices, and
// a comparison for each pair of their edges in both boxes. O(k^2) otherwise.
Uniting unite_touching(const std::vector<Points>& rings);

// --- Joins separate lines, arcs and curves into closed outlines: the bounded faces of the planar graph
// that the pieces form. The order of the pieces does not matter.

// A line, an arc, or an open polyline or path.
struct DrawnPiece {
  Outline outline;
  std::string layer;
  bool filled = false;    // matters if a straight edge closes the piece
  std::size_t copy = 0;   // the copy of a block that it belongs to; 0 for none
  std::string name = {};  // of the object that it is a part of
};

struct JoinedOutline {
  Outline outline;     // counter-clockwise, from the corner that is first by x, then y
  std::size_t parts;   // the number of its pieces
  std::string name;    // of all its pieces; else the first, by name, of their layers
  bool across_layers;  // its pieces are on several layers
  std::size_t copy;    // of all its pieces; 0 if they have not all the same
};

struct Joining {
  std::vector<JoinedOutline> outlines;
  std::vector<std::size_t> open;   // the pieces in no outline, in order
  std::vector<std::size_t> alone;  // those of `open` whose ends meet no other piece's ends
  // The greatest area of a box around open pieces that meet end to end. A straight line alone, such
  // as a centre line, does not count.
  double greatest_open = 0;
  std::size_t repeated = 0;  // number of dropped parts that lie on another piece
  double gap = 0;            // the greatest distance of two ends that were joined
  bool gap_is_seen = false;  // the gap exceeds 1.5 safe_reach times the larger side
  // The two nearest of the ends that stayed open, if there are 2 to 1000 of them.
  std::optional<std::pair<Vec2, Vec2>> apart;
};

// Open ends are joined within these shares of the drawing's larger side. Shares coarser than
// safe_reach are used only where ends are still open.
inline constexpr double safe_reach = 1e-5;  // beyond it, an open end joins only another open end
inline constexpr double join_reaches[] = {1e-6, 1e-5, 1e-4, 1e-3};

// Joins pieces of the same layer, then all pieces that are still open.
//
// Ends at the same place become one point. An open end also joins the ends near it: first within
// the finest of join_reaches, then within the coarser ones. If the distance `reach` is given, only
// those below `reach` are used, and then `reach` itself. A straight line joins open ends that are
// farther apart than the coarsest of join_reaches, if `reach` allows. An end in the interior of a
// straight line divides this line. Parts that lie on another piece are dropped. So are parts that
// lead nowhere: those with an open end, and lines between two outlines. Each remaining bounded face
// is an outline. The boundary around several faces that share lines is not an outline. O(n log n)
// for n ends, but O(n sqrt(n) log n) if most lines are as long as the drawing.
Joining join(const std::vector<DrawnPiece>& pieces, std::optional<double> reach = std::nullopt);

}  // namespace evenlift
