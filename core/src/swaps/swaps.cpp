#include "evenlift/swaps.h"

#include <algorithm>
#include <string>
#include <utility>

#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "grasp/grasp.h"
#include "swaps/rounds.h"

namespace evenlift {
namespace {

using swaps::Better;
using swaps::Choices;
using swaps::Part;
using swaps::Trial;

// A team that keeps its candidate keeps its number.
std::vector<std::uint32_t> arranged(const std::vector<std::uint32_t>& before,
                                    std::vector<std::uint32_t> after) {
  for (std::size_t team = 0; team < before.size(); ++team) {
    const auto same = std::find(after.begin(), after.end(), before[team]);
    if (same != after.end()) std::swap(*same, after[team]);
  }
  return after;
}

// Each free candidate with each part that stays.
std::vector<Trial> trials_with_others(const Choices& choices,
                                      const std::vector<std::uint32_t>& taken) {
  std::vector<char> is_taken(choices.size());
  for (const std::uint32_t candidate : taken) is_taken[candidate] = 1;
  std::vector<Trial> trials;
  for (std::uint32_t candidate = 0; candidate < choices.size() && !choices.is_spent(); ++candidate)
    for (std::uint32_t part = 0; is_taken[candidate] == 0 && part < choices.parts(); ++part)
      if (choices.fit(candidate, choices.size() + part))
        trials.push_back(choices.trial(candidate, choices.size() + part));
  return trials;
}

class Swapper {
 public:
  Swapper(Choices& choices, std::vector<std::uint32_t> start) : choices_(choices) {
    history_.keys = keys_ = choices_.keys_of(choices_.part_of(start));
    history_.start = taken_ = std::move(start);
  }

  SwapHistory run() {
    if (taken_.size() == 2 && choices_.size() <= most_candidates_for_pairs) try_pairs();
    make_swaps();
    // One team fewer may hold where these do not.
    if (keys_.level < best_level && taken_.size() >= 2 && !choices_.is_spent() && try_one_more())
      make_swaps();
    history_.cut_short = choices_.is_spent();
    history_.steps = choices_.steps();
    return std::move(history_);
  }

 private:
  void make_swaps() {
    const std::size_t most_rounds = 4 * taken_.size();
    history_.settled = false;
    while (!history_.settled && rounds_ < most_rounds && history_.tried <= most_swaps &&
           !choices_.is_spent()) {
      history_.settled = !try_swaps() && !choices_.is_spent();
      ++rounds_;
    }
  }

  // Moves both teams to the best two candidates, if better.
  void try_pairs() {
    choices_.set_parts({});
    std::vector<Trial> trials;
    for (std::uint32_t a = 0; a < choices_.size(); ++a)
      for (std::uint32_t b = a + 1; b < choices_.size(); ++b)
        if (choices_.fit(a, b)) trials.push_back(choices_.trial(a, b));
    if (const auto best = find(std::move(trials)))
      take(*best, arranged(taken_, {best->trial.candidate, best->trial.other}), SwapKind::pair);
  }

  // Returns whether there was a swap.
  bool try_swaps() {
    std::vector<Part> parts;
    for (std::size_t team = 0; team < taken_.size(); ++team)
      parts.push_back(choices_.part_of(taken_, team));
    choices_.set_parts(std::move(parts));
    const auto best = find(with_others(taken_));
    if (!best) return false;
    std::vector<std::uint32_t> taken = taken_;
    taken[best->trial.other - choices_.size()] = best->trial.candidate;
    take(*best, std::move(taken), SwapKind::single);
    return true;
  }

  // Replaces all teams by the result for one team fewer and the best further team. Returns whether
  // that is better.
  bool try_one_more() {
    Swapper fewer(choices_, {history_.start.begin(), history_.start.end() - 1});
    const SwapHistory history = fewer.run();
    history_.tried += history.tried;
    std::vector<std::uint32_t> taken = history.taken();
    std::vector<Part> parts;
    parts.push_back(choices_.part_of(taken));
    choices_.set_parts(std::move(parts));
    const auto best = find(with_others(taken));
    if (!best) return false;
    taken.push_back(best->trial.candidate);
    take(*best, arranged(taken_, std::move(taken)), SwapKind::one_more);
    return true;
  }

  std::vector<Trial> with_others(const std::vector<std::uint32_t>& taken) const {
    return trials_with_others(choices_, taken);
  }

  std::optional<Better> find(std::vector<Trial> trials) {
    history_.tried += trials.size();
    return swaps::best_trial(choices_, std::move(trials), keys_);
  }

  void take(const Better& best, std::vector<std::uint32_t> taken, SwapKind kind) {
    std::vector<std::uint32_t> teams;
    for (std::uint32_t team = 0; team < taken.size(); ++team)
      if (taken[team] != taken_[team]) teams.push_back(team);
    taken_ = taken;
    keys_ = best.keys;
    history_.swaps.push_back(
        {kind, std::move(teams), std::move(taken), best.keys, best.decided_by});
  }

  Choices& choices_;
  std::vector<std::uint32_t> taken_;
  HoldKeys keys_;
  std::size_t rounds_ = 0;
  SwapHistory history_;
};

}  // namespace

std::optional<HoldKey> better_by(const HoldKeys& a, const HoldKeys& b) {
  if (a.level != b.level) return a.level > b.level ? std::optional(HoldKey::level) : std::nullopt;
  if (a.coverage > b.coverage + coverage_tie) return HoldKey::coverage;
  if (b.coverage > a.coverage + coverage_tie) return std::nullopt;
  return a.ratios > b.ratios + tau ? std::optional(HoldKey::ratios) : std::nullopt;
}

HoldKeys hold_keys(const PolygonWithHoles& object, const Vec2& centre,
                   const std::vector<Candidate>& candidates,
                   const std::vector<std::uint32_t>& taken, const HoldRequirements& hold,
                   const Stands* stands) {
  const Choices choices(object, centre, candidates, hold, stands);
  return choices.keys_of(choices.part_of(taken));
}

std::optional<InputError> check_swaps(std::size_t candidates, std::size_t teams,
                                      const Stands* stands) {
  const std::size_t placed = teams < candidates ? teams : candidates;
  if (placed == candidates && !stands) return std::nullopt;
  if (placed > most_swapped_teams)
    return setting_error(Setting::goal,
                         say("at most {most} teams can be swapped for a hold, not {teams}",
                             {most_swapped_teams, placed}));
  if (static_cast<std::uint64_t>(placed) * candidates > most_swaps)
    return setting_error(
        Setting::goal, say("the object has {candidates} candidates, too many to swap {teams} teams "
                           "among them for a hold; raise the minimum load ratio",
                           {candidates, placed}));
  return std::nullopt;
}

SwapHistory swap_teams(const PolygonWithHoles& object, const Vec2& centre,
                       const std::vector<Candidate>& candidates, std::vector<std::uint32_t> start,
                       const HoldRequirements& hold, const Stands* stands) {
  if (start.size() == candidates.size() || start.empty()) {
    SwapHistory history;
    if (!start.empty() && start.size() <= most_swapped_teams)
      history.keys = hold_keys(object, centre, candidates, start, hold, stands);
    history.start = std::move(start);
    history.settled = true;
    return history;
  }
  Choices choices(object, centre, candidates, hold, stands);
  return Swapper(choices, std::move(start)).run();
}

std::optional<Swap> best_swap_of(const PolygonWithHoles& object, const Vec2& centre,
                                 const std::vector<Candidate>& candidates,
                                 const std::vector<std::uint32_t>& taken, std::uint32_t team,
                                 const HoldRequirements& hold, const Stands* stands) {
  Choices choices(object, centre, candidates, hold, stands);
  const HoldKeys now = choices.keys_of(choices.part_of(taken));
  choices.set_parts({choices.part_of(taken, team)});
  const auto best = swaps::best_trial(choices, trials_with_others(choices, taken), now);
  if (!best) return std::nullopt;
  Swap swap{SwapKind::single, {team}, taken, best->keys, best->decided_by};
  swap.taken[team] = best->trial.candidate;
  return swap;
}

ChosenTeams choose_candidates(const PolygonWithHoles& object, const Vec2& centre,
                              const std::vector<Candidate>& candidates, const Settings& settings,
                              std::size_t teams, const Stands* stands) {
  std::vector<std::uint32_t> taken =
      select_teams(object, centre, candidates, *metric_of(settings.method), teams,
                   first_team(settings.positions), stands);
  if (!swaps_teams(settings)) return {std::move(taken)};
  const SwapHistory history = swap_teams(object, centre, candidates, std::move(taken),
                                         hold_requirements(object, centre, settings), stands);
  return {history.taken(), history.cut_short, static_cast<double>(history.steps) / most_swap_steps};
}

}  // namespace evenlift
