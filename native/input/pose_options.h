// Where the robots' poses are to be written, and how.
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

// What was typed. An option that was not given is empty.
struct PoseFileOptions {
  std::optional<std::string> file, frame, origin;

  void declare(CommandLine& line);

  // What is asked for, if anything is. Throws Failure naming the option.
  std::optional<PosesAsked> asked() const;
};

}  // namespace evenlift::native
