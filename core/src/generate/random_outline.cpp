// Family::random: a tree grows at random over a coarse grid of cells, and its outline visits each
// of the 2 x 2 points of every cell once. Then each point moves within its box, and vertices are
// cut off at random until n are left. A ray crosses about sqrt(n) edges. No step tests edges
// against edges, because the outline stays simple:
// - Columns and rows have disjoint bands; a point's box is where its two bands meet. An edge
//   between neighbours stays in one band, between the two boxes. So edges can meet only in a box,
//   which contains one vertex.
// - Cutting off a vertex is safe if no other vertex lies in the closed triangle that disappears.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "generate/families.h"

namespace evenlift::families {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

// A tree over the cells of a square: the neighbours to which each cell is joined.
struct CellTree {
  std::size_t side = 0;
  std::size_t first = 0;
  struct Joints {
    bool used = false, east = false, north = false, west = false, south = false;
  };
  std::vector<Joints> cells;
};

void join(CellTree& tree, std::size_t cell, std::size_t neighbour) {
  CellTree::Joints& a = tree.cells[cell];
  CellTree::Joints& b = tree.cells[neighbour];
  if (neighbour == cell + 1)
    a.east = b.west = true;
  else if (neighbour == cell + tree.side)
    a.north = b.south = true;
  else if (cell == neighbour + 1)
    a.west = b.east = true;
  else
    a.south = b.north = true;
  b.used = true;
}

// Grows `size` cells from the middle of a square, of which they fill about two thirds. Growth from
// the newest cell makes corridors, growth from any cell makes branches, and a random mixture makes
// both. O(size).
CellTree grow_tree(std::size_t size, Rng& rng) {
  CellTree tree;
  tree.side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(size) / 0.68)));
  const std::size_t side = tree.side;
  tree.cells.resize(side * side);
  tree.first = side / 2 * side + side / 2;
  tree.cells[tree.first].used = true;
  std::vector<std::size_t> growing = {tree.first};
  for (std::size_t used = 1; used < size;) {
    const bool from_newest = rng.uniform() < 0.55;
    const std::size_t choice =
        from_newest ? growing.size() - 1 : static_cast<std::size_t>(rng.below(growing.size()));
    const std::size_t cell = growing[choice];
    const std::size_t column = cell % side, row = cell / side;
    std::size_t free_cells[4];
    std::size_t count = 0;
    const auto consider = [&](bool inside, std::size_t neighbour) {
      if (inside && !tree.cells[neighbour].used) free_cells[count++] = neighbour;
    };
    consider(column + 1 < side, cell + 1);
    consider(row + 1 < side, cell + side);
    consider(column > 0, cell - 1);
    consider(row > 0, cell - side);
    if (count == 0) {  // this cell cannot grow any further
      std::swap(growing[choice], growing.back());
      growing.pop_back();
      continue;
    }
    const std::size_t next = free_cells[rng.below(count)];
    join(tree, cell, next);
    growing.push_back(next);
    ++used;
  }
  return tree;
}

// A point of the fine grid, two by two per cell.
struct Node {
  std::size_t column = 0, row = 0;
};

// Walks counter-clockwise around the tree: along the sides of a cell, and across where it is joined
// to a neighbour. O(cells of the tree).
std::vector<Node> walk_around(const CellTree& tree) {
  const Node start = {tree.first % tree.side * 2, tree.first / tree.side * 2};
  std::vector<Node> walk;
  Node at = start;
  do {
    walk.push_back(at);
    const CellTree::Joints& cell = tree.cells[at.row / 2 * tree.side + at.column / 2];
    const bool right = at.column % 2 == 1, upper = at.row % 2 == 1;
    if (!right && !upper)
      cell.south ? --at.row : ++at.column;
    else if (right && !upper)
      cell.east ? ++at.column : ++at.row;
    else if (right && upper)
      cell.north ? ++at.row : --at.column;
    else
      cell.west ? --at.column : --at.row;
  } while (at.column != start.column || at.row != start.row);
  return walk;
}

// Columns (or rows) of varying width.
struct Bands {
  std::vector<double> begin;
  std::vector<double> width;
};
Bands draw_bands(std::size_t count, Rng& rng) {
  Bands bands;
  double at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    bands.begin.push_back(at);
    bands.width.push_back(0.6 + 0.8 * rng.uniform());
    at += bands.width.back();
  }
  return bands;
}

// The outline while vertices are cut off: a ring of the walk's nodes, and the node in each box.
class Outline {
 public:
  Outline(std::vector<Node> nodes, std::size_t columns, std::size_t rows, int decimals, Rng& rng)
      : nodes_(std::move(nodes)), columns_(columns), occupant_(columns * rows, none) {
    place_nodes(columns, rows, decimals, rng);
    const std::size_t count = nodes_.size();
    for (std::size_t i = 0; i < count; ++i) {
      previous_.push_back(i == 0 ? count - 1 : i - 1);
      next_.push_back(i + 1 == count ? 0 : i + 1);
      occupant_[nodes_[i].row * columns_ + nodes_[i].column] = i;
    }
    left_ = count;
  }

  // Cuts in random order until n are left. Expected O(nodes): the first rounds finish all but a few
  // small outlines, and only later rounds examine triangles that span many boxes.
  void cut_down_to(std::size_t n, Rng& rng) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < nodes_.size(); ++i) order.push_back(i);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(rng.below(i))]);
    std::size_t most_boxes = 64;
    double clearance = 0.3 * unit_;
    while (left_ > n) {
      for (std::size_t i = 0; i < order.size() && left_ > n; ++i)
        if (next_[order[i]] != none && can_cut(order[i], most_boxes, clearance)) cut(order[i]);
      // Eventually a vertex can always be cut, since every polygon has two ears.
      most_boxes *= 4;
      clearance *= 0.5;
    }
  }

  std::vector<GridPoint> vertices() const {
    std::vector<GridPoint> vertices;
    std::size_t at = 0;
    while (next_[at] == none) ++at;
    for (std::size_t i = 0; i < left_; ++i, at = next_[at]) vertices.push_back(points_[at]);
    return vertices;
  }

 private:
  // Puts each node somewhere in its box, the middle three quarters of its column and of its row.
  // The outline fills 0 .. 1000 in the longer direction.
  void place_nodes(std::size_t columns, std::size_t rows, int decimals, Rng& rng) {
    const Bands across = draw_bands(columns, rng);
    const Bands up = draw_bands(rows, rng);
    std::vector<std::pair<double, double>> places;
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
    for (const Node& node : nodes_) {
      const double x =
          across.begin[node.column] + across.width[node.column] * (0.125 + 0.75 * rng.uniform());
      const double y = up.begin[node.row] + up.width[node.row] * (0.125 + 0.75 * rng.uniform());
      places.emplace_back(x, y);
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
    unit_ = 1000 * units(decimals) / std::max(x1 - x0, y1 - y0);
    for (const auto& [x, y] : places)
      points_.push_back({nearest((x - x0) * unit_), nearest((y - y0) * unit_)});
  }

  // Whether the triangle of v and its neighbours spans at most `most_boxes` boxes and contains no
  // other vertex, and the new edge keeps `clearance` from the other vertices in these boxes.
  bool can_cut(std::size_t v, std::size_t most_boxes, double clearance) const {
    const std::size_t a = previous_[v], c = next_[v];
    std::size_t column0 = none, column1 = 0, row0 = none, row1 = 0;
    for (const std::size_t i : {a, v, c}) {
      column0 = std::min(column0, nodes_[i].column), column1 = std::max(column1, nodes_[i].column);
      row0 = std::min(row0, nodes_[i].row), row1 = std::max(row1, nodes_[i].row);
    }
    if ((column1 - column0 + 1) * (row1 - row0 + 1) > most_boxes) return false;
    for (std::size_t row = row0; row <= row1; ++row)
      for (std::size_t column = column0; column <= column1; ++column) {
        const std::size_t i = occupant_[row * columns_ + column];
        if (i == none || i == a || i == v || i == c) continue;
        if (in_triangle(points_[i], points_[a], points_[v], points_[c])) return false;
        if (distance(points_[i], points_[a], points_[c]) < clearance) return false;
      }
    return true;
  }

  void cut(std::size_t v) {
    next_[previous_[v]] = next_[v];
    previous_[next_[v]] = previous_[v];
    next_[v] = none;
    occupant_[nodes_[v].row * columns_ + nodes_[v].column] = none;
    --left_;
  }

  static bool in_triangle(const GridPoint& p, const GridPoint& a, const GridPoint& b,
                          const GridPoint& c) {
    const std::int64_t ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }

  // From the segment a b, a != b.
  static double distance(const GridPoint& p, const GridPoint& a, const GridPoint& b) {
    const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const auto px = static_cast<double>(p.x - a.x), py = static_cast<double>(p.y - a.y);
    const double along = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double ex = px - along * dx, ey = py - along * dy;
    return std::sqrt(ex * ex + ey * ey);
  }

  std::vector<Node> nodes_;
  std::size_t columns_;
  std::vector<std::size_t> occupant_;
  std::vector<std::size_t> previous_, next_;  // `next_` is none: cut off
  std::vector<GridPoint> points_;
  double unit_ = 1;  // mean width of a column, in grid units
  std::size_t left_ = 0;
};

// Whether some point sees all, or nearly all, of a counter-clockwise outline: clips a large square
// by each edge's inner side, with a little slack, which polygon/corners.h does not allow. O(n) times
// the corners of the remaining square, which is soon empty.
bool is_star_shaped(const std::vector<GridPoint>& outline) {
  struct Corner {
    double x, y;
  };
  const double far = 1e7, slack = 1e-3;
  std::vector<Corner> kernel = {{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  for (std::size_t i = 0; i < outline.size() && !kernel.empty(); ++i) {
    const GridPoint& a = outline[i];
    const GridPoint& b = outline[i + 1 == outline.size() ? 0 : i + 1];
    const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const auto side = [&](const Corner& p) {  // distance inwards in edge lengths, plus slack
      const double cross =
          dx * (p.y - static_cast<double>(a.y)) - dy * (p.x - static_cast<double>(a.x));
      return cross / (dx * dx + dy * dy) + slack;
    };
    std::vector<Corner> clipped;
    for (std::size_t j = 0; j < kernel.size(); ++j) {
      const Corner& p = kernel[j];
      const Corner& q = kernel[j + 1 == kernel.size() ? 0 : j + 1];
      const double sp = side(p), sq = side(q);
      if (sp >= 0) clipped.push_back(p);
      if ((sp < 0) != (sq < 0)) {
        const double t = sp / (sp - sq);
        clipped.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
      }
    }
    kernel = std::move(clipped);
  }
  return !kernel.empty();
}

}  // namespace

GridPolygon random(std::size_t n, Rng& rng) {
  GridPolygon polygon;
  // A third more vertices than are kept, because cuts make edges of all lengths and directions; for
  // few vertices, enough cells for a bend.
  const std::size_t cells = std::max<std::size_t>(n <= 5 ? 2 : 4, (n + n / 3 + 3) / 4);
  // With up to five vertices every polygon is star-shaped. With a few more, some are, and are drawn
  // again.
  const int attempts = n <= 5 ? 1 : 1000;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const CellTree tree = grow_tree(cells, rng);
    Outline outline(walk_around(tree), 2 * tree.side, 2 * tree.side, polygon.decimals, rng);
    outline.cut_down_to(n, rng);
    polygon.vertices = outline.vertices();
    if (n > 5 && !is_star_shaped(polygon.vertices)) break;
  }
  return polygon;
}

}  // namespace evenlift::families
