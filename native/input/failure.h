#pragma once

#include <string>
#include <system_error>
#include <vector>

#include "evenlift/result.h"

namespace evenlift::native {

inline constexpr int bad_input_status = 2;  // wrong usage or input
inline constexpr int not_kept_status = 3;   // a condition is not met, or a task is not done
inline constexpr int other_status = 1;      // anything else, such as a file that cannot be written

// The error that a command throws. main() then prints `evenlift: WHERE: WHAT` on standard error.
struct Failure {
  int status = bad_input_status;
  std::string where;                   // a file and the place in it, or an option as typed
  std::string what;                    // one sentence without a full stop
  std::vector<std::string> list = {};  // further lines, such as the possible choices
  bool silent = false;                 // print nothing: the user already knows, or no one reads
};

// Prints the message on one line, and the list below it. Control characters appear as "?", and an
// empty `where` as two quotation marks. Prints nothing if the failure is silent.
void print_failure(const Failure& failure);

// The error's message as a part of a sentence: "no such file or directory".
std::string system_message(const std::error_code& error);

Failure bad_value(const std::string& option, const std::string& expected, const std::string& typed);

// A failure for an error in `source`: a file's name, "standard input" or "link".
Failure bad_input(const std::string& source, const InputError& error);

}  // namespace evenlift::native
