// Coverage, form closure and spread of loads of every method with few robots, also odd numbers.
// This is beyond the thesis, whose robots form teams of two.
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
  std::vector<std::string> cells;  // by all_methods; "–" if not measured with this number of robots
};

// The table of one set, averaged over the polygons on which the method was measured with that
// number of robots. Unlike in figure 5.11, form closure includes polygons on which teams of two
// cannot reach it.
struct FewRobots {
  std::string set;
  std::vector<FewRobotsRow> rows;  // by quantity, then by robots
};

// Every set has the same rows in the same order. O(rows).
FewRobots few_robots(const SetAggregates& set);

// Each table follows the name of its set. O(rows).
std::string few_robots_markdown(const std::vector<FewRobots>& sets);

// [{"set", "rows": [{"what", "robots", "cells": [by method]}]}] O(rows).
std::string few_robots_json(const std::vector<FewRobots>& sets);

}  // namespace evenlift::experiment
