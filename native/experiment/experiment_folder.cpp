#include "experiment/experiment_run.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "input/command_line.h"
#include "input/files.h"

namespace evenlift::native {
namespace {

namespace fs = std::filesystem;

// Unique: each byte becomes %XX unless it is a letter, a digit or a sign that every system
// accepts. Very long names keep their beginning, with a fingerprint to distinguish them.
std::string file_name(const std::string& polygon) {
  std::string out;
  for (const char c : polygon) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == ' ';
    if (plain) {
      out += c;
    } else {
      (out += '%') += {"0123456789ABCDEF"[byte >> 4], "0123456789ABCDEF"[byte & 15]};
    }
  }
  constexpr std::size_t longest = 180;
  if (out.size() > longest) out = out.substr(0, longest) + "%" + experiment::fingerprint(polygon);
  return out + ".csv";
}

std::string parts(const std::string& folder) { return folder + "/parts"; }

std::string part_path(const std::string& folder, const std::string& set,
                      const std::string& polygon) {
  return parts(folder) + "/polygon-" + file_name(set + "/" + polygon);
}

std::string shard_name(const experiment::Shard& shard) {
  return "shard-" + std::to_string(shard.i) + "-of-" + std::to_string(shard.n) + ".csv";
}

// Finished shards, in a fixed order.
std::vector<fs::path> shard_files(const std::string& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator at(parts(folder), error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.rfind("shard-", 0) == 0 && at->path().extension() == ".csv")
      paths.push_back(at->path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw Failure{bad_input_status, where, what};
}

}  // namespace

ExperimentFolder ExperimentFolder::create(const std::string& path) {
  std::error_code error;
  fs::create_directories(parts(path), error);
  if (error) throw Failure{other_status, path, system_message(error)};
  return ExperimentFolder(path);
}

ExperimentFolder ExperimentFolder::open(const std::string& path) {
  if (path.empty()) refuse("PATH", "its name is empty");
  std::error_code error;
  if (!fs::is_directory(parts(path), error))
    refuse(path, "no experiment has run here: there is no folder " + parts(path));
  return ExperimentFolder(path);
}

std::optional<experiment::Part> ExperimentFolder::find(
    const experiment::ShardList::Entry& entry,
    const experiment::ExperimentSettings& settings) const {
  const std::optional<std::string> text = read_file(part_path(path_, entry.set, entry.polygon));
  std::optional<experiment::Part> part = text ? experiment::read_part(*text) : std::nullopt;
  if (!part || part->result.set != entry.set || part->result.polygon != entry.polygon ||
      part->fingerprint != entry.fingerprint || part->settings != settings)
    return std::nullopt;
  return part;
}

void ExperimentFolder::keep(const experiment::Part& part) const {
  write_file(part_path(path_, part.result.set, part.result.polygon), experiment::write_part(part));
}

void ExperimentFolder::finish(const experiment::ShardList& list) const {
  for (const fs::path& path : shard_files(path_)) {
    const std::optional<experiment::ShardList> other =
        experiment::read_shard_list(read_file(path.string()).value_or(""));
    std::error_code ignored;
    if (!other || other->shard.n != list.shard.n) fs::remove(path, ignored);
  }
  write_file(parts(path_) + "/" + shard_name(list.shard), experiment::write_shard_list(list));
}

std::vector<experiment::ShardList> ExperimentFolder::finished() const {
  std::vector<experiment::ShardList> lists;
  for (const fs::path& path : shard_files(path_)) {
    std::optional<experiment::ShardList> list =
        experiment::read_shard_list(read_file(path.string()).value_or(""));
    if (!list) refuse(path.string(), "this is not a list of a finished shard");
    lists.push_back(*std::move(list));
  }
  return lists;
}

std::vector<experiment::Part> collect(const std::vector<ExperimentFolder>& folders) {
  struct Found {
    const ExperimentFolder* folder;
    experiment::ShardList list;
  };
  std::map<std::uint32_t, Found> shards;  // by i
  for (const ExperimentFolder& folder : folders)
    for (experiment::ShardList& list : folder.finished()) {
      const experiment::Shard shard = list.shard;
      if (!shards.empty() && (shard.n != shards.begin()->second.list.shard.n ||
                              list.settings != shards.begin()->second.list.settings))
        refuse(folder.path(), "its shards do not match the shards of " +
                                  shards.begin()->second.folder->path() +
                                  ": their number or settings differ");
      shards.insert_or_assign(shard.i, Found{&folder, std::move(list)});
    }
  if (shards.empty()) refuse(folders.front().path(), "no shard is finished here");

  const std::uint32_t n = shards.begin()->second.list.shard.n;
  std::map<std::pair<std::string, std::string>, experiment::Part> all;  // by set and polygon
  for (std::uint32_t i = 1; i <= n; ++i) {
    const auto shard = shards.find(i);
    if (shard == shards.end())
      refuse("shard " + std::to_string(i) + "/" + std::to_string(n), "missing or not finished");
    const auto& [folder, list] = shard->second;
    for (const experiment::ShardList::Entry& entry : list.entries) {
      std::optional<experiment::Part> part = folder->find(entry, list.settings);
      if (!part)
        refuse(folder->path(), "the measurements of " + entry.polygon +
                                   " are missing or damaged; run its shard again");
      if (!all.emplace(std::pair(entry.set, entry.polygon), *std::move(part)).second)
        refuse(folder->path(), entry.polygon + " was also measured in another shard");
    }
  }
  std::vector<experiment::Part> sorted;
  for (auto& [polygon, part] : all) sorted.push_back(std::move(part));
  return sorted;
}

}  // namespace evenlift::native
