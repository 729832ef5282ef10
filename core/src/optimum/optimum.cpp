#include "evenlift/optimum.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "evenlift/closure.h"
#include "evenlift/stability.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "grasp/grasp.h"
#include "optimum/rings.h"
#include "polygon/corners.h"
#include "swaps/rounds.h"

namespace evenlift::optimum {
namespace {

// The area of a ring in the triangle a, b, C (the origin).
double area_within(const Points& ring, const Vec2& a, const Vec2& b) {
  if (!(cross(a, b) > 0)) return 0;
  return std::fabs(area_left_of_both(clip_left(ring, a, b), b, Vec2{}, a));
}

}  // namespace

Triangles::Triangles(const PolygonWithHoles& object, const Vec2& centre,
                     const std::vector<Candidate>& candidates)
    : chords_(static_cast<std::uint32_t>(candidates.size())) {
  Points ring, ends(2 * candidates.size());
  for (const Vec2& v : object.boundary()) ring.push_back(v - centre);
  for (std::uint32_t i = 0; i < chords_; ++i) {
    ends[i] = candidates[i].chord.r2.position - centre;
    ends[chords_ + i] = candidates[i].chord.r1.position - centre;
  }
  shares_.assign(ends.size() * (chords_ + std::size_t{1}), 0);
  for (std::uint32_t from = 0; from < ends.size(); ++from)
    for (std::uint32_t steps = 1; steps < chords_; ++steps)
      shares_[from * (chords_ + std::size_t{1}) + steps] =
          area_within(ring, ends[from], ends[(from + steps) % ends.size()]) / object.area();
}

namespace {

constexpr double impossible = -1;

bool is_over(const Stop& stop) { return stop && stop(); }

// For each number of ends after a first one and each place of the last: the greatest sum of the
// triangles between them, and the place before the last.
class Chain {
 public:
  // Places up to `length` and up to `most` further ends. O(length^2 most).
  Chain(const Triangles& triangles, std::uint32_t first, std::uint32_t length, std::uint32_t most)
      : width_(length + 1),
        sums_(std::size_t{width_} * (most + 1), impossible),
        before_(sums_.size()) {
    sums_[0] = 0;
    const std::uint32_t longest = triangles.chords();
    for (std::uint32_t number = 1; number <= most; ++number)
      for (std::uint32_t to = 1; to < width_; ++to)
        for (std::uint32_t from = to > longest ? to - longest : 0; from < to; ++from) {
          const double sum = at(number - 1, from);
          if (sum < 0) continue;
          offer(number, to, from, sum + triangles.share(triangles.after(first, from), to - from));
        }
  }

  double at(std::uint32_t number, std::uint32_t place) const {
    return sums_[std::size_t{number} * width_ + place];
  }

  // Without the first place.
  std::vector<std::uint32_t> places(std::uint32_t number, std::uint32_t place) const {
    std::vector<std::uint32_t> places;
    for (; number > 0; --number) {
      places.push_back(place);
      place = before_[std::size_t{number} * width_ + place];
    }
    std::reverse(places.begin(), places.end());
    return places;
  }

 private:
  void offer(std::uint32_t number, std::uint32_t to, std::uint32_t from, double sum) {
    const std::size_t i = std::size_t{number} * width_ + to;
    if (sum <= sums_[i]) return;
    sums_[i] = sum;
    before_[i] = from;
  }

  std::uint32_t width_;
  std::vector<double> sums_;
  std::vector<std::uint32_t> before_;
};

// The best chain that a triangle to the place `length` closes.
struct Closed {
  double sum = impossible;
  std::uint32_t number = 0, place = 0;
};

Closed close(const Triangles& triangles, const Chain& chain, std::uint32_t first,
             std::uint32_t length, std::uint32_t most) {
  Closed best;
  for (std::uint32_t number = 0; number <= most; ++number)
    for (std::uint32_t place = 0; place < length; ++place) {
      const double sum = chain.at(number, place);
      const std::uint32_t left = length - place;
      if (sum < 0 || left > triangles.chords()) continue;
      const double closed = sum + triangles.share(triangles.after(first, place), left);
      if (closed > best.sum) best = {closed, number, place};
    }
  return best;
}

// The best ring through both ends of the chord at place 0, by dynamic programming over chords in
// order of slope. The state is the last end used on each side, and the number of chords used. There
// must be a chord.
class BothSides {
 public:
  BothSides(const Triangles& triangles, std::uint32_t first, std::uint32_t teams)
      : triangles_(triangles),
        first_(first),
        chords_(triangles.chords()),
        teams_(teams),
        sums_(std::size_t{chords_} * chords_ * teams, impossible),
        before_(sums_.size(), 0) {
    sums_[index(0, 0, 1)] = 0;
    for (std::uint32_t chord = 1; chord < chords_; ++chord) extend(chord);
  }

  Ring best() const {
    Ring best{impossible, {}};
    std::array<std::uint32_t, 3> last{};
    for (std::uint32_t right = 0; right < chords_; ++right)
      for (std::uint32_t left = 0; left < chords_; ++left)
        for (std::uint32_t used = 1; used <= teams_; ++used) {
          const double sum = sums_[index(right, left, used)];
          if (sum < 0) continue;
          const double closed = sum + step(right, chords_) + step(chords_ + left, 2 * chords_);
          if (closed <= best.share) continue;
          best.share = closed;
          last = {right, left, used};
        }
    best.ends = ends_of(last);
    return best;
  }

 private:
  std::size_t index(std::uint32_t right, std::uint32_t left, std::uint32_t used) const {
    return (std::size_t{right} * chords_ + left) * teams_ + (used - 1);
  }
  // Places are counted about C from the chord's right end.
  double step(std::uint32_t from, std::uint32_t to) const {
    return triangles_.share(triangles_.after(first_, from), to - from);
  }

  void extend(std::uint32_t chord) {
    for (std::uint32_t right = 0; right < chord; ++right)
      for (std::uint32_t left = 0; left < chord; ++left) {
        const double on_right = step(right, chord), on_left = step(chords_ + left, chords_ + chord);
        for (std::uint32_t used = 1; used < teams_; ++used) {
          const std::size_t from = index(right, left, used);
          if (sums_[from] < 0) continue;
          offer(index(chord, left, used + 1), from, sums_[from] + on_right);
          offer(index(right, chord, used + 1), from, sums_[from] + on_left);
          offer(index(chord, chord, used + 1), from, sums_[from] + on_right + on_left);
        }
      }
  }

  void offer(std::size_t to, std::size_t from, double sum) {
    if (sum <= sums_[to]) return;
    sums_[to] = sum;
    before_[to] = static_cast<std::uint32_t>(from);
  }

  std::vector<std::uint32_t> ends_of(std::array<std::uint32_t, 3> last) const {
    assert(chords_ > 0);
    std::vector<std::uint32_t> right{0}, left{0};
    for (std::size_t at = index(last[0], last[1], last[2]); at % teams_ != 0; at = before_[at]) {
      const auto pair = static_cast<std::uint32_t>(at / teams_);
      right.push_back(pair / chords_);
      left.push_back(pair % chords_);
    }
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t place : right) ends.push_back(triangles_.after(first_, place));
    for (const std::uint32_t place : left)
      ends.push_back(triangles_.after(first_, chords_ + place));
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  const Triangles& triangles_;
  std::uint32_t first_, chords_, teams_;
  std::vector<double> sums_;
  std::vector<std::uint32_t> before_;
};

}  // namespace

std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop) {
  const std::uint32_t ends = triangles.ends();
  Ring best;
  for (std::uint32_t first = 0; first < ends && most > 0; ++first) {
    if (is_over(stop)) return std::nullopt;
    const Chain chain(triangles, first, ends - 1 - first, most - 1);
    Closed closed;
    for (std::uint32_t number = 0; number < most; ++number)
      for (std::uint32_t place = 0; place + first < ends; ++place) {
        const double sum = chain.at(number, place);
        const std::uint32_t left = ends - place;
        if (sum < 0 || left > triangles.chords()) continue;
        const double whole = sum + triangles.share(first + place, left);
        if (whole > closed.sum) closed = {whole, number, place};
      }
    if (closed.sum <= best.share) continue;
    best.share = closed.sum;
    best.ends = {first};
    for (const std::uint32_t place : chain.places(closed.number, closed.place))
      best.ends.push_back(first + place);
  }
  return best;
}

std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop) {
  Ring best;
  for (std::uint32_t first = 0; first < triangles.chords() && teams > 0; ++first) {
    if (is_over(stop)) return std::nullopt;
    Ring ring = BothSides(triangles, first, teams).best();
    if (ring.share > best.share) best = std::move(ring);
  }
  return best;
}

std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop) {
  const std::uint32_t chords = triangles.chords();
  Ring best;
  for (std::uint32_t first = 0; first < chords && teams > 0; ++first) {
    if (is_over(stop)) return std::nullopt;
    const std::uint32_t opposite = first + chords;
    const Chain right(triangles, first, chords - 1, teams - 1),
        left(triangles, opposite, chords - 1, teams - 1);
    const Closed a = close(triangles, right, first, chords, teams - 1),
                 b = close(triangles, left, opposite, chords, teams - 1);
    if (a.sum + b.sum <= best.share) continue;
    best.share = a.sum + b.sum;
    best.ends = {first, opposite};
    for (const std::uint32_t place : right.places(a.number, a.place))
      best.ends.push_back(triangles.after(first, place));
    for (const std::uint32_t place : left.places(b.number, b.place))
      best.ends.push_back(triangles.after(opposite, place));
  }
  return best;
}

}  // namespace evenlift::optimum

namespace evenlift {

namespace {

using optimum::Ring;
using optimum::Triangles;

constexpr double rounding = 1e-12;  // of sums of shares

std::vector<LiftingPoint> robots_of(const std::vector<Candidate>& candidates,
                                    const std::vector<std::uint32_t>& taken) {
  std::vector<LiftingPoint> robots;
  for (const std::uint32_t i : taken)
    for (const LiftingPoint& end : {candidates[i].chord.r1, candidates[i].chord.r2})
      robots.push_back(end);
  return robots;
}

double coverage_of(const PolygonWithHoles& object, const std::vector<Candidate>& candidates,
                   const std::vector<std::uint32_t>& taken) {
  return coverage(object, lifting_base(object, robots_of(candidates, taken)));
}

// The chords of the ring's ends, then others up to `teams`, those of `start` first.
std::vector<std::uint32_t> chords_of(const Triangles& triangles, const Ring& ring,
                                     const std::vector<std::uint32_t>& start, std::size_t teams) {
  std::vector<std::uint32_t> chords;
  const auto add = [&](std::uint32_t chord) {
    if (std::find(chords.begin(), chords.end(), chord) == chords.end()) chords.push_back(chord);
  };
  for (const std::uint32_t end : ring.ends) add(triangles.chord_of(end));
  for (const std::uint32_t chord : start)
    if (chords.size() < teams) add(chord);
  for (std::uint32_t chord = 0; chord < triangles.chords() && chords.size() < teams; ++chord)
    add(chord);
  std::sort(chords.begin(), chords.end());
  return chords;
}

class Widest {
 public:
  Widest(const PolygonWithHoles& object, const std::vector<Candidate>& candidates,
         std::size_t teams, std::vector<std::uint32_t> start, const Stands* stands)
      : object_(object),
        candidates_(candidates),
        teams_(teams),
        start_(std::move(start)),
        stands_(stands) {
    take(start_);
    bound_by_all();
  }

  void search(const Vec2& centre, const Stop& stop) {
    if (start_.size() >= candidates_.size() || teams_ == 0) {
      best_.bound = best_.coverage;
    } else if (candidates_.size() <= most_candidates_bounded) {
      bound_by_rings(Triangles(object_, centre, candidates_), stop);
    }
    best_.proved = best_.coverage >= best_.bound - coverage_tie;
  }

  Optimum result() && { return std::move(best_); }

 private:
  void take(std::vector<std::uint32_t> chords) {
    if (stands_ && stands_->any_collide(robots_of(candidates_, chords))) return;
    const double covers = coverage_of(object_, candidates_, chords);
    if (!best_.taken.empty() && covers <= best_.coverage) return;
    std::sort(chords.begin(), chords.end());
    best_.taken = std::move(chords);
    best_.coverage = covers;
  }

  // No choice covers more than all candidates together.
  void bound_by_all() {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < candidates_.size(); ++i) all.push_back(i);
    best_.bound = coverage_of(object_, candidates_, all) + rounding;
  }

  void bound_by_rings(const Triangles& triangles, const Stop& stop) {
    const auto teams = static_cast<std::uint32_t>(teams_);
    const bool exact = candidates_.size() <= most_candidates_proved;
    const auto one = optimum::best_ring(triangles, teams, stop);
    const auto both = !one    ? std::nullopt
                      : exact ? optimum::best_ring_of_chords(triangles, teams, stop)
                              : optimum::best_ring_by_sides(triangles, teams, stop);
    for (const auto& ring : {one, both}) {
      if (!ring) continue;
      const std::vector<std::uint32_t> chords = chords_of(triangles, *ring, start_, teams_);
      if (chords.size() == teams_) take(chords);
    }
    if (!both) return;
    best_.bound = std::min(best_.bound, std::max(one->share, both->share) + rounding);
    best_.bound = std::max(best_.bound, best_.coverage);
  }

  const PolygonWithHoles& object_;
  const std::vector<Candidate>& candidates_;
  std::size_t teams_;
  std::vector<std::uint32_t> start_;
  const Stands* stands_;
  Optimum best_;
};

// All sets of `size` numbers below `all`, in lexicographic order.
template <class Visit>
void for_each_subset(std::uint32_t all, std::size_t size, Visit visit) {
  std::vector<std::uint32_t> subset(size);
  for (std::uint32_t i = 0; i < size; ++i) subset[i] = i;
  while (true) {
    visit(subset);
    std::size_t i = size;
    while (i > 0 && subset[i - 1] == all - static_cast<std::uint32_t>(size - (i - 1))) --i;
    if (i == 0) return;
    ++subset[i - 1];
    for (; i < size; ++i) subset[i] = subset[i - 1] + 1;
  }
}

// At most `limit` + 1.
std::uint64_t count_choices(std::size_t all, std::size_t size, std::uint64_t limit) {
  double number = 1;
  for (std::size_t i = 0; i < size; ++i)
    number = number * static_cast<double>(all - i) / static_cast<double>(i + 1);
  return number > static_cast<double>(limit) ? limit + 1
                                             : static_cast<std::uint64_t>(std::llround(number));
}

// The best choice by all keys.
class SearchToHold {
 public:
  SearchToHold(const PolygonWithHoles& object, const Vec2& centre,
               const std::vector<Candidate>& candidates, const HoldRequirements& hold,
               const Stands* stands)
      : object_(object),
        centre_(centre),
        candidates_(candidates),
        hold_(hold),
        stands_(stands),
        choices_(object, centre, candidates, hold, stands) {}

  HoldKeys keys_of(const std::vector<std::uint32_t>& taken) const {
    return choices_.keys_of(choices_.part_of(taken));
  }

  void compare_all(std::size_t teams, ChoiceToHold& best) {
    // A part: all teams but the last.
    std::vector<swaps::Part> parts;
    std::vector<std::vector<std::uint32_t>> of_part;
    for_each_subset(choices_.size(), teams - 1, [&](const std::vector<std::uint32_t>& subset) {
      if (!subset.empty() && subset.back() + 1 == choices_.size()) return;
      if (stands_ && stands_->any_collide(robots_of(candidates_, subset))) return;
      parts.push_back(choices_.part_of(subset));
      of_part.push_back(subset);
    });
    choices_.set_parts(std::move(parts));
    std::vector<swaps::Trial> trials;
    for (std::uint32_t part = 0; part < of_part.size(); ++part)
      for (std::uint32_t last = of_part[part].empty() ? 0 : of_part[part].back() + 1;
           last < choices_.size(); ++last)
        if (choices_.fit(last, choices_.size() + part))
          trials.push_back(choices_.trial(last, choices_.size() + part));
    if (const auto found = swaps::best_trial(choices_, std::move(trials), best.keys)) {
      best.taken = of_part[found->trial.other - choices_.size()];
      best.taken.push_back(found->trial.candidate);
      best.keys = found->keys;
    }
    best.most_level = best.keys.level;
    best.most_coverage = best.keys.coverage;
    best.proved = best.compared = true;
  }

  // Swaps from the best choice so far and the widest one.
  void swap(const Optimum& widest, ChoiceToHold& best) const {
    std::vector<std::vector<std::uint32_t>> starts{best.taken};
    if (widest.taken.size() == best.taken.size()) starts.push_back(widest.taken);
    for (const std::vector<std::uint32_t>& start : starts) {
      if (check_swaps(candidates_.size(), start.size(), stands_)) continue;
      const SwapHistory history = swap_teams(object_, centre_, candidates_, start, hold_, stands_);
      const HoldKeys keys = keys_of(history.taken());
      if (better_by(keys, best.keys)) {
        best.taken = history.taken();
        best.keys = keys;
      }
    }
  }

  // A further contact never decreases the margin: no choice exceeds the level of all candidates.
  void bound(const Optimum& widest, ChoiceToHold& best) const {
    best.most_level = best_level;
    if (candidates_.size() <= most_candidates_bounded)
      best.most_level = level_of(margin_of_all(), level_bounds(hold_.min_margin));
    best.most_level = std::max(best.most_level, best.keys.level);
    best.most_coverage = std::max(widest.bound, best.keys.coverage);
    best.proved = best.keys.level == best.most_level &&
                  best.keys.coverage >= best.most_coverage - coverage_tie;
  }

 private:
  // The margin, enlarged by more than the rounding error.
  std::optional<double> margin_of_all() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < candidates_.size(); ++i) all.push_back(i);
    const auto touching = contact_points(stands_, robots_of(candidates_, all));
    const auto counted = clear_contacts(object_, contacts(object_, touching), hold_.clear);
    const auto margin = analyse_hold(object_, centre_, counted).margin;
    return margin ? std::optional(*margin + tau) : std::nullopt;
  }

  const PolygonWithHoles& object_;
  Vec2 centre_;
  const std::vector<Candidate>& candidates_;
  HoldRequirements hold_;
  const Stands* stands_;
  swaps::Choices choices_;
};

}  // namespace

Optimum widest_choice(const PolygonWithHoles& object, const Vec2& centre,
                      const std::vector<Candidate>& candidates, std::size_t teams,
                      const std::vector<std::uint32_t>& start, const Stop& stop,
                      const Stands* stands) {
  Widest widest(object, candidates, std::min(teams, candidates.size()), start, stands);
  widest.search(centre, stop);
  return std::move(widest).result();
}

std::optional<ChoiceToHold> choice_to_hold(const PolygonWithHoles& object, const Vec2& centre,
                                           const std::vector<Candidate>& candidates,
                                           std::size_t teams,
                                           const std::vector<std::uint32_t>& start,
                                           const HoldRequirements& hold, const Optimum& widest,
                                           const Stands* stands, std::uint64_t most) {
  if (start.empty() || start.size() > most_swapped_teams) return std::nullopt;
  SearchToHold to_hold(object, centre, candidates, hold, stands);
  ChoiceToHold best;
  best.taken = start;
  best.keys = to_hold.keys_of(start);
  if (start.size() >= candidates.size()) {
    best.most_level = best.keys.level;
    best.most_coverage = best.keys.coverage;
    best.proved = best.compared = true;
  } else if (count_choices(candidates.size(), teams, most) <= most) {
    to_hold.compare_all(teams, best);
  } else {
    to_hold.swap(widest, best);
    to_hold.bound(widest, best);
  }
  std::sort(best.taken.begin(), best.taken.end());
  return best;
}

}  // namespace evenlift
