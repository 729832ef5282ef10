#include "evenlift/output/words.h"

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/robustness_words.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "evenlift/stands.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
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

// "robots 3 and 4", from 1.
std::string robots_of(const Placement& placement, const std::vector<std::size_t>& robots) {
  return say(robots.size() == 1 ? "robot {robots}" : "robots {robots}",
             {numbers_of(placement, robots)});
}

// Whether the loads of this model are shown as ranges.
bool shows_ranges(const Reported& of, LoadModel model) {
  return has_ranges(model) && of.report.disturbance.any();
}

// Of these robots, by this model.
std::string overload_in_words(const Reported& of, const std::vector<std::size_t>& robots,
                              LoadModel model) {
  const Placement& placement = of.placement;
  const Report& report = of.report;
  if (placement.teams.empty() || !placement.loads || !report.has_capacities) return {};
  const bool failed = report.failed.has_value(), has_own = report.has_own_capacities;
  // What tips carries nothing.
  if (!failed && shows_ranges(of, model) && report.tips) return {};
  // `best` ignores different capacities.
  if (has_own && model == LoadModel::best) return {};
  const std::string limit = limit_in_words(of);
  if (robots.empty()) {
    // If a given support stands a little high, some can be overloaded (if_uneven_in_words).
    const bool given = placement.settings.method == Method::given && !failed;
    const bool if_uneven =
        given && !report.loads_are_determined && !report.overloaded_at_worst.empty();
    return if_uneven ? std::string() : say("No robot carries more than {limit}.", {limit});
  }
  // `best` gives the greatest load, not its robot. By `worst`, and in ranges, not all robots have
  // their greatest loads at once.
  if (model == LoadModel::best)
    return say("However the weight is shared, some robot carries more than {limit}.", {limit});
  constexpr const char* sentences[3][2] = {
      {"{who} can be overloaded", "{who} can be overloaded, with more than {limit}"},
      {"{who} is overloaded", "{who} is overloaded, with more than {limit}"},
      {"{who} are overloaded", "{who} are overloaded, with more than {limit}"}};
  const std::size_t all = count_robots(placement.teams) - (failed ? 1 : 0);
  const bool are_all = robots.size() == all;
  const std::string who =
      are_all ? say(failed ? "All the other {number} robots" : "All {number} robots", {all})
              : say(failed ? "{some} of the other {number} robots" : "{some} of {number} robots",
                    {robots.size(), all});
  const std::string values[] = {who, limit};
  const std::size_t verb = model == LoadModel::worst || shows_ranges(of, model) ? 0
                           : robots.size() == 1                                 ? 1
                                                                                : 2;
  return say_written(sentences[verb][has_own ? 0 : 1], values, has_own ? 1 : 2) +
         (are_all ? "" : ": " + robots_of(placement, robots)) + ".";
}

// The plan assumes that all robots work, level and even ground, and an exact C. If other loads are
// shown, the text says so.
std::string need_in_words(const CapacityPlan& plan, const Reported& of) {
  const Settings& settings = of.placement.settings;
  const char* presumed =
      of.report.failed                     ? "Considering load only, with no failures"
      : of.report.model != LoadModel::plan ? "Considering load only, as planned"
      : of.report.disturbance.besides_com()
          ? "Considering load only, on level, even ground and with C known exactly"
      : of.shown.com_radius > 0 ? "Considering load only, with C known exactly"
                                : nullptr;
  // For balanced robots, the plan does not check whether such a set exists (plan_capacity).
  const bool balanced = settings.method == Method::balanced;
  if (plan.possible)
    return say(balanced ? "{presumed}, it takes {robots}, with {load} each."
                        : "{presumed}, this method needs {robots}, with at most {load} each.",
               {presumed ? presumed : "Considering load only",
                count_of(plan.team_size * plan.teams, "robot", "robots"),
                load_in_words(plan.greatest_load, of.shown.units, Toward::up)});
  const std::uint32_t tried = plan.team_size * plan.tried;
  // More robots may have room, but were not tried.
  const bool stopped =
      plan.cut_short || plan.tried >= most_teams_tried(settings) || plan.team_size == most_robots ||
      (swaps_teams(settings) &&
       check_swaps(of.placement.candidates.size(), plan.tried + 1, of.placement.stands.get()));
  if (stopped)
    return presumed ? say("{presumed}, even {number} robots are too few.", {presumed, tried})
                    : say("Even {number} robots are too few.", {tried});
  if (plan.tried == 0) return {};
  return presumed ? say("{presumed}, even all {number} robots that can be placed are too few.",
                        {presumed, tried})
                  : say("Even all {number} robots that can be placed are too few.", {tried});
}

std::string need_if_one_fails(const FailurePlan& plan, const Reported& of) {
  if (of.placement.settings.method == Method::given) return {};
  if (plan.possible || plan.can_tip)
    return say(
        plan.can_tip
            ? "To allow for any one failure: {robots}, at most {load} each at rest if equally stiff, "
              "but the object can then tip."
        : of.report.disturbance.any()
            ? "To allow for any one failure: {robots}, at most {load} each if equally stiff, within "
              "the given conditions."
            : "To allow for any one failure: {robots}, at most {load} each at rest if equally stiff.",
        {count_of(plan.robots, "robot", "robots"),
         load_in_words(plan.greatest_load, of.shown.units, Toward::up)});
  if (plan.tried == 0) return say("No number of robots was found to allow for any one failure.");
  return say("No number up to {robots} was found to allow for any one failure.",
             {count_of(plan.tried, "robot", "robots")});
}

// That the hold is not firm, and why.
std::string fragile_hold_in_words(const ShownPlacement& of) {
  const Clearance& clearance = of.placement.closure.clearance;
  HoldRequirements hold = hold_requirements(of.placement);
  hold.tolerance = 0;
  if (is_firm(of.placement.polygon(), clearance, hold))
    return clearance.tolerance > near_distance(of.placement.polygon().diameter())
               ? say("It is held only as long as robots stand within {distance} of their places.",
                     {promised_length(clearance.tolerance, of.shown.units)})
               : say("It is held only as long as robots stand exactly.");
  return say(
      "It is held only as long as robot {robot} stands accurately: it is only {distance} from a "
      "corner.",
      {of.placement.called(clearance.point.value_or(0)),
       promised_length(clearance.distance, of.shown.units)});
}

bool stands_beneath(const Placement& placement) {
  for (const Team& team : placement.teams)
    for (const Robot& robot : team.robots)
      if (robot.point.edge == beneath) return true;
  return false;
}

// "It falls: the centre of mass is 12 mm outside the lifting base, beyond robots 2 and 3."
std::string fall_in_words(const Reported& of) {
  const Equilibrium& equilibrium = of.report.equilibrium;
  const std::vector<std::size_t> over(equilibrium.tips_over.begin(), equilibrium.tips_over.end());
  const double outside = -equilibrium.com_margin;
  return say(
      "It falls: the centre of mass is {distance} outside the lifting base, beyond {robots}.",
      {with_length_unit(amount(outside, outside), of.shown.units), robots_of(of.placement, over)});
}

// For messages about settings and links.
bool names_its_subject(std::string_view message) {
  // A translation lists its own beginnings.
  std::string_view beginnings = translated("the |no edge |there is no edge ");
  while (!beginnings.empty()) {
    const std::string_view beginning = beginnings.substr(0, beginnings.find('|'));
    if (message.starts_with(beginning)) return true;
    beginnings.remove_prefix(std::min(beginning.size() + 1, beginnings.size()));
  }
  return false;
}

}  // namespace

std::string loads_in_words(const Reported& of, TellWeight weight) {
  const Placement& placement = of.placement;
  if (!placement.search_ended && placement.teams.empty())
    return say("Still looking for places for {number} robots.", {placement.settings.robots});
  if (placement.teams.empty())
    return say(placement.settings.method == Method::balanced ? "No robots can be placed."
               : placement.settings.method == Method::given  ? "No robot stands at the object."
                                                             : "No team can be placed.");
  if (!placement.loads) return fall_in_words(of);
  const Units& units = of.shown.units;
  const std::string all = placement.settings.cargo.empty()
                              ? say("{weight} in all", {weight_in_words(of)})
                              : weight_in_words(of);
  const bool tips = of.report.tips;
  const std::string disturbance = tips ? std::string() : disturbance_in_words(of.shown);
  const LoadSummary& loads = *placement.loads;
  const bool given = placement.settings.method == Method::given,
             planned = of.report.model == LoadModel::plan;
  const std::size_t number = count_robots(placement.teams);
  const std::string robots = planned && given && !of.report.loads_are_determined
                                 ? count_of(number, "equally stiff robot", "equally stiff robots")
                                 : count_of(number, "robot", "robots");
  const auto ended = [&](const std::string& sentence) {
    return weight == TellWeight::no ? sentence + "." : say("{sentence} ({all}).", {sentence, all});
  };
  if (planned && !disturbance.empty()) {
    double least = of.report.greatest;
    for (const LoadRange& range : of.report.loads) least = std::min(least, range.least);
    return ended(
        say(number == 1 ? "{robots} carries {load}, {conditions}"
                        : "{robots} carry {load} each, {conditions}",
            {robots, load_in_words(LoadRange{least, of.report.greatest}, of.report.greatest, units),
             disturbance}));
  }
  constexpr const char* sentences[4][3] = {
      {"{robots} carries {load}", "{robots} carry {load} each",
       "{robots} carry equal loads of {load}"},
      {"If equally stiff, {robots} carries {load}", "If equally stiff, {robots} carry {load} each",
       "If equally stiff, {robots} carry equal loads of {load}"},
      {"As planned, {robots} carries {load}", "As planned, {robots} carry {load} each",
       "As planned, {robots} carry equal loads of {load}"},
      {"On level ground and with C as given, {robots} carries {load}",
       "On level ground and with C as given, {robots} carry {load} each",
       "On level ground and with C as given, {robots} carry equal loads of {load}"}};
  const bool equal = placement.settings.method == Method::balanced;
  return ended(say(sentences[tips      ? 3
                             : planned ? 0
                             : given   ? 1
                                       : 2][equal         ? 2
                                          : number == 1 ? 0
                                                        : 1],
                   {robots, equal ? load_in_words(loads.max, loads.max, units)
                                  : load_in_words(loads.min, loads.max, loads.max, units)}));
}

std::string weight_in_words(const ShownPlacement& of) {
  const Settings& settings = of.placement.settings;
  const std::string all = given_weight(of.placement.weight(), of.shown.units);
  if (settings.cargo.empty()) return all;
  double cargo = 0;
  for (const Cargo& item : settings.cargo) cargo += item.weight;
  return say("{weight} with its cargo of {cargo}", {all, given_weight(cargo, of.shown.units)});
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
    return say("No robot touches the {number} no-go parts of the boundary.", {no_go.size()});
  std::string parts;
  for (const EdgePart& part : no_go) {
    const std::string words =
        part.from == 0 && part.to == 1
            ? say("edge {edge}", {part.edge + 1})
            : say("edge {edge} between {from} and {to} of its length",
                  {part.edge + 1, percentage(part.from), percentage(part.to)});
    parts = parts.empty() ? words : say("{parts}, nor {part}", {parts, words});
  }
  return say("No robot touches {parts}.", {parts});
}

std::string unusable_in_words(WhyUnusable why, const RobotSize& robot, const Units& units) {
  const auto size = [&](double value) { return with_length_unit(plain(value), units); };
  switch (why) {
    case WhyUnusable::no_go:
      return say("no-go: no robot may touch this");
    case WhyUnusable::body:
      return say("a robot of radius {radius} does not fit here", {size(robot.radius)});
    case WhyUnusable::arm:
      return say("an arm of reach {reach} would cross the object", {size(robot.reach)});
    case WhyUnusable::corner:
      return robot.width > 0
                 ? say("a hand of width {width} would stick out here", {size(robot.width)})
                 : say("no robot stands at a corner");
    case WhyUnusable::hand:
      return say("a hand of depth {depth} would stick out here", {size(robot.depth)});
    case WhyUnusable::hole:
      return say("a hand of depth {depth} would reach into a hole here", {size(robot.depth)});
    case WhyUnusable::near_no_go:
      return say("a hand of width {width} would reach a no-go part", {size(robot.width)});
    case WhyUnusable::narrow:
      break;
  }
  return say("too short for a robot between its neighbours");
}

namespace {

std::string why_short(const Placement& placement) {
  const bool by_ratio = selects_candidates(placement.settings.method);
  const std::size_t teams = placement.teams.size();
  if (teams == 0 && !placement.search_ended) return {};
  if (placement.settings.method == Method::given) return {};
  if (teams == 0 && !check_centre_of_mass(placement.polygon(), placement.centre_of_mass))
    return say("The centre of mass is outside the object, beyond all places for robots.");
  if (teams == 0 && placement.settings.method == Method::balanced)
    return say(
        placement.stands
            ? "No places were found for {number} balanced robots of this size: their centroid "
              "must be the centre of mass."
            : "No places were found for {number} balanced robots: their centroid must be the "
              "centre of mass.",
        {placement.settings.robots});
  const bool has_size = !(placement.settings.robot == RobotSize{});
  if (teams == 0 && placement.stands)
    return say(
        has_size
            ? "No chord through the centre of mass where two robots of this size can stand meets the minimum load ratio. Lower the minimum, or use smaller robots."
            : "No chord through the centre of mass that avoids the no-go edges meets the minimum load ratio. Lower the minimum, or allow more edges.");
  if (teams == 0)
    return say(
        by_ratio
            ? "No chord through the centre of mass meets the minimum load ratio. Lower the minimum, or move the centre of mass."
            : "No line through the centre of mass meets the boundary on both sides of it.");
  if (teams >= placement.requested_teams) return {};
  return say(
      placement.stands && placement.candidates.size() > teams
          ? "There is room for only {teams} of {requested}: anywhere else, robots would be too close to each other."
      : placement.stands && has_size
          ? "There is room for only {teams} of {requested} at this minimum load ratio with robots of this size."
      : placement.stands
          ? "There is room for only {teams} of {requested} at this minimum load ratio on the allowed parts of the boundary."
      : by_ratio ? "There is room for only {teams} of {requested} at this minimum load ratio."
                 : "There is room for only {teams} of {requested}.",
      {teams, count_of(placement.requested_teams, "team", "teams")});
}

}  // namespace

std::string shortage_in_words(const Placement& placement) {
  std::string why = why_short(placement);
  if (why.empty() || !placement.accuracy_with_room) return why;
  const Settings& settings = placement.settings;
  const std::size_t robots =
      settings.method == Method::balanced ? settings.robots : 2 * placement.requested_teams;
  return why + " " +
         say("That is for robots that may be off by {accuracy}; with {less} there is room for {robots}.",
             {plain(*settings.accuracy),
              significant(*placement.accuracy_with_room, 2, Toward::down),
              count_of(robots, "robot", "robots")});
}

std::string cut_short_in_words(const Placement& placement) {
  if (!placement.cut_short) return {};
  return say("The search was cut short by its limit of work: there may be better places.");
}

std::string coverage_in_words(const Placement& placement) {
  if (placement.teams.empty() || !placement.loads) return {};
  if (placement.lifting_base.size() == 1) return say("It stands on one point, so it can tip.");
  if (placement.lifting_base.size() < 3)
    return say("They stand on one line, so the object can tip.");
  if (placement.coverage >= 1 - tau)
    return say("Pressing down anywhere on the object does not tip it.");
  if (placement.coverage <= tau) return say("Pressing down anywhere on the object can tip it.");
  const std::string share = percentage(placement.coverage);
  for (const auto& [sign, sentence] :
       {std::pair(
            "<\u00A0",
            "Less than\u00A0{share} of the object can be pressed down on without tipping it."),
        std::pair(
            ">\u00A0",
            "More than\u00A0{share} of the object can be pressed down on without tipping it.")})
    if (share.starts_with(sign))
      return say(sentence, {share.substr(std::string_view(sign).size())});
  return say(placement.coverage < good_coverage
                 ? "Only {share} of the object, less than half, can be pressed down on without "
                   "tipping it."
                 : "{share} of the object can be pressed down on without tipping it.",
             {share});
}

std::string closure_in_words(const Reported& of) {
  const Placement& placement = of.placement;
  if (placement.teams.empty()) return {};
  const Closure& closure = placement.closure;
  if (closure.form_closure && !of.report.firm) return fragile_hold_in_words(of);
  if (closure.form_closure)
    return say("The robots hold it: it can neither slide nor turn, even without friction.");
  if (closure.second_order)
    return say("It is held only to second order: any movement jams as soon as it begins.");
  if (!closure.margin && stands_beneath(placement))
    return say(
        "No robot touches an edge from the side, so nothing keeps it from sliding or turning.");
  if (!closure.margin)
    return say(
        "All robots stand on corners, where contacts are not counted: nothing else keeps it from "
        "sliding or turning.");
  return say("It can still {motions}.", {free_motions_in_words(closure)});
}

std::string free_motions_in_words(const Closure& closure) {
  const bool clockwise = closure.clockwise.exists,
             counterclockwise = closure.counterclockwise.exists;
  const char* turn = clockwise && counterclockwise ? "turn either way"
                     : clockwise                   ? "turn clockwise"
                     : counterclockwise            ? "turn counter-clockwise"
                                                   : nullptr;
  if (!closure.translation_free) return turn ? say(turn) : std::string();
  return turn ? say("{turn} and slide", {turn}) : say("slide");
}

std::string detail_in_words(const Reported& of) {
  const Placement& placement = of.placement;
  const std::string coverage = coverage_in_words(placement), closure = closure_in_words(of);
  // A press matters only where the object stays without one. Problems come first.
  // Where there is a problem, there is little room: the facts say how far robots may be off.
  const bool is_well = of.report.held && placement.coverage >= good_coverage;
  const bool is_asked = placement.settings.accuracy.value_or(0) > 0;
  const std::string accuracy = is_well || is_asked ? accuracy_in_words(of) : std::string();
  if (of.report.tips) return joined({shortage_in_words(placement), closure, accuracy});
  const bool closure_first = !of.report.held && placement.coverage >= good_coverage;
  return joined({shortage_in_words(placement), upright_in_words(of),
                 closure_first ? closure : coverage, closure_first ? coverage : closure, accuracy});
}

std::string worst_news_in_words(const Reported& of) {
  if (!of.placement.loads) return {};
  const std::string tips = tipping_in_words(of);
  if (!tips.empty() || of.report.overloaded.empty()) return tips;
  return overload_in_words(of, of.report.overloaded, of.report.model);
}

std::string if_uneven_in_words(const Reported& of) {
  const Placement& placement = of.placement;
  const Report& report = of.report;
  if (placement.settings.method != Method::given || !placement.loads ||
      report.loads_are_determined || report.tips || !report.worst || report.worst->empty())
    return {};
  const std::vector<double>& worst = *report.worst;
  const bool are_shown =
      std::equal(worst.begin(), worst.end(), report.loads.begin(), report.loads.end(),
                 [](double load, const LoadRange& range) { return load == range.greatest; });
  if (are_shown) return {};
  const double most = *std::max_element(worst.begin(), worst.end());
  std::vector<std::size_t> who;
  for (std::size_t i = 0; i < worst.size(); ++i)
    if (worst[i] >= most - tau * placement.weight()) who.push_back(i);
  const std::string load = load_in_words(most, of.shown.units, Toward::up);
  constexpr std::size_t most_named = 3;
  const std::string text =
      who.size() > most_named
          ? say("If one of them stands a little high, some robot can come to carry {load}.", {load})
          : say("If one of them stands a little high, {robots} can come to carry {load}.",
                {robots_of(of.placement, who), load});
  const std::vector<std::size_t>& overloaded = report.overloaded_at_worst;
  if (overloaded.empty() || overloaded == report.overloaded) return text;
  return text + " " + overload_in_words(of, overloaded, LoadModel::worst);
}

std::string verdict(const Reported& of) {
  return joined(
      {worst_news_in_words(of), loads_in_words(of), if_uneven_in_words(of), detail_in_words(of)});
}

std::string limit_in_words(const ShownPlacement& of) {
  const double factor = of.shown.carrying.load_factor();
  const std::string text = plain(std::round(1e4 * factor) / 1e4);
  if (has_own_capacities(of))
    return factor == 1 ? say("its capacity") : say("its capacity divided by {factor}", {text});
  const std::string capacity = given_weight(*of.shown.capacity, of.shown.units);
  return factor == 1 ? capacity : say("{capacity} divided by {factor}", {capacity, text});
}

std::string capacity_in_words(const Reported& of) {
  return joined({overload_in_words(of, of.report.overloaded, of.report.model), needs_in_words(of)});
}

std::string needs_in_words(const Reported& of) {
  const auto& [plan, if_one_fails] = std::tie(of.report.plan, of.report.if_one_fails);
  return joined({plan ? need_in_words(*plan, of) : std::string(),
                 if_one_fails ? need_if_one_fails(*if_one_fails, of) : std::string()});
}

int place_decimals(const Placement& placement) {
  constexpr int most_more = 2;
  const Polygon& polygon = placement.polygon();
  const double at_vertex = 3 * near_distance(polygon.diameter());
  const int usual = coordinate_decimals(placement.vertices());
  int decimals = usual;
  double last_place = 1;
  for (int i = 0; i < usual; ++i) last_place /= 10;
  const auto rounds_to_vertex = [&](const LiftingPoint& point) {
    if (point.edge == beneath) return false;
    const double to_vertex = std::min(length(point.position - polygon.edge_start(point.edge)),
                                      length(point.position - polygon.edge_end(point.edge)));
    return to_vertex > at_vertex && to_vertex < last_place;
  };
  for (const LiftingPoint& point : lifting_points(placement.teams))
    while (decimals < usual + most_more && rounds_to_vertex(point)) {
      ++decimals;
      last_place /= 10;
    }
  return decimals;
}

TeamInWords team_in_words(const Placement& placement, std::size_t team, int decimals) {
  const Team& shown = placement.teams[team];
  TeamInWords words{ratio_in_words(shown.ratio), {}, {}, {}};
  if (shown.robots.size() == 2) {
    const double length = shown.robots[0].arm + shown.robots[1].arm;
    words.length = amount(length, length);
  }
  for (const Robot& robot : shown.robots) {
    words.at.push_back(point_in_words(robot.point.position, decimals));
    words.loads.push_back(amount(robot.load, placement.loads ? placement.loads->max : 0));
  }
  return words;
}

std::string method_in_words(Method method) {
  return say(method == Method::distributed ? "equal angles"
             : method == Method::given     ? "by hand"
                                           : name(method));
}

std::string form_closure_in_words(const Closure& closure) {
  return closure.form_closure ? "yes" : closure.second_order ? "second order" : "no";
}

std::string sentence(const InputError& error) {
  const std::string place = describe(error.place), message(translated(error.message));
  const std::string_view both = translated("the edges ");
  if (place.starts_with(translated("edges ")) && message.starts_with(both))
    return with_capital(place + " " + message.substr(both.size()));
  const bool option = error.place.kind == Place::Kind::option,
             whole_link = error.place.kind == Place::Kind::link && error.place.index == 0;
  // A message about a setting or a link usually begins with its subject; the name in front would
  // repeat it.
  const bool named = names_its_subject(message);
  // So would "centre of mass".
  const std::string within = error.place.kind == Place::Kind::centre_of_mass ? "" : "the ";
  const bool doubled = message.find(within + place) != std::string::npos ||
                       message.find('"' + place + '"') != std::string::npos;
  const bool is_name = option && place == error.place.option;  // not "robot 4"
  if (place.empty() || doubled || (named && (is_name || whole_link))) return with_capital(message);
  // A setting's name keeps its spelling.
  return is_name ? place + ": " + message : with_capital(place + ": " + message);
}

}  // namespace evenlift
