// Settings as text: what window.evenlift.set() passes, and what the browser keeps.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift::view {

// The settings that set() can change.
struct Changeable {
  Document document;
  std::optional<double> capacity;  // of one robot
};

// Makes the changes of `lines`, each a line `name=value` as settings_text.h reads it; a capacity
// may be "none". The first line that cannot be read is the error. What only place() can judge is
// not checked here. O(bytes).
Result<Changeable> with_settings(Changeable given, std::string_view lines);

// The preferences that the browser keeps besides the document, as `name=value` lines; and back.
// What cannot be read keeps its default, as another version of the page may have written it.
// O(bytes).
struct Kept {
  bool motion = true;
  std::optional<double> capacity;
};
std::string kept_text(const Kept& kept);
Kept read_kept(std::string_view lines);

}  // namespace evenlift::view
