#include "derive/derive.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "evenlift/document.h"
#include "evenlift/formats.h"
#include "evenlift/numbers.h"
#include "evenlift/swaps.h"

namespace evenlift::view {
namespace {

// Removes the word that it returns.
std::string_view next_word(std::string_view& text) {
  const std::size_t end = text.find(' ');
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return word;
}

std::optional<double> coordinate(std::string_view word) {
  const std::optional<double> value = read_number(word);
  return value && std::abs(*value) <= 2 * max_coordinate ? value : std::nullopt;
}

}  // namespace

std::string robots_text(const std::vector<LiftingPoint>& robots) {
  std::string text;
  for (const LiftingPoint& robot : robots)
    text += (text.empty() ? "" : " ") + std::to_string(robot.edge) + ' ' +
            shortest(robot.position.x) + ' ' + shortest(robot.position.y);
  return text;
}

std::optional<std::vector<LiftingPoint>> read_robots(std::string_view text, std::size_t number,
                                                     const Polygon& polygon) {
  const std::string_view given = text;
  std::vector<LiftingPoint> robots;
  while (!text.empty() && robots.size() < number) {
    const std::optional<std::uint64_t> edge = read_whole(next_word(text));
    const std::optional<double> x = coordinate(next_word(text)), y = coordinate(next_word(text));
    if (!edge || *edge >= polygon.vertices().size() || !x || !y) return std::nullopt;
    robots.push_back({Vec2(*x, *y), static_cast<std::uint32_t>(*edge)});
  }
  // Any text that robots_text() would not write is invalid.
  if (robots.size() != number || robots_text(robots) != given) return std::nullopt;
  return robots;
}

std::string plan_text(const FailurePlan& plan) {
  if (!plan.possible && !plan.can_tip) return std::to_string(plan.tried);
  const std::string found = std::to_string(plan.robots) + ' ' + shortest(plan.greatest_load);
  return plan.can_tip ? found + ' ' + std::to_string(plan.tried) : found;
}

std::optional<FailurePlan> read_plan(std::string_view text) {
  const std::string_view given = text;
  const std::optional<std::uint64_t> number = read_whole(next_word(text));
  if (!number || *number > most_robots) return std::nullopt;
  const auto robots = static_cast<std::uint32_t>(*number);
  const std::optional<double> greatest = read_number(next_word(text));
  const std::optional<std::uint64_t> tried = read_whole(text);
  if (tried && *tried > most_robots) return std::nullopt;
  const FailurePlan plan{greatest && !tried, greatest && tried, greatest ? robots : 0,
                         greatest.value_or(0), tried ? static_cast<std::uint32_t>(*tried) : robots};
  return plan_text(plan) == given ? std::optional(plan) : std::nullopt;
}

std::string setting_line(Setting setting, const Document& document) {
  const std::string text = text_of(setting, document);
  return text.empty() ? text : std::string(name(setting)) + '=' + text + '\n';
}

std::string settings_text(const Document& document) {
  std::string text;
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::stands || row.changes == Changes::loads)
      text += setting_line(row.setting, document);
  return text;
}

std::string settings_for_others(const Document& document) {
  constexpr Setting of_this_object[] = {
      Setting::com,           Setting::no_go, Setting::supports, Setting::support_capacities,
      Setting::support_names, Setting::cargo, Setting::overlays, Setting::step,
      Setting::failed};
  Document others = document;
  if (others.settings.method == Method::given) others.settings.method = Method::area;
  std::string text;
  for (const SettingRow& row : all_settings())
    if (row.changes != Changes::view &&
        std::find(std::begin(of_this_object), std::end(of_this_object), row.setting) ==
            std::end(of_this_object))
      text += setting_line(row.setting, others);
  return text;
}

bool read_lines(std::string_view lines, Document& document) {
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    const std::size_t equals = line.find('=');
    const auto setting = setting_from_name(line.substr(0, equals));
    if (!setting || equals == std::string_view::npos) return false;
    if (read_setting(*setting, line.substr(equals + 1), document)) return false;
  }
  return true;
}

namespace {

// Ends a search that found no robots. Returns false if there are robots.
bool find_none(Placement& placement) {
  if (!placement.teams.empty()) return false;
  placement.search_ended = true;
  return true;
}

// The balanced placement on the screen, or null.
std::optional<Placement>* balanced(Derived& facts) {
  for (std::optional<Placement>* placement : {&facts.placement, &facts.second})
    if (*placement && (*placement)->settings.method == Method::balanced) return placement;
  return nullptr;
}

// Without the holes that do not fit.
std::string object_text(const Derived& facts) {
  Document object = facts.placed;
  object.holes = facts.placement->object.rings_of_holes();
  return write_thesis(object);
}

// Settings and C as text, with the effective goal.
std::string settings_of(const Derived& facts, Settings settings) {
  settings.goal = goal_of(settings);
  return settings_text({{}, facts.placed.centre_of_mass, std::move(settings)});
}

Taken take_count(Derived& facts, const std::string& text) {
  facts.spare = read_plan(text);
  if (!facts.spare) return Taken::nothing;
  facts.search.counting = false;
  return Taken::count;
}

}  // namespace

void drop_search(Derived& facts, Effects& effects) {
  Search& search = facts.search;
  if (search.under_way || search.counting) effects.push_back(EndSearch{});
  search = {search.number, true};
}

void end_search(Derived& facts, Effects& effects) {
  drop_search(facts, effects);
  facts.search.due = false;
}

void begin_search(Derived& facts, Effects& effects) {
  if (!facts.search.due) return;
  facts.search.due = false;
  const std::optional<Placement>* shown = balanced(facts);
  if (facts.refusal || !shown || (*shown)->search_ended) return;
  const Placement& start = **shown;
  facts.search = {facts.search.number + 1, false, true};
  effects.push_back(BeginSearch{facts.search.number, object_text(facts),
                                settings_of(facts, start.settings),
                                robots_text(lifting_points(start.teams))});
}

void begin_count(Derived& facts, const Shown& shown, Effects& effects) {
  Search& search = facts.search;
  if (!shown.capacity || !facts.placement || facts.refusal || facts.spare) return;
  if (search.under_way || search.counting) return;
  const Settings& now = facts.placement->settings;
  if (now.method != Method::balanced || !facts.placement->search_ended) return;
  search = {search.number + 1, false, false, true};
  const Document conditions{{}, {}, {}, shown};
  std::string settings = settings_of(facts, now);
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::shown && row.plans)
      settings += setting_line(row.setting, conditions);
  effects.push_back(BeginSearch{search.number, object_text(facts), settings, {}});
}

void drop_count(Derived& facts, Effects& effects) {
  if (facts.search.counting) effects.push_back(EndSearch{});
  facts.search.counting = false;
  facts.spare.reset();
}

Taken take(Derived& facts, const Given::Found& found) {
  Search& search = facts.search;
  if (found.number != search.number) return Taken::nothing;
  if (search.counting && found.robots) return take_count(facts, *found.robots);
  std::optional<Placement>* shown = balanced(facts);
  if (!search.under_way || !shown) return Taken::nothing;
  if (!found.robots) {
    search.under_way = false;
    return Taken::same_robots;
  }
  Placement& placement = **shown;
  Taken taken = Taken::same_robots;
  if (found.ended && found.robots->empty()) {
    if (!find_none(placement)) return Taken::nothing;
  } else {
    const auto robots = read_robots(*found.robots, placement.settings.robots, placement.polygon());
    if (!robots) return Taken::nothing;
    if (robots_text(lifting_points(placement.teams)) != *found.robots) taken = Taken::other_robots;
    const bool cut_short = placement.cut_short || found.cut_short;  // in the start, or since
    *shown = with_robots(std::move(placement), *robots, found.ended, cut_short);
  }
  search.under_way = !found.ended;
  return taken;
}

namespace {

// A placement takes about a microsecond per vertex and candidate (docs/performance.md), and drawing
// takes half of a frame.
constexpr std::size_t most_within_a_frame = 8000;

// After a wrong number, all that follow are 0, and ok() is false.
class Reader {
 public:
  explicit Reader(std::span<const double> numbers) : rest_(numbers) {}

  bool ok() const { return ok_; }
  bool is_at_end() const { return ok_ && rest_.empty(); }
  std::size_t left() const { return rest_.size(); }

  double number() {
    if (rest_.empty() || !std::isfinite(rest_.front())) ok_ = false;
    if (!ok_) return 0;
    const double value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  std::size_t whole(std::size_t most) {
    const double value = number();
    if (!(value >= 0 && value <= static_cast<double>(most) && value == std::floor(value)))
      ok_ = false;
    return ok_ ? static_cast<std::size_t>(value) : 0;
  }
  std::uint32_t index(std::size_t end) {
    if (end == 0) ok_ = false;
    return ok_ ? static_cast<std::uint32_t>(whole(end - 1)) : 0;
  }
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }

 private:
  std::span<const double> rest_;
  bool ok_ = true;
};

void add(std::vector<double>& numbers, const Vec2& point) {
  numbers.insert(numbers.end(), {point.x, point.y});
}

void add(std::vector<double>& numbers, const LiftingPoint& point) {
  add(numbers, point.position);
  numbers.push_back(point.edge);
}

void add(std::vector<double>& numbers, const Candidate& candidate) {
  const Chord& chord = candidate.chord;
  add(numbers, chord.r1);
  add(numbers, chord.r2);
  numbers.insert(numbers.end(),
                 {chord.arm1, chord.arm2, chord.ratio, static_cast<double>(candidate.kind),
                  candidate.between_vertices ? 1.0 : 0.0});
  add(numbers, candidate.direction);
  numbers.push_back(candidate.length);
}
constexpr std::size_t numbers_of_a_candidate = 14;
constexpr std::size_t candidate_kinds = static_cast<std::size_t>(CandidateKind::range) + 1;

LiftingPoint read_point(Reader& reader, std::size_t edges) {
  const Vec2 position = reader.point();
  return {position, reader.index(edges)};
}

Candidate read_candidate(Reader& reader, std::size_t edges) {
  Candidate candidate;
  Chord& chord = candidate.chord;
  chord.r1 = read_point(reader, edges);
  chord.r2 = read_point(reader, edges);
  chord.arm1 = reader.number();
  chord.arm2 = reader.number();
  chord.ratio = reader.number();
  candidate.kind = static_cast<CandidateKind>(reader.index(candidate_kinds));
  candidate.between_vertices = reader.whole(1) == 1;
  candidate.direction = reader.point();
  candidate.length = reader.number();
  return candidate;
}

std::optional<Points> read_ring(Reader& reader, std::size_t size) {
  if (size > reader.left() / 2) return std::nullopt;
  Points ring(size);
  for (Vec2& vertex : ring) vertex = reader.point();
  return ring;
}

}  // namespace

bool is_for_a_worker(const Document& document, const Placement& before) {
  return selects_candidates(document.settings.method) && stands_anywhere(document.settings) &&
         !document.moved.any() && document.vertices.size() == before.vertices().size() &&
         document.holes.size() == before.object.holes().size() &&
         document.vertices.size() + before.candidates.size() > most_within_a_frame;
}

std::vector<double> rings_as_numbers(const Document& document) {
  std::vector<const Points*> rings = {&document.vertices};
  for (const Points& hole : document.holes) rings.push_back(&hole);
  std::vector<double> numbers = {static_cast<double>(rings.size())};
  for (const Points* ring : rings) numbers.push_back(static_cast<double>(ring->size()));
  for (const Points* ring : rings)
    for (const Vec2& vertex : *ring) add(numbers, vertex);
  return numbers;
}

std::string settings_as_selected(const Document& document) {
  Document as_selected{{}, document.centre_of_mass, document.settings};
  as_selected.settings.supports.clear();  // as text, they would make the method `given`
  if (swaps_teams(document.settings)) as_selected.settings.goal = Goal::cover;
  return settings_text(as_selected);
}

std::optional<Document> read_task(std::span<const double> rings, std::string_view settings) {
  Reader reader(rings);
  const std::size_t number = reader.whole(reader.left());
  if (number == 0 || number > reader.left()) return std::nullopt;
  std::vector<std::size_t> sizes(number);
  for (std::size_t& size : sizes) size = reader.whole(max_vertices);
  Document document;
  for (std::size_t i = 0; i < number; ++i) {
    std::optional<Points> ring = read_ring(reader, sizes[i]);
    if (!ring) return std::nullopt;
    if (i == 0)
      document.vertices = *std::move(ring);
    else
      document.holes.push_back(*std::move(ring));
  }
  if (!reader.is_at_end() || !read_lines(settings, document)) return std::nullopt;
  return document;
}

std::vector<double> choice_as_numbers(const Placement& placement) {
  std::vector<double> numbers;
  numbers.reserve(2 + placement.candidates.size() * numbers_of_a_candidate +
                  placement.team_candidates.size());
  numbers.push_back(static_cast<double>(placement.candidates.size()));
  numbers.push_back(static_cast<double>(placement.team_candidates.size()));
  for (const Candidate& candidate : placement.candidates) add(numbers, candidate);
  for (const std::uint32_t team : placement.team_candidates) numbers.push_back(team);
  return numbers;
}

std::optional<Choice> read_choice(std::span<const double> numbers, std::size_t edges) {
  Reader reader(numbers);
  const std::size_t candidates = reader.whole(numbers.size() / numbers_of_a_candidate),
                    teams = reader.whole(candidates);
  if (!reader.ok()) return std::nullopt;
  Choice choice;
  choice.candidates.reserve(candidates);
  for (std::size_t i = 0; i < candidates; ++i)
    choice.candidates.push_back(read_candidate(reader, edges));
  for (std::size_t i = 0; i < teams; ++i) choice.teams.push_back(reader.index(candidates));
  return reader.is_at_end() ? std::optional(std::move(choice)) : std::nullopt;
}

}  // namespace evenlift::view
