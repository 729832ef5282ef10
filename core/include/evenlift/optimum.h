// The best choice of teams among the candidates: how far the greedy choice is from it
// (algorithm.md, The optimum).
//
// C lies in H, so the area of P in H is a sum over the edges of H: of the area of P in each edge's
// triangle with C. Any ring of ends about C, each seen less than 180 degrees after the one before,
// covers no more than the hull of its ends. So the greatest coverage of t teams is the greatest sum
// of such triangles over all rings of ends of at most t chords, and dynamic programming finds it.
//
// This dynamic programme does not ask whether robots with a size get into each other's way. Of such
// robots it gives a bound of what they can cover, and choices of which only those count that have
// room.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/exchange.h"
#include "evenlift/polygon.h"

namespace evenlift {

struct Optimum {
  std::vector<std::uint32_t> taken;  // the candidates of the best choice that was found, increasing
  double coverage = 0;               // of that choice, 0 .. 1
  double bound = 1;                  // no choice covers more, up to rounding
  bool proved = false;               // whether no choice is better
};

// Asked now and then; true ends the computation, and the bound is then what all candidates cover.
using Stop = std::function<bool()>;

// The numbers of candidates up to which a choice is proved to be the best, and up to which there is
// a bound better than the hull of all ends.
inline constexpr std::size_t most_candidates_proved = 160, most_candidates_bounded = 600;

// The choice of `teams` teams, or all candidates if there are fewer, that covers most. `candidates`
// are in candidate order, and `start` is a choice of as many, which counts if nothing better is
// found. With `stands` no choice counts whose robots get into each other's way, but the bound is
// that of all. For K candidates O(n K^2 + K^4 teams) up to most_candidates_proved. With more the
// ends of a chord are taken one by one, as if each had a team of its own, in O(n K^2 + K^3 teams).
// That gives a bound, and the best choice if its ends belong to few enough chords. Beyond
// most_candidates_bounded the bound is what all candidates cover, in O(n K) at worst.
Optimum widest_choice(const Polygon& polygon, const Vec2& centre,
                      const std::vector<Candidate>& candidates, std::size_t teams,
                      const std::vector<std::uint32_t>& start, const Stop& stop = {},
                      const Stands* stands = nullptr);

// The number of choices that firmest_choice() can compare.
inline constexpr std::uint64_t most_choices = std::uint64_t{1} << 22;

struct FirmestChoice {
  std::vector<std::uint32_t> taken;
  HoldKeys keys;
  // No choice reaches a higher level, nor covers more, up to rounding.
  std::uint32_t most_level = 3;
  double most_coverage = 1;
  bool compared = false;  // whether all choices were compared
  // Whether no choice is better: by all keys if all were compared, or else by level and coverage.
  bool proved = false;
};

// The best choice by the keys of teams that are to hold (exchange.h), of all choices of `teams`
// teams. With more than `most` of them it is the best that exchanges come to from `start` and from
// the widest choice, and bounded: by the level of all candidates at once, up to
// most_candidates_bounded, and by the bound of the widest choice. `start` is a choice of as many,
// which counts if none is better. Nothing if `start` has no team or more than most_exchanged_teams.
// With `stands` only choices count whose robots do not get into each other's way.
std::optional<FirmestChoice> firmest_choice(
    const Polygon& polygon, const Vec2& centre, const std::vector<Candidate>& candidates,
    std::size_t teams, const std::vector<std::uint32_t>& start, const FirmHold& firm,
    const Optimum& widest, const Stands* stands = nullptr, std::uint64_t most = most_choices);

}  // namespace evenlift
