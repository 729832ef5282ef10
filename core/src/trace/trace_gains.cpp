// Figures of a metric's gain, by the same wedges as the scores.
#include <algorithm>

#include "evenlift/trace.h"
#include "polygon/clip.h"
#include "selection/base_edge.h"

namespace evenlift {
namespace {

class GainScene {
 public:
  GainScene(const Trace& trace) : trace_(trace) {}

  void add(const EndGain& end) {
    if (!end.outside) return;
    switch (trace_.metric()) {
      case Metric::circle:
        add_triangle(end);
        return add_circle(end);
      case Metric::distance:
        return add_arms(end);
      case Metric::area:
        add_triangle(end);
        return add_part(end);
    }
  }
  std::vector<Figure> take() && { return std::move(out_); }

 private:
  void add_triangle(const EndGain& end) {
    out_.push_back({FigureKind::gain_triangle, {end.h1, end.h2, end.p}, std::nullopt, end.value});
  }

  void add_part(const EndGain& end) {
    Points part = trace_.object().boundary();
    if (!trace_.polygon().counter_clockwise()) std::reverse(part.begin(), part.end());
    part = clip_left(part, end.h2, end.h1);  // beyond the edge of H
    part = clip_left(part, end.h1, end.p);
    part = clip_left(part, end.p, end.h2);
    if (part.size() > 2)
      out_.push_back({FigureKind::gain_part, std::move(part), std::nullopt, end.value});
  }

  void add_circle(const EndGain& end) {
    const double a = length(end.h2 - end.p), b = length(end.p - end.h1),
                 c = length(end.h2 - end.h1);
    const double twice_area = std::fabs(cross(end.h2 - end.h1, end.p - end.h1));
    const Vec2 middle = (a * end.h1 + b * end.h2 + c * end.p) / (a + b + c);
    out_.push_back({FigureKind::gain_circle, {middle}, std::nullopt, twice_area / (a + b + c)});
  }

  void add_arms(const EndGain& end) {
    const Surroundings surroundings(trace_.object(), trace_.centre);
    const Vec2 h1 = end.h1 - trace_.centre, h2 = end.h2 - trace_.centre, p = end.p - trace_.centre;
    const Wedge wedge(surroundings, Metric::distance, h1, h2);
    for (const Wedge::Arm& arm : wedge.arms(p)) {
      add_arm(FigureKind::arm_before, arm.vertex, h1, h2, arm.before);
      add_arm(FigureKind::arm_after, arm.vertex, arm.up_to_p ? h1 : p, arm.up_to_p ? p : h2,
              arm.after);
    }
  }

  // From a vertex outside the line from -> to to its foot.
  void add_arm(FigureKind kind, const Vec2& vertex, const Vec2& from, const Vec2& to,
               double distance) {
    if (!(distance > 0)) return;
    const Vec2 inward = left_normal(to - from) / length(to - from);
    out_.push_back({kind,
                    {trace_.centre + vertex, trace_.centre + vertex + distance * inward},
                    std::nullopt,
                    distance});
  }

  const Trace& trace_;
  std::vector<Figure> out_;
};

}  // namespace

std::vector<Figure> gain_figures(const Trace& trace, const TeamScores& scores,
                                 std::uint32_t candidate) {
  GainScene scene(trace);
  if (scores.rule == Rule::score)
    for (const EndGain& end : scores.of_candidate[candidate].ends) scene.add(end);
  return std::move(scene).take();
}

}  // namespace evenlift
