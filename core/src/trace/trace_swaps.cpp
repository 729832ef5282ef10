// The details of a swap of teams.
#include "trace/margin_of.h"

namespace evenlift {

SwapDetail look_at_swap(const Trace& trace, std::uint32_t index) {
  const ExchangeHistory& history = *trace.exchanges;
  const Exchange& exchange = history.exchanges[index];
  const bool first = index == 0;
  const auto& taken = first ? history.start : history.exchanges[index - 1].taken;
  SwapDetail detail;
  detail.before = first ? history.keys : history.exchanges[index - 1].keys;
  detail.after = exchange.keys;
  detail.margin_before = margin_of(trace, lifting_points(trace.stages[index]));
  detail.margin = margin_of(trace, lifting_points(trace.stages[index + 1]));
  detail.teams = exchange.teams;
  for (const std::uint32_t team : exchange.teams) {
    detail.from.push_back(taken[team]);
    detail.to.push_back(exchange.taken[team]);
  }
  detail.kind = exchange.kind;
  detail.decided_by = exchange.decided_by;
  return detail;
}

}  // namespace evenlift
