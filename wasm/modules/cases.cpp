// The loads in each case of loading, for a window that can be printed (web/windows/cases.js).
#include "modules/cases.h"

#include <utility>
#include <vector>

#include "evenlift/link.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/verdict.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "modules/kinds.h"

namespace evenlift::view {
namespace {

// More are not printed on a page.
constexpr std::size_t most_robots_in_cases = 64;

std::string cells(const CaseInWords& words) {
  std::vector<std::string> texts{words.name, words.greatest, words.robot, words.least};
  if (!words.use.empty()) texts.push_back(words.use);
  texts.push_back(words.stays);
  return json::texts(texts);
}

}  // namespace

bool cases_fit_on_paper(const Placement& placement) {
  return !placement.teams.empty() && count_robots(placement.teams) <= most_robots_in_cases;
}

std::string table_of_cases(const Reported& of) {
  const std::vector<LoadCase> all = load_cases(of);
  std::vector<std::string> rows;
  for (const CaseInWords& words : cases_in_words(of, all)) rows.push_back(cells(words));
  return json::object({{"headings", cells(headings_of_cases(of))},
                       {"rows", json::array(rows)},
                       {"worst", std::to_string(worst_case(all).value_or(0))}});
}

std::string cases(const RequestMembers& members) {
  const Result<Document> document = decode_link(members.text("link"));
  if (!document) return problem(document.error().message);
  const Result<Placement> placement = place(*document, Effort::whole, Misfitting::left_out);
  if (!placement) return problem(sentence(placement.error()));
  if (placement->teams.empty()) return problem("there are no robots");
  if (!cases_fit_on_paper(*placement))
    return problem("cases are shown for up to 64 robots; evenlift place --cases has them all");
  const Reported of(*placement, document->shown);
  std::vector<std::string> said{verdict(of)};
  for (const std::string& sentence :
       {given_in_part_in_words(of), tilt_in_words(of), use_in_words(of), weighing_in_words(of)})
    if (!sentence.empty()) said.push_back(sentence);
  Shown plain = document->shown;
  plain.overlays = {};
  return json::object({{"said", json::texts(said)},
                       {"table", table_of_cases(of)},
                       {"svg", json::text(placement_svg({*placement, plain}, {}))}});
}

}  // namespace evenlift::view
