// Teams of two that are exchanged until they hold the object (algorithm.md, Choosing so that it
// holds). This is beyond the thesis, whose choice looks at the lifting base alone.
//
// It is a local search that begins with the teams that a metric selects. Of two choices of equally
// many teams that one is better which is ahead in the first key in which they differ:
// 1. the level: how many of 0.001, 0.4 mu and mu the margin reaches, mu being the minimum margin;
// 2. the coverage, the larger by more than 1e-9;
// 3. the sum of the load ratios, the larger by more than tau.
// In an exchange a team goes to a candidate that no team has. Each round makes the best of the
// exchanges that make the choice better; of those that tie in all keys, the one to the first
// candidate in candidate order, and then the one of the first team. Two teams among at most
// most_candidates_for_pairs candidates begin by going to the best of all pairs, if that is better.
// The search ends with a round without an exchange, with the 4 t-th round of t teams, or when more
// than most_exchanges choices were compared. If the level is below 3 then, the same is done for t -
// 1 teams. What they come to with the best further candidate replaces the t teams if it is better,
// and exchanges go on within the same 4 t rounds. So one team more never loses a level, though the
// teams may be others; only for one more team of robots with a size there may be no room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/closure.h"
#include "evenlift/document.h"
#include "evenlift/polygon.h"
#include "evenlift/result.h"

namespace evenlift {

class Stands;

inline constexpr std::uint32_t most_exchanged_teams = 32;
inline constexpr std::uint64_t most_exchanges = std::uint64_t{1} << 22;
inline constexpr std::size_t most_candidates_for_pairs = 100;

// The keys of a choice of teams.
struct HoldKeys {
  std::uint32_t level = 0;  // 0 .. 3
  double coverage = 0;
  double ratios = 0;  // the sum of the load ratios
};
enum class HoldKey : std::uint8_t { level, coverage, ratios };

// The first key in which a choice is better than another of equally many teams; nothing if it is
// not better. O(1).
std::optional<HoldKey> better_by(const HoldKeys& a, const HoldKeys& b);

// The keys of the teams on some candidates, of which there are at most most_exchanged_teams; with
// `stands` those of robots with a size, which hold the object where they touch it. O(n log n + K
// log n), and O(n) for each corner of H at worst.
HoldKeys hold_keys(const Polygon& polygon, const Vec2& centre,
                   const std::vector<Candidate>& candidates,
                   const std::vector<std::uint32_t>& taken, const FirmHold& firm,
                   const Stands* stands = nullptr);

// What was exchanged: one team, both of two at once, or all for what one team fewer came to with
// one more.
enum class ExchangeKind : std::uint8_t { single, pair, one_more };

struct Exchange {
  ExchangeKind kind = ExchangeKind::single;
  std::vector<std::uint32_t> teams;  // the numbers of those that went elsewhere, increasing
  std::vector<std::uint32_t> taken;  // the candidates of all teams afterwards
  HoldKeys keys;                     // afterwards
  HoldKey decided_by = HoldKey::level;
};

struct ExchangeHistory {
  std::vector<std::uint32_t> start;  // the candidates of the teams
  HoldKeys keys;                     // at the start
  std::vector<Exchange> exchanges;   // in their order
  bool settled = false;              // the last round found nothing better
  std::uint64_t tried = 0;           // choices that were compared

  const std::vector<std::uint32_t>& taken() const {
    return exchanges.empty() ? start : exchanges.back().taken;
  }
};

// The error if so many teams among so many candidates cannot be exchanged: there are more than
// most_exchanged_teams, or a round would have more than most_exchanges exchanges. None if all
// candidates are taken, since there is nothing to exchange; but with `stands` some teams may find
// no room. O(1).
std::optional<InputError> check_exchanges(std::size_t candidates, std::size_t teams,
                                          const Stands* stands = nullptr);

// Exchanges the teams. The choice is never worse than its start. With `stands` only choices are
// tried whose robots do not get into each other's way. For t teams among K candidates at most 4 t
// rounds of O(t K) exchanges, of which few need more than a bound; and where the level stays below
// 3, as much again for t - 1 teams, and so on, so that there are O(t^2) rounds at worst.
// check_exchanges() must allow them.
ExchangeHistory exchange_teams(const Polygon& polygon, const Vec2& centre,
                               const std::vector<Candidate>& candidates,
                               std::vector<std::uint32_t> start, const FirmHold& firm,
                               const Stands* stands = nullptr);

// The best exchange of one team alone; nothing if none makes the choice better. Like one round of
// exchange_teams(), but of one team.
std::optional<Exchange> best_exchange_of(const Polygon& polygon, const Vec2& centre,
                                         const std::vector<Candidate>& candidates,
                                         const std::vector<std::uint32_t>& taken,
                                         std::uint32_t team, const FirmHold& firm,
                                         const Stands* stands = nullptr);

// The teams that the settings ask for, of a method that chooses among candidates: selected
// (selection.h), and exchanged if they are to hold; then check_exchanges() must allow it. Returns
// indices into `candidates`.
std::vector<std::uint32_t> choose_candidates(const Polygon& polygon, const Vec2& centre,
                                             const std::vector<Candidate>& candidates,
                                             const Settings& settings, std::size_t teams,
                                             const Stands* stands = nullptr);

}  // namespace evenlift
