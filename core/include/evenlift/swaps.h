// Swaps teams of two so that they hold the object if possible, with the required margin
// (algorithm.md, Choosing teams that hold). This goes beyond the thesis, which considers only the
// lifting base.
//
// A local search begins with the teams that a metric selects. Two choices with the same number of
// teams are compared by these keys; the first key that is not a tie decides which is better:
// 1. the `level`, the number of thresholds that the margin of a firm hold (closure.h) reaches;
// 2. the coverage, larger by more than 1e-9;
// 3. the sum of the load ratios, larger by more than tau.
// The margin is that of the contacts at least `clear` from every corner. The thresholds are 0.001,
// 0.4 mu and mu, where mu is the minimum margin.
//
// A swap moves a team to a candidate that no team has. Each round makes the best of the swaps that
// make the choice better. If there are two teams and at most most_candidates_for_pairs candidates,
// the search begins by moving both teams to the best pair of candidates, if that makes the choice
// better. The search ends after a round without a swap, after 4 t rounds for t teams, or after the
// round in which the number of choices compared exceeds most_swaps.
//
// If the level is then below 3, the same search is made for t - 1 teams, and the best further
// candidate is added to its result. If this choice is better, it replaces the t teams, and swaps
// continue within the same 4 t rounds. So one more team never lowers the level, unless robots with
// a size find no room for it. All of this ends when the work exceeds most_swap_steps, without the
// round under way. Work is counted, not timed, in steps as for balanced robots (BalancedWork in
// balanced.h): for each choice, each of its coverages and each of its margins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/closure.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/result.h"

namespace evenlift {

class Stands;

inline constexpr std::uint32_t most_swapped_teams = 32;
inline constexpr std::uint64_t most_swaps = std::uint64_t{1} << 22;
inline constexpr std::uint64_t most_swap_steps = 250'000'000;
inline constexpr std::size_t most_candidates_for_pairs = 100;

// The keys by which choices of teams are compared.
struct HoldKeys {
  std::uint32_t level = 0;  // 0 .. 3
  double coverage = 0;
  double ratios = 0;  // the sum of the load ratios
};
enum class HoldKey : std::uint8_t { level, coverage, ratios };

// The key that makes a choice with the keys `a` better than a choice with the keys `b`; empty if it
// is not better. Both choices must have the same number of teams. O(1).
std::optional<HoldKey> better_by(const HoldKeys& a, const HoldKeys& b);

// The keys of the teams on the candidates `taken`. There must be no more than most_swapped_teams.
// With `stands`, the contacts of the robots (stands.h), not their lifting points, hold the object.
// O(n log n + K log n), and O(n) for each corner of H at worst.
HoldKeys hold_keys(const PolygonWithHoles& object, const Vec2& centre,
                   const std::vector<Candidate>& candidates,
                   const std::vector<std::uint32_t>& taken, const HoldRequirements& hold,
                   const Stands* stands = nullptr);

// The teams that a swap moves: one team (`single`), two at once (`pair`), or all (`one_more`). With
// `one_more`, they take the candidates chosen for t - 1 teams and the best further candidate.
enum class SwapKind : std::uint8_t { single, pair, one_more };

struct Swap {
  SwapKind kind = SwapKind::single;
  std::vector<std::uint32_t> teams;  // the teams that moved, increasing
  std::vector<std::uint32_t> taken;  // the candidates of all teams afterwards
  HoldKeys keys;                     // those of the choice afterwards
  HoldKey decided_by = HoldKey::level;
};

struct SwapHistory {
  std::vector<std::uint32_t> start;  // the candidates of the teams at the start
  HoldKeys keys;                     // those of the choice at the start; not computed for more
                                     // than most_swapped_teams
  std::vector<Swap> swaps;
  bool settled = false;     // whether the last round found nothing better
  bool cut_short = false;   // whether most_swap_steps ended the search
  std::uint64_t steps = 0;  // the work
  std::uint64_t tried = 0;  // the number of choices compared

  const std::vector<std::uint32_t>& taken() const {
    return swaps.empty() ? start : swaps.back().taken;
  }
};

// Checks the limits on swaps. It is an error if there are more than most_swapped_teams teams, or
// more than most_swaps swaps in a round. If every candidate has a team, there is nothing to swap
// and no error. With `stands`, however, some teams may find no room, so the limits always apply.
// O(1).
std::optional<InputError> check_swaps(std::size_t candidates, std::size_t teams,
                                      const Stands* stands = nullptr);

// Swaps teams, beginning with those on the candidates `start`; the result is never worse. With
// `stands`, only choices whose robots do not collide are tried. check_swaps() must allow the swaps.
// For t teams among K candidates, a round has O(t K) swaps; a bound alone rules out most of them.
// With the searches for fewer teams, there are O(t^2) rounds at worst.
SwapHistory swap_teams(const PolygonWithHoles& object, const Vec2& centre,
                       const std::vector<Candidate>& candidates, std::vector<std::uint32_t> start,
                       const HoldRequirements& hold, const Stands* stands = nullptr);

// The best swap of this team, as in a round of swap_teams(); empty if no swap of the team makes the
// choice better.
std::optional<Swap> best_swap_of(const PolygonWithHoles& object, const Vec2& centre,
                                 const std::vector<Candidate>& candidates,
                                 const std::vector<std::uint32_t>& taken, std::uint32_t team,
                                 const HoldRequirements& hold, const Stands* stands = nullptr);

// The teams for these settings, as indices into `candidates`, whether the swaps were cut short, and
// the part of their limit of work that they took (about 1 if they were cut short). The method
// must choose among candidates. The teams are selected (selection.h) and, if the goal is to hold,
// swapped; in that case check_swaps() must allow the swaps.
struct ChosenTeams {
  std::vector<std::uint32_t> taken;
  bool cut_short = false;
  double work = 0;
};
ChosenTeams choose_candidates(const PolygonWithHoles& object, const Vec2& centre,
                              const std::vector<Candidate>& candidates, const Settings& settings,
                              std::size_t teams, const Stands* stands = nullptr);

}  // namespace evenlift
