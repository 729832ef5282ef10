// Compares the greedy choice of teams with the best one.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/optimum.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/wording.h"
#include "modules/kinds.h"

namespace evenlift::view {
namespace {

struct Compared {
  Shown shown;
  Placement greedy, best;
  Optimum optimum;
  double seconds = 0;    // the time limit
  bool stopped = false;  // the time ran out
};

// The same number of teams, chosen among candidates.
Document with_teams(Document document) {
  Settings& settings = document.settings;
  if (settings.method == Method::balanced)
    settings.teams = std::max<std::uint32_t>(1, settings.robots / 2);
  if (!selects_candidates(settings.method)) settings.method = Method::area;
  settings.goal.reset();
  document.moved = {};
  return document;
}

Compared compare(const Placement& greedy, const Shown& shown, double seconds) {
  const double end = now() + 1000 * seconds;
  bool stopped = false;
  const evenlift::Stop stop = [&] { return stopped = stopped || now() >= end; };
  Optimum optimum =
      widest_choice(greedy.object, greedy.centre_of_mass, greedy.candidates, greedy.requested_teams,
                    greedy.team_candidates, stop, greedy.stands.get());
  Placement best = with_choice(greedy, optimum.taken);
  return {shown, greedy, std::move(best), std::move(optimum), seconds, stopped};
}

std::string row(const std::string& name, const ShownPlacement& of) {
  const Placement& placement = of.placement;
  std::string teams;
  for (const std::uint32_t i : placement.team_candidates)
    teams += (teams.empty() ? "" : ", ") + std::to_string(i + 1);
  const LoadSummary& loads = *placement.loads;
  return json::array({json::text(name), json::text(percentage(placement.coverage, 2)),
                      json::text(load_in_words(loads.min, loads.max, loads.max, of.shown.units)),
                      json::text(form_closure_in_words(placement.closure)), json::text(teams)});
}

std::string how_sure(const Compared& compared) {
  const Optimum& optimum = compared.optimum;
  const std::string bound = fixed(100 * optimum.bound, 2) + "\u00A0%";
  const std::size_t candidates = compared.greedy.candidates.size();
  if (optimum.proved)
    return say(
        "It is proved: no choice of this number of teams among these candidates covers more.");
  if (compared.stopped)
    return say(
        "A proof would take longer than {seconds} seconds here. This is the best choice found in "
        "that time; no choice covers more than {coverage}. The program takes the time that you give "
        "it: evenlift optimum FILE --teams {teams} --time-limit 600.",
        {plain(compared.seconds), bound, compared.greedy.requested_teams});
  return say(candidates > most_candidates_bounded
                 ? "With {candidates} the optimum would take too long. All of them together cover "
                   "{coverage}, and no choice covers more."
                 : "With {candidates} there is no proof that it is the best: no choice covers more "
                   "than {coverage}.",
             {count_of(candidates, "candidate", "candidates"), bound});
}

std::string gap(const Compared& compared) {
  const double behind = compared.optimum.coverage - compared.greedy.coverage;
  if (!(behind > 1e-9))
    return say(compared.optimum.proved ? "The greedy choice is the best one."
                                       : "Nothing better than the greedy choice was found.");
  return say("The greedy choice is {points} behind it.",
             {points_ahead(compared.optimum.coverage, compared.greedy.coverage)});
}

// Balanced robots may cover more than the best teams.
std::string balanced_beside(const Document& document, const Compared& compared) {
  Document other = document;
  other.settings.method = Method::balanced;
  other.settings.robots = 2 * compared.greedy.requested_teams;
  if (other.settings.robots < least_robots || other.settings.robots > most_robots) return {};
  const Result<Placement> balanced = place(other, Effort::start);
  if (!balanced || balanced->teams.empty() || balanced->coverage <= compared.best.coverage)
    return {};
  return say(
      balanced->search_ended
          ? "As many balanced robots, which need not stand in pairs, cover {coverage}."
          : "As many balanced robots, which need not stand in pairs, cover at least {coverage}.",
      {percentage(balanced->coverage)});
}

std::string as_json(const Compared& compared, Method asked, const std::string& beside) {
  const Placement& greedy = compared.greedy;
  const bool proved = compared.optimum.proved;
  const Shown& shown = compared.shown;
  const std::string method(name(greedy.settings.method));
  std::vector<std::string> said = {json::text(gap(compared)), json::text(how_sure(compared))};
  if (!beside.empty()) said.push_back(json::text(beside));
  if (asked != greedy.settings.method)
    said.push_back(json::text(
        say("The method {method} does not choose among candidates, so the same number of "
            "teams is chosen by {metric} here.",
            {method_in_words(asked), method})));
  return json::object(
      {{"rows",
        json::array({row(say("Greedy, by {metric}", {method}), {greedy, shown}),
                     row(say(proved ? "The optimum" : "The best found"), {compared.best, shown})})},
       {"said", json::array(said)},
       {"pictures", json::array({json::text(placement_sketch({greedy, shown})),
                                 json::text(placement_sketch({compared.best, shown}))})}});
}

}  // namespace

std::string optimum(const RequestMembers& members) {
  const Result<Document> document = decode_link(members.text("link"));
  if (!document) return problem(document.error().message);
  const Document in_teams = with_teams(*document);
  const Result<Placement> greedy = place(in_teams);
  if (!greedy) return problem(sentence(greedy.error()));
  if (greedy->teams.empty())
    return problem("no chord through the centre of mass meets the minimum load ratio");
  const Compared compared = compare(*greedy, document->shown, members.number("seconds"));
  return as_json(compared, document->settings.method, balanced_beside(in_teams, compared));
}

}  // namespace evenlift::view
