// Even candidates about many centres. An even chord about M ends where the outline meets its mirror
// image in M. A tree of boxes finds these places without visiting every edge; their candidates are
// decided like all others.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/stands.h"
#include "polygon/edge_tree.h"

namespace evenlift {

class EvenChords {
 public:
  // The polygon and the stands must outlive it. With stands the candidates are those of
  // standing_candidates(). O(n).
  explicit EvenChords(const Polygon& polygon, const Stands* stands = nullptr);

  // Also prepares for some_about(). `walk` contains all edges in order along the outline, from a
  // place that does not depend on the vertex list. O(n).
  EvenChords(const Polygon& polygon, const Stands* stands, const std::vector<std::uint32_t>& walk);

  // Equals find_candidates(polygon, centre, 1), but without a limit on the number of candidates,
  // and a chord between two vertices may name the other edges of these vertices. The centre may be
  // anywhere. O(n) at worst; for an outline that hardly winds, O(log n) for each place where it
  // meets its mirror image.
  std::vector<Candidate> about(const Vec2& centre) const;

  // All even candidates about the centre or, of many, those between the edges of a sample: of a
  // half, a quarter, an eighth and so on of all edges, the smallest with at least enough_chords
  // candidates. An edge's number in the walk alone decides its samples. A strongly winding outline
  // may have a hundred thousand even chords about one centre, and some serve a search as well.
  // O(log n) for each place where the sample meets its mirror image.
  static constexpr std::size_t enough_chords = 32;
  std::vector<Candidate> some_about(const Vec2& centre) const;

  // The number of even candidates with duplicates, at most `most`. A strongly winding outline soon
  // reaches `most`, so this is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  // Some edges, in the order of their numbers.
  struct Sample {
    std::vector<std::uint32_t> edges;
    std::vector<LineEnds> lines;  // moved inward by a hand's depth if it has any
    EdgeTree tree;
  };
  static Sample sample_of(const Polygon& polygon, const Stands* stands,
                          const std::vector<std::uint32_t>& edges);
  std::vector<Candidate> in_order(std::vector<Candidate> found) const;

  const Polygon& polygon_;
  const Stands* stands_;
  Sample all_;
  std::vector<Sample> samples_;  // the smallest first
  double size_ = 0;              // the largest coordinate
};

}  // namespace evenlift
