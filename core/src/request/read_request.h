// Reads a request from JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/experiment/measure.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/requirements.h"
#include "evenlift/result.h"

namespace evenlift {

enum class Command : std::uint8_t { place, candidates, svg, poses, link, experiment, version };

// A polygon of an experiment. If `document` is an error, the polygon does not count in the
// averages, and the answer gives the reason.
struct NamedPolygon {
  std::string set, name;
  Result<Document> document;
};

struct Request {
  Command command = Command::place;
  Document document;
  bool candidates = false, failures = false, even_out = false;
  std::vector<Condition> conditions;
  PoseFormat pose_format = PoseFormat::json;
  PoseOptions poses;
  std::vector<NamedPolygon> polygons;
  experiment::ExperimentSettings experiment;
};

// Members that the command does not have are errors, so that no mistyped name goes unnoticed. The
// geometry is not checked. O(bytes).
Result<Request> read_request(std::string_view text);

}  // namespace evenlift
