#include "evenlift/experiment/few_robots.h"

#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "experiment/thesis/markdown.h"

namespace evenlift::experiment {
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
