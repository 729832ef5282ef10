// The bar of the present tool: the buttons for drawing a polygon, or for transforming it.
#include "actions/actions.h"
#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "tools/drawing.h"
#include "widgets/buttons.h"
#include "widgets/cards.h"
#include "widgets/dropdown.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

float snap_chips_width() {
  return switch_chip_width("Snap to grid") + 6 + switch_chip_width("Snap to axis");
}

template <typename Switch>
void snap_switches(const Ui& ui, Switch one, void (*between)()) {
  Snap snap = ui.state.snap;
  bool changed = false;
  if (one("Snap to grid", snap.grid)) snap.grid = !snap.grid, changed = true;
  between();
  if (one("Snap to axis", snap.axis)) snap.axis = !snap.axis, changed = true;
  if (changed) ui.push(SetSnap{snap});
}

void snap_chips(const Ui& ui) {
  snap_switches(
      ui, [&](const char* label, bool on) { return switch_chip(ui, label, on); },
      [] { ImGui::SameLine(0, 6); });
}

bool word_button(const Ui& ui, const char* label, bool enabled, bool strong = false) {
  const float width = text_size(Face::text, label).x + (ui.layout.wide ? 28 : 20);
  return flat_button(ui, label, label, width, enabled, strong);
}

void run(const Ui& ui, ActionId id) { action(id).run(ui.state, ui.commands); }

void draw_drawing_bar(const Ui& ui) {
  const bool some = !ui.state.drawing.points.empty();
  const bool closes = ui.state.drawing.points.size() >= 3 && !ui.state.drawing.refusal;
  const bool roomy = ui.layout.wide && ui.layout.toolbar.width() >= 560;
  if (word_button(ui, roomy || !ui.layout.wide ? "Close the shape" : "Close", closes, true))
    ui.push(FinishDrawing{});
  ImGui::SameLine(0, 6);
  if (word_button(ui, roomy ? "Take one back" : "Back", some)) ui.push(TakePointBack{});
  ImGui::SameLine(0, 6);
  if (word_button(ui, "Cancel", true)) ui.push(SetTool{Tool::parts});
  if (!ui.layout.wide) return;
  if (roomy && some) ImGui::SameLine(0, 12);
  // The bar is as high before the first vertex, so that it does not come to lie over that.
  if (!some && !roomy) {
    constexpr char hint[] = "Each vertex can be moved as you draw.";
    const ImVec2 at = ImGui::GetCursorScreenPos(), text = text_size(Face::label, hint);
    ImGui::Dummy(ImVec2(text.x, ui.control()));
    draw_text(*ImGui::GetWindowDrawList(), Face::label,
              ImVec2(at.x, at.y + (ui.control() - text.y) / 2), ui.theme.second_text, hint);
  }
  if (!some) return;
  draw_edge_fields(ui, roomy ? 84 : 68, roomy ? 72 : 60);
}

void draw_whole_bar(const Ui& ui) {
  if (word_button(ui, "Done", true, true)) ui.push(SetTool{Tool::parts});
  ImGui::SameLine(0, 6);
  const bool wide = ui.layout.wide;
  if (word_button(ui, wide ? "Turn −15°" : "−15°", true)) run(ui, ActionId::turn_right);
  ImGui::SameLine(0, 6);
  if (word_button(ui, wide ? "Turn 15°" : "15°", true)) run(ui, ActionId::turn_left);
  ImGui::SameLine(0, 6);
  if (word_button(ui, "Larger", true)) run(ui, ActionId::larger);
  ImGui::SameLine(0, 6);
  if (word_button(ui, "Smaller", true)) run(ui, ActionId::smaller);
}

void draw_marking_bar(const Ui& ui) {
  if (word_button(ui, "Done", true, true)) ui.push(SetTool{Tool::parts});
  ImGui::SameLine(0, 6);
  Settings changed = settings(ui.state);
  if (!word_button(ui, ui.layout.wide ? "Remove all marks" : "Remove all", !changed.no_go.empty()))
    return;
  changed.no_go.clear();
  ui.push(SetSettings{changed});
}

void draw_vertex_bar(const Ui& ui) {
  const bool can_remove = ui.state.document.vertices.size() > 3;
  if (word_button(ui, "Remove vertex", can_remove)) run(ui, ActionId::remove_vertex);
  ImGui::SameLine(0, 6);
  if (word_button(ui, "Add one after", true)) run(ui, ActionId::insert_vertex);
}

}  // namespace

void draw_edge_fields(const Ui& ui, float length_width, float angle_width) {
  const Drawing& drawing = ui.state.drawing;
  const Vec2 from = drawing.points.back();
  const Edge edge = edge_between(from, drawing.cursor.value_or(drawing.last_cursor.value_or(from)));
  // Under a finger, and until the pointer moves, nothing says where the next edge leads.
  const bool begun = edge.length > 0;
  const Asked length = typed_field(ui, "edge length", "Length",
                                   drawing.length ? plain(*drawing.length)
                                   : begun        ? length_in_words(ui.state, edge.length)
                                                  : "–",
                                   length_width);
  ImGui::SameLine(0, 8);
  const Asked angle = typed_field(ui, "edge angle", "Angle",
                                  drawing.degrees ? plain(*drawing.degrees) + "°"
                                  : begun         ? fixed(edge.degrees, 1) + "°"
                                                  : "–",
                                  angle_width);
  if (length.moved) ui.push(TypeEdge{length.moved, {}, length.pressed});
  if (angle.moved) ui.push(TypeEdge{{}, angle.moved, angle.pressed});
  // Enter where nothing was typed: it places the edge whose other number was typed, or else does what it does on the drawing.
  const bool entered = (length.pressed && !length.moved) || (angle.pressed && !angle.moved);
  if (entered && (drawing.length || drawing.degrees))
    ui.push(TypeEdge{{}, {}, true});
  else if (entered && action(ActionId::finish).enabled(ui.state))
    run(ui, ActionId::finish);
  if (length.withdrawn || angle.withdrawn) ui.push(WithdrawEdge{});
}

bool has_tool_bar(const AppState& state) {
  if (state.screen.embed) return false;
  const bool held = state.held.kind != Pick::Kind::none;
  const Layout places = layout(state);
  if (!places.wide && state.sheet == Sheet::full) return false;  // the drawing is covered
  // On a small screen it would cover robots while one asks about them.
  const bool asks = state.explanation && (!places.wide || places.low);
  return state.tool != Tool::parts || (state.selected && !held && !asks);
}

bool snaps_in_menu(const Ui& ui) {
  const bool little_room = ui.layout.low || (!ui.layout.wide && ui.state.tool != Tool::draw);
  return little_room && ui.state.tool != Tool::mark && has_tool_bar(ui.state);
}

void draw_snap_choices(const Ui& ui) {
  snap_switches(
      ui, [&](const char* label, bool on) { return choice(ui, label, nullptr, on); }, [] {});
}

void draw_tool_bar(const Ui& ui) {
  const AppState& state = ui.state;
  if (!has_tool_bar(state)) return;
  const Rect& at = ui.layout.toolbar;
  begin_card(ui, "tool bar", {at.left, at.bottom + 8, at.right, at.bottom + 160},
             {.fixed_width = false, .padding = 8});
  if (state.tool == Tool::draw)
    draw_drawing_bar(ui);
  else if (state.tool == Tool::transform)
    draw_whole_bar(ui);
  else if (state.tool == Tool::mark)
    return draw_marking_bar(ui), end_card(ui);
  else
    draw_vertex_bar(ui);
  const double end = static_cast<double>(ImGui::GetItemRectMax().x + snap_chips_width()) + 12 + 8;
  const bool fits = end <= at.right;
  if (fits) ImGui::SameLine(0, 12);
  if (fits || !snaps_in_menu(ui))
    snap_chips(ui);  // in a row of their own if there is height for it
  end_card(ui);
}

}  // namespace evenlift::view
