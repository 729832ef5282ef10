#include "evenlift/output/json.h"

#include "evenlift/candidates.h"
#include "output/json/json_text.h"

namespace evenlift {
namespace {

std::string ends(const Chord& chord) {
  return json::array({json::pair(chord.r1.position), json::pair(chord.r2.position)});
}

std::string candidates_json(const std::vector<Candidate>& candidates) {
  std::vector<std::string> items;
  for (const Candidate& candidate : candidates)
    items.push_back(json::object({{"ends", ends(candidate.chord)},
                                  {"ratio", json::number(candidate.chord.ratio)},
                                  {"kind", json::text(name(candidate.kind))}}));
  return json::long_array(items, 1);
}

std::string teams_json(const std::vector<Team>& teams) {
  std::vector<std::string> items;
  for (const Team& team : teams)
    items.push_back(json::object(
        {{"ends", ends(team.chord)},
         {"ratio", json::number(team.chord.ratio)},
         {"loads", json::array({json::number(team.loads[0]), json::number(team.loads[1])})}}));
  return json::long_array(items, 1);
}

std::string loads_json(const std::optional<LoadSummary>& loads) {
  if (!loads) return "null";
  return json::object({{"min", json::number(loads->min)},
                       {"mean", json::number(loads->mean)},
                       {"max", json::number(loads->max)},
                       {"spread", json::number(loads->spread)},
                       {"max_share", json::number(loads->max_share)}});
}

std::string closure_json(const Closure& closure) {
  std::vector<std::string> free;
  if (closure.clockwise.exists) free.push_back(json::text("clockwise"));
  if (closure.counterclockwise.exists) free.push_back(json::text("counterclockwise"));
  if (closure.translation_free) free.push_back(json::text("translation"));
  return json::long_object(
      {{"form_closure", json::boolean(closure.form_closure)},
       {"margin", closure.margin ? json::number(*closure.margin) : "null"},
       {"second_order", json::boolean(closure.second_order)},
       {"free", json::array(free)},
       {"clockwise", json::points(closure.clockwise.clipped, 2)},
       {"counterclockwise", json::points(closure.counterclockwise.clipped, 2)}},
      1);
}

std::string capacity_json(const Placement& placement, const CapacityInJson& capacity) {
  std::vector<std::string> robots;
  for (const std::size_t robot : overloaded_robots(placement, capacity.limit))
    robots.push_back(std::to_string(robot));
  const CapacityPlan& plan = capacity.plan;
  return json::object({{"limit", json::number(capacity.limit)},
                       {"overloaded", json::array(robots)},
                       {"teams_needed", plan.possible ? std::to_string(plan.teams) : "null"},
                       {"greatest_load", plan.possible ? json::number(plan.greatest_load) : "null"},
                       {"teams_tried", std::to_string(plan.tried)}});
}

std::string overlays_json(const Overlays& overlays) {
  return json::object({{"candidates", json::boolean(overlays.candidates)},
                       {"chords", json::boolean(overlays.chords)},
                       {"hull", json::boolean(overlays.lifting_base)},
                       {"clockwise", json::boolean(overlays.clockwise)},
                       {"counterclockwise", json::boolean(overlays.counterclockwise)},
                       {"tipping", json::boolean(overlays.tipping)}});
}

}  // namespace

std::string placement_json(const Placement& placement, bool with_candidates,
                           const std::optional<CapacityInJson>& capacity) {
  const Settings& settings = placement.settings;
  std::vector<json::Member> members = {
      {"polygon", json::points(placement.vertices, 1)},
      {"centre_of_mass", json::pair(placement.centre_of_mass)},
      {"metric", json::text(name(settings.method))},
      {"min_ratio", json::number(settings.min_ratio)},
      {"weight", json::number(settings.weight)},
      {"seed", std::to_string(settings.seed)},
  };
  if (with_candidates) members.push_back({"candidates", candidates_json(placement.candidates)});
  members.push_back({"requested_teams", std::to_string(placement.requested_teams)});
  members.push_back({"teams", teams_json(placement.teams)});
  members.push_back({"hull", json::points(placement.lifting_base, 1)});
  members.push_back({"coverage", json::number(placement.coverage)});
  members.push_back({"loads", loads_json(placement.loads)});
  members.push_back({"closure", closure_json(placement.closure)});
  if (capacity) members.push_back({"capacity", capacity_json(placement, *capacity)});
  return json::long_object(members, 0) + "\n";
}

std::string document_json(const Document& document) {
  const Settings& settings = document.settings;
  return json::long_object(
             {{"polygon", json::points(document.vertices, 1)},
              {"centre_of_mass",
               document.centre_of_mass ? json::pair(*document.centre_of_mass) : "null"},
              {"teams", settings.teams ? std::to_string(*settings.teams) : json::text("max")},
              {"metric", json::text(name(settings.method))},
              {"min_ratio", json::number(settings.min_ratio)},
              {"weight", json::number(settings.weight)},
              {"seed", std::to_string(settings.seed)},
              {"overlays", overlays_json(settings.overlays)},
              {"step", settings.step ? std::to_string(*settings.step) : "null"}},
             0) +
         "\n";
}

}  // namespace evenlift
