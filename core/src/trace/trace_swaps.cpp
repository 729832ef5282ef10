// The details of an exchange of teams.
#include "evenlift/closure.h"
#include "evenlift/trace.h"

namespace evenlift {
namespace {

std::optional<double> margin_of(const Trace& trace, const std::vector<Team>& teams) {
  const std::vector<Contact> touching = contacts(trace.polygon, lifting_points(teams));
  return analyse_hold(trace.polygon, trace.centre, touching).margin;
}

}  // namespace

SwapDetail look_at_swap(const Trace& trace, std::uint32_t index) {
  const ExchangeHistory& history = *trace.exchanges;
  const Exchange& exchange = history.exchanges[index];
  const bool first = index == 0;
  const auto& taken = first ? history.start : history.exchanges[index - 1].taken;
  SwapDetail detail;
  detail.before = first ? history.keys : history.exchanges[index - 1].keys;
  detail.after = exchange.keys;
  detail.margin_before = margin_of(trace, trace.stages[index]);
  detail.margin = margin_of(trace, trace.stages[index + 1]);
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
