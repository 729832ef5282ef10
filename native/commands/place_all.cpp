#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

#include "commands/commands.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/quantities.h"
#include "evenlift/output/verdict.h"
#include "evenlift/placement.h"
#include "print/progress.h"
#include "print/table.h"
#include "print/threads.h"

namespace evenlift::native {
namespace {

// A part before robots are placed.
struct Part {
  std::size_t number = 0;  // with which --shape selects it
  std::string name;        // unique, or empty in JSON
  Vec2 at, size;           // the middle and the size of its bounding box
  double area = 0;         // without holes; 0 if the outline is invalid
};

struct PartResult {
  std::string refusal;  // empty if it was placed
  // With cargo; unknown if it follows from the area of an invalid outline.
  std::optional<double> weight;
  std::size_t robots = 0;
  // Of all quantities with a column; empty unless robots carry it.
  std::vector<std::optional<double>> columns;
  std::optional<std::size_t> overloaded;  // robots, if any has a capacity
  std::string verdict, problem;           // its kind, and the first reason
  bool kept = true;                       // all conditions
  std::string json;                       // with --json only
  bool done = false;
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
  if (options.weight.typed() && options.input.settings.typed(Setting::weight))
    refuse("--weight", "applies without a weight by area");
  if (options.table.csv) check_output_file("--csv", *options.table.csv, options.input.file);
}

// --- The parts

// A part without a name is called by its kind; equal names get numbers.
void make_unique(std::vector<Part>& parts, const std::vector<ImportedShape>& shapes) {
  std::map<std::string, std::size_t> counts, used;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].name.empty()) parts[i].name = shapes[i].kind;
    ++counts[parts[i].name];
  }
  for (Part& part : parts)
    if (counts[part.name] > 1) part.name += " (" + std::to_string(++used[part.name]) + ")";
}

std::vector<Part> parts_of(const std::vector<ImportedShape>& shapes) {
  std::vector<Part> parts;
  for (const ImportedShape& shape : shapes) {
    const Box box = bounding_box(shape.document.vertices);
    const Result<PolygonWithHoles> object = object_of(shape.document);
    parts.push_back(
        {parts.size() + 1, shape.name, box.middle(), box.size(), object ? object->area() : 0});
  }
  make_unique(parts, shapes);
  return parts;
}

// Whether a part comes before another by the column of --sort; large values first.
using Before = bool (*)(const Part& a, const ImportedShape& of_a, const Part& b,
                        const ImportedShape& of_b);
struct SortColumn {
  const char* name;
  Before before;  // null if it needs the results
};
constexpr SortColumn sort_columns[] = {
    {"file", [](const Part&, const ImportedShape& a, const Part&,
                const ImportedShape& b) { return a.order < b.order; }},
    {"number", [](const Part& a, const ImportedShape&, const Part& b,
                  const ImportedShape&) { return a.number < b.number; }},
    {"name", [](const Part& a, const ImportedShape&, const Part& b,
                const ImportedShape&) { return a.name < b.name; }},
    {"area", [](const Part& a, const ImportedShape&, const Part& b,
                const ImportedShape&) { return a.area > b.area; }},
    {"weight",
     [](const Part&, const ImportedShape& a, const Part&, const ImportedShape& b) {
       return total_weight(a.document.settings) > total_weight(b.document.settings);
     }},
    {"load", nullptr}};

const SortColumn& sort_column(const TableOptions& options) {
  const std::string wanted = options.sort.value_or("file");
  for (const SortColumn& column : sort_columns)
    if (wanted == column.name) return column;
  throw bad_value("--sort", "expected file, number, name, area, weight or load", wanted);
}

// --- Results

Result<Placement> placed(Document& document, const PlaceOptions& options, Beside& beside) {
  if (options.even_out) {
    Result<Document> even = with_even_supports(document);
    if (!even) return even.error();
    beside.evened_out = support_moves(document, *even);
    document = *std::move(even);
  }
  return place(document);
}

// With a capacity, each part has the number of robots that it needs, unless one was typed; at least two
// teams or three balanced robots, since fewer stand on one line. Returns whether the number changed.
bool take_number_needed(Document& document, const Report& report, const PlaceOptions& options) {
  const auto& typed = options.input.settings;
  Settings& settings = document.settings;
  if (!report.plan || !report.plan->possible || settings.method == Method::given ||
      typed.typed(Setting::teams) || typed.typed(Setting::robots))
    return false;
  const Settings before = settings;
  if (settings.method == Method::balanced)
    settings.robots =
        std::clamp(report.plan->teams * report.plan->team_size, std::uint32_t{3}, most_robots);
  else
    settings.teams = std::max(report.plan->teams, std::uint32_t{2});
  return !(settings == before);
}

std::string json_line(const Part& part, const ImportedShape& shape, const std::string& object) {
  const std::string name = shape.name.empty() ? std::string() : part.name;
  return "{\"shape\": " + std::to_string(part.number) + ", \"name\": " + json::text(name) +
         ", \"at\": " + json::pair(part.at) + ", \"size\": " + json::pair(part.size) +
         ", \"area\": " + json::number(part.area) + ", " + json::on_one_line(object).substr(1) +
         "\n";
}

void summarize(const Reported& of, PartResult& result) {
  const Judgement judgement = judge(of);
  result.weight = of.placement.weight();
  result.verdict = name(judgement.kind);
  if (!judgement.reasons.empty()) result.problem = judgement.reasons.front();
  result.robots = count_robots(of.placement.teams);
  if (result.robots == 0 || !of.placement.loads) return;
  for (const Quantity* column : columns()) result.columns.push_back(column->value(of));
  if (of.report.has_capacities) result.overloaded = of.report.overloaded.size();
  // The reason that the row gives should say that no other number would do.
  if (of.report.plan && !of.report.plan->possible && !of.report.overloaded.empty())
    result.problem += " " + needs_in_words(of);
}

PartResult result_of(const Part& part, const ImportedShape& shape, const PlaceOptions& options,
                     const std::vector<Condition>& conditions) {
  PartResult result;
  Asked asked = asked_by(options.robustness, shape.document.shown);
  const bool failures = asked.failures;
  if (options.as_json) asked = {.models = true, .failures = failures};
  asked.plans = true;
  asked.failures |= need_failures(conditions);
  Document document = shape.document;
  if (!options.weight.typed() || part.area > 0) result.weight = total_weight(document.settings);
  Beside beside;
  Result<Placement> placement = placed(document, options, beside);
  if (placement && document.shown.capacity &&
      take_number_needed(document, report_of({*placement, document.shown}, {.plans = true}),
                         options))
    placement = placed(document, options, beside);
  if (!placement) {
    result.refusal = sentence(placement.error());
    if (options.as_json)
      result.json =
          json_line(part, shape, json::object({{"error", error_json(placement.error())}}));
    return result;
  }
  const Reported of({*placement, document.shown}, asked);
  const std::vector<Requirement> requirements = check_conditions(of, conditions);
  result.kept = std::all_of(requirements.begin(), requirements.end(),
                            [](const Requirement& each) { return each.kept; });
  summarize(of, result);
  if (options.as_json)
    result.json = json_line(part, shape,
                            placement_json(of, options.candidates, failures, requirements, beside));
  return result;
}

std::optional<double> greatest_load(const PartResult& result) {
  return result.columns.empty() ? std::nullopt : result.columns.front();
}

// --- Tables

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

struct Rows {
  const std::vector<ImportedShape>& shapes;
  const std::vector<Part>& parts;
  const std::vector<PartResult>& results;  // in the order of the parts
  std::vector<std::size_t> order;          // of the rows
};

std::string table_of(const Rows& rows, bool conditions) {
  const std::vector<const Quantity*> shown = columns();
  double heaviest = 0, widest = 0;  // for the decimals
  bool capacities = false;
  for (std::size_t k = 0; k < rows.parts.size(); ++k) {
    const PartResult& result = rows.results[k];
    for (std::size_t i = 0; i < result.columns.size(); ++i)
      if (shown[i]->unit == Unit::weight)
        heaviest = std::max(heaviest, result.columns[i].value_or(0));
    capacities = capacities || result.overloaded;
    const Part& part = rows.parts[k];
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
  for (const std::size_t at : rows.order) {
    const Part& part = rows.parts[at];
    const PartResult& result = rows.results[at];
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

// Numbers are those of JSON; what is unknown is an empty cell.
std::string csv_of(const Rows& rows, bool conditions) {
  std::string text = "shape,name,x,y,width,height,area,weight,robots";
  for (const Quantity* column : columns()) {
    std::string heading(column->column);
    std::replace(heading.begin(), heading.end(), ' ', '_');
    text += "," + heading;
  }
  text += std::string(",overloaded") + (conditions ? ",kept" : "") + ",verdict,problem\n";
  for (const std::size_t at : rows.order) {
    const Part& part = rows.parts[at];
    const PartResult& result = rows.results[at];
    const bool refused = !result.refusal.empty();
    text += std::to_string(part.number) + "," + csv_cell(part.name);
    for (const double value : {part.at.x, part.at.y, part.size.x, part.size.y, part.area})
      text += "," + shortest(value);
    text += "," + (result.weight ? shortest(*result.weight) : std::string());
    text += "," + (refused ? std::string() : std::to_string(result.robots));
    const std::vector<const Quantity*> shown = columns();
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const bool is_known = i < result.columns.size() && result.columns[i];
      text += ",";
      if (is_known)
        text += shown[i]->unit == Unit::yes_or_no ? yes_or_no(*result.columns[i] == 1)
                                                  : shortest(*result.columns[i]);
    }
    text += "," + (result.overloaded ? std::to_string(*result.overloaded) : std::string());
    if (conditions) text += "," + (refused ? std::string() : yes_or_no(result.kept));
    text += "," + (refused ? "refused" : result.verdict) + "," +
            csv_cell(refused ? result.refusal : result.problem) + "\n";
  }
  return text;
}

// Writes the lines of JSON that are next in the order, as soon as they are done.
class Lines {
 public:
  Lines(const std::vector<std::size_t>& order, std::vector<PartResult>& results)
      : order_(order), results_(results) {}

  void done(std::size_t part, PartResult result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    results_[part] = std::move(result);
    results_[part].done = true;
    for (; next_ < order_.size() && results_[order_[next_]].done; ++next_) {
      std::string& json = results_[order_[next_]].json;
      if (!json.empty()) write_output(json);
      json = {};
    }
  }

 private:
  const std::vector<std::size_t>& order_;
  std::vector<PartResult>& results_;
  std::size_t next_ = 0;
  std::mutex mutex_;
};

}  // namespace

void place_all(const PlaceOptions& options) {
  check_options(options);
  const std::vector<Condition> conditions = options.conditions();
  const SortColumn& sort = sort_column(options.table);
  const unsigned jobs = jobs_option(options.table.jobs);
  InputShapes input = options.input.read_all();
  std::vector<ImportedShape>& shapes = input.shapes;
  for (ImportedShape& shape : shapes) {
    options.weight.apply(shape.document);
    asked_by(options.robustness, shape.document.shown);  // refuses options that do not fit
  }
  options.weight.explain(shapes.front().document.shown.units);
  const std::vector<Part> parts = parts_of(shapes);
  std::vector<PartResult> results(shapes.size());
  Rows rows{shapes, parts, results, std::vector<std::size_t>(shapes.size())};
  std::iota(rows.order.begin(), rows.order.end(), std::size_t{0});
  if (sort.before)
    std::stable_sort(rows.order.begin(), rows.order.end(), [&](std::size_t a, std::size_t b) {
      return sort.before(parts[a], shapes[a], parts[b], shapes[b]);
    });
  {
    Waiting waiting("placing the robots", shapes.size(), "shape");
    Lines lines(rows.order, results);
    in_threads(shapes.size(), jobs, [&](std::size_t turn) {
      waiting.begin();
      const std::size_t part = rows.order[turn];
      PartResult result = result_of(parts[part], shapes[part], options, conditions);
      if (sort.before) return lines.done(part, std::move(result));
      results[part] = std::move(result);
    });
  }
  if (!sort.before) {
    std::stable_sort(rows.order.begin(), rows.order.end(), [&](std::size_t a, std::size_t b) {
      return greatest_load(results[a]).value_or(-1) > greatest_load(results[b]).value_or(-1);
    });
    for (const std::size_t part : rows.order) write_output(results[part].json);
  }
  if (options.table.csv) write_file(*options.table.csv, csv_of(rows, !conditions.empty()));
  if (!options.as_json) write_output(table_of(rows, !conditions.empty()));

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
