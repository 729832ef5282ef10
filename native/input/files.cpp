#include "input/files.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <memory>

#include "evenlift/lesson_link.h"
#include "evenlift/link.h"
#include "input/failure.h"

namespace evenlift::native {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

std::string system_error() { return system_message({errno, std::generic_category()}); }

// Stops soon after the limit; the reader of the text then refuses it.
std::string read_all(std::FILE* file, const std::string& source) {
  std::string text;
  char buffer[1 << 16];
  while (text.size() <= max_text_bytes) {
    const std::size_t count = std::fread(buffer, 1, sizeof buffer, file);
    text.append(buffer, count);
    if (count == sizeof buffer) continue;
    if (std::ferror(file)) throw Failure{bad_input_status, source, system_error()};
    if (std::feof(file)) break;
  }
  return text;
}

bool exists(const std::string& path) {
  struct stat info;
  return stat(path.c_str(), &info) == 0;
}

// A file may be called "1.dat", so any existing path counts as a file.
bool names_link(const std::string& file) {
  return file != "-" && !exists(file) &&
         (looks_like_link(file) || has_lesson_link(file) || file.find('#') != std::string::npos);
}

ImportedShape linked(const std::string& link, const ShapeOptions& options) {
  if (options.project)
    throw Failure{bad_input_status, "--project",
                  "a share link keeps its coordinates, which are no degrees"};
  Result<Document> document = decode_link(link);
  if (!document) throw bad_input("link", document.error());
  std::vector<ImportedShape> shapes = {{*std::move(document), "", "polygon", {}}};
  if (!options.keeps_holes())
    if (const std::string note = leave_out_holes(shapes); !note.empty())
      print_failure({0, "link", note, {}});
  return std::move(shapes.front());
}

struct Source {
  std::string name, text;
};

Source read_source(const std::string& file) {
  if (file.empty()) throw Failure{bad_input_status, "FILE", "its name is empty"};
  if (file == "-") return {"standard input", read_standard_input()};
  const File opened(std::fopen(file.c_str(), "rb"));
  if (!opened) throw Failure{bad_input_status, file, system_error()};
  return {file, read_all(opened.get(), file)};
}

// A pipe may be both read and written.
bool is_same_file(const struct stat& a, const struct stat& b) {
  return S_ISREG(a.st_mode) && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

void write_all(std::FILE* file, std::string_view text, const std::string& name) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (!written || std::fflush(file) != 0) throw Failure{other_status, name, system_error()};
}

}  // namespace

Input read_input(const std::string& file, const ShapeOptions& options) {
  if (names_link(file)) return {"link", linked(file, options).document};
  const Source source = read_source(file);
  return {source.name, choose_shape(source.text, source.name, options)};
}

InputShapes read_all_shapes(const std::string& file, const ShapeOptions& options) {
  if (names_link(file)) return {"link", {linked(file, options)}};
  const Source source = read_source(file);
  return {source.name, all_shapes(source.text, source.name, options)};
}

std::string read_standard_input() { return read_all(stdin, "standard input"); }

std::optional<std::string> read_file(const std::string& path) {
  const File opened(std::fopen(path.c_str(), "rb"));
  if (!opened) return std::nullopt;
  try {
    return read_all(opened.get(), path);
  } catch (const Failure&) {
    return std::nullopt;
  }
}

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat of_a, of_b;
  const int found_a = a == "-" ? fstat(fileno(stdin), &of_a) : stat(a.c_str(), &of_a);
  return found_a == 0 && stat(b.c_str(), &of_b) == 0 && is_same_file(of_a, of_b);
}

void check_output_file(const std::string& option, const std::string& path,
                       const std::string& input) {
  if (path == "-") throw bad_value(option, "expected the name of a file", path);
  if (is_same_file(input, path))
    throw Failure{bad_input_status, option, "would overwrite " + path + ", an input file"};
}

void write_file(const std::string& path, std::string_view text) {
  struct stat info;
  const bool replaceable = lstat(path.c_str(), &info) != 0 || S_ISREG(info.st_mode);
  std::string target = replaceable ? path + ".part" : path;
  File file(std::fopen(target.c_str(), replaceable ? "wbx" : "wb"));
  // A file of this name may already exist.
  for (int i = 2; !file && replaceable && errno == EEXIST && i < 100; ++i) {
    target = path + ".part" + std::to_string(i);
    file.reset(std::fopen(target.c_str(), "wbx"));
  }
  if (!file) throw Failure{other_status, path, system_error()};
  try {
    write_all(file.get(), text, path);
    if (std::fclose(file.release()) != 0) throw Failure{other_status, path, system_error()};
    if (replaceable && std::rename(target.c_str(), path.c_str()) != 0)
      throw Failure{other_status, path, system_error()};
  } catch (const Failure&) {
    if (replaceable) std::remove(target.c_str());
    throw;
  }
}

void write_output(std::string_view text) {
  try {
    write_all(stdout, text, "standard output");
  } catch (const Failure&) {
    if (errno == EPIPE) throw Failure{other_status, "standard output", "", {}, true};
    throw;
  }
}

}  // namespace evenlift::native
