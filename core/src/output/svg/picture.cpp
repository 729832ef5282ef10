#include "evenlift/output/picture.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/output/label_places.h"

namespace evenlift {
namespace {

void add_area(std::vector<Shape>& shapes, Role role, const Points& points) {
  if (!points.empty()) shapes.push_back({role, points});
}

// Of `count` lines, every stride-th is shown.
std::size_t stride(std::size_t count, std::size_t most) {
  return count <= most ? 1 : (count - 1) / most + 1;
}

// Candidates of no team.
void add_candidates(std::vector<Shape>& shapes, const Placement& placement, std::size_t most) {
  std::vector<bool> taken(placement.candidates.size(), false);
  for (const std::uint32_t i : placement.team_candidates) taken[i] = true;
  for (std::size_t i = 0; i < taken.size(); i += stride(taken.size(), most)) {
    if (taken[i]) continue;
    const Chord& chord = placement.candidates[i].chord;
    shapes.push_back({Role::candidate, {chord.r1.position, chord.r2.position}});
  }
}

void add_cargo(std::vector<Shape>& shapes, const Placement& placement) {
  const std::vector<Cargo>& cargo = placement.settings.cargo;
  if (cargo.empty()) return;
  const std::vector<double> radii = cargo_radii(placement);
  for (std::uint32_t i = 0; i < cargo.size(); ++i)
    shapes.push_back({.role = Role::cargo,
                      .points = {cargo[i].at},
                      .load = cargo[i].weight,
                      .item = i,
                      .radius = radii[i]});
  shapes.push_back({Role::cargo_lever, {placement.own_centre, placement.centre_of_mass}});
  shapes.push_back({Role::own_centre, {placement.own_centre}});
}

}  // namespace

std::vector<double> cargo_radii(const Placement& placement) {
  const Settings& settings = placement.settings;
  const double most = largest_cargo_disc * placement.polygon().diameter();
  double largest = 0;
  std::vector<double> radii;
  for (const Cargo& item : settings.cargo) {
    radii.push_back(std::sqrt(placement.object.area() * (item.weight / settings.weight) / pi));
    largest = std::max(largest, radii.back());
  }
  if (largest > most)
    for (double& radius : radii) radius *= most / largest;
  return radii;
}

std::vector<Segment> joining_lines(const Team& team, const Vec2& centre) {
  const std::vector<Robot>& robots = team.robots;
  if (robots.size() == 2) return {{robots[0].point.position, robots[1].point.position}};
  std::vector<Segment> lines;
  for (const Robot& robot : robots) lines.push_back({robot.point.position, centre});
  return lines;
}

std::vector<TallyStroke> tally(std::size_t team, const Vec2& at, const Vec2& outward,
                               double radius) {
  constexpr double stroke = 7, apart = 5;  // pixels
  const double way = length(outward);
  const Vec2 out = way > 0 ? outward / way : Vec2(0, 1);
  const Vec2 across(-out.y, out.x);
  const std::size_t fives = team / 5, strokes = fives + team % 5;
  std::vector<TallyStroke> marks;
  for (std::size_t i = 0; i < strokes; ++i) {
    const double aside = apart * (static_cast<double>(i) - static_cast<double>(strokes - 1) / 2);
    const Vec2 from = at + radius * out + aside * across;
    marks.push_back({{from, from + stroke * out}, i < fives});
  }
  return marks;
}

std::vector<Shape> make_picture(const Placement& placement, const Overlays& overlays,
                                std::size_t most_lines) {
  std::vector<Shape> shapes;
  shapes.push_back({.role = Role::object,
                    .points = placement.vertices(),
                    .holes = placement.object.rings_of_holes()});
  // Without contacts every point is free: there is no region.
  const bool touches = placement.closure.margin.has_value();
  if (touches && overlays.clockwise)
    add_area(shapes, Role::clockwise, placement.closure.clockwise.clipped);
  if (touches && overlays.counterclockwise)
    add_area(shapes, Role::counterclockwise, placement.closure.counterclockwise.clipped);
  if (overlays.lifting_base) add_area(shapes, Role::lifting_base, placement.lifting_base);
  // Balanced robots and supports have no candidates.
  if (overlays.candidates && !is_one_team(placement.settings.method))
    add_candidates(shapes, placement, most_lines);
  const auto teams = static_cast<std::uint32_t>(placement.teams.size());
  if (overlays.chords) {
    const auto step = static_cast<std::uint32_t>(stride(placement.teams.size(), most_lines));
    for (std::uint32_t i = 0; i < teams; i += step) {
      for (const Segment& line : joining_lines(placement.teams[i], placement.centre_of_mass))
        shapes.push_back({Role::chord, {line.from, line.to}, i});
    }
  }
  add_cargo(shapes, placement);
  shapes.push_back({Role::centre_of_mass, {placement.centre_of_mass}});
  // The first teams matter most and are on top.
  for (std::uint32_t i = teams; i-- > 0;) {
    for (const Robot& robot : placement.teams[i].robots)
      shapes.push_back({Role::robot, {robot.point.position}, i, robot.load});
  }
  return shapes;
}

}  // namespace evenlift

namespace evenlift::labels {

namespace {

// A cost of 1 is one pixel farther away.
constexpr double cost_of_edge = 60;
constexpr double cost_of_inside = 40;
constexpr double cost_of_chord = 25;
constexpr double cost_of_turning = 24;  // to the opposite side
constexpr int directions = 24;
constexpr double distances[] = {5, 12, 22};
constexpr double room = 2;                    // between two labels
constexpr std::size_t large_outline = 20000;  // has no visible interior

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

Box grown(const Box& box, double by) {
  const Vec2 margin(by, by);
  return {box.low - margin, box.high + margin};
}

bool contains(const Box& box, const Box& inner) {
  return box.low.x <= inner.low.x && box.low.y <= inner.low.y && inner.high.x <= box.high.x &&
         inner.high.y <= box.high.y;
}

Box bounds(const Segment& s) {
  return {Vec2(std::min(s.first.x, s.second.x), std::min(s.first.y, s.second.y)),
          Vec2(std::max(s.first.x, s.second.x), std::max(s.first.y, s.second.y))};
}

bool touches(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// Whether the segment's bounds touch the box, which has corners on both sides of the segment's
// line.
bool meets(const Segment& s, const Box& box) {
  if (!touches(bounds(s), box)) return false;
  const Vec2 along = s.second - s.first;
  bool left = false, right = false;
  for (const Vec2& corner :
       {box.low, box.high, Vec2(box.low.x, box.high.y), Vec2(box.high.x, box.low.y)}) {
    const double side = cross(along, Vec2(corner - s.first));
    left = left || side >= 0;
    right = right || side <= 0;
  }
  return left && right;
}

// The box of `size` in this direction that touches `owner` grown by `distance`.
Box beside(const Box& owner, const Vec2& size, double distance, const Vec2& direction) {
  const Vec2 half = (owner.high - owner.low) / 2;
  const Vec2 middle = owner.low + half;
  // Diagonal places are mostly on an ellipse: touching corners would look too far apart.
  const Vec2 reach = half + size / 2 + Vec2(distance, distance);
  const double scale =
      1 / std::max(std::abs(direction.x) / reach.x, std::abs(direction.y) / reach.y);
  const double rounder = 1 / length(Vec2(direction.x / reach.x, direction.y / reach.y));
  const double corner = std::min(std::abs(direction.x), std::abs(direction.y));
  const Vec2 at = middle + direction * (corner < 0.2 ? scale : 0.35 * scale + 0.65 * rounder);
  return {at - size / 2, at + size / 2};
}

struct Nearby {
  std::vector<Segment> edges, chords;
};

Nearby near(const Request& request, const Surroundings& around) {
  const double reach = 2 * (request.size.x + request.size.y) + distances[2];
  const Box area = grown(request.owner, reach);
  Nearby nearby;
  const auto add_edges = [&](const Points& p) {
    for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++)
      if (touches(bounds({p[j], p[i]}), area)) nearby.edges.push_back({p[j], p[i]});
  };
  add_edges(around.outline);
  for (const Points& hole : around.holes) add_edges(hole);
  for (const Segment& chord : around.chords)
    if (touches(bounds(chord), area)) nearby.chords.push_back(chord);
  return nearby;
}

class Placer {
 public:
  Placer(const std::vector<Request>& requests, const Surroundings& around)
      : requests_(requests), around_(around), places_(requests.size()) {
    for (const Request& request : requests) nearby_.push_back(near(request, around));
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * pi * k / directions;
      compass_.emplace_back(cosine(angle), sine(angle));
    }
  }

  void place_all() {
    for (std::size_t i = 0; i < requests_.size(); ++i) place_one(i);
  }

  std::vector<std::optional<Box>> places() const { return places_; }

 private:
  void place_one(std::size_t i) {
    places_[i].reset();
    const Request& request = requests_[i];
    std::optional<double> least;
    for (const double distance : distances)
      for (const Vec2& direction : compass_) {
        const Box box = beside(request.owner, request.size, distance, direction);
        if (!allowed(i, box)) continue;
        const double cost =
            distance + cost_of_direction(request, direction) + cost_of_place(i, box);
        if (least && cost >= *least) continue;
        least = cost;
        places_[i] = box;
      }
  }

  bool allowed(std::size_t i, const Box& box) const {
    if (!contains(around_.frame, box)) return false;
    const Box with_room = grown(box, room);
    for (const Box& mark : around_.marks)
      if (overlap(mark, with_room)) return false;
    for (std::size_t j = 0; j < requests_.size(); ++j) {
      if (overlap(requests_[j].owner, box)) return false;
      if (j != i && places_[j] && overlap(*places_[j], with_room)) return false;
    }
    return true;
  }

  static double cost_of_direction(const Request& request, const Vec2& direction) {
    const double size = length(request.away);
    return size > 0 ? cost_of_turning * (1 - dot(request.away, direction) / size) / 2 : 0;
  }

  double cost_of_place(std::size_t i, const Box& box) const {
    double cost = 0;
    const Box with_room = grown(box, room);
    for (const Segment& edge : nearby_[i].edges)
      if (meets(edge, with_room)) {
        cost += cost_of_edge;
        break;
      }
    for (const Segment& chord : nearby_[i].chords)
      if (meets(chord, box)) cost += cost_of_chord;
    const Vec2 middle = (box.low + box.high) / 2;
    if (on_object(middle)) cost += cost_of_inside;
    return cost;
  }

  bool on_object(const Vec2& at) const {
    return around_.outline.size() <= large_outline && inside(around_.outline, at) &&
           std::none_of(around_.holes.begin(), around_.holes.end(),
                        [&](const Points& hole) { return inside(hole, at); });
  }

  const std::vector<Request>& requests_;
  const Surroundings& around_;
  std::vector<std::optional<Box>> places_;
  std::vector<Nearby> nearby_;
  std::vector<Vec2> compass_;
};

}  // namespace

std::vector<std::optional<Box>> place(const std::vector<Request>& requests,
                                      const Surroundings& around) {
  Placer placer(requests, around);
  placer.place_all();
  placer.place_all();
  return placer.places();
}

}  // namespace evenlift::labels
