// What is said: to the browser, to those who cannot see the canvas, and in a notice over the drawing.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// Asks something of the browser, once the commands of now are carried out.
void emit(AppState& state, Effect effect);
void announce(AppState& state, std::string text);

// A notice, which screen readers are told, too. One without a text takes the last one away. What says that something went wrong stays until it is
// closed or another one comes; others end after a while, since they cover a part of the drawing.
void show(AppState& state, Notice notice);
void end_notice(AppState& state);

}  // namespace evenlift::view
