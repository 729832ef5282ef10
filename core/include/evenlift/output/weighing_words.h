// What a weighing found, how much of each robot is used, and the cases of loading, in words.
#pragma once

#include <string>
#include <vector>

#include "evenlift/cases.h"
#include "evenlift/output/words.h"
#include "evenlift/report.h"

namespace evenlift {

// "Weighed: 480 kg, C at (333, 446), known within 4.", and what follows from a second weighing and
// from readings that do not fit equally stiff supports. Empty without readings. O(m).
std::string weighing_in_words(const Reported& of);

// Only the first sentence. O(1).
std::string weighed_in_words(const Reported& of);

// Only what is said of readings that do not fit; empty if they fit, or without readings. O(m).
std::string misfit_of_readings(const Reported& of);

// "Robot 3 is used to 87 %, with a dynamic factor of 1.2 and a weight that may be off by 5 %." Empty
// if no robot has a capacity, or without loads. O(m).
std::string use_in_words(const Reported& of);

// A share of a capacity, rounded up, such as "87 %"; "–" if it is not known. O(1).
std::string use_in_words(const std::optional<double>& use);

// A row of the table of load cases: the case's name, and its values as text, "–" where there is none.
struct CaseInWords {
  std::string name, greatest, robot, least, use, stays;
};
// The headings of that table, and its rows; without capacities, `use` is empty. O(cases).
CaseInWords headings_of_cases(const Reported& of);
std::vector<CaseInWords> cases_in_words(const Reported& of, const std::vector<LoadCase>& cases);

}  // namespace evenlift
