// Selects the command, and turns a failure into one line and an exit status.
#include <csignal>
#include <cstdio>
#include <exception>

#include "commands/commands.h"
#include "evenlift/output/json.h"
#include "input/command_line.h"
#include "input/files.h"
#include "schema/schema.h"

namespace evenlift::native {
namespace {

struct Command {
  const char* name;
  const char* summary;
  void (*run)(const Arguments&);
};

constexpr Command commands[] = {
    {"place", "places for robots around a polygon, with loads and stability", cmd_place},
    {"trace", "the algorithm step by step, in words and numbers", cmd_trace},
    {"link", "a polygon and its settings as a share link, and back", cmd_link},
    {"generate", "a polygon from a family, a size and a seed", cmd_generate},
    {"optimum", "how far the greedy choice of teams is from the best one", cmd_optimum},
    {"check", "whether links solve the task of a lesson: homework", cmd_check},
    {"experiment", "the measurements of chapter 5 on many polygons, with a report", cmd_experiment},
};

std::string help() {
  std::string text =
      "evenlift places teams of two robots around a polygonal object so that each robot carries\n"
      "about the same load.\n\n"
      "Usage: evenlift COMMAND ...\n\nCommands:\n";
  for (const Command& command : commands) {
    std::string name = command.name;
    name.resize(12, ' ');
    text += "  " + name + command.summary + "\n";
  }
  return text +
         "\n`evenlift COMMAND --help` explains a command, and `evenlift --schema` prints the JSON Schema of all\n"
         "results and requests. Exit status: 0 done, 3 a condition\n"
         "is not kept or a task is not done, 2 bad usage or bad input, 1 anything else.\n";
}

void run(Arguments arguments) {
  if (arguments.empty())
    throw Failure{bad_input_status, "command", "missing; `evenlift --help` lists the commands"};
  std::string name = arguments.front();
  arguments.erase(arguments.begin());
  if (name == "help" && !arguments.empty()) {
    name = arguments.front();
    arguments = {"--help"};
  }
  if (name == "--help" || name == "-h" || name == "help") return write_output(help());
  if (name == "--version") return write_output("evenlift " + std::string(version()) + "\n");
  if (name == "--schema") return write_output(schema_json());
  for (const Command& command : commands)
    if (name == command.name) return command.run(arguments);
  const bool option = name.size() > 1 && name[0] == '-';
  throw Failure{bad_input_status, name,
                option ? "unknown option; a command comes first, and `evenlift --help` lists them"
                       : "unknown command; `evenlift --help` lists them"};
}

}  // namespace
}  // namespace evenlift::native

int main(int count, char** values) {
  using namespace evenlift::native;
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);  // if the reader stops early, only the write fails
#endif
  try {
    run(Arguments(values + 1, values + count));
    return 0;
  } catch (const Failure& failure) {
    print_failure(failure);
    return failure.status;
  } catch (const std::exception& error) {
    print_failure({other_status, "internal error", error.what()});
    return other_status;
  }
}
