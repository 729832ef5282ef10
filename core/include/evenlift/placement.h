// From a polygon to a placement: the one call that programs make.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/closure.h"
#include "evenlift/document.h"
#include "evenlift/loads.h"
#include "evenlift/result.h"
#include "evenlift/stability.h"

namespace evenlift {

struct Placement {
  Points vertices;  // as given
  Vec2 centre_of_mass = Vec2::Zero();
  Settings settings;                  // as used
  std::vector<Candidate> candidates;  // in candidate order, for every metric
  std::uint32_t requested_teams = 0;  // with "max" the number of candidates
  std::vector<Team> teams;            // in the order selected
  std::vector<std::int64_t>
      team_candidates;  // for each team its candidate's index, -1 if it took none
  Points lifting_base;  // corners of H, counter-clockwise; empty with no team
  double coverage = 0;
  std::optional<LoadSummary> loads;
  Closure closure;
};

// Whether settings are in their ranges (settings_text.h), and "max" only with a metric that selects
// among candidates. The error's place names the setting. O(1).
std::optional<InputError> check_settings(const Settings& settings);

// Validates the document and computes everything that is reported of it. The same document gives
// the same bits on every platform. O(n log n + K log K) for K edge-pairs plus the cost of the
// selection (selection.h).
Result<Placement> place(const Document& document);

}  // namespace evenlift
