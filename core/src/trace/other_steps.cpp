// How each item of cargo moves the centre of mass.
#include <algorithm>

#include "evenlift/placed_robots.h"
#include "evenlift/stability.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "trace/step_rows.h"

namespace evenlift {

void StepNumbers::cargo() {
  const Cargo& item = placement_.settings.cargo[item_];
  const Loaded before = with_cargo(item_), after = with_cargo(item_ + std::size_t{1});
  count("cargo", item_ + std::size_t{1});
  add("weight", item.weight);
  point("x", "y", item.at);
  add("total_weight", after.weight);
  point("centre_x", "centre_y", after.centre);
  add("moved_by", length(after.centre - before.centre));
}

// The lever from the former centre of mass to the item turns about the new one.
void StepFigures::cargo() {
  const Cargo& item = placement_.settings.cargo[item_];
  const Vec2 before = with_cargo(item_).centre;
  add(FigureKind::lever, Points{before, item.at});
  add(FigureKind::old_centre, Points{before});
  add(FigureKind::cargo, Points{item.at}, item_, item.weight);
  centre_ = with_cargo(item_ + std::size_t{1}).centre;
}

// --- For robots with a size: the usable boundary, and what obstructs the rest.

namespace {

double size_of(const Stretch& stretch) { return stretch.to - stretch.from; }

LiftingPoint contact_at(const Polygon& polygon, std::uint32_t edge, const Stretch& stretch) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  return {p + (stretch.from + stretch.to) / 2 / length(q - p) * (q - p), edge};
}

// The middle of the longest usable range.
LiftingPoint roomiest(const Polygon& polygon, const Stands& stands) {
  std::uint32_t edge = 0;
  Stretch longest;
  for (std::uint32_t e = 0; e < polygon.size(); ++e)
    for (const Stretch& stretch : stands.room(e))
      if (size_of(stretch) > size_of(longest)) {
        longest = stretch;
        edge = e;
      }
  return contact_at(polygon, edge, longest);
}

}  // namespace

StandsDetail look_at_stands(const Trace& trace) {
  const Stands& stands = *trace.placement.stands;
  const std::vector<UnusablePart>& parts = stands.unusable();
  StandsDetail detail;
  for (std::uint32_t edge = 0; edge < trace.polygon().size(); ++edge) {
    detail.boundary += length(trace.polygon().edge_end(edge) - trace.polygon().edge_start(edge));
    for (const Stretch& stretch : stands.room(edge)) detail.usable += size_of(stretch);
  }
  std::array<std::uint32_t, why_unusable_count> longest;
  longest.fill(no_index);
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const auto why = static_cast<std::size_t>(parts[i].why);
    detail.lost[why] += size_of(parts[i].part);
    if (longest[why] == no_index || size_of(parts[i].part) > size_of(parts[longest[why]].part))
      longest[why] = i;
  }
  if (!stands.has_body()) return detail;
  detail.fits = roomiest(trace.polygon(), stands);
  for (const WhyUnusable why : {WhyUnusable::body, WhyUnusable::arm, WhyUnusable::corner,
                                WhyUnusable::hand, WhyUnusable::hole, WhyUnusable::near_no_go}) {
    const std::uint32_t part = longest[static_cast<std::size_t>(why)];
    if (part == no_index) continue;
    detail.misfits.push_back(
        {part, contact_at(trace.polygon(), parts[part].edge, parts[part].part)});
  }
  return detail;
}

void StepNumbers::stands() {
  const StandsDetail& stands = *detail_.stands;
  add("boundary", stands.boundary);
  add("usable", stands.usable / stands.boundary);
  for (std::size_t why = 0; why < why_unusable_count; ++why)
    if (stands.lost[why] > 0)
      add(name(static_cast<WhyUnusable>(why)), stands.lost[why] / stands.boundary);
}

void StepFigures::stands() {
  const std::vector<UnusablePart>& parts = placement_.stands->unusable();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const Vec2 &p = trace_.polygon().edge_start(parts[i].edge),
               &q = trace_.polygon().edge_end(parts[i].edge);
    const Vec2 along = (q - p) / length(q - p);
    add(FigureKind::unusable, Points{p + parts[i].part.from * along, p + parts[i].part.to * along},
        i);
  }
  for (const auto& [part, contact] : detail_.stands->misfits) add_body(contact, part);
  if (detail_.stands->fits) add_body(*detail_.stands->fits, {});
}

void StepFigures::add_body(const LiftingPoint& contact, std::optional<std::uint32_t> part) {
  const RobotSize& robot = placement_.stands->robot();
  const LiftingPoint lifting = placement_.stands->lifting_point(contact);
  const Vec2 stand = placement_.stands->stand(lifting);
  const Vec2 &p = trace_.polygon().edge_start(contact.edge),
             &q = trace_.polygon().edge_end(contact.edge);
  const Vec2 aside = robot.width / 2 / length(q - p) * (q - p);
  if (robot.reach > 0) add(FigureKind::hand, Points{stand, contact.position}, part);
  if (robot.depth > 0 && robot.width > 0)
    add(FigureKind::hand,
        Points{contact.position - aside, contact.position + aside, lifting.position + aside,
               lifting.position - aside},
        part);
  else if (robot.depth > 0)
    add(FigureKind::hand, Points{contact.position, lifting.position}, part);
  else if (robot.width > 0)
    add(FigureKind::hand, Points{contact.position - aside, contact.position + aside}, part);
  if (robot.radius > 0) add(FigureKind::body, Points{stand}, part, robot.radius);
}

// --- Where given supports stand, and what each carries.

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
  const auto& models = trace_.report.models;
  add("springs", placement_.loads->max);
  add("best", models->best);
  add("worst", *std::max_element(models->worst.begin(), models->worst.end()));
}

void StepNumbers::falls() { add("com_margin", trace_.report.equilibrium.com_margin); }

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
  const std::vector<std::uint32_t>& over = trace_.report.equilibrium.tips_over;
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
