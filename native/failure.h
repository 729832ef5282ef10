// How a command gives up: one line on standard error and the exit status.
#pragma once

#include <string>

#include "evenlift/result.h"

namespace evenlift::native {

inline constexpr int bad_input_status = 2;  // of usage or of what was read
inline constexpr int other_status = 1;      // anything else, such as a file that cannot be written

// Thrown by commands, caught by main, which prints `evenlift: WHERE: WHAT`.
struct Failure {
  int status = bad_input_status;
  std::string where;  // a file and the place in it, or an option as it is typed
  std::string what;   // one sentence, no full stop
};

// An error in what `source` (a file's name, "standard input", "link") holds.
Failure bad_input(const std::string& source, const InputError& error);

}  // namespace evenlift::native
