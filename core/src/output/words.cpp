#include "evenlift/output/words.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "evenlift/formats.h"

namespace evenlift {

std::string fixed(double value, int decimals) {
  double unit = 1;
  for (int i = 0; i < decimals; ++i) unit *= 10;
  const double scaled = std::floor(std::abs(value) * unit + 0.5);
  if (!(scaled < 1e15)) return shortest(value);
  std::string digits = std::to_string(static_cast<std::int64_t>(scaled));
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, 1, '.');
  return value < 0 && scaled > 0 ? "-" + digits : digits;
}

int decimals_for(double largest) {
  int decimals = 0;
  for (double size = std::abs(largest); size < 99.95 && decimals < 9; size *= 10) ++decimals;
  return decimals;
}

std::string percentage(double share) {
  const double percent = 100 * share;
  if (percent <= 0 || percent >= 100) return percent <= 0 ? "0 %" : "100 %";
  const bool near_an_end = percent < 9.95 || percent > 99;
  const std::string text =
      near_an_end ? fixed(std::clamp(percent, 0.1, 99.9), 1) : fixed(percent, 0);
  return text + " %";
}

std::string loads_in_words(const Placement& placement) {
  const std::size_t teams = placement.teams.size();
  if (teams == 0)
    return placement.candidates.empty()
               ? "No team can be placed: no chord through the centre of mass is even enough."
               : "No team can be placed.";
  const LoadSummary& loads = *placement.loads;
  const int decimals = decimals_for(loads.max);
  const std::string least = fixed(loads.min, decimals), most = fixed(loads.max, decimals);
  std::string text = std::to_string(2 * teams) + " robots, each " + least;
  if (least != most) text += "–" + most;
  text += " kg of " + shortest(placement.settings.weight) + ".";
  if (teams < placement.requested_teams)
    text += " Only " + std::to_string(teams) + " of the " +
            std::to_string(placement.requested_teams) + " teams asked for could be placed.";
  return text;
}

std::string coverage_in_words(const Placement& placement) {
  if (placement.hull.size() < 3) return "They stand on one line, so the object can tip.";
  if (placement.coverage >= 1) return "All of the object is safe to push on.";
  return percentage(placement.coverage) + " of the object is safe to push on.";
}

std::string closure_in_words(const Placement& placement) {
  const Closure& closure = placement.closure;
  if (closure.form_closure) return "It cannot move: form closure.";
  if (closure.second_order) return "It cannot move, though only to second order.";
  if (!closure.margin) return "Nothing keeps it from sliding or turning.";
  const bool clockwise = closure.clockwise.exists,
             counterclockwise = closure.counterclockwise.exists;
  std::string turn = clockwise && counterclockwise ? "turn either way"
                     : clockwise                   ? "turn clockwise"
                     : counterclockwise            ? "turn counter-clockwise"
                                                   : "";
  if (closure.translation_free) turn += turn.empty() ? "slide" : " and slide";
  return "It can still " + turn + ".";
}

std::string verdict(const Placement& placement) {
  if (placement.teams.empty()) return loads_in_words(placement);
  return loads_in_words(placement) + " " + coverage_in_words(placement) + " " +
         closure_in_words(placement);
}

}  // namespace evenlift
