// Every number in the text of chapter 5 of the thesis (and in 6.1), with the same number for the
// measured polygons.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

struct Claim {
  std::string section;  // of the thesis
  std::string what;     // and how it is counted if the thesis leaves that open
  std::string thesis;   // "—" if its text gives no number
  std::string ours;     // "—" if the data have none
};

// The claims of one set from its sorted `results` and their `aggregates`: the same for every set,
// in the same order. O(rows).
std::vector<Claim> make_claims(const std::vector<PolygonResult>& results,
                               const std::vector<Aggregate>& aggregates);

struct SetClaims {
  std::string set;
  std::vector<Claim> claims;
};

// A table with a column for each set, ending in a newline. O(claims).
std::string claims_markdown(const std::vector<SetClaims>& sets);

// {"sets": [names], "rows": [{"section", "what", "thesis", "ours": [of each set]}]} O(claims).
std::string claims_json(const std::vector<SetClaims>& sets);

}  // namespace evenlift::experiment
