// Files, and the shapes in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/import.h"
#include "input/command_line.h"

namespace evenlift::native {

// --- Selects the shapes of a file, and reports how they are read.

struct ShapeOptions {
  std::optional<std::string> shape, flatten, join, holes;
  bool project = false;
  bool offered = false;  // whether the command has these options

  void declare(CommandLine& line);
  // Whether the shapes keep their holes. Throws Failure if --holes is neither yes nor no.
  bool keeps_holes() const;
  // Whether --shape is "all". Only `evenlift place` then takes all shapes; for other commands, the
  // word is a shape's name.
  bool selects_all() const { return shape == "all"; }
};

// --- Reads and writes whole files, byte for byte. All functions except is_same_file() and read_file()
// throw Failure.

// Below, `file` is a path, "-" for standard input, or a share link.
struct Input {
  std::string source;  // the name in errors: the path, "standard input" or "link"
  Document document;
  bool y_down = false;                              // y points down in the file, an SVG
  std::vector<std::size_t> lines_of_supports = {};  // in their file, if they come from one
};
Input read_input(const std::string& file, const ShapeOptions& options);

// One or more shapes of a file; a link has one shape.
struct InputShapes {
  std::string source;
  std::vector<ImportedShape> shapes;
  bool y_down = false;
};
InputShapes read_all_shapes(const std::string& file, const ShapeOptions& options = {});

// Returns the selected shape, or the only one. Reports on standard error what was left out and how
// the text was read, one line each. Throws Failure if the text or an option is invalid. The user
// must select a shape if there are several, or if open lines that were left out span more than any
// shape; without a selection, throws a Failure that lists the shapes.
Input choose_shape(const std::string& text, const std::string& source, const ShapeOptions& options);

// Returns all shapes. Reports the same as choose_shape(). If choose_shape() would require a
// selection but the command has no option for it, also reports that all shapes are taken. Throws
// Failure if the text or an option is invalid.
InputShapes all_shapes(const std::string& text, const std::string& source,
                       const ShapeOptions& options);

// Returns the text on standard input, cut off after max_text_bytes + 1 bytes.
std::string read_standard_input();

// Returns the text of a file, cut off in the same way; nullopt if the file cannot be read.
std::optional<std::string> read_file(const std::string& path);

// Whether both paths lead to the same regular file. The first may be "-", for standard input.
bool is_same_file(const std::string& a, const std::string& b);

// Refuses a path that is "-", which is only for reading, or that leads to the input file. The
// Failure names the option.
void check_output_file(const std::string& option, const std::string& path,
                       const std::string& input);

// Creates or replaces a regular file: writes a new file beside the old one, then renames the new
// file. On an error, the old file stays unchanged. Writes directly to any other path, such as a
// pipe or a symbolic link (/dev/stdout).
void write_file(const std::string& path, std::string_view text);

// Writes to standard output. The Failure is silent if the pipe is broken, since a reader may stop
// early.
void write_output(std::string_view text);

struct PolygonFile {
  std::string set;   // the name of the given folder; single_files for a file given directly
  std::string name;  // its path in that folder, or its file name, without the extension
  std::string path;
};

inline constexpr const char* single_files = "files";

// Finds the given files and, in the given folders and their sub-folders, all files whose names end
// in .txt, .csv, .wkt, .json, .geojson, .svg or .dxf. Ignores hidden files and folders, the results of
// experiments, and index.txt, which is a list of contents; says on standard error what else it leaves
// out. Each given folder is a set, and the given files together are another
// set. The result is sorted by set and name. Throws Failure for a missing path, a folder without
// polygon files, two sets with the same name, and two files of a set with the same name.
std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths);

}  // namespace evenlift::native
