// The ranges of robots with a size, and the candidates in them.
#include <algorithm>

#include "candidates/chord_range.h"
#include "candidates/pair_candidate.h"
#include "candidates/pair_range.h"
#include "candidates/stand_lines.h"
#include "evenlift/candidates.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

// The length of a range, on both edges together.
double way(const PairRange& range) {
  const Vec2 on_a = range.a1 - range.a0;
  const Vec2 on_b = range.a1 / range.q1 - range.a0 / range.q0;
  return length(on_a) + length(on_b);
}

}  // namespace

std::vector<PairRange> standing_ranges(const StandLine& a, const StandLine& b, double min_ratio,
                                       double near) {
  std::vector<PairRange> ranges;
  if (std::fabs(a.height) <= near || std::fabs(b.height) <= near) return ranges;
  const ChordRange chords(a, b);
  for (const Stretch& piece : chords.pieces(min_ratio)) {
    PairRange range;
    range.a = a.edge;
    range.b = b.edge;
    range.a0 = a.at(piece.from);
    range.a1 = a.at(piece.to);
    range.q0 = chords.q(piece.from);
    range.q1 = chords.q(piece.to);
    ranges.push_back(range);
  }
  return ranges;
}

std::vector<PairRange> standing_ranges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                       std::uint32_t b, double min_ratio, const Stands& stands) {
  const auto line_a = stand_line(polygon, centre, stands, a);
  const auto line_b = stand_line(polygon, centre, stands, b);
  if (!line_a || !line_b) return {};
  return standing_ranges(*line_a, *line_b, min_ratio, near_distance(polygon.diameter()));
}

std::size_t longest_range(const std::vector<PairRange>& ranges, double near) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (way(ranges[i]) > way(ranges[longest]) + near) longest = i;
  return longest;
}

std::vector<Candidate> standing_range_chords(const FromCorners& from, const Vec2& centre,
                                             const StandLine& a, const StandLine& b,
                                             double min_ratio, double near) {
  const std::vector<PairRange> ranges = standing_ranges(a, b, min_ratio, near);
  std::vector<Candidate> found;
  if (ranges.empty()) return found;
  const PairRange& range = ranges[longest_range(ranges, near)];
  if (is_one_place(range, near)) return found;
  const auto clear = clear_part(from, centre, range);
  for (const double s : range_places) {
    const Candidate candidate = range_candidate(centre, range, clear_place_at(range, clear, s));
    if (reaches(candidate.chord, min_ratio) && can_stand(*from.stands, candidate))
      found.push_back(candidate);
  }
  return found;
}

}  // namespace evenlift
