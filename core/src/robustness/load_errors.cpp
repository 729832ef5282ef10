#include "robustness/load_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robustness/standard_frame.h"

namespace evenlift {
namespace {

constexpr std::size_t most_exact = 1000;

Points in_units(const Points& robots, const Vec2& centre, double unit) {
  Points places;
  places.reserve(robots.size());
  for (const Vec2& robot : robots) places.push_back((robot - centre) / unit);
  return places;
}

StandardFrame frame_of(const Points& places, const std::vector<double>& loads) {
  Points carrying;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (loads[i] > 0) carrying.push_back(places[i]);
  return carrying.empty() ? StandardFrame{} : standard_frame(carrying);
}

}  // namespace

LoadErrors::LoadErrors(const Points& robots, const Vec2& centre, double unit, double weight,
                       std::vector<double> loads, bool are_planned,
                       std::vector<ErrorDirection> directions)
    : robots_(robots),
      centre_(centre),
      unit_(unit),
      weight_(weight),
      loads_(std::move(loads)),
      are_planned_(are_planned),
      directions_(std::move(directions)),
      places_(in_units(robots, centre, unit)) {
  const StandardFrame frame = frame_of(places_, loads_);
  for (Vec2& place : places_) place = frame(place);
  axis_[0] = frame.axis[0];
  axis_[1] = frame.axis[1];
  of_centre_ = frame({});
  for (const double load : loads_) {
    carrying_ += load > 0 ? 1 : 0;
    total_ += load;
  }
}

Vec2 LoadErrors::derivative(std::size_t i, std::size_t j) const {
  const auto in_plane = [&](const Vec2& q) { return axis_[0] * q.x + axis_[1] * q.y; };
  Vec2 sum = in_plane(places_[i]) * -loads_[j];
  if (!are_planned_ && loads_[j] > 0) {
    const double p = (i == j ? 1.0 : 0.0) - (1 + dot(places_[i], places_[j])) / carrying_;
    sum += in_plane(of_centre_) * (p * weight_);
  }
  return sum / (carrying_ * unit_);
}

double LoadErrors::sum(std::size_t i) const {
  if (!(loads_[i] > 0)) return 0;
  if (loads_.size() > most_exact) {
    // The sum of |P_ij| is at most the root of m, since P is a projection.
    const auto size = [&](const Vec2& q) { return length(axis_[0] * q.x + axis_[1] * q.y); };
    return (size(places_[i]) * total_ +
            (are_planned_ ? 0 : size(of_centre_) * std::sqrt(carrying_) * weight_)) /
           (carrying_ * unit_);
  }
  double sum = 0;
  for (std::size_t j = 0; j < loads_.size(); ++j) sum += dot(derivative(i, j), worst_way(i, j));
  return sum;
}

Vec2 LoadErrors::worst_way(std::size_t i, std::size_t j) const {
  const ErrorDirection& direction = directions_[j];
  const Vec2 by = derivative(i, j);
  switch (direction.kind) {
    case ErrorDirection::Kind::none:
      break;
    case ErrorDirection::Kind::any:
      if (const double size = length(by); size > 0) return by / size;
      break;
    case ErrorDirection::Kind::along: {
      const double first = dot(by, direction.ways[0]), second = dot(by, direction.ways[1]);
      if (std::max(first, second) >= 0) return direction.ways[first < second ? 1 : 0];
    }
  }
  return {};
}

Points LoadErrors::worst_errors(std::size_t i) const {
  Points errors;
  errors.reserve(robots_.size());
  for (std::size_t j = 0; j < robots_.size(); ++j) errors.push_back(worst_way(i, j));
  return errors;
}

Vec2 LoadErrors::other_way(std::size_t j, const Vec2& way) const {
  const ErrorDirection& direction = directions_[j];
  if (direction.kind != ErrorDirection::Kind::along) return -way;
  return direction.ways[way == direction.ways[0] ? 1 : 0];
}

std::vector<double> LoadErrors::planned_at(const Points& robots) const {
  const Points places = in_units(robots, centre_, unit_);
  const StandardFrame frame = frame_of(places, loads_);
  Vec2 moment;  // of the planned loads about C
  for (std::size_t i = 0; i < places.size(); ++i) moment += places[i] * loads_[i];
  const Vec2 in_frame{dot(frame.axis[0], moment), dot(frame.axis[1], moment)};
  std::vector<double> loads;
  loads.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    loads.push_back(loads_[i] > 0 ? loads_[i] - dot(frame(places[i]), in_frame) / carrying_ : 0);
  return loads;
}

}  // namespace evenlift
