#include "evenlift/parts.h"

#include <algorithm>
#include <map>

#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/verdict.h"
#include "evenlift/placement.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/supports.h"

namespace evenlift {
namespace {

// Equal names get numbers, but not such that make other names.
void make_unique(std::vector<Part>& parts) {
  std::map<std::string, std::size_t> counts, used;
  for (const Part& part : parts) ++counts[part.name];
  for (Part& part : parts) {
    if (counts[part.name] == 1) continue;
    std::string numbered;
    do {
      numbered = part.name + " (" + std::to_string(++used[part.name]) + ")";
    } while (counts.contains(numbered));
    part.name = std::move(numbered);
  }
}

Result<Placement> placed(Document& document, const PartsAsked& asked, Beside& beside) {
  if (asked.even_out) {
    Result<Document> even = with_even_supports(document, asked.misfitting);
    if (!even) return even.error();
    beside.evened_out = support_moves(document, *even);
    document = *std::move(even);
  }
  return place(document, Effort::whole, asked.misfitting);
}

// Returns whether the number changed.
bool take_number_needed(Document& document, const Report& report) {
  Settings& settings = document.settings;
  if (!report.plan || !report.plan->possible || settings.method == Method::given) return false;
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
  for (const Quantity* column : part_columns()) result.columns.push_back(column->value(of));
  if (of.report.has_capacities) result.overloaded = of.report.overloaded.size();
  // The reason that the row gives should say that no other number would do.
  if (of.report.plan && !of.report.plan->possible && !of.report.overloaded.empty())
    result.problem += " " + needs_in_words(of);
}

}  // namespace

std::vector<Part> parts_of(const std::vector<ImportedShape>& shapes) {
  std::vector<Part> parts;
  for (const ImportedShape& shape : shapes) {
    const Box box = bounding_box(shape.document.vertices);
    const Result<PolygonWithHoles> object = object_of(shape.document);
    parts.push_back({parts.size() + 1, shape.name.empty() ? shape.kind : shape.name, box.middle(),
                     box.size(), object ? object->area() : 0});
  }
  make_unique(parts);
  return parts;
}

PartResult place_part(const Part& part, const ImportedShape& shape, const PartsAsked& wanted) {
  PartResult result;
  Asked asked{.model = wanted.model, .failures = wanted.failures};
  if (wanted.as_json) asked = {.models = true, .failures = wanted.failures};
  asked.plans = true;
  asked.failures |= need_failures(wanted.conditions);
  Document document = shape.document;
  if (!wanted.weight_by_area || part.area > 0) result.weight = total_weight(document.settings);
  Beside beside;
  Result<Placement> placement = placed(document, wanted, beside);
  if (placement && document.shown.capacity && !wanted.number_chosen &&
      take_number_needed(document, report_of({*placement, document.shown}, {.plans = true})))
    placement = placed(document, wanted, beside);
  result.settings = document.settings;
  if (!placement) {
    result.refusal = sentence(placement.error());
    if (wanted.as_json)
      result.json =
          json_line(part, shape, json::object({{"error", error_json(placement.error())}}));
    return result;
  }
  const Reported of({*placement, document.shown}, asked);
  const std::vector<Requirement> requirements = check_conditions(of, wanted.conditions);
  result.kept = std::all_of(requirements.begin(), requirements.end(),
                            [](const Requirement& each) { return each.kept; });
  summarize(of, result);
  if (wanted.as_json)
    result.json = json_line(
        part, shape, placement_json(of, wanted.candidates, wanted.failures, requirements, beside));
  return result;
}

}  // namespace evenlift
