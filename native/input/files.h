// Reads and writes whole files, byte for byte. All except is_same_file() and read_file() throw
// Failure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "input/shapes.h"

namespace evenlift::native {

// `file` is a path, "-" for standard input, or a share link.
struct Input {
  std::string source;  // its name in errors: the path, "standard input" or "link"
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

// Whether both lead to the same regular file; the first may be "-".
bool is_same_file(const std::string& a, const std::string& b);

// Refuses "-", which is only for reading, and the path of the input file. The Failure names the
// option.
void check_output_file(const std::string& option, const std::string& path,
                       const std::string& input);

// Replaces the file by one with `text`, or leaves it unchanged: writes a new file beside it, and
// renames that. Writes directly to a file that is not regular (a pipe, /dev/stdout).
void write_file(const std::string& path, std::string_view text);

// Writes to standard output. The Failure is silent if the pipe is broken, since a reader may stop
// early.
void write_output(std::string_view text);

}  // namespace evenlift::native
