// Every number that the text of the thesis's chapter 5 (and its repetition in 6.1) states, next to
// the same number on the measured polygons.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

struct Claim {
  std::string section;  // of the thesis
  std::string what;     // what is counted, and how where the thesis leaves it open
  std::string thesis;   // what it states; "—" where the text gives no number for this one
  std::string ours;     // the same from the data; "—" where the data have none
};

// Of one set: `results` sorted, `aggregates` of them. The same claims in the same order for every
// set. O(rows).
std::vector<Claim> make_claims(const std::vector<PolygonResult>& results,
                               const std::vector<Aggregate>& aggregates);

// The claims of one set.
struct SetClaims {
  std::string set;
  std::vector<Claim> claims;
};

// A table in Markdown with a column for each set, ending in a newline. O(claims).
std::string claims_markdown(const std::vector<SetClaims>& sets);

// {"sets": [names], "rows": [{"section", "what", "thesis", "ours": [of each set]}]} O(claims).
std::string claims_json(const std::vector<SetClaims>& sets);

}  // namespace evenlift::experiment
