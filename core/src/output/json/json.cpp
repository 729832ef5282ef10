#include "evenlift/output/json.h"

#include <cmath>

#include "evenlift/candidates.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/verdict.h"
#include "evenlift/settings.h"
#include "evenlift/stands.h"
#include "output/json/robustness_json.h"

namespace evenlift::json {
namespace {

bool is_of_use(const SettingRow& row, const Settings& settings) {
  if (row.setting == Setting::goal)
    return swaps_teams(settings) || (settings.method == Method::balanced && settings.goal);
  return is_kept(row, settings);
}

std::string capacities(const std::vector<std::optional<double>>& given) {
  std::vector<std::string> items;
  for (const std::optional<double>& capacity : given)
    items.push_back(capacity ? number(*capacity) : "null");
  return array(items);
}

std::string names(const std::vector<std::string>& given) {
  std::vector<std::string> items;
  for (const std::string& name : given) items.push_back(name.empty() ? "null" : text(name));
  return array(items);
}

std::string cargo(const std::vector<Cargo>& cargo) {
  std::vector<std::string> items;
  for (const Cargo& item : cargo) {
    std::vector<Member> members{{"at", pair(item.at)}, {"weight", number(item.weight)}};
    if (!item.name.empty()) members.push_back({"name", text(item.name)});
    items.push_back(object(members));
  }
  return long_array(items, 1);
}

std::string value(const SettingRow& row, const Document& document) {
  switch (row.setting) {
    case Setting::overlays:
      return overlays(document.shown.overlays);
    case Setting::robot:
      return robot(document.settings.robot);
    case Setting::goal:
      return text(name(goal_of(document.settings)));
    case Setting::supports:
      return points(document.settings.supports, 1);
    case Setting::cargo:
      return cargo(document.settings.cargo);
    case Setting::support_capacities:
      return capacities(document.shown.support_capacities);
    case Setting::support_names:
      return names(document.settings.support_names);
    case Setting::readings:
      return numbers(document.settings.weighed.readings);
    case Setting::readings_tilted:
      return numbers(document.settings.weighed.tilted_readings);
    case Setting::reading_error:
      if (const auto& error = document.settings.weighed.error; !(error.percent > 0))
        return number(error.weight);
      break;
    case Setting::heading:
      if (const auto& heading = document.settings.weighed.heading) return pair(*heading);
      break;
    default:
      break;
  }
  const std::string given = text_of(row.setting, document);
  if (!row.access.is_number) return text(given);
  if (given.empty() || given == "none") return "null";
  return given == row.range.unset ? text(given) : given;
}

}  // namespace

void add_settings(std::vector<Member>& members, const Document& document, Listed SettingRow::*list,
                  Setting first, Setting last) {
  const Document usual;
  for (const SettingRow& row : all_settings()) {
    if (row.setting < first || row.setting > last || row.*list == Listed::never) continue;
    if (!is_of_use(row, document.settings)) continue;
    if (row.*list == Listed::if_changed &&
        text_of(row.setting, document) == text_of(row.setting, usual))
      continue;
    members.push_back({row.json.empty() ? row.name : row.json, value(row, document)});
  }
}

std::string overlays(const Overlays& overlays) {
  std::vector<Member> members;
  for (const NamedOverlay& overlay : all_overlays())
    members.push_back({overlay.name, boolean(overlays.*(overlay.shown))});
  return object(members);
}

std::string robot(const RobotSize& robot) {
  return object({{"radius", number(robot.radius)},
                 {"reach", number(robot.reach)},
                 {"depth", number(robot.depth)},
                 {"width", number(robot.width)},
                 {"gap", number(robot.gap)}});
}

}  // namespace evenlift::json

namespace evenlift {

namespace {

std::string ends(const Chord& chord) {
  return json::array({json::pair(chord.r1.position), json::pair(chord.r2.position)});
}

std::string team_json(const Team& team, bool carries) {
  std::vector<std::string> ends, loads;
  for (const Robot& robot : team.robots) {
    ends.push_back(json::pair(robot.point.position));
    loads.push_back(carries ? json::number(robot.load) : "null");
  }
  return json::object({{"ends", json::array(ends)},
                       {"ratio", json::number(team.ratio)},
                       {"loads", json::array(loads)}});
}

std::string candidate_list(const std::vector<Candidate>& candidates) {
  std::vector<std::string> items;
  for (const Candidate& candidate : candidates)
    items.push_back(json::object({{"ends", ends(candidate.chord)},
                                  {"ratio", json::number(candidate.chord.ratio)},
                                  {"kind", json::text(name(candidate.kind))}}));
  return json::long_array(items, 1);
}

std::string teams_json(const Placement& placement) {
  std::vector<std::string> items;
  for (const Team& team : placement.teams)
    items.push_back(team_json(team, placement.loads.has_value()));
  return json::long_array(items, 1);
}

// With robots that are off, if any may be.
const std::optional<ModelLoads>& models_of(const Report& report) {
  return report.inexact_models ? report.inexact_models : report.models;
}

std::string loads_json(const Reported& of) {
  if (!of.placement.loads) return "null";
  const std::optional<ModelLoads>& models = models_of(of.report);
  std::vector<json::Member> members = json::quantities_of("loads", of);
  members.push_back({"models", json::models(models, 2)});
  if (models && models->are_ranges()) {
    members.push_back({"ranges", json::ranges(loads_by(LoadModel::plan, of.placement, models))});
    members.push_back(
        {"may_let_go", json::boolean(may_let_go(LoadModel::plan, of.placement, models))});
  }
  return json::long_object(members, 1);
}

std::string depends_on_json(const Clearance& clearance) {
  if (!clearance.point) return "null";
  return json::object({{"robot", std::to_string(*clearance.point)},
                       {"distance", json::number(clearance.distance)}});
}

std::string closure_json(const Reported& of) {
  const Closure& closure = of.placement.closure;
  std::vector<std::string> free;
  if (closure.clockwise.exists) free.push_back(json::text("clockwise"));
  if (closure.counterclockwise.exists) free.push_back(json::text("counterclockwise"));
  if (closure.translation_free) free.push_back(json::text("translation"));
  std::vector<json::Member> members = json::quantities_of("closure", of);
  members.push_back({"free", json::array(free)});
  members.push_back({"slides", closure.translation ? json::pair(*closure.translation) : "null"});
  members.push_back({"depends_on", depends_on_json(closure.clearance)});
  members.push_back({"clockwise", json::points(closure.clockwise.clipped, 2)});
  members.push_back({"counterclockwise", json::points(closure.counterclockwise.clipped, 2)});
  return json::long_object(members, 1);
}

std::string failure_plan_json(const std::optional<FailurePlan>& plan) {
  if (!plan) return "null";
  return json::object(
      {{"robots_needed", plan->possible ? std::to_string(plan->robots) : "null"},
       {"greatest_load", plan->possible ? json::number(plan->greatest_load) : "null"},
       {"robots_tried", std::to_string(plan->tried)}});
}

// As in 1.0.0, a C uncertainty alone changes nothing.
std::string overloaded_json(const Reported& of) {
  return json::wholes(of.report.disturbance.besides_com() ? of.report.overloaded_as_planned
                                                          : of.report.overloaded_at_rest);
}

std::string capacity_json(const Reported& of) {
  const std::optional<double>& limit = of.shown.capacity;
  const CapacityPlan plan = of.report.plan.value_or(CapacityPlan{});
  const auto& radius = of.report.com_radius;
  std::vector<json::Member> members = {
      {"limit", limit ? json::number(*limit) : "null"},
      {"overloaded", overloaded_json(of)},
      {"teams_needed", plan.possible ? std::to_string(plan.teams) : "null"},
      {"greatest_load", plan.possible ? json::number(plan.greatest_load) : "null"},
      {"teams_tried", std::to_string(plan.tried)},
      {"robots_needed", plan.possible ? std::to_string(plan.teams * plan.team_size) : "null"},
      {"com_radius", radius ? json::number_or_null(radius->within) : "null"},
      {"if_one_fails", failure_plan_json(of.report.if_one_fails)}};
  for (json::Member& member : json::quantities_of("capacity", of))
    members.push_back(std::move(member));
  return json::object(members);
}

void add_holes(std::vector<json::Member>& members, const std::vector<Points>& holes) {
  std::vector<std::string> rings;
  for (const Points& hole : holes) rings.push_back(json::points(hole, 2));
  if (!holes.empty()) members.push_back({"holes", json::long_array(rings, 1)});
}

void add_moved(std::vector<json::Member>& members, const Moved& moved) {
  if (moved.any()) members.push_back({"moved", json::text(moved_text(moved))});
}

// Edges are numbered from 1; positions on them are from 0 to 1.
std::string unusable_json(const Placement& placement) {
  std::vector<std::string> items;
  const Polygon& polygon = placement.polygon();
  for (const UnusablePart& part : placement.stands->unusable()) {
    const double size = length(polygon.edge_end(part.edge) - polygon.edge_start(part.edge));
    items.push_back(json::array({std::to_string(part.edge + 1), json::number(part.part.from / size),
                                 json::number(part.part.to / size), json::text(name(part.why))}));
  }
  return json::long_array(items, 1);
}

void add_stands(std::vector<json::Member>& members, const Placement& placement) {
  if (!placement.stands) return;
  members.push_back({"robot", json::robot(placement.settings.robot)});
  members.push_back({"no_go", json::text(no_go_text(placement.settings.no_go))});
  members.push_back({"unusable", unusable_json(placement)});
}

void add_carrying(std::vector<json::Member>& members, const Reported& of) {
  const Carrying& carrying = of.shown.carrying;
  members.push_back({"tilt", json::tilt(of.report.tilt, 1)});
  if (carrying.extra)
    members.push_back({"extra", json::extra(of.report.extra, *carrying.extra, 1)});
}

std::string verdict_json(const Judgement& judgement) {
  const std::vector<std::string> codes(judgement.codes.begin(), judgement.codes.end());
  return json::object({{"kind", json::text(name(judgement.kind))},
                       {"reasons", json::texts(judgement.reasons)},
                       {"codes", json::texts(codes)}});
}

// Supports that do not fit, and those over which a falling object tips.
void add_misfits(std::vector<json::Member>& members, const Reported& of) {
  std::vector<std::string> items, tips_over;
  for (const Misfit& misfit : of.report.misfits) {
    std::vector<json::Member> of_one = {{"robot", std::to_string(misfit.robot)},
                                        {"why", json::text(misfit_in_words(misfit))}};
    if (misfit.why == Misfit::Why::too_near)
      of_one.push_back({"other", std::to_string(misfit.other)});
    items.push_back(json::object(of_one));
  }
  members.push_back({"misfits", json::long_array(items, 1)});
  for (const std::uint32_t robot : of.report.equilibrium.tips_over)
    tips_over.push_back(std::to_string(robot));
  if (!of.placement.loads) members.push_back({"tips_over", json::array(tips_over)});
}

std::string requirements_json(const std::vector<Requirement>& requirements) {
  std::vector<std::string> items;
  for (const auto& [condition, value, kept] : requirements) {
    const std::string known = !value || std::isinf(*value) ? "null"
                              : is_yes_or_no(condition)    ? json::boolean(*value == 1)
                                                           : json::number(*value);
    items.push_back(json::object({{"condition", json::text(condition.text)},
                                  {"value", known},
                                  {"kept", json::boolean(kept)}}));
  }
  return json::long_array(items, 1);
}

std::string uses_json(const Reported& of) {
  std::vector<std::string> items;
  for (const auto& use : of.report.use) items.push_back(json::number_or_null(use));
  return json::array(items);
}

std::string effective_json(const Report::Effective& effective) {
  return json::object({{"clear", json::number(effective.clear)},
                       {"apart", json::number(effective.apart)},
                       {"snap", json::number(effective.snap)}});
}

std::string moves_json(const std::vector<SupportMove>& moves) {
  std::vector<std::string> items;
  for (const auto& [robot, from, to] : moves)
    items.push_back(json::object({{"robot", std::to_string(robot)},
                                  {"from", json::pair(from)},
                                  {"to", json::pair(to)},
                                  {"by", json::number(length(to - from))}}));
  return json::long_array(items, 1);
}

// Settings that the results do not show, so that a program can open the result; each only if it is
// not the default.
void add_asked(std::vector<json::Member>& members, const Settings& settings,
               const Overlays& overlays) {
  const Settings usual;
  if (!settings.teams)
    members.push_back({"teams_asked", json::text("max")});
  else if (is_one_team(settings.method) && settings.teams != usual.teams)
    members.push_back({"teams_asked", std::to_string(*settings.teams)});
  if (overlays != Overlays{}) members.push_back({"overlays", json::overlays(overlays)});
}

}  // namespace

std::string_view version() { return EVENLIFT_VERSION; }

std::string cases_json(const std::vector<LoadCase>& cases) {
  std::vector<std::string> items;
  for (const LoadCase& each : cases)
    items.push_back(json::object({{"name", json::text(name(each.kind))},
                                  {"failed", each.failed ? std::to_string(*each.failed) : "null"},
                                  {"greatest", json::number_or_null(each.greatest)},
                                  {"robot", each.robot ? std::to_string(*each.robot) : "null"},
                                  {"least", json::number_or_null(each.least)},
                                  {"use", json::number_or_null(each.use)},
                                  {"stays", json::boolean(each.stays)}}));
  return json::long_array(items, 1);
}

std::string candidates_json(const std::vector<Candidate>& candidates,
                            const std::vector<std::string>& notices) {
  std::vector<json::Member> members = {{"candidates", candidate_list(candidates)}};
  if (!notices.empty()) members.push_back({"notices", json::texts(notices)});
  return json::long_object(members, 0) + "\n";
}

namespace {

std::string left_out_json(const Placement& placement) {
  std::vector<std::string> items;
  for (const Misplaced& each : placement.left_out)
    items.push_back(
        json::object({{"kind", json::text(each.kind == Misplaced::Kind::hole ? "hole" : "support")},
                      {"index", std::to_string(each.index)},
                      {"in_hole", each.in_hole ? std::to_string(*each.in_hole) : "null"}}));
  return json::array(items);
}

}  // namespace

std::string placement_json(const ShownPlacement& of, bool with_candidates, Asked asked) {
  asked.models = true;
  return placement_json({of, asked}, with_candidates, asked.failures);
}

std::string placement_json(const Reported& of, bool with_candidates, bool with_failures,
                           const std::vector<Requirement>& requirements, const Beside& beside) {
  const Placement& placement = of.placement;
  const Settings& settings = placement.settings;
  const Document asked{{}, {}, settings, of.shown, {}};
  const bool robots = !placement.teams.empty();
  const bool given = settings.method == Method::given;
  std::vector<json::Member> members = {{"polygon", json::points(placement.vertices(), 1)}};
  add_holes(members, placement.object.rings_of_holes());
  members.push_back({"centre_of_mass", json::pair(placement.centre_of_mass)});
  members.push_back({"own_centre_of_mass", json::pair(placement.own_centre)});
  members.push_back({"total_weight", json::number(placement.weight())});
  json::add_settings(members, asked, &SettingRow::in_result, Setting::teams, Setting::weight_unit);
  if (with_candidates) members.push_back({"candidates", candidate_list(placement.candidates)});
  members.push_back({"requested_teams", std::to_string(placement.requested_teams)});
  members.push_back({"teams", teams_json(placement)});
  if (robots) members.push_back({"robots", json::robots(placement, 1)});
  members.push_back({"hull", json::points(placement.lifting_base, 1)});
  members.push_back(json::quantity("coverage", of));
  members.push_back({"loads", loads_json(of)});
  members.push_back({"closure", closure_json(of)});
  members.push_back({"goal", json::text(name(goal_of(settings)))});
  for (const char* member : {"goal_reached", "stands", "held"})
    members.push_back(json::quantity(member, of));
  members.push_back({"verdict", verdict_json(judge(of))});
  if (given) add_misfits(members, of);
  if (!placement.left_out.empty()) members.push_back({"left_out", left_out_json(placement)});
  if (settings.method == Method::balanced || placement.cut_short)
    members.push_back(
        {"search_ended", json::boolean(placement.search_ended && !placement.cut_short)});
  json::add_settings(members, asked, &SettingRow::in_result, Setting::goal, Setting::failed);
  add_asked(members, settings, of.shown.overlays);
  add_moved(members, placement.moved);
  add_stands(members, placement);
  if (robots) members.push_back({"robustness", json::robustness(of, models_of(of.report), 1)});
  if (robots) members.push_back({"accuracy", json::accuracy(of, 1)});
  if (robots && with_failures) members.push_back({"failures", json::failures(of.report, 1)});
  add_carrying(members, of);
  if (placement.weighing) members.push_back({"weighing", json::weighing(of, 1)});
  if (of.report.has_capacities) members.push_back({"use", uses_json(of)});
  if (beside.cases) members.push_back({"cases", cases_json(*beside.cases)});
  if (of.report.known.plans && of.report.has_capacities)
    members.push_back({"capacity", capacity_json(of)});
  if (!requirements.empty()) members.push_back({"requirements", requirements_json(requirements)});
  members.push_back({"effective", effective_json(of.report.effective)});
  if (beside.evened_out) members.push_back({"evened_out", moves_json(*beside.evened_out)});
  if (!beside.notices.empty()) members.push_back({"notices", json::texts(beside.notices)});
  members.push_back({"version", json::text(version())});
  return json::long_object(members, 0) + "\n";
}

std::string document_json(const Document& document) {
  std::vector<json::Member> members = {{"polygon", json::points(document.vertices, 1)}};
  add_holes(members, document.holes);
  members.push_back(
      {"centre_of_mass", document.centre_of_mass ? json::pair(*document.centre_of_mass) : "null"});
  json::add_settings(members, document, &SettingRow::in_document, Setting::teams, Setting::failed);
  add_moved(members, document.moved);
  return json::long_object(members, 0) + "\n";
}

}  // namespace evenlift
