#include <algorithm>

#include "commands.h"
#include "evenlift/output/json.h"
#include "evenlift/output/markup.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "options.h"

namespace evenlift::native {
namespace {

using Row = std::vector<std::string>;

// Columns two spaces apart, as wide as they need, to the right; the first row are headings.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], character_count(row[i]));
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += "  " + std::string(widths[i] - character_count(row[i]), ' ') + row[i];
    text += "\n";
  }
  return text;
}

// Which of a team's robots carry more than the capacity.
std::string overloaded(const Team& team, double capacity) {
  const bool first = team.loads[0] > capacity, second = team.loads[1] > capacity;
  return first && second ? "both" : first ? "first" : second ? "second" : "-";
}

std::string team_table(const Placement& placement, const std::optional<double>& capacity) {
  const int decimals = coordinate_decimals(placement.vertices);
  std::vector<Row> rows = {{"team", "ratio", "robot at", "bears", "robot at", "bears"}};
  if (capacity) rows[0].push_back("overloaded");
  for (std::size_t i = 0; i < placement.teams.size(); ++i) {
    const TeamInWords team = team_in_words(placement, i, decimals);
    rows.push_back(
        {std::to_string(i + 1), team.ratio, team.at[0], team.loads[0], team.at[1], team.loads[1]});
    if (capacity) rows.back().push_back(overloaded(placement.teams[i], *capacity));
  }
  return table(rows);
}

std::string candidate_table(const Placement& placement) {
  std::vector<std::string> team(placement.candidates.size(), "-");
  for (std::size_t i = 0; i < placement.team_candidates.size(); ++i)
    team[placement.team_candidates[i]] = std::to_string(i + 1);
  const int decimals = coordinate_decimals(placement.vertices);
  std::vector<Row> rows = {{"candidate", "ratio", "kind", "from", "to", "team"}};
  for (std::size_t i = 0; i < placement.candidates.size(); ++i) {
    const Candidate& candidate = placement.candidates[i];
    rows.push_back({std::to_string(i + 1), ratio_in_words(candidate.chord.ratio),
                    std::string(name(candidate.kind)),
                    point_in_words(candidate.chord.r1.position, decimals),
                    point_in_words(candidate.chord.r2.position, decimals), team[i]});
  }
  return table(rows);
}

// The settings and the results, one on each line.
std::string facts(const Placement& placement) {
  const Settings& settings = placement.settings;
  std::vector<std::pair<std::string, std::string>> lines = {
      {"Method", std::string(name(settings.method))}};
  if (settings.method == Method::random) lines.emplace_back("Seed", std::to_string(settings.seed));
  lines.emplace_back("Minimum load ratio", plain(settings.min_ratio));
  lines.emplace_back("Centre of mass", point_in_words(placement.centre_of_mass,
                                                      coordinate_decimals(placement.vertices)));
  for (const Fact& fact : facts_in_words(placement)) lines.emplace_back(fact.label, fact.value);
  std::size_t widest = 0;
  for (const auto& [label, value] : lines) widest = std::max(widest, character_count(label));
  std::string text;
  for (const auto& [label, value] : lines)
    text += "  " + label + std::string(widest + 2 - character_count(label), ' ') + value + "\n";
  return text;
}

std::string for_people(const Placement& placement, bool with_candidates,
                       const std::optional<CapacityInJson>& capacity) {
  std::string text = verdict(placement) + "\n";
  if (capacity) text += capacity_in_words(placement, capacity->limit, &capacity->plan) + "\n";
  text += "\n";
  const auto limit = capacity ? std::optional<double>(capacity->limit) : std::nullopt;
  if (!placement.teams.empty()) text += team_table(placement, limit) + "\n";
  if (with_candidates && !placement.candidates.empty()) text += candidate_table(placement) + "\n";
  return text + facts(placement);
}

}  // namespace

void cmd_place(const Arguments& arguments) {
  CommandLine line(
      "evenlift place", "Places teams of two robots on a polygon and says what holds of them.",
      "FILE is a path, - for standard input, or a share link. Its format is told by its content:\n"
      "the thesis's text, WKT POLYGON, or GeoJSON.\n\n"
      "Examples:\n"
      "  evenlift place table.txt --teams 4 --svg table.svg\n"
      "  evenlift place table.txt --metric circle --com 120,80 --json\n");
  std::string file;
  SettingOptions options;
  std::optional<std::string> svg, capacity_text;
  bool as_json = false, candidates = false;
  line.positional(file, "FILE", "the polygon");
  options.declare(line);
  line.value(capacity_text, "--capacity", "K",
             "what one robot can carry: who is overloaded, and how many are needed");
  line.flag(as_json, "--json", "one JSON object instead of a table");
  line.flag(candidates, "--candidates", "list the candidates too, and show them in the picture");
  line.value(svg, "--svg", "OUT", "also write a picture as SVG");
  if (!line.parse(arguments)) return;

  Input input = read_input(file);
  options.apply(input.document);
  std::optional<CapacityInJson> capacity;
  if (capacity_text) capacity = CapacityInJson{capacity_option(*capacity_text), {}};
  const Result<Placement> placement = place(input.document);
  if (!placement) throw options.failure(input.source, placement.error());
  if (capacity) capacity->plan = plan_capacity(*placement, capacity->limit);
  if (svg) {
    Placement pictured = *placement;
    pictured.settings.overlays.candidates |= candidates;
    write_file(*svg, placement_svg(pictured));
  }
  write_output(as_json ? placement_json(*placement, candidates, capacity)
                       : for_people(*placement, candidates, capacity));
}

}  // namespace evenlift::native
