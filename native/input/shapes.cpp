#include "input/shapes.h"

#include <algorithm>

#include "evenlift/numbers.h"
#include "input/failure.h"

namespace evenlift::native {
namespace {

constexpr std::size_t most_listed = 20;

ImportOptions import_options(const ShapeOptions& options) {
  ImportOptions import;
  const auto read = [](const std::optional<std::string>& typed, const char* option,
                       const char* rule) -> std::optional<double> {
    if (!typed) return std::nullopt;
    const std::optional<double> value = read_number(*typed);
    if (!value || !(*value > 0)) throw bad_value(option, rule, *typed);
    return value;
  };
  import.tolerance = read(options.flatten, "--flatten",
                          "the distance between curves and edges must be a number above 0");
  import.join =
      read(options.join, "--join", "the distance of ends that are joined must be a number above 0");
  return import;
}

std::vector<std::string> listed(const std::vector<ImportedShape>& shapes) {
  std::vector<std::string> lines;
  const std::size_t count = std::min(shapes.size(), most_listed);
  for (std::size_t i = 0; i < count; ++i)
    lines.push_back(std::to_string(i + 1) + "  " + describe(shapes[i]));
  if (count < shapes.size())
    lines.push_back("and " + std::to_string(shapes.size() - count) + " more");
  return lines;
}

std::size_t only_shape(const Import& import, const std::string& source,
                       const ShapeOptions& options) {
  if (import.shapes.size() == 1 && !import.doubtful) return 0;
  const std::string count =
      import.doubtful ? "what does not close is larger than the largest shape" +
                            std::string(import.notes.empty() ? "" : " (" + import.notes[0] + ")")
                      : "it has " + std::to_string(import.shapes.size()) + " shapes";
  if (!options.offered)
    throw Failure{bad_input_status, source, count + ", but only one is allowed here"};
  throw Failure{bad_input_status, source, count + "; --shape N selects one", listed(import.shapes)};
}

std::size_t named_shape(const Import& import, const std::string& typed) {
  const std::vector<ImportedShape>& shapes = import.shapes;
  const std::optional<std::uint64_t> number = read_whole(typed);
  if (number && *number >= 1 && *number <= shapes.size())
    return static_cast<std::size_t>(*number) - 1;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].name != typed) continue;
    if (found)
      throw Failure{bad_input_status, "--shape",
                    "shapes " + std::to_string(*found + 1) + " and " + std::to_string(i + 1) +
                        " are both called \"" + typed + "\"; give a number instead"};
    found = i;
  }
  if (found) return *found;
  throw Failure{bad_input_status, "--shape",
                "expected a number from 1 to " + std::to_string(shapes.size()) +
                    " or a shape's name, not \"" + typed + "\"",
                listed(shapes)};
}

}  // namespace

void ShapeOptions::declare(CommandLine& line) {
  offered = true;
  line.value(shape, "--shape", "N", "number or name of a shape, if the file has several");
  line.value(flatten, "--flatten", "T",
             "greatest distance of edges from curves (default about 1/1000 of the shape)");
  line.value(join, "--join", "D",
             "greatest distance of ends that are joined (default up to 1/1000 of the drawing)");
}

Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options) {
  Result<Import> read = read_shapes(text, import_options(options));
  if (!read) throw bad_input(source, read.error());
  Import import = std::move(read).value();
  const std::size_t chosen =
      options.shape ? named_shape(import, *options.shape) : only_shape(import, source, options);
  const ImportedShape& shape = import.shapes[chosen];
  for (const std::string& note : import.notes) print_failure({0, source, note, {}});
  if (shape.tolerance)
    print_failure({0,
                   source,
                   "curves were flattened to within " + shortest(*shape.tolerance) +
                       (options.flatten || !options.offered ? "" : "; --flatten T changes this"),
                   {}});
  return shape.document;
}

}  // namespace evenlift::native
