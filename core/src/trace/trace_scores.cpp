// The scores of a choice, by the selection's own gain functions.
#include "evenlift/trace.h"
#include "exact/sorted_indices.h"
#include "selection/greedy_selector.h"
#include "selection/rules.h"

namespace evenlift {
namespace {

// Repeats the selection. A candidate's `stage` is the number of keys that it survived.
class Tournament {
 public:
  Tournament(const std::vector<Candidate>& candidates, const TeamScores& scores, double floor)
      : candidates_(candidates),
        scores_(scores),
        keys_(keys_of(scores.rule)),
        stage_(candidates.size()) {
    std::vector<std::uint32_t> in_play;
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
      const Score& score = scores.of_candidate[i];
      if (score.taken || score.collides) continue;
      left_.push_back(i);
      if (score.eligible && score.exact) in_play.push_back(i);
    }
    for (const Key key : keys_) {
      keep_best(in_play, key, floor, [&](std::uint32_t i) { return value(key, i); });
      for (const std::uint32_t i : in_play) ++stage_[i];
    }
  }

  std::vector<std::uint32_t> ranking() const {
    std::vector<std::uint32_t> ranking;
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
      return comes_first(left_[i], left_[j]);
    };
    for (const std::uint32_t i : sorted_indices(left_.size(), before)) ranking.push_back(left_[i]);
    return ranking;
  }

  DecidedBy lost_by(std::uint32_t i) const {
    if (stage_[i] == keys_.size()) return DecidedBy::order;
    if (stage_[i] == 0) return DecidedBy::first_key;
    return keys_[stage_[i]] == Key::ratio ? DecidedBy::ratio : DecidedBy::length;
  }

 private:
  double value(Key key, std::uint32_t i) const {
    return value_of(key, candidates_[i], scores_.of_candidate[i].value);
  }

  bool comes_first(std::uint32_t i, std::uint32_t j) const {
    if (stage_[i] != stage_[j]) return stage_[i] > stage_[j];
    const Score &a = scores_.of_candidate[i], &b = scores_.of_candidate[j];
    if (a.eligible != b.eligible) return a.eligible;
    if (stage_[i] < keys_.size())
      for (const Key key : keys_)
        if (value(key, i) != value(key, j)) return value(key, i) > value(key, j);
    return i < j;
  }

  const std::vector<Candidate>& candidates_;
  const TeamScores& scores_;
  std::span<const Key> keys_;
  std::vector<std::uint32_t> left_;  // can still be taken
  std::vector<std::uint8_t> stage_;
};

void score_first_team(const std::vector<Candidate>& candidates, FirstTeam first,
                      TeamScores& scores) {
  scores.rule = rule_of_first_team(candidates, first);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Score& score = scores.of_candidate[i];
    score.value = value_of(keys_of(scores.rule).front(), candidates[i], 0);
    score.eligible = is_eligible(scores.rule, candidates[i].chord.ratio);
  }
}

double score_further_team(const Trace& trace, TeamScores& scores) {
  const Placement& placement = trace.placement;
  const std::vector<Candidate>& candidates = placement.candidates;
  Selector selector(trace.object(), trace.centre, candidates, trace.metric(), FirstTeam::even,
                    placement.stands.get());
  for (std::uint32_t i = 0; i < scores.team; ++i) {
    const std::uint32_t taken = trace.selected()[i];
    selector.take(taken);
    scores.of_candidate[taken].taken = true;
  }
  for (std::uint32_t i = 0; i < candidates.size(); ++i)
    scores.of_candidate[i].collides = selector.dropped_out(i);
  selector.compare();
  const bool all = std::uint64_t{candidates.size()} * trace.polygon().size() <= exact_score_budget;
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
  const Tournament tournament(candidates, scores, floor);
  scores.ranking = tournament.ranking();
  if (scores.ranking.size() > 1) scores.decided_by = tournament.lost_by(scores.ranking[1]);
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
