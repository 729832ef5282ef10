#pragma once

#include <string>
#include <utility>

#include "app/app.h"

namespace evenlift::view {

// Returns the text for the caller in JavaScript, and keeps it alive until the next call.
inline const char* hand_over(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

// --- Shared parts of the functions that web/page calls for window.evenlift, the address bar and keys.
// All text is UTF-8; a text that such a function returns stays valid until the next call.

App& app();

// Carries out the pending commands and their requests to the browser. Returns whether there were
// commands.
bool settle();

// Carries out these commands at once, as if they came from a button.
void carry_out(Commands commands);

// Does everything that follows a command. A function that must return a refusal changes the state
// without a command, and then calls carried_out().
void carried_out();

}  // namespace evenlift::view
