// Messages: to the browser, to users who cannot see the canvas, and in a notice over the drawing.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// The page carries it out after the present commands.
void emit(AppState& state, Effect effect);
void announce(AppState& state, std::string text);

// Screen readers also read the notice. Without text, removes the last one. A problem stays until
// closed or replaced; other notices end, since they cover part of the drawing.
void show(AppState& state, Notice notice);
void end_notice(AppState& state);

}  // namespace evenlift::view
