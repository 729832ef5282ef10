// Every number in the text of the thesis's chapter 5 (and of its section 6.1), beside the same
// number for the measured polygons.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

struct Claim {
  std::string section;  // section of the thesis
  std::string what;     // the quantity, and how it is counted if the thesis leaves that open
  std::string thesis;   // the thesis's number; "—" if its text gives none
  std::string ours;     // the same number for the measured polygons; "—" if the data have none
};

// The claims for a set of polygons, from its sorted `results` and their `aggregates`. All sets have
// the same claims in the same order. O(rows).
std::vector<Claim> make_claims(const std::vector<PolygonResult>& results,
                               const std::vector<Aggregate>& aggregates);

struct SetClaims {
  std::string set;
  std::vector<Claim> claims;
};

// A Markdown table with a column for each set. It ends with a newline. O(claims).
std::string claims_markdown(const std::vector<SetClaims>& sets);

// The claims as JSON: {"sets": [names], "rows": [{"section", "what", "thesis", "ours": [one for
// each set]}]}. O(claims).
std::string claims_json(const std::vector<SetClaims>& sets);

}  // namespace evenlift::experiment
