#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "experiment/thesis/claims_sections.h"

namespace evenlift::experiment::claims {
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

}  // namespace evenlift::experiment::claims
