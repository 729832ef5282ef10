// The greedy choice of a document's teams beside the best ones, for the program and for requests.
#include <string>
#include <utility>
#include <vector>

#include "evenlift/optimum.h"
#include "evenlift/output/json_text.h"
#include "evenlift/swaps.h"
#include "evenlift/wording.h"

namespace evenlift {

Result<ComparedChoices> compare_choices(const Document& document, const Stop& stop) {
  const bool holds = goal_of(document.settings) == Goal::hold;
  if (!selects_candidates(document.settings.method))
    return bad_setting("metric",
                       say("only area, circle and distance choose among candidates and have "
                           "an optimum, not {method}",
                           {name(document.settings.method)}));
  Document plain = document;
  plain.settings.goal.reset();
  Result<Placement> greedy = place(plain);
  if (!greedy) return greedy.error();
  // For robots with a size there may be room for fewer teams than requested.
  const std::size_t teams = greedy->teams.size();
  const Stands* stands = greedy->stands.get();
  ComparedChoices compared{*std::move(greedy), {}, {}};
  const Placement& of = compared.greedy;
  compared.widest = widest_choice(of.object, of.centre_of_mass, of.candidates, teams,
                                  of.team_candidates, stop, stands);
  if (!holds) return compared;
  compared.to_hold =
      choice_to_hold(of.object, of.centre_of_mass, of.candidates, teams, of.team_candidates,
                     hold_requirements(of), compared.widest, stands);
  if (!compared.to_hold && teams > 0)
    return bad_setting("goal",
                       say("at most {most} teams can be compared by their hold, not {teams}",
                           {std::size_t{most_swapped_teams}, teams}));
  return compared;
}

std::string choices_json(const ComparedChoices& compared, const std::vector<std::string>& notices) {
  const auto taken = [](const std::vector<std::uint32_t>& candidates) {
    return json::wholes({candidates.begin(), candidates.end()});
  };
  const Placement& greedy = compared.greedy;
  const Optimum& widest = compared.widest;
  std::vector<json::Member> members = {
      {"teams", std::to_string(greedy.teams.size())},
      {"candidates", std::to_string(greedy.candidates.size())},
      {"greedy", json::object({{"taken", taken(greedy.team_candidates)},
                               {"coverage", json::number(greedy.coverage)}})},
      {"optimum", json::object({{"taken", taken(widest.taken)},
                                {"coverage", json::number(widest.coverage)},
                                {"bound", json::number(widest.bound)},
                                {"proved", json::boolean(widest.proved)}})}};
  if (const auto& to_hold = compared.to_hold)
    members.push_back({"hold", json::object({{"taken", taken(to_hold->taken)},
                                             {"level", std::to_string(to_hold->keys.level)},
                                             {"coverage", json::number(to_hold->keys.coverage)},
                                             {"most_level", std::to_string(to_hold->most_level)},
                                             {"bound", json::number(to_hold->most_coverage)},
                                             {"proved", json::boolean(to_hold->proved)}})});
  if (!notices.empty()) members.push_back({"notices", json::texts(notices)});
  return json::long_object(members, 0) + "\n";
}

}  // namespace evenlift
