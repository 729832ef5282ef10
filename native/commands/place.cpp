#include <algorithm>

#include "commands/commands.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/markup.h"
#include "evenlift/output/quantities.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/verdict.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/placement.h"
#include "evenlift/supports.h"
#include "evenlift/tolerance.h"
#include "print/progress.h"
#include "print/table.h"

namespace evenlift::native {
namespace {

std::string robot_table(const Reported& of, const LoadColumn& loads) {
  const Placement& placement = of.placement;
  const Report& report = of.report;
  const bool given = placement.settings.method == Method::given;
  const Team& team = placement.teams.front();
  const TeamInWords words = team_in_words(placement, 0, place_decimals(placement));
  std::vector<Row> rows = {{"robot", "at", loads.heading}};
  const bool named = given && !placement.settings.support_names.empty();
  if (given) rows[0].insert(rows[0].begin() + 2, "stands");
  if (named) rows[0].insert(rows[0].begin() + 1, "name");
  if (report.has_own_capacities) rows[0].push_back("capacity");
  if (report.has_capacities) rows[0].insert(rows[0].end(), {"use", loads.overloaded});
  for (std::size_t i = 0; i < team.robots.size(); ++i) {
    const bool carries = placement.loads.has_value();
    rows.push_back(
        {std::to_string(placement.number_of(i)), words.at[i], carries ? loads.text[i] : "-"});
    if (given)
      rows.back().insert(rows.back().begin() + 2,
                         team.robots[i].point.edge == beneath ? "beneath" : "at the edge");
    if (named) {
      const std::string_view name = placement.name_of(i);
      rows.back().insert(rows.back().begin() + 1, name.empty() ? "-" : std::string(name));
    }
    if (report.has_own_capacities)
      rows.back().push_back(report.capacities[i] ? plain(*report.capacities[i]) : "-");
    if (report.has_capacities) {
      const bool known = i < report.use.size() && report.use[i];
      rows.back().push_back(known ? use_in_words(report.use[i]) : "-");
      rows.back().push_back(report.is_overloaded(i) ? "yes" : "-");
    }
  }
  return table(rows);
}

std::string team_table(const Reported& of, const LoadColumn& loads) {
  const Placement& placement = of.placement;
  if (is_one_team(placement.settings.method)) return robot_table(of, loads);
  const int decimals = place_decimals(placement);
  std::vector<Row> rows = {{"team", "ratio", "robot at", loads.heading, "robot at", loads.heading}};
  if (of.report.has_capacities) rows[0].push_back(loads.overloaded);
  for (std::size_t i = 0; i < placement.teams.size(); ++i) {
    const TeamInWords team = team_in_words(placement, i, decimals);
    rows.push_back({std::to_string(i + 1), team.ratio, team.at[0], loads.text[2 * i], team.at[1],
                    loads.text[2 * i + 1]});
    const bool first = of.report.is_overloaded(2 * i), second = of.report.is_overloaded(2 * i + 1);
    if (of.report.has_capacities)
      rows.back().push_back(first && second ? "both" : first ? "first" : second ? "second" : "-");
  }
  return table(rows);
}

std::string candidate_table(const Placement& placement) {
  std::vector<std::string> team(placement.candidates.size(), "-");
  for (std::size_t i = 0; i < placement.team_candidates.size(); ++i)
    team[placement.team_candidates[i]] = std::to_string(i + 1);
  const int decimals = coordinate_decimals(placement.vertices());
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

// Settings and results, one on each line.
std::string facts(const Reported& of) {
  const Placement& placement = of.placement;
  const Settings& settings = placement.settings;
  std::vector<std::pair<std::string, std::string>> lines = {
      {"Method", std::string(name(settings.method))}};
  if (settings.method == Method::random) lines.emplace_back("Seed", std::to_string(settings.seed));
  if (settings.method == Method::balanced) {
    const std::string reached = placement.goal_reached ? "" : ", not reached";
    lines.emplace_back("Goal", std::string(name(goal_of(settings))) + reached);
    if (settings.survive > 0)
      lines.emplace_back("Failures to survive", std::to_string(settings.survive));
  } else if (settings.method != Method::given) {
    lines.emplace_back("Minimum load ratio", plain(settings.min_ratio));
    if (settings.positions == Positions::range)
      lines.emplace_back("Positions", "anywhere in the range");
    if (swaps_teams(settings))
      lines.emplace_back("Goal", placement.goal_reached ? "hold" : "hold, not reached");
  }
  if (placement.moved.any()) lines.emplace_back("Moved by hand", moved_text(placement.moved));
  if (!placement.object.holes().empty())
    lines.emplace_back("Outline", outline_in_words(placement.object));
  if (!settings.cargo.empty()) {
    lines.emplace_back("Weight", weight_in_words(of));
    lines.emplace_back(
        "Centre of mass without cargo",
        point_in_words(placement.own_centre, coordinate_decimals(placement.vertices())));
  }
  lines.emplace_back("Centre of mass", point_in_words(placement.centre_of_mass,
                                                      coordinate_decimals(placement.vertices())));
  for (const Fact& fact : facts_in_words(of)) lines.emplace_back(fact.label, fact.value);
  std::size_t widest = 0;
  for (const auto& [label, value] : lines) widest = std::max(widest, character_count(label));
  std::string text;
  for (const auto& [label, value] : lines)
    text += "  " + label + std::string(widest + 2 - character_count(label), ' ') + value + "\n";
  return text;
}

// Where evened-out robots stood before.
std::string moves_in_words(const std::vector<SupportMove>& moves, const Reported& of) {
  if (moves.empty()) return "The robots were even already: none was moved.";
  const int decimals = place_decimals(of.placement);
  std::string text;
  for (const auto& [robot, from, to] : moves)
    text += std::string(text.empty() ? "Moved" : ";") + " robot " +
            support_called(of.placement.settings, robot) + " from " +
            point_in_words(from, decimals) + " to " + point_in_words(to, decimals) + ", by " +
            length_in_words(length(to - from), of.shown.units, Toward::nearest);
  return text + ".";
}

std::string for_people(const Reported& of, bool with_candidates,
                       const std::vector<Requirement>& requirements, const Beside& beside) {
  const Placement& placement = of.placement;
  std::string sentences = verdict(of) + "\n", tables;
  if (!placement.teams.empty()) tables += team_table(of, load_column(of)) + "\n";
  const std::string cut_short = cut_short_in_words(placement);
  if (!cut_short.empty()) sentences += cut_short + "\n";
  if (of.report.has_capacities) {
    // The first line names the overloaded robots.
    const std::string line =
        of.report.overloaded.empty() ? capacity_in_words(of) : needs_in_words(of);
    if (!line.empty()) sentences += line + "\n";
    if (const std::string use = use_in_words(of); !use.empty()) sentences += use + "\n";
  }
  sentences += robustness_lines(of);
  if (const std::string weighing = weighing_in_words(of); !weighing.empty())
    sentences += weighing + "\n";
  for (const std::string& left_out : left_out_in_words(placement)) sentences += left_out + "\n";
  for (const std::string& misfit : misfits_in_words(of)) sentences += misfit + "\n";
  if (beside.evened_out) sentences += moves_in_words(*beside.evened_out, of) + "\n";
  for (const Requirement& requirement : requirements)
    sentences += requirement_in_words(requirement) + "\n";
  if (placement.loads && !of.report.failures.empty()) tables += failure_table(of) + "\n";
  if (beside.cases) tables += case_table(of, *beside.cases) + "\n";
  if (with_candidates && !placement.candidates.empty()) tables += candidate_table(placement) + "\n";
  return sentences + "\n" + tables + facts(of);
}

// SVG that contains the share link, unless the polygon is too large for one.
std::string picture(const Reported& of, const Document& document, bool with_candidates,
                    const Beside& beside) {
  Shown shown = of.shown;
  shown.overlays.candidates |= with_candidates;
  Report report = of.report;
  complete(report, of, {});  // loads as planned
  const Result<std::string> link = encode_link(document);
  return placement_svg({{of.placement, shown}, report}, link ? *link : std::string(),
                       beside.cases ? cases_json(*beside.cases) : std::string());
}

// All outputs must go to different files.
void check_outputs(const PlaceOptions& options, const std::optional<PosesAsked>& poses) {
  const std::string& read = options.input.file;
  if (options.svg) check_output_file("--svg", *options.svg, read);
  if (poses) check_output_file("--poses", poses->file, read);
  if (const auto supports = options.input.settings.supports_file()) {
    if (options.svg) check_output_file("--svg", *options.svg, *supports);
    if (poses) check_output_file("--poses", poses->file, *supports);
  }
  if (options.svg && poses &&
      (*options.svg == poses->file || is_same_file(*options.svg, poses->file)))
    throw Failure{bad_input_status, "--poses",
                  "would overwrite " + poses->file + ", which --svg writes"};
}

// Replaces the document, and returns what was moved.
std::vector<SupportMove> even_out(Input& input, const PlaceOptions& options) {
  Result<Document> even = with_even_supports(input.document, options.misfitting());
  if (!even) throw options.input.settings.failure(input, even.error());
  std::vector<SupportMove> moves = support_moves(input.document, *even);
  input.document = *std::move(even);
  return moves;
}

struct Outputs {
  std::string printed;
  std::optional<std::string> svg, poses;
  bool kept = true;  // all requirements
};

Outputs make_outputs(const Input& input, const PlaceOptions& options,
                     const std::optional<PosesAsked>& poses, Asked asked,
                     const std::vector<Condition>& conditions, Beside beside) {
  Waiting waiting("placing the robots");
  const Result<Placement> placement = place(input.document, Effort::whole, options.misfitting());
  if (!placement) throw options.input.settings.failure(input, placement.error());
  const ShownPlacement shown(*placement, input.document.shown);
  tell_loads_outside(input, options.input.settings);
  if (input.document.settings.method == Method::given)
    for (const std::string& note : snap_notes(placement->object, input.document.settings))
      print_failure({0, "--supports", note, {}});
  waiting.now("counting the robots needed");
  Report report = report_of(shown, {.model = asked.model, .plans = true});
  waiting.now("examining what may happen");
  const bool told = asked.failures;  // otherwise only conditions need them
  asked.models = options.as_json;
  if (options.as_json) asked.model = LoadModel::plan;
  asked.failures |= need_failures(conditions);
  complete(report, shown, asked);
  const std::vector<Requirement> requirements = check_conditions({shown, report}, conditions);
  if (options.cases) beside.cases = load_cases(shown);
  Outputs outputs;
  if (options.svg)
    outputs.svg = picture({shown, report}, input.document, options.candidates, beside);
  if (poses) outputs.poses = poses_text(shown, poses->format, poses->options);
  if (!told) report.failures.clear();
  outputs.printed =
      options.as_json
          ? placement_json({shown, report}, options.candidates, told, requirements, beside)
          : for_people({shown, report}, options.candidates, requirements, beside);
  outputs.kept = std::all_of(requirements.begin(), requirements.end(),
                             [](const Requirement& each) { return each.kept; });
  return outputs;
}

}  // namespace

void cmd_place(const Arguments& arguments) {
  CommandLine line(
      "evenlift place",
      "Places teams of two robots, or any number of balanced ones, on a polygon, or judges robots that "
      "already stand.",
      "FILE is a path, - for standard input, or a share link. Its format is recognised by its content:\n"
      "the thesis's text, columns of numbers (CSV), SVG, DXF, WKT POLYGON, GeoJSON, or a result\n"
      "of --json. If it has several shapes, --shape selects one, or all.\n\n"
      "Examples:\n"
      "  evenlift place table.txt --teams 4 --svg table.svg\n"
      "  evenlift place drawing.dxf --shape 2\n"
      "  evenlift place drawing.dxf --shape all\n"
      "  evenlift place table.txt --metric circle --com 120,80 --json\n"
      "  evenlift place table.txt --metric balanced --robots 5\n"
      "  evenlift place table.txt --supports \"0,0 160,0 80,90\" --require \"stands, max<=40\"\n");
  PlaceOptions options;
  options.declare(line);
  if (!line.parse(arguments)) return;
  if (options.input.shapes.selects_all()) return place_all(options);

  if (options.table.typed())
    throw Failure{bad_input_status,
                  options.table.csv    ? "--csv"
                  : options.table.sort ? "--sort"
                                       : "--jobs",
                  "applies only to --shape all"};
  Input input = options.input.read();
  options.apply_weight(input.document);
  options.explain_weight(input.document.shown.units);
  const std::vector<Condition> conditions = options.conditions();
  const std::optional<PosesAsked> pose_file = options.poses.asked();
  check_outputs(options, pose_file);
  const Asked asked = asked_by(options.robustness, input.document.shown);
  Beside beside;
  if (options.even_out) beside.evened_out = even_out(input, options);
  const Outputs outputs =
      make_outputs(input, options, pose_file, asked, conditions, std::move(beside));
  if (outputs.svg) write_file(*options.svg, *outputs.svg);
  if (outputs.poses) write_file(pose_file->file, *outputs.poses);
  write_output(outputs.printed);
  if (!outputs.kept) throw Failure{not_kept_status, {}, {}, {}, true};
}

}  // namespace evenlift::native
