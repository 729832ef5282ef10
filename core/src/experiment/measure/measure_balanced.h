// The measurements of balanced robots (evenlift/experiment/measure.h), and tests of form closure
// for all methods.
#pragma once

#include <vector>

#include "evenlift/chords.h"
#include "evenlift/experiment/measure.h"

namespace evenlift::experiment {

// Whether robots at these points are in form closure by the contacts clear of corners, with the
// usual distance (closure.h).
bool holds_clearly(const Polygon& polygon, const Vec2& centre,
                   const std::vector<LiftingPoint>& points);

// Fills in form closure (in_form_closure), the thesis's own test (no_region_has_area), and a clear
// hold (holds_clearly).
void test_closure(const Subject& subject, const std::vector<LiftingPoint>& points, Measurement& m);

// measure() for Method::balanced.
std::vector<Measurement> measure_balanced(const Subject& subject,
                                          const ExperimentSettings& settings);

}  // namespace evenlift::experiment
