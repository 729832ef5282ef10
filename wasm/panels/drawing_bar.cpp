// The bar of the present tool or the selected vertex.
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

constexpr float gap = 6;  // between buttons

float snap_chips_width() {
  return switch_chip_width("Snap to grid") + gap + switch_chip_width("Snap to axis");
}

template <typename Switch>
void snap_switches(const Ui& ui, Switch one, void (*between)()) {
  Snap snap = ui.state.view.snap;
  bool changed = false;
  if (one("Snap to grid", snap.grid)) snap.grid = !snap.grid, changed = true;
  between();
  if (one("Snap to axis", snap.axis)) snap.axis = !snap.axis, changed = true;
  if (changed) ui.push(SetSnap{snap});
}

void snap_chips(const Ui& ui) {
  snap_switches(
      ui, [&](const char* label, bool on) { return switch_chip(ui, label, on); },
      [] { ImGui::SameLine(0, gap); });
}

float word_button_width(const Ui& ui, const char* label) {
  const bool ample = ui.layout.wide && ui.layout.toolbar.width() >= 300;
  return text_size(Face::text, label).x + (ample ? 28 : 20);
}

bool word_button(const Ui& ui, const char* label, bool enabled, bool strong = false) {
  return flat_button(ui, label, label, word_button_width(ui, label), enabled, strong);
}

float row_width(const Ui& ui, std::initializer_list<const char*> labels) {
  float width = -gap;
  for (const char* label : labels) width += gap + word_button_width(ui, label);
  return width;
}

// The width for a bar below the toolbar, without the bar's margins.
float room_of_bar(const Ui& ui) {
  return static_cast<float>(std::min(ui.layout.toolbar.right, ui.layout.free.right) -
                            ui.layout.toolbar.left) -
         16;
}

// The fields of the next edge; width_of() includes their names.
struct FieldWidths {
  float length, angle;
};
constexpr FieldWidths roomy_fields{84, 72}, small_fields{68, 60};
float width_of(const FieldWidths& fields) {
  return text_size(Face::label, "Length").x + 6 + fields.length + 8 +
         text_size(Face::label, "Angle").x + 6 + fields.angle;
}

// Whether whole names and the fields of the next edge fit in one row.
bool is_roomy(const Ui& ui) {
  return ui.layout.wide && row_width(ui, {"Close the shape", "Remove last", "Cancel"}) + 12 +
                                   width_of(roomy_fields) <=
                               room_of_bar(ui);
}

void run(const Ui& ui, ActionId id) { action(id).run(ui.state, ui.commands); }

// Holes and weights need an object that is not refused.
constexpr std::pair<const char*, Tool> drawn[] = {
    {"Shape", Tool::draw}, {"Hole", Tool::hole}, {"Cargo", Tool::weight}};

bool can_choose_drawn(const Ui& ui) {
  return ui.state.derived().placement && !ui.state.derived().refusal;
}

float choice_width(const Ui& ui) {
  return can_choose_drawn(ui) ? row_width(ui, {drawn[0].first, drawn[1].first, drawn[2].first}) : 0;
}

// In the present row; another item must follow.
void choose_drawn(const Ui& ui) {
  for (const auto& [label, tool] : drawn) {
    if (toggle_button(ui, label, label, label, word_button_width(ui, label),
                      ui.state.view.tool == tool))
      ui.push(SetTool{tool});
    ImGui::SameLine(0, gap);
  }
}

void draw_weight_field(const Ui& ui) {
  const std::optional<Handle> handle =
      ui.state.view.selected ? handle_of(ui.state.work.document(), *ui.state.view.selected)
                             : std::nullopt;
  if (!handle || !handle->is_weight) return;
  Cargo item = settings(ui.state).cargo[handle->index];
  const Asked typed = typed_field(ui, {"cargo weight", "Weight"},
                                  with_weight_unit(plain(item.weight), shown(ui.state).units), 96);
  if (!typed.moved) return;
  item.weight = *typed.moved;
  ui.push(SetCargo{handle->index, item});
}

void draw_weight_bar(const Ui& ui) {
  if (can_choose_drawn(ui)) choose_drawn(ui);
  if (word_button(ui, "Done", true)) ui.push(SetTool{Tool::parts});
  if (!ui.state.view.selected) return;
  if (word_button(ui, "Remove weight", true)) ui.push(RemoveVertex{*ui.state.view.selected});
  ImGui::SameLine(0, 12);
  draw_weight_field(ui);
}

void draw_drawing_bar(const Ui& ui) {
  const bool hole = ui.state.view.tool == Tool::hole;
  const bool some = !ui.state.view.drawing.points.empty();
  if (!ui.layout.wide && !some && can_choose_drawn(ui)) {
    // In place of buttons that need vertices.
    choose_drawn(ui);
    if (word_button(ui, "Cancel", true)) ui.push(SetTool{Tool::parts});
    return;
  }
  const bool closes = ui.state.view.drawing.points.size() >= 3 && !ui.state.view.drawing.refusal;
  const bool roomy = is_roomy(ui);
  if (word_button(ui,
                  hole                       ? "Close the hole"
                  : roomy || !ui.layout.wide ? "Close the shape"
                                             : "Close",
                  closes, true))
    ui.push(FinishDrawing{});
  ImGui::SameLine(0, gap);
  if (word_button(ui, roomy ? "Remove last" : "Back", some)) ui.push(TakePointBack{});
  ImGui::SameLine(0, gap);
  if (word_button(ui, "Cancel", true)) ui.push(SetTool{Tool::parts});
  if (!ui.layout.wide) return;
  if (roomy) ImGui::SameLine(0, 12);
  const FieldWidths fields = roomy ? roomy_fields : small_fields;
  if (some) return draw_edge_fields(ui, fields.length, fields.angle);
  // The bar has its full size at once, so that it will not cover the first vertex.
  constexpr char hint[] = "Placed vertices can be dragged.";
  const ImVec2 at = ImGui::GetCursorScreenPos(), text = text_size(Face::label, hint);
  ImGui::Dummy(ImVec2(std::max(text.x, width_of(fields)), ui.control()));
  draw_text(*ImGui::GetWindowDrawList(), Face::label,
            ImVec2(at.x, at.y + (ui.control() - text.y) / 2), ui.theme.second_text, hint);
}

// The longest names of the buttons that turn and scale for which there is room.
struct WholeNames {
  const char *right, *left, *larger, *smaller;
};
WholeNames whole_names(const Ui& ui) {
  constexpr WholeNames longest{"Turn −15°", "Turn 15°", "Larger", "Smaller"},
      shorter{"−15°", "15°", "Larger", "Smaller"}, shortest{"−15°", "15°", "+", "−"};
  for (const WholeNames& names : {longest, shorter})
    if (row_width(ui, {"Done", names.right, names.left, names.larger, names.smaller}) <=
        room_of_bar(ui))
      return names;
  return shortest;
}

void draw_whole_bar(const Ui& ui) {
  if (word_button(ui, "Done", true, true)) ui.push(SetTool{Tool::parts});
  const WholeNames names = whole_names(ui);
  const auto button = [&](const char* name, const char* label, ActionId id) {
    ImGui::SameLine(0, gap);
    const float width = std::max(word_button_width(ui, label), ui.control());
    if (flat_button(ui, name, label, width, true, false, name)) run(ui, id);
  };
  button("Turn −15°", names.right, ActionId::turn_right);
  button("Turn 15°", names.left, ActionId::turn_left);
  button("Larger", names.larger, ActionId::larger);
  button("Smaller", names.smaller, ActionId::smaller);
}

void draw_robot_bar(const Ui& ui) {
  if (word_button(ui, "Done", true, true)) ui.push(SetTool{Tool::parts});
  if (settings(ui.state).method != Method::given) return;
  ImGui::SameLine(0, gap);
  if (word_button(ui, "Even out", true)) ui.push(EvenOut{});
}

void draw_marking_bar(const Ui& ui) {
  if (word_button(ui, "Done", true, true)) ui.push(SetTool{Tool::parts});
  ImGui::SameLine(0, gap);
  Settings changed = settings(ui.state);
  if (!word_button(ui, ui.layout.wide ? "Remove all marks" : "Remove all", !changed.no_go.empty()))
    return;
  changed.no_go.clear();
  ui.push(SetSettings{changed});
}

}  // namespace

void draw_edge_fields(const Ui& ui, float length_width, float angle_width) {
  const Drawing& drawing = ui.state.view.drawing;
  const Vec2 from = drawing.points.back();
  const Edge edge = edge_between(from, drawing.cursor.value_or(drawing.last_cursor.value_or(from)));
  // Under a finger, and until the pointer moves, the next edge has no direction.
  const bool begun = edge.length > 0;
  const Asked length = typed_field(ui, {"edge length", "Length", true},
                                   drawing.length ? plain(*drawing.length)
                                   : begun        ? length_in_words(ui.state, edge.length)
                                                  : "–",
                                   length_width);
  ImGui::SameLine(0, 8);
  const Asked angle = typed_field(ui, {"edge angle", "Angle"},
                                  drawing.degrees ? plain(*drawing.degrees) + "°"
                                  : begun         ? fixed(edge.degrees, 1) + "°"
                                                  : "–",
                                  angle_width);
  if (length.moved) ui.push(TypeEdge{length.moved, {}, length.pressed});
  if (angle.moved) ui.push(TypeEdge{{}, angle.moved, angle.pressed});
  // Enter without a new number places the edge if one was typed before; otherwise it acts as on the
  // drawing.
  const bool entered = (length.pressed && !length.moved) || (angle.pressed && !angle.moved);
  if (entered && (drawing.length || drawing.degrees))
    ui.push(TypeEdge{{}, {}, true});
  else if (entered && action(ActionId::finish).enabled(ui.state))
    run(ui, ActionId::finish);
  if (length.withdrawn || angle.withdrawn) ui.push(WithdrawEdge{});
}

bool vertex_is_on_sheet(const Ui& ui) {
  const AppState& state = ui.state;
  return state.view.tool == Tool::parts && state.view.selected && !ui.layout.wide &&
         state.view.sheet == Sheet::closed;
}

namespace {

// On a low screen the vertex's buttons would cover robots, so they are at the foot of the panel.
bool vertex_is_over_panel(const Ui& ui) {
  const AppState& state = ui.state;
  const Layout& places = ui.layout;
  return state.view.tool == Tool::parts && state.view.selected && places.wide && places.low &&
         state.view.panel_open;
}

}  // namespace

void draw_vertex_buttons(const Ui& ui) {
  const std::optional<Handle> handle =
      handle_of(ui.state.work.document(), ui.state.view.selected.value_or(0));
  const bool weight = handle && handle->is_weight;
  const char *remove = weight ? "Remove weight" : "Remove vertex", *add = "Add one after";
  const bool of_outline = handle && !weight && handle->ring == 0;
  const bool can_remove = !of_outline || ui.state.work.document().vertices.size() > 3;
  const bool fills_row = vertex_is_on_sheet(ui) || vertex_is_over_panel(ui);
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const auto width = [&](const char* label) {
    return fills_row ? half : word_button_width(ui, label);
  };
  if (flat_button(ui, remove, remove, width(remove), can_remove)) run(ui, ActionId::remove_vertex);
  ImGui::SameLine(0, gap);
  if (weight) return draw_weight_field(ui);
  if (flat_button(ui, add, add, width(add))) run(ui, ActionId::insert_vertex);
}

bool has_tool_bar(const Ui& ui) {
  const AppState& state = ui.state;
  const Layout& places = ui.layout;
  if (state.session.screen.embed) return false;
  if (!places.wide && state.view.sheet == Sheet::full) return false;  // the drawing is covered
  if (state.view.tool != Tool::parts) return true;
  const bool held = state.view.held.kind != Pick::Kind::none;
  // On a low screen the bar would cover the robots that the card explains.
  return state.view.selected && !held && !vertex_is_on_sheet(ui) &&
         !(state.derived().explanation && places.low);
}

bool snaps_in_menu(const Ui& ui) {
  const bool little_room = ui.layout.low || (!ui.layout.wide && !draws(ui.state.view.tool));
  return little_room && ui.state.view.tool != Tool::mark && !adds_by_click(ui.state.view.tool) &&
         (has_tool_bar(ui) || vertex_is_on_sheet(ui));
}

void draw_snap_choices(const Ui& ui) {
  snap_switches(
      ui, [&](const char* label, bool on) { return choice(ui, label, nullptr, on); }, [] {});
}

void draw_tool_bar(const Ui& ui) {
  const AppState& state = ui.state;
  // From the next frame on, everything beneath the panels avoids the bar.
  const bool shown = has_tool_bar(ui);
  if ((in_last_frame("has tool bar", shown, shown) != 0) != shown) ui.push(LayOutAgain{});
  if (!shown) return;
  const Rect &at = ui.layout.toolbar, &panel = ui.layout.panel;
  const bool over_panel = vertex_is_over_panel(ui);
  const Rect foot{panel.left, panel.bottom - ui.layout.control - 16, panel.right, panel.bottom},
      below_toolbar{at.left, at.bottom + 8, at.right, at.bottom + 160};
  begin_card(ui, "tool bar", over_panel ? foot : below_toolbar,
             {.fixed_width = over_panel, .padding = 8});
  if (draws(state.view.tool))
    draw_drawing_bar(ui);
  else if (state.view.tool == Tool::transform)
    draw_whole_bar(ui);
  else if (state.view.tool == Tool::mark)
    return draw_marking_bar(ui), end_card(ui);
  else if (state.view.tool == Tool::robot)
    return draw_robot_bar(ui), end_card(ui);
  else if (state.view.tool == Tool::weight)
    return draw_weight_bar(ui), end_card(ui);
  else
    draw_vertex_buttons(ui);
  const bool chooses = draws(state.view.tool) && ui.layout.wide && can_choose_drawn(ui);
  const float chips = snap_chips_width() + (chooses ? choice_width(ui) + 2 * gap : 0);
  const double end = static_cast<double>(ImGui::GetItemRectMax().x + chips) + 12 + 8;
  const bool fits = end <= at.right && !over_panel, snaps = fits || !snaps_in_menu(ui);
  // Otherwise they have their own row, if there is height for it.
  if (fits) ImGui::SameLine(0, 12);
  if (chooses) choose_drawn(ui);
  if (chooses && snaps) ImGui::SameLine(0, gap);
  if (snaps) snap_chips(ui);
  end_card(ui);
}

}  // namespace evenlift::view
