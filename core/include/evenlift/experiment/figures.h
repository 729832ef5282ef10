// The thesis's figures as data: what a chart draws, and a sentence that says what it shows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

struct FigurePoint {
  std::uint32_t robots = 0;
  double value = 0;            // as in the aggregates: a load, or a share of 1
  std::uint32_t polygons = 0;  // that it is an average of
};

struct FigureSeries {
  Method method = Method::area;
  std::vector<FigurePoint> points;  // by robots
};

struct Figure {
  std::string set;    // whose averages these are; empty of a single polygon
  std::string id;     // "5.3", of the thesis's figure
  std::string title;  // what is measured, in words
  std::string unit;   // "kg" or another of weights, or "%" where values are shares, shown times 100
  std::string column;                // of the aggregates that the values are
  std::string sentence;              // what it shows, made from the data
  std::vector<FigureSeries> series;  // by method; none without values
};

// The largest number of robots with which the method was measured on at least a fifth of all
// polygons on which it was measured, so that no point of a chart averages only a few polygons. 0
// without polygons. O(rows).
std::uint32_t most_robots_shown(const std::vector<Aggregate>& aggregates, Method method);

// Figures 5.3 to 5.8 and 5.11 of one set: teams of two up to most_robots_shown of area, and
// balanced robots up to theirs. O(rows).
std::vector<Figure> make_figures(const SetAggregates& set);

// What section 5.1 measures of one polygon with every method, against the number of robots: the
// greatest load, the difference of loads, coverage, and form closure (for random placements the
// fraction of samples in form closure). `settings` are those of the measurements. O(rows).
std::vector<Figure> make_polygon_figures(const PolygonResult& result,
                                         const ExperimentSettings& settings);

// [{"set", "id", "title", "unit", "column", "sentence", "series": [{"method",
// "points": [[robots, value, polygons], ...]}]}] O(rows).
std::string figures_json(const std::vector<Figure>& figures);

}  // namespace evenlift::experiment
