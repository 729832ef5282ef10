#include "commands/commands.h"

namespace evenlift::native {

void TableOptions::declare(CommandLine& line) {
  line.value(csv, "--csv", "OUT", "with --shape all: also write the rows as CSV");
  line.value(
      sort, "--sort", "COLUMN",
      "with --shape all: order of the rows: file (default), number, name, area, weight or load");
  line.value(jobs, "--jobs", "J", "with --shape all: threads (default all processors)");
}

void PlaceOptions::declare(CommandLine& line) {
  input.declare(line);
  line.flag(input.settings.y_down, "--y-down",
            "in an SVG: typed and printed places are the file's own, with y downward");
  line.value(weight.per_area, "--weight-per-area", "W",
             "weight from the area, for each square unit of the coordinates, or such as 15.6/m2");
  line.value(weight.thickness, "--thickness", "T",
             "weight from the area, this thickness and --density");
  line.value(weight.density, "--density", "D",
             "weight of each cubic unit of the coordinates, or such as 7850/m3");
  table.declare(line);
  input.settings.declare(line, OptionGroup::uncertainty);
  input.settings.declare(line, OptionGroup::units);
  robustness.declare(line);
  line.flag(even_out, "--even-out", "move given supports to the nearest places with equal loads");
  line.flag(keep_misfits, "--keep-misfits",
            "leave out supports and holes that do not fit the object, instead of refusing it");
  line.flag(cases, "--cases", "the loads in each case: each condition alone, all, each failure");
  line.value(require, "--require", "\"CONDITION, ...\"",
             "such as \"held, coverage>=0.8, max<=20\"; exit status 3 if one is not kept");
  line.flag(as_json, "--json", "one JSON object instead of a table");
  line.flag(candidates, "--candidates", "also list the candidates, and show them in the picture");
  line.value(svg, "--svg", "OUT", "also write a picture as SVG");
  poses.declare(line);
}

void PlaceOptions::apply_weight(Document& document) const {
  if (weight.typed() && input.settings.typed(Setting::weight))
    throw Failure{bad_input_status, "--weight", "applies without a weight by area"};
  if (const auto wrong = set_weight(document, weight)) throw input.settings.failure({}, *wrong);
}

void PlaceOptions::explain_weight(const Units& units) const {
  const auto doubt = doubtful_unit(weight, units);
  if (!doubt) return;
  Failure said = input.settings.failure({}, *doubt);
  said.status = 0;
  print_failure(said);
}

std::vector<Condition> PlaceOptions::conditions() const {
  if (!require) return {};
  Result<std::vector<Condition>> conditions = read_conditions(*require);
  if (!conditions) throw Failure{bad_input_status, "--require", conditions.error().message};
  return *std::move(conditions);
}

}  // namespace evenlift::native
