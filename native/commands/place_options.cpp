#include "commands/commands.h"

namespace evenlift::native {

void PlaceOptions::declare(CommandLine& line) {
  input.declare(line);
  input.settings.declare(line, OptionGroup::uncertainty);
  input.settings.declare(line, OptionGroup::units);
  robustness.declare(line);
  line.flag(even_out, "--even-out", "move given supports to the nearest places with equal loads");
  line.value(require, "--require", "\"CONDITION, ...\"",
             "such as \"held, coverage>=0.8, max<=20\"; exit status 3 if one is not kept");
  line.flag(as_json, "--json", "one JSON object instead of a table");
  line.flag(candidates, "--candidates", "also list the candidates, and show them in the picture");
  line.value(svg, "--svg", "OUT", "also write a picture as SVG");
  poses.declare(line);
}

std::vector<Condition> PlaceOptions::conditions() const {
  if (!require) return {};
  Result<std::vector<Condition>> conditions = read_conditions(*require);
  if (!conditions) throw Failure{bad_input_status, "--require", conditions.error().message};
  return *std::move(conditions);
}

}  // namespace evenlift::native
