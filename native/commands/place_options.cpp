#include "commands/commands.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon_with_holes.h"

namespace evenlift::native {
namespace {

// A number above 0, perhaps followed by the unit of area or volume to which it refers, such as "15.6/m2"
// or "7850/m3": returns the number for that of the document's unit of length.
double per_unit(const std::string& option, const std::string& text, LengthUnit unit, int power) {
  const std::size_t slash = text.find('/');
  const std::optional<double> value = read_number(text.substr(0, slash));
  const std::string digit = std::to_string(power),
                    given = slash == std::string::npos ? std::string() : text.substr(slash + 1);
  const std::string rule = "must be a number above 0, perhaps with its unit, such as " +
                           std::string(power == 2 ? "15.6/m2" : "7850/m3");
  if (!value || !(*value > 0)) throw bad_value(option, rule, text);
  if (given.empty()) {
    if (slash != std::string::npos) throw bad_value(option, rule, text);
    return *value;
  }
  for (const LengthUnit of : {LengthUnit::m, LengthUnit::cm, LengthUnit::mm, LengthUnit::in}) {
    if (given != std::string(name(of)) + digit) continue;
    if (unit == LengthUnit::none)
      throw Failure{bad_input_status, option, "needs the unit of the coordinates: --unit U"};
    const double scale = in_metres(1, unit) / in_metres(1, of);
    return *value * (power == 2 ? scale * scale : scale * scale * scale);
  }
  throw bad_value(option, rule, text);
}

}  // namespace

void WeightByArea::declare(CommandLine& line) {
  line.value(per_area, "--weight-per-area", "W",
             "weight from the area, for each square unit of the coordinates, or such as 15.6/m2");
  line.value(thickness, "--thickness", "T", "weight from the area, this thickness and --density");
  line.value(density, "--density", "D",
             "weight of each cubic unit of the coordinates, or such as 7850/m3");
}

void WeightByArea::apply(Document& document) const {
  if (!typed()) return;
  if (per_area && (thickness || density))
    throw Failure{bad_input_status, "--weight-per-area",
                  "applies without --thickness and --density"};
  if (!per_area && !(thickness && density))
    throw Failure{bad_input_status, thickness ? "--thickness" : "--density",
                  thickness ? "needs --density" : "needs --thickness"};
  const LengthUnit unit = document.shown.units.length;
  double weight = 0;
  if (per_area) {
    weight = per_unit("--weight-per-area", *per_area, unit, 2);
  } else {
    const std::optional<double> thick = read_number(*thickness);
    if (!thick || !(*thick > 0))
      throw bad_value("--thickness", "must be a length above 0", *thickness);
    weight = *thick * per_unit("--density", *density, unit, 3);
  }
  const Result<PolygonWithHoles> object = object_of(document);
  if (!object) return;
  document.settings.weight = weight * object->area();
  if (!is_in_range(Setting::weight, document.settings.weight))
    throw Failure{bad_input_status, per_area ? "--weight-per-area" : "--density",
                  "makes a weight of " + shortest(document.settings.weight) +
                      "; it must be from 1e-100 to 1e100"};
}

void TableOptions::declare(CommandLine& line) {
  line.value(csv, "--csv", "OUT", "with --shape all: also write the rows as CSV");
  line.value(
      sort, "--sort", "COLUMN",
      "with --shape all: order of the rows: file (default), number, name, area, weight or load");
  line.value(jobs, "--jobs", "J", "with --shape all: threads (default all processors)");
}

void PlaceOptions::declare(CommandLine& line) {
  input.declare(line);
  weight.declare(line);
  table.declare(line);
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
