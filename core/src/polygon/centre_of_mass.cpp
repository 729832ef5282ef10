#include "evenlift/centre_of_mass.h"

#include <cmath>
#include <string>
#include <utility>

#include "evenlift/predicates.h"
#include "polygon/coordinates.h"

namespace evenlift {
namespace {

InputError at_centre(ErrorCode code, std::string message) {
  return {code, std::move(message), {Place::Kind::centre_of_mass, 0, 0, {}}};
}

std::optional<InputError> check_coordinates(const Vec2& centre) {
  if (!is_finite(centre))
    return at_centre(ErrorCode::bad_coordinate,
                     "a coordinate of the centre of mass is not a finite number");
  if (max_norm(centre) > max_coordinate)
    return at_centre(ErrorCode::bad_coordinate,
                     "a coordinate of the centre of mass exceeds 1e9 in size");
  if (is_too_near_to_0(centre))
    return at_centre(ErrorCode::bad_coordinate,
                     "a coordinate of the centre of mass is below 1e-100 in size but not 0");
  return std::nullopt;
}

// Far cargo may make numbers overflow; then the point is outside.
bool is_strictly_in_hull(const Polygon& polygon, const Vec2& point) {
  if (!is_finite(point)) return false;
  const Points& hull = polygon.hull();
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (!(orient(hull[i], hull[(i + 1) % hull.size()], point) > 0)) return false;
  return true;
}

}  // namespace

Vec2 with_cargo(const Vec2& own, const Settings& settings) {
  return with_cargo(own, settings, settings.cargo.size()).centre;
}

Result<Vec2> check_centre_of_mass(const Polygon& polygon, const std::optional<Vec2>& given) {
  if (given)
    if (auto error = check_coordinates(*given)) return *std::move(error);
  const Vec2 centre = given.value_or(polygon.centroid());
  if (!is_strictly_in_hull(polygon, centre))
    return at_centre(ErrorCode::centre_outside_hull,
                     "the centre of mass is not inside the convex hull of the polygon");
  return centre;
}

Result<CentreOfMass> centre_of_mass(const PolygonWithHoles& object,
                                    const std::optional<Vec2>& given, const Settings& settings) {
  if (given)
    if (auto error = check_coordinates(*given)) return *std::move(error);
  const Vec2 own = given.value_or(object.centroid());
  const Vec2 all = with_cargo(own, settings);
  if (!is_strictly_in_hull(object, all))
    return at_centre(ErrorCode::centre_outside_hull,
                     settings.cargo.empty()
                         ? "the centre of mass is not inside the convex hull of the polygon"
                         : "with its cargo the centre of mass is not inside the convex hull of the "
                           "polygon");
  return CentreOfMass{own, all};
}

Loaded with_cargo(const Vec2& own, const Settings& settings, std::size_t items) {
  if (items == 0) return {settings.weight, own};
  double weight = settings.weight;
  Vec2 moments;  // about C0
  for (std::size_t i = 0; i < items; ++i) {
    const Cargo& item = settings.cargo[i];
    weight += item.weight;
    moments += item.weight * (item.at - own);
  }
  return {weight, own + moments / weight};
}

}  // namespace evenlift
