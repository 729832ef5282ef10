// Settings as text: what window.evenlift.set() passes, and what the browser keeps.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"

namespace evenlift::view {

// What set() can change.
struct Changeable {
  Document document;
  LoadModel load_model = LoadModel::plan;  // whose loads are shown
  std::optional<std::uint64_t> failed =
      {};  // the robot that fails, from 1, or 0 for none; nothing if
           // that stays
};

// Makes the changes of `lines`, each a line `name=value` as settings.h reads it. The first line
// that cannot be read is the error. What only place() can judge is not checked here. O(bytes).
Result<Changeable> with_settings(Changeable given, std::string_view lines);

// The preferences that the browser keeps besides the document, as `name=value` lines; and back.
// What cannot be read keeps its default, as another version of the page may have written it.
// O(bytes).
struct Kept {
  bool motion = true;
};
std::string kept_text(const Kept& kept);
Kept read_kept(std::string_view lines);

}  // namespace evenlift::view
