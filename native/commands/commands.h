// The commands. They receive the arguments after their name. A command throws
// Failure if its exit status is not 0. Before that, it writes to standard output only in the cases
// that cli.md names under "Exit status and errors".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/output/requirements.h"
#include "evenlift/parts.h"
#include "input/options.h"
#include "print/table.h"

namespace evenlift::native {

using Arguments = std::vector<std::string>;

void cmd_place(const Arguments& arguments);
void cmd_link(const Arguments& arguments);
void cmd_generate(const Arguments& arguments);
void cmd_trace(const Arguments& arguments);
void cmd_optimum(const Arguments& arguments);
void cmd_check(const Arguments& arguments);
void cmd_experiment(const Arguments& arguments);

// Of a table of all shapes.
struct TableOptions {
  std::optional<std::string> csv, sort, jobs;

  void declare(CommandLine& line);
  bool typed() const { return csv || sort || jobs; }
};

struct PlaceOptions {
  InputOptions input;
  WeightByArea weight;
  TableOptions table;
  RobustnessOptions robustness;
  bool as_json = false, candidates = false, even_out = false, cases = false, keep_misfits = false;
  std::optional<std::string> require;
  std::optional<std::string> svg;
  PoseFileOptions poses;

  void declare(CommandLine& line);

  // Sets the document's weight if it follows from its area, and says on standard error how a number
  // without a unit was read. Throws Failure with the option's name if a value is invalid.
  void apply_weight(Document& document) const;
  void explain_weight(const Units& units) const;

  Misfitting misfitting() const {
    return keep_misfits ? Misfitting::left_out : Misfitting::refused;
  }

  // Returns the conditions of --require. Throws Failure if they are invalid.
  std::vector<Condition> conditions() const;
};

// --- The command `evenlift place --shape all`.

// Prints a table with a row for each shape, or with --json a line for each, even if shapes are
// refused. Throws Failure before printing if an option is invalid or needs a single shape, or the
// input cannot be read; after printing if a shape was refused or a condition is not kept.
void place_all(const PlaceOptions& options);

}  // namespace evenlift::native
