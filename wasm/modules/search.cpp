// The search for balanced robots, and the count of those needed if any one may fail.
#include <optional>
#include <string_view>
#include <utility>

#include "derive/derive.h"
#include "evenlift/balanced.h"
#include "evenlift/capacity.h"
#include "evenlift/centre_of_mass.h"
#include "evenlift/formats.h"
#include "evenlift/output/json_text.h"
#include "evenlift/placement.h"
#include "modules/kinds.h"

namespace evenlift::view {
namespace {

struct Task {
  BalancedProblem problem;
  std::optional<BalancedSearch> search;   // from where it goes on
  std::optional<Placement> counted = {};  // with a capacity, in place of a search
  Shown shown = {};                       // the capacity, and the conditions for which to count
};

std::optional<Task> task_of(std::string_view text, std::string_view settings,
                            std::string_view robots) {
  Result<Document> document = read_thesis(text);
  if (!document || !read_lines(settings, *document)) return std::nullopt;
  document->settings.method = Method::balanced;
  const Result<PolygonWithHoles> object = object_of(*document);
  if (!object) return std::nullopt;
  const auto centre = centre_of_mass(*object, document->centre_of_mass, document->settings);
  if (!centre) return std::nullopt;
  BalancedProblem problem(*object, centre->all, document->settings);
  if (document->shown.capacity) {
    Placement counted(*object);
    counted.own_centre = centre->own;
    counted.centre_of_mass = centre->all;
    counted.settings = document->settings;
    return Task{std::move(problem), std::nullopt, std::move(counted), document->shown};
  }
  if (robots.empty()) return Task{std::move(problem), std::nullopt};
  auto start = read_robots(robots, document->settings.robots, *object);
  if (!start) return std::nullopt;
  BalancedSearch search;
  search.robots = *std::move(start);
  return Task{std::move(problem), std::move(search)};
}

std::string found(std::string_view robots, bool cut_short = false) {
  return json::object({{"robots", json::text(robots)}, {"cut_short", json::boolean(cut_short)}});
}

// The start, and then better robots until the search ends. Reports them at most ten times a second.
std::string search_to_its_end(Task& task) {
  constexpr double between_reports = 100;  // milliseconds
  std::string told = task.search ? robots_text(task.search->robots) : "";
  double told_at = now();
  if (!task.search) task.search = start_balanced(task.problem);
  while (task.search && !task.search->finished) {
    if (now() >= told_at + between_reports) {
      std::string better = robots_text(task.search->robots);
      if (better != told) report(found(better));
      told = std::move(better);
      told_at = now();
    }
    task.search = try_next_triple(task.problem, *std::move(task.search)).search;
  }
  return found(task.search ? robots_text(task.search->robots) : "",
               task.search && task.search->cut_short);
}

}  // namespace

std::string search(const RequestMembers& members) {
  std::optional<Task> task =
      task_of(members.text("polygon"), members.text("settings"), members.text("robots"));
  if (!task) return problem("the search cannot begin");
  if (!task->counted) return search_to_its_end(*task);
  const double limit = limit_of(*task->shown.capacity, task->shown.carrying);
  return found(plan_text(plan_for_failures({*task->counted, task->shown}, limit)));
}

}  // namespace evenlift::view
