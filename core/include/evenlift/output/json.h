// Placements, documents and errors as JSON, in the format that `evenlift place --json` and
// `window.evenlift.state()` promise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/document.h"
#include "evenlift/output/requirements.h"
#include "evenlift/placement.h"
#include "evenlift/result.h"

namespace evenlift {

struct CapacityInJson {
  CapacityPlan plan;
  std::optional<FailurePlan> if_one_fails;  // capacity_in_json() always sets it
};

// Returns the part of placement_json() about capacities, or nothing if no robot has a capacity.
// Without a common capacity, both plans keep their defaults. The cost is that of the plans
// (capacity.h).
std::optional<CapacityInJson> capacity_in_json(const ShownPlacement& of);

// Returns a placement as one JSON object, indented by two spaces, with short arrays on one line,
// and a newline at the end. Numbers have the fewest digits that read back to the same double. The
// bytes are the same on every platform. O(output), plus the costs of model_loads(), robustness(),
// judge() and, if their results are in the text, misfits(), single_failures() and extra_load().
std::string placement_json(const ShownPlacement& of, bool with_candidates,
                           const std::optional<CapacityInJson>& capacity = std::nullopt,
                           bool with_failures = false,
                           const std::vector<Requirement>& requirements = {});

// Returns {"candidates": [{"ends", "ratio", "kind"}]}, as in placement_json(). O(candidates).
std::string candidates_json(const std::vector<Candidate>& candidates);

// Returns a document in the format of placement_json(): the polygon, the centre of mass (null for
// the centroid) and the settings. read_shapes() (import.h) reads the text back. O(output).
std::string document_json(const Document& document);

// Returns {"code", "message", "place"} on one line (docs/requests.md). O(1).
std::string error_json(const InputError& error);

}  // namespace evenlift
