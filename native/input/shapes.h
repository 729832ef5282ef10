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
  // Whether holes count. Throws Failure if --holes is neither yes nor no.
  bool keeps_holes() const;
  // Whether --shape is "all". Only `evenlift place` then takes all shapes; for other commands, the
  // word is a shape's name.
  bool selects_all() const { return shape == "all"; }
};

// Returns the selected shape, or the only one. Reports omissions and decisions on standard error,
// one per line. Throws Failure; if no shape is selected among several, it lists the shapes.
Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options);

// Returns all shapes, whatever was left out. Reports the same as choose_shape(). If the command has
// no option for a shape, also reports that all of several are taken. Throws Failure.
std::vector<ImportedShape> all_shapes(const std::string& text, const std::string& source,
                                      const ShapeOptions& options);

}  // namespace evenlift::native
