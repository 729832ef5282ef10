// The measurements of balanced robots (evenlift/experiment/measure.h), and tests of form closure
// for all methods.
#pragma once

#include <vector>

#include "evenlift/chords.h"
#include "evenlift/experiment/measure.h"

namespace evenlift::experiment {

// Whether robots at these points hold the object in form closure by contacts at least the default
// `clear` (usual_clear R) from every corner (closure.h).
bool holds_clearly(const Polygon& polygon, const Vec2& centre,
                   const std::vector<LiftingPoint>& points);

// Fills in the results of three tests: form closure (in_form_closure), the thesis's own test
// (no_region_has_area), and form closure by clear contacts (holds_clearly).
void test_closure(const Subject& subject, const std::vector<LiftingPoint>& points, Measurement& m);

// The result of measure() for Method::balanced.
std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings);

}  // namespace evenlift::experiment
