#include "input/polygon_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <tuple>

#include "input/failure.h"

namespace evenlift::native {
namespace {

namespace fs = std::filesystem;

std::string without_extension(fs::path path) { return path.replace_extension().generic_string(); }

bool is_polygon_file(const fs::path& path) {
  const std::string name = path.filename().string(), extension = path.extension().string();
  // Not .csv, in which experiments write results: a table of vertices must be given by itself.
  constexpr std::string_view endings[] = {".txt", ".wkt", ".json", ".geojson", ".svg", ".dxf"};
  return name != "index.txt" &&
         std::find(std::begin(endings), std::end(endings), extension) != std::end(endings);
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

void add_folder(const std::string& folder, std::vector<PolygonFile>& files) {
  const std::size_t before = files.size();
  const std::string set = folder_name(folder);
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error)) {
    const fs::path path = at->path();
    const bool is_folder = at->is_directory(error);
    if (hidden(path)) {
      if (is_folder) at.disable_recursion_pending();
    } else if (!is_folder && is_polygon_file(path)) {
      files.push_back(
          {set, without_extension(path.lexically_relative(folder)), path.generic_string()});
    }
  }
  if (error) unreadable(folder, error);
  if (files.size() == before)
    throw Failure{
        bad_input_status, folder,
        "no polygon in this folder: no file name ends in .txt, .wkt, .json, .geojson, .svg or .dxf"};
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

}  // namespace evenlift::native
