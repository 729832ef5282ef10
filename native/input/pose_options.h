// The file for the robots' poses, and its format.
#pragma once

#include <optional>
#include <string>

#include "evenlift/output/poses.h"
#include "input/command_line.h"

namespace evenlift::native {

struct PosesAsked {
  std::string file;
  PoseFormat format;
  PoseOptions options;
};

// The typed options; empty if not given.
struct PoseFileOptions {
  std::optional<std::string> file, frame, origin;

  void declare(CommandLine& line);

  // The requested file, if any. Throws Failure with the option's name.
  std::optional<PosesAsked> asked() const;
};

}  // namespace evenlift::native
