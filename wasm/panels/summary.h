// The result in words: the verdict at the top of the panel, and all of it for those who cannot see
// the canvas.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

enum class Mood : std::uint8_t { good, not_quite, falls, refused, drawing };

struct Verdict {
  Mood mood = Mood::good;
  std::string headline;  // "6 robots carry 15.2–18.1 kg each (100 kg in all)."
  std::string detail;    // "A push down on 81 % of the object does not tip it. It can still slide."
  bool searching = false;  // balanced robots may still change
};

Verdict verdict(const AppState& state);

// What the verdict presumes of the robots; empty where it says nothing of them.
std::string presumed_in_words(const AppState& state);

// What happens if a robot fails: it falls, or it is not quite well because it can tip or a robot is
// overloaded.
Mood mood_of(const AppState& state, const std::optional<RestOfRobots>& rest);

// The same in words, of the robot with this number, from 0: what happens if it fails, if that is
// known.
std::string failure_words(const AppState& state, std::size_t robot);

// Whether a robot carries more than its capacity, by the loads that are shown.
bool is_overloaded(const AppState& state);

// That a robot is overloaded, in a few words; empty if none is.
std::string overload_in_brief(const AppState& state);

// With a capacity of one robot: whether each stays within it, and how many robots are needed; else
// empty.
std::string need_in_words(const AppState& state);

// What the loads that are shown presume, if they are not the plan's, and what a doubt about the
// centre of mass changes, each a sentence or two; empty for the plan without doubt.
std::string model_words(const AppState& state);
std::string doubt_words(const AppState& state);

// The label of weights, such as "kg".
std::string weight_unit(const AppState& state);

// What is on the screen but not in the link, in whole sentences; empty if the link holds
// everything.
std::string link_lacks_in_words(const AppState& state);

// Verdict, teams and their loads, each a sentence: the text of the page's live region. O(teams).
std::string summary(const AppState& state);

// What is selected, in hand and shown, each a sentence on a line of its own: besides the summary,
// for those who cannot see the canvas. O(1).
std::string news(const AppState& state);

}  // namespace evenlift::view
