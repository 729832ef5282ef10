#include "evenlift/numbers.h"
#include "evenlift/parts.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

constexpr char per_area_name[] = "weight_per_area";

// A text such as "15.6/m2" or "7850 kg/m³" in its parts.
struct PerUnit {
  std::string_view number, of;
  bool has_unit;
};

PerUnit split(std::string_view text, WeightUnit weights) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return {text, {}, false};
  std::string_view number = text.substr(0, slash);
  if (number.ends_with(name(weights))) number.remove_suffix(name(weights).size());
  while (number.ends_with(' ')) number.remove_suffix(1);
  return {number, text.substr(slash + 1), true};
}

InputError bad_text(const char* name, const char* rule, const std::string& text) {
  constexpr std::size_t most_quoted = 200;
  const bool quotes = text.size() <= most_quoted;
  return bad_setting(name, quotes ? say("{rule}, not \"{text}\"", {rule, text}) : rule);
}

// A number above 0, perhaps followed by the unit of area or volume to which it refers: returns the
// number for that of the document's unit of length.
Result<double> per_unit(const char* name_of_it, const std::string& text, const Units& units,
                        int power) {
  const PerUnit given = split(text, units.weight);
  const std::optional<double> value = read_number(given.number);
  const char* const rule =
      power == 2
          ? "the weight by area must be a number above 0, perhaps with its unit, such as 15.6/m2"
          : "the density must be a number above 0, perhaps with its unit, such as 7850/m3";
  if (!value || !(*value > 0)) return bad_text(name_of_it, rule, text);
  if (!given.has_unit) return *value;
  for (const LengthUnit of : {LengthUnit::m, LengthUnit::cm, LengthUnit::mm, LengthUnit::in}) {
    const std::string unit(name(of));
    if (given.of != unit + (power == 2 ? "2" : "3") && given.of != unit + (power == 2 ? "²" : "³"))
      continue;
    if (units.length == LengthUnit::none)
      return bad_setting(name_of_it,
                         "this has a unit, but the coordinates have none; give theirs as well");
    const double scale = in_metres(1, units.length) / in_metres(1, of);
    return *value * (power == 2 ? scale * scale : scale * scale * scale);
  }
  return bad_text(name_of_it, rule, text);
}

Result<double> for_each_square_unit(const WeightByArea& weight, const Units& units) {
  if (weight.per_area && (weight.thickness || weight.density))
    return bad_setting(per_area_name,
                       "the weight by area applies without a thickness and a density");
  if (weight.per_area) return per_unit(per_area_name, *weight.per_area, units, 2);
  if (!weight.density) return bad_setting("thickness", "the thickness needs a density as well");
  if (!weight.thickness) return bad_setting("density", "the density needs a thickness as well");
  const std::optional<double> thick = read_number(*weight.thickness);
  if (!thick || !(*thick > 0))
    return bad_text("thickness", "the thickness must be a number above 0", *weight.thickness);
  const Result<double> density = per_unit("density", *weight.density, units, 3);
  if (!density) return density.error();
  return *thick * *density;
}

}  // namespace

std::optional<InputError> set_weight(Document& document, const WeightByArea& weight) {
  if (!weight.typed()) return std::nullopt;
  const Result<double> each = for_each_square_unit(weight, document.shown.units);
  if (!each) return each.error();
  const Result<PolygonWithHoles> object = object_of(document);
  if (!object) return std::nullopt;
  document.settings.weight = *each * object->area();
  if (is_in_range(Setting::weight, document.settings.weight)) return std::nullopt;
  return bad_setting(weight.per_area ? per_area_name : "density",
                     say("this makes a weight of {weight}; it must be from 1e-100 to 1e100",
                         {as_read(shortest(document.settings.weight))}));
}

std::optional<InputError> doubtful_unit(const WeightByArea& weight, const Units& units) {
  const std::optional<std::string>& text = weight.per_area ? weight.per_area : weight.density;
  if (!text || split(*text, units.weight).has_unit || units.length == LengthUnit::none ||
      units.length == LengthUnit::m)
    return std::nullopt;
  const std::string power = weight.per_area ? "2" : "3", mine(name(units.length));
  return bad_setting(weight.per_area ? per_area_name : "density",
                     say("this was read as {mine}, in the unit of the coordinates; {metres} is "
                         "another weight",
                         {*text + "/" + mine + power, *text + "/m" + power}));
}

}  // namespace evenlift
