// Placements, documents and errors as JSON, in the format that `evenlift place --json` and
// `window.evenlift.state()` promise.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/cases.h"
#include "evenlift/document.h"
#include "evenlift/output/requirements.h"
#include "evenlift/result.h"

namespace evenlift {

// Returns a placement as one JSON object, indented by two spaces, with short arrays on one line,
// and a newline at the end. Numbers have the fewest digits that read back to the same double. The
// bytes are the same on every platform. Loads by models (Asked::models) must be known, and so must
// failures if the text is to have them. Plans are in the text if they are known. O(output).
// `beside` is what happened before: which supports were evened out, and what was left out of the
// input; and the cases of loading.
struct Beside {
  std::optional<std::vector<SupportMove>> evened_out;
  std::optional<std::vector<LoadCase>> cases;  // load_cases() (cases.h), if asked for
  std::vector<std::string> notices;
};
std::string placement_json(const Reported& of, bool with_candidates, bool with_failures,
                           const std::vector<Requirement>& requirements = {},
                           const Beside& beside = {});

// The member `cases` of placement_json(). O(cases).
std::string cases_json(const std::vector<LoadCase>& cases);

// The same with a report of its own, which costs as much as report_of().
std::string placement_json(const ShownPlacement& of, bool with_candidates, Asked asked = {});

// Returns {"candidates": [{"ends", "ratio", "kind"}]}, as in placement_json(). O(candidates).
std::string candidates_json(const std::vector<Candidate>& candidates,
                            const std::vector<std::string>& notices = {});

// Returns a document in the format of placement_json(): the polygon, the centre of mass (null for
// the centroid) and the settings. read_shapes() (import.h) reads the text back. O(output).
std::string document_json(const Document& document);

// Returns {"code", "message", "place", "path"} on one line (docs/requests.md). O(1).
std::string error_json(const InputError& error);

// The version of evenlift, such as "2.0.0".
std::string_view version();

}  // namespace evenlift
