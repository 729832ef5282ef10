#include "import/joining/joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>

namespace evenlift {
namespace {

// Ends closer than this part of the drawing's larger side differ only by rounding.
constexpr double rounding = 1e-9;

// Merges nodes into sets; the least node names its set.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::size_t of(std::size_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void merge(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

constexpr std::size_t no_place = static_cast<std::size_t>(-1);

// The pieces of one or more layers as a graph.
class Drawing {
 public:
  Drawing(const std::vector<DrawnPiece>& pieces, std::vector<std::size_t> chosen, double side)
      : pieces_(pieces), chosen_(std::move(chosen)), side_(side), sets_(0) {}

  void connect(std::optional<double> reach);
  void add_outlines(Joining& joining) const;
  // The chosen pieces in no outline.
  std::vector<std::size_t> open() const;
  double gap() const { return gap_; }
  std::size_t repeated() const { return repeated_; }
  std::optional<std::pair<Vec2, Vec2>> apart() const { return apart_; }

 private:
  // A line or curve, before its ends become nodes.
  struct Atom {
    Vec2 from;
    CurvePiece curve;
    std::size_t piece;
  };

  void take_atoms();
  void number_places();
  void find_closed_chains();
  bool only_touches(std::size_t atom, std::size_t place, double near) const;
  void divide_lines(double near, const std::vector<std::size_t>& number);
  std::vector<std::size_t> line_ranks();
  std::vector<GraphEdge> edges();
  std::vector<std::size_t> other_ends() const;
  void join_loose_ends(double near);
  void join_pairs_of_open_ends(double near);
  std::vector<std::size_t> open_ends();
  void remember_apart();

  const std::vector<DrawnPiece>& pieces_;
  std::vector<std::size_t> chosen_;
  double side_;
  std::vector<Atom> atoms_;
  std::vector<std::size_t> from_, to_;  // by atom: the places of its ends
  Points places_;                       // distinct, by x, then y
  std::vector<std::vector<std::pair<double, std::size_t>>> divided_;  // by atom: `along`, `place`
  Sets sets_;
  std::vector<std::size_t> closed_chain_;           // by place: that it is in, or no_place
  std::vector<std::array<std::size_t, 2>> beside_;  // by place: the other ends of two lines there
  std::vector<Face> faces_;
  std::vector<GraphEdge> edges_;
  std::vector<std::pair<std::size_t, std::size_t>> bridges_;  // straight lines across wide gaps
  std::vector<std::size_t> piece_at_;                         // a piece that ends at each place
  std::vector<std::size_t> loose_;                            // open if only rounding is forgiven
  double gap_ = 0;
  std::size_t repeated_ = 0;
  std::optional<std::pair<Vec2, Vec2>> apart_;
};

void Drawing::take_atoms() {
  for (const std::size_t piece : chosen_) {
    Vec2 from = pieces_[piece].outline.start;
    for (const CurvePiece& curve : pieces_[piece].outline.pieces) {
      atoms_.push_back({from, curve, piece});
      from = curve.end;
    }
  }
}

// Numbers ends by place, so that the order of the pieces does not matter, and joins those that
// differ only by rounding.
void Drawing::number_places() {
  for (const Atom& atom : atoms_) {
    places_.push_back(atom.from);
    places_.push_back(atom.curve.end);
  }
  std::sort(places_.begin(), places_.end(), is_before);
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  const auto number = [&](const Vec2& at) {
    return static_cast<std::size_t>(
        std::lower_bound(places_.begin(), places_.end(), at, is_before) - places_.begin());
  };
  for (const Atom& atom : atoms_) {
    from_.push_back(number(atom.from));
    to_.push_back(number(atom.curve.end));
  }
  divided_.resize(atoms_.size());
  piece_at_.resize(places_.size());
  for (std::size_t a = 0; a < atoms_.size(); ++a)
    piece_at_[from_[a]] = piece_at_[to_[a]] = atoms_[a].piece;
  sets_ = Sets(places_.size());
  const double near = rounding * side_;
  if (!(near > 0)) return;
  const PointGrid grid(places_, near);
  for (std::size_t i = 0; i < places_.size(); ++i)
    grid.for_each_near(places_[i], near, [&](std::size_t j) {
      if (j < i) sets_.merge(i, j);
    });
}

// The chains of lines and arcs that close without any other, perhaps across a gap that may be joined:
// two ends meet at each of their places.
void Drawing::find_closed_chains() {
  const std::size_t count = places_.size();
  Sets chains(count);
  beside_.assign(count, {no_place, no_place});
  std::vector<std::uint32_t> ends(count);
  const auto take = [&](std::size_t at, std::size_t other, CurvePiece::Kind kind) {
    if (ends[at] < 2 && kind == CurvePiece::Kind::line) beside_[at][ends[at]] = other;
    ++ends[at];
  };
  for (std::size_t a = 0; a < atoms_.size(); ++a) {
    const std::size_t from = sets_.of(from_[a]), to = sets_.of(to_[a]);
    chains.merge(from, to);
    take(from, to, atoms_[a].curve.kind);
    take(to, from, atoms_[a].curve.kind);
  }
  std::vector<char> closes(count, 1);
  std::vector<std::uint32_t> corners(count);          // by chain
  std::vector<std::vector<std::size_t>> open(count);  // ends, by chain
  for (std::size_t i = 0; i < count; ++i) {
    if (sets_.of(i) != i) continue;
    ++corners[chains.of(i)];
    if (ends[i] > 2) closes[chains.of(i)] = 0;
    if (ends[i] == 1) open[chains.of(i)].push_back(i);
  }
  const double reach = std::end(join_reaches)[-1] * side_;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t chain = chains.of(sets_.of(i));
    const std::vector<std::size_t>& gap = open[chain];
    const bool is_closed = gap.empty() || (gap.size() == 2 && corners[chain] > 3 &&
                                           length(places_[gap[0]] - places_[gap[1]]) <= reach);
    closed_chain_.push_back(closes[chain] != 0 && is_closed ? chain : no_place);
  }
}

// Whether the place, on a line, is the corner of another closed chain that has no line along this one.
bool Drawing::only_touches(std::size_t atom, std::size_t place, double near) const {
  const std::size_t chain = closed_chain_[from_[atom]], other = closed_chain_[place];
  if (chain == no_place || other == no_place || chain == other) return false;
  const Vec2 from = atoms_[atom].from, way = atoms_[atom].curve.end - from;
  return std::none_of(beside_[place].begin(), beside_[place].end(), [&](std::size_t next) {
    return next != no_place && std::abs(cross(way, places_[next] - from)) <= near * length(way);
  });
}

// Divides straight lines at the given places that are on them. A closed chain does not divide another
// that it only touches: where they also cross, neither would be found.
void Drawing::divide_lines(double near, const std::vector<std::size_t>& number) {
  if (number.empty()) return;
  Points some;
  for (const std::size_t place : number) some.push_back(places_[place]);
  const double cell = std::max(near, side_ / (1 + std::sqrt(static_cast<double>(some.size()))));
  const PointGrid grid(some, cell);
  for (std::size_t a = 0; a < atoms_.size(); ++a) {
    const Atom& atom = atoms_[a];
    if (atom.curve.kind != CurvePiece::Kind::line) continue;
    const Vec2 way = atom.curve.end - atom.from;
    const double square = dot(way, way);
    if (!(square > 0)) continue;
    grid.for_each_along(atom.from, atom.curve.end, near, [&](std::size_t i) {
      const Vec2 apart = some[i] - atom.from;
      const double along = dot(apart, way) / square;
      if (!(along > 0 && along < 1)) return;
      if (length(apart - along * way) > near) return;
      const std::size_t place = number[i];
      for (const std::size_t end : {from_[a], to_[a]})
        if (sets_.of(end) == sets_.of(place)) return;
      if (only_touches(a, sets_.of(place), near)) return;
      divided_[a].emplace_back(along, place);
    });
    std::sort(divided_[a].begin(), divided_[a].end());
    divided_[a].erase(std::unique(divided_[a].begin(), divided_[a].end()), divided_[a].end());
  }
}

// The longest straight line has the first rank; lines with the same ends share one.
std::vector<std::size_t> Drawing::line_ranks() {
  using Key = std::tuple<double, std::size_t, std::size_t>;
  std::vector<Key> keys;
  for (std::size_t a = 0; a < atoms_.size(); ++a) {
    const std::size_t from = sets_.of(from_[a]), to = sets_.of(to_[a]);
    keys.emplace_back(-length(places_[to] - places_[from]), std::min(from, to), std::max(from, to));
  }
  std::vector<Key> sorted = keys;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> ranks;
  for (const Key& key : keys)
    ranks.push_back(static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), key) -
                                             sorted.begin()));
  return ranks;
}

// Each edge once.
std::vector<GraphEdge> Drawing::edges() {
  const std::vector<std::size_t> ranks = line_ranks();
  std::vector<GraphEdge> all;
  for (std::size_t a = 0; a < atoms_.size(); ++a) {
    const Atom& atom = atoms_[a];
    std::size_t from = sets_.of(from_[a]);
    const auto add = [&](std::size_t to, CurvePiece curve) {
      to = sets_.of(to);
      // A line without length is dropped, but a curve may return to its start.
      if (from == to && curve.kind == CurvePiece::Kind::line) return;
      curve.end = places_[to];
      all.push_back({from, to, curve, ranks[a], atom.piece});
      from = to;
    };
    for (const auto& [along, place] : divided_[a])
      add(place, {CurvePiece::Kind::line, places_[place]});
    add(to_[a], atom.curve);
  }
  const std::size_t before = all.size() + bridges_.size();
  for (const auto& [a, b] : bridges_)
    all.push_back({sets_.of(a),
                   sets_.of(b),
                   {CurvePiece::Kind::line, places_[sets_.of(b)]},
                   atoms_.size(),
                   piece_at_[a]});
  drop_repeated(all, safe_reach * side_);
  repeated_ = before - all.size();
  return all;
}

std::vector<std::size_t> Drawing::open_ends() {
  std::vector<std::uint32_t> degree(places_.size());
  for (const GraphEdge& edge : edges_) {
    ++degree[edge.from];
    ++degree[edge.to];
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < degree.size(); ++i)
    if (degree[i] == 1) open.push_back(i);
  return open;
}

// For each end, the other end of its line: joining both would make a short line vanish.
std::vector<std::size_t> Drawing::other_ends() const {
  std::vector<std::size_t> other(places_.size(), places_.size());
  for (const GraphEdge& edge : edges_) {
    if (edge.curve.kind != CurvePiece::Kind::line) continue;
    other[edge.from] = edge.to;
    other[edge.to] = edge.from;
  }
  return other;
}

// Within a safe distance, an end that was open at first joins all places near it, so that lines
// drawn several times coincide.
void Drawing::join_loose_ends(double near) {
  const std::vector<std::size_t> other = other_ends();
  const PointGrid grid(places_, near);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const std::size_t node : loose_) {
    const std::size_t end = other[sets_.of(node)];
    grid.for_each_near(places_[node], near, [&](std::size_t i) {
      if (sets_.of(i) == sets_.of(node)) return;
      if (end < places_.size() && sets_.of(i) == sets_.of(end)) return;
      pairs.emplace_back(node, i);
      gap_ = std::max(gap_, length(places_[i] - places_[node]));
    });
  }
  for (const auto& [a, b] : pairs) sets_.merge(a, b);
  divide_lines(near, loose_);
}

// Joins pairs of open ends, the nearest first.
void Drawing::join_pairs_of_open_ends(double near) {
  const std::vector<std::size_t> open = open_ends(), other = other_ends();
  Points at;
  for (const std::size_t node : open) at.push_back(places_[node]);
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  const PointGrid grid(at, near);
  for (std::size_t i = 0; i < at.size(); ++i)
    grid.for_each_near(at[i], near, [&](std::size_t j) {
      if (j < i && other[open[i]] != open[j])
        pairs.emplace_back(length(at[j] - at[i]), open[j], open[i]);
    });
  std::sort(pairs.begin(), pairs.end());
  std::vector<char> joined(places_.size());
  for (const auto& [distance, a, b] : pairs) {
    if (joined[a] != 0 || joined[b] != 0) continue;
    joined[a] = joined[b] = 1;
    gap_ = std::max(gap_, distance);
    if (distance <= std::end(join_reaches)[-1] * side_)
      sets_.merge(a, b);
    else
      bridges_.emplace_back(a, b);
  }
}

void Drawing::remember_apart() {
  const std::vector<std::size_t> open = open_ends();
  constexpr std::size_t most_compared = 1000;
  if (open.size() < 2 || open.size() > most_compared) return;
  double least = 0;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t j = i + 1; j < open.size(); ++j) {
      const double apart = length(places_[open[i]] - places_[open[j]]);
      if (apart_ && apart >= least) continue;
      least = apart;
      apart_ = {places_[open[i]], places_[open[j]]};
    }
}

void Drawing::connect(std::optional<double> reach) {
  take_atoms();
  number_places();
  find_closed_chains();
  std::vector<std::size_t> all(places_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  divide_lines(rounding * side_, all);
  edges_ = edges();
  loose_ = open_ends();
  std::vector<double> reaches;
  for (const double part : join_reaches)
    if (!reach || part * side_ < *reach) reaches.push_back(part * side_);
  if (reach) reaches.push_back(*reach);
  for (const double near : reaches) {
    const bool safe = near <= 1.5 * safe_reach * side_;
    if (!(near > 0) || loose_.empty() || (!safe && open_ends().empty())) break;
    if (safe)
      join_loose_ends(near);
    else
      join_pairs_of_open_ends(near);
    edges_ = edges();
  }
  faces_ = faces_of(edges_, places_);
  remember_apart();
}

void Drawing::add_outlines(Joining& joining) const {
  for (const Face& face : faces_) {
    std::vector<std::size_t> used;
    for (const HalfEdge& half : face.boundary) used.push_back(edges_[half.edge].piece);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const auto [least, greatest] = std::minmax_element(
        used.begin(), used.end(),
        [&](std::size_t a, std::size_t b) { return pieces_[a].layer < pieces_[b].layer; });
    const std::string& layer = pieces_[*least].layer;
    const DrawnPiece& first = pieces_[used.front()];
    const auto all = [&](auto member) {
      return std::all_of(used.begin(), used.end(), [&](std::size_t piece) {
        return pieces_[piece].*member == first.*member;
      });
    };
    const bool is_named = !first.name.empty() && all(&DrawnPiece::name);
    joining.outlines.push_back({outline_of(face, edges_, places_), used.size(),
                                is_named ? first.name : layer, layer != pieces_[*greatest].layer,
                                all(&DrawnPiece::copy) ? first.copy : 0});
  }
}

std::vector<std::size_t> Drawing::open() const {
  std::vector<char> used(pieces_.size());
  for (const Face& face : faces_)
    for (const HalfEdge& half : face.boundary) used[edges_[half.edge].piece] = 1;
  // A piece without edges left lies on another.
  std::vector<char> left(pieces_.size());
  for (const GraphEdge& edge : edges_) left[edge.piece] = 1;
  std::vector<std::size_t> open;
  for (const std::size_t piece : chosen_)
    if (used[piece] == 0 && left[piece] != 0) open.push_back(piece);
  return open;
}

using TwoEnds = std::optional<std::pair<Vec2, Vec2>>;

bool is_nearer(const TwoEnds& ends, const TwoEnds& others) {
  const auto apart = [](const TwoEnds& two) { return length(two->second - two->first); };
  return ends && (!others || apart(ends) < apart(others));
}

Points ends_of(const std::vector<DrawnPiece>& pieces, const std::vector<std::size_t>& chosen) {
  Points ends;
  for (const std::size_t piece : chosen) {
    ends.push_back(pieces[piece].outline.start);
    ends.push_back(pieces[piece].outline.end());
  }
  return ends;
}

// `all` contains the ends of all pieces, two for each.
std::vector<std::size_t> alone(const Points& all, const std::vector<std::size_t>& open,
                               double near) {
  const PointGrid grid(all, near);
  std::vector<std::size_t> alone;
  for (const std::size_t piece : open) {
    bool meets = false;
    for (const std::size_t end : {2 * piece, 2 * piece + 1})
      grid.for_each_near(all[end], near, [&](std::size_t i) { meets = meets || i / 2 != piece; });
    if (!meets) alone.push_back(piece);
  }
  return alone;
}

double greatest_open(const std::vector<DrawnPiece>& pieces, const std::vector<std::size_t>& open,
                     double near) {
  const Points ends = ends_of(pieces, open);
  const PointGrid grid(ends, near);
  Sets sets(open.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    grid.for_each_near(ends[i], near, [&](std::size_t j) { sets.merge(i / 2, j / 2); });
  std::vector<Points> corners(open.size());
  std::vector<std::size_t> parts(open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Outline& outline = pieces[open[i]].outline;
    const Box box = control_box(outline);
    corners[sets.of(i)].insert(corners[sets.of(i)].end(), {box.low, box.high});
    parts[sets.of(i)] += outline.pieces.size() + (outline.curved() ? 1 : 0);
  }
  double greatest = 0;
  for (std::size_t i = 0; i < open.size(); ++i)
    if (parts[i] > 1) greatest = std::max(greatest, bounding_box(corners[i]).area());
  return greatest;
}

}  // namespace

Joining join(const std::vector<DrawnPiece>& pieces, std::optional<double> reach) {
  Joining joining;
  Points corners;
  for (const DrawnPiece& piece : pieces) {
    const Box box = control_box(piece.outline);
    corners.insert(corners.end(), {box.low, box.high});
  }
  std::vector<std::size_t> all(pieces.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Points ends = ends_of(pieces, all);
  const Vec2 size = bounding_box(corners).size();
  const double side = std::max(size.x, size.y);
  if (!(side > 0) || !std::isfinite(side)) {
    joining.open = std::move(all);
    return joining;
  }
  const auto take = [&](std::vector<std::size_t> chosen) {
    Drawing drawing(pieces, std::move(chosen), side);
    drawing.connect(reach);
    drawing.add_outlines(joining);
    joining.repeated += drawing.repeated();
    joining.gap = std::max(joining.gap, drawing.gap());
    if (is_nearer(drawing.apart(), joining.apart)) joining.apart = drawing.apart();
    return drawing.open();
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](std::size_t a, std::size_t b) { return pieces[a].layer < pieces[b].layer; });
  std::size_t layers = 0;
  for (std::size_t first = 0; first < all.size(); ++layers) {
    std::size_t last = first;
    while (last < all.size() && pieces[all[last]].layer == pieces[all[first]].layer) ++last;
    const std::vector<std::size_t> open = take({all.begin() + static_cast<std::ptrdiff_t>(first),
                                                all.begin() + static_cast<std::ptrdiff_t>(last)});
    joining.open.insert(joining.open.end(), open.begin(), open.end());
    first = last;
  }
  if (layers > 1 && joining.open.size() > 1) {
    joining.apart.reset();
    joining.open = take(joining.open);
  }
  std::sort(joining.open.begin(), joining.open.end());
  const double near = 1.5 * safe_reach * side;
  joining.gap_is_seen = joining.gap > near;
  joining.alone = alone(ends, joining.open, near);
  joining.greatest_open = greatest_open(pieces, joining.open, near);
  return joining;
}

}  // namespace evenlift
