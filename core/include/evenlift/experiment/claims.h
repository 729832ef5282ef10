// Every number that the text of the thesis's chapter 5 (and its repetition in 6.1) states, next to
// the same number on the measured polygons.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift {

struct Claim {
  std::string section;  // of the thesis
  std::string what;     // what is counted, and how where the thesis leaves it open
  std::string thesis;   // what it states; "—" where the text gives no number for this one
  std::string ours;     // the same from the data; "—" where the data have none
};

// `results` sorted, `aggregates` of them. O(rows).
std::vector<Claim> make_claims(const std::vector<PolygonResult>& results,
                               const std::vector<Aggregate>& aggregates);

// A table in Markdown, ending in a newline. O(claims).
std::string claims_markdown(const std::vector<Claim>& claims);

// [{"section", "what", "thesis", "ours"}] O(claims).
std::string claims_json(const std::vector<Claim>& claims);

}  // namespace evenlift
