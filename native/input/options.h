// The options of settings: from text on the command line to a Document.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"
#include "evenlift/settings.h"
#include "input/command_line.h"
#include "input/failure.h"
#include "input/files.h"
#include "input/shapes.h"

namespace evenlift::native {

// The value of an option that is a whole number of at most `most`. Throws Failure.
std::uint64_t whole_option(const std::string& option, const std::string& text,
                           std::uint64_t most = ~std::uint64_t{0});

// Puts a setting that was typed into the document, and reads those that are no part of a document
// (settings.h). Throws Failure naming the option where the text is no value of it.
void setting_option(Setting setting, const std::string& text, Document& document);
LoadModel loads_option(const std::string& text);

// What was typed of the options of settings, which the table of settings describes (settings.h). A
// setting whose option was not given keeps the file's value or the default.
class SettingOptions {
 public:
  void declare(CommandLine& line, OptionGroup group);

  // Puts what was typed into the document. Throws Failure naming the option where the text is no
  // value of its setting or of no use with the method; which values go together is checked with the
  // rest of the document.
  void apply(Document& document) const;

  // An error of the document to which these options were applied, in terms of what was typed.
  Failure failure(const std::string& source, const InputError& error) const;

 private:
  using Typed = std::optional<std::string>;
  const Typed& typed(Setting setting) const { return typed_[static_cast<std::size_t>(setting)]; }

  std::array<Typed, static_cast<std::size_t>(Setting::end_of_settings)> typed_;
};

// A polygon and its settings, as all commands take them that place robots on it. Some commands
// declare more groups of settings.
struct InputOptions {
  std::string file;
  SettingOptions settings;
  ShapeOptions shapes;

  void declare(CommandLine& line, const std::string& help = "the polygon");

  // What the file holds, with the settings that were typed. Throws Failure.
  Input read() const;
};

}  // namespace evenlift::native
