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

struct PoseFileOptions {
  std::optional<std::string> file, frame, origin;

  void declare(CommandLine& line);

  // The typed values; nullopt if no file is requested. Throws Failure with the option's name if a
  // value is invalid or does not apply.
  std::optional<PosesAsked> asked() const;
};

}  // namespace evenlift::native
