#include <algorithm>
#include <cmath>

#include "commands.h"
#include "evenlift/formats.h"
#include "evenlift/output/json.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "options.h"

namespace evenlift::native {
namespace {

using Row = std::vector<std::string>;

// Characters, of UTF-8.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

// Columns two spaces apart, as wide as they need, to the right; the first row are headings.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += "  " + std::string(widths[i] - width(row[i]), ' ') + row[i];
    text += "\n";
  }
  return text;
}

std::string point(const Vec2& p, int decimals) {
  return "(" + fixed(p.x(), decimals) + ", " + fixed(p.y(), decimals) + ")";
}

// Enough to find the place on the object: four digits of its size.
int coordinate_decimals(const Points& vertices) {
  Vec2 low = vertices[0], high = vertices[0];
  for (const Vec2& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return std::min(decimals_for((high - low).maxCoeff()) + 1, 9);
}

std::string team_table(const Placement& placement) {
  const int coordinates = coordinate_decimals(placement.vertices);
  const int loads = decimals_for(placement.loads->max);
  std::vector<Row> rows = {{"team", "ratio", "robot at", "bears", "robot at", "bears"}};
  for (const Team& team : placement.teams)
    rows.push_back({std::to_string(rows.size()), fixed(team.chord.ratio, 3),
                    point(team.chord.r1.position, coordinates), fixed(team.loads[0], loads),
                    point(team.chord.r2.position, coordinates), fixed(team.loads[1], loads)});
  return table(rows);
}

std::string candidate_table(const Placement& placement) {
  std::vector<std::string> team(placement.candidates.size(), "-");
  for (std::size_t i = 0; i < placement.team_candidates.size(); ++i)
    if (placement.team_candidates[i] >= 0)
      team[static_cast<std::size_t>(placement.team_candidates[i])] = std::to_string(i + 1);
  const int coordinates = coordinate_decimals(placement.vertices);
  std::vector<Row> rows = {{"candidate", "ratio", "kind", "from", "to", "team"}};
  for (std::size_t i = 0; i < placement.candidates.size(); ++i) {
    const Candidate& candidate = placement.candidates[i];
    rows.push_back({std::to_string(i + 1), fixed(candidate.chord.ratio, 3),
                    std::string(name(candidate.kind)),
                    point(candidate.chord.r1.position, coordinates),
                    point(candidate.chord.r2.position, coordinates), team[i]});
  }
  return table(rows);
}

std::string facts(const Placement& placement) {
  const Settings& settings = placement.settings;
  std::string text = "  centre of mass  " +
                     point(placement.centre_of_mass, coordinate_decimals(placement.vertices)) +
                     "\n";
  text += "  candidates      " + std::to_string(placement.candidates.size()) +
          " at a minimum load ratio of " + shortest(settings.min_ratio) + "\n";
  text += "  selection       " + std::string(name(settings.metric));
  if (settings.metric == Metric::random) text += ", seed " + std::to_string(settings.seed);
  text += "\n";
  if (!placement.loads) return text;
  const LoadSummary& loads = *placement.loads;
  const int decimals = decimals_for(loads.max);
  text += "  loads           mean " + fixed(loads.mean, decimals) + ", spread " +
          fixed(loads.spread, decimals) + ", at most " + percentage(loads.max_share) +
          " of a team's load on one robot\n";
  text += "  coverage        " + percentage(placement.coverage) + "\n";
  const Closure& closure = placement.closure;
  text += "  closure         ";
  text += closure.form_closure ? "form closure" : closure.second_order ? "second order" : "none";
  if (closure.margin) {
    const double size = std::fabs(*closure.margin);
    text += ", margin " + fixed(*closure.margin, size < 1e-9 ? 0 : std::max(3, decimals_for(size)));
  }
  return text + "\n";
}

std::string for_people(const Placement& placement, bool with_candidates) {
  std::string text = verdict(placement) + "\n\n";
  if (!placement.teams.empty()) text += team_table(placement) + "\n";
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
  std::optional<std::string> svg;
  bool as_json = false, candidates = false;
  line.positional(file, "FILE", "the polygon");
  options.declare(line);
  line.flag(as_json, "--json", "one JSON object instead of a table");
  line.flag(candidates, "--candidates", "list the candidates too, and show them in the picture");
  line.value(svg, "--svg", "OUT", "also write a picture as SVG");
  if (!line.parse(arguments)) return;

  Input input = read_input(file);
  options.apply(input.document);
  const Result<Placement> placement = place(input.document);
  if (!placement) throw options.failure(input.source, placement.error());
  if (svg) {
    Placement pictured = *placement;
    pictured.settings.overlays.candidates |= candidates;
    write_file(*svg, placement_svg(pictured));
  }
  write_output(as_json ? placement_json(*placement, candidates)
                       : for_people(*placement, candidates));
}

}  // namespace evenlift::native
