#pragma once

#include <vector>

#include "experiment/experiment_folder.h"
#include "input/failure.h"
#include "input/polygon_files.h"

namespace evenlift::native {

struct RunOutcome {
  std::size_t polygons = 0;      // of this shard
  std::size_t resumed = 0;       // of these, in an earlier run
  std::vector<Failure> refused;  // polygons that could not be read
};

// Measures this shard's files, every n-th of all, the largest shapes first, in `jobs` threads (one
// after another in WebAssembly). Skips polygons that the folder contains with the same settings.
// Finally writes the shard's list. Throws Failure if the folder cannot be written.
RunOutcome run_experiment(const std::vector<PolygonFile>& all, const experiment::Shard& shard,
                          const experiment::ExperimentSettings& settings, unsigned jobs,
                          const ExperimentFolder& folder);

}  // namespace evenlift::native
