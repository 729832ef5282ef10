// Reads and writes whole files, byte for byte. All functions except is_same_file() and read_file()
// throw Failure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "input/shapes.h"

namespace evenlift::native {

// Below, `file` is a path, "-" for standard input, or a share link.
struct Input {
  std::string source;  // the name in errors: the path, "standard input" or "link"
  Document document;
};
Input read_input(const std::string& file, const ShapeOptions& options);

// One or more shapes of a file; a link has one shape.
struct InputShapes {
  std::string source;
  std::vector<ImportedShape> shapes;
};
InputShapes read_all_shapes(const std::string& file, const ShapeOptions& options = {});

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

}  // namespace evenlift::native
