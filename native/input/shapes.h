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
  bool offered = false;  // the command has these options

  void declare(CommandLine& line);
  // Throws Failure if neither yes nor no was typed.
  bool keeps_holes() const;
  // Only `evenlift place` takes all shapes; elsewhere the word is a shape's name.
  bool selects_all() const { return shape == "all"; }
};

// The selected shape, or the only one. Reports omissions and decisions on standard error, one per
// line. Throws Failure, which without a selection among several shapes lists them.
Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options);

// All shapes, whatever was left out. Reports the same, and that all of several are taken, unless an
// option asked for that. Throws Failure.
std::vector<ImportedShape> all_shapes(const std::string& text, const std::string& source,
                                      const ShapeOptions& options);

}  // namespace evenlift::native
