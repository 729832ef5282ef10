// The scores of a choice, by the selection's own gain functions.
#include <algorithm>
#include <numeric>

#include "evenlift/trace.h"
#include "evenlift/why_not.h"
#include "exact/sorted_indices.h"
#include "selection/greedy_selector.h"

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

namespace {

const std::vector<std::uint32_t>& taken_before(const Trace& trace, std::uint32_t swap) {
  return swap == 0 ? trace.swaps->start : trace.swaps->swaps[swap - 1].taken;
}

// With several teams, questions alternate between the team that leaves and the place where it goes.
std::optional<QuestionKind> asked_of_swap(const Trace& trace, std::uint32_t number) {
  const Swap& swap = trace.swaps->swaps[number];
  if (swap.kind != SwapKind::single) return std::nullopt;
  if (swap.taken.size() > 1 && number % 2 == 0) return QuestionKind::leaving_team;
  return QuestionKind::coming_candidate;
}

std::vector<std::uint32_t> all_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

std::vector<LiftingPoint> robots_on(const Trace& trace, const std::vector<std::uint32_t>& taken) {
  std::vector<LiftingPoint> robots;
  for (const std::uint32_t candidate : taken)
    for (const LiftingPoint& end : {trace.placement.candidates[candidate].chord.r1,
                                    trace.placement.candidates[candidate].chord.r2})
      robots.push_back(end);
  return robots;
}

// Candidates to which a team could move.
std::vector<std::uint32_t> open_to(const Trace& trace, std::uint32_t swap, std::uint32_t team) {
  std::vector<std::uint32_t> taken = taken_before(trace, swap);
  const Stands* stands = trace.placement.stands.get();
  std::vector<std::uint32_t> open;
  for (const std::uint32_t candidate : all_numbers(trace.placement.candidates.size())) {
    const auto& before = taken_before(trace, swap);
    if (std::find(before.begin(), before.end(), candidate) != before.end()) continue;
    taken[team] = candidate;
    if (!stands || !stands->any_collide(robots_on(trace, taken))) open.push_back(candidate);
  }
  return open;
}

}  // namespace

bool is_choice(const Trace& trace, std::uint32_t k) {
  const Step step = trace.step(k);
  if (step.kind == StepKind::scores)  // one candidate is no choice
    return trace.placement.candidates.size() > step.item + std::size_t{1};
  if (step.kind == StepKind::completion || step.kind == StepKind::exchange)
    return look_at(trace, k).balanced->chords.size() > 1;
  if (step.kind == StepKind::swap) return asked_of_swap(trace, step.item).has_value();
  if (step.kind != StepKind::outcome) return false;
  const Outcome outcome = look_at_pair(trace, step.item).outcome;
  return outcome == Outcome::nearer_end || outcome == Outcome::too_uneven;
}

std::optional<Question> question(const Trace& trace, const StepDetail& detail) {
  if (!is_choice(trace, detail.number)) return std::nullopt;
  if (detail.pair) return Question{QuestionKind::nearer_end, detail.pair->nearer};
  if (detail.balanced) return Question{QuestionKind::even_chord, detail.balanced->chosen};
  if (detail.scores) return Question{QuestionKind::winning_chord, detail.scores->ranking.front()};
  const QuestionKind kind = *asked_of_swap(trace, detail.step.item);
  const SwapDetail& swap = *detail.swap;
  return Question{kind, kind == QuestionKind::leaving_team ? swap.teams[0] : swap.to[0]};
}

std::vector<std::uint32_t> choices(const Trace& trace, const StepDetail& detail,
                                   const Question& question) {
  switch (question.kind) {
    case QuestionKind::nearer_end:
      return all_numbers(2);
    case QuestionKind::even_chord:
      return all_numbers(detail.balanced->chords.size());
    case QuestionKind::leaving_team:
      return all_numbers(taken_before(trace, detail.step.item).size());
    case QuestionKind::coming_candidate:
      return open_to(trace, detail.step.item, detail.swap->teams[0]);
    case QuestionKind::winning_chord:
      break;
  }
  std::vector<std::uint32_t> candidates = detail.scores->ranking;
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

const Chord& chord_of_choice(const Trace& trace, const StepDetail& detail, const Question& question,
                             std::uint32_t choice) {
  switch (question.kind) {
    case QuestionKind::nearer_end:
      return detail.pair->ends[choice];
    case QuestionKind::even_chord:
      return detail.balanced->chords[choice];
    case QuestionKind::leaving_team:
      choice = taken_before(trace, detail.step.item)[choice];
      break;
    case QuestionKind::winning_chord:
    case QuestionKind::coming_candidate:
      break;
  }
  return trace.placement.candidates[choice].chord;
}

OtherSwap compare_swap(const Trace& trace, const StepDetail& detail, const Question& question,
                       std::uint32_t choice) {
  const Placement& placement = trace.placement;
  const HoldRequirements hold = hold_requirements(placement);
  const Stands* stands = placement.stands.get();
  std::vector<std::uint32_t> taken = taken_before(trace, detail.step.item);
  OtherSwap other;
  if (question.kind == QuestionKind::leaving_team) {
    other.team = choice;
    const auto best = best_swap_of(trace.object(), trace.centre, placement.candidates, taken,
                                   choice, hold, stands);
    if (!best) return other;
    other.candidate = best->taken[choice];
    other.keys = best->keys;
    return other;
  }
  other.team = detail.swap->teams[0];
  other.candidate = choice;
  taken[other.team] = choice;
  other.keys = hold_keys(trace.object(), trace.centre, placement.candidates, taken, hold, stands);
  return other;
}

}  // namespace evenlift
