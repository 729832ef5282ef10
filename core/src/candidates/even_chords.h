// Even candidates about many centres, one after another. The ends of an even chord about a centre M
// are where the outline meets its mirror image in M. A tree of boxes finds these places without
// visiting every edge; the usual rules then decide which of the places give candidates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/stands.h"
#include "polygon/clip.h"

namespace evenlift {

class EvenChords {
 public:
  // The polygon and the stands must outlive the EvenChords. With stands, the candidates are those
  // of standing_candidates(). O(n).
  explicit EvenChords(const Polygon& polygon, const Stands* stands = nullptr);

  // Also prepares for some_about(). `walk` contains all edges in order along the outline, beginning
  // at a vertex that does not depend on the order of the vertex list. O(n).
  EvenChords(const Polygon& polygon, const Stands* stands, const std::vector<std::uint32_t>& walk);

  // Returns all even candidates about a centre, which may be anywhere. They are those of
  // find_candidates(polygon, centre, 1), but without a limit on their number. An end of a chord
  // between two vertices may name the other of the two edges at its vertex. If the outline hardly
  // winds: O(log n) for each place where it meets its mirror image, O(n) in all at worst.
  std::vector<Candidate> about(const Vec2& centre) const;

  // Returns even candidates about the centre: those between the edges of one sample, or all of them
  // if no sample has enough_chords candidates. If the outline has more than 1,000 edges, there are
  // samples with a half, a quarter, an eighth and so on of the edges, and the smallest one with
  // enough candidates, duplicates included, is used. Only an edge's number in the walk decides
  // which samples contain the edge. A strongly winding outline may have a hundred thousand even
  // chords about one centre, but a search needs only some of them. O(log n) for each place where
  // the sample meets its mirror image. Adds the work to `compared`, about the
  // number of boxes and edges compared.
  static constexpr std::size_t enough_chords = 32;
  std::vector<Candidate> some_about(const Vec2& centre, std::uint64_t& compared) const;

  // Returns the number of even candidates, duplicates included, but at most `most`. On a strongly
  // winding outline the count soon reaches `most`, so this function is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  // Some edges, in the order of their numbers.
  struct Sample {
    std::vector<std::uint32_t> edges;
    std::vector<LineEnds> lines;  // the edges, moved inward by the depth of the hand, if any
    EdgeTree tree;
  };
  static Sample sample_of(const Polygon& polygon, const Stands* stands,
                          const std::vector<std::uint32_t>& edges);
  std::vector<Candidate> about(const Vec2& centre, std::uint64_t& compared) const;
  std::vector<Candidate> in_order(const std::vector<Candidate>& found) const;

  const Polygon& polygon_;
  const Stands* stands_;
  Sample all_;
  std::vector<Sample> samples_;  // the smallest first
  double size_ = 0;              // the largest absolute value of a coordinate
};

}  // namespace evenlift
