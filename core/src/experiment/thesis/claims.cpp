#include "evenlift/experiment/claims.h"

#include "evenlift/experiment/figures.h"
#include "evenlift/output/words.h"
#include "experiment/thesis/claims_sections.h"
#include "output/json/json_text.h"

namespace evenlift::experiment {
namespace claims {

std::string percent(double share, int decimals) { return fixed(100 * share, decimals) + " %"; }

std::string rate(const Count& count) {
  if (count.of == 0) return none;
  return percent(static_cast<double>(count.yes) / count.of) + " (" + std::to_string(count.yes) +
         " of " + std::to_string(count.of) + ")";
}

std::string with_deviation(const std::string& value, const std::optional<double>& deviation,
                           double scale, int decimals, const char* unit) {
  return value + (deviation ? " (s.d. " + fixed(scale * *deviation, decimals) + unit + ")" : "");
}

}  // namespace claims

namespace {

// A cell of a table in Markdown; names of polygons may hold anything.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '\\') out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

}  // namespace

std::vector<Claim> make_claims(const std::vector<PolygonResult>& results,
                               const std::vector<Aggregate>& aggregates) {
  const std::uint32_t most_teams = most_teams_shown(aggregates);
  std::vector<Claim> all;
  claims::add_loads(all, aggregates, most_teams);
  claims::add_coverage(all, results, aggregates, most_teams);
  claims::add_closure(all, results, aggregates);
  return all;
}

std::string claims_markdown(const std::vector<SetClaims>& sets) {
  std::string head = "| section | what | the thesis |", rule = "| --- | --- | --- |";
  for (const SetClaims& set : sets) {
    head += " " + cell(set.set) + " |";
    rule += " --- |";
  }
  std::string text = head + "\n" + rule + "\n";
  for (std::size_t i = 0; !sets.empty() && i < sets.front().claims.size(); ++i) {
    const Claim& c = sets.front().claims[i];
    text += "| " + c.section + " | " + cell(c.what) + " | " + c.thesis + " |";
    for (const SetClaims& set : sets) text += " " + cell(set.claims[i].ours) + " |";
    text += "\n";
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
