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
  import.project = options.project;
  import.holes = options.keeps_holes();
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

std::string why_asked(const Import& import) {
  if (!import.doubtful) return "it has " + std::to_string(import.shapes.size()) + " shapes";
  return "what does not close is larger than the largest shape" +
         (import.notes.empty() ? std::string() : " (" + import.notes[0] + ")");
}

std::size_t only_shape(const Import& import, const std::string& source) {
  if (import.shapes.size() == 1 && !import.doubtful) return 0;
  throw Failure{bad_input_status, source, why_asked(import) + "; --shape N selects one",
                listed(import.shapes)};
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

Import read_text(const std::string& text, const std::string& source, const ShapeOptions& options) {
  Result<Import> read = read_shapes(text, import_options(options));
  if (!read) throw bad_input(source, read.error());
  return std::move(read).value();
}

// Writes to standard error, without failing.
void say(const std::string& source, const std::string& what) {
  print_failure({0, source, what, {}});
}

void report(const Import& import, const std::optional<double>& tolerance, const std::string& source,
            const ShapeOptions& options) {
  for (const std::string& note : import.notes) say(source, note);
  if (import.in_degrees && options.offered) say(source, "--project converts degrees to metres");
  if (!tolerance) return;
  const bool may_change = options.offered && !options.flatten;
  say(source, "curves were flattened to within " + shortest(*tolerance) +
                  (may_change ? "; --flatten T changes this" : ""));
}

}  // namespace

void ShapeOptions::declare(CommandLine& line) {
  offered = true;
  line.value(shape, "--shape", "N",
             "number or name of a shape, if the file has several; place also takes all");
  line.value(flatten, "--flatten", "T",
             "greatest distance of edges from curves (default about 1/1000 of the shape)");
  line.value(join, "--join", "D",
             "greatest distance of ends that are joined (default up to 1/1000 of the drawing)");
  line.value(holes, "--holes", "no", "leave out the holes of the shape (default yes: they count)");
  line.flag(project, "--project", "convert longitudes and latitudes in degrees to metres");
}

bool ShapeOptions::keeps_holes() const {
  if (!holes || *holes == "yes") return true;
  if (*holes == "no") return false;
  throw bad_value("--holes", "expected yes or no", *holes);
}

Document choose_shape(const std::string& text, const std::string& source,
                      const ShapeOptions& options) {
  const Import import = read_text(text, source, options);
  const std::size_t chosen =
      options.shape ? named_shape(import, *options.shape) : only_shape(import, source);
  const ImportedShape& shape = import.shapes[chosen];
  report(import, shape.tolerance, source, options);
  return shape.document;
}

std::vector<ImportedShape> all_shapes(const std::string& text, const std::string& source,
                                      const ShapeOptions& options) {
  Import import = read_text(text, source, options);
  std::optional<double> tolerance;  // the greatest
  for (const ImportedShape& shape : import.shapes)
    if (shape.tolerance) tolerance = std::max(tolerance.value_or(0), *shape.tolerance);
  report(import, tolerance, source, options);
  if (!options.offered && (import.shapes.size() > 1 || import.doubtful))
    say(source, why_asked(import) + "; all shapes are taken");
  return std::move(import.shapes);
}

}  // namespace evenlift::native
