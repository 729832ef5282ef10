#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "experiment/experiment_folder.h"
#include "input/command_line.h"
#include "input/files.h"

namespace evenlift::native {

struct MeasuredPolygon {
  std::string set;
  std::string name;    // PolygonFile::name, and the shape's number if there are several: "gear 2"
  std::string source;  // names the shape in errors: the file's path, and the shape's number
  Document document;
  std::optional<Failure> refused;  // why the file cannot be read; the document is then empty
};

// Returns all shapes, in the order of the files. Prints notes on standard error, one per line: what
// it leaves out, and which files have several shapes. Throws Failure if two shapes of a set have
// the same name. O(bytes + k log k) for k shapes.
std::vector<MeasuredPolygon> read_polygons(const std::vector<PolygonFile>& files);

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
