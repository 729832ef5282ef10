// DIR/parts has one file for each finished polygon, and one for each finished shard, which lists
// its polygons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/results.h"
#include "evenlift/experiment/shard_list.h"

namespace evenlift::native {

class ExperimentFolder {
 public:
  // Makes the folder if necessary, or throws Failure.
  static ExperimentFolder create(const std::string& path);
  // Throws Failure if the folder has no parts of a run.
  static ExperimentFolder open(const std::string& path);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  // The part of a polygon if it is complete, and has this fingerprint and these settings.
  std::optional<experiment::Part> find(const experiment::ShardList::Entry& entry,
                                       const experiment::ExperimentSettings& settings) const;
  // Completely or not at all; safe for several threads and programs at once.
  void keep(const experiment::Part& part) const;

  // Records of another division of the work no longer count.
  void finish(const experiment::ShardList& list) const;
  // Throws Failure if a list cannot be read.
  std::vector<experiment::ShardList> finished() const;

 private:
  explicit ExperimentFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

// All parts of a finished run, by set and polygon, from the folder or folders of its shards. Throws
// Failure if a shard is missing or unfinished, or if shards do not belong together.
std::vector<experiment::Part> collect(const std::vector<ExperimentFolder>& folders);

}  // namespace evenlift::native
