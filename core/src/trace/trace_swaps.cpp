#include "trace/margin_of.h"

namespace evenlift {

SwapDetail look_at_swap(const Trace& trace, std::uint32_t index) {
  const SwapHistory& history = *trace.swaps;
  const Swap& swap = history.swaps[index];
  const bool first = index == 0;
  const auto& taken = first ? history.start : history.swaps[index - 1].taken;
  SwapDetail detail;
  detail.before = first ? history.keys : history.swaps[index - 1].keys;
  detail.after = swap.keys;
  detail.margin_before = margin_of(trace, lifting_points(trace.stages[index]));
  detail.margin = margin_of(trace, lifting_points(trace.stages[index + 1]));
  detail.teams = swap.teams;
  for (const std::uint32_t team : swap.teams) {
    detail.from.push_back(taken[team]);
    detail.to.push_back(swap.taken[team]);
  }
  detail.kind = swap.kind;
  detail.decided_by = swap.decided_by;
  return detail;
}

}  // namespace evenlift
