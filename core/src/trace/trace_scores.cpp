// The detail of a choice: the score of every candidate, by the selection's own gain functions.
#include <algorithm>
#include <array>

#include "evenlift/selection.h"
#include "evenlift/tolerance.h"
#include "evenlift/trace.h"
#include "exact/sorted_indices.h"
#include "selection/greedy_selector.h"

namespace evenlift {
namespace {

enum class Quantity : std::uint8_t { score, ratio, length };

struct Key {
  Quantity quantity;
  DecidedBy decided_by;  // the answer where candidates differ in it
};

using Keys = std::array<Key, 3>;

// A first team has only two different keys; its third repeats one of them and tells nothing new.
constexpr Keys by_length{{{Quantity::length, DecidedBy::first_key},
                          {Quantity::ratio, DecidedBy::ratio},
                          {Quantity::length, DecidedBy::length}}};
constexpr Keys by_ratio{{{Quantity::ratio, DecidedBy::first_key},
                         {Quantity::length, DecidedBy::length},
                         {Quantity::ratio, DecidedBy::length}}};
constexpr Keys by_score{{{Quantity::score, DecidedBy::first_key},
                         {Quantity::ratio, DecidedBy::ratio},
                         {Quantity::length, DecidedBy::length}}};

// There is no default, so that the compiler asks for the keys of each rule.
const Keys& keys_of(Rule rule) {
  switch (rule) {
    case Rule::longest_even:
    case Rule::longest:
      return by_length;
    case Rule::most_even:
      return by_ratio;
    case Rule::score:
      break;
  }
  return by_score;
}

// The selection's tournament: at each key the candidates that tie with the best stay in. A
// candidate's `stage` is the number of keys that it survived.
class Tournament {
 public:
  Tournament(const std::vector<Candidate>& candidates, TeamScores& scores, double floor)
      : candidates_(candidates), scores_(scores), floor_(floor), stage_(candidates.size()) {}

  void run() {
    for (std::uint32_t i = 0; i < candidates_.size(); ++i)
      if (!scores_.of_candidate[i].taken && !scores_.of_candidate[i].collides)
        scores_.ranking.push_back(i);
    for (std::uint32_t key = 0; key < 3; ++key) play(key);
    const std::vector<std::uint32_t> left = std::move(scores_.ranking);
    scores_.ranking.clear();
    for (const std::uint32_t i : sorted_indices(left.size(), [&](std::uint32_t i, std::uint32_t j) {
           return comes_first(left[i], left[j]);
         }))
      scores_.ranking.push_back(left[i]);
    scores_.decided_by =
        scores_.ranking.size() < 2 ? DecidedBy::only_one : lost_by(scores_.ranking[1]);
  }

  // The key at which a candidate that did not win was out.
  DecidedBy lost_by(std::uint32_t i) const {
    return stage_[i] < 3 ? keys()[stage_[i]].decided_by : DecidedBy::order;
  }

 private:
  const Keys& keys() const { return keys_of(scores_.rule); }

  double key(std::uint32_t i, std::uint32_t which) const {
    switch (keys()[which].quantity) {
      case Quantity::ratio:
        return candidates_[i].chord.ratio;
      case Quantity::length:
        return candidates_[i].length;
      case Quantity::score:
        break;
    }
    return scores_.of_candidate[i].value;
  }

  bool ties(double best, double value, std::uint32_t which) const {
    switch (keys()[which].quantity) {
      case Quantity::ratio:
        return ratios_tie(best, value);
      case Quantity::length:
        return lengths_tie(best, value);
      case Quantity::score:
        break;
    }
    return scores_tie(best, value, floor_);
  }

  void play(std::uint32_t which) {
    const auto in_play = [&](std::uint32_t i) {
      return stage_[i] == which && scores_.of_candidate[i].eligible &&
             scores_.of_candidate[i].exact;
    };
    double best = 0;
    bool any = false;
    for (const std::uint32_t i : scores_.ranking) {
      if (!in_play(i)) continue;
      best = any ? std::max(best, key(i, which)) : key(i, which);
      any = true;
    }
    for (const std::uint32_t i : scores_.ranking)
      if (in_play(i) && ties(best, key(i, which), which)) ++stage_[i];
  }

  bool comes_first(std::uint32_t i, std::uint32_t j) const {
    if (stage_[i] != stage_[j]) return stage_[i] > stage_[j];
    const Score &a = scores_.of_candidate[i], &b = scores_.of_candidate[j];
    if (a.eligible != b.eligible) return a.eligible;
    if (stage_[i] < 3)
      for (std::uint32_t which = 0; which < 3; ++which)
        if (key(i, which) != key(j, which)) return key(i, which) > key(j, which);
    return i < j;
  }

  const std::vector<Candidate>& candidates_;
  TeamScores& scores_;
  double floor_;
  std::vector<std::uint8_t> stage_;
};

void score_first_team(const std::vector<Candidate>& candidates, FirstTeam first,
                      TeamScores& scores) {
  if (first == FirstTeam::longest) {
    scores.rule = Rule::longest;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      scores.of_candidate[i].value = candidates[i].length;
    return;
  }
  const bool any_even = std::any_of(candidates.begin(), candidates.end(),
                                    [](const Candidate& c) { return is_even(c.chord); });
  scores.rule = any_even ? Rule::longest_even : Rule::most_even;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Score& score = scores.of_candidate[i];
    score.value = any_even ? candidates[i].length : candidates[i].chord.ratio;
    score.eligible = !any_even || is_even(candidates[i].chord);
  }
}

double score_further_team(const Trace& trace, TeamScores& scores) {
  const Placement& placement = trace.placement;
  const std::vector<Candidate>& candidates = placement.candidates;
  Selector selector(trace.polygon, trace.centre, candidates, placement.settings.method,
                    ~std::size_t{0}, FirstTeam::even, placement.stands.get());
  for (std::uint32_t i = 0; i < scores.team; ++i) {
    const std::uint32_t taken = trace.selected()[i];
    selector.take(taken);
    scores.of_candidate[taken].taken = true;
  }
  for (std::uint32_t i = 0; i < candidates.size(); ++i)
    scores.of_candidate[i].collides = selector.dropped_out(i);
  selector.compare();
  const bool all = std::uint64_t{candidates.size()} * trace.polygon.size() <= exact_score_budget;
  for (const Vec2& corner : selector.base()) scores.base.push_back(trace.centre + corner);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    Score& score = scores.of_candidate[i];
    if (all) selector.score(i);
    for (std::uint32_t e = 0; e < 2; ++e) {
      const Gain& gain = selector.gain(i, e);
      const Chord& chord = candidates[i].chord;
      EndGain& end = score.ends[e];
      score.exact = score.exact && gain.exact();
      end.p = e == 0 ? chord.r1.position : chord.r2.position;
      end.value = gain.value;
      end.outside = selector.outside(i, e);
      end.h1 = trace.centre + selector.wedge(i, e).h1();
      end.h2 = trace.centre + selector.wedge(i, e).h2();
    }
    score.value = score.ends[0].value + score.ends[1].value;
  }
  return selector.floor();
}

}  // namespace

TeamScores look_at_scores(const Trace& trace, std::uint32_t team) {
  const std::vector<Candidate>& candidates = trace.placement.candidates;
  TeamScores scores;
  scores.team = team;
  scores.of_candidate.resize(candidates.size());
  double floor = 0;
  if (team == 0) {
    score_first_team(candidates, first_team(trace.placement.settings.positions), scores);
  } else {
    floor = score_further_team(trace, scores);
  }
  Tournament tournament(candidates, scores, floor);
  tournament.run();
  for (std::uint32_t i = 0; i < candidates.size(); ++i)
    scores.of_candidate[i].lost_by = tournament.lost_by(i);
  return scores;
}

std::vector<std::uint32_t> best_ranked(const TeamScores& scores) {
  std::vector<std::uint32_t> best;
  for (const std::uint32_t c : scores.ranking)
    if (scores.of_candidate[c].eligible && best.size() < most_ranked_numbered) best.push_back(c);
  return best;
}

}  // namespace evenlift
