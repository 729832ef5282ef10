// The list of the polygons in a finished shard of an experiment, read when shards are merged.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/experiment/results.h"

namespace evenlift::experiment {

// A shard is part i of n equal parts of an experiment, 1 <= i <= n <= max_shards.
inline constexpr std::uint32_t max_shards = 100000;
struct Shard {
  std::uint32_t i = 1, n = 1;
  bool operator==(const Shard&) const = default;
};

struct ShardList {
  Shard shard;
  ExperimentSettings settings;
  struct Entry {
    std::string set, polygon, fingerprint;  // as in the polygon's `Part` (results.h)
  };
  std::vector<Entry> entries;
};

// Write and read a list as text. read_shard_list() returns nothing for a text that is not such a
// list. O(entries).
std::string write_shard_list(const ShardList& list);
std::optional<ShardList> read_shard_list(std::string_view text);

}  // namespace evenlift::experiment
