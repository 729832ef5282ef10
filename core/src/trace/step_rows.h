// The tables of steps, and the functions in their rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/centre_of_mass.h"
#include "evenlift/closure.h"
#include "evenlift/trace.h"

namespace evenlift {

// --- The margin of robots in a trace.

// The margin (closure.h) of robots that lift at these points. Only contacts far enough from corners
// count; nullopt if there are no such contacts.
inline std::optional<double> margin_of(const Trace& trace,
                                       const std::vector<LiftingPoint>& robots) {
  const Placement& placement = trace.placement;
  const auto touching = contacts(trace.polygon(), contact_points(placement.stands.get(), robots));
  const double clear = hold_requirements(placement).clear;
  return analyse_hold(trace.polygon(), trace.centre,
                      clear_contacts(trace.polygon(), touching, clear))
      .margin;
}

// --- The common parts of the tables of steps.

// Whether a table has one row for each kind of step, in order.
template <class Row, std::size_t size>
constexpr bool has_each_step(const Row (&rows)[size]) {
  for (std::size_t i = 0; i < size; ++i)
    if (rows[i].kind != static_cast<StepKind>(i)) return false;
  return size == step_kind_count;
}

// One step of a trace, as the functions in the tables' rows see it.
class LookedAtStep {
 protected:
  LookedAtStep(const Trace& trace, const StepDetail& detail)
      : trace_(trace), placement_(trace.placement), detail_(detail), item_(detail.step.item) {}

  // The object with its first `items` pieces of cargo.
  Loaded with_cargo(std::size_t items) const {
    return evenlift::with_cargo(placement_.own_centre, placement_.settings, items);
  }

  const Trace& trace_;
  const Placement& placement_;
  const StepDetail& detail_;
  std::uint32_t item_;
};

// --- Balanced robots in a trace.

// Repeats the search for balanced robots and records it in the trace. The result becomes the
// trace's placement. If the search is too long to show, the function returns an error for
// HistoryLength::whole, and records nothing for HistoryLength::start.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

void look_at_balanced(const Trace& trace, StepDetail& detail);

// The set of balanced robots that the step shows: its own or, if it has none, the final set of the
// search. Null for the steps about the object, and if there is no such set.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

// --- The figures of the steps.

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

// --- The numbers of the steps, under their JSON names.

// Each step's row in steps.cpp names the function for its numbers.
class StepNumbers : LookedAtStep {
 public:
  StepNumbers(const Trace& trace, const StepDetail& detail) : LookedAtStep(trace, detail) {}

  void polygon();
  void centroid();
  void centre();
  void radial();
  void ray();
  void slopes();
  void sections();
  void outcome();
  void opposite();
  void duplicates();
  void candidates();
  void directions();
  void scores();
  void team();
  void base();
  void fewer();
  void share();
  void loads();
  void coverage();
  void contacts();
  void cut();
  void slide();
  void closure();
  void second_order();
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
  void settled();
  void failure();
  void failures();
  void pairs();
  void range();
  void swap();
  void held();
  void stands();
  void support();
  void equations();
  void each_load();
  void by_springs();
  void extremes();
  void falls();
  void cargo();

  std::vector<Number> take() && { return std::move(numbers_); }

 private:
  void add(std::string_view name, double value) { numbers_.push_back({name, value}); }
  void count(std::string_view name, std::size_t value) { add(name, static_cast<double>(value)); }
  void point(std::string_view x, std::string_view y, const Vec2& p);
  void ratio_and_candidate(double ratio, std::optional<std::uint32_t> candidate);

  void robots_and_coverage();

  std::vector<Number> numbers_;
};

}  // namespace evenlift
