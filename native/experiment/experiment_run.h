// Measures polygons in several threads and keeps what is finished.
#pragma once

#include <vector>

#include "experiment/experiment_folder.h"
#include "input/failure.h"
#include "input/polygon_files.h"

namespace evenlift::native {

struct RunOutcome {
  std::size_t polygons = 0;      // of this shard
  std::size_t resumed = 0;       // of these, measured in an earlier run
  std::vector<Failure> refused;  // what could not be read, by the polygons' names
};

// Measures the shard's part of all the files, every n-th: first what is largest, in `jobs` threads
// (in WebAssembly one after another). What the folder holds already of the same polygon and
// settings is not measured again. Ends with the shard's list. Throws Failure if the folder cannot
// be written.
RunOutcome run_experiment(const std::vector<PolygonFile>& all, const experiment::Shard& shard,
                          const experiment::ExperimentSettings& settings, unsigned jobs,
                          const ExperimentFolder& folder);

}  // namespace evenlift::native
