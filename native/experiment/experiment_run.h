// Runs an experiment over a folder, and writes its report.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/experiment/outputs.h"
#include "evenlift/experiment/results.h"
#include "evenlift/experiment/shard_list.h"
#include "input/command_line.h"
#include "input/files.h"

namespace evenlift::native {

// --- The folder of an experiment. Its subfolder parts/ has a file with the Part (results.h) of each
// finished polygon, and a list of the polygons of each finished shard (shard_list.h).

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

// --- An experiment's report as one HTML file, which works without a network. It contains the thesis's
// figures redrawn, results for few robots, and a table of the thesis's claims with our results.

// Returns the report. The same data gives the same bytes. If the program was built without charts,
// the report has tables and a notice instead of charts.
std::string report_html(const std::vector<experiment::ResultSet>& sets,
                        const experiment::Outputs& outputs,
                        const experiment::ExperimentSettings& settings);

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
//
// `loading` sets the weight and the cargo of each polygon.
using Loading = std::function<void(Document&)>;
RunOutcome run_experiment(const std::vector<PolygonFile>& all, const Loading& loading,
                          const experiment::Shard& shard,
                          const experiment::ExperimentSettings& settings, unsigned jobs,
                          const ExperimentFolder& folder);

}  // namespace evenlift::native
