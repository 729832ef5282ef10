// Command lines, and failures with their exit status.
#pragma once

#include <map>
#include <memory>
#include <optional>
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

// --- A command's arguments. CLI11 parses them. Every error becomes a Failure; "Exit status and errors"
// in cli.md describes how the program reports it.

namespace CLI {

class App;
}

namespace evenlift::native {

// Values stay text, because evenlift checks them itself, with its own messages (options.h).
class CommandLine {
 public:
  // `command` is the command as typed ("evenlift place"); `purpose` is a sentence.
  CommandLine(const std::string& command, const std::string& purpose, const std::string& examples);
  ~CommandLine();

  void positional(std::string& into, const std::string& name, const std::string& help);
  // Declares a list of positional arguments, which may be empty.
  void positionals(std::vector<std::string>& into, const std::string& name,
                   const std::string& help);
  void value(std::optional<std::string>& into, const std::string& option, const std::string& name,
             const std::string& help);
  // Declares `other` as a second name of an option declared with value(). The help omits `other`.
  void alias(const std::string& other, const std::string& option);
  void flag(bool& into, const std::string& option, const std::string& help);

  // Fills the declared variables. Returns false after printing help on request. Throws Failure on
  // an unknown option, a missing or surplus argument, an option that is given twice or without its
  // value, and a flag that is given a value.
  bool parse(const std::vector<std::string>& arguments);

 private:
  std::string advice_for(const std::string& option) const;
  std::vector<std::string> joined(const std::vector<std::string>& arguments) const;

  std::unique_ptr<CLI::App> app_;
  std::vector<std::string> positionals_;
  std::vector<std::string> value_options_;
  std::vector<std::string> flags_;
  std::map<std::string, std::string> aliases_;  // second name to option
};

}  // namespace evenlift::native
