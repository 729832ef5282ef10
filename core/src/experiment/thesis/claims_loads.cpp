#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "experiment/thesis/claims_sections.h"

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

}  // namespace evenlift::experiment::claims
