#include <algorithm>
#include <mutex>

#include "commands/commands.h"
#include "evenlift/parts.h"
#include "print/progress.h"
#include "print/table.h"
#include "print/threads.h"

namespace evenlift::native {
namespace {

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
  if (options.table.csv) check_output_file("--csv", *options.table.csv, options.input.file);
}

PartOrder order_of(const TableOptions& options) {
  const auto order = part_order_from_name(options.sort.value_or("file"));
  if (!order) throw bad_value("--sort", part_order_requirement, *options.sort);
  return *order;
}

PartsAsked asked_of(const PlaceOptions& options) {
  const auto& typed = options.input.settings;
  PartsAsked asked;
  asked.conditions = options.conditions();
  asked.weight_by_area = options.weight.typed();
  asked.number_chosen = typed.typed(Setting::teams) || typed.typed(Setting::robots);
  asked.even_out = options.even_out;
  asked.misfitting = options.misfitting();
  asked.failures = options.robustness.failures;
  if (options.robustness.loads) asked.model = loads_option(*options.robustness.loads);
  asked.as_json = options.as_json;
  asked.candidates = options.candidates;
  return asked;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

// The results are in the order of the parts.
std::string table_of(const std::vector<std::size_t>& rows, const std::vector<Part>& parts,
                     const std::vector<PartResult>& results, bool conditions) {
  const std::vector<const Quantity*>& shown = part_columns();
  double heaviest = 0, widest = 0;  // for the decimals
  bool capacities = false;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const PartResult& result = results[k];
    for (std::size_t i = 0; i < result.columns.size(); ++i)
      if (shown[i]->unit == Unit::weight)
        heaviest = std::max(heaviest, result.columns[i].value_or(0));
    capacities = capacities || result.overloaded;
    const Part& part = parts[k];
    widest = std::max({widest, part.size.x, part.size.y});
  }
  std::vector<Row> cells = {{"shape", "name", "size", "weight", "robots"}};
  const auto is_shown = [&](const Quantity* column) {
    return capacities || !column->needs_capacities;
  };
  for (const Quantity* column : shown)
    if (is_shown(column)) cells[0].emplace_back(column->column);
  if (capacities) cells[0].push_back("overloaded");
  if (conditions) cells[0].push_back("kept");
  cells[0].push_back("verdict");
  std::vector<std::string> remarks(1);
  for (const std::size_t at : rows) {
    const Part& part = parts[at];
    const PartResult& result = results[at];
    Row row = {std::to_string(part.number), part.name,
               amount(part.size.x, widest) + " x " + amount(part.size.y, widest),
               result.weight ? amount(*result.weight, *result.weight) : "-"};
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
      row.push_back(result.verdict);
    }
    cells.push_back(std::move(row));
  }
  return table(cells, remarks);
}

// Writes the lines of JSON that are next in the order, as soon as they are done.
class Lines {
 public:
  Lines(const std::vector<std::size_t>& order, std::vector<PartResult>& results)
      : order_(order), results_(results), done_(results.size()) {}

  void done(std::size_t part, PartResult result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    results_[part] = std::move(result);
    done_[part] = true;
    for (; next_ < order_.size() && done_[order_[next_]]; ++next_) {
      std::string& json = results_[order_[next_]].json;
      if (!json.empty()) write_output(json);
      json = {};
    }
  }

 private:
  const std::vector<std::size_t>& order_;
  std::vector<PartResult>& results_;
  std::vector<bool> done_;
  std::size_t next_ = 0;
  std::mutex mutex_;
};

}  // namespace

void place_all(const PlaceOptions& options) {
  check_options(options);
  options.conditions();  // refuses those that are invalid
  const PartOrder order = order_of(options.table);
  const unsigned jobs = jobs_option(options.table.jobs);
  InputShapes input = options.input.read_all();
  std::vector<ImportedShape>& shapes = input.shapes;
  for (ImportedShape& shape : shapes) {
    options.apply_weight(shape.document);
    asked_by(options.robustness, shape.document.shown);  // refuses options that do not fit
  }
  options.explain_weight(shapes.front().document.shown.units);
  const std::vector<Part> parts = parts_of(shapes);
  const PartsAsked asked = asked_of(options);
  std::vector<PartResult> results(shapes.size());
  std::vector<std::size_t> rows = order_of_rows(order, shapes, parts, {});
  {
    Waiting waiting("placing the robots", shapes.size(), "shape");
    Lines lines(rows, results);
    in_threads(shapes.size(), jobs, [&](std::size_t turn) {
      waiting.begin();
      const std::size_t part = rows[turn];
      PartResult result = place_part(parts[part], shapes[part], asked);
      if (order != PartOrder::load) return lines.done(part, std::move(result));
      results[part] = std::move(result);
    });
  }
  if (order == PartOrder::load) {
    rows = order_of_rows(order, shapes, parts, results);
    for (const std::size_t part : rows) write_output(results[part].json);
  }
  const bool conditions = !asked.conditions.empty();
  if (options.table.csv)
    write_file(*options.table.csv, parts_csv(rows, parts, results, conditions));
  if (!options.as_json) write_output(table_of(rows, parts, results, conditions));

  const auto refused = std::count_if(results.begin(), results.end(),
                                     [](const PartResult& each) { return !each.refusal.empty(); });
  if (refused > 0)
    throw Failure{bad_input_status, input.source,
                  std::to_string(refused) + " of " + std::to_string(results.size()) + " shapes " +
                      (refused == 1 ? "was" : "were") + " refused"};
  if (std::any_of(results.begin(), results.end(),
                  [](const PartResult& each) { return !each.kept; }))
    throw Failure{not_kept_status, {}, {}, {}, true};
}

}  // namespace evenlift::native
