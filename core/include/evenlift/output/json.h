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
  std::optional<FailurePlan> if_one_fails;  // if requested
};

// Nothing if no robot has a capacity. Costs as much as the plans (capacity.h).
std::optional<CapacityInJson> capacity_in_json(const ShownPlacement& of);

// One object, indented by two spaces, short arrays on one line, ending in a newline. Numbers have
// the fewest digits that read back to the same double. The bytes are the same on every platform.
// O(output), plus the costs of placed_robots.h: of model_loads and robustness always, of the others
// if requested.
std::string placement_json(const ShownPlacement& of, bool with_candidates,
                           const std::optional<CapacityInJson>& capacity = std::nullopt,
                           bool with_failures = false,
                           const std::vector<Requirement>& requirements = {});

// {"candidates": [{"ends", "ratio", "kind"}]}, as in placement_json. O(candidates).
std::string candidates_json(const std::vector<Candidate>& candidates);

// The content of a link, as in placement_json: the polygon, the centre of mass (null for the
// centroid) and the settings. read_shapes() (import.h) reads it back. O(output).
std::string document_json(const Document& document);

// {"code", "message", "place"} on one line (docs/requests.md). O(1).
std::string error_json(const InputError& error);

}  // namespace evenlift
