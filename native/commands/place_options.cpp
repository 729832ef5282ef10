#include "commands/commands.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon_with_holes.h"

namespace evenlift::native {
namespace {

// A text such as "15.6/m2" or "7850 kg/m³" in its parts.
struct PerUnit {
  std::string_view number, of;
  bool has_unit;
};

PerUnit parts_of(std::string_view text, WeightUnit weights) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return {text, {}, false};
  std::string_view number = text.substr(0, slash);
  if (number.ends_with(name(weights))) number.remove_suffix(name(weights).size());
  while (number.ends_with(' ')) number.remove_suffix(1);
  return {number, text.substr(slash + 1), true};
}

// A number above 0, perhaps followed by the unit of area or volume to which it refers: returns the
// number for that of the document's unit of length.
double per_unit(const std::string& option, const std::string& text, const Units& units, int power) {
  const PerUnit given = parts_of(text, units.weight);
  const std::optional<double> value = read_number(given.number);
  const std::string rule = "must be a number above 0, perhaps with its unit, such as " +
                           std::string(power == 2 ? "15.6/m2" : "7850/m3");
  if (!value || !(*value > 0)) throw bad_value(option, rule, text);
  if (!given.has_unit) return *value;
  for (const LengthUnit of : {LengthUnit::m, LengthUnit::cm, LengthUnit::mm, LengthUnit::in}) {
    const std::string unit(name(of));
    if (given.of != unit + (power == 2 ? "2" : "3") && given.of != unit + (power == 2 ? "²" : "³"))
      continue;
    if (units.length == LengthUnit::none)
      throw Failure{bad_input_status, option, "needs the unit of the coordinates: --unit U"};
    const double scale = in_metres(1, units.length) / in_metres(1, of);
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
  const Units& units = document.shown.units;
  double weight = 0;
  if (per_area) {
    weight = per_unit("--weight-per-area", *per_area, units, 2);
  } else {
    const std::optional<double> thick = read_number(*thickness);
    if (!thick || !(*thick > 0))
      throw bad_value("--thickness", "must be a length above 0", *thickness);
    weight = *thick * per_unit("--density", *density, units, 3);
  }
  const Result<PolygonWithHoles> object = object_of(document);
  if (!object) return;
  document.settings.weight = weight * object->area();
  if (!is_in_range(Setting::weight, document.settings.weight))
    throw Failure{bad_input_status, per_area ? "--weight-per-area" : "--density",
                  "makes a weight of " + shortest(document.settings.weight) +
                      "; it must be from 1e-100 to 1e100"};
}

void WeightByArea::explain(const Units& units) const {
  const std::optional<std::string>& text = per_area ? per_area : density;
  if (!text || parts_of(*text, units.weight).has_unit || units.length == LengthUnit::none ||
      units.length == LengthUnit::m)
    return;
  const std::string digit = per_area ? "2" : "3", mine(name(units.length));
  print_failure({0, per_area ? "--weight-per-area" : "--density",
                 "was read as " + *text + "/" + mine + digit +
                     ", in the unit of the coordinates; " + *text + "/m" + digit +
                     " is another weight"});
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
