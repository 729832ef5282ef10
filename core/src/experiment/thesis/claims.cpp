#include "evenlift/experiment/claims.h"

#include "evenlift/experiment/figures.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "experiment/thesis/claims_sections.h"
#include "experiment/thesis/markdown.h"

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
