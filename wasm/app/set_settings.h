// Settings as text, as window.evenlift.set() passes them and the browser keeps them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"

namespace evenlift::view {

// The values that set() can change.
struct Changeable {
  Document document;
  LoadModel load_model = LoadModel::plan;  // the model of the shown loads
  std::optional<std::uint64_t> failed =
      {};  // the robot that fails, from 1, or 0 for none; unchanged without a value
};

// Applies the changes in `lines`, each a line `name=value` in the syntax of settings.h. Returns an
// error for the first line that cannot be read. Checks that need place() are not made here.
// O(bytes).
Result<Changeable> with_settings(Changeable given, std::string_view lines);

// The preferences that the browser keeps apart from the document, as `name=value` lines; and back.
// A line that cannot be read keeps its default, since another version of the page may have written
// it. O(bytes).
struct Kept {
  bool motion = true;
};
std::string kept_text(const Kept& kept);
Kept read_kept(std::string_view lines);

}  // namespace evenlift::view
