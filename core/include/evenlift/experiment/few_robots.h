// Tables for every method with few robots, including odd numbers of them: coverage, form closure,
// form closure by contacts far enough from corners, spread of loads, and number of polygons. They
// go beyond the thesis, whose robots form teams of two.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// The numbers of robots in the table.
inline constexpr std::uint32_t few_robots_from = 3, few_robots_to = 12;

struct FewRobotsRow {
  std::string what;                // the quantity and its unit
  std::uint32_t robots = 0;        // few_robots_from .. few_robots_to
  std::vector<std::string> cells;  // for each of all_methods; "–" if not measured
};

// The table of one set. Each value is an average over the polygons on which the method was measured
// with that number of robots. Unlike in figure 5.11, these include polygons on which teams of two
// cannot reach form closure.
struct FewRobots {
  std::string set;
  std::vector<FewRobotsRow> rows;  // sorted by quantity, then by number of robots
};

// The table of a set. Every set has the same rows in the same order. O(rows).
FewRobots few_robots(const SetAggregates& set);

// The tables in Markdown. The first column of each is headed by the name of its set. O(rows).
std::string few_robots_markdown(const std::vector<FewRobots>& sets);

// The tables as JSON: [{"set", "rows": [{"what", "robots", "cells": [by method]}]}]. O(rows).
std::string few_robots_json(const std::vector<FewRobots>& sets);

}  // namespace evenlift::experiment
