// The kinds of requests that the page's workers answer besides those of docs/requests.md. Each
// function takes the members that its comment names and returns JSON, as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/request.h"

namespace evenlift::view {

// Numbers that come with a request, and go with its answer, as bits instead of text.
std::vector<double>& numbers();

// The host's clock, in milliseconds.
double now();
// The answer to a request that cannot be carried out: {"problem"}, in the reader's language.
std::string problem(std::string_view sentence);
// Hands over a result before the answer.
void report(const std::string& json);

// words: {"English": "translated"}. All later sentences are in these words. {}.
std::string speak(const RequestMembers& members);

// polygon in the thesis's format, settings as lines `name=value`, robots (derive/derive.h)
// from which to go on, or "". {"robots"}, also reported when better ones are found: the best ones,
// empty if there are none, and cut_short, whether a limit of work ended the search. With a capacity, the number of robots needed if any one may fail
// (plan_text()). {"problem"} if a text is invalid.
std::string search(const RequestMembers& members);

// settings as lines, and as numbers the rings (derive/derive.h). The answer's numbers are the
// choice, or none if the object is refused. {}.
std::string choose(const RequestMembers& members);

// set, name, text of a polygon, method or "" for all, the settings minRatio, samples, weight,
// weightUnit, mostTeams and mostBalanced; or problem, why the text could not be read. {"part"}
// (evenlift/experiment/results.h), or {"problem"} if a setting is out of range.
std::string measure(const RequestMembers& members);

// parts, and onePolygon 1 for the results of a single polygon in place of averages over sets.
// The outputs (evenlift/experiment/outputs.h).
std::string results(const RequestMembers& members);

// link, seconds. Compares its teams with the best choice of the same number, within this time:
// {"rows", "said", "pictures"}: rows of name, coverage, loads, form closure and chosen candidates,
// sentences, and a picture of each row as SVG. {"problem"}: why there is nothing to compare.
std::string optimum(const RequestMembers& members);

// link. The loads in each case of loading, for paper: {"said", "table", "svg"}: sentences, the table
// (cases.h), and the picture. {"problem"}: why there is none.
std::string cases(const RequestMembers& members);

// text, tolerance: the greatest distance between curves and edges, or 0 for the default. Reads a
// drawing or a table: {"format", "unit", "notes", "doubtful", "leftOpen", "shapes"}, or
// {"problem"}. In a doubtful drawing, open lines are larger than any shape; leftOpen has them. A
// shape has a name, a description, the tolerance of its curves (or 0), outline and holes for a
// small picture, and its text in the thesis's format, with the link that holds its settings, or "".
std::string shapes(const RequestMembers& members);

// text, tolerance, settings as lines (settings_for_others() of derive/derive.h), which a file's own
// replace; capacity, per_area, thickness and density as typed, or "" (parts.h). Places robots on each
// shape. First reports {"count", "columns"}, the columns' headings, then for each part in the order of
// the text its number, name, width, height, weight (or null), robots, values (or null) and texts of the
// columns, verdict and problem, outline and holes for a small picture, and open, the link or text that
// opens it. {"csv", "notes"}, or {"problem"} if something typed is invalid.
std::string place_parts(const RequestMembers& members);

// link, lesson, the text of a lesson or "" for the main steps: the steps, to be printed
// (handout.cpp).
std::string handout(const RequestMembers& members);

// text. {"rows"} of a QR code's modules, with 1 for dark and 0 for light, without the quiet zone;
// none if the text is too long. The generator chooses version, mask, and the strongest error
// correction that fits it.
std::string qr_code(const RequestMembers& members);

}  // namespace evenlift::view
