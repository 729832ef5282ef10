#include "import/dxf/spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

DxfDrawn draw_spline(DxfEntity& entity, double same_point) {
  constexpr int closed = 1, periodic = 2;
  const int flags = entity.flags_of();
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

}  // namespace evenlift
