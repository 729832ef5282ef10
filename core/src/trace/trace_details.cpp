#include <algorithm>

#include "evenlift/predicates.h"
#include "evenlift/trace.h"
#include "trace/balanced_steps.h"

namespace evenlift {
namespace {

void cut_regions(const Trace& trace, std::uint32_t contacts, StepDetail& detail) {
  const auto some = [&](std::uint32_t number) {
    return std::vector<Contact>(trace.contacts.data(), trace.contacts.data() + number);
  };
  FreeRegions after = free_regions(trace.polygon(), trace.centre, some(contacts));
  detail.clockwise = std::move(after.clockwise);
  detail.counterclockwise = std::move(after.counterclockwise);
  if (contacts < 2) return;
  const FreeRegions before = free_regions(trace.polygon(), trace.centre, some(contacts - 1));
  detail.clockwise_before = before.clockwise.exists;
  detail.counterclockwise_before = before.counterclockwise.exists;
}

void look_at_team(const Trace& trace, StepDetail& detail) {
  const std::uint32_t team = detail.step.item;
  if (trace.by_candidates() && detail.step.kind != StepKind::base)
    detail.scores = look_at_scores(trace, team);
  detail.base_before = lifting_base(trace, team);
  detail.base = lifting_base(trace, team + 1);
}

void look_at_bases_of_swap(const Trace& trace, StepDetail& detail) {
  Progress known;
  known.base_teams = static_cast<std::uint32_t>(trace.placement.teams.size());
  known.swaps = detail.step.item;
  detail.base_before = lifting_base(trace, known);
  ++known.swaps;
  detail.base = lifting_base(trace, known);
}

}  // namespace

bool centre_is_outside(const Trace& trace) {
  const Vec2& c = trace.centre;
  bool outside = true;
  for (std::size_t i = 0; i < trace.polygon().size(); ++i) {
    const Vec2 &p = trace.polygon().edge_start(i), &q = trace.polygon().edge_end(i);
    const double side = orient(p, q, c);
    const bool within_x = (p.x <= c.x) == (c.x <= q.x);
    const bool within_y = (p.y <= c.y) == (c.y <= q.y);
    if (side == 0 && within_x && within_y) return false;
    // Half-open: a vertex to the left of C counts for one of its edges.
    if ((p.y > c.y) != (q.y > c.y) && (side > 0) == (q.y > p.y)) outside = !outside;
  }
  return outside;
}

StepDetail look_at(const Trace& trace, std::uint32_t k) {
  StepDetail detail;
  detail.number = k;
  detail.step = trace.step(k);
  const std::uint32_t item = detail.step.item;
  if (trace.balanced()) look_at_balanced(trace, detail);
  switch (detail.step.kind) {
    case StepKind::sections:
    case StepKind::outcome:
      detail.pair = look_at_pair(trace, item);
      break;
    case StepKind::opposite:
      detail.opposite = look_at_opposite(trace, item);
      break;
    case StepKind::stands:
      detail.stands = look_at_stands(trace);
      break;
    case StepKind::range:
      detail.range = look_at_range(trace, item);
      break;
    case StepKind::swap:
      look_at_bases_of_swap(trace, detail);
      detail.swap = look_at_swap(trace, item);
      break;
    case StepKind::scores:
    case StepKind::team:
    case StepKind::base:
      look_at_team(trace, detail);
      break;
    case StepKind::contacts:
      cut_regions(trace, 0, detail);
      break;
    case StepKind::cut:
      cut_regions(trace, item + 1, detail);
      break;
    default:
      break;
  }
  return detail;
}

}  // namespace evenlift
