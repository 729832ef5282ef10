#include "evenlift/accuracy.h"
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

constexpr std::array<const char*, promise_count> meanings{
    "All at once, each along its edge, except robots in inward corners: what is told remains true. "
    "Farther off, a robot may have no room",
    "All at once, each along its edge, except robots in inward corners: what is told remains true. "
    "Farther off, the object may tip",
    "All at once, each along its edge, except robots in inward corners: what is told remains true. "
    "Farther off, the robots may no longer hold it",
    "All at once, each along its edge, except robots in inward corners: what is told remains true. "
    "Farther off, a robot may be overloaded"};

// The limit that is worth telling.
const Accuracy::First* limit_of(const ShownPlacement& of, const Accuracy& accuracy) {
  const bool is_told =
      accuracy.first && accuracy.first->within > near_distance(of.placement.polygon().diameter());
  return is_told ? &*accuracy.first : nullptr;
}

// What ends within the accuracy that is asked for.
std::string broken_in_words(const ShownPlacement& of, const Accuracy& all) {
  if (all.keeps_asked(near_distance(of.placement.polygon().diameter()))) return {};
  return say("With robots off by {distance} or more, {problem}.",
             {promised_length(all.first->within, of.shown.units), first_to_fail(*all.first)});
}

// For the accuracy that is asked for.
std::string with_asked(const ShownPlacement& of, const Accuracy& all) {
  const Units& units = of.shown.units;
  if (of.placement.teams.empty()) return {};
  if (std::string broken = broken_in_words(of, all); !broken.empty()) return broken;
  const std::string asked = with_length_unit(plain(all.asked), units);
  if (!all.greatest)
    return say("With robots off by up to {distance} all of this still holds.", {asked});
  return say(
      "With robots off by up to {distance} all of this still holds; robot {robot} then carries up "
      "to about {load}.",
      {asked, all.greatest->robot + 1, load_in_words(all.greatest->load, units, Toward::up)});
}

}  // namespace

std::string inaccuracy_in_words(const ShownPlacement& of) {
  return broken_in_words(of, accuracy(of));
}

std::string accuracy_in_words(const ShownPlacement& of) {
  const Accuracy all = accuracy(of);
  if (all.asked > 0) return with_asked(of, all);
  // closure_in_words() says it.
  const bool is_said = all.first && all.first->what == Promise::hold && !hold_firmly(of.placement);
  if (is_said) return {};
  const Accuracy::First* first = limit_of(of, all);
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

std::optional<Fact> accuracy_fact(const ShownPlacement& of) {
  const Accuracy all = accuracy(of);
  const Accuracy::First* first = limit_of(of, all);
  if (!first) return std::nullopt;
  return Fact{"Robots may be off by", promised_length(first->within, of.shown.units),
              meanings[static_cast<std::size_t>(first->what)]};
}

std::string upright_in_words(const ShownPlacement& of) {
  if (of.placement.lifting_base.size() < 3) return {};
  const auto line = tipping_line(of.placement);
  if (!line || tips_when_disturbed(of) || is_upright(of)) return {};
  return say(
      "C is only {distance} inside the line from robot {a} to robot {b}.",
      {promised_length(line->distance, of.shown.units), line->robots[0] + 1, line->robots[1] + 1});
}

}  // namespace evenlift
