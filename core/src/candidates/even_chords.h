// Even candidates about many centres, one after another. The ends of an even chord about M are
// where the outline meets its mirror image in M. A tree of boxes over the outline finds these
// places without visiting every edge; the candidates there are decided like all others.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/stands.h"
#include "polygon/edge_tree.h"

namespace evenlift {

class EvenChords {
 public:
  // The polygon must outlive it, and so must the stands of robots with a size, if given. With
  // stands the candidates are those of standing_candidates(). O(n).
  explicit EvenChords(const Polygon& polygon, const Stands* stands = nullptr);

  // Prepares for some_about() also. `walk` contains all edges in their order along the outline,
  // beginning at a place that does not depend on the order of the vertex list. O(n).
  EvenChords(const Polygon& polygon, const Stands* stands, const std::vector<std::uint32_t>& walk);

  // Equals find_candidates(polygon, centre, 1), with two exceptions. The number of candidates is
  // not limited. Of equal chords between two vertices another may be kept: its ends are the same,
  // but may name the other edges of these vertices. The centre may be anywhere. O(n) at worst; for
  // an outline that does not wind much, O(log n) for each place where it meets its mirror image.
  std::vector<Candidate> about(const Vec2& centre) const;

  // All even candidates about the centre, or some if there are many: the candidates between the
  // edges of a sample. The samples are a half, a quarter, an eighth and so on of all edges; the
  // smallest with at least enough_chords candidates is used. An edge's number in the walk alone
  // decides whether it is in a sample. A strongly winding outline may have a hundred thousand even
  // chords about one centre, and some of them serve a search just as well. O(log n) for each place
  // where the sample meets its mirror image.
  static constexpr std::size_t enough_chords = 32;
  std::vector<Candidate> some_about(const Vec2& centre) const;

  // The number of even candidates before duplicates are merged, at most `most`. A strongly winding
  // outline soon reaches `most`, so this is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  // Some edges, in the order of their numbers.
  struct Sample {
    std::vector<std::uint32_t> edges;
    std::vector<LineEnds> lines;  // the edges, moved inward by a hand's depth if it has any
    EdgeTree tree;
  };
  static Sample sample_of(const Polygon& polygon, const Stands* stands,
                          const std::vector<std::uint32_t>& edges);
  std::vector<Candidate> in_order(std::vector<Candidate> found) const;

  const Polygon& polygon_;
  const Stands* stands_;
  Sample all_;
  std::vector<Sample> samples_;  // from the smallest to the largest
  double size_ = 0;              // the largest coordinate
};

}  // namespace evenlift
