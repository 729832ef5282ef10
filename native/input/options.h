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

// A whole number up to `most`. Throws Failure.
std::uint64_t whole_option(const std::string& option, const std::string& text,
                           std::uint64_t most = ~std::uint64_t{0});

// Puts a setting into the document, or reads one that is not part of it (settings.h). Throws
// Failure with the option's name if the text is invalid.
void setting_option(Setting setting, const std::string& text, Document& document);
LoadModel loads_option(const std::string& text);

// Options of the table of settings (settings.h). A setting without its option keeps the file's
// value or the default.
class SettingOptions {
 public:
  void declare(CommandLine& line, OptionGroup group);

  // Throws Failure with the option's name if the text is invalid for its setting, or if the method
  // does not use the setting. Combinations are checked with the rest of the document.
  void apply(Document& document) const;

  // The path, if --supports names a file.
  std::optional<std::string> supports_file() const;

  // An error of the document as one about these options.
  Failure failure(const std::string& source, const InputError& error) const;

 private:
  using Typed = std::optional<std::string>;
  const Typed& typed(Setting setting) const { return typed_[static_cast<std::size_t>(setting)]; }

  std::array<Typed, static_cast<std::size_t>(Setting::end_of_settings)> typed_;
};

// For all commands that place robots; some declare more groups of settings.
struct InputOptions {
  std::string file;
  SettingOptions settings;
  ShapeOptions shapes;

  void declare(CommandLine& line, const std::string& help = "the polygon");

  // Both apply the typed settings, and throw Failure.
  Input read() const;
  InputShapes read_all() const;

 private:
  void apply(Document& document) const;
};

}  // namespace evenlift::native
