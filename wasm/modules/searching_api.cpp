// The search for balanced robots. web/page/search_loop.js runs it in a worker or, without workers,
// between frames.
#include <emscripten/emscripten.h>

#include <optional>
#include <string_view>
#include <utility>

#include "derive/robots_text.h"
#include "derive/settings_text.h"
#include "evenlift/balanced.h"
#include "evenlift/capacity.h"
#include "evenlift/centre_of_mass.h"
#include "evenlift/formats.h"
#include "evenlift/placement.h"
#include "page/hand_over.h"

namespace evenlift {

using view::hand_over;

namespace {

struct Task {
  BalancedProblem problem;
  std::optional<BalancedSearch> search;  // nothing before the start, and if no set of robots exists
  bool started = false;
  std::optional<Placement> counted = {};  // with a capacity, in place of a search
  double capacity = 0;
  std::optional<FailurePlan> plan = {};  // the completed count
};
std::optional<Task>& task() {
  static std::optional<Task> the_task;
  return the_task;
}

std::optional<Task> read_task(std::string_view text, std::string_view settings,
                              std::string_view robots) {
  Result<Document> document = read_polygon(text);
  if (!document || !view::read_lines(settings, *document)) return std::nullopt;
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
    return Task{std::move(problem), std::nullopt, false, std::move(counted),
                *document->shown.capacity};
  }
  if (robots.empty()) return Task{std::move(problem), std::nullopt};
  auto start = view::read_robots(robots, document->settings.robots, *object);
  if (!start) return std::nullopt;
  BalancedSearch search;
  search.robots = *std::move(start);
  return Task{std::move(problem), std::move(search), true};
}

void start(Task& task) {
  task.search = start_balanced(task.problem);
  task.started = true;
}

bool has_ended(const Task& task) { return task.started && (!task.search || task.search->finished); }

}  // namespace
}  // namespace evenlift

extern "C" {

// Begins the search for a polygon in the thesis's format, with settings as lines `name=value`, from
// `robots` (derive/robots_text.h), if not empty. With a capacity, begins instead the count of the
// robots needed if any one may fail. Returns 0 if a text is invalid.
EMSCRIPTEN_KEEPALIVE int balanced_begin(const char* polygon, const char* settings,
                                        const char* robots) {
  evenlift::task() = evenlift::read_task(polygon, settings, robots);
  return evenlift::task() ? 1 : 0;
}

// Continues for this number of milliseconds, or until the search ends; its start or a whole count
// may take longer. Returns whether it has ended.
EMSCRIPTEN_KEEPALIVE int balanced_go_on(double milliseconds) {
  if (!evenlift::task()) return 1;
  evenlift::Task& task = *evenlift::task();
  if (task.counted) {
    task.plan = plan_for_failures(*task.counted, task.capacity);
    return 1;
  }
  const double end = emscripten_get_now() + milliseconds;
  if (!task.started) evenlift::start(task);
  while (!evenlift::has_ended(task) && emscripten_get_now() < end)
    task.search = evenlift::try_next_triple(task.problem, *std::move(task.search)).search;
  return evenlift::has_ended(task) ? 1 : 0;
}

// The robots found, or the number counted; empty if there are none.
EMSCRIPTEN_KEEPALIVE const char* balanced_robots() {
  const std::optional<evenlift::Task>& task = evenlift::task();
  if (task && task->plan) return evenlift::hand_over(evenlift::view::plan_text(*task->plan));
  return evenlift::hand_over(
      task && task->search ? evenlift::view::robots_text(task->search->robots) : "");
}

}  // extern "C"
