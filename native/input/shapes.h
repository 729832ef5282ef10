// Which shape of a file is meant, and how near its edges stay to curves.
#pragma once

#include <optional>
#include <string>

#include "evenlift/import.h"
#include "input/command_line.h"

namespace evenlift::native {

// What was typed. An option that was not given is empty.
struct ShapeOptions {
  std::optional<std::string> shape, flatten;
  bool offered = false;  // the command has these options

  void declare(CommandLine& line);
};

// Reads the text and takes the shape that is meant, or the only one. What was left out or decided
// is said on standard error, a line each. Throws Failure; if no shape is named and there are
// several, it lists them.
Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options);

}  // namespace evenlift::native
