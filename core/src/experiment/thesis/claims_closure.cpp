#include "evenlift/wording.h"
#include "experiment/thesis/claims_sections.h"
#include "experiment/thesis/sentences.h"

namespace evenlift::experiment::claims {
namespace {

// A test of form closure: ours, or the thesis's own.
struct Reading {
  Closed closed;
  std::optional<double> Aggregate::*rate;
  std::uint32_t Aggregate::*possible;
  const char* in_words;  // appended to the name of the quantity

  std::string of(std::string_view what) const {
    return std::string(translated(what)) + std::string(translated(in_words));
  }
};
constexpr Reading readings[] = {
    {&Measurement::form_closure, &Aggregate::form_closure, &Aggregate::closable, ""},
    {&Measurement::no_area, &Aggregate::no_area, &Aggregate::no_area_possible,
     ", by the thesis’s test that no region has an area"}};

std::string lost_in_words(const Lost& lost) {
  if (lost.steps.of == 0) return none;
  if (lost.steps.yes == 0) return say("never (in {steps} steps)", {lost.steps.of});
  std::vector<std::string> numbers;
  for (const std::uint32_t robots : lost.robots) numbers.push_back(std::to_string(robots));
  return say("{lost} of {steps} steps, on the way to {numbers} robots",
             {lost.steps.yes, lost.steps.of, listed(numbers)});
}

// The numbers of robots from 4 to 12 with which no method of teams has a higher rate than equal
// angles.
std::string distributed_leads(const Rows& rows, const Reading& reading) {
  std::string text;
  for (std::uint32_t robots = 4; robots <= 12; robots += 2) {
    const Aggregate* ours = find(rows, Method::distributed, robots);
    if (!ours || !(ours->*reading.rate)) continue;
    bool leads = true;
    for (const Method method : pair_methods)
      if (const Aggregate* a = find(rows, method, robots); a && a->*reading.rate)
        leads = leads && *(a->*reading.rate) <= *(ours->*reading.rate);
    if (leads) text += (text.empty() ? "" : ", ") + std::to_string(robots);
  }
  return text.empty() ? "none of 4 to 12" : text;
}

void add_rates(std::vector<Claim>& claims, const Rows& rows, const Reading& reading,
               std::uint32_t robots, Method stated_method, const char* stated) {
  for (const Method method : pair_methods) {
    const Aggregate* a = find(rows, method, robots);
    claims.push_back(
        {"5.5",
         reading.of(say("In form closure with {robots} robots, {method}", {robots, name(method)})),
         method == stated_method ? stated : none,
         a && a->*reading.rate
             ? say("{share} (of {number})", {percent(*(a->*reading.rate)), a->*reading.possible})
             : none});
  }
}

std::string never_closed(const Results& results, const Reading& reading) {
  std::uint32_t measured = 0;
  for (const PolygonResult& result : results) measured += !result.measurements.empty();
  const Count possible = closed(results, reading.closed);
  return say("{count} of {all}", {measured - possible.of, measured});
}

void add_reading(std::vector<Claim>& claims, const Results& results, const Rows& rows,
                 const Reading& reading) {
  claims.push_back({"5.5", reading.of("Polygons that no method brings into form closure"), "12",
                    never_closed(results, reading)});
  add_rates(claims, rows, reading, 4, Method::distributed, "41 %");
  add_rates(claims, rows, reading, 8, Method::distance, "80 %");
  claims.push_back(
      {"5.5",
       reading.of("In form closure with 8 robots, distance, polygons with at most 12 vertices"),
       none, rate(closed_with(results, reading.closed, Method::distance, 8, 12))});
  claims.push_back(
      {"5.5",
       reading.of("Numbers of robots up to 12 with which distributed has the most polygons in form "
                  "closure"),
       "all", distributed_leads(rows, reading)});
  for (const Method method : candidate_methods)
    claims.push_back(
        {"5.5", reading.of(say("Form closure lost by adding a team, {method}", {name(method)})),
         "never", lost_in_words(closure_lost(results, reading.closed, method))});
  claims.push_back(
      {"5.5", reading.of(say("Form closure lost by adding a team, {method}", {"distributed"})),
       "on the way to 14 and 18 robots",
       lost_in_words(closure_lost(results, reading.closed, Method::distributed))});
  claims.push_back(
      {"5.5",
       reading.of(
           "Polygons in form closure by the algorithm, of those in form closure by any method"),
       "over 88 %", rate(closed(results, reading.closed))});
}

}  // namespace

void add_closure(std::vector<Claim>& claims, const Results& results, const Rows& rows) {
  for (const Reading& reading : readings) add_reading(claims, results, rows, reading);
}

}  // namespace evenlift::experiment::claims
