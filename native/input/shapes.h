// Selects the shapes of a file, and says how they are read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/import.h"
#include "input/command_line.h"

namespace evenlift::native {

// The typed options; empty if not given.
struct ShapeOptions {
  std::optional<std::string> shape, flatten, join, holes;
  bool project = false;
  bool offered = false;  // the command has these options

  void declare(CommandLine& line);
  // Whether holes count. Throws Failure if neither yes nor no was typed.
  bool keeps_holes() const;
  // Only `evenlift place` takes all shapes; elsewhere the word is a shape's name.
  bool selects_all() const { return shape == "all"; }
};

// Reads the text and returns the selected shape, or the only one. Omissions and decisions are
// reported on standard error, one per line. Throws Failure; without a selection among several
// shapes, it lists them.
Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options);

// Reads the text and returns all its shapes, whatever was left out. Reports the same, and, where no
// option asked for all of several shapes, that all are taken. Throws Failure.
std::vector<ImportedShape> all_shapes(const std::string& text, const std::string& source,
                                      const ShapeOptions& options);

}  // namespace evenlift::native
