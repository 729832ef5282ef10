#pragma once

#include <vector>

#include "experiment/experiment_folder.h"
#include "input/failure.h"
#include "input/polygon_files.h"

namespace evenlift::native {

struct RunOutcome {
  std::size_t polygons = 0;      // the number in this shard
  std::size_t resumed = 0;       // the number of them that an earlier run measured
  std::vector<Failure> refused;  // why polygons were refused
};

// Measures the files of this shard in `jobs` threads (one shape after another in WebAssembly). If
// there are n shards, each has every n-th file. The largest shapes come first. Skips unchanged
// polygons whose measurements with the same settings are already in the folder. Finally writes the
// shard's list. Throws Failure if the folder cannot be written.
RunOutcome run_experiment(const std::vector<PolygonFile>& all, const experiment::Shard& shard,
                          const experiment::ExperimentSettings& settings, unsigned jobs,
                          const ExperimentFolder& folder);

}  // namespace evenlift::native
