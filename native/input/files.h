// Reading and writing whole files, byte for byte.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "input/shapes.h"

namespace evenlift::native {

// The contents of FILE, which is a path, "-" for standard input, or a share link. Throws Failure.
struct Input {
  std::string source;  // what to call it in an error: the path, "standard input" or "link"
  Document document;
};
Input read_input(const std::string& file, const ShapeOptions& options = {});

// The contents of a file, cut after max_text_bytes + 1; nothing if it cannot be read.
std::optional<std::string> read_file(const std::string& path);

// Whether two paths lead to one regular file, of which the first may also be "-" for standard
// input.
bool is_same_file(const std::string& a, const std::string& b);

// Whether an option can write to a path: it is not "-", which is a file to read only, and it is not
// the file that is read. Throws Failure naming the option if not.
void check_output_file(const std::string& option, const std::string& path,
                       const std::string& input);

// Replaces the file by `text` or leaves it as it was: writes beside it and renames. What is no
// regular file (a pipe, /dev/stdout) is written to directly. Throws Failure.
void write_file(const std::string& path, std::string_view text);

// Writes to standard output. Throws Failure, a silent one if nobody reads any more (a broken pipe),
// which is nothing to complain about.
void write_output(std::string_view text);

}  // namespace evenlift::native
