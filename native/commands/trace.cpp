#include "evenlift/trace.h"
#include "commands/commands.h"
#include "evenlift/output/trace_json.h"
#include "evenlift/placement.h"
#include "input/options.h"

namespace evenlift::native {

void cmd_trace(const Arguments& arguments) {
  CommandLine line(
      "evenlift trace", "Prints the algorithm's steps in order, with this polygon's numbers.",
      "FILE is a path, - for standard input, or a share link, as for `evenlift place`.\n\n"
      "Examples:\n"
      "  evenlift trace table.txt\n"
      "  evenlift trace table.txt --metric circle --teams 2 --json\n"
      "  evenlift trace table.txt --metric balanced --robots 6\n");
  InputOptions options;
  bool as_json = false;
  options.declare(line);
  line.flag(as_json, "--json", "one JSON array of steps instead of a list");
  if (!line.parse(arguments)) return;

  const Input input = options.read();
  // The trace does the search for balanced robots itself.
  const Result<Placement> placement = place(input.document, Effort::start);
  if (!placement) throw options.settings.failure(input.source, placement.error());
  const Result<Trace> trace =
      make_trace(*placement, HistoryLength::whole, input.document.shown.units);
  if (!trace) throw options.settings.failure(input.source, trace.error());
  if (const auto error = check_printed_size(*trace))
    throw options.settings.failure(input.source, *error);
  write_output(as_json ? trace_json(*trace) : trace_list(*trace));
}

}  // namespace evenlift::native
