// The folder of an experiment. Its subfolder parts/ has a file with the Part (results.h) of each
// finished polygon, and a list of the polygons of each finished shard (shard_list.h).
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
  // Throws Failure if the folder has no subfolder parts/.
  static ExperimentFolder open(const std::string& path);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  // The Part of the entry's polygon, if it is complete and has the entry's fingerprint and these
  // settings; otherwise nullopt.
  std::optional<experiment::Part> find(const experiment::ShardList::Entry& entry,
                                       const experiment::ExperimentSettings& settings) const;
  // Writes a Part completely or not at all. Several threads and programs may call it at the same
  // time for different polygons.
  void keep(const experiment::Part& part) const;

  // Writes the list of a finished shard. Removes lists that cannot be read, and lists from a run
  // with another number of shards.
  void finish(const experiment::ShardList& list) const;
  // The lists of all finished shards. Throws Failure if a list cannot be read.
  std::vector<experiment::ShardList> finished() const;

 private:
  explicit ExperimentFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

// All Parts of a finished run, sorted by set and polygon. Its shards may be in several folders.
// Throws Failure if a shard is missing, unfinished or damaged, or if shards do not belong together.
std::vector<experiment::Part> collect(const std::vector<ExperimentFolder>& folders);

}  // namespace evenlift::native
