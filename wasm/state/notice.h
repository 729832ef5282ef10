// Messages: to the browser, to users who cannot see the canvas, and in a notice over the drawing.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// Requests something of the browser. The page carries it out after the present commands.
void emit(AppState& state, Effect effect);
void announce(AppState& state, std::string text);

// Shows a notice, which screen readers also read. One without text removes the last one. A problem
// stays until it is closed or replaced; other notices end after a while, since they cover part of
// the drawing.
void show(AppState& state, Notice notice);
void end_notice(AppState& state);

}  // namespace evenlift::view
