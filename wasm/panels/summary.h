// The verdict at the top of the panel, and the whole result in words for users who cannot see the
// canvas.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

enum class Mood : std::uint8_t { good, not_quite, falls, refused, drawing };

struct Verdict {
  Mood mood = Mood::good;
  std::string headline;    // "6 robots carry 15.2–18.1 kg each (100 kg in all)."
  std::string detail;      // "81 % of the object can be pressed down on without tipping it. …"
  bool searching = false;  // balanced robots may change
};

// In the panel, which has the weight (on a phone once it is pulled up), the headline omits it (but not that of cargo), and the detail
// begins with what is amiss. Elsewhere the words are those of the program.
enum class Words : std::uint8_t { in_panel, of_program };
Verdict verdict(const AppState& state, Words words = Words::of_program);

// The verdict's assumptions about the robots; empty if the verdict is not about placed robots.
std::string presumed_in_words(const AppState& state);

// The mood after a robot's failure: `falls` if the other robots do not carry the object, or if it
// tips under the given conditions; `not_quite` if a press may tip it or a robot is overloaded; and
// otherwise `good`.
Mood mood_of(const AppState& state, const std::optional<RestOfRobots>& rest);

// Describes what happens if the robot with this number, from 0, fails; empty if unknown.
std::string failure_words(const AppState& state, std::size_t robot);

// Texts like "4", "29.1 kg", "8.2 kg", "61 %", "held". The loads are empty if the object falls.
struct ScoreInWords {
  std::string robots, most, spread, covered, held;
};
ScoreInWords score_of(const Reported& reported);

// Whether some robot carries more than its capacity if none fails, or whether the robot with this
// number, from 0, does so according to the shown loads.
bool is_overloaded(const AppState& state);
bool is_overloaded(const AppState& state, std::size_t robot);

// The score of robots placed by hand, such as
// "4 robots · at most 29.0 kg · spread 8.0 kg · 64 % covered · not held".
std::string score(const AppState& state);

// Says whether each robot stays within its capacity, unless the verdict says it, and how many robots
// are needed; empty if no capacity is given.
std::string need_in_words(const AppState& state, bool with_overloaded = true);

// model_words() states the assumptions of the shown loads, and uncertainty_words() the effect of
// the disturbance (uncertainty.h), each in a sentence or two. Both are empty for the plan without a
// disturbance.
std::string model_words(const AppState& state);
std::string uncertainty_words(const AppState& state);

// The slope at which the object tips (tilt.h), and the places where a further load may stand; empty
// if the user asks about neither.
std::string carrying_words(const AppState& state);
std::string weighing_words(const AppState& state);  // empty without readings

// The unit of weights, such as "kg".
std::string weight_unit(const AppState& state);

// Whole sentences about everything on the screen that the link lacks; empty if it lacks nothing.
std::string link_lacks_in_words(const AppState& state);

// The verdict, teams and loads, each in a sentence. This is the text of the page's live region.
// O(teams).
std::string summary(const AppState& state);

// What the summary lacks: the selection, the tool, snapping, which overlays are shown or hidden,
// and the comparison, each on its own line. O(n).
std::string news(const AppState& state);

}  // namespace evenlift::view
