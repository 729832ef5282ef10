// The panels, and what their rows share.
#pragma once

#include <string>

#include "actions/actions.h"
#include "evenlift/settings.h"
#include "ui/ui.h"

namespace evenlift::view {

// --- Shows an action (actions.h) as a button or as a row of an open list. A button shows the icon of
// the action and, on hovering, its name and key.

void action_button(const Ui& ui, ActionId id, float size);

// A button with the name beside the icon. The action must be enabled.
void named_action_button(const Ui& ui, ActionId id, float size);

// A row with the name, and with the key if there may be a keyboard.
void action_row(const Ui& ui, ActionId id);

// The value after a step up or down that suits its size: 120 changes by tens, 12 by ones.
double stepped(double value, int by);

// --- The panels, in one table.

// A part of the side panel or sheet.
struct Panel {
  const char* name;
  void (*draw)(const Ui&);
  bool of_result;                            // whether it shows the last good placement
  bool (*shown)(const AppState&) = nullptr;  // whether it is shown; null: always
};

void draw_panels(const AppState& state, const Layout& places, Commands& commands);

// The sections, each in its own file.
void draw_verdict(const Ui& ui);        // its words, the offer, and what remains if a robot fails
void draw_headline(const Ui& ui);       // its first sentence
void draw_verdict_words(const Ui& ui);  // three lines, or all of them after a press, and the offer
void draw_verdict_details(const Ui& ui);  // its other sentences, and what remains if a robot fails
// In an <iframe> without a lesson: the result, and the link to the page.
void draw_embedded_verdict(const Ui& ui);
void draw_failures(const Ui& ui);  // below the verdict, of constant height
void draw_controls(const Ui& ui);  // method, number of robots, weight
void draw_teams_stepper(const Ui& ui);
void draw_drawers(const Ui& ui);
void draw_weighing(const Ui& ui);    // what readings tell
void draw_score(const Ui& ui);       // of robots placed by hand
void draw_comparison(const Ui& ui);  // with a second method
// Draws the heat map's colours, with the forces at their borders.
void draw_heat_key(const Ui& ui);
void draw_teams(const Ui& ui);
void draw_numbers(const Ui& ui);

// The sections of the walkthrough.
void draw_walkthrough_step(const Ui& ui);
void draw_walkthrough_briefly(const Ui& ui, float height);
void draw_walkthrough_ranking(const Ui& ui);
void draw_walkthrough_code(const Ui& ui);
void draw_walkthrough_history(const Ui& ui);
void draw_player(const Ui& ui);
void draw_player_row(const Ui& ui);

// The floating cards.
void draw_toolbar(const Ui& ui);
void draw_tool_bar(const Ui& ui);
// snaps_in_menu() returns whether the menu of the toolbar has the snap choices, because they do not
// fit in the tool's bar. draw_snap_choices() draws their rows in the menu.
bool snaps_in_menu(const Ui& ui);
void draw_snap_choices(const Ui& ui);
// The fields for the next edge, while at least one vertex is drawn.
void draw_edge_fields(const Ui& ui, float length_width, float angle_width);
// draw_vertex_buttons() draws the buttons for the selected vertex. vertex_is_on_sheet() returns
// whether these are on the closed sheet of a narrow screen instead of in a bar over the drawing.
void draw_vertex_buttons(const Ui& ui);
bool vertex_is_on_sheet(const Ui& ui);
void draw_view_tools(const Ui& ui);
void draw_way_back(const Ui& ui);
void draw_notice(const Ui& ui);
void draw_why_card(const Ui& ui);

}  // namespace evenlift::view
