// The thesis's figures, and figures of one polygon. Each has the points of a chart and a sentence
// about its main result.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

struct FigurePoint {
  std::uint32_t robots = 0;
  double value = 0;            // as in the aggregates: a load, or a share from 0 to 1
  std::uint32_t polygons = 0;  // number of polygons in the average
};

struct FigureSeries {
  Method method = Method::area;
  std::vector<FigurePoint> points;  // by number of robots
};

struct Figure {
  std::string set;       // the averaged set; empty for a single polygon
  std::string id;        // number of the thesis's figure, such as "5.3"; `column` for one polygon
  std::string title;     // the quantity, in words
  std::string unit;      // a unit of weight such as "kg", or "%" for shares (shown times 100)
  std::string column;    // the column of aggregates_csv(), or of measurements_csv() for one polygon
  std::string sentence;  // the main result in words
  std::vector<FigureSeries> series;  // one for each method that has values
};

// The greatest number of robots measured on at least a fifth of the method's polygons; 0 without
// polygons. Beyond it, a point would be the average of only a few polygons. O(rows).
std::uint32_t most_robots_shown(const std::vector<Aggregate>& aggregates, Method method);

// Figures 5.3 to 5.8 and 5.11 of one set. They show teams of two by every method, up to the
// most_robots_shown() of `area`, and balanced robots, up to that of `balanced`. O(rows).
std::vector<Figure> make_figures(const SetAggregates& set);

// The quantities of section 5.1 for one polygon with every method, by number of robots: greatest
// load, spread of loads, coverage, and form closure (for random placements, the share in form
// closure). `settings` are those of the measurements. O(rows).
std::vector<Figure> make_polygon_figures(const PolygonResult& result,
                                         const ExperimentSettings& settings);

// The figures as JSON: [{"set", "id", "title", "unit", "column", "sentence", "series": [{"method",
// "points": [[robots, value, polygons], ...]}]}]. O(rows).
std::string figures_json(const std::vector<Figure>& figures);

}  // namespace evenlift::experiment
