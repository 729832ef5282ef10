// The measurements of many polygons as CSV, and the part files from which an interrupted or divided
// run is assembled.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/experiment/measure.h"

namespace evenlift::experiment {

struct PolygonResult {
  std::string set;      // the set of polygons with which this one is averaged
  std::string polygon;  // unique in its set
  std::string problem;  // the reason why the polygon was refused, or empty
  std::uint32_t vertices = 0;
  bool convex = false;
  std::uint32_t candidates = 0;           // the most teams that the algorithm can place
  std::vector<Measurement> measurements;  // sorted by method, then by robots
  bool operator==(const PolygonResult&) const = default;
};

// The seconds that each stage of a polygon took. A stage is "candidates" or a method's name.
using Times = std::vector<std::pair<std::string, double>>;

// 16 hexadecimal digits that differ for different texts, except by chance (FNV-1a, 64 bits).
// O(bytes).
std::string fingerprint(std::string_view bytes);

// The fingerprint of the settings and of the document's outline, holes, centre of mass, cargo and, if
// it counts, weight.
// O(n).
std::string fingerprint(const Document& document, const ExperimentSettings& settings);

// Replaces the fingerprint of a polygon that was refused or could not be read.
inline constexpr const char* refused_fingerprint = "refused";

// The polygon's result, still without measurements. O(1).
PolygonResult result_of(const std::string& set, const std::string& polygon, const Subject& subject);

// Sorts by set, then by polygon, both by their bytes. O(n log n).
void sort_results(std::vector<PolygonResult>& results);

// The results of one set, sorted by polygon.
struct ResultSet {
  std::string name;
  std::vector<PolygonResult> results;
};

// Divides sorted results into sets and keeps their order. O(n).
std::vector<ResultSet> group_by_set(std::vector<PolygonResult> results);

// A polygon that is finished: measured or refused. write_part() returns it as a text, which ends
// with a newline. O(rows).
struct Part {
  ExperimentSettings settings;
  std::string fingerprint;  // of the polygon's input
  PolygonResult result;
  Times times;
  bool operator==(const Part&) const = default;
};
std::string write_part(const Part& part);

// Reads a text that write_part() returned. Returns nothing for any other text. O(bytes).
std::optional<Part> read_part(std::string_view text);

// One row for each set, polygon, method and number of robots, in that order, under a heading. The
// columns are the set, the polygon, the number of teams and the fields of Measurement, of which
// `chosen` and `after_failure` may be empty; those of failures are there only if they were measured. Numbers have the fewest digits that read back to the same double. O(rows).
std::string measurements_csv(const std::vector<ResultSet>& sets);

// One row for each polygon: its number of vertices, whether it is convex, and the number of teams
// that the algorithm can place. If the polygon was refused, its row has the reason instead.
// O(polygons).
std::string polygons_csv(const std::vector<ResultSet>& sets);

// One row for each polygon and stage, with its seconds.
std::string times_csv(const std::vector<Part>& parts);

}  // namespace evenlift::experiment
