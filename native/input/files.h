// Reads and writes whole files, byte for byte.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "input/shapes.h"

namespace evenlift::native {

// The contents of FILE, which is a path, "-" for standard input, or a share link. Throws Failure.
struct Input {
  std::string source;  // its name in errors: the path, "standard input" or "link"
  Document document;
};
Input read_input(const std::string& file, const ShapeOptions& options);

// All shapes in FILE, one or more; a link has one. Throws Failure.
struct InputShapes {
  std::string source;
  std::vector<ImportedShape> shapes;
};
InputShapes read_all_shapes(const std::string& file, const ShapeOptions& options = {});

// Standard input to its end, cut off after max_text_bytes + 1. Throws Failure.
std::string read_standard_input();

// The contents of a file, cut off after max_text_bytes + 1; nothing if it cannot be read.
std::optional<std::string> read_file(const std::string& path);

// Whether both paths lead to the same regular file; the first may also be "-" for standard input.
bool is_same_file(const std::string& a, const std::string& b);

// Checks that an option can write to a path: the path is not "-", which is only for reading, and
// not the input file. Throws Failure with the option's name otherwise.
void check_output_file(const std::string& option, const std::string& path,
                       const std::string& input);

// Replaces the file by `text` or leaves it unchanged: writes a file beside it and renames that.
// Writes directly to a file that is not regular (a pipe, /dev/stdout). Throws Failure.
void write_file(const std::string& path, std::string_view text);

// Writes to standard output. Throws Failure; a silent one if the pipe is broken, since a reader may
// stop early.
void write_output(std::string_view text);

}  // namespace evenlift::native
