// Even candidates about many centres. An even chord about M ends where the outline meets its mirror
// image in M. A tree of boxes finds these places without visiting every edge; the candidates there
// are decided like all others.
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

  // All even candidates about a centre, which may be anywhere: those of find_candidates(polygon,
  // centre, 1), but without a limit on their number. A chord between two vertices may name the
  // other edges of these vertices. O(n) at worst; for an outline that hardly winds, O(log n) for
  // each place where the outline meets its mirror image.
  std::vector<Candidate> about(const Vec2& centre) const;

  // Even candidates about the centre: those between edges of one sample, or all of them if no
  // sample has enough_chords candidates. The samples hold a half, a quarter, an eighth and so on of
  // all edges, and the smallest with enough candidates is used. Only an edge's number in the walk
  // decides which samples contain it. A strongly winding outline may have a hundred thousand even
  // chords about one centre, and a search needs only some of them. O(log n) for each place where
  // the sample meets its mirror image.
  static constexpr std::size_t enough_chords = 32;
  std::vector<Candidate> some_about(const Vec2& centre) const;

  // The number of even candidates, including duplicates, or `most` if that is less. A strongly
  // winding outline soon reaches `most`, so this is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  // Some edges, in the order of their numbers.
  struct Sample {
    std::vector<std::uint32_t> edges;
    std::vector<LineEnds> lines;  // moved inward by the depth of the hand, if any
    EdgeTree tree;
  };
  static Sample sample_of(const Polygon& polygon, const Stands* stands,
                          const std::vector<std::uint32_t>& edges);
  std::vector<Candidate> in_order(std::vector<Candidate> found) const;

  const Polygon& polygon_;
  const Stands* stands_;
  Sample all_;
  std::vector<Sample> samples_;  // the smallest first
  double size_ = 0;              // the largest absolute value of a coordinate
};

}  // namespace evenlift
