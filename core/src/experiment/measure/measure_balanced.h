// The measurements of balanced robots (evenlift/experiment/measure.h), and tests of form closure
// for all methods.
#pragma once

#include <vector>

#include "evenlift/chords.h"
#include "evenlift/experiment/measure.h"

namespace evenlift::experiment {

// Whether robots at these points keep the object in form closure even without the contacts that are
// nearer to a corner (closure.h) than usual_clear times R, the default of the setting `clear`.
bool holds_clearly(const Polygon& polygon, const Vec2& centre,
                   const std::vector<LiftingPoint>& points);

// Sets the results of three tests in `m`: form closure (in_form_closure), the thesis's own test
// (no_region_has_area), and form closure by clear contacts (holds_clearly).
void test_closure(const Subject& subject, const std::vector<LiftingPoint>& points, Measurement& m);

// The result of measure() for Method::balanced.
std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings);

}  // namespace evenlift::experiment
