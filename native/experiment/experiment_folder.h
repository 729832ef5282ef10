// What an experiment keeps in its folder while it runs: DIR/parts, one file for each finished
// polygon, and one for each finished shard that lists its polygons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/results.h"
#include "evenlift/experiment/shard_list.h"

namespace evenlift::native {

class ExperimentFolder {
 public:
  // Makes the folder if there is none. Throws Failure if it cannot.
  static ExperimentFolder create(const std::string& path);
  // A folder that a run has filled; throws Failure if it has no parts.
  static ExperimentFolder open(const std::string& path);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  // The part of a polygon, if it is there, whole, and of this fingerprint and these settings.
  std::optional<experiment::Part> find(const experiment::ShardList::Entry& entry,
                                       const experiment::ExperimentSettings& settings) const;
  // Writes a part, whole or not at all. Safe for several threads and programs at once.
  void keep(const experiment::Part& part) const;

  // Notes that a shard is done. Notes about another division of the work no longer count.
  void finish(const experiment::ShardList& list) const;
  // The finished shards. Throws Failure if a list cannot be read.
  std::vector<experiment::ShardList> finished() const;

 private:
  explicit ExperimentFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

// All parts of a finished run, by set and polygon, from one folder or from those of its shards.
// Throws Failure if a shard is missing or not finished, or shards do not belong together.
std::vector<experiment::Part> collect(const std::vector<ExperimentFolder>& folders);

}  // namespace evenlift::native
