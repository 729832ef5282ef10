// From a document to a placement, in the one call that programs make.
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
  Points vertices;                     // as given
  Vec2 centre_of_mass = Vec2::Zero();  // as given, or the centroid
  Settings settings;                   // as given
  std::vector<Candidate> candidates;   // in candidate order; found with every method
  std::uint32_t requested_teams = 0;   // as given; for "max" the number of candidates
  std::vector<Team> teams;             // in the order of choice; perhaps fewer than requested
  std::vector<std::uint32_t> team_candidates;  // the index of each team's candidate; empty if the
                                               // method does not choose among candidates
  Points lifting_base;               // corners of H, counter-clockwise; none without teams
  double coverage = 0;               // see stability.h
  std::optional<LoadSummary> loads;  // none without teams
  Closure closure;
};

// Checks that settings are in their ranges (settings_text.h) and that "max" is used only with a
// method that chooses among candidates. The error's place names the setting. O(1).
std::optional<InputError> check_settings(const Settings& settings);

// Checks the document and computes everything that is reported about it. The same document gives
// the same bits on every platform. O(n log n + K log K) for K edge-pairs, besides the cost of the
// selection (selection.h).
Result<Placement> place(const Document& document);

}  // namespace evenlift
