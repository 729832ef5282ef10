#include <algorithm>
#include <cmath>
#include <utility>

#include "import/dxf/drawing.h"

namespace evenlift {
namespace {

constexpr DxfName bad_degree{"spline of a degree outside 1 to 10",
                             "splines of a degree outside 1 to 10"};
constexpr DxfName fit_points{"spline that has only fit points",
                             "splines that have only fit points"};
constexpr DxfName no_points{"spline without control points", "splines without control points"};
constexpr DxfName few_points{"spline with too few control points for its degree",
                             "splines with too few control points for their degree"};
constexpr DxfName bad_count{"spline whose number of knots does not fit its control points",
                            "splines whose number of knots does not fit their control points"};
constexpr DxfName bad_order{"spline whose knots are out of order",
                            "splines whose knots are out of order"};
constexpr DxfName no_length{"spline whose knots are all equal",
                            "splines whose knots are all equal"};
constexpr DxfName bad_weights{"spline whose number of weights does not fit its control points",
                              "splines whose number of weights does not fit their control points"};
constexpr DxfName bad_weight{"spline with a weight of 0 or less",
                             "splines with a weight of 0 or less"};
constexpr DxfName in_parts{"spline of several separate parts", "splines of several separate parts"};

struct Spline {
  std::size_t degree = 3;
  Points control;
  std::vector<double> knots, weights;
  bool has_fit_points = false;
};

Spline read_spline(DxfEntity& entity) {
  Spline spline;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) spline.control.push_back({entity.number(group), 0});
    if (group.code == 20 && !spline.control.empty()) spline.control.back().y = entity.number(group);
    if (group.code == 40) spline.knots.push_back(entity.number(group));
    if (group.code == 41) spline.weights.push_back(entity.number(group));
    spline.has_fit_points = spline.has_fit_points || group.code == 11;
  }
  spline.degree = static_cast<std::size_t>(std::clamp(entity.number_of(71, 3), 0.0, 99.0));
  return spline;
}

template <class Value>
void repeat_first(std::vector<Value>& values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) values.push_back(Value(values[i]));
}

void repeat_first_points(Spline& spline) {
  const bool weighted = spline.weights.size() == spline.control.size();
  repeat_first(spline.control, spline.degree);
  if (weighted) repeat_first(spline.weights, spline.degree);
}

// Some programs omit the first and last knots, which the formula does not use. For closed curves,
// some do not repeat the first control points.
void complete(Spline& spline, bool closed) {
  const std::size_t points = spline.control.size(), degree = spline.degree;
  std::vector<double>& knots = spline.knots;
  if (!knots.empty() && knots.size() + 1 == points + degree) {
    knots.insert(knots.begin(), knots.front());
    knots.push_back(knots.back());
  } else if (closed && points > degree && knots.size() == points + 2 * degree + 1) {
    repeat_first_points(spline);
  }
}

// Whether degree + 1 knots are equal at each end, and those between are evenly spaced.
bool has_even_clamped_knots(const Spline& spline) {
  const std::vector<double>& knots = spline.knots;
  const std::size_t degree = spline.degree, points = spline.control.size();
  const double first = knots.front(), length = knots.back() - first;
  const double spans = static_cast<double>(points - degree);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const std::size_t steps = std::clamp(k, degree, points) - degree;
    const double even = first + length * (static_cast<double>(steps) / spans);
    if (!(std::abs(knots[k] - even) <= 1e-6 * length)) return false;
  }
  return true;
}

// Some versions of LibreCAD write closed curves with the knots of open ones, but LibreCAD draws
// them as closed, with evenly spaced knots.
void make_periodic(Spline& spline) {
  repeat_first_points(spline);
  spline.knots.resize(spline.control.size() + spline.degree + 1);
  for (std::size_t k = 0; k < spline.knots.size(); ++k) spline.knots[k] = static_cast<double>(k);
}

const DxfName* problem(const Spline& spline) {
  const std::size_t points = spline.control.size(), degree = spline.degree;
  const std::vector<double>&knots = spline.knots, &weights = spline.weights;
  const auto positive = [](double weight) { return weight > 0; };
  if (points == 0) return spline.has_fit_points ? &fit_points : &no_points;
  if (degree < 1 || degree > max_spline_degree) return &bad_degree;
  if (points <= degree) return &few_points;
  if (knots.size() != points + degree + 1) return &bad_count;
  if (!std::is_sorted(knots.begin(), knots.end())) return &bad_order;
  if (!(knots[degree] < knots[points])) return &no_length;
  if (!weights.empty() && weights.size() != points) return &bad_weights;
  if (!std::all_of(weights.begin(), weights.end(), positive)) return &bad_weight;
  return nullptr;
}

// If a curve is marked as closed, the first control points are repeated after the last one in two
// cases: if the number of knots includes those for the repetition; or if the curve is also marked as
// periodic, has the evenly spaced knots of an open curve, and its first and last control points
// differ.
DxfDrawn draw_spline(DxfEntity& entity) {
  constexpr int closed = 1, periodic = 2;
  const int flags = entity.flags();
  Spline spline = read_spline(entity);
  complete(spline, (flags & closed) != 0);
  if (const DxfName* reason = problem(spline)) return {{}, nullptr, reason};
  const auto meet = [&](const Vec2& a, const Vec2& b) {
    return max_norm(bounding_box({a, b}).size()) <=
           same_point * max_norm(bounding_box(spline.control).size());
  };
  DxfDrawn drawn;
  drawn.made_periodic = (flags & closed) != 0 && (flags & periodic) != 0 &&
                        has_even_clamped_knots(spline) &&
                        !meet(spline.control.front(), spline.control.back());
  if (drawn.made_periodic) make_periodic(spline);
  std::optional<Outline> curve =
      Outline::b_spline(spline.control, spline.knots, spline.degree, spline.weights);
  if (!curve) return {{}, nullptr, &in_parts};
  if (meet(curve->start, curve->end())) drawn.closed_kind = "closed spline";
  drawn.outline = *std::move(curve);
  return drawn;
}

constexpr Affine behind{-1, 0, 0, 1, 0, 0};
constexpr DxfName mesh{"mesh", "meshes"};

// Mirrors a flat object that is seen from behind.
Outline placed(DxfEntity& entity, Outline outline) {
  return entity.seen_from_behind() ? transformed(outline, behind) : std::move(outline);
}

DxfDrawn draw_vertices(const std::vector<DxfVertex>& vertices, bool closed) {
  if (vertices.empty()) return {};
  Outline outline;
  outline.start = vertices.front().point;
  for (std::size_t i = 1; i < vertices.size(); ++i)
    outline.bulge_to(vertices[i].point, vertices[i - 1].bulge);
  if (closed)
    outline.bulge_to(outline.start, vertices.back().bulge);
  else if (outline.end() == outline.start && vertices.size() > 2)
    closed = true;
  const char* kind = outline.curved() ? "closed polyline with arcs" : "closed polyline";
  return {std::move(outline), closed ? kind : nullptr};
}

// Each vertex begins with an x.
DxfDrawn lightweight_polyline(DxfEntity& entity) {
  std::vector<DxfVertex> vertices;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) vertices.push_back({{entity.number(group), 0}});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().point.y = entity.number(group);
    if (group.code == 42) vertices.back().bulge = entity.number(group);
  }
  DxfDrawn drawn = draw_vertices(vertices, (entity.flags() & 1) != 0);
  drawn.outline = placed(entity, std::move(drawn.outline));
  return drawn;
}

// A polyline with a fitted spline lists its frame's corners (bit 16) before the curve's vertices
// (bit 8).
void drop_spline_frame(std::vector<DxfVertex>& vertices) {
  const auto has = [](int bit) {
    return [bit](const DxfVertex& vertex) { return (vertex.flags & bit) != 0; };
  };
  if (std::any_of(vertices.begin(), vertices.end(), has(8))) std::erase_if(vertices, has(16));
}

DxfDrawn heavy_polyline(DxfEntity& entity) {
  constexpr int closed = 1, in_space = 8, meshes = 16 | 64;
  const int flags = entity.flags();
  if ((flags & meshes) != 0) return {{}, nullptr, &mesh};
  drop_spline_frame(entity.vertices);
  DxfDrawn drawn = draw_vertices(entity.vertices, (flags & closed) != 0);
  if ((flags & in_space) == 0) drawn.outline = placed(entity, std::move(drawn.outline));
  return drawn;
}

DxfDrawn line(DxfEntity& entity) {
  Outline outline;
  outline.start = entity.point_of(10);
  const Vec2 end = entity.point_of(11);
  if (end == outline.start) return {};
  outline.line_to(end);
  return {std::move(outline)};
}

DxfDrawn circle(DxfEntity& entity) {
  const Vec2 centre = entity.point_of(10);
  const double radius = entity.number_of(40, 0);
  if (!(radius > 0)) return {};
  return {placed(entity, Outline::ellipse({radius, 0, 0, radius, centre.x, centre.y})), "circle"};
}

constexpr DxfName no_angle{"arc of no length", "arcs of no length"};

// The angle counter-clockwise from one direction to another, in (0, whole], where `whole` is a full
// turn. Because of rounding, a little more than a full turn counts as one, and a little less than no
// angle as none: 0. Programs leave such arcs at corners.
double angle_from_to(double from, double to, double whole, double near) {
  if (from >= to && from - to < near) return 0;
  const double angle = std::fmod(to - from, whole);
  if (angle <= 0) return angle + whole;
  return angle < near && std::fabs(to - from) > whole / 2 ? whole : angle;
}

DxfDrawn arc(DxfEntity& entity) {
  const Vec2 centre = entity.point_of(10);
  const double radius = entity.number_of(40, 0), from = entity.number_of(50, 0),
               to = entity.number_of(51, 360);
  if (!(radius > 0)) return {};
  const double angle = angle_from_to(from, to, 360, same_point * 180 / pi);
  if (angle == 0) return {{}, nullptr, &no_angle};
  if (!(angle < 360)) return circle(entity);
  const auto at = [&](double degrees) -> Vec2 { return centre + radius * direction_of(degrees); };
  Outline outline;
  outline.start = at(from);
  const Vec2 quarter = direction_of(angle / 4);
  outline.bulge_to(at(to), quarter.y / quarter.x);
  return {placed(entity, std::move(outline))};
}

// Parameters are in radians.
DxfDrawn ellipse(DxfEntity& entity) {
  const Vec2 centre = entity.point_of(10), major = entity.point_of(11);
  const double ratio = entity.number_of(40, 1), from = entity.number_of(41, 0),
               to = entity.number_of(42, 2 * pi);
  // An ellipse has world coordinates. If seen from behind, its minor axis points the other way.
  const Vec2 minor = (entity.seen_from_behind() ? -ratio : ratio) * left_normal(major);
  const Affine frame{major.x, major.y, minor.x, minor.y, centre.x, centre.y};
  const double angle = angle_from_to(from, to, 2 * pi, same_point);
  if (angle == 0) return {{}, nullptr, &no_angle};
  if (angle > 2 * pi - same_point) return {Outline::ellipse(frame), "ellipse"};
  const auto at = [](double parameter) {
    const double turned = std::fmod(parameter, 2 * pi);
    return Vec2(cosine(turned), sine(turned));
  };
  Outline outline;
  outline.start = frame(at(from));
  outline.arc_to(frame, at(from), at(to), true, angle > pi, frame(at(to)));
  return {std::move(outline)};
}

struct Drawer {
  std::string_view type;
  DxfDrawn (*draw)(DxfEntity& entity);
};
constexpr Drawer drawers[] = {
    {"LINE", line},       {"LWPOLYLINE", lightweight_polyline}, {"ARC", arc},
    {"CIRCLE", circle},   {"POLYLINE", heavy_polyline},         {"SPLINE", draw_spline},
    {"ELLIPSE", ellipse},
};

}  // namespace

std::optional<DxfDrawn> draw(DxfEntity& entity) {
  for (const Drawer& drawer : drawers)
    if (drawer.type == entity.type) return drawer.draw(entity);
  return std::nullopt;
}

}  // namespace evenlift
