// Applies commands, and derives their consequences.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"
#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// --- Derives the consequences of commands, or of functions called in place of commands.

// Derives the facts (derive/derive.h). Then updates the open step and the announcement of a
// refusal. If the robots' size changed, the view will fit the window again unless the user has
// panned or zoomed. Call it once after each batch of commands.
void conclude(AppState& state);

// Places the document at once if a worker is still choosing its teams. Call it before a command
// that uses the robots of the present shape.
void place_now(AppState& state);

// --- Settings as text: those that window.evenlift.set() passes, and those that the browser keeps.

// The values that set() can change.
struct Changeable {
  Document document;
  LoadModel load_model = LoadModel::plan;  // of the shown loads
  // The failing robot, from 1, or 0 for none; nullopt leaves it unchanged.
  std::optional<std::uint64_t> failed = {};
};

// Applies lines `name=value` in the syntax of settings.h. Returns an error for the first unreadable
// line, or if check_settings() refuses the result. Makes no checks that need place(). O(bytes).
Result<Changeable> with_settings(Changeable given, std::string_view lines);

// The preferences that the browser keeps apart from the document, as lines `name=value`. An
// unreadable line leaves its preference at the default, because another version of the page may
// have written the line. O(bytes).
struct Kept {
  bool motion = true;
};
std::string kept_text(const Kept& kept);
Kept read_kept(std::string_view lines);

// --- Applies commands to the state. The folder `edits` implements the longer commands.

// Applies the commands in order and empties the list. Returns whether there were any; if so,
// another frame is due. If a document is refused, the last good placement stays.
bool apply(AppState& state, Commands& commands);

}  // namespace evenlift::view
