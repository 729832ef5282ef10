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
  LoadModel load_model = LoadModel::plan;  // of the shown loads
  std::optional<std::uint64_t> failed =
      {};  // the failing robot, from 1, or 0 for none; unchanged without a value
};

// Applies lines `name=value` in the syntax of settings.h. Returns an error for the first unreadable
// line. Makes no checks that need place(). O(bytes).
Result<Changeable> with_settings(Changeable given, std::string_view lines);

// The preferences that the browser keeps apart from the document, as lines `name=value`. If a line
// is unreadable, the default stays: another version of the page may have written it. O(bytes).
struct Kept {
  bool motion = true;
};
std::string kept_text(const Kept& kept);
Kept read_kept(std::string_view lines);

}  // namespace evenlift::view
