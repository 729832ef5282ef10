#include "polygon_files.h"

#include <algorithm>
#include <filesystem>

#include "failure.h"

namespace evenlift::native {
namespace {

namespace fs = std::filesystem;

std::string without_extension(fs::path path) { return path.replace_extension().generic_string(); }

bool is_polygon_file(const fs::path& path) {
  const std::string name = path.filename().string(), extension = path.extension().string();
  return name != "index.txt" && (extension == ".txt" || extension == ".wkt" ||
                                 extension == ".json" || extension == ".geojson");
}

bool hidden(const fs::path& path) {
  const std::string name = path.filename().string();
  return !name.empty() && name[0] == '.';
}

[[noreturn]] void unreadable(const std::string& path, const std::error_code& error) {
  throw Failure{bad_input_status, path, system_message(error)};
}

void add_folder(const std::string& folder, std::vector<PolygonFile>& files) {
  const std::size_t before = files.size();
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error)) {
    const fs::path path = at->path();
    const bool is_folder = at->is_directory(error);
    if (hidden(path)) {
      if (is_folder) at.disable_recursion_pending();
    } else if (!is_folder && is_polygon_file(path)) {
      files.push_back({without_extension(path.lexically_relative(folder)), path.generic_string()});
    }
  }
  if (error) unreadable(folder, error);
  if (files.size() == before)
    throw Failure{bad_input_status, folder,
                  "no polygon in this folder: no file that ends in .txt, .wkt, .json or .geojson"};
}

}  // namespace

std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths) {
  std::vector<PolygonFile> files;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
      unreadable(path, error ? error : std::make_error_code(std::errc::no_such_file_or_directory));
    if (fs::is_directory(status)) {
      add_folder(path, files);
    } else {
      files.push_back({without_extension(fs::path(path).filename()), path});
    }
  }
  std::sort(files.begin(), files.end(), [](const PolygonFile& a, const PolygonFile& b) {
    return a.name != b.name ? a.name < b.name : a.path < b.path;
  });
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].name == files[i - 1].name)
      throw Failure{bad_input_status, files[i].path,
                    "would have the same name, " + files[i].name + ", as " + files[i - 1].path +
                        "; rename one, or give a folder that holds both"};
  return files;
}

}  // namespace evenlift::native
