#include "candidates/pair_candidate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "candidates/candidate_order.h"
#include "candidates/standing.h"
#include "chords/radial_view.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// Spreads numbers without a pattern, so that a sample does not pick only one side of every tooth of
// a comb (the finalizer of MurmurHash3).
std::uint32_t scattered(std::uint32_t number) {
  number ^= number >> 16;
  number *= 0x85ebca6bu;
  number ^= number >> 13;
  number *= 0xc2b2ae35u;
  return number ^ (number >> 16);
}

EdgePair swapped(const EdgePair& pair) {
  return {pair.b, pair.a, pair.begin_b, pair.begin_a, pair.end_b, pair.end_a};
}

}  // namespace

class EvenChords::Search {
 public:
  // Stops as soon as `most` chords are found.
  Search(const EvenChords& chords, const Sample& sample, const Vec2& centre, std::size_t most)
      : tree_(sample.tree),
        lines_(sample.lines),
        edges_(sample.edges),
        stands_(chords.stands_),
        polygon_(chords.polygon_),
        centre_(centre),
        twice_(2 * centre),
        most_(most) {
    // The ends of even chords are within 3 tau L of the mirror image; the rest allows for rounding.
    near_ = near_distance(polygon_.diameter());
    constexpr double rounding = 0x1p-48;
    slack_ = 4 * near_ + rounding * (chords.size_ + max_norm(centre));
  }

  std::vector<Candidate> run(std::uint64_t& compared) {
    visit(0, 0);
    compared += compared_;
    return std::move(found_);
  }

 private:
  bool can_meet(const Box& a, const Box& b) const {
    return a.low.x + b.low.x <= twice_.x + slack_ && a.low.y + b.low.y <= twice_.y + slack_ &&
           a.high.x + b.high.x >= twice_.x - slack_ && a.high.y + b.high.y >= twice_.y - slack_;
  }

  void visit(std::uint32_t i, std::uint32_t j) {
    const EdgeTree::Node &a = tree_.node(i), &b = tree_.node(j);
    ++compared_;
    if (found_.size() >= most_ || !can_meet(a.box, b.box)) return;
    if (i == j) {
      if (a.is_leaf()) return compare_edges(a, b);
      visit(a.left, a.left);
      visit(a.left, a.right);
      return visit(a.right, a.right);
    }
    if (a.is_leaf() && b.is_leaf()) return compare_edges(a, b);
    const bool split_a = b.is_leaf() || (!a.is_leaf() && a.end - a.begin >= b.end - b.begin);
    if (split_a) {
      visit(a.left, j);
      visit(a.right, j);
    } else {
      visit(i, b.left);
      visit(i, b.right);
    }
  }

  void compare_edges(const EdgeTree::Node& a, const EdgeTree::Node& b) {
    compared_ += (a.end - a.begin) * (b.end - b.begin);
    for (std::uint32_t i = a.begin; i < a.end; ++i)
      for (std::uint32_t j = &a == &b ? i + 1 : b.begin; j < b.end; ++j)
        if (may_meet(i, j)) add(i, j);
  }

  // Whether an edge and the mirror image of another may come within `slack_` of each other.
  bool may_meet(std::uint32_t a, std::uint32_t b) const {
    const Vec2 p = lines_[a].start - centre_, q = lines_[a].end - centre_;
    const Vec2 r = centre_ - lines_[b].start, s = centre_ - lines_[b].end;
    return !apart(p, q, r, s) && !apart(r, s, p, q);
  }

  // Whether r and s lie on one side of the line p q, farther from it than `slack_`.
  bool apart(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) const {
    const Vec2 along = q - p;
    const double to_r = cross(along, r - p), to_s = cross(along, s - p);
    if ((to_r > 0) != (to_s > 0)) return false;
    const double least = std::min(std::fabs(to_r), std::fabs(to_s));
    return least > slack_ * one_norm(along);
  }

  void add(std::uint32_t i, std::uint32_t j) {
    compared_ += stands_ ? of_pair_with_stands : of_pair;
    if (stands_ && stands_->robot().depth > 0) return add_moved(edges_[i], edges_[j]);
    add_pair(edges_[i], edges_[j]);
    add_opposite(edges_[i], edges_[j]);
  }

  void add_moved(std::uint32_t edge_a, std::uint32_t edge_b) {
    const auto a = stand_line(polygon_, centre_, *stands_, edge_a);
    const auto b = stand_line(polygon_, centre_, *stands_, edge_b);
    for (const Candidate& candidate : standing_chords(*stands_, centre_, *a, *b, 1, near_))
      found_.push_back(candidate);
  }

  void add_pair(std::uint32_t a, std::uint32_t b) {
    auto pair = pair_of_edges(polygon_, centre_, a, b, near_);
    if (!pair) return;
    // In the sweep over all pairs, the line's forward half meets `a`.
    const bool a_is_ahead = pair->begin_a != inside_edge
                                ? is_forward(centre_, polygon_.vertex(pair->begin_a))
                                : !is_forward(centre_, polygon_.vertex(pair->begin_b));
    if (!a_is_ahead) pair = swapped(*pair);
    if (stands_) {
      for (const Candidate& candidate : standing_chords(polygon_, *stands_, centre_, *pair, 1))
        found_.push_back(candidate);
      return;
    }
    const auto verdict = examine_pair(polygon_, centre_, *pair, 1);
    if (verdict.candidate) found_.push_back(*verdict.candidate);
  }

  // Edge v begins at vertex v.
  void add_opposite(std::uint32_t v, std::uint32_t w) {
    if (!are_opposite(polygon_.vertex(v) - centre_, polygon_.vertex(w) - centre_, near_)) return;
    const Candidate candidate = opposite_chord(polygon_, centre_, {std::min(v, w), std::max(v, w)});
    if (stands_ && (stands_->has_body() || !can_stand(*stands_, candidate))) return;
    if (reaches(candidate.chord, 1)) found_.push_back(candidate);
  }

  // What a pair of edges that may meet costs, in comparisons.
  static constexpr std::uint64_t of_pair = 60, of_pair_with_stands = 160;

  const EdgeTree& tree_;
  const std::vector<LineEnds>& lines_;
  const std::vector<std::uint32_t>& edges_;
  const Stands* stands_;
  const Polygon& polygon_;
  Vec2 centre_, twice_;
  std::size_t most_;
  double near_ = 0, slack_ = 0;
  std::uint64_t compared_ = 0;
  std::vector<Candidate> found_;
};

EvenChords::Sample EvenChords::sample_of(const Polygon& polygon, const Stands* stands,
                                         const std::vector<std::uint32_t>& edges) {
  std::vector<std::uint32_t> kept;
  std::vector<LineEnds> lines;
  const bool moved = stands != nullptr && stands->robot().depth > 0;
  for (const std::uint32_t edge : edges) {
    if (!moved) {
      lines.push_back({polygon.edge_start(edge), polygon.edge_end(edge)});
    } else if (const auto line = stand_line(polygon, {}, *stands, edge)) {
      lines.push_back({line->at(line->low), line->at(line->high)});
    } else {
      continue;
    }
    kept.push_back(edge);
  }
  EdgeTree tree(lines);
  return {std::move(kept), std::move(lines), std::move(tree)};
}

EvenChords::EvenChords(const Polygon& polygon, const Stands* stands)
    : polygon_(polygon),
      stands_(stands),
      all_(sample_of(polygon, stands, indices_below(polygon.size()))) {
  for (const Vec2& v : polygon.vertices()) size_ = std::max(size_, max_norm(v));
}

EvenChords::EvenChords(const Polygon& polygon, const Stands* stands,
                       const std::vector<std::uint32_t>& walk)
    : EvenChords(polygon, stands) {
  constexpr std::size_t few_edges = 1000;
  constexpr std::size_t smallest_sample = 64;
  if (walk.size() <= few_edges) return;
  std::uint32_t below = ~std::uint32_t{0} / 2;
  for (std::size_t size = walk.size() / 2; size >= smallest_sample; size /= 2, below /= 2) {
    std::vector<std::uint32_t> edges;
    for (std::uint32_t i = 0; i < walk.size(); ++i)
      if (scattered(i) < below) edges.push_back(walk[i]);
    std::sort(edges.begin(), edges.end());
    samples_.push_back(sample_of(polygon, stands, edges));
  }
  std::reverse(samples_.begin(), samples_.end());
}

std::vector<Candidate> EvenChords::in_order(const std::vector<Candidate>& found) const {
  const double near = near_distance(polygon_.diameter());
  return merge_duplicates(in_candidate_order(found, near), near).candidates;
}

std::vector<Candidate> EvenChords::about(const Vec2& centre) const {
  std::uint64_t compared = 0;
  return about(centre, compared);
}

std::vector<Candidate> EvenChords::about(const Vec2& centre, std::uint64_t& compared) const {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  return in_order(Search(*this, all_, centre, all).run(compared));
}

std::vector<Candidate> EvenChords::some_about(const Vec2& centre, std::uint64_t& compared) const {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  for (const Sample& sample : samples_) {
    std::vector<Candidate> found = Search(*this, sample, centre, all).run(compared);
    if (found.size() >= enough_chords) return in_order(found);
  }
  return about(centre, compared);
}

std::size_t EvenChords::count_about(const Vec2& centre, std::size_t most) const {
  std::uint64_t compared = 0;
  return std::min(most, Search(*this, all_, centre, most).run(compared).size());
}

}  // namespace evenlift
