// The oracle's problem as the core's document.
#pragma once

#include <cstdint>

#include "evenlift/document.h"
#include "oracle/oracle.h"

namespace evenlift::testing {

inline Document document_of(const oracle::Problem& problem) {
  Document d;
  for (const oracle::Point& p : problem.vertices) d.vertices.emplace_back(p[0], p[1]);
  if (problem.centre_of_mass)
    d.centre_of_mass = Vec2((*problem.centre_of_mass)[0], (*problem.centre_of_mass)[1]);
  d.settings.teams = static_cast<std::uint32_t>(problem.teams);
  d.settings.min_ratio = problem.min_ratio;
  d.settings.weight = problem.weight;
  d.settings.method = problem.metric == oracle::Metric::area     ? Method::area
                      : problem.metric == oracle::Metric::circle ? Method::circle
                                                                 : Method::distance;
  return d;
}

}  // namespace evenlift::testing
