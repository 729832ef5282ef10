#include "evenlift/experiment/aggregates.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "evenlift/numbers.h"
#include "experiment/measure/csv.h"

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

}  // namespace evenlift::experiment
