#include "derive/derive.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/verdict.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/method.h"

namespace evenlift::view {
namespace {

// Another document for the same object, tried in the order below.
struct Alternative {
  const char* verb;  // the button's first words, in English
  bool says_held;    // the verb promises a hold
  bool (*suits)(const Placement&);
  Document (*document)(const Derived&);
};

bool chooses(const Placement& of) { return selects_candidates(of.settings.method); }

template <class Value>
Document with(const Derived& facts, Value Settings::*setting, Value value) {
  Document document = facts.placed;
  document.moved = {};
  document.settings.*setting = value;
  return document;
}

// clang-format off
const Alternative alternatives[] = {
    {"Use ranges", false,
     [](const Placement& of) { return chooses(of) && of.stands && of.settings.positions == Positions::best; },
     [](const Derived& facts) { return with(facts, &Settings::positions, Positions::range); }},
    {"Make it hold", true,
     [](const Placement& of) { return chooses(of) && goal_of(of.settings) != Goal::hold; },
     [](const Derived& facts) { return with(facts, &Settings::goal, std::optional(Goal::hold)); }},
    {"Use area", false,
     [](const Placement& of) { return of.settings.method != Method::area && count_robots(of.teams) % 2 == 0; },
     [](const Derived& facts) { return by_other_method(facts, Method::area); }},
    {"Use balanced", false,
     [](const Placement& of) { return of.settings.method != Method::balanced && count_robots(of.teams) >= least_robots; },
     [](const Derived& facts) { return by_other_method(facts, Method::balanced); }},
};
// clang-format on

bool is_short(const Placement& placement) {
  return !is_one_team(placement.settings.method) &&
         placement.teams.size() < placement.requested_teams;
}

// "88" of "88 %".
std::string without_sign(std::string percentage) {
  return percentage.substr(0, percentage.find("\u00A0%"));
}

// What an alternative changes, for better or worse: ": holds, 88 → ≥ 93 % covered".
struct Differences {
  std::string text;
  bool gains = false;
};

Differences differences(const Placement& before, const Placement& after, bool says_held) {
  Differences all;
  const auto add = [&](const std::string& change, bool gains) {
    all.text += (all.text.empty() ? ": " : ", ") + change;
    all.gains |= gains;
  };
  if (is_short(before) && after.teams.size() > before.teams.size())
    add(say("room for {teams}", {count_of(after.teams.size(), "team", "teams")}), true);
  if (!before.loads && after.loads) add(say("it stands"), true);
  if (!says_held && !is_held(before) && is_held(after)) add(say("holds"), true);
  if (is_held(before) && !is_held(after)) add(say("not held"), false);
  constexpr double worth_telling = 0.01;
  if (std::abs(after.coverage - before.coverage) > worth_telling)
    add(say(after.search_ended ? "{before} → {coverage} covered"
                               : "{before} → ≥\u00A0{coverage} covered",
            {without_sign(percentage(before.coverage)), percentage(after.coverage)}),
        after.coverage > before.coverage);
  return all;
}

std::optional<Offer> lower_ratio(const Derived& facts) {
  if (!facts.best_ratio) return std::nullopt;
  Offer offer{facts.placed.settings,
              say("Lower the ratio to {ratio}", {fixed(*facts.best_ratio, 2)})};
  offer.settings.min_ratio = *facts.best_ratio;
  return offer;
}

std::optional<Offer> best_alternative(const Derived& facts, const Shown& shown) {
  const Placement& now = *facts.placement;
  const Judgement judgement = judge({now, shown});
  if (judgement.kind == VerdictKind::good) return std::nullopt;
  std::optional<Offer> found;
  std::size_t fewest = judgement.reasons.size();
  for (const Alternative& alternative : alternatives) {
    if (!alternative.suits(now)) continue;
    Document document = alternative.document(facts);
    document.shown = shown;
    const Document tried = settled(facts, document);
    const Result<Placement> other = try_placement(tried, now);
    if (!other || other->teams.empty()) continue;
    const Differences told = differences(now, *other, alternative.says_held);
    const Judgement judged = judge({*other, tried.shown});
    const bool holds = !alternative.says_held || is_held(*other);
    if ((!told.gains && !alternative.says_held) || !holds || judged.reasons.size() >= fewest)
      continue;
    fewest = judged.reasons.size();
    found = Offer{document.settings, say(alternative.verb) + told.text};
    if (judged.kind == VerdictKind::good) break;
  }
  return found;
}

}  // namespace

void renew_offer(Derived& facts, const Shown& shown) {
  constexpr std::size_t most_vertices = 2000, most_tried = 16;
  facts.offer.reset();
  if (facts.refusal || !facts.placement) return;
  facts.offer = lower_ratio(facts);
  const std::size_t robots = count_robots(facts.placement->teams);
  if (facts.offer || robots == 0 || robots > most_tried ||
      facts.placement->vertices().size() > most_vertices)
    return;
  facts.offer = best_alternative(facts, shown);
}

}  // namespace evenlift::view
