#include "evenlift/link.h"

#include <algorithm>

#include "commands/commands.h"
#include "evenlift/centre_of_mass.h"
#include "evenlift/formats.h"
#include "evenlift/generate.h"
#include "evenlift/lesson_link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/trace_json.h"
#include "evenlift/placement.h"
#include "evenlift/polygon.h"
#include "evenlift/trace.h"
#include "input/handed_in.h"
#include "input/options.h"

namespace evenlift::native {
namespace {

std::string family_names() {
  std::string names;
  for (const Family family : all_families)
    names += (names.empty() ? "" : ", ") + std::string(name(family));
  return names;
}

}  // namespace

void cmd_generate(const Arguments& arguments) {
  CommandLine line("evenlift generate",
                   "Writes a polygon in the thesis's format. The same seed gives the same polygon.",
                   "Example:\n  evenlift generate random --n 50 --seed 7 | evenlift place -\n");
  std::string family_text;
  std::optional<std::string> n_text, seed_text;
  line.positional(family_text, "FAMILY", family_names());
  line.value(n_text, "--n", "N", "number of vertices (default 12)");
  line.value(seed_text, "--seed", "S", "selects a polygon of the family (default 1)");
  if (!line.parse(arguments)) return;

  const std::optional<Family> family = family_from_name(family_text);
  if (!family) throw bad_value("FAMILY", "expected one of " + family_names(), family_text);
  const std::uint64_t n = n_text ? whole_option("--n", *n_text) : 12;
  Document document;  // its settings contain the seed
  if (seed_text) setting_option(Setting::seed, *seed_text, document);
  // size_t has 32 bits in WebAssembly; a larger number is too large anyway.
  const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(n, 0xFFFFFFFF));
  Result<Points> points = generate(*family, size, document.settings.seed);
  if (!points) throw Failure{bad_input_status, "--n", points.error().message};
  document.vertices = *std::move(points);
  write_output(write_thesis(document));
}

namespace {

// Every link must open with a result, so the document must be one that can be placed.
void check(const Input& input, const SettingOptions& options) {
  const Document& document = input.document;
  if (const std::optional<InputError> error = check_settings(document.settings, document.shown))
    throw options.failure(input, *error);
  const Result<PolygonWithHoles> object = object_of(document);
  if (!object) throw options.failure(input, object.error());
  const auto centre = centre_of_mass(*object, document.centre_of_mass, document.settings);
  if (!centre) throw options.failure(input, centre.error());
}

void encode(const Arguments& arguments) {
  CommandLine line(
      "evenlift link encode",
      "Prints a polygon and its settings as a share link's fragment, without #.",
      "FILE is a path, - for standard input, or a share link, whose settings the options change.\n");
  InputOptions options;
  bool candidates = false;
  options.declare(line, "the polygon, in any format of `evenlift place`");
  options.settings.declare(line, OptionGroup::uncertainty);
  options.settings.declare(line, OptionGroup::units);
  line.flag(candidates, "--candidates", "also show the candidates on the page");
  if (!line.parse(arguments)) return;

  Input input = options.read();
  if (candidates) input.document.shown.overlays.candidates = true;
  check(input, options.settings);
  const Result<std::string> link = encode_link(input.document);
  if (!link) throw options.settings.failure(input, link.error());
  write_output(*link + "\n");
}

void decode(const Arguments& arguments) {
  CommandLine line(
      "evenlift link decode",
      "Prints the contents of a share link as JSON, or the text of a lesson.",
      "LINK is a link's fragment, with or without #, or a whole address that ends in one. Of an\n"
      "address with a polygon and a lesson, the lesson is printed.\n");
  std::string link;
  line.positional(link, "LINK", "VERSION.PAYLOAD");
  if (!line.parse(arguments)) return;
  if (has_lesson_link(link)) {
    const Result<std::string> lesson = decode_lesson_link(link);
    if (!lesson) throw bad_input("link", lesson.error());
    return write_output(*lesson);
  }
  const Result<Document> document = decode_link(link);
  if (!document) throw bad_input("link", document.error());
  write_output(document_json(*document));
}

void encode_lesson(const Arguments& arguments) {
  CommandLine line("evenlift link lesson", "Prints a lesson as a share link's fragment, without #.",
                   "LESSON is a file, - for standard input, or the name of a ready-made lesson.\n");
  std::string name;
  line.positional(name, "LESSON", "the text of a lesson");
  if (!line.parse(arguments)) return;
  const LessonText lesson = read_lesson("link", name);
  const Result<std::string> link = encode_lesson_link(lesson.text);
  if (!link) throw bad_input(name, link.error());
  write_output(*link + "\n");
}

constexpr const char* help =
    "Usage: evenlift link encode FILE [options]\n"
    "       evenlift link lesson LESSON\n"
    "       evenlift link decode LINK\n\n"
    "See also `evenlift link encode --help`, and so on.\n";

}  // namespace

void cmd_link(const Arguments& arguments) {
  if (arguments.empty())
    throw Failure{bad_input_status, "link", "expected encode, lesson or decode after it"};
  const std::string& direction = arguments.front();
  const Arguments rest(arguments.begin() + 1, arguments.end());
  if (direction == "encode") return encode(rest);
  if (direction == "lesson") return encode_lesson(rest);
  if (direction == "decode") return decode(rest);
  if (direction == "--help" || direction == "-h") return write_output(help);
  throw bad_value("link", "expected encode, lesson or decode", direction);
}

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
  if (!placement) throw options.settings.failure(input, placement.error());
  const Result<Trace> trace =
      make_trace(*placement, HistoryLength::whole, input.document.shown.units);
  if (!trace) throw options.settings.failure(input, trace.error());
  if (const auto error = check_printed_size(*trace)) throw options.settings.failure(input, *error);
  write_output(as_json ? trace_json(*trace) : trace_list(*trace));
}

}  // namespace evenlift::native
