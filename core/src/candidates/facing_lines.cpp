#include "candidates/facing_lines.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "exact/pseudo_angle.h"

namespace evenlift {
namespace {

constexpr double half_turn = 2;  // of pseudo_angle

// Unlike in RadialSweep (chords), directions are rounded: these lines are computed, so their ends
// have no exact directions. Rounding confuses only lines whose common range of directions is about
// 1e-16 rad. Such a range is one place within tau L, and ChordRange then decides, within tau L,
// whether a chord ends on both lines.
//
// A line through C turns by 180 degrees. Its half ahead meets each listed line from that line's
// first to its last direction; its half behind, half a turn later.
struct Event {
  double angle;  // in [0, half_turn)
  bool enters;   // leaving lines come first, since the ranges are open
  std::uint32_t line;
  int side;  // 0: ahead, 1: behind
  bool operator<(const Event& other) const {
    return std::tie(angle, enters, line) < std::tie(other.angle, other.enters, other.line);
  }
};

// The lines that one half of the turning line meets.
class Met {
 public:
  explicit Met(std::size_t lines) : slots_(lines, none) {}

  void add(std::uint32_t line) {
    if (slots_[line] != none) return;
    slots_[line] = lines_.size();
    lines_.push_back(line);
  }

  void remove(std::uint32_t line) {
    const std::size_t slot = std::exchange(slots_[line], none);
    if (slot == none) return;
    if (lines_.back() != line) {
      lines_[slot] = lines_.back();
      slots_[lines_.back()] = slot;
    }
    lines_.pop_back();
  }

  const std::vector<std::uint32_t>& lines() const { return lines_; }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> slots_;
  std::vector<std::uint32_t> lines_;
};

int side_of(double angle) { return angle < half_turn ? 0 : 1; }

}  // namespace

void for_each_facing(const std::vector<StandLine>& lines, double near,
                     const std::function<bool(std::uint32_t i, std::uint32_t j)>& visit) {
  std::vector<Event> events;
  Met met[2] = {Met(lines.size()), Met(lines.size())};
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const StandLine& line = lines[i];
    if (std::fabs(line.height) <= near) continue;
    double first = pseudo_angle(line.at(line.low)), last = pseudo_angle(line.at(line.high));
    if (line.height < 0) std::swap(first, last);
    if (first == last) continue;
    for (const auto& [angle, enters] : {std::pair(first, true), std::pair(last, false)})
      events.push_back({angle - half_turn * side_of(angle), enters, i, side_of(angle)});
    // Lines that are met from the beginning.
    if (first > last && last > 0) met[0].add(i);
    if (first < half_turn && last > half_turn) met[1].add(i);
  }
  std::sort(events.begin(), events.end());
  for (const Event& event : events) {
    if (!event.enters) {
      met[event.side].remove(event.line);
      continue;
    }
    for (const std::uint32_t other : met[1 - event.side].lines())
      if (!(event.side == 0 ? visit(event.line, other) : visit(other, event.line))) return;
    met[event.side].add(event.line);
  }
}

}  // namespace evenlift
