// A Placement in the shape that `evenlift place --json` and `window.evenlift.state()` promise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/document.h"
#include "evenlift/placement.h"

namespace evenlift {

// What one robot can carry, and what follows from it.
struct CapacityInJson {
  double limit = 0;
  CapacityPlan plan;
  std::optional<FailurePlan> if_one_fails;  // if it was asked for
};

// One JSON object, two-space indented, short arrays on one line, ending in a newline; numbers have
// the fewest digits that read back to the same double; the same bytes on every platform. O(output),
// besides the costs of placed_robots.h: of model_loads and robustness always, of the others if
// asked for.
std::string placement_json(const ShownPlacement& of, bool with_candidates,
                           const std::optional<CapacityInJson>& capacity = std::nullopt,
                           bool with_failures = false);

// {"candidates": [{"ends", "ratio", "kind"}]}: the candidates by themselves, with the layout of
// placement_json. O(candidates).
std::string candidates_json(const std::vector<Candidate>& candidates);

// What a link holds, with the layout of placement_json: the polygon, the centre of mass, null if it
// is the centroid, and the settings. read_shapes() (import.h) reads it again. O(output).
std::string document_json(const Document& document);

}  // namespace evenlift
