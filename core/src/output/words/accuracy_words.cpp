#include "evenlift/output/robustness_words.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

// As the subject and verb of a sentence.
std::string first_to_fail(const Accuracy::First& first) {
  const auto number = [&](std::size_t i) { return first.robots[i] + 1; };
  switch (first.what) {
    case Promise::fits:
      return first.robots.size() == 1 ? say("robot {robot} may have no room", {number(0)})
                                      : say("robots {a} and {b} may come too near to each other",
                                            {number(0), number(1)});
    case Promise::stands:
      return say("the object may tip over the line from robot {a} to robot {b}",
                 {number(0), number(1)});
    case Promise::hold:
      return say("the robots may no longer hold it");
    case Promise::capacity:
      return say("robot {robot} may be overloaded", {number(0)});
  }
  return {};
}

// The limit that is worth telling.
const Accuracy::First* limit_of(const Reported& of) {
  const auto& first = of.report.accuracy.first;
  const bool is_told = first && first->within > near_distance(of.placement.polygon().diameter());
  return is_told ? &*first : nullptr;
}

// What ends within the accuracy that is asked for.
std::string broken_in_words(const Reported& of) {
  const Accuracy& all = of.report.accuracy;
  if (all.keeps_asked(near_distance(of.placement.polygon().diameter()))) return {};
  return say("With robots off by {distance} or more, {problem}.",
             {promised_length(all.first->within, of.shown.units), first_to_fail(*all.first)});
}

// For the accuracy that is asked for.
std::string with_asked(const Reported& of) {
  const Accuracy& all = of.report.accuracy;
  const Units& units = of.shown.units;
  if (of.placement.teams.empty()) return {};
  if (std::string broken = broken_in_words(of); !broken.empty()) return broken;
  const std::string asked = with_length_unit(plain(all.asked), units);
  if (!all.greatest)
    return say("With robots off by up to {distance} all of this still holds.", {asked});
  return say(
      "With robots off by up to {distance} all of this still holds; robot {robot} then carries up "
      "to about {load}.",
      {asked, all.greatest->robot + 1, load_in_words(all.greatest->load, units, Toward::up)});
}

}  // namespace

std::string inaccuracy_in_words(const Reported& of) { return broken_in_words(of); }

std::string accuracy_in_words(const Reported& of) {
  const Accuracy& all = of.report.accuracy;
  if (all.asked > 0) return with_asked(of);
  // closure_in_words() says it.
  const bool is_said = all.first && all.first->what == Promise::hold && !of.report.firm;
  if (is_said) return {};
  const Accuracy::First* first = limit_of(of);
  if (!first) return {};
  const std::string within = promised_length(first->within, of.shown.units);
  const std::vector<std::size_t>& exact = all.in_notches;
  constexpr std::size_t most_named = 6;
  if (exact.empty())
    return say("All of this holds if robots stand within {distance} of their places.", {within});
  if (exact.size() > most_named)
    return say(
        "All of this holds if robots stand within {distance} of their places, and those in inward "
        "corners stay there.",
        {within});
  return say(
      exact.size() == 1
          ? "All of this holds if robots stand within {distance} of their places, and robot "
            "{robots} stays in its inward corner."
          : "All of this holds if robots stand within {distance} of their places, and robots "
            "{robots} stay in their inward corners.",
      {within, numbers_from_1(exact)});
}

std::string upright_in_words(const Reported& of) {
  if (of.placement.lifting_base.size() < 3) return {};
  const auto& line = of.report.tipping_line;
  if (!line || of.report.tips || of.report.upright) return {};
  return say(
      "C is only {distance} inside the line from robot {a} to robot {b}.",
      {promised_length(line->distance, of.shown.units), line->robots[0] + 1, line->robots[1] + 1});
}

}  // namespace evenlift
