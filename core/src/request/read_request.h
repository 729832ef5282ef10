// A request, read from JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/experiment/measure.h"
#include "evenlift/output/poses.h"
#include "evenlift/result.h"

namespace evenlift {

enum class Command : std::uint8_t { place, candidates, svg, poses, link, experiment, version };

// A polygon of an experiment. One that is no polygon's text is left out of the averages, and why is
// told.
struct NamedPolygon {
  std::string set, name;
  Result<Document> document;
};

struct Request {
  Command command = Command::place;
  Document document;
  bool candidates = false, failures = false;
  PoseFormat pose_format = PoseFormat::json;
  PoseOptions poses;
  std::vector<NamedPolygon> polygons;
  experiment::ExperimentSettings experiment;
};

// Reads a request. Members that its command does not have are errors, so that no typing error goes
// unnoticed. Of the geometry nothing is checked. O(bytes).
Result<Request> read_request(std::string_view text);

}  // namespace evenlift
