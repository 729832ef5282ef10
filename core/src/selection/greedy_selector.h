// The greedy choice of teams (algorithm.md, Selection).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/document.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"
#include "selection/base_edge.h"
#include "selection/rules.h"

namespace evenlift {

// Lazy greedy evaluation (M. Minoux, Accelerated greedy algorithms for maximizing submodular set
// functions, 1978). Each end of a candidate has an upper bound of its gain. The bound is refined,
// and finally replaced by the gain, only while the candidate can still win. Gains do not always
// diminish here, so an end gets a new bound when the edge of H in front of it changes. While H
// stays the same, so do all gains; the candidates that tie for the best score then wait in a line.
class Selector {
 public:
  // The caller takes at most `most_teams`. The candidates and `stands` must outlive the selector.
  // With `stands`, candidates whose robots collide with a taken team drop out.
  Selector(const PolygonWithHoles& object, const Vec2& centre,
           const std::vector<Candidate>& candidates, Metric metric,
           std::size_t most_teams = ~std::size_t{0}, FirstTeam first = FirstTeam::even,
           const Stands* stands = nullptr);

  // Takes the best candidate left. Returns false if every candidate is taken or has dropped out.
  bool take_next();

  // Takes this candidate, whatever its score.
  void take(std::uint32_t candidate);

  const std::vector<std::uint32_t>& taken() const { return taken_; }

  // Whether the candidate dropped out because it collides with a taken team.
  bool dropped_out(std::uint32_t candidate) const { return states_[candidate] == State::dropped; }

  // The candidate's score after the teams taken so far, of which there must be at least one.
  double score(std::uint32_t candidate);

  // Evaluates candidates like take_next(), but takes none.
  void compare() { find_leaders(); }

  // The known gain of a candidate's end (0: r1, 1: r2), the wedge of the edge of H in front of the
  // end, and whether the end is outside H. At least one team must be taken.
  const Gain& gain(std::uint32_t candidate, std::uint32_t end) const {
    return ends_[2 * candidate + end].gain;
  }
  const Wedge& wedge(std::uint32_t candidate, std::uint32_t end) const {
    return wedges_[ends_[2 * candidate + end].wedge];
  }
  bool outside(std::uint32_t candidate, std::uint32_t end) const {
    return gains(wedge(candidate, end), ends_[2 * candidate + end].position);
  }

  // The corners of H, relative to C.
  const Points& base() const { return hull_; }

  // Scores that differ by at most the floor always tie. For distance, the floor depends on H.
  double floor() const { return floor_; }

 private:
  using Index = std::uint32_t;
  using Indices = std::vector<Index>;

  struct End {
    Vec2 position;  // relative to C
    double pseudo_angle = 0;
    Index wedge = 0;  // into wedges_
    // An end in the direction of a corner of H belongs to both edges there. The larger gain counts,
    // so that mirror images have the same scores.
    std::optional<Index> other_wedge;
    Gain gain;
  };
  enum class State : std::uint8_t { open, taken, dropped };
  bool is_open(Index candidate) const { return states_[candidate] == State::open; }
  Index best_by(Rule rule, Indices indices) const;
  double find_best_score();
  Indices find_leaders();
  bool ties(double best, double score) const {
    return evenlift::ties(Key::score, best, score, floor_);
  }
  double bound(Index candidate) const {
    return ends_[2 * candidate].gain.value + ends_[2 * candidate + 1].gain.value;
  }
  bool exact(Index candidate) const {
    return ends_[2 * candidate].gain.exact() && ends_[2 * candidate + 1].gain.exact();
  }
  double evaluate(const End& end, Index wedge) const;
  void evaluate(End& end);
  void sharpen(Index candidate);
  bool widen_base(Index candidate);
  void enter_wedge(Index index);
  Gain estimate(const End& end) const;
  bool gains(const Wedge& wedge, const Vec2& p) const;
  void line_up(Indices leaders);
  void drop_colliding(Index taken);

  const std::vector<Candidate>& candidates_;
  Surroundings surroundings_;
  Metric metric_;
  std::size_t most_teams_;
  FirstTeam first_;
  double near_;   // tau L
  double floor_;  // see floor()

  std::vector<End> ends_;      // candidate i has the ends 2 i (r1) and 2 i + 1 (r2)
  Indices by_direction_;       // the ends by pseudo-angle
  Points hull_;                // corners of H relative to C, counter-clockwise
  Indices edges_;              // the wedge of each edge, from corner i to i + 1
  std::vector<Wedge> wedges_;  // also those of past edges, so that indices stay valid

  const Stands* stands_;
  std::size_t out_ = 0;        // candidates taken or dropped
  std::vector<State> states_;  // of the candidates
  std::vector<std::uint32_t> taken_;
  Indices line_;                  // candidates to take while H stays the same, in reverse order
  std::size_t best_in_line_ = 0;  // the number of those with exactly the best score
  double best_score_ = 0;
};

}  // namespace evenlift
