// Sends messages: to the browser, to users who cannot see the canvas, and in a notice over the
// drawing.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
