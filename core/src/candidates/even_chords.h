// Even candidates about many centres, one after another: the ends of an even chord about M are
// where the outline meets its mirror image in M. A tree of boxes over the outline finds these
// places without looking at every edge, and what is found there is decided as for any candidate.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/stands.h"
#include "polygon/edge_tree.h"

namespace evenlift {

class EvenChords {
 public:
  // The polygon must outlive it, and so must the stands of robots with a size, if there are any: then
  // the candidates are those of standing_candidates(). O(n).
  explicit EvenChords(const Polygon& polygon, const Stands* stands = nullptr);

  // The very same as find_candidates(polygon, centre, 1), except that there is no limit of their
  // number, and that of equal chords between two vertices another may be the one that stays: its
  // ends are the same, but may name the other edges of these vertices. The centre may be anywhere.
  // O(n) at worst; for an outline that does not wind much, O(log n) for each place where it meets
  // its mirror image.
  std::vector<Candidate> about(const Vec2& centre) const;

  // How many of them there are before duplicates are merged, counted to `most` at the most. An
  // outline that winds much has so many soon, so that this is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  const Polygon& polygon_;
  const Stands* stands_;
  std::vector<std::uint32_t> edges_;  // of the lines
  std::vector<LineEnds> lines_;       // the edges, or with a hand's depth where it lifts
  EdgeTree tree_;
  double size_ = 0;  // the largest coordinate
};

}  // namespace evenlift
