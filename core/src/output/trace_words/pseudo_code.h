// The statements of the pseudo-code. Each step of the walkthrough executes one of them. In the
// list, a comment on its own line names the methods that have the statements below it; a comment
// beside a statement refers to that statement only.
#pragma once

#include <cstdint>

#include "evenlift/trace.h"

namespace evenlift {

enum class Statement : std::uint8_t {
  centre,
  cargo,
  stands,  // if robots have a size or there are no-go edges
  // area, circle and distance
  each_vertex,
  each_hit,
  sort_chords,
  each_pair,
  sections,
  parallel,
  bisecting,
  nearer_end,
  accept,
  opposite,
  merge,
  order,
  first_team,
  first_base,
  each_team,  // also distributed and random
  scores,
  next_team,
  wider_base,  // all but balanced
  range,
  exchange,  // balanced
  // distributed
  open_directions,
  direction,
  // random
  first_robot,
  second_robot,
  // balanced
  centroid_law,
  each_number,
  middle,
  even_chords,
  best_set,
  swap,  // area, circle and distance
  rounds,
  equal_loads,
  failures,
  // given
  each_support,
  equations,
  springs,
  // all
  loads,  // all but balanced and given
  coverage,
  cut,
  slide,
  form_closure,
  second_order,
};

Statement statement_of_outcome(const Trace& trace, const StepDetail& detail);
Statement statement_of_scores(const Trace& trace, const StepDetail& detail);
Statement statement_of_team(const Trace& trace, const StepDetail& detail);
Statement statement_of_fewer(const Trace& trace, const StepDetail& detail);
Statement statement_of_loads(const Trace& trace, const StepDetail& detail);
Statement statement_of_base(const Trace& trace, const StepDetail& detail);

}  // namespace evenlift
