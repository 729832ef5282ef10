// For the pictures of a handout: maps points to the paper, and finds places for words on the paper.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

// The area of a picture, in the units of its SVG, with y downwards. The polygon and its cargo are
// in the middle of the area.
class Paper {
 public:
  static constexpr double width = 320, height = 220, margin = 34;
  static constexpr double disc = 8;   // radius of a robot
  static constexpr double text = 10;  // height of the letters

  explicit Paper(const Points& points);
  // The place of the point on the paper, rounded to tenths. The rounding is invisible, and makes
  // the file shorter.
  Vec2 operator()(const Vec2& p) const;
  Points operator()(const Points& points) const;
  double length(double in_polygon_units) const { return in_polygon_units * scale_; }

 private:
  double scale_;
  Vec2 middle_;
};

// A weight's disc and label. The area of the disc shows the weight's share of the total weight. The
// label is the name or, without a name, how heavy the weight is.
struct PaperCargo {
  Vec2 middle;  // on the paper
  double radius;
  std::string name;
};
std::vector<PaperCargo> cargo_on_paper(const Paper& paper, const Trace& trace);

struct PaperRobot {
  Vec2 middle;                 // on the paper
  std::uint32_t number;        // on its disc, from 1
  std::optional<double> load;  // if known at the step
};
std::vector<PaperRobot> robots_on_paper(const Paper& paper, const Trace& trace,
                                        const StepDetail& detail);

// Words and the middle of their place on the paper.
struct PaperWords {
  Vec2 middle;
  std::string text;
};

// The text in a step's picture: C, the names of cargo and of the parts that the caption mentions,
// the numbers or load ratios of the compared chords, and the robots' loads once known. Words
// without room are left out. O(words (n + words + lines)).
std::vector<PaperWords> words_on_paper(const Paper& paper, const Trace& trace,
                                       const StepDetail& detail,
                                       const std::vector<Figure>& figures);

}  // namespace evenlift
