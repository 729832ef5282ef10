// Settings as text: those that window.evenlift.set() passes, and those that the browser keeps.
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

}  // namespace evenlift::view
