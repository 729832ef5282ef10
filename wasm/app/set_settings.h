// Settings as text: what window.evenlift.set() gives, and what the browser keeps.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift::view {

// What set() can change.
struct Changeable {
  Document document;
  std::optional<double> capacity;  // of one robot
};

// What was given with the changes of `lines` made, each a line `name=value` as settings_text.h
// reads it; a capacity may be "none". The first line that cannot be read is the error; what only
// place() can judge is not looked at. O(bytes).
Result<Changeable> with_settings(Changeable given, std::string_view lines);

// What this browser keeps besides the document, as `name=value` lines; and from them. What cannot
// be read is left at its default: another version of the page wrote it. O(bytes).
struct Kept {
  bool motion = true;
  std::optional<double> capacity;
};
std::string kept_text(const Kept& kept);
Kept read_kept(std::string_view lines);

}  // namespace evenlift::view
