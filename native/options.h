// The place options: from text on the command line to a Document's settings.
#pragma once

#include <optional>
#include <string>

#include "command_line.h"
#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"
#include "evenlift/settings_text.h"
#include "failure.h"
#include "files.h"
#include "shapes.h"

namespace evenlift::native {

// The value of an option that is a whole number of at most `most`. Throws Failure.
std::uint64_t whole_option(const std::string& option, const std::string& text,
                           std::uint64_t most = ~std::uint64_t{0});

// Puts a setting that was typed into the document, and reads those that are no part of a document
// (settings_text.h). Throws Failure naming the option where the text is no value of it.
void setting_option(Setting setting, const std::string& text, Document& document);
LoadModel loads_option(const std::string& text);

// What was typed. An option that was not given is empty: the file's value or the default applies.
struct SettingOptions {
  std::optional<std::string> teams, metric, min_ratio, com, weight, seed;
  std::optional<std::string> robots, goal, min_margin, apart, clear, survive, positions, robot,
      no_go;

  void declare(CommandLine& line);

  // Puts what was typed into the document. Throws Failure naming the option where the text is no
  // value of its setting or of no use with the method; which values go together is checked with the
  // rest of the document.
  void apply(Document& document) const;

  // An error of the document to which these options were applied, in terms of what was typed.
  Failure failure(const std::string& source, const InputError& error) const;

 private:
  void check_method(const Settings& settings) const;
};

// A polygon and its settings, as all commands take them that place robots on it.
struct InputOptions {
  std::string file;
  SettingOptions settings;
  ShapeOptions shapes;

  void declare(CommandLine& line, const std::string& help = "the polygon");

  // What the file holds, with the settings that were typed. Throws Failure.
  Input read() const;
};

// The labels of lengths and weights, as they were typed.
struct UnitOptions {
  std::optional<std::string> unit, weight_unit;

  void declare(CommandLine& line);
  void apply(Document& document) const;  // throws Failure naming the option
};

// What a robot carries and how well the centre of mass is known, as it was typed.
struct DoubtOptions {
  std::optional<std::string> capacity, com_radius;

  void declare(CommandLine& line);
  void apply(Document& document) const;  // throws Failure naming the option
};

}  // namespace evenlift::native
