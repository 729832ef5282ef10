#include "evenlift/experiment/aggregates.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/experiment/few_robots.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "evenlift/tolerance.h"
#include "experiment/measure/csv.h"
#include "experiment/thesis/by_polygon.h"

namespace evenlift::experiment {
namespace {

// The values of one method and number of robots, in the order of the polygons.
struct Column {
  std::vector<double> spread, load_max, max_share, coverage, closed, held_clear;
  std::vector<double> form_closure, no_area;  // of polygons that can_close()
};

std::string optional_number(const std::optional<double>& value) {
  return value ? shortest(*value) : "";
}

csv::Row aggregate_row(const std::string& set, const Aggregate& a) {
  csv::Row row = {set, std::string(name(a.method)), std::to_string(teams_of(a.method, a.robots)),
                  std::to_string(a.robots), std::to_string(a.polygons)};
  for (const Statistics& s : {a.spread, a.load_max, a.max_share, a.coverage}) {
    row.push_back(shortest(s.mean));
    row.push_back(optional_number(s.deviation));
  }
  row.push_back(shortest(a.closed));
  row.push_back(std::to_string(a.closable));
  row.push_back(optional_number(a.form_closure));
  row.push_back(std::to_string(a.no_area_possible));
  row.push_back(optional_number(a.no_area));
  row.push_back(shortest(a.held_clear));
  return row;
}

}  // namespace

Statistics statistics(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  Statistics s{sum / n, std::nullopt};
  if (values.size() < 2) return s;
  double squares = 0;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  s.deviation = std::sqrt(squares / (n - 1));
  return s;
}

bool can_close(const PolygonResult& result, Closed closed) {
  return std::any_of(
      result.measurements.begin(), result.measurements.end(),
      [&](const Measurement& m) { return m.method != Method::balanced && m.*closed > 0; });
}

std::vector<Aggregate> aggregate(const std::vector<PolygonResult>& results) {
  std::map<std::pair<Method, std::uint32_t>, Column> columns;
  for (const PolygonResult& result : results) {
    const bool closable = can_close(result, &Measurement::form_closure),
               no_area_possible = can_close(result, &Measurement::no_area);
    for (const Measurement& m : result.measurements) {
      Column& column = columns[{m.method, m.robots}];
      column.spread.push_back(m.spread);
      column.load_max.push_back(m.load_max);
      column.max_share.push_back(m.max_share);
      column.coverage.push_back(m.coverage);
      column.closed.push_back(m.form_closure);
      column.held_clear.push_back(m.held_clear);
      if (closable) column.form_closure.push_back(m.form_closure);
      if (no_area_possible) column.no_area.push_back(m.no_area);
    }
  }
  std::vector<Aggregate> aggregates;
  for (const auto& [key, column] : columns) {
    Aggregate a;
    a.method = key.first;
    a.robots = key.second;
    a.polygons = static_cast<std::uint32_t>(column.spread.size());
    a.spread = statistics(column.spread);
    a.load_max = statistics(column.load_max);
    a.max_share = statistics(column.max_share);
    a.coverage = statistics(column.coverage);
    a.closed = statistics(column.closed).mean;
    a.held_clear = statistics(column.held_clear).mean;
    a.closable = static_cast<std::uint32_t>(column.form_closure.size());
    if (a.closable > 0) a.form_closure = statistics(column.form_closure).mean;
    a.no_area_possible = static_cast<std::uint32_t>(column.no_area.size());
    if (a.no_area_possible > 0) a.no_area = statistics(column.no_area).mean;
    aggregates.push_back(a);
  }
  return aggregates;
}

std::string aggregates_csv(const std::vector<SetAggregates>& sets) {
  std::string text =
      csv::line({"set", "method", "teams", "robots", "polygons", "spread_mean", "spread_sd",
                 "load_max_mean", "load_max_sd", "max_share_mean", "max_share_sd", "coverage_mean",
                 "coverage_sd", "closed_mean", "closable", "form_closure_mean", "no_area_possible",
                 "no_area_mean", "held_clear_mean"});
  for (const SetAggregates& set : sets)
    for (const Aggregate& a : set.aggregates) text += csv::line(aggregate_row(set.set, a));
  return text;
}

const Aggregate* find(const std::vector<Aggregate>& aggregates, Method method,
                      std::uint32_t robots) {
  for (const Aggregate& a : aggregates)
    if (a.method == method && a.robots == robots) return &a;
  return nullptr;
}

namespace {

// Whether a spread is zero except for rounding: it is at most τ times the mean load.
bool is_even(double spread, std::uint32_t robots) {
  return spread <= tau * experiment_weight / robots;
}

}  // namespace

std::optional<double> pick_spread(const Aggregate& a) { return a.spread.mean; }
std::optional<double> pick_share(const Aggregate& a) { return a.max_share.mean; }
std::optional<double> pick_coverage(const Aggregate& a) { return a.coverage.mean; }
std::optional<double> pick_closure(const Aggregate& a) { return a.form_closure; }

std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t robots, Pick pick) {
  double sum = 0;
  for (const Method method : candidate_methods) {
    const Aggregate* a = find(aggregates, method, robots);
    const std::optional<double> value = a ? pick(*a) : std::nullopt;
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / static_cast<double>(std::size(candidate_methods));
}

std::optional<double> spread_times(const std::vector<Aggregate>& aggregates, Method method,
                                   std::uint32_t robots) {
  const std::optional<double> ours = algorithm_average(aggregates, robots, pick_spread);
  const Aggregate* other = find(aggregates, method, robots);
  if (!ours || !other || is_even(*ours, robots)) return std::nullopt;
  return other->spread.mean / *ours;
}

std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Method method,
                                  std::uint32_t most_robots) {
  std::optional<Range> range;
  for (std::uint32_t robots = 2; robots <= most_robots; robots += 2) {
    const std::optional<double> times = spread_times(aggregates, method, robots);
    if (!times) continue;
    if (!range) range = {*times, *times};
    range->least = std::min(range->least, *times);
    range->most = std::max(range->most, *times);
  }
  return range;
}

std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Method method,
                                    std::uint32_t most_robots) {
  double sum = 0;
  int count = 0;
  for (std::uint32_t robots = 4; robots <= most_robots; robots += 2) {
    const std::optional<double> ours = algorithm_average(aggregates, robots, pick_coverage);
    const Aggregate* other = find(aggregates, method, robots);
    if (!ours || !other) continue;
    sum += *ours - other->coverage.mean;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

namespace {

std::string bare_percent(double share) { return fixed(100 * share, 1); }

// A column of the aggregates, in words and digits.
struct Measure {
  const char* what;
  std::string (*digits)(const Aggregate&);
};

constexpr Measure measures[] = {
    {"coverage, %", [](const Aggregate& a) { return bare_percent(a.coverage.mean); }},
    {"in form closure, %", [](const Aggregate& a) { return bare_percent(a.closed); }},
    {"held with clearance, %", [](const Aggregate& a) { return bare_percent(a.held_clear); }},
    {"spread of loads, kg of 100 kg", [](const Aggregate& a) { return fixed(a.spread.mean, 2); }},
    {"number of polygons", [](const Aggregate& a) { return std::to_string(a.polygons); }},
};

FewRobotsRow make_row(const SetAggregates& set, const Measure& measure, std::uint32_t robots) {
  FewRobotsRow row{measure.what, robots, {}};
  for (const Method method : all_methods) {
    const Aggregate* a = find(set.aggregates, method, robots);
    row.cells.push_back(a ? measure.digits(*a) : "–");
  }
  return row;
}

}  // namespace

FewRobots few_robots(const SetAggregates& set) {
  FewRobots table{set.set, {}};
  for (const Measure& measure : measures)
    for (std::uint32_t robots = few_robots_from; robots <= few_robots_to; ++robots)
      table.rows.push_back(make_row(set, measure, robots));
  return table;
}

std::string few_robots_markdown(const std::vector<FewRobots>& sets) {
  std::string text;
  for (const FewRobots& set : sets) {
    std::vector<std::string> heads = {markdown::cell(set.set), "robots"};
    for (const Method method : all_methods) heads.emplace_back(name(method));
    text += (text.empty() ? "" : "\n") + markdown::row(heads) +
            markdown::row(std::vector<std::string>(heads.size(), "---"));
    for (const FewRobotsRow& row : set.rows) {
      std::vector<std::string> cells = {row.what, std::to_string(row.robots)};
      cells.insert(cells.end(), row.cells.begin(), row.cells.end());
      text += markdown::row(cells);
    }
  }
  return text;
}

std::string few_robots_json(const std::vector<FewRobots>& sets) {
  std::vector<std::string> tables;
  for (const FewRobots& set : sets) {
    std::vector<std::string> rows;
    for (const FewRobotsRow& row : set.rows) {
      std::vector<std::string> cells;
      for (const std::string& cell : row.cells) cells.push_back(json::text(cell));
      rows.push_back(json::object({{"what", json::text(row.what)},
                                   {"robots", std::to_string(row.robots)},
                                   {"cells", json::array(cells)}}));
    }
    tables.push_back(
        json::object({{"set", json::text(set.set)}, {"rows", json::long_array(rows, 0)}}));
  }
  return json::long_array(tables, 0) + "\n";
}

}  // namespace evenlift::experiment
