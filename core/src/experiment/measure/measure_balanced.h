// The measures of balanced robots (evenlift/experiment/measure.h), and the test of closure that all
// methods share.
#pragma once

#include <vector>

#include "evenlift/chords.h"
#include "evenlift/experiment/measure.h"

namespace evenlift::experiment {

// Fills in whether robots at these points are in form closure, and pass the thesis's own test. As
// in_form_closure and no_region_has_area.
void test_closure(const Subject& subject, const std::vector<LiftingPoint>& points, Measurement& m);

// measure() for Method::balanced.
std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings);

}  // namespace evenlift::experiment
