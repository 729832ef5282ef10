#include <chrono>
#include <cmath>

#include "commands/commands.h"
#include "evenlift/numbers.h"
#include "evenlift/optimum.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "input/options.h"
#include "print/progress.h"

namespace evenlift::native {
namespace {

constexpr double usual_time_limit_s = 10, longest_time_limit_s = 86400;

double time_limit_option(const std::optional<std::string>& text) {
  if (!text) return usual_time_limit_s;
  const std::optional<double> seconds = read_number(*text);
  if (!seconds || !(*seconds > 0 && *seconds <= longest_time_limit_s))
    throw bad_value("--time-limit",
                    "the time limit must be a number of seconds above 0 and up to 86400", *text);
  return *seconds;
}

// Candidates, counted from 1.
std::string candidates_in_words(const std::vector<std::uint32_t>& taken) {
  std::string text;
  for (const std::uint32_t i : taken) text += (text.empty() ? "" : ", ") + std::to_string(i + 1);
  return text.empty() ? "none" : text;
}

std::string verdict_on(const ChoiceToHold& to_hold) {
  if (to_hold.proved && to_hold.keys.level > 0)
    return std::string("It holds the object firmly, and it is the best of all choices by ") +
           (to_hold.compared ? "hold, coverage and load ratios." : "hold and coverage.");
  if (to_hold.most_level == 0) return "No choice of this number of teams holds the object firmly.";
  if (to_hold.keys.level == 0)
    return "It does not hold the object firmly; it is not proved that no choice does.";
  return std::string("It holds the object firmly") +
         (to_hold.keys.level == to_hold.most_level
              ? ", and no choice has a greater margin. It is not proved to have the greatest coverage of such choices: none covers more than "
              : ". It is not proved to be the best: no choice covers more than ") +
         percentage(to_hold.most_coverage, 2) + ".";
}

std::string for_people(const ComparedChoices& compared) {
  const Placement& greedy = compared.greedy;
  const Optimum& widest = compared.widest;
  std::string text = count_of(greedy.teams.size(), "team", "teams") + " among " +
                     count_of(greedy.candidates.size(), "candidate", "candidates") + ".\n\n";
  text += "  Greedy, by " + std::string(name(greedy.settings.method)) + "   covers " +
          percentage(greedy.coverage, 2) + "   candidates " +
          candidates_in_words(greedy.team_candidates) + "\n";
  text += std::string("  ") + (widest.proved ? "The optimum" : "The best found") + "   covers " +
          percentage(widest.coverage, 2) + "   candidates " + candidates_in_words(widest.taken) +
          "\n";
  text +=
      widest.proved
          ? "  It is proved: no choice of this number of teams among these candidates covers more.\n"
          : "  It is not proved: no choice covers more than " + percentage(widest.bound, 2) + ".\n";
  text += "  The greedy choice is " +
          points_ahead(std::max(widest.coverage, greedy.coverage), greedy.coverage) +
          " behind it.\n";
  if (const auto& to_hold = compared.to_hold)
    text += "\n  To hold           covers " + percentage(to_hold->keys.coverage, 2) +
            "   candidates " + candidates_in_words(to_hold->taken) + "\n  " + verdict_on(*to_hold) +
            "\n";
  return text;
}

std::string answer(const Input& input, const SettingOptions& options, double seconds, bool json) {
  const Waiting waiting("comparing choices of teams");
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  const Result<ComparedChoices> compared =
      compare_choices(input.document, [&] { return std::chrono::steady_clock::now() >= end; });
  if (!compared) throw options.failure(input, compared.error());
  return json ? choices_json(*compared) : for_people(*compared);
}

}  // namespace

void cmd_optimum(const Arguments& arguments) {
  CommandLine line(
      "evenlift optimum", "How far the greedy choice of teams is from the best one.",
      "Among up to 160 candidates, the widest lifting base is proved to be the best if time allows;\n"
      "with more, there is only a bound. With --goal hold, up to 4,194,304 choices are all compared;\n"
      "with more, there is only a bound.\n\n"
      "Example:\n  evenlift optimum table.txt --teams 2\n");
  InputOptions options;
  std::optional<std::string> time_limit;
  bool json = false;
  options.declare(line);
  line.value(time_limit, "--time-limit", "S",
             "seconds until the search stops with its present bound (default 10)");
  line.flag(json, "--json", "one JSON object instead of sentences");
  if (!line.parse(arguments)) return;
  const double seconds = time_limit_option(time_limit);
  write_output(answer(options.read(), options.settings, seconds, json));
}

}  // namespace evenlift::native
