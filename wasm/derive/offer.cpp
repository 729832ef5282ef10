#include "derive/derive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/verdict.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/method.h"

namespace evenlift::view {
namespace {

// Another document for the same object, tried in the order below.
struct Alternative {
  const char* verb;  // the button's first words, in English; null for the number of robots
  bool says_held;    // the verb promises a hold
  bool (*suits)(const Placement&);
  Document (*document)(const Derived&);
  bool if_bad = false;  // tried only if it falls, tips, or overloads a robot
};

bool chooses(const Placement& of) { return selects_candidates(of.settings.method); }

template <class Value>
Document with(const Derived& facts, Value Settings::*setting, Value value) {
  Document document = facts.placed;
  document.moved = {};
  document.settings.*setting = value;
  return document;
}

template <std::uint32_t more>
Document with_more(const Derived& facts) {
  const Settings& now = facts.placed.settings;
  return now.method == Method::balanced
             ? with(facts, &Settings::robots, std::min(now.robots + 2 * more, most_robots))
             : with(facts, &Settings::teams,
                    std::optional(std::uint32_t{placed_teams(facts.placement)} + more));
}

bool has_number(const Placement& of) { return of.settings.method != Method::given; }

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
    {"Equal loads", false,
     [](const Placement& of) { return of.settings.method != Method::balanced && count_robots(of.teams) >= least_robots; },
     [](const Derived& facts) { return by_other_method(facts, Method::balanced); }},
    {"Use goal Cover", false,
     [](const Placement& of) { return has_number(of) && goal_of(of.settings) == Goal::hold; },
     [](const Derived& facts) { return with(facts, &Settings::goal, std::optional(Goal::cover)); }, true},
    {nullptr, false, has_number, with_more<1>, true},
    {nullptr, false, has_number, with_more<2>, true},
};
// clang-format on

bool is_short(const Placement& placement) {
  return !is_one_team(placement.settings.method) &&
         placement.teams.size() < placement.requested_teams;
}

// "88" of "88 %".
std::string without_sign(const std::string& percentage) {
  return percentage.substr(0, percentage.find("\u00A0%"));
}

// What an alternative changes, for better or worse: ": holds, 88 → ≥ 93 % covered".
struct Differences {
  std::string text;
  bool gains = false;
};

Differences differences(const Reported& was, const Reported& is, bool says_held) {
  const Placement &before = was.placement, &after = is.placement;
  Differences all;
  const auto add = [&](const std::string& change, bool gains) {
    all.text += (all.text.empty() ? ": " : ", ") + change;
    all.gains |= gains;
  };
  if (is_short(before) && after.teams.size() > before.teams.size())
    add(say("room for {teams}", {count_of(after.teams.size(), "team", "teams")}), true);
  if (!before.loads && after.loads) add(say("it stands"), true);
  if (was.report.tips && !is.report.tips && after.loads) add(say("it stays"), true);
  if (!was.report.tips && is.report.tips) add(say("it can tip"), false);
  if (!was.report.overloaded.empty() && is.report.overloaded.empty() && after.loads)
    add(say("none is overloaded"), true);
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

// The fewer, the better; a bad verdict counts for more than all others.
constexpr std::size_t bad = 1000;
std::size_t faults(const Judgement& judgement) {
  return judgement.reasons.size() + (judgement.kind == VerdictKind::bad ? bad : 0);
}

// A gentler slope, on which the object stands clearly (Report::upright): it still does if robots and
// slope are off by a little.
std::optional<Offer> gentler_slope(const Derived& facts, const Reported& now) {
  if (!now.report.tips || !now.report.tilt || !(now.shown.carrying.slope > 0)) return std::nullopt;
  const Tilt& tilt = *now.report.tilt;
  const double least = std::min(tilt.slope, tilt.slope_left.value_or(tilt.slope));
  Shown gentler = now.shown;
  for (int percent = static_cast<int>(100 * least); percent >= 1; percent = percent * 9 / 10) {
    gentler.carrying.slope = static_cast<double>(percent) / 100;
    if (!evenlift::report_of(ShownPlacement(now.placement, gentler)).upright) continue;
    return Offer{facts.placed.settings,
                 say("Slope {slope} at most: it stays", {slope_in_words(gentler.carrying.slope)}),
                 gentler};
  }
  return std::nullopt;
}

std::optional<Offer> best_alternative(const Derived& facts, const Shown& shown) {
  const Placement& now = *facts.placement;
  const Reported before(now, shown);
  const Judgement judgement = judge(before);
  if (judgement.kind == VerdictKind::good) return std::nullopt;
  std::optional<Offer> found;
  std::size_t fewest = faults(judgement);
  for (const Alternative& alternative : alternatives) {
    if (!alternative.suits(now)) continue;
    if (alternative.if_bad && fewest < bad) continue;
    Document document = alternative.document(facts);
    document.shown = shown;
    const Document tried = settled(facts, document);
    const Result<Placement> other = try_placement(tried, now);
    if (!other || other->teams.empty()) continue;
    const Reported after(*other, tried.shown);
    const Differences told = differences(before, after, alternative.says_held);
    const Judgement judged = judge(after);
    const bool holds = !alternative.says_held || is_held(*other);
    if ((!told.gains && !alternative.says_held) || !holds || faults(judged) >= fewest) continue;
    fewest = faults(judged);
    const std::string robots = count_of(count_robots(other->teams), "robot", "robots");
    const std::string verb =
        alternative.verb ? say(alternative.verb) : say("Use {robots}", {robots});
    found = Offer{document.settings, verb + told.text};
    if (judged.kind == VerdictKind::good) break;
  }
  if (fewest >= bad)
    if (auto gentler = gentler_slope(facts, before)) return gentler;
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
