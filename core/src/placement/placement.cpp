#include "evenlift/placement.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

#include "evenlift/balanced.h"
#include "evenlift/centre_of_mass.h"
#include "evenlift/numbers.h"
#include "evenlift/placed_robots.h"
#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/supports.h"
#include "evenlift/swaps.h"
#include "evenlift/wording.h"
#include "placement/robot_drift.h"

namespace evenlift {
namespace {

bool reaches_goal(const Placement& placement) {
  if (placement.teams.empty()) return false;
  return goal_of(placement.settings) == Goal::cover || hold_firmly(placement);
}

void describe_grasp(Placement& placement, const std::vector<LiftingPoint>& points) {
  placement.lifting_base = lifting_base(placement.polygon(), points);
  placement.coverage = coverage(placement.object, placement.lifting_base);
  placement.closure = analyse_closure(placement.polygon(), placement.centre_of_mass,
                                      contact_points(placement.stands.get(), points));
  placement.goal_reached = reaches_goal(placement);
}

void take_loads(Placement& placement, const std::vector<double>& loads) {
  std::size_t number = 0;
  for (Team& team : placement.teams) {
    double least = loads[number], greatest = least;
    for (Robot& robot : team.robots) {
      robot.load = loads[number++];
      least = std::min(least, robot.load);
      greatest = std::max(greatest, robot.load);
    }
    team.ratio = greatest > 0 ? least / greatest : 0;
  }
}

LoadSummary summarize_others(const Placement& placement, std::size_t robot) {
  LoadSummary summary = *summarize_loads(placement.teams);
  const std::vector<double> loads = planned_loads(placement.teams);
  summary.min = summary.max;
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (i != robot) summary.min = std::min(summary.min, loads[i]);
  summary.mean = placement.weight() / static_cast<double>(loads.size() - 1);
  summary.spread = summary.max - summary.min;
  return summary;
}

// One team of all robots, balanced or given.
Team team_of(const Placement& placement, const std::vector<LiftingPoint>& robots) {
  return share_evenly(robots, placement.centre_of_mass, placement.weight());
}

void place_balanced(Placement& placement, Effort effort) {
  const BalancedProblem problem(placement.object, placement.centre_of_mass, placement.settings);
  placement.search_ended = effort == Effort::whole || is_quick_to_start(problem);
  if (!placement.search_ended) return;
  auto search = start_balanced(problem, &placement.cut_short);
  if (!search) return;
  if (effort == Effort::whole) search = finish_search(problem, *std::move(search));
  placement.teams = {team_of(placement, search->robots)};
  placement.search_ended = search->finished;
  placement.cut_short = search->cut_short;
}

// Where given supports lift; nothing for those that have no place. Without `stands` robots are
// points.
Result<std::vector<std::optional<LiftingPoint>>> lifting_supports(const PolygonWithHoles& object,
                                                                  const Settings& settings,
                                                                  const Stands* stands,
                                                                  Misfitting misfitting) {
  auto places = places_of_supports(object, settings);
  if (!places) return places;
  const auto has_place = [](const auto& place) { return place.has_value(); };
  if (misfitting == Misfitting::refused && !std::all_of(places->begin(), places->end(), has_place))
    return place_supports(object, settings).error();
  if (stands)
    for (auto& robot : *places)
      if (robot) robot = stands->lifting_point(stands->beside_vertex(object.outline(), *robot));
  return places;
}

// The supports share the weight like springs: their loads are not planned.
std::optional<InputError> place_given(Placement& placement, Misfitting misfitting) {
  const auto places =
      lifting_supports(placement.object, placement.settings, placement.stands.get(), misfitting);
  if (!places) return places.error();
  std::vector<LiftingPoint> robots;
  for (std::uint32_t i = 0; i < places->size(); ++i) {
    if ((*places)[i]) {
      robots.push_back(*(*places)[i]);
      placement.supports.push_back(i);
      continue;
    }
    const auto hole = placement.object.hole_around(placement.settings.supports[i]);
    placement.left_out.push_back({Misplaced::Kind::support, i, hole});
  }
  if (robots.size() == places->size()) placement.supports.clear();
  if (robots.empty()) return std::nullopt;
  placement.teams = {team_of(placement, robots)};
  const auto springs = spring_loads(positions(robots), placement.centre_of_mass,
                                    placement.polygon().diameter(), placement.weight());
  take_loads(placement, springs ? springs->loads : std::vector<double>(robots.size(), 0));
  return std::nullopt;
}

// If the robots do not carry the object, none has a load.
bool is_carried(const std::vector<Team>& teams) {
  for (const Team& team : teams)
    for (const Robot& robot : team.robots)
      if (robot.load > 0) return true;
  return false;
}

std::uint32_t requested_teams(const Placement& placement) {
  if (is_one_team(placement.settings.method)) return 1;
  return placement.settings.teams.value_or(static_cast<std::uint32_t>(placement.candidates.size()));
}

// Also stores the candidates that the teams use.
std::optional<InputError> choose_teams(Placement& placement, Effort effort,
                                       Misfitting misfitting = Misfitting::refused) {
  const Polygon& polygon = placement.polygon();
  const Vec2& centre = placement.centre_of_mass;
  const Settings& settings = placement.settings;
  const std::size_t teams = placement.requested_teams;
  std::vector<Chord> chords;
  switch (settings.method) {
    case Method::area:
    case Method::circle:
    case Method::distance: {
      ChosenTeams chosen = choose_candidates(placement.object, centre, placement.candidates,
                                             settings, teams, placement.stands.get());
      placement.team_candidates = std::move(chosen.taken);
      placement.cut_short = chosen.cut_short;
      chords = chords_of(placement.candidates, placement.team_candidates);
      break;
    }
    case Method::distributed:
      chords = distributed_teams(polygon, centre, teams);
      break;
    case Method::random:
      chords = random_teams(polygon, centre, teams, settings.seed);
      break;
    case Method::balanced:
      place_balanced(placement, effort);
      return std::nullopt;
    case Method::given:
      return place_given(placement, misfitting);
  }
  placement.teams = distribute_weight(chords, placement.weight());
  return std::nullopt;
}

}  // namespace

Result<std::vector<Candidate>> candidates_of(const Polygon& polygon, const Vec2& centre,
                                             const Settings& settings, const Stands* stands) {
  const double clear = hold_requirements(polygon, centre, settings).clear;
  if (!stands)
    return find_candidates(polygon, centre, settings.min_ratio, settings.positions, clear);
  auto found =
      standing_candidates(polygon, centre, settings.min_ratio, *stands, settings.positions, clear);
  if (!found) return found.error();
  return std::move(found->candidates);
}

namespace {

// The robots that the settings ask for; nothing if it is as many as possible.
std::optional<std::uint32_t> requested_robots(const Settings& settings) {
  if (settings.method == Method::balanced) return settings.robots;
  if (!settings.teams) return std::nullopt;
  return 2 * *settings.teams;
}

bool has_room_for_all(const PolygonWithHoles& object, const Vec2& centre,
                      const Settings& settings) {
  auto stands = make_stands(object, centre, settings);
  if (!stands) return false;
  auto candidates = candidates_of(object, centre, settings, stands->get());
  if (!candidates) return false;
  Placement placement(object);
  placement.stands = *std::move(stands);
  placement.centre_of_mass = centre;
  placement.settings = settings;
  placement.candidates = *std::move(candidates);
  placement.requested_teams = requested_teams(placement);
  return !choose_teams(placement, Effort::start) &&
         count_robots(placement.teams) >= requested_robots(settings).value_or(1);
}

// With which accuracy the robots would have room; nothing if the accuracy is not the reason, or if
// trying would take long. Swaps would not change the number of teams.
std::optional<double> accuracy_with_room(const PolygonWithHoles& object, const Vec2& centre,
                                         const Settings& settings) {
  const double asked = settings.accuracy.value_or(0);
  constexpr std::size_t most_vertices = 2000;
  if (!(asked > 0) || settings.method == Method::given || object.boundary().size() > most_vertices)
    return std::nullopt;
  return less_accuracy(asked, [&](double accuracy) {
    Settings less = settings;
    less.accuracy = accuracy;
    if (less.method != Method::balanced) less.goal = Goal::cover;
    return has_room_for_all(object, centre, less);
  });
}

InputError with_hint(InputError error, const PolygonWithHoles& object, const Vec2& centre,
                     const Settings& settings) {
  const auto robots = requested_robots(settings);
  const auto less = robots ? accuracy_with_room(object, centre, settings) : std::nullopt;
  if (!less) return error;
  return setting_error(
      Setting::accuracy,
      say("no edge has room for robots that may be off by {accuracy}; with "
          "{less} there is room for {robots}",
          {as_read(shortest(*settings.accuracy)), as_read(shortest(*less)), *robots}));
}

bool is_short(const Placement& placement) {
  const auto robots = requested_robots(placement.settings);
  return robots && count_robots(placement.teams) < *robots &&
         (placement.search_ended || !placement.teams.empty());
}

std::optional<InputError> check_balanced(const Settings& settings) {
  const std::uint32_t least = 2 * settings.survive + 3;
  if (settings.survive == 0 || settings.robots >= least) return std::nullopt;
  return setting_error(
      Setting::survive,
      say(settings.survive == 1
              ? "surviving {number} failure takes at least {least} robots, not {robots}"
              : "surviving {number} failures takes at least {least} robots, not {robots}",
          {settings.survive, least, settings.robots}));
}

std::optional<InputError> check_given(const Settings& settings, const Shown& shown) {
  if (settings.supports.empty())
    return setting_error(Setting::supports,
                         "the method given needs the places of its robots, such as "
                         "0,0 160,0 80,90");
  const std::size_t names = settings.support_names.size();
  if (names > 0 && names != settings.supports.size())
    return setting_error(
        Setting::support_names,
        say("{names} names are given for {supports} supports", {names, settings.supports.size()}));
  const std::size_t capacities = shown.support_capacities.size();
  if (capacities == 0 || capacities == settings.supports.size()) return std::nullopt;
  return setting_error(Setting::support_capacities,
                       say("{capacities} capacities are given for {supports} supports",
                           {capacities, settings.supports.size()}));
}

}  // namespace

void describe_grasp(Placement& placement) {
  placement.loads.reset();
  if (is_carried(placement.teams)) placement.loads = summarize_loads(placement.teams);
  describe_grasp(placement, lifting_points(placement.teams));
}

HoldRequirements hold_requirements(const Placement& placement) {
  return hold_requirements(placement.polygon(), placement.centre_of_mass, placement.settings);
}

bool hold_firmly(const Placement& placement) {
  const Closure& closure = placement.closure;
  return closure.form_closure &&
         is_firm(placement.polygon(), closure.clearance, hold_requirements(placement));
}

bool is_held(const Placement& placement) {
  return placement.closure.form_closure ? hold_firmly(placement) : placement.closure.second_order;
}

std::vector<LiftingPoint> contact_points(const Placement& placement) {
  return contact_points(placement.stands.get(), lifting_points(placement.teams));
}

const Shown ShownPlacement::usual;

ShownPlacement::ShownPlacement(const Placement& of, const Shown& how)
    : weighed_(of.weighing
                   ? std::make_shared<const Shown>(as_weighed(*of.weighing, of.settings, how))
                   : nullptr),
      placement(of),
      shown(weighed_ ? *weighed_ : how) {}

std::optional<InputError> check_settings(const Settings& settings, const Shown& shown) {
  if (auto error = check_ranges(settings, shown)) return error;
  if (settings.method == Method::balanced) return check_balanced(settings);
  if (settings.method == Method::given) return check_given(settings, shown);
  if (!stands_anywhere(settings) && !selects_candidates(settings.method))
    return setting_error(
        settings.no_go.empty() ? Setting::robot : Setting::no_go,
        "the methods distributed and random treat robots as points that can stand anywhere");
  if (settings.goal == Goal::hold && !selects_candidates(settings.method))
    return setting_error(
        Setting::goal,
        "the methods distributed and random choose by direction; for a hold, choose area, "
        "circle, distance or balanced");
  if (settings.teams || selects_candidates(settings.method)) return std::nullopt;
  return setting_error(Setting::teams,
                       "only area, circle and distance can place all candidates; give a number");
}

namespace {

// The object without the holes that do not fit, and these. Each try leaves out one hole.
Result<PolygonWithHoles> object_that_fits(const Document& document,
                                          std::vector<Misplaced>& left_out) {
  Document fitting = document;
  std::vector<std::uint32_t> numbers(document.holes.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  for (;;) {
    auto object = object_of(fitting);
    const std::size_t ring = object ? 0 : object.error().place.ring;
    if (ring == 0 || ring > fitting.holes.size()) {
      std::sort(left_out.begin(), left_out.end(),
                [](const Misplaced& a, const Misplaced& b) { return a.index < b.index; });
      return object;
    }
    const auto hole = static_cast<std::ptrdiff_t>(ring) - 1;
    left_out.push_back({Misplaced::Kind::hole, numbers[ring - 1]});
    fitting.holes.erase(fitting.holes.begin() + hole);
    numbers.erase(numbers.begin() + hole);
  }
}

// With the numbers that the holes have in the document.
void number_holes(Placement& placement, const std::vector<Misplaced>& holes) {
  for (Misplaced& support : placement.left_out)
    for (const Misplaced& hole : holes)
      if (support.in_hole && hole.index <= *support.in_hole) ++*support.in_hole;
  placement.left_out.insert(placement.left_out.begin(), holes.begin(), holes.end());
}

}  // namespace

Result<Placement> place(const Document& document, Effort effort, Misfitting misfitting) {
  if (auto error = check_settings(document.settings, document.shown)) return *error;
  std::vector<Misplaced> holes;
  auto object =
      misfitting == Misfitting::refused ? object_of(document) : object_that_fits(document, holes);
  if (!object) return object.error();
  auto placement = place(*std::move(object), document.centre_of_mass, document.settings, effort,
                         document.moved, misfitting);
  if (placement) number_holes(*placement, holes);
  return placement;
}

namespace {

// The mass of an object: as given, or as its supports' readings tell.
struct Mass {
  Settings settings;
  std::optional<Weighing> weighing;
  CentreOfMass centre;
  bool out_of_reach = false;  // C is outside the outline's hull
};

Result<Mass> mass_of(const PolygonWithHoles& object, const std::optional<Vec2>& own_centre,
                     const Settings& settings, Misfitting misfitting = Misfitting::refused) {
  Mass mass{settings, std::nullopt, {}};
  std::optional<Vec2> own = own_centre;
  if (is_weighed(settings)) {
    if (settings.weight != Settings{}.weight)
      return setting_error(Setting::weight, weight_is_weighed);
    if (own)
      return setting_error(Setting::com,
                           "the readings give the centre of mass: leave it out, or the readings");
    // Stands of given supports do not depend on C.
    const auto stands = make_stands(object, object.outline().vertex(0), settings);
    if (!stands) return stands.error();
    const auto places = lifting_supports(object, settings, stands->get(), misfitting);
    if (!places) return places.error();
    Points robots = settings.supports;
    for (std::size_t i = 0; i < robots.size(); ++i)
      if ((*places)[i]) robots[i] = (*places)[i]->position;
    auto weighing = weigh(robots, settings, object.outline().diameter());
    if (!weighing) return weighing.error();
    const OwnMass alone = own_mass(*weighing, settings);
    mass.settings.weight = alone.weight;
    own = alone.centre;
    mass.weighing = *std::move(weighing);
  }
  const auto centre = centre_of_mass(object, own, mass.settings);
  const Vec2 alone = own.value_or(object.centroid()), all = with_cargo(alone, mass.settings);
  mass.out_of_reach = !centre && misfitting == Misfitting::left_out && is_finite(all) &&
                      centre.error().code == ErrorCode::centre_outside_hull;
  if (!centre && !mass.out_of_reach) return centre.error();
  mass.centre = centre ? *centre : CentreOfMass{alone, all};
  return mass;
}

}  // namespace

namespace {

// No robots can balance an object whose C is beyond all of its material.
Placement nowhere(PolygonWithHoles object, const Mass& mass) {
  Placement placement(std::move(object));
  placement.own_centre = mass.centre.own;
  placement.centre_of_mass = mass.centre.all;
  placement.settings = mass.settings;
  placement.requested_teams = requested_teams(placement);
  describe_grasp(placement);
  return placement;
}

}  // namespace

Result<Placement> place(PolygonWithHoles object, const std::optional<Vec2>& own_centre,
                        const Settings& given, Effort effort, const Moved& moved,
                        Misfitting misfitting) {
  if (auto error = check_settings(given)) return *error;
  auto mass = mass_of(object, own_centre, given, misfitting);
  if (!mass) return mass.error();
  const Settings& settings = mass->settings;
  const CentreOfMass& centre = mass->centre;
  if (mass->out_of_reach && settings.method != Method::given)
    return nowhere(std::move(object), *mass);
  auto stands = make_stands(object, centre.all, settings);
  if (!stands) return with_hint(stands.error(), object, centre.all, settings);
  auto candidates = mass->out_of_reach ? Result<std::vector<Candidate>>(std::vector<Candidate>())
                                       : candidates_of(object, centre.all, settings, stands->get());
  if (!candidates) return candidates.error();
  if (swaps_teams(settings))
    if (auto error =
            check_swaps(candidates->size(), settings.teams.value_or(max_teams), stands->get()))
      return *error;

  Placement placement(std::move(object));
  placement.stands = *std::move(stands);
  placement.own_centre = centre.own;
  placement.centre_of_mass = centre.all;
  placement.settings = settings;
  placement.weighing = std::move(mass->weighing);
  placement.candidates = std::move(*candidates);
  placement.requested_teams = requested_teams(placement);
  // If all robots were moved by hand, there is no search.
  if (moved.robots.empty())
    if (auto error = choose_teams(placement, effort, misfitting)) return *std::move(error);
  if (moved.robots.empty() && is_short(placement))
    placement.accuracy_with_room =
        accuracy_with_room(placement.object, placement.centre_of_mass, settings);
  if (!moved.any()) {
    describe_grasp(placement);
  } else if (auto error = move_robots(placement, moved)) {
    return *std::move(error);
  }
  return placement;
}

Result<Placement> place_as_chosen(PolygonWithHoles object, const std::optional<Vec2>& own_centre,
                                  const Settings& settings, Choice choice) {
  if (auto error = check_settings(settings)) return *error;
  const auto centre = centre_of_mass(object, own_centre, settings);
  if (!centre) return centre.error();
  Placement placement(std::move(object));
  placement.own_centre = centre->own;
  placement.centre_of_mass = centre->all;
  placement.settings = settings;
  placement.candidates = std::move(choice.candidates);
  placement.requested_teams = requested_teams(placement);
  return with_choice(std::move(placement), std::move(choice.teams));
}

Result<std::vector<Candidate>> candidates_of(const Document& document) {
  if (auto error = check_settings(document.settings, document.shown)) return *error;
  const auto object = object_of(document);
  if (!object) return object.error();
  const auto mass = mass_of(*object, document.centre_of_mass, document.settings);
  if (!mass) return mass.error();
  const auto stands = make_stands(*object, mass->centre.all, document.settings);
  if (!stands) return stands.error();
  return candidates_of(*object, mass->centre.all, document.settings, stands->get());
}

Result<Document> with_even_supports(const Document& document, Misfitting misfitting) {
  const std::string option = "even_out";
  if (document.settings.method != Method::given)
    return bad_setting(option, "only given supports can be evened out");
  const auto placement = place(document, Effort::whole, misfitting);
  if (!placement) return placement.error();
  const std::vector<LiftingPoint> robots = lifting_points(placement->teams);
  if (robots.size() > most_evened)
    return bad_setting(option, "at most 64 supports can be evened out");
  const auto even = even_out(
      BalancedProblem(placement->object, placement->centre_of_mass, placement->settings), robots);
  if (!even)
    return bad_setting(
        option,
        "there are no places near the outline to which two or three robots could move so that all "
        "carry the same load");
  const std::vector<LiftingPoint> touched = contact_points(placement->stands.get(), *even);
  // Readings are those at the former places.
  Document moved = placement->weighing ? taken_over(document, *placement->weighing) : document;
  for (std::size_t i = 0; i < robots.size(); ++i)
    if ((*even)[i].position != robots[i].position)
      moved.settings.supports[placement->support_of(i)] = touched[i].position;
  return moved;
}

std::vector<SupportMove> support_moves(const Document& before, const Document& after) {
  const Points &from = before.settings.supports, &to = after.settings.supports;
  std::vector<SupportMove> moves;
  for (std::size_t i = 0; i < from.size() && i < to.size(); ++i)
    if (from[i] != to[i]) moves.push_back({i, from[i], to[i]});
  return moves;
}

Placement with_robots(Placement placement, const std::vector<LiftingPoint>& robots,
                      bool search_ended, bool cut_short) {
  placement.teams = {team_of(placement, robots)};
  placement.search_ended = search_ended;
  placement.cut_short = cut_short;
  placement.moved = {};
  describe_grasp(placement);
  return placement;
}

std::vector<PairRange> ranges_of(const Placement& placement, const Chord& chord) {
  const double min_ratio = placement.settings.min_ratio;
  const Vec2& centre = placement.centre_of_mass;
  if (placement.stands)
    return standing_ranges(placement.polygon(), centre, chord.r1.edge, chord.r2.edge, min_ratio,
                           *placement.stands);
  if (const auto range = range_of(placement.polygon(), centre, chord, min_ratio)) return {*range};
  return {};
}

Placement with_choice(Placement placement, std::vector<std::uint32_t> candidates) {
  placement.teams =
      distribute_weight(chords_of(placement.candidates, candidates), placement.weight());
  placement.team_candidates = std::move(candidates);
  placement.moved = {};
  describe_grasp(placement);
  return placement;
}

Placement with_failure(Placement placement, std::size_t robot) {
  const auto ranges = ranges_without(placement, robot, {});
  std::vector<LiftingPoint> others = lifting_points(placement.teams);
  std::vector<double> loads(others.size(), 0);
  for (std::size_t i = 0; ranges && i < loads.size(); ++i) loads[i] = (*ranges)[i].greatest;
  take_loads(placement, loads);
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(robot));
  describe_grasp(placement, others);
  placement.loads.reset();
  if (ranges)
    placement.loads = summarize_others(placement, robot);
  else
    placement.coverage = 0;
  return placement;
}

}  // namespace evenlift
