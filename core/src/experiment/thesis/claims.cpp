#include "evenlift/experiment/claims.h"
#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/experiment/figures.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "experiment/thesis/by_polygon.h"

namespace evenlift::experiment::claims {
namespace {

struct Stated {
  Method method;
  const char* value;
};

constexpr Stated spread_of_4[] = {{Method::area, "—"},
                                  {Method::circle, "—"},
                                  {Method::distance, "1.5 kg (s.d. 1.9 kg)"},
                                  {Method::distributed, "12.5 kg (s.d. 14.5 kg)"},
                                  {Method::random, "—"}};
constexpr Stated spread_of_30[] = {{Method::area, "0.4 kg (s.d. 0.3 kg)"},
                                   {Method::circle, "—"},
                                   {Method::distance, "—"},
                                   {Method::distributed, "—"},
                                   {Method::random, "3.1 kg (s.d. 2.5 kg)"}};
constexpr Stated ranges_of_4[] = {{Method::distance, "24.25–25.75 kg"},
                                  {Method::distributed, "18.75–31.25 kg"}};
constexpr Stated ranges_of_30[] = {{Method::area, "3.1–3.5 kg"}, {Method::random, "1.75–4.85 kg"}};
constexpr Stated shares_of_10_teams[] = {{Method::area, "46.6–53.4 % (s.d. 2.2 %)"},
                                         {Method::circle, "46.6–53.4 % (s.d. 2.2 %)"},
                                         {Method::distance, "46.6–53.4 % (s.d. 2.2 %)"},
                                         {Method::distributed, "35.5–64.5 % (s.d. 14.0 %)"},
                                         {Method::random, "—"}};

template <std::size_t n>
void add_spreads(std::vector<Claim>& claims, const Rows& rows, std::uint32_t robots,
                 const Stated (&stated)[n]) {
  for (const auto& [method, value] : stated) {
    const Aggregate* a = find(rows, method, robots);
    claims.push_back(
        {"5.3", say("Spread of loads with {robots} robots, {method}", {robots, name(method)}),
         value,
         a ? with_deviation(fixed(a->spread.mean, 2) + " kg", a->spread.deviation, 1, 2, " kg")
           : none});
  }
}

// The thesis adds half the mean spread to the mean load, and subtracts it.
template <std::size_t n>
void add_ranges(std::vector<Claim>& claims, const Rows& rows, std::uint32_t robots,
                const Stated (&stated)[n]) {
  const double mean = experiment_weight / robots;
  for (const auto& [method, value] : stated) {
    const Aggregate* a = find(rows, method, robots);
    claims.push_back(
        {"5.3",
         say("Range of loads with {robots} robots, mean ± half the spread, {method}",
             {robots, name(method)}),
         value,
         a ? fixed(mean - a->spread.mean / 2, 2) + "–" + fixed(mean + a->spread.mean / 2, 2) + " kg"
           : none});
  }
}

void add_shares(std::vector<Claim>& claims, const Rows& rows) {
  for (const auto& [method, value] : shares_of_10_teams) {
    const Aggregate* a = find(rows, method, 20);
    claims.push_back(
        {"5.3", say("Shares of the team’s load with 10 teams, {method}", {name(method)}), value,
         a ? with_deviation(
                 fixed(100 - 100 * a->max_share.mean, 1) + "–" + percent(a->max_share.mean, 1),
                 a->max_share.deviation, 100, 1, " %")
           : none});
  }
}

// The fewest robots whose greatest load is within the capacity, on average.
std::string robots_needed(const Rows& rows, Method method, double capacity) {
  const Aggregate* least = nullptr;
  for (const Aggregate& a : rows)
    if (a.method == method && a.load_max.mean <= capacity && (!least || a.robots < least->robots))
      least = &a;
  return least ? say("{robots} ({load} kg, {polygons} polygons)",
                     {least->robots, fixed(least->load_max.mean, 2), least->polygons})
               : none;
}

void add_robots_needed(std::vector<Claim>& claims, const Rows& rows) {
  for (const Method method : pair_methods) {
    const char* stated = method == Method::distributed ? "28"
                         : method == Method::random    ? "30"
                                                       : "22";
    claims.push_back(
        {"5.3",
         say("Fewest robots with a greatest load of at most 5 kg of 100 kg, averaged over the "
             "polygons, {method}",
             {name(method)}),
         stated, robots_needed(rows, method, 5)});
  }
}

void add_times(std::vector<Claim>& claims, const Rows& rows, std::uint32_t most_robots) {
  const auto add = [&](const std::string& where, const char* stated, auto made) {
    for (const Method method : {Method::distributed, Method::random})
      claims.push_back({"6.1",
                        say("Spread of loads of {method} in multiples of the algorithm’s, {where}",
                            {name(method), where}),
                        stated, made(method)});
  };
  add("over the numbers of robots shown", "5–8", [&](Method method) -> std::string {
    const auto range = spread_ratio(rows, method, most_robots);
    return range ? fixed(range->least, 1) + "–" + fixed(range->most, 1) : none;
  });
  add("with 4 robots", none, [&](Method method) -> std::string {
    const auto times = spread_times(rows, method, 4);
    return times ? fixed(*times, 1) : none;
  });
}

}  // namespace

void add_loads(std::vector<Claim>& claims, const Rows& rows, std::uint32_t most_robots) {
  add_spreads(claims, rows, 4, spread_of_4);
  add_ranges(claims, rows, 4, ranges_of_4);
  add_spreads(claims, rows, 30, spread_of_30);
  add_ranges(claims, rows, 30, ranges_of_30);
  add_shares(claims, rows);
  add_robots_needed(claims, rows);
  add_times(claims, rows, most_robots);
}

namespace {

// The mean of the points of figure 5.7 from four robots on.
std::optional<double> mean_of_figure(const Rows& rows, std::uint32_t most_robots) {
  double sum = 0;
  int count = 0;
  for (std::uint32_t robots = 4; robots <= most_robots; robots += 2) {
    if (const auto value = algorithm_average(rows, robots, pick_coverage)) {
      sum += *value;
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::string mean_and_deviation(const std::vector<double>& values, double sign) {
  if (values.empty()) return none;
  const Statistics s = statistics(values);
  return with_deviation(percent(sign * s.mean, 1), s.deviation, 100, 1, " %");
}

void add_choices(std::vector<Claim>& claims, const Results& results) {
  claims.push_back({"5.4", "All three metrics choose the same second team", "79 %",
                    rate(same_choice(results, 2))});
  claims.push_back({"5.4", "The same third team, where the second is the same", "95 %",
                    rate(same_choice(results, 3))});
  // Fewer vertices leave fewer choices.
  claims.push_back({"5.4", "The same second team, polygons with at most 12 vertices", none,
                    rate(same_choice(results, 2, 12))});
  claims.push_back(
      {"5.4",
       "The same third team, where the second is the same, polygons with at most 12 vertices", none,
       rate(same_choice(results, 3, 12))});
  claims.push_back(
      {"5.4", "Where the second team differs, the coverages differ by less than 10 % of the object",
       "most", rate(alike_coverage(results, 0.1))});
}

void add_algorithm(std::vector<Claim>& claims, const Results& results, const Rows& rows,
                   std::uint32_t most_robots) {
  const auto mean = mean_of_figure(rows, most_robots);
  claims.push_back({"6.1", "Coverage by the algorithm: mean of figure 5.7 from 4 robots on", "87 %",
                    mean ? percent(*mean, 1) : none});
  const auto covered = algorithm_average(rows, 36, pick_coverage);
  claims.push_back({"6.1", "Coverage by the algorithm: with 36 robots", "87 %",
                    covered ? percent(*covered, 1) : none});
  claims.push_back({"6.1",
                    "Coverage by the algorithm: mean over all its measurements from 4 robots on",
                    "87 %", mean_and_deviation(all_coverages(results), 1)});
  claims.push_back({"6.1", "Coverage by the algorithm: with the greatest number of teams", "87 %",
                    mean_and_deviation(final_coverages(results), 1)});
}

void add_comparisons(std::vector<Claim>& claims, const Results& results) {
  claims.push_back(
      {"5.4",
       "Coverage of distributed less coverage of the algorithm, mean over a polygon’s numbers of teams",
       "10 % (s.d. 10 %)",
       mean_and_deviation(coverage_differences(results, Method::distributed), 1)});
  claims.push_back(
      {"5.4",
       "Coverage of the algorithm less coverage of random, mean over a polygon’s numbers of teams",
       "slightly more", mean_and_deviation(coverage_differences(results, Method::random), -1)});
  const auto loss = greatest_loss(results, 12);
  claims.push_back(
      {"5.4",
       "Coverage with 12 robots before and after the centre of mass is moved, worst case (figure 5.9)",
       "84.71 % to 12.98 %",
       loss ? say("{least} to {most}", {percent(loss->before, 2), percent(loss->after, 2)}) + " (" +
                  loss->polygon + ")"
            : none});
}

}  // namespace

void add_coverage(std::vector<Claim>& claims, const Results& results, const Rows& rows,
                  std::uint32_t most_robots) {
  add_choices(claims, results);
  add_algorithm(claims, results, rows, most_robots);
  add_comparisons(claims, results);
}

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

namespace evenlift::experiment {

namespace claims {

std::string percent(double share, int decimals) { return fixed(100 * share, decimals) + " %"; }

std::string rate(const Count& count) {
  if (count.of == 0) return none;
  return say("{share} ({count} of {all})",
             {percent(static_cast<double>(count.yes) / count.of), count.yes, count.of});
}

std::string with_deviation(const std::string& value, const std::optional<double>& deviation,
                           double scale, int decimals, const char* unit) {
  return deviation ? say("{value} (s.d. {deviation})",
                         {value, fixed(scale * *deviation, decimals) + unit})
                   : value;
}

}  // namespace claims

std::vector<Claim> make_claims(const std::vector<PolygonResult>& results,
                               const std::vector<Aggregate>& aggregates) {
  const std::uint32_t most_robots = most_robots_shown(aggregates, Method::area);
  std::vector<Claim> all;
  claims::add_loads(all, aggregates, most_robots);
  claims::add_coverage(all, results, aggregates, most_robots);
  claims::add_closure(all, results, aggregates);
  return all;
}

std::string claims_markdown(const std::vector<SetClaims>& sets) {
  std::vector<std::string> heads = {"section", "what", "the thesis"};
  for (const SetClaims& set : sets) heads.push_back(markdown::cell(set.set));
  std::string text =
      markdown::row(heads) + markdown::row(std::vector<std::string>(heads.size(), "---"));
  for (std::size_t i = 0; !sets.empty() && i < sets.front().claims.size(); ++i) {
    const Claim& c = sets.front().claims[i];
    std::vector<std::string> cells = {c.section, markdown::cell(c.what), c.thesis};
    for (const SetClaims& set : sets) cells.push_back(markdown::cell(set.claims[i].ours));
    text += markdown::row(cells);
  }
  return text;
}

std::string claims_json(const std::vector<SetClaims>& sets) {
  std::vector<std::string> names, rows;
  for (const SetClaims& set : sets) names.push_back(json::text(set.set));
  for (std::size_t i = 0; !sets.empty() && i < sets.front().claims.size(); ++i) {
    const Claim& c = sets.front().claims[i];
    std::vector<std::string> ours;
    for (const SetClaims& set : sets) ours.push_back(json::text(set.claims[i].ours));
    rows.push_back(json::object({{"section", json::text(c.section)},
                                 {"what", json::text(c.what)},
                                 {"thesis", json::text(c.thesis)},
                                 {"ours", json::array(ours)}}));
  }
  return json::object({{"sets", json::array(names)}, {"rows", json::long_array(rows, 0)}}) + "\n";
}

}  // namespace evenlift::experiment
