#include <algorithm>
#include <cmath>

#include "evenlift/balanced.h"
#include "evenlift/capacity.h"
#include "evenlift/load_models.h"
#include "evenlift/selection.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

// Places any number of robots by the placement's method.
class Placer {
 public:
  explicit Placer(const Placement& placement) : placement_(placement) {}

  bool is_balanced() const { return placement_.settings.method == Method::balanced; }

  // Empty if the method cannot place this number.
  std::vector<Team> teams(std::uint32_t robots) {
    const Settings& settings = placement_.settings;
    const std::size_t number = robots / 2;
    std::vector<Chord> chords;
    switch (settings.method) {
      case Method::distributed:
        chords = distributed_teams(placement_.polygon(), placement_.centre_of_mass, number);
        break;
      case Method::random:
        chords =
            random_teams(placement_.polygon(), placement_.centre_of_mass, number, settings.seed);
        break;
      case Method::balanced:
        return balanced(robots);
      case Method::given:
        return {};
      case Method::area:
      case Method::circle:
      case Method::distance:
        chords = chords_of(placement_.candidates, chosen(number));
    }
    if (chords.size() < number) return {};
    return distribute_weight(chords, total_weight(settings));
  }

 private:
  std::vector<Team> balanced(std::uint32_t robots) const {
    Settings settings = placement_.settings;
    settings.robots = robots;
    const BalancedProblem problem(placement_.object, placement_.centre_of_mass, settings);
    auto search = start_balanced(problem);
    if (!search) return {};
    return {share_evenly(finish_search(problem, *std::move(search)).robots,
                         placement_.centre_of_mass, total_weight(settings))};
  }

  // Without swaps, a smaller choice is the beginning of a larger one.
  std::vector<std::uint32_t> chosen(std::size_t number) {
    const bool swapped = swaps_teams(placement_.settings);
    if (swapped || chosen_.size() < number)
      chosen_ = choose_candidates(placement_.object, placement_.centre_of_mass,
                                  placement_.candidates, placement_.settings,
                                  swapped ? number : 2 * number, placement_.stands.get());
    return {chosen_.begin(),
            chosen_.begin() + static_cast<std::ptrdiff_t>(std::min(number, chosen_.size()))};
  }

  const Placement& placement_;
  std::vector<std::uint32_t> chosen_;
};

// The greatest load, intact or after any one failure; nullopt if the object then falls, or the load
// exceeds the capacity.
std::optional<double> greatest_of_all(const Placement& placement, const std::vector<Team>& teams,
                                      double capacity) {
  const Points all = positions(lifting_points(teams));
  const std::vector<double> planned = planned_loads(teams);
  double greatest = *std::max_element(planned.begin(), planned.end());
  for (std::size_t failed = 0; failed < all.size() && !exceeds(greatest, capacity); ++failed) {
    Points others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(failed));
    const auto springs = spring_loads(others, placement.centre_of_mass,
                                      placement.polygon().diameter(), placement.weight());
    if (!springs) return std::nullopt;
    greatest = std::max(greatest, *std::max_element(springs->loads.begin(), springs->loads.end()));
  }
  return exceeds(greatest, capacity) ? std::nullopt : std::optional(greatest);
}

// After one failure, equal loads are weight / (robots - 1).
std::uint32_t least_that_may_do(const Settings& settings, double capacity, std::uint32_t most) {
  const double number = std::ceil(total_weight(settings) / (capacity * (1 + tau))) + 1;
  const auto by_weight = static_cast<std::uint32_t>(std::clamp(number, 3.0, most + 1.0));
  const bool balanced = settings.method == Method::balanced;
  if (balanced && settings.survive > 0) return std::max(by_weight, 2 * settings.survive + 3);
  return balanced ? by_weight : by_weight + by_weight % 2;
}

}  // namespace

FailurePlan plan_for_failures(const Placement& placement, double capacity) {
  if (placement.settings.method == Method::given) return {};
  Placer method(placement);
  const bool balanced = method.is_balanced();
  const std::uint32_t most = balanced ? most_robots : 2 * most_teams_tried(placement.settings),
                      step = balanced ? 1 : 2;
  const std::uint32_t least = least_that_may_do(placement.settings, capacity, most);
  FailurePlan plan;
  plan.tried = least - 1;
  std::uint64_t loads = 0;
  for (std::uint32_t robots = least; robots <= most; robots += step) {
    if (balanced && robots >= least + most_sets_planned) break;
    loads += std::uint64_t{robots} * robots;
    if (loads > most_loads_planned) break;
    if (swaps_teams(placement.settings) &&
        check_swaps(placement.candidates.size(), robots / 2, placement.stands.get()))
      break;
    const std::vector<Team> teams = method.teams(robots);
    if (teams.empty() && !balanced) break;
    plan.tried = robots;
    if (teams.empty()) continue;
    if (const auto greatest = greatest_of_all(placement, teams, capacity))
      return {true, robots, *greatest, robots};
  }
  return plan;
}

}  // namespace evenlift
