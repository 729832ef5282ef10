#include "input/files.h"

#include <sys/stat.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string_view>
#include <tuple>

#include "evenlift/lesson_link.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "input/command_line.h"

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
  return choose_shape(source.text, source.name, options);
}

InputShapes read_all_shapes(const std::string& file, const ShapeOptions& options) {
  if (names_link(file)) return {"link", {linked(file, options)}};
  const Source source = read_source(file);
  return all_shapes(source.text, source.name, options);
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

namespace {

namespace fs = std::filesystem;

std::string without_extension(fs::path path) { return path.replace_extension().generic_string(); }

bool is_polygon_file(const fs::path& path) {
  const std::string name = path.filename().string(), extension = path.extension().string();
  constexpr std::string_view endings[] = {".txt",     ".csv", ".wkt", ".json",
                                          ".geojson", ".svg", ".dxf"};
  return name != "index.txt" &&
         std::find(std::begin(endings), std::end(endings), extension) != std::end(endings);
}

// Whether an experiment wrote it: its tables stand together, its parts in a folder of their own.
bool is_result(const fs::path& path) {
  const std::string name = path.filename().string();
  const fs::path folder = path.parent_path();
  if (folder.filename() == "parts")
    return name.starts_with("polygon-") || name.starts_with("shard-");
  std::error_code error;
  for (const char* written : {"measurements.csv", "aggregates.csv", "polygons.csv", "times.csv",
                              "thesis.md", "robots.md", "report.html"})
    if (name == written) return fs::exists(folder / "measurements.csv", error);
  return false;
}

bool hidden(const fs::path& path) {
  const std::string name = path.filename().string();
  return !name.empty() && name[0] == '.';
}

[[noreturn]] void unreadable(const std::string& path, const std::error_code& error) {
  throw Failure{bad_input_status, path, system_message(error)};
}

// The last part in any spelling: "a/b/" and "a/b/." are b.
std::string folder_name(const std::string& folder) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  if (error) unreadable(folder, error);
  const fs::path last = whole.filename().empty() ? whole.parent_path() : whole;
  return last.filename().empty() ? last.generic_string() : last.filename().generic_string();
}

// Says what a folder has besides polygons.
void tell_left_out(const std::string& folder, std::vector<std::string> names) {
  constexpr std::size_t most_named = 5;
  if (names.empty()) return;
  std::sort(names.begin(), names.end());
  std::string text = names.size() == 1 ? "1 file was left out: "
                                       : std::to_string(names.size()) + " files were left out: ";
  for (std::size_t i = 0; i < names.size() && i < most_named; ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most_named) text += " …";
  print_failure({0, folder, text, {}});
}

void add_folder(const std::string& folder, std::vector<PolygonFile>& files) {
  const std::size_t before = files.size();
  const std::string set = folder_name(folder);
  std::vector<std::string> left_out;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error)) {
    const fs::path path = at->path();
    const bool is_folder = at->is_directory(error);
    if (hidden(path)) {
      if (is_folder) at.disable_recursion_pending();
    } else if (!is_folder && is_polygon_file(path) && !is_result(path)) {
      files.push_back(
          {set, without_extension(path.lexically_relative(folder)), path.generic_string()});
    } else if (!is_folder && path.filename() != "index.txt" && !is_result(path)) {
      left_out.push_back(path.lexically_relative(folder).generic_string());
    }
  }
  if (error) unreadable(folder, error);
  if (files.size() == before)
    throw Failure{
        bad_input_status, folder,
        "no polygon in this folder: no file name ends in .txt, .csv, .wkt, .json, .geojson, .svg or .dxf"};
  tell_left_out(folder, std::move(left_out));
}

// The folder's name identifies its set.
void check_set_names(const std::vector<std::string>& folders, bool with_files) {
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string set = folder_name(folders[i]);
    if (with_files && set == single_files)
      throw Failure{
          bad_input_status, folders[i],
          "would be a set with the same name, files, as the files given directly; rename the folder"};
    for (std::size_t j = 0; j < i; ++j)
      if (folder_name(folders[j]) == set)
        throw Failure{bad_input_status, folders[i],
                      "would be a set with the same name, " + set + ", as " + folders[j] +
                          "; rename one, or give a folder that contains both"};
  }
}

}  // namespace

std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths) {
  std::vector<PolygonFile> files;
  std::vector<std::string> folders;
  for (const std::string& path : paths) {
    if (path.empty()) throw Failure{bad_input_status, "PATH", "its name is empty"};
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
      unreadable(path, error ? error : std::make_error_code(std::errc::no_such_file_or_directory));
    if (fs::is_directory(status)) {
      folders.push_back(path);
      add_folder(path, files);
    } else {
      files.push_back({single_files, without_extension(fs::path(path).filename()), path});
    }
  }
  check_set_names(folders, folders.size() < paths.size());
  std::sort(files.begin(), files.end(), [](const PolygonFile& a, const PolygonFile& b) {
    return std::tie(a.set, a.name, a.path) < std::tie(b.set, b.name, b.path);
  });
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].set == files[i - 1].set && files[i].name == files[i - 1].name)
      throw Failure{bad_input_status, files[i].path,
                    "would have the same name, " + files[i].name + ", as " + files[i - 1].path +
                        "; rename one, or give a folder that contains both"};
  return files;
}

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

Import read_text(const std::string& text, const std::string& source, const ShapeOptions& options) {
  Result<Import> read = read_shapes(text, import_options(options));
  if (!read) throw bad_input(source, read.error());
  return std::move(read).value();
}

bool has_y_down(const Import& import) { return import.format == "SVG"; }

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

Input choose_shape(const std::string& text, const std::string& source,
                   const ShapeOptions& options) {
  const Import import = read_text(text, source, options);
  const Result<std::size_t> chosen = evenlift::choose_shape(import, options.shape);
  const bool is_list_of_use = !chosen && chosen.error().code == ErrorCode::unsupported;
  if (!chosen && options.shape)
    throw Failure{bad_input_status, "--shape", chosen.error().message,
                  is_list_of_use ? listed(import.shapes) : std::vector<std::string>()};
  if (!chosen)
    throw Failure{bad_input_status, source, chosen.error().message + "; --shape N selects one",
                  listed(import.shapes)};
  const ImportedShape& shape = import.shapes[*chosen];
  report(import, shape.tolerance, source, options);
  return {source, shape.document, has_y_down(import)};
}

InputShapes all_shapes(const std::string& text, const std::string& source,
                       const ShapeOptions& options) {
  Import import = read_text(text, source, options);
  std::optional<double> tolerance;  // the greatest
  for (const ImportedShape& shape : import.shapes)
    if (shape.tolerance) tolerance = std::max(tolerance.value_or(0), *shape.tolerance);
  report(import, tolerance, source, options);
  import.shapes.resize(count_parts(import));
  const Result<std::size_t> only = evenlift::choose_shape(import, std::nullopt);
  if (!options.offered && !only) say(source, only.error().message + "; all shapes are taken");
  return {source, std::move(import.shapes), has_y_down(import)};
}

}  // namespace evenlift::native
