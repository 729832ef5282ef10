#include "evenlift/weighing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/numbers.h"
#include "evenlift/predicates.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double error_of(double reading, const ReadingError& error) {
  return error.percent / 100 * reading + error.weight;
}

std::vector<double> errors_of(const std::vector<double>& readings, const ReadingError& error) {
  std::vector<double> errors;
  errors.reserve(readings.size());
  for (const double reading : readings) errors.push_back(error_of(reading, error));
  return errors;
}

// The greatest length of a sum of all vectors, each with either sign: the farthest vertex of a
// zonotope, whose vertices are found by turning one vector after another round. O(m log m).
double longest_sum(Points vectors) {
  std::erase(vectors, Vec2());  // has no direction
  for (Vec2& each : vectors)
    if (each.y < 0 || (each.y == 0 && each.x < 0)) each = -each;
  std::sort(vectors.begin(), vectors.end(),
            [](const Vec2& a, const Vec2& b) { return cross(a, b) > 0; });
  Vec2 sum;
  for (const Vec2& each : vectors) sum += each;
  double longest = length(sum);
  for (const Vec2& each : vectors) {
    sum -= each * 2;
    longest = std::max(longest, length(sum));
  }
  return longest;
}

struct Balance {
  double weight = 0, weight_error = 0;
  Vec2 centre;
  double radius = 0;
};

std::optional<InputError> check_count(Setting setting, const std::vector<double>& readings,
                                      std::size_t supports) {
  if (readings.size() == supports) return std::nullopt;
  return setting_error(setting, say("{readings} readings are given for {supports} supports",
                                    {readings.size(), supports}));
}

std::optional<InputError> check_places(const Points& supports, double near) {
  if (convex_hull(supports, near).size() >= 3) return std::nullopt;
  return setting_error(
      Setting::readings,
      supports.size() == 1
          ? "one support does not tell where C is: weigh with three or more"
          : "the supports are on one line, so C is known along that line only: turn "
            "the object and weigh it again, or weigh with three supports");
}

// The supports must not be on one line.
Result<Balance> balance_of(const Points& supports, const std::vector<double>& readings,
                           const ReadingError& error, Setting setting) {
  Balance found;
  found.weight = sum_of(readings);
  if (!(found.weight >= min_weight))
    return setting_error(setting, "all readings are 0: nothing stands on the supports");
  const std::vector<double> errors = errors_of(readings, error);
  found.weight_error = sum_of(errors);
  if (!(found.weight_error < found.weight))
    return setting_error(
        Setting::reading_error,
        say("the readings may be off by {error} in all, as much as they read, "
            "{weight}: then nothing is known",
            {as_read(shortest(found.weight_error)), as_read(shortest(found.weight))}));
  // About the first support: coordinates may be far larger than distances.
  const Vec2& origin = supports.front();
  Vec2 moment;
  for (std::size_t i = 0; i < supports.size(); ++i)
    moment += (supports[i] - origin) * (readings[i] / found.weight);
  found.centre = origin + moment;
  Points arms;
  for (std::size_t i = 0; i < supports.size(); ++i)
    arms.push_back((supports[i] - found.centre) * errors[i]);
  found.radius = longest_sum(std::move(arms)) / (found.weight - found.weight_error);
  return found;
}

std::optional<InputError> check_inside(const Points& supports, const Vec2& centre, double near) {
  const Points hull = convex_hull(supports, near);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (orient(a, b, centre) / length(b - a) <= near)
      return setting_error(
          Setting::readings,
          "C is at the edge of the supports' hull, since those that carry are on one line: the object "
          "may tip, and C is known only if three that are not on one line carry");
  }
  return std::nullopt;
}

// P, for those that carry, in a frame in which P_ij = [i = j] - (1 + q_i . q_j) / m.
void compare_with_springs(Weighing& weighing, const Points& supports,
                          const std::vector<double>& readings, const ReadingError& error,
                          double unit) {
  std::vector<std::size_t> carrying;
  Points places;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!(readings[i] > 0)) continue;
    carrying.push_back(i);
    places.push_back((supports[i] - weighing.centre) / unit);
  }
  if (carrying.size() < 4) return;
  const StandardFrame frame = standard_frame(places);
  if (frame.axis[1] == Vec2()) return;
  for (Vec2& place : places) place = frame(place);
  const auto m = static_cast<double>(carrying.size());
  for (std::vector<double>* each :
       {&weighing.residuals, &weighing.slack, &weighing.spread, &weighing.own_part})
    each->assign(readings.size(), 0);
  for (std::size_t k = 0; k < carrying.size(); ++k) {
    const std::size_t i = carrying[k];
    for (std::size_t l = 0; l < carrying.size(); ++l) {
      const double p = (k == l ? 1 : 0) - (1 + dot(places[k], places[l])) / m;
      const double reading = readings[carrying[l]];
      weighing.residuals[i] += p * reading;
      weighing.slack[i] += std::fabs(p) * error_of(reading, error);
      weighing.spread[i] += std::fabs(p);
      if (k == l) weighing.own_part[i] = p;
    }
  }
}

// The second weighing.
Result<std::optional<Weighing::Height>> height_of(const Weighing& first, const Points& supports,
                                                  const Settings& settings) {
  const Weighed& weighed = settings.weighed;
  if (weighed.tilted_readings.empty()) return std::optional<Weighing::Height>();
  if (!(weighed.tilted > 0))
    return setting_error(Setting::tilted,
                         "the second weighing needs its slope, such as 8% or 5deg");
  if (!weighed.heading)
    return setting_error(Setting::heading,
                         "the second weighing needs the direction uphill, such as 1,0");
  if (auto wrong = check_count(Setting::readings_tilted, weighed.tilted_readings, supports.size()))
    return *std::move(wrong);
  const auto second =
      balance_of(supports, weighed.tilted_readings, weighed.error, Setting::readings_tilted);
  if (!second) return second.error();
  const Vec2 uphill = *weighed.heading / length(*weighed.heading);
  Weighing::Height found;
  found.height = dot(first.centre - second->centre, uphill) / weighed.tilted;
  found.error = (first.radius + second->radius) / weighed.tilted;
  const double cosine = 1 / std::sqrt(1 + weighed.tilted * weighed.tilted);
  const double off = first.weight_error + second->weight_error + tau * first.weight;
  found.fits = std::fabs(second->weight - first.weight) <= off ||
               std::fabs(second->weight - first.weight * cosine) <= off;
  return std::optional(found);
}

}  // namespace

bool is_weighed(const Settings& settings) {
  return settings.method == Method::given && !settings.weighed.readings.empty();
}

Result<Weighing> weigh(const Points& supports, const Settings& settings, double diameter) {
  const Weighed& weighed = settings.weighed;
  if (auto wrong = check_count(Setting::readings, weighed.readings, supports.size()))
    return *std::move(wrong);
  const double near = near_distance(diameter);
  if (auto wrong = check_places(supports, near)) return *std::move(wrong);
  const auto level = balance_of(supports, weighed.readings, weighed.error, Setting::readings);
  if (!level) return level.error();
  if (auto wrong = check_inside(supports, level->centre, near)) return *std::move(wrong);
  double cargo = 0;
  for (const Cargo& item : settings.cargo) cargo += item.weight;
  if (!(level->weight > cargo))
    return setting_error(
        Setting::readings,
        say("the readings add up to {weight}, no more than the cargo alone, {cargo}",
            {as_read(shortest(level->weight)), as_read(shortest(cargo))}));
  Weighing found;
  found.weight = level->weight;
  found.weight_error = level->weight_error;
  found.centre = level->centre;
  found.radius = level->radius;
  compare_with_springs(found, supports, weighed.readings, weighed.error, diameter);
  auto height = height_of(found, supports, settings);
  if (!height) return height.error();
  found.height = *height;
  return found;
}

ReadingsFit fit_of(const Weighing& weighing, const Carrying& carrying) {
  ReadingsFit result;
  const std::size_t m = weighing.residuals.size();
  std::size_t carry = 0;
  for (const double part : weighing.spread) carry += part > 0 ? 1 : 0;
  const double uneven = carrying.give && carry > 0 ? weighing.weight / static_cast<double>(carry) *
                                                         (carrying.uneven / *carrying.give)
                                                   : 0;
  const double rounding = tau * weighing.weight;
  for (std::size_t i = 0; i < m; ++i)
    result.fit &= std::fabs(weighing.residuals[i]) <=
                  weighing.slack[i] + uneven * weighing.spread[i] + rounding;
  if (result.fit) return result;
  // P_ii is the square of the distance of a reading from those that springs explain.
  constexpr double least_part = 1e-6;
  double greatest = 0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < m; ++i) {
    const double part = weighing.own_part[i];
    result.too_little.push_back(part > least_part ? -weighing.residuals[i] / part : 0);
    if (!(part > least_part)) continue;
    const double size = std::fabs(weighing.residuals[i]) / std::sqrt(part);
    if (size > greatest * (1 + tau)) {
      greatest = size;
      result.suspect = i;
      number = 1;
    } else if (size >= greatest * (1 - tau)) {
      ++number;
    }
  }
  if (number != 1 || carry < 5) result.suspect.reset();
  return result;
}

OwnMass own_mass(const Weighing& weighing, const Settings& settings) {
  OwnMass own{weighing.weight, {}};
  for (const Cargo& item : settings.cargo) own.weight -= item.weight;
  Vec2 moment;  // about C
  for (const Cargo& item : settings.cargo)
    moment += (item.at - weighing.centre) * (item.weight / own.weight);
  own.centre = weighing.centre - moment;
  return own;
}

double radius_of(const Weighing& weighing, const Settings& settings, double height) {
  return weighing.radius + settings.accuracy.value_or(0) + height * settings.weighed.level_error;
}

Shown as_weighed(const Weighing& weighing, const Settings& settings, Shown shown) {
  double& height = shown.carrying.com_height;
  if (weighing.height)
    height = std::clamp(weighing.height->height + weighing.height->error, height, max_length);
  const double radius = radius_of(weighing, settings, height);
  shown.carrying.weight_doubt =
      std::max(shown.carrying.weight_doubt, weighing.weight_error / weighing.weight);
  shown.com_radius = std::clamp(radius, shown.com_radius, std::max(shown.com_radius, max_length));
  return shown;
}

Document taken_over(Document document, const Weighing& weighing) {
  const OwnMass own = own_mass(weighing, document.settings);
  document.shown = as_weighed(weighing, document.settings, std::move(document.shown));
  document.settings.weight = own.weight;
  document.centre_of_mass = own.centre;
  document.settings.weighed = {};
  return document;
}

std::optional<Document> settled_after_edit(const Document& edited, const Document& before,
                                           const Weighing& weighing) {
  const Settings &now = edited.settings, &then = before.settings;
  if (now.weighed.readings.empty() || !(now.weighed == then.weighed)) return std::nullopt;
  const bool weight_is_given = now.weight != Settings{}.weight;
  const bool apply = now.method == Method::given && now.supports.size() == then.supports.size() &&
                     now.cargo == then.cargo && !edited.centre_of_mass && !weight_is_given;
  if (apply) return std::nullopt;
  const Document told = taken_over(before, weighing);
  Document settled = edited;
  settled.settings.weighed = {};
  if (!weight_is_given) settled.settings.weight = told.settings.weight;
  if (!edited.centre_of_mass) settled.centre_of_mass = told.centre_of_mass;
  settled.shown.com_radius = told.shown.com_radius;
  settled.shown.carrying.com_height = told.shown.carrying.com_height;
  settled.shown.carrying.weight_doubt = told.shown.carrying.weight_doubt;
  return settled;
}

}  // namespace evenlift
