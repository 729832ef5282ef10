#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/output/requirements.h"
#include "input/options.h"
#include "print/table.h"

namespace evenlift::native {

struct PlaceOptions {
  InputOptions input;
  RobustnessOptions robustness;
  bool as_json = false, candidates = false, even_out = false;
  std::optional<std::string> require;
  std::optional<std::string> svg;
  PoseFileOptions poses;

  void declare(CommandLine& line);

  // Returns the conditions of --require. Throws Failure if they are invalid.
  std::vector<Condition> conditions() const;
};

}  // namespace evenlift::native
