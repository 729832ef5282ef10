// The drawers of the panel: sections of settings, each closed until it is pressed. One table
// (drawers.cpp) says which setting stands in which drawer, and how it is shown; so a new setting is a
// row of it.
#pragma once

#include <optional>
#include <string>

#include "evenlift/settings.h"
#include "ui/ui.h"

namespace evenlift::view {

struct DrawerRow {
  Drawer drawer;
  std::optional<Setting> setting;  // nothing for a row that is no setting
  const char *label = "", *about = "";
  void (*draw)(const Ui&, const DrawerRow&);
  // What the drawer's line says of the row, such as "Slope 8 %"; empty if all is as usual. Null if the
  // row has nothing to say.
  std::string (*told)(const AppState&, const DrawerRow&) = nullptr;
  bool (*offered)(const AppState&) = nullptr;  // null: always
  const char* spoken = nullptr;                // its name for screen readers, if not the label
  // Of a number: as text, and as text for typing.
  std::string (*text)(const AppState&, double) = nullptr;
  std::string (*exact)(double) = nullptr;
  double step = 0;  // of draw_ratio()
  // Of draw_length(), for a setting with a default: its member, and the name of the button that
  // restores the default.
  std::optional<double> Settings::*member = nullptr;
  const char* usual = nullptr;
  // Of draw_optional(): the text shown without a value, and the button that removes the value.
  const char *without = nullptr, *unset_id = nullptr, *unset = nullptr;
};

// --- The kinds of rows.

void draw_length(const Ui& ui, const DrawerRow& row);    // a length that steps up and down
void draw_ratio(const Ui& ui, const DrawerRow& row);     // a number with a fixed step
void draw_optional(const Ui& ui, const DrawerRow& row);  // a number that may be absent
void draw_text(const Ui& ui, const DrawerRow& row);      // a typed text

// What differs from the default: "Slope 8 %".
std::string told_setting(const AppState& state, const DrawerRow& row);

// The name of a setting's control for scripts, such as "robot radius".
std::string id_of(Setting setting);

// size_of_object() returns the diagonal of the polygon's bounding box, or 100 before the first
// placement. first_length() returns the length to which a step up from 0 leads: a power of ten,
// from 1/500 to 1/50 of the size.
double size_of_object(const AppState& state);
double first_length(double size_of_object);

// Numbers as these rows show them.
std::string length_text(const AppState& state, double value);
std::string weight_text(const AppState& state, double value);

// A text in a constant number of lines, so that nothing below moves.
void draw_remark(const Ui& ui, const std::string& text, std::size_t lines);

// --- The rows that are not of these kinds (drawer_object.cpp, drawer_robots.cpp, drawer_show.cpp).

void draw_centre(const Ui& ui, const DrawerRow& row);
std::string told_centre(const AppState& state, const DrawerRow& row);
void draw_uncertainty_words(const Ui& ui, const DrawerRow& row);
void draw_units(const Ui& ui, const DrawerRow& row);
std::string told_units(const AppState& state, const DrawerRow& row);
void draw_cargo(const Ui& ui, const DrawerRow& row);
std::string told_cargo(const AppState& state, const DrawerRow& row);
void draw_holes(const Ui& ui, const DrawerRow& row);
std::string told_holes(const AppState& state, const DrawerRow& row);

void draw_capacity(const Ui& ui, const DrawerRow& row);
void draw_min_ratio(const Ui& ui, const DrawerRow& row);
std::string told_min_ratio(const AppState& state, const DrawerRow& row);
void draw_goal(const Ui& ui, const DrawerRow& row);
std::string told_goal(const AppState& state, const DrawerRow& row);
void draw_seed(const Ui& ui, const DrawerRow& row);
void draw_radius(const Ui& ui, const DrawerRow& row);
void draw_no_go(const Ui& ui, const DrawerRow& row);
std::string told_no_go(const AppState& state, const DrawerRow& row);
void draw_left_of_boundary(const Ui& ui, const DrawerRow& row);
void draw_sizes_kept(const Ui& ui, const DrawerRow& row);
std::string told_sizes_kept(const AppState& state, const DrawerRow& row);
void draw_positions(const Ui& ui, const DrawerRow& row);
std::string told_positions(const AppState& state, const DrawerRow& row);
void draw_survive(const Ui& ui, const DrawerRow& row);

void draw_carrying_words(const Ui& ui, const DrawerRow& row);

void draw_overlays(const Ui& ui, const DrawerRow& row);
std::string told_overlays(const AppState& state, const DrawerRow& row);
void draw_model(const Ui& ui, const DrawerRow& row);
std::string told_model(const AppState& state, const DrawerRow& row);
void draw_compare(const Ui& ui, const DrawerRow& row);
std::string told_compare(const AppState& state, const DrawerRow& row);

}  // namespace evenlift::view
