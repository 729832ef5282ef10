// Where given supports stand, and what each carries.
#include <algorithm>

#include "evenlift/placed_robots.h"
#include "evenlift/stability.h"
#include "evenlift/tolerance.h"
#include "trace/step_figures.h"
#include "trace/step_numbers.h"

namespace evenlift {
namespace {

Points first_places(const Placement& placement, std::size_t number) {
  Points places = positions(lifting_points(placement.teams));
  places.resize(number);
  return places;
}

// The loads of springs: level + slope . (p - C), where above 0.
struct Sinking {
  double level = 0;
  Vec2 slope;
};

// The plane of least squares through the loads above 0; level if these robots are on one line.
Sinking sinking_of(const Placement& placement) {
  const Vec2& centre = placement.centre_of_mass;
  Vec2 mean;
  double load = 0, number = 0;
  const auto each = [&](auto take) {
    for (const Robot& robot : placement.teams[0].robots)
      if (robot.load > 0) take(robot);
  };
  each([&](const Robot& robot) {
    mean += robot.point.position - centre;
    load += robot.load;
    ++number;
  });
  mean /= number;
  double xx = 0, xy = 0, yy = 0;
  Vec2 along;
  each([&](const Robot& robot) {
    const Vec2 d = robot.point.position - centre - mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    along += (robot.load - load / number) * d;
  });
  const double area = xx * yy - xy * xy;
  if (!(area > tau * xx * yy)) return {load / number, Vec2{}};
  const Vec2 slope = Vec2(yy * along.x - xy * along.y, xx * along.y - xy * along.x) / area;
  return {load / number - dot(slope, mean), slope};
}

}  // namespace

// --- Numbers

void StepNumbers::support() {
  const LiftingPoint& place = placement_.teams[0].robots[item_].point;
  count("robot", item_ + 1);
  point("x", "y", place.position);
  count("beneath", place.edge == beneath);
}

void StepNumbers::equations() {
  count("robots", count_robots(placement_.teams));
  add("weight", placement_.weight());
}

void StepNumbers::each_load() {
  constexpr std::string_view names[] = {"load1", "load2", "load3"};
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  for (std::size_t i = 0; i < robots.size() && i < std::size(names); ++i)
    add(names[i], robots[i].load);
}

void StepNumbers::by_springs() {
  add("min", placement_.loads->min);
  add("max", placement_.loads->max);
}

void StepNumbers::extremes() {
  const auto models = model_loads(placement_);
  add("springs", placement_.loads->max);
  add("best", models->best);
  add("worst", *std::max_element(models->worst.begin(), models->worst.end()));
}

void StepNumbers::falls() { add("com_margin", equilibrium(placement_).com_margin); }

// --- Figures

void StepFigures::support() {
  const LiftingPoint& place = placement_.teams[0].robots[item_].point;
  add_base_of(FigureKind::base_before, item_);
  add_base_of(FigureKind::base, item_ + std::size_t{1});
  if (place.edge != beneath) add_edge(FigureKind::edge, place.edge);
  add(FigureKind::robot, Points{place.position}, item_);
}

void StepFigures::add_base_of(FigureKind kind, std::size_t supports) {
  std::vector<LiftingPoint> points = lifting_points(placement_.teams);
  points.resize(supports);
  if (!points.empty()) add(kind, lifting_base(trace_.polygon(), points));
}

void StepFigures::equations() {
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  for (std::uint32_t i = 0; i < robots.size(); ++i)
    add(FigureKind::arm, Points{trace_.centre, robots[i].point.position}, i);
  add_supports(false);
}

void StepFigures::by_lever() {
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  add(FigureKind::lever, Points{robots[0].point.position, robots[1].point.position});
  add_supports(true);
}

// Triangles of C and two robots: each area is in proportion to the third's load.
void StepFigures::by_areas() {
  const Points places = first_places(placement_, 3);
  for (std::uint32_t i = 0; i < 3; ++i)
    add(FigureKind::share, Points{trace_.centre, places[(i + 1) % 3], places[(i + 2) % 3]}, i,
        placement_.teams[0].robots[i].load / placement_.weight());
  add_supports(true);
}

// Lines of equal load on springs, like contour lines of a tilted board, and the direction in which
// it sinks.
void StepFigures::by_springs() {
  constexpr int lines = 7;
  const Sinking sinking = sinking_of(placement_);
  const double steep = length(sinking.slope), size = trace_.polygon().diameter();
  if (steep * size > tau * placement_.weight()) {
    const Vec2 down = sinking.slope / steep, across = left_normal(down) * (size / 2);
    for (int i = 0; i < lines; ++i) {
      const double ahead = (i - lines / 2) * size / lines;
      const Vec2 middle = trace_.centre + ahead * down;
      const double load = sinking.level + ahead * steep;
      if (load >= 0) add(FigureKind::level, Points{middle - across, middle + across}, {}, load);
    }
    add(FigureKind::sinks, Points{trace_.centre, trace_.centre + size / 4 * down});
  }
  add_supports(true);
}

void StepFigures::extremes() { add_supports(true); }

void StepFigures::falls() {
  add(FigureKind::base, placement_.lifting_base);
  const std::vector<std::uint32_t> over = equilibrium(placement_).tips_over;
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  if (over.size() == 2)
    add(FigureKind::side, Points{robots[over[0]].point.position, robots[over[1]].point.position});
  add_supports(false);
}

void StepFigures::add_supports(bool loaded) {
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  for (std::uint32_t i = 0; i < robots.size(); ++i)
    add(FigureKind::robot, Points{robots[i].point.position}, i, loaded ? robots[i].load : 0);
}

}  // namespace evenlift
