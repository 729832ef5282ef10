// The place options: from text on the command line to a Document's settings.
#pragma once

#include <optional>
#include <string>

#include "command_line.h"
#include "evenlift/document.h"
#include "evenlift/result.h"
#include "failure.h"
#include "files.h"

namespace evenlift::native {

// What was typed; nothing where an option was not given and the file's or the default value stands.
struct SettingOptions {
  std::optional<std::string> teams, metric, min_ratio, com, weight, seed;

  void declare(CommandLine& line);

  // Puts what was typed into the document. Throws Failure naming the option where a value is no
  // number, no whole number or no metric; ranges are checked with the rest of the document.
  void apply(Document& document) const;

  // An error of the document to which these options were applied, in terms of what was typed.
  Failure failure(const std::string& source, const InputError& error) const;
};

}  // namespace evenlift::native
