#include "state/derived.h"

#include <algorithm>
#include <utility>

#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/settings.h"
#include "evenlift/swaps.h"
#include "state/method.h"

namespace evenlift::view {
namespace {

Computed so_far;

Result<Opened> opened(Result<Document> document) {
  if (!document) return document.error();
  return view::opened(std::move(document).value());
}

bool is_of(const PolygonWithHoles& object, const Document& document) {
  return object.outline().vertices() == document.vertices &&
         object.rings_of_holes() == document.holes;
}

Result<Placement> placed(const Document& document, const PolygonWithHoles* known) {
  if (known && is_of(*known, document))
    return place(*known, document.centre_of_mass, document.settings, Effort::start, document.moved,
                 Misfitting::left_out);
  return place(document, Effort::start, Misfitting::left_out);
}

// Swaps of t teams among K candidates take 0.1 to 5 microseconds times t^3 K, and 1.6 times that in
// the browser (docs/performance.md).
double swap_cost(const Placement& placement) {
  const auto teams = static_cast<double>(placement.teams.size());
  return teams * teams * teams * static_cast<double>(placement.candidates.size());
}
constexpr double most_in_a_drag = 50e3, most_at_rest = 1e6;

// For the goal *hold*: the teams without swaps.
Placement not_swapped(Placement selected, const Settings& settings) {
  selected.settings = settings;
  selected.goal_reached = !selected.teams.empty() && selected.closure.form_closure;
  selected.search_ended = false;
  return selected;
}

Result<Placement> placed_in(Haste haste, const Document& document, const PolygonWithHoles* known) {
  const Settings& settings = document.settings;
  if (!swaps_teams(settings)) return placed(document, known);
  Document as_selected = document;
  as_selected.settings.goal = Goal::cover;
  as_selected.moved = {};
  Result<Placement> selected = placed(as_selected, known);
  if (!selected) return selected;
  const double most = haste == Haste::drag ? most_in_a_drag : most_at_rest;
  if (swap_cost(*selected) <= most) return placed(document, &selected->object);
  if (auto error = check_swaps(selected->candidates.size(), settings.teams.value_or(max_teams),
                               selected->stands.get()))
    return *error;
  return not_swapped(std::move(selected).value(), settings);
}

}  // namespace

Result<Placement> compute_placement(const Document& document,
                                    const std::optional<Placement>& before, Haste haste) {
  ++so_far.placements;
  return placed_in(haste, document, before ? &before->object : nullptr);
}

Result<Placement> compute_as_chosen(const Document& document, const Placement& before,
                                    Choice choice) {
  ++so_far.placements;
  Result<PolygonWithHoles> object =
      is_of(before.object, document) ? before.object : object_of(document);
  if (!object) return object.error();
  Settings as_selected = document.settings;
  if (swaps_teams(as_selected)) as_selected.goal = Goal::cover;
  Result<Placement> placement =
      place_as_chosen(*std::move(object), document.centre_of_mass, as_selected, std::move(choice));
  if (!placement || !swaps_teams(document.settings)) return placement;
  if (auto error =
          check_swaps(placement->candidates.size(), document.settings.teams.value_or(max_teams)))
    return *error;
  return not_swapped(std::move(placement).value(), document.settings);
}

Result<Placement> try_placement(const Document& document, const Placement& before) {
  ++so_far.tries;
  return placed_in(Haste::drag, document, &before.object);
}

bool swaps_in_a_drag(const Placement& placement) {
  return swaps_teams(placement.settings) && swap_cost(placement) <= most_in_a_drag;
}

bool waits_for_swap(const Placement& placement) {
  return swaps_teams(placement.settings) && !placement.search_ended;
}

Result<Trace> compute_trace(const Placement& placement, const Units& units, HistoryLength length) {
  ++so_far.traces;
  return make_trace(placement, length, units);
}

CapacityPlan compute_plan(const Placement& placement, double capacity) {
  ++so_far.plans;
  return plan_capacity(placement, capacity);
}

Computed computed() { return so_far; }

Result<Opened> opened(Document document) {
  // A lesson shows teams at their original places.
  if (document.shown.step) document.moved.teams.clear();
  Result<Placement> placement = compute_placement(document);
  if (!placement) return placement.error();
  return Opened{std::move(document), std::move(placement).value(), std::nullopt};
}

Document with_settings_of(Document polygon, const Document& before) {
  polygon.settings = before.settings;
  polygon.shown = before.shown;
  polygon.shown.step.reset();
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::shown && row.is_length) read_setting(row.setting, "0", polygon);
  polygon.settings.no_go.clear();
  return polygon;
}

Result<Opened> opened_after(Document polygon, const Work& work) {
  const Document& before = work.document();
  polygon = with_settings_of(std::move(polygon), before);
  polygon.settings.weighed = {};
  if (before.settings.method == Method::given) {
    const auto robots = static_cast<std::uint32_t>(before.settings.supports.size());
    polygon.settings = with_method(polygon.settings, work.aside.method.value_or(Method::area), 3);
    polygon.settings.teams = std::max(1u, robots / 2);
    polygon.settings.robots = std::clamp(robots, fewest_robots(polygon.settings), most_robots);
    polygon.shown.support_capacities.clear();
  }
  Result<Opened> next = opened(std::move(polygon));
  if (next) next->left_robots = before.settings.method == Method::given;
  return next;
}

Result<Document> parse_document(std::string_view text) {
  return looks_like_link(text) ? decode_link(text) : read_polygon(text);
}

Result<Opened> read_link(std::string_view link) { return opened(decode_link(link)); }
Result<Opened> read_document(std::string_view text) { return opened(parse_document(text)); }

}  // namespace evenlift::view
