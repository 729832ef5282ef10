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

// The value of an option that is a whole number up to `most`. Throws Failure.
std::uint64_t whole_option(const std::string& option, const std::string& text,
                           std::uint64_t most = ~std::uint64_t{0});

// Puts a typed setting into the document, or reads a setting that is not part of a document
// (settings.h). Throws Failure with the option's name if the text is invalid.
void setting_option(Setting setting, const std::string& text, Document& document);
LoadModel loads_option(const std::string& text);

// The typed options of settings, as the table of settings describes them (settings.h). A setting
// without its option keeps the file's value or the default.
class SettingOptions {
 public:
  void declare(CommandLine& line, OptionGroup group);

  // Puts the typed values into the document. Throws Failure with the option's name if the text is
  // invalid for its setting, or if the method does not use the setting. Combinations of values are
  // checked with the rest of the document.
  void apply(Document& document) const;

  // The path of the file of supports, if --supports names one.
  std::optional<std::string> supports_file() const;

  // Converts an error of the document to one about these typed options.
  Failure failure(const std::string& source, const InputError& error) const;

 private:
  using Typed = std::optional<std::string>;
  const Typed& typed(Setting setting) const { return typed_[static_cast<std::size_t>(setting)]; }

  std::array<Typed, static_cast<std::size_t>(Setting::end_of_settings)> typed_;
};

// A polygon and its settings, for all commands that place robots. Some commands declare more groups
// of settings.
struct InputOptions {
  std::string file;
  SettingOptions settings;
  ShapeOptions shapes;

  void declare(CommandLine& line, const std::string& help = "the polygon");

  // The document in the file, with the typed settings. Throws Failure.
  Input read() const;
  // All shapes in the file, each with the typed settings. Throws Failure.
  InputShapes read_all() const;

 private:
  void apply(Document& document) const;
};

}  // namespace evenlift::native
