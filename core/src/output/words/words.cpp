// A placement in words.
#include "evenlift/output/words.h"

#include "evenlift/output/carrying_words.h"

#include <string_view>

#include "evenlift/placed_robots.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

std::string joined(std::initializer_list<std::string> sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    if (!text.empty() && !sentence.empty()) text += ' ';
    text += sentence;
  }
  return text;
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

// "robots 3 and 4", numbered from 1.
std::string robots_of(const std::vector<std::size_t>& robots) {
  return (robots.size() == 1 ? "robot " : "robots ") + numbers_from_1(robots);
}

std::string overload_in_words(const ShownPlacement& of, const std::vector<std::size_t>& robots,
                              LoadModel model, const std::optional<std::size_t>& failed) {
  const Placement& placement = of.placement;
  if (placement.teams.empty() || !placement.loads || !has_capacities(of)) return {};
  const bool has_own = has_own_capacities(of);
  // `best` says nothing about robots with different capacities.
  if (has_own && model == LoadModel::best) return {};
  const std::string limit = limit_in_words(of);
  if (robots.empty()) return "No robot carries more than " + limit + ".";
  // `best` gives only the greatest load, not its robot; by `worst`, not all robots have their
  // greatest loads at once.
  if (model == LoadModel::best)
    return "However the weight is shared, some robot carries more than " + limit + ".";
  const std::size_t all = count_robots(placement.teams) - (failed ? 1 : 0);
  const std::string number = std::to_string(all), others = failed ? "the other " : "";
  const std::string who = robots.size() == all
                              ? "All " + others + number
                              : std::to_string(robots.size()) + " of " + others + number;
  const std::string verb = model == LoadModel::worst ? " can be"
                           : robots.size() == 1      ? " is"
                                                     : " are";
  const std::string which = robots.size() == all ? std::string() : ": " + robots_of(robots);
  return who + " robots" + verb + " overloaded" + (has_own ? "" : ", with more than " + limit) +
         which + ".";
}

// Whether loads may change for other reasons than a C uncertainty.
bool needs_level(const Shown& shown) {
  return disturbance_of(shown) != Disturbance{.reach = shown.com_radius};
}

// The plan counts with all robots working, level and even ground, and C as given. If other loads are shown, the text states
// this.
std::string need_in_words(const CapacityPlan& plan, const ShownPlacement& of, LoadModel model,
                          const std::optional<std::size_t>& failed) {
  const Settings& settings = of.placement.settings;
  const std::string presumed = failed                     ? "with no failures, "
                               : model != LoadModel::plan ? "as planned, "
                               : needs_level(of.shown)
                                   ? "on level, even ground and with C known exactly, "
                               : of.shown.com_radius > 0 ? "with C known exactly, "
                                                         : "";
  // For balanced robots only the weight counts (plan_capacity).
  const bool balanced = settings.method == Method::balanced;
  if (plan.possible)
    return capital((presumed.empty() ? "considering load only, " : presumed) +
                   (balanced ? "it takes " : "this method needs ") +
                   count_of(plan.team_size * plan.teams, "robot", "robots") +
                   (balanced ? ", with " : ", with at most ") +
                   load_in_words(plan.greatest_load, plan.greatest_load, of.shown.units) +
                   " each.");
  const std::string tried = std::to_string(plan.team_size * plan.tried);
  if (plan.tried >= most_teams_tried(settings) || plan.team_size == most_robots)
    return capital(presumed + "even " + tried + " robots are too few.");
  if (plan.tried == 0) return {};
  return capital(presumed + "even all " + tried + " robots that can be placed are too few.");
}

// The number of robots of which any one may fail.
std::string need_if_one_fails(const FailurePlan& plan, const Units& units) {
  if (plan.possible)
    return "To allow for any one failure: " + count_of(plan.robots, "robot", "robots") +
           ", at most " + load_in_words(plan.greatest_load, plan.greatest_load, units) +
           " each at rest if equally stiff.";
  if (plan.tried == 0) return {};
  return "No number up to " + count_of(plan.tried, "robot", "robots") +
         " was found to allow for any one failure.";
}

// For a hold that relies on a contact near a corner.
std::string near_corner_in_words(const ShownPlacement& of) {
  const Clearance& clearance = of.placement.closure.clearance;
  return "The hold depends on the accuracy of robot " +
         std::to_string(clearance.point.value_or(0) + 1) + ", which stands only " +
         promised_length(clearance.distance, of.shown.units) + " from a corner.";
}

// Whether some robot stands beneath the object.
bool stands_beneath(const Placement& placement) {
  for (const Team& team : placement.teams)
    for (const Robot& robot : team.robots)
      if (robot.point.edge == beneath) return true;
  return false;
}

// "It falls: the centre of mass is 12 mm outside the lifting base, beyond robots 2 and 3."
std::string fall_in_words(const ShownPlacement& of) {
  const Equilibrium equilibrium = evenlift::equilibrium(of.placement);
  const std::vector<std::size_t> over(equilibrium.tips_over.begin(), equilibrium.tips_over.end());
  const double outside = -equilibrium.com_margin;
  return "It falls: the centre of mass is " +
         with_length_unit(amount(outside, outside), of.shown.units) +
         " outside the lifting base, beyond " + robots_of(over) + ".";
}

// A margin below 0 measures how far form closure is missed, not the strength of a hold.
std::string hold_in_words(const Closure& closure) {
  if (closure.form_closure && closure.margin) return margin_in_words(*closure.margin);
  return closure.second_order ? "by curvature alone" : "not held";
}

}  // namespace

std::string loads_in_words(const ShownPlacement& of, LoadModel shown,
                           const std::vector<LoadRange>& ranges) {
  const Placement& placement = of.placement;
  if (!placement.search_ended && placement.teams.empty())
    return "Still looking for places for " + std::to_string(placement.settings.robots) + " robots.";
  if (placement.teams.empty())
    return placement.settings.method == Method::balanced ? "No robots can be placed."
                                                         : "No team can be placed.";
  if (!placement.loads) return fall_in_words(of);
  const Units& units = of.shown.units;
  const std::string in_all =
      " (" + weight_in_words(of) + (placement.settings.cargo.empty() ? " in all)." : ").");
  const std::string disturbance = disturbance_in_words(of.shown);
  const LoadSummary& loads = *placement.loads;
  const bool given = placement.settings.method == Method::given;
  const std::string stiff = given && !loads_are_determined(placement) ? "equally stiff " : "";
  const std::size_t number = count_robots(placement.teams);
  const std::string robots = (shown == LoadModel::plan ? ""
                              : given                  ? "If equally stiff, "
                                                       : "As planned, ") +
                             std::to_string(number) + " " +
                             (shown == LoadModel::plan ? stiff : "") +
                             (number == 1 ? "robot" : "robots"),
                    carry = number == 1 ? " carries " : " carry ",
                    each = number == 1 ? "" : " each";
  if (shown == LoadModel::plan && !disturbance.empty() && !ranges.empty()) {
    double least = ranges.front().least, greatest = 0;
    for (const LoadRange& range : ranges) {
      least = std::min(least, range.least);
      greatest = std::max(greatest, range.greatest);
    }
    return robots + carry + load_in_words(least, greatest, greatest, units) + each + ", " +
           disturbance + in_all;
  }
  if (placement.settings.method == Method::balanced)
    return robots + " carry equal loads of " + load_in_words(loads.max, loads.max, units) + in_all;
  return robots + carry + load_in_words(loads.min, loads.max, loads.max, units) + each + in_all;
}

std::string weight_in_words(const ShownPlacement& of) {
  const Settings& settings = of.placement.settings;
  const std::string all = given_weight(of.placement.weight(), of.shown.units);
  if (settings.cargo.empty()) return all;
  double cargo = 0;
  for (const Cargo& item : settings.cargo) cargo += item.weight;
  return all + " with its cargo of " + given_weight(cargo, of.shown.units);
}

std::string outline_in_words(const PolygonWithHoles& object) {
  const std::string vertices = count_of(object.outline().size(), "vertex", "vertices");
  const std::size_t holes = object.holes().size();
  return holes == 0 ? vertices : vertices + ", " + count_of(holes, "hole", "holes");
}

std::string no_go_in_words(const std::vector<EdgePart>& no_go) {
  constexpr std::size_t most_named = 3;
  if (no_go.empty()) return {};
  if (no_go.size() > most_named)
    return "No robot touches the " + std::to_string(no_go.size()) + " no-go parts of the boundary.";
  std::string text = "No robot touches ";
  for (std::size_t i = 0; i < no_go.size(); ++i) {
    const EdgePart& part = no_go[i];
    text += (i == 0 ? "edge " : ", nor edge ") + std::to_string(part.edge + 1);
    if (part.from != 0 || part.to != 1)
      text +=
          " between " + percentage(part.from) + " and " + percentage(part.to) + " of its length";
  }
  return text + ".";
}

std::string unusable_in_words(WhyUnusable why, const RobotSize& robot, const Units& units) {
  const auto size = [&](double value) { return with_length_unit(plain(value), units); };
  switch (why) {
    case WhyUnusable::no_go:
      return "no-go: no robot may touch this";
    case WhyUnusable::body:
      return "a robot of radius " + size(robot.radius) + " does not fit here";
    case WhyUnusable::arm:
      return "an arm of reach " + size(robot.reach) + " would cross the object";
    case WhyUnusable::corner:
      return robot.width > 0 ? "a hand of width " + size(robot.width) + " would stick out here"
                             : "no robot stands at a corner";
    case WhyUnusable::hand:
      return "a hand of depth " + size(robot.depth) + " would stick out here";
    case WhyUnusable::hole:
      return "a hand of depth " + size(robot.depth) + " would reach into a hole here";
    case WhyUnusable::near_no_go:
      return "a hand of width " + size(robot.width) + " would reach a no-go part";
    case WhyUnusable::narrow:
      break;
  }
  return "too short for a robot between its neighbours";
}

std::string shortage_in_words(const Placement& placement) {
  const bool by_ratio = selects_candidates(placement.settings.method);
  const std::size_t teams = placement.teams.size();
  if (teams == 0 && !placement.search_ended) return {};
  if (teams == 0 && placement.settings.method == Method::balanced)
    return "No places were found for " + std::to_string(placement.settings.robots) +
           " balanced robots" + (placement.stands ? " of this size" : "") +
           ": their centroid must be the centre of mass.";
  const bool has_size = !(placement.settings.robot == RobotSize{});
  if (teams == 0 && placement.stands)
    return has_size
               ? "No chord through the centre of mass where two robots of this size can stand meets the minimum load ratio. Lower the minimum, or use smaller robots."
               : "No chord through the centre of mass that avoids the no-go edges meets the minimum load ratio. Lower the minimum, or allow more edges.";
  if (teams == 0)
    return by_ratio
               ? "No chord through the centre of mass meets the minimum load ratio. Lower the minimum, or move the centre of mass."
               : "No line through the centre of mass meets the boundary on both sides of it.";
  if (teams >= placement.requested_teams) return {};
  return "There is room for only " + std::to_string(teams) + " of " +
         count_of(placement.requested_teams, "team", "teams") +
         (placement.stands && placement.candidates.size() > teams
              ? ": anywhere else, robots would be too close to each other."
          : placement.stands && has_size ? " at this minimum load ratio with robots of this size."
          : placement.stands ? " at this minimum load ratio on the allowed parts of the boundary."
          : by_ratio         ? " at this minimum load ratio."
                             : ".");
}

std::string coverage_in_words(const Placement& placement) {
  if (placement.teams.empty() || !placement.loads) return {};
  if (placement.lifting_base.size() == 1) return "It stands on one point, so it can tip.";
  if (placement.lifting_base.size() < 3) return "They stand on one line, so the object can tip.";
  if (placement.coverage >= 1 - tau) return "Pressing down anywhere on the object does not tip it.";
  if (placement.coverage <= tau) return "Pressing down anywhere on the object can tip it.";
  std::string share = percentage(placement.coverage);
  for (const auto& [sign, words] : {std::pair("<", "less than"), {">", "more than"}})
    if (share.starts_with(sign)) share.replace(0, 1, words);
  if (placement.coverage < good_coverage && !share.starts_with("less"))
    share = "only " + share + " of the object, less than half,";
  else
    share += " of the object";
  return capital(share + " can be pressed down on without tipping it.");
}

std::string closure_in_words(const ShownPlacement& of) {
  const Placement& placement = of.placement;
  if (placement.teams.empty()) return {};
  const Closure& closure = placement.closure;
  if (closure.form_closure && !hold_clearly(placement)) return near_corner_in_words(of);
  if (closure.form_closure)
    return "The robots' contact alone stops it from sliding or turning. Robots may be off by " +
           promised_length(closure.clearance.tolerance, of.shown.units) + " along their edges.";
  if (closure.second_order)
    return "It is held only to second order: any movement jams as soon as it begins.";
  if (!closure.margin && stands_beneath(placement))
    return "No robot that touches it from the side keeps it from sliding or turning.";
  if (!closure.margin)
    return "All robots stand on corners, where contacts are not counted: nothing else keeps it from "
           "sliding or turning.";
  return "It can still " + free_motions_in_words(closure) + ".";
}

std::string free_motions_in_words(const Closure& closure) {
  const bool clockwise = closure.clockwise.exists,
             counterclockwise = closure.counterclockwise.exists;
  std::string turn = clockwise && counterclockwise ? "turn either way"
                     : clockwise                   ? "turn clockwise"
                     : counterclockwise            ? "turn counter-clockwise"
                                                   : "";
  if (!closure.translation_free) return turn;
  return turn.empty() ? "slide" : turn + " and slide";
}

bool is_held(const Placement& placement) {
  return placement.closure.form_closure ? hold_clearly(placement) : placement.closure.second_order;
}

std::string detail_in_words(const ShownPlacement& of) {
  const Placement& placement = of.placement;
  const std::string coverage = coverage_in_words(placement), closure = closure_in_words(of);
  // Problems come first.
  const bool closure_first = !is_held(placement) && placement.coverage >= good_coverage;
  return joined({shortage_in_words(placement), closure_first ? closure : coverage,
                 closure_first ? coverage : closure});
}

std::string verdict(const ShownPlacement& of, LoadModel shown,
                    const std::vector<LoadRange>& ranges) {
  return joined({loads_in_words(of, shown, ranges), detail_in_words(of)});
}

std::string limit_in_words(const ShownPlacement& of) {
  return has_own_capacities(of) ? "its capacity" : given_weight(*of.shown.capacity, of.shown.units);
}

std::string capacity_in_words(const ShownPlacement& of, const CapacityPlan* plan,
                              const FailurePlan* if_one_fails) {
  return capacity_in_words(of, plan, overloaded_robots(of), LoadModel::plan, std::nullopt,
                           if_one_fails);
}

std::string capacity_in_words(const ShownPlacement& of, const CapacityPlan* plan,
                              const std::vector<std::size_t>& overloaded, LoadModel model,
                              const std::optional<std::size_t>& failed,
                              const FailurePlan* if_one_fails) {
  return joined({overload_in_words(of, overloaded, model, failed),
                 plan ? need_in_words(*plan, of, model, failed) : std::string(),
                 if_one_fails ? need_if_one_fails(*if_one_fails, of.shown.units) : std::string()});
}

std::vector<Fact> facts_in_words(const ShownPlacement& of) {
  const Placement& placement = of.placement;
  const Units& units = of.shown.units;
  const bool in_pairs = !is_one_team(placement.settings.method);
  std::vector<Fact> facts;
  if (in_pairs)
    facts.push_back({"Candidate teams", std::to_string(placement.candidates.size()),
                     "One for each candidate chord at this minimum load ratio; two robots each"});
  if (placement.teams.empty()) return facts;
  facts.push_back(
      {"Coverage", percentage(placement.coverage, 1),
       "Share of the object above the lifting base: pressing down there does not tip it, if robots "
       "push back and none is overloaded"});
  if (const auto& loads = placement.loads) {
    facts.push_back({"Mean load", load_in_words(loads->mean, loads->max, units), "Of all robots"});
    facts.push_back({"Spread of loads", load_in_words(loads->spread, loads->max, units),
                     "Greatest load minus least load"});
    if (in_pairs)
      facts.push_back(
          {"Greatest share in a team", percentage(loads->max_share, 1), "50 % in an even team"});
  }
  const Closure& closure = placement.closure;
  facts.push_back(
      {"Form closure", form_closure_in_words(closure),
       "Whether the robots' contact alone keeps the object from moving in the plane, to first "
       "order, if no robot gives way"});
  facts.push_back({"Margin", hold_in_words(closure),
                   "Strength of form closure; compare only placements of the same object"});
  if (closure.form_closure)
    facts.push_back(
        {"Robots may be off by", promised_length(closure.clearance.tolerance, of.shown.units),
         "All robots at once, each along its edge, except robots in inward corners: form closure "
         "remains"});
  return facts;
}

TeamInWords team_in_words(const Placement& placement, std::size_t team, int coordinate_decimals) {
  const Team& shown = placement.teams[team];
  TeamInWords words{ratio_in_words(shown.ratio), {}, {}, {}};
  if (shown.robots.size() == 2) {
    const double length = shown.robots[0].arm + shown.robots[1].arm;
    words.length = amount(length, length);
  }
  for (const Robot& robot : shown.robots) {
    words.at.push_back(point_in_words(robot.point.position, coordinate_decimals));
    words.loads.push_back(amount(robot.load, placement.loads ? placement.loads->max : 0));
  }
  return words;
}

std::string method_in_words(Method method) {
  return method == Method::distributed ? "equal angles"
         : method == Method::given     ? "by hand"
                                       : std::string(name(method));
}

std::string form_closure_in_words(const Closure& closure) {
  return closure.form_closure ? "yes" : closure.second_order ? "second order" : "no";
}

std::string sentence(const InputError& error) {
  const std::string place = describe(error.place), &message = error.message;
  constexpr std::string_view both = "the edges ";
  if (place.starts_with("edges ") && message.starts_with(both))
    return capital(place + " " + message.substr(both.size()));
  const bool option = error.place.kind == Place::Kind::option,
             whole_link = error.place.kind == Place::Kind::link && error.place.index == 0;
  // A message about a setting or a link usually begins with its subject; a name in front would only
  // repeat it.
  const bool named = message.starts_with("the ") || message.starts_with("no edge ") ||
                     message.starts_with("there is no edge ");
  const bool doubled = message.find("the " + place) != std::string::npos;  // "the centre of mass"
  if (place.empty() || doubled || (named && (option || whole_link))) return capital(message);
  // The name of a setting keeps its spelling.
  return option ? place + ": " + message : capital(place + ": " + message);
}

}  // namespace evenlift
