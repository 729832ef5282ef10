#include "commands/commands.h"

#include <algorithm>

#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/quantities.h"
#include "evenlift/placement.h"
#include "print/progress.h"
#include "print/table.h"

namespace evenlift::native {
namespace {

struct ShapeResult {
  std::string name;  // or its kind
  std::size_t vertices = 0;
  std::string refusal;  // empty if it was placed
  std::size_t robots = 0;
  std::vector<std::optional<double>>
      columns;  // of all quantities with a column; empty unless robots carry it
  std::optional<std::size_t> overloaded;  // robots, if any has a capacity
  bool kept = true;                       // all conditions
  std::string json;                       // with --json only
};

std::vector<const Quantity*> columns() {
  std::vector<const Quantity*> found;
  for (const Quantity& quantity : quantities())
    if (!quantity.column.empty()) found.push_back(&quantity);
  return found;
}

void check_options(const PlaceOptions& options) {
  const auto refuse = [](const char* option, const char* why) {
    throw Failure{bad_input_status, option, why};
  };
  constexpr char one_file[] = "writes a file for one shape, so --shape must select one";
  constexpr char one_table[] = "applies to --shape all only with --json";
  if (options.svg) refuse("--svg", one_file);
  if (options.poses.file) refuse("--poses", one_file);
  options.poses.asked();  // refuses --frame and --origin without --poses
  if (options.candidates && !options.as_json) refuse("--candidates", one_table);
  if (options.robustness.failures && !options.as_json) refuse("--failures", one_table);
}

Result<Placement> placed(Document& document, const PlaceOptions& options, Beside& beside) {
  if (options.even_out) {
    Result<Document> even = with_even_supports(document);
    if (!even) return even.error();
    beside.evened_out = support_moves(document, *even);
    document = *std::move(even);
  }
  return place(document);
}

std::string json_line(std::size_t number, const std::string& name, const std::string& object) {
  return "{\"shape\": " + std::to_string(number) + ", \"name\": " + json::text(name) + ", " +
         json::on_one_line(object).substr(1) + "\n";
}

void summarize(const Reported& of, ShapeResult& result) {
  result.robots = count_robots(of.placement.teams);
  if (result.robots == 0 || !of.placement.loads) return;
  for (const Quantity* column : columns()) result.columns.push_back(column->value(of));
  if (of.report.has_capacities) result.overloaded = of.report.overloaded.size();
}

ShapeResult result_of(std::size_t number, const ImportedShape& shape, const PlaceOptions& options,
                      const std::vector<Condition>& conditions) {
  ShapeResult result;
  result.name = shape.name.empty() ? shape.kind : shape.name;
  result.vertices = shape.document.vertices.size();
  Asked asked = asked_by(options.robustness, shape.document.shown);
  if (options.as_json) asked = {.models = true, .failures = asked.failures, .plans = true};
  const bool failures = asked.failures;
  asked.failures |= need_failures(conditions);
  Document document = shape.document;
  Beside beside;
  const Result<Placement> placement = placed(document, options, beside);
  if (!placement) {
    result.refusal = sentence(placement.error());
    if (options.as_json)
      result.json =
          json_line(number, shape.name, json::object({{"error", error_json(placement.error())}}));
    return result;
  }
  const Reported of({*placement, document.shown}, asked);
  const std::vector<Requirement> requirements = check_conditions(of, conditions);
  result.kept = std::all_of(requirements.begin(), requirements.end(),
                            [](const Requirement& each) { return each.kept; });
  if (options.as_json)
    result.json = json_line(number, shape.name,
                            placement_json(of, options.candidates, failures, requirements, beside));
  else
    summarize(of, result);
  return result;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

std::string table_of(const std::vector<ShapeResult>& results, bool conditions) {
  const std::vector<const Quantity*> shown = columns();
  double heaviest = 0;  // for the decimals of loads
  bool capacities = false;
  for (const ShapeResult& result : results) {
    for (std::size_t i = 0; i < result.columns.size(); ++i)
      if (shown[i]->unit == Unit::weight)
        heaviest = std::max(heaviest, result.columns[i].value_or(0));
    capacities = capacities || result.overloaded;
  }
  std::vector<Row> rows = {{"shape", "name", "vertices", "robots"}};
  const auto is_shown = [&](const Quantity* column) {
    return capacities || !column->needs_capacities;
  };
  for (const Quantity* column : shown)
    if (is_shown(column)) rows[0].emplace_back(column->column);
  if (capacities) rows[0].push_back("overloaded");
  if (conditions) rows[0].push_back("kept");
  std::vector<std::string> remarks(1);
  for (const ShapeResult& result : results) {
    Row row = {std::to_string(rows.size()), result.name, std::to_string(result.vertices)};
    remarks.push_back(result.refusal);
    if (result.refusal.empty()) {
      row.push_back(std::to_string(result.robots));
      for (std::size_t i = 0; i < shown.size(); ++i) {
        if (!is_shown(shown[i])) continue;
        const bool is_known = i < result.columns.size() && result.columns[i];
        row.push_back(is_known ? cell_in_words(*shown[i], *result.columns[i], heaviest) : "-");
      }
      if (capacities)
        row.push_back(result.columns.empty() ? "-" : std::to_string(result.overloaded.value_or(0)));
      if (conditions) row.push_back(yes_or_no(result.kept));
    }
    rows.push_back(std::move(row));
  }
  return table(rows, remarks);
}

}  // namespace

void place_all(const PlaceOptions& options) {
  check_options(options);
  const std::vector<Condition> conditions = options.conditions();
  const InputShapes input = options.input.read_all();
  std::vector<ShapeResult> results;
  {
    Waiting waiting("placing the robots", input.shapes.size(), "shape");
    for (const ImportedShape& shape : input.shapes) {
      waiting.begin();
      results.push_back(result_of(results.size() + 1, shape, options, conditions));
    }
  }
  std::string lines;
  for (const ShapeResult& result : results) lines += result.json;
  write_output(options.as_json ? lines : table_of(results, !conditions.empty()));

  const auto refused = std::count_if(results.begin(), results.end(),
                                     [](const ShapeResult& each) { return !each.refusal.empty(); });
  if (refused > 0)
    throw Failure{bad_input_status, input.source,
                  std::to_string(refused) + " of " + std::to_string(results.size()) + " shapes " +
                      (refused == 1 ? "was" : "were") + " refused"};
  if (std::any_of(results.begin(), results.end(),
                  [](const ShapeResult& each) { return !each.kept; }))
    throw Failure{not_kept_status, {}, {}, {}, true};
}

}  // namespace evenlift::native
