// Messages, the size of the screen, and what the camera shows.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// --- Sends messages: to the browser, to users who cannot see the canvas, and in a notice over the
// drawing.

// Appends an effect, which the page carries out after the present commands.
void emit(AppState& state, Effect effect);
// Announces a text to users who cannot see the canvas.
void announce(AppState& state, std::string text);

// Shows a notice, which screen readers also read. A notice without text removes the last one. A
// problem stays until it is closed or replaced; other notices end by themselves, since a notice
// covers part of the drawing.
void show(AppState& state, Notice notice);
// Ends the notice, unless it reports a problem.
void end_notice(AppState& state);

// --- Sets the size of the screen, and the scale of everything on it.

// Sets the canvas's size in CSS pixels, and the number of device pixels per CSS pixel.
void set_canvas(AppState& state, double css_width, double css_height, double css_ratio);

// Scales everything for presentation mode, which enlarges a walkthrough more than the page with its
// settings. Call this when the mode may have changed, or a walkthrough may have been opened or
// closed. O(1).
void scale_screen(AppState& state);

// Notes how much of the canvas a window of the page covers at each side, in CSS pixels.
void cover_screen(AppState& state, double left, double right, double foot);

// Makes room for a card of this height, in CSS pixels, at the foot of the drawing. A height of 0
// removes the room.
void make_room(AppState& state, double height);

// Begins or ends presentation mode, which enlarges everything in full screen. An open walkthrough
// is shown without the settings.
void set_presenting(AppState& state, bool on);

// --- Tells which part of the polygon the camera shows.

// Returns whether a centre of mass that the user set is on the screen and no panel covers it; true
// if the user did not set it.
bool centre_is_shown(const AppState& state);

// Returns whether all vertices of the outline are on the screen, and no panel covers one.
// O(vertices).
bool vertices_are_shown(const AppState& state);

// Returns whether all vertices of the outline are on the screen, perhaps under a panel, and the
// scale is not much smaller than the fitting camera's. O(vertices).
bool well_shown(const AppState& state);

// Returns the scale as a percentage of the fitting camera's scale (layout.h), for instance "125 %".
// O(vertices).
std::string zoom_in_words(const AppState& state);

// Returns whether the outline crosses the uncovered part of the canvas. O(vertices).
bool outline_is_seen(const AppState& state);

}  // namespace evenlift::view
