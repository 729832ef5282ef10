// What few robots achieve, odd numbers included, by every method: coverage, closure and spread of
// loads. Beyond the thesis, whose robots come in twos.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// The numbers of robots that the table has.
inline constexpr std::uint32_t few_robots_from = 3, few_robots_to = 12;

struct FewRobotsRow {
  std::string what;                // what is measured, and its unit
  std::uint32_t robots = 0;        // few_robots_from .. few_robots_to
  std::vector<std::string> cells;  // in the order of all_methods; "–" where a method has no such
                                   // number of robots
};

// The table of one set. Its averages are over the polygons on which the method was measured with so
// many robots; closure is not, as in figure 5.11, of those that teams of two can close.
struct FewRobots {
  std::string set;
  std::vector<FewRobotsRow> rows;  // by what is measured, then by robots
};

// The table from the aggregates of a set. Every set has the same rows in the same order. O(rows).
FewRobots few_robots(const SetAggregates& set);

// The tables in Markdown, each after its set's name. O(rows).
std::string few_robots_markdown(const std::vector<FewRobots>& sets);

// [{"set", "rows": [{"what", "robots", "cells": [by method]}]}] O(rows).
std::string few_robots_json(const std::vector<FewRobots>& sets);

}  // namespace evenlift::experiment
