#include <algorithm>
#include <iterator>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

#include "commands/commands.h"
#include "evenlift/experiment/outputs.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "experiment/experiment_run.h"
#include "input/options.h"

namespace evenlift::native {
namespace {

struct Options {
  std::vector<std::string> paths;
  std::optional<std::string> out, samples, min_ratio, max_teams, max_balanced, jobs, shard;
  std::optional<std::string> weight, cargo, robot;
  bool failures = false, merge = false;
};

std::uint32_t whole_option_32(const std::string& option, const std::string& text) {
  return static_cast<std::uint32_t>(whole_option(option, text, ~std::uint32_t{0}));
}

experiment::ExperimentSettings settings_of(const Options& options) {
  experiment::ExperimentSettings settings;
  if (options.samples) settings.samples = whole_option_32("--samples", *options.samples);
  if (options.max_teams) settings.most_teams = whole_option_32("--max-teams", *options.max_teams);
  if (options.max_balanced)
    settings.most_balanced = whole_option_32("--max-balanced", *options.max_balanced);
  Document document;
  for (const auto& [setting, text] : {std::pair(Setting::min_ratio, &options.min_ratio),
                                      {Setting::robot, &options.robot},
                                      {Setting::weight, &options.weight},
                                      {Setting::cargo, &options.cargo}})
    if (*text) setting_option(setting, **text, document);
  settings.min_ratio = document.settings.min_ratio;
  settings.robot = document.settings.robot;
  settings.failures = options.failures;
  if (options.weight || options.cargo) settings.weight.reset();
  if (const std::optional<InputError> error = experiment::check_settings(settings))
    throw SettingOptions{}.failure({}, *error);
  return settings;
}

experiment::Shard shard_of(const Options& options) {
  if (!options.shard) return {};
  const std::size_t slash = options.shard->find('/');
  const auto i = read_whole(options.shard->substr(0, slash));
  const auto n =
      slash == std::string::npos ? std::nullopt : read_whole(options.shard->substr(slash + 1));
  if (!i || !n || *i < 1 || *i > *n || *n > experiment::max_shards)
    throw bad_value(
        "--shard",
        "expected I/N, with I from 1 to N and N up to " + std::to_string(experiment::max_shards),
        *options.shard);
  return {static_cast<std::uint32_t>(*i), static_cast<std::uint32_t>(*n)};
}

constexpr const char* result_files[] = {"measurements.csv", "aggregates.csv", "polygons.csv",
                                        "times.csv",        "thesis.md",      "robots.md",
                                        "report.html"};

void check_out(const std::string& out, const std::vector<PolygonFile>& read) {
  if (out == "-") throw bad_value("--out", "expected the name of a folder", out);
  for (const char* name : result_files)
    for (const PolygonFile& file : read)
      if (is_same_file(file.path, out + "/" + name))
        throw Failure{bad_input_status, "--out",
                      "would overwrite " + file.path + ", an input file"};
}

// The same parts give the same bytes.
std::string write_results(std::vector<experiment::Part> parts, const ExperimentFolder& folder) {
  const experiment::ExperimentSettings settings =
      parts.empty() ? experiment::ExperimentSettings{} : parts.front().settings;
  const std::string times = experiment::times_csv(parts);
  std::vector<experiment::PolygonResult> results;
  std::size_t rows = 0;
  for (experiment::Part& part : parts) {
    rows += part.result.measurements.size();
    results.push_back(std::move(part.result));
  }
  const std::vector<experiment::ResultSet> sets = experiment::group_by_set(std::move(results));
  const experiment::Outputs outputs = experiment::make_outputs(sets);
  const std::string texts[] = {outputs.measurements_csv,
                               outputs.aggregates_csv,
                               outputs.polygons_csv,
                               times,
                               experiment::claims_markdown(outputs.claims),
                               experiment::few_robots_markdown(outputs.few_robots),
                               report_html(sets, outputs, settings)};
  static_assert(std::size(texts) == std::size(result_files));
  for (std::size_t i = 0; i < std::size(texts); ++i)
    write_file(folder.file(result_files[i]), texts[i]);
  return count_of(parts.size(), "polygon", "polygons") + ", " +
         count_of(rows, "measurement", "measurements") + ": " + folder.file("report.html") + "\n";
}

void report_refused(const std::vector<Failure>& refused, std::size_t polygons) {
  for (const Failure& failure : refused) print_failure(failure);
  if (!refused.empty())
    throw Failure{other_status, "experiment",
                  std::to_string(refused.size()) + " of " + std::to_string(polygons) +
                      " polygons could not be read and were left out"};
}

// Weight and cargo of every polygon; typed cargo is added to that of the file.
Loading loading_of(const Options& options) {
  return [&options](Document& document) {
    if (options.weight) setting_option(Setting::weight, *options.weight, document);
    if (options.cargo) add_cargo(*options.cargo, document);
  };
}

void run(const Options& options) {
  if (options.paths.empty())
    throw Failure{bad_input_status, "PATH", "missing; see `evenlift experiment --help`"};
  const experiment::ExperimentSettings settings = settings_of(options);
  const experiment::Shard shard = shard_of(options);
  const unsigned jobs = jobs_option(options.jobs);
  const std::vector<PolygonFile> files = find_polygon_files(options.paths);
  check_out(*options.out, files);
  const ExperimentFolder folder = ExperimentFolder::create(*options.out);
  const RunOutcome outcome =
      run_experiment(files, loading_of(options), shard, settings, jobs, folder);
  std::string said;
  if (outcome.resumed > 0)
    said = std::to_string(outcome.resumed) + " of " + std::to_string(outcome.polygons) +
           " polygons were already measured\n";
  if (shard == experiment::Shard{}) {
    said += write_results(collect({folder}), folder);
  } else {
    said += "shard " + std::to_string(shard.i) + " of " + std::to_string(shard.n) + ": " +
            count_of(outcome.polygons, "polygon", "polygons") +
            "; `evenlift experiment --merge` makes the report\n";
  }
  write_output(said);
  report_refused(outcome.refused, outcome.polygons);
}

void merge(const Options& options) {
  constexpr char is_measured[] = "not allowed with --merge: the shards are already measured";
  for (const auto& [option, given] :
       {std::pair("--samples", &options.samples), std::pair("--min-ratio", &options.min_ratio),
        std::pair("--max-teams", &options.max_teams),
        std::pair("--max-balanced", &options.max_balanced), std::pair("--jobs", &options.jobs),
        std::pair("--shard", &options.shard), std::pair("--weight", &options.weight),
        std::pair("--cargo", &options.cargo), std::pair("--robot", &options.robot)})
    if (*given) throw Failure{bad_input_status, option, is_measured};
  if (options.failures) throw Failure{bad_input_status, "--failures", is_measured};
  check_out(*options.out, {});
  std::vector<ExperimentFolder> folders;
  for (const std::string& path : options.paths) folders.push_back(ExperimentFolder::open(path));
  if (folders.empty()) folders.push_back(ExperimentFolder::open(*options.out));
  const std::vector<experiment::Part> parts = collect(folders);
  std::vector<Failure> refused;
  for (const experiment::Part& part : parts)
    if (!part.result.problem.empty())
      refused.push_back({other_status, part.result.polygon, part.result.problem});
  write_output(write_results(parts, ExperimentFolder::create(*options.out)));
  report_refused(refused, parts.size());
}

}  // namespace

void cmd_experiment(const Arguments& arguments) {
  CommandLine line(
      "evenlift experiment",
      "Measures every method with every number of robots on many polygons, as in chapter 5 of the\n"
      "thesis, and writes tables and a report with its figures.",
      "PATH is a polygon's file or a folder of polygons; each folder is a set with its own\n"
      "averages. Of a file with several shapes, all are measured. Measurements are kept in DIR/parts, so an interrupted run continues where\n"
      "it stopped.\n\n"
      "Examples:\n"
      "  evenlift experiment assets/polygons --out report\n"
      "  evenlift experiment assets/polygons assets/thesis-like --out report     (two sets)\n"
      "  evenlift experiment assets/polygons --out report --shard 2/8   (on the second of 8 machines)\n"
      "  evenlift experiment --merge --out report                       (when all 8 are done)\n");
  Options options;
  line.positionals(options.paths, "PATH", "polygons and folders; with --merge folders of shards");
  line.value(options.out, "--out", "DIR", "the folder to write to");
  line.value(options.samples, "--samples", "N",
             "number of random placements to average (default 200)");
  line.value(options.min_ratio, "--min-ratio", "R", "minimum load ratio, 0 to 1 (default 0.8)");
  line.value(options.max_teams, "--max-teams", "N",
             "greatest number of teams to measure (default 1000)");
  line.value(options.max_balanced, "--max-balanced", "M",
             "greatest number of balanced robots to measure, 2 to 64 (default 12)");
  line.value(options.weight, "--weight", "W",
             "the weight of every object (default 100; with --cargo its own)");
  line.value(options.cargo, "--cargo", "\"X,Y:W[:NAME] ...\"",
             "loads fixed to every object, added to those of the files");
  line.value(options.robot, "--robot", "r=R,reach=G,...",
             "size of a robot, as for place; distributed and random have none");
  line.flag(options.failures, "--failures",
            "also measure whether any one robot may fail, and the greatest load then");
  line.value(options.jobs, "--jobs", "N", "number of threads (default one for each processor)");
  line.value(options.shard, "--shard", "I/N", "measure only the I-th of N parts of the work");
  line.flag(options.merge, "--merge",
            "only make the report, from the shards in the PATHs or in DIR");
  if (!line.parse(arguments)) return;
  if (!options.out)
    throw Failure{bad_input_status, "--out", "missing; it names the folder to write to"};
  options.merge ? merge(options) : run(options);
}

}  // namespace evenlift::native
