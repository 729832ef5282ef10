// A command's arguments. CLI11 parses them. Every error becomes a Failure; "Exit status and errors"
// in cli.md describes how the program reports it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
