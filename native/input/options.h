#pragma once

#include <array>
#include <optional>
#include <string>

#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/output/poses.h"
#include "evenlift/result.h"
#include "evenlift/settings.h"
#include "input/command_line.h"
#include "input/files.h"

namespace evenlift::native {

// Reads a whole number up to `most`. Throws Failure for any other text.
std::uint64_t whole_option(const std::string& option, const std::string& text,
                           std::uint64_t most = ~std::uint64_t{0});

// The number of threads that --jobs asks for, or that of the processors. Throws Failure if it is not
// from 1 to 1024.
unsigned jobs_option(const std::optional<std::string>& text);

// The option of a setting: "min_ratio" is typed --min-ratio.
std::string as_typed(std::string_view setting);

// setting_option() reads a setting into the document. loads_option() returns the load model, which
// is not part of a document. Both throw Failure with the option's name if the text is invalid.
void setting_option(Setting setting, const std::string& typed, Document& document);
LoadModel loads_option(const std::string& text);
// Adds typed cargo to the document's; `none` removes it. Throws Failure like setting_option().
void add_cargo(const std::string& text, Document& document, bool y_down = false);

// The options for the settings in the table of settings.h. If an option is not typed, its setting
// keeps the file's value or the default.
class SettingOptions {
 public:
  void declare(CommandLine& line, OptionGroup group);
  // The file of supports has what they read.
  bool weigh = false;
  // In typed places and files of supports, y points down.
  bool y_down = false;

  // Applies the typed settings. Throws Failure with the option's name if a text is invalid, or if
  // the method does not use the setting. Combinations of settings are checked later, with the rest
  // of the document. Returns where supports stand in their file, if they come from one.
  std::vector<std::size_t> apply(Document& document) const;

  // The path of the file that --supports names; nullopt if it names no file.
  std::optional<std::string> supports_file() const;

  // The Failure for an error of the document. The Failure names the option at fault, if any, or
  // the line of the file of supports.
  Failure failure(const Input& input, const InputError& error) const;

  using Typed = std::optional<std::string>;
  const Typed& typed(Setting setting) const { return typed_[static_cast<std::size_t>(setting)]; }

 private:
  std::array<Typed, static_cast<std::size_t>(Setting::end_of_settings)> typed_;
};

// The options of all commands that place robots. Some commands declare more groups of settings.
struct InputOptions {
  std::string file;
  SettingOptions settings;
  ShapeOptions shapes;

  void declare(CommandLine& line, const std::string& help = "the polygon");

  // read() reads one shape of the file, and read_all() reads all shapes. Both apply the typed
  // settings, and throw Failure if the file or a setting is invalid.
  Input read() const;
  InputShapes read_all() const;

 private:
  std::vector<std::size_t> apply(Document& document) const;
  void tell_y(const std::string& source, bool y_down) const;
};

// Says on standard error which of the typed loads is outside the object. O(n) for each load.
void tell_loads_outside(const Input& input, const SettingOptions& options);

struct PosesAsked {
  std::string file;
  PoseFormat format;
  PoseOptions options;
};

struct PoseFileOptions {
  std::optional<std::string> file, frame, origin;

  void declare(CommandLine& line);

  // The typed values; nullopt if no file is requested. Throws Failure with the option's name if a
  // value is invalid or does not apply.
  std::optional<PosesAsked> asked() const;
};

}  // namespace evenlift::native
