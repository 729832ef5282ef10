// The figures of the steps.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "evenlift/trace.h"
#include "trace/step_rows.h"

namespace evenlift {

// Collects the figures of one step, back to front. The step's row in steps.cpp names the function.
class StepFigures : LookedAtStep {
 public:
  StepFigures(const Trace& trace, const StepDetail& detail) : LookedAtStep(trace, detail) {}

  void none() {}
  void polygon();
  void centroid();
  void centre();
  void radial();
  void ray();
  void slopes();
  void sections();
  void outcome();
  void opposite();
  void candidates();
  void scores();
  void team();
  void base();
  void share();
  void loads();
  void coverage();
  void contacts();
  void cut();
  void slide();
  void closure();
  void result();
  void lever();
  void three();
  void many();
  void rest();
  void mirror();
  void completion();
  void start();
  void exchange();
  void round();
  void failure();
  void pairs();
  void range();
  void swap();
  void held();
  void stands();
  void support();
  void equations();
  void by_lever();
  void by_areas();
  void by_springs();
  void extremes();
  void falls();
  void cargo();

  // Returns the figures, with the centre of mass in front.
  std::vector<Figure> take() &&;

 private:
  void add(FigureKind kind, Points points, std::optional<std::uint32_t> item = {},
           double value = 0);
  void add(FigureKind kind, const Chord& chord, std::optional<std::uint32_t> item, double value);
  void add_edge(FigureKind kind, std::uint32_t edge);
  void add_fan(const Polygon& ring, std::optional<std::uint32_t> hole);
  void add_vertex_chord(std::uint32_t index);
  void add_pair(bool reflected);
  void add_team(std::uint32_t index, bool loaded);
  void add_regions(const FreeRegion& clockwise, const FreeRegion& counterclockwise);
  void add_contacts(std::size_t number);
  void add_balanced(double load);
  void add_arms();
  void add_even_chords();
  void add_completion();
  void add_teams(const std::vector<Team>& teams);
  void add_supports(bool loaded);
  void add_base_of(FigureKind kind, std::size_t supports);
  void add_body(const LiftingPoint& contact, std::optional<std::uint32_t> part);

  std::vector<Figure> figures_;
  std::optional<Vec2> centre_;  // if set, drawn in place of C
};

}  // namespace evenlift
