// Selects the shapes of a file, and reports how they are read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/import.h"
#include "input/command_line.h"

namespace evenlift::native {

struct ShapeOptions {
  std::optional<std::string> shape, flatten, join, holes;
  bool project = false;
  bool offered = false;  // whether the command has these options

  void declare(CommandLine& line);
  // Whether the shapes keep their holes. Throws Failure if --holes is neither yes nor no.
  bool keeps_holes() const;
  // Whether --shape is "all". Only `evenlift place` then takes all shapes; for other commands, the
  // word is a shape's name.
  bool selects_all() const { return shape == "all"; }
};

// Returns the selected shape, or the only one. Reports on standard error what was left out and how
// the text was read, one line each. Throws Failure if the text or an option is invalid. The user
// must select a shape if there are several, or if open lines that were left out span more than any
// shape; without a selection, throws a Failure that lists the shapes.
Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options);

// Returns all shapes. Reports the same as choose_shape(). If choose_shape() would require a
// selection but the command has no option for it, also reports that all shapes are taken. Throws
// Failure if the text or an option is invalid.
std::vector<ImportedShape> all_shapes(const std::string& text, const std::string& source,
                                      const ShapeOptions& options);

}  // namespace evenlift::native
