// The rows about the object and the conditions under which it is carried.
#include "actions/actions.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/drawers.h"
#include "panels/panels.h"
#include "panels/summary.h"
#include "tools/pick.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

std::string centre_in_words(const AppState& state) {
  return point_in_words(centre_of_mass(state), coordinate_decimals(state.work.document().vertices));
}

bool has_own_centre(const AppState& state) {
  return state.work.document().centre_of_mass.has_value();
}

// The button that begins a tool, or ends it.
void draw_tool_button(const Ui& ui, const DrawerRow& row, Tool tool, const char* begin) {
  const float width = labelled(ui, row.label, row.about);
  const bool on = ui.state.view.tool == tool;
  if (!flat_button(ui, begin, on ? "Done" : begin, width)) return;
  ui.push(SetTool{on ? Tool::parts : tool});
  if (!ui.layout.wide) ui.push(SetSheet{Sheet::closed});  // it covers the drawing
}

constexpr Choice length_units[] = {{"no unit"}, {"m"}, {"cm"}, {"mm"}, {"in"}};
constexpr Choice weight_units[] = {{"kg"}, {"t"}, {"N"}, {"lb"}};
static_assert(std::size(length_units) == std::size(all_length_units));
static_assert(std::size(weight_units) == std::size(all_weight_units));

}  // namespace

void draw_centre(const Ui& ui, const DrawerRow& row) {
  const float width = labelled(ui, row.label, row.about);
  const bool own = has_own_centre(ui.state), known = own || when::is_weighed(ui.state);
  const float reset = own ? ui.control() : 0;
  const Vec2 centre = centre_of_mass(ui.state);
  text_field(ui, "com", "Centre of mass, x and y", "com",
             known ? centre_in_words(ui.state) : "centroid", width - reset,
             known ? shortest(centre.x) + ", " + shortest(centre.y) : "");
  if (!own) return;
  ImGui::SameLine(0, 0);
  if (icon_button(ui, "centroid", Icon::close, true, "Back to the centroid", ui.control()))
    ui.push(ReleaseCentre{});
}

std::string told_centre(const AppState& state, const DrawerRow&) {
  return has_own_centre(state) || when::is_weighed(state)
             ? say("C at {place}", {centre_in_words(state)})
             : std::string();
}

void draw_uncertainty_words(const Ui& ui, const DrawerRow&) {
  if (disturbance_of(shown(ui.state)).any()) draw_remark(ui, uncertainty_words(ui.state), 5);
}

void draw_units(const Ui& ui, const DrawerRow& row) {
  Units units = shown(ui.state).units;
  const float width = labelled(ui, row.label, row.about), each = (width - 8) / 2;
  const auto length = dropdown(ui, "length units", "Unit of lengths", length_units,
                               static_cast<std::size_t>(units.length), each);
  ImGui::SameLine(0, 8);
  const auto weight = dropdown(ui, "weight units", "Unit of weights", weight_units,
                               static_cast<std::size_t>(units.weight), each);
  if (length) units.length = static_cast<LengthUnit>(*length);
  if (weight) units.weight = static_cast<WeightUnit>(*weight);
  if (units != shown(ui.state).units) ui.push(showing(ui.state, &Shown::units, units));
}

std::string told_units(const AppState& state, const DrawerRow&) {
  const Units& units = shown(state).units;
  if (units == Units{}) return {};
  const char* weight = weight_units[static_cast<std::size_t>(units.weight)].label;
  if (units.length == LengthUnit::none) return weight;
  return say("{length}, {weight}",
             {length_units[static_cast<std::size_t>(units.length)].label, weight});
}

void draw_cargo(const Ui& ui, const DrawerRow& row) {
  draw_tool_button(ui, row, Tool::weight, "Add cargo");
}

std::string told_cargo(const AppState& state, const DrawerRow&) {
  const std::vector<Cargo>& cargo = settings(state).cargo;
  double all = 0;
  for (const Cargo& item : cargo) all += item.weight;
  return cargo.empty() ? std::string() : say("cargo {weight}", {weight_text(state, all)});
}

void draw_holes(const Ui& ui, const DrawerRow& row) {
  draw_tool_button(ui, row, Tool::hole, "Add a hole");
}

std::string told_holes(const AppState& state, const DrawerRow&) {
  const std::size_t holes = state.work.document().holes.size();
  return holes == 0 ? std::string() : count_of(holes, "hole", "holes");
}

// --- Carrying

namespace {

// Shows or hides an overlay that explains these numbers.
void draw_show(const Ui& ui, bool Overlays::*overlay, ActionId toggle, const char* show,
               const char* hide) {
  const bool on = shown(ui.state).overlays.*overlay;
  if (flat_button(ui, show, on ? hide : show, ImGui::GetContentRegionAvail().x))
    action(toggle).run(ui.state, ui.commands);
}

}  // namespace

void draw_carrying_words(const Ui& ui, const DrawerRow&) {
  const Carrying& now = shown(ui.state).carrying;
  if (flat_button(ui, "cases", "All cases …", ImGui::GetContentRegionAvail().x))
    ui.push(OpenDialog{Dialog::cases});
  if (ImGui::IsItemHovered())
    tip(ui, "The loads in each case: each condition alone, all of them, and each failure");
  const std::string words = carrying_words(ui.state);
  if (!words.empty()) text_block(Face::label, ui.theme.second_text, words);
  if (now.has_height())
    draw_show(ui, &Overlays::tilt, ActionId::toggle_tilt, "Show the slopes", "Hide the slopes");
  if (now.extra)
    draw_show(ui, &Overlays::load, ActionId::toggle_load, "Show where it may stand",
              "Hide where it may stand");
}

}  // namespace evenlift::view
