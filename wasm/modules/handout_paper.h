// The pictures of a handout: from polygon coordinates to the paper, and where words stand on it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

// A picture's ground, in the units of its SVG, with y down. The polygon lies in its middle.
class Paper {
 public:
  static constexpr double width = 320, height = 220, margin = 34;
  static constexpr double disc = 8;   // radius of a robot
  static constexpr double text = 10;  // height of the letters

  explicit Paper(const Points& polygon);
  // Rounded to tenths, which nobody sees and which keeps the handout short.
  Vec2 operator()(const Vec2& p) const;
  Points operator()(const Points& points) const;
  double length(double in_polygon_units) const { return in_polygon_units * scale_; }

 private:
  double scale_;
  Vec2 middle_;
};

// A robot that is drawn in the picture of a step.
struct PaperRobot {
  Vec2 middle;           // on the paper
  std::uint32_t number;  // on its disc, from 1: of its team, or its own where there are no teams
  std::optional<double> load;  // once the step knows it
};
std::vector<PaperRobot> robots_on_paper(const Paper& paper, const Trace& trace,
                                        const StepDetail& detail);

// Words and where their middle is on the paper.
struct PaperWords {
  Vec2 middle;
  std::string text;
};

// What is written into the picture of a step: C, the parts that the step speaks of, load ratios of
// the chords that it compares, and what robots bear once that is known. Words that find no room are
// left out. O(words (n + words + lines)).
std::vector<PaperWords> words_on_paper(const Paper& paper, const Trace& trace,
                                       const StepDetail& detail,
                                       const std::vector<Figure>& figures);

}  // namespace evenlift
