#include "evenlift/lesson.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "evenlift/centre_of_mass.h"
#include "evenlift/link.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/supports.h"
#include "evenlift/task.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

bool on_edges(const EdgePair& pair, std::uint32_t a, std::uint32_t b) {
  return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
}

struct Finder {
  const Trace& trace;

  std::optional<std::uint32_t> operator()(const at::Kind& address) const {
    return trace.find(address.kind, address.item);
  }
  std::optional<std::uint32_t> operator()(const at::Vertex& address) const {
    for (std::uint32_t i = 0; i < trace.rays.vertices.size(); ++i)
      if (trace.rays.vertices[i] == address.vertex) return trace.find(StepKind::ray, i);
    return std::nullopt;
  }
  std::optional<std::uint32_t> operator()(const at::Edges& address) const {
    for (std::uint32_t i = 0; i < trace.pairs.size(); ++i)
      if (on_edges(trace.pairs[i], address.a, address.b)) return trace.find(StepKind::outcome, i);
    return std::nullopt;
  }
  std::optional<std::uint32_t> operator()(const at::Number& address) const {
    if (address.step < trace.size()) return address.step;
    return std::nullopt;
  }
  std::optional<std::uint32_t> operator()(const at::End&) const { return trace.size() - 1; }
};

// The message about a step that the trace does not have.
struct Absence {
  const Trace& trace;

  std::string operator()(const at::Kind& address) const {
    const std::string word(address.kind == StepKind::outcome ? std::string_view("pair")
                                                             : name(address.kind));
    const auto step = [&](std::uint32_t number) {
      return "[" + word + " " + std::to_string(number) + "]";
    };
    const std::uint32_t count = trace.count(address.kind), item = address.item + 1;
    if (count == 0)
      return say("there is no step {step} with this polygon and these settings",
                 {"[" + word + "]"});
    if (count == 1)
      return say(
          "there is no step {step}: with this polygon and these settings there is only {only}",
          {step(item), "[" + word + "]"});
    return say(
        "there is no step {step}: with this polygon and these settings there are {first} to {last}",
        {step(item), step(1), step(count)});
  }
  std::string operator()(const at::Vertex& address) const {
    const std::uint32_t vertex = address.vertex + 1;
    if (address.vertex >= trace.polygon().size())
      return say("there is no vertex {vertex}: the polygon has {count} vertices",
                 {vertex, trace.polygon().size()});
    return say("there is no ray from vertex {vertex} with these settings", {vertex});
  }
  std::string operator()(const at::Edges& address) const {
    return say(
        "edges {a} and {b} are not examined together: no chord through the centre of mass joins them",
        {address.a + 1, address.b + 1});
  }
  std::string operator()(const at::Number& address) const {
    return say("there is no step {step}: there are {count}", {address.step + 1, trace.size()});
  }
  std::string operator()(const at::End&) const { return {}; }
};

Result<Document> opened_object(const Lesson& lesson, const Document& sample, std::uint64_t number) {
  if (!lesson.link.empty()) return decode_link(lesson.link);
  if (!lesson.generated) return sample;
  const GeneratedPolygon& polygon = *lesson.generated;
  Result<Points> vertices = generate(polygon.family, polygon.n, polygon.seed.value_or(number));
  if (!vertices) return vertices.error();
  Document document;
  document.vertices = *std::move(vertices);
  return document;
}

}  // namespace

Result<Document> lesson_document(const Lesson& lesson, const Document& sample,
                                 std::uint64_t number) {
  Result<Document> document = opened_object(lesson, sample, number);
  if (!document) return document;
  for (const GivenSetting& given : lesson.settings)
    if (auto error = read_setting(given.setting, given.text, *document))
      return at_line(*std::move(error), lesson);
  return document;
}

InputError at_line(InputError error, const Lesson& lesson) {
  for (const GivenSetting& given : lesson.settings)
    if ((error.place.kind == Place::Kind::centre_of_mass && given.setting == Setting::com) ||
        (error.place.kind == Place::Kind::option && error.place.option == name(given.setting)))
      error.place = {Place::Kind::line, given.line, 0, {}};
  return error;
}

std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address) {
  return std::visit(Finder{trace}, address);
}

std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace) {
  for (const LessonStep& step : lesson.steps)
    if (!find_step(trace, step.address))
      return InputError{ErrorCode::bad_syntax,
                        std::visit(Absence{trace}, step.address),
                        {Place::Kind::line, step.line, 0, {}}};
  return std::nullopt;
}

namespace {

InputError task_error(std::string message) { return {ErrorCode::bad_setting, std::move(message)}; }

// A random weighted mean of the supports, each with at least a tenth of an equal share. `number` is
// the seed.
Vec2 drawn_centre(const Points& supports, std::uint64_t number) {
  Rng rng(number);
  Vec2 sum;
  double total = 0;
  for (const Vec2& support : supports) {
    const double share = 0.1 + 0.9 * rng.uniform();
    sum += share * support;
    total += share;
  }
  return sum / total;
}

std::optional<InputError> hide_centre(Exercise& exercise, std::uint64_t number) {
  Document& document = exercise.start;
  if (document.settings.method != Method::given || document.settings.supports.size() < 3)
    return task_error(
        "the centre of mass can only be found from the loads of three or more supports");
  if (!document.centre_of_mass)
    document.centre_of_mass = drawn_centre(document.settings.supports, number);
  const Result<Placement> placement = place(document);
  if (!placement) return placement.error();
  if (!placement->loads || placement->lifting_base.size() < 3)
    return task_error(placement->loads
                          ? "the supports stand in a line, so their loads do not tell where C is"
                          : "the object falls, so its supports have no loads to read");
  for (const PlacedRobot& robot : placed_robots(*placement))
    exercise.readings.push_back(robot.load);
  document.centre_of_mass.reset();
  return std::nullopt;
}

std::optional<InputError> put_robots(Exercise& exercise, std::size_t robots) {
  Document& document = exercise.start;
  const Result<PolygonWithHoles> object = object_of(document);
  if (!object) return object.error();
  const auto centre = centre_of_mass(*object, document.centre_of_mass, document.settings);
  if (!centre) return centre.error();
  document.settings.method = Method::given;
  document.settings.goal.reset();
  document.settings.supports = supports_to_place(*object, centre->all, robots, document.settings);
  document.shown.support_capacities.clear();
  document.settings.support_names.clear();
  document.moved = {};
  return std::nullopt;
}

// changed_against() itself compares outline, holes, method and moved robots.
struct Part {
  Movable part;
  std::initializer_list<Setting> settings;
};
const Part parts[] = {
    {Movable::robots,
     {Setting::supports, Setting::support_capacities, Setting::support_names, Setting::robots}},
    {Movable::teams,
     {Setting::teams, Setting::min_ratio, Setting::seed, Setting::positions, Setting::goal,
      Setting::min_margin, Setting::apart}},
    {Movable::centre, {Setting::com}},
    {Movable::cargo, {Setting::cargo}},
};

bool may(const Task& task, Movable part) {
  return std::find(task.may.begin(), task.may.end(), part) != task.may.end();
}

bool may_set(const Task& task, Setting setting) {
  return std::any_of(std::begin(parts), std::end(parts), [&](const Part& part) {
    return may(task, part.part) &&
           std::find(part.settings.begin(), part.settings.end(), setting) != part.settings.end();
  });
}

// These only decide how a document is shown.
bool is_free(Setting setting) {
  return setting == Setting::overlays || setting == Setting::unit ||
         setting == Setting::weight_unit || setting == Setting::step;
}

bool may_use(const Task& task, Method from, Method to) {
  const auto is_pair = [](Method method) { return !is_one_team(method); };
  return from == to || (to == Method::given && may(task, Movable::robots)) ||
         (is_pair(to) && may(task, Movable::teams));
}

std::vector<std::string> changed_against(const Task& task, const Document& start,
                                         const Document& now) {
  std::vector<std::string> changed;
  if (!may(task, Movable::vertices)) {
    const bool is_other =
        std::none_of(now.vertices.begin(), now.vertices.end(), [&](const Vec2& vertex) {
          return std::find(start.vertices.begin(), start.vertices.end(), vertex) !=
                 start.vertices.end();
        });
    if (is_other) return {"the whole object, as if it were of another lesson or number"};
    if (start.vertices != now.vertices) changed.emplace_back("the outline");
    if (start.holes != now.holes) changed.emplace_back("the holes");
  }
  for (const SettingRow& row : all_settings()) {
    const Setting setting = row.setting;
    if (row.changes == Changes::view || is_free(setting)) continue;
    if (setting == Setting::method) {
      if (!may_use(task, start.settings.method, now.settings.method))
        changed.emplace_back(row.subject);
    } else if (counts(row.counts_for, now.settings) && !may_set(task, setting) &&
               text_of(setting, start) != text_of(setting, now)) {
      changed.emplace_back(row.subject);
    }
  }
  if (start.moved != now.moved && !may(task, Movable::robots) && !may(task, Movable::teams))
    changed.emplace_back("where robots stand");
  return changed;
}

// Compares the robots' loads with the readings.
std::vector<Goalpost> found(const Exercise& exercise, const ShownPlacement& of) {
  const std::vector<PlacedRobot> robots = placed_robots(of.placement);
  double largest = 0;
  for (const double reading : exercise.readings) largest = std::max(largest, reading);
  std::vector<Goalpost> goals;
  for (std::size_t i = 0; i < exercise.readings.size(); ++i) {
    const double reading = exercise.readings[i];
    const bool carries = of.placement.loads && i < robots.size();
    goals.push_back(
        {"load " + std::to_string(i + 1),
         say("Robot {robot} should carry {load}",
             {i + 1, load_in_words(reading, largest, of.shown.units)}),
         carries ? load_in_words(robots[i].load, largest, of.shown.units) : std::string(),
         carries && std::abs(robots[i].load - reading) <= found_within * of.placement.weight()});
  }
  return goals;
}

}  // namespace

Result<Exercise> exercise(const Lesson& lesson, const Document& sample, std::uint64_t number) {
  Result<Document> document = lesson_document(lesson, sample, number);
  if (!document) return document.error();
  Exercise exercise{*std::move(document), {}};
  if (!lesson.task) return exercise;
  if (lesson.task->place > 0)
    if (const auto error = put_robots(exercise, lesson.task->place)) return *error;
  if (lesson.task->find_centre)
    if (const auto error = hide_centre(exercise, number)) return *error;
  return exercise;
}

bool is_numbered(const Lesson& lesson) {
  const bool has_centre =
      std::any_of(lesson.settings.begin(), lesson.settings.end(),
                  [](const GivenSetting& given) { return given.setting == Setting::com; });
  return (lesson.generated && !lesson.generated->seed) ||
         (lesson.task && lesson.task->find_centre && !has_centre);
}

Attempt check_task(const Task& task, const Exercise& exercise, const Document& document,
                   const ShownPlacement& of) {
  Attempt attempt;
  if (task.find_centre) attempt.goals = found(exercise, of);
  for (const Requirement& requirement : check_conditions(of, task.conditions))
    attempt.goals.push_back({requirement.condition.text,
                             condition_in_words(requirement.condition, of.shown.units),
                             value_in_words(requirement, of.shown.units), requirement.kept});
  attempt.changed = changed_against(task, exercise.start, document);
  attempt.kept =
      attempt.changed.empty() && std::all_of(attempt.goals.begin(), attempt.goals.end(),
                                             [](const Goalpost& goal) { return goal.kept; });
  return attempt;
}

std::string movable_in_words(const Task& task) {
  static constexpr std::string_view words[] = {"the robots", "the teams", "the centre of mass",
                                               "the shape", "the cargo"};
  std::vector<std::string> parts;
  for (const auto part : task.may)
    parts.emplace_back(translated(words[static_cast<std::size_t>(part)]));
  return say("Only {parts} may be changed.", {listed(parts)});
}

}  // namespace evenlift
