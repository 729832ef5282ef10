// A command's arguments: CLI11 behind an interface that has one way to fail, the one of cli.md.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace evenlift::native {

// Values stay text here, so that the sentence that refuses one is ours (options.h).
class CommandLine {
 public:
  // `command` as typed ("evenlift place"), what it does in a sentence, and examples of its use.
  CommandLine(const std::string& command, const std::string& purpose, const std::string& examples);
  ~CommandLine();

  void positional(std::string& into, const std::string& name, const std::string& help);
  // Any number of arguments, perhaps none.
  void positionals(std::vector<std::string>& into, const std::string& name,
                   const std::string& help);
  void value(std::optional<std::string>& into, const std::string& option, const std::string& name,
             const std::string& help);
  void flag(bool& into, const std::string& option, const std::string& help);

  // Fills what was declared. False if help was asked for, which has then been printed. Throws
  // Failure on an unknown option, a missing or surplus argument, an option given twice or without
  // its value.
  bool parse(const std::vector<std::string>& arguments);

 private:
  std::vector<std::string> joined(const std::vector<std::string>& arguments) const;

  std::unique_ptr<CLI::App> app_;
  std::vector<std::string> positionals_;
  std::vector<std::string> value_options_;
  std::vector<std::string> flags_;
};

}  // namespace evenlift::native
