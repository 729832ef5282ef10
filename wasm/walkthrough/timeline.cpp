#include "walkthrough/timeline.h"

#include <algorithm>
#include <cmath>

namespace evenlift::view {

Timeline timeline(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.trace) return {};
  if (walk.script)
    return {static_cast<std::uint32_t>(walk.script->position),
            static_cast<std::uint32_t>(walk.script->stops.size())};
  if (walk.all_steps) return {walk.at, walk.trace->size()};
  const auto at = std::lower_bound(walk.main.begin(), walk.main.end(), walk.at);
  return {static_cast<std::uint32_t>(at - walk.main.begin()),
          static_cast<std::uint32_t>(walk.main.size())};
}

std::uint32_t step_of(const AppState& state, std::uint32_t position) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.script && walk.all_steps) return position;
  if (!walk.script) return walk.main[std::min<std::size_t>(position, walk.main.size() - 1)];
  return walk.script->stops[std::min<std::size_t>(position, walk.script->stops.size() - 1)].step;
}

std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.script && walk.all_steps) return step;
  const Timeline now = timeline(state);
  if (step_of(state, now.at) == step) return now.at;
  for (std::uint32_t position = 0; position < now.count; ++position)
    if (step_of(state, position) == step) return position;
  return std::nullopt;
}

std::vector<ChapterPart> chapter_parts(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  const Timeline now = timeline(state);
  if (!walk.trace || walk.script) return {{0, now.count}};
  std::vector<ChapterPart> parts;
  for (std::uint32_t c = 0; c < chapter_count; ++c) {
    const auto begin = walk.trace->chapter_begin(static_cast<Chapter>(c));
    if (!begin) continue;
    std::uint32_t first = *begin;
    if (!walk.all_steps)
      first = static_cast<std::uint32_t>(
          std::lower_bound(walk.main.begin(), walk.main.end(), *begin) - walk.main.begin());
    if (!parts.empty()) parts.back().count = first - parts.back().first;
    if (!parts.empty() && parts.back().count == 0) parts.pop_back();
    parts.push_back({first, now.count - first});
  }
  return parts;
}

double share_of(const std::vector<ChapterPart>& parts, std::uint32_t position) {
  std::size_t i = parts.size() - 1;
  while (i > 0 && parts[i].first > position) --i;
  const bool last = i + 1 == parts.size();
  const double within = position - parts[i].first;
  // The last step is at the very end of the timeline.
  const double inside = !last                ? within / parts[i].count
                        : parts[i].count > 1 ? within / (parts[i].count - 1)
                        : parts.size() > 1   ? 1.0
                                             : 0.0;
  return (static_cast<double>(i) + inside) / static_cast<double>(parts.size());
}

std::uint32_t position_at(const std::vector<ChapterPart>& parts, double share) {
  const double scaled = std::clamp(share, 0.0, 1.0) * static_cast<double>(parts.size());
  const std::size_t i = std::min(static_cast<std::size_t>(scaled), parts.size() - 1);
  const bool last = i + 1 == parts.size();
  const double steps = parts[i].count - (last ? 1.0 : 0.0);
  return parts[i].first +
         static_cast<std::uint32_t>(std::lround((scaled - static_cast<double>(i)) * steps));
}

}  // namespace evenlift::view
