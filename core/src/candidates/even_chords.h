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
  // The polygon must outlive it, and so must the stands of robots with a size, if there are any:
  // then the candidates are those of standing_candidates(). O(n).
  explicit EvenChords(const Polygon& polygon, const Stands* stands = nullptr);

  // The same, ready for some_about(). `walk` are all edges in their order along the outline,
  // beginning at a place that does not depend on how the vertices are listed. O(n).
  EvenChords(const Polygon& polygon, const Stands* stands, const std::vector<std::uint32_t>& walk);

  // The very same as find_candidates(polygon, centre, 1), except that there is no limit of their
  // number, and that of equal chords between two vertices another may be the one that stays: its
  // ends are the same, but may name the other edges of these vertices. The centre may be anywhere.
  // O(n) at worst; for an outline that does not wind much, O(log n) for each place where it meets
  // its mirror image.
  std::vector<Candidate> about(const Vec2& centre) const;

  // All of them, or some if there are many: those between edges of a sample, the smallest of a
  // half, a quarter, an eighth and so on of all edges between which there are at least
  // enough_chords. Which edges are in a sample depends on their numbers in the walk alone. An
  // outline that winds much has a hundred thousand even chords about one centre, and some of them
  // serve a search as well. O(log n) for each place where the sample meets its mirror image.
  static constexpr std::size_t enough_chords = 32;
  std::vector<Candidate> some_about(const Vec2& centre) const;

  // How many of them there are before duplicates are merged, counted to `most` at the most. An
  // outline that winds much has so many soon, so that this is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  // Some edges, in the order of their numbers.
  struct Sample {
    std::vector<std::uint32_t> edges;
    std::vector<LineEnds> lines;  // the edges, or with a hand's depth where it lifts
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
