#include "options.h"

#include "evenlift/formats.h"

namespace evenlift::native {
namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

[[noreturn]] void refuse(const std::string& option, const std::string& expected,
                         const std::string& typed) {
  throw Failure{bad_input_status, option, "expected " + expected + ", not " + quoted(typed)};
}

double number_option(const std::string& option, const std::string& text) {
  const std::optional<double> value = read_number(text);
  if (!value) refuse(option, "a number", text);
  return *value;
}

std::optional<std::uint32_t> teams_option(const std::string& text) {
  if (text == "max") return std::nullopt;
  const std::optional<std::uint64_t> value = read_whole(text);
  if (!value || *value < 1 || *value > max_teams)
    refuse("--teams", "a whole number from 1 to " + std::to_string(max_teams) + ", or max", text);
  return static_cast<std::uint32_t>(*value);
}

Metric metric_option(const std::string& text) {
  const std::optional<Metric> metric = metric_from_name(text);
  if (!metric) refuse("--metric", "area, circle, distance, distributed or random", text);
  return *metric;
}

Vec2 com_option(const std::string& text) {
  const std::size_t comma = text.find(',');
  const std::optional<double> x = read_number(text.substr(0, comma));
  const std::optional<double> y =
      comma == std::string::npos ? std::nullopt : read_number(text.substr(comma + 1));
  if (!x || !y) refuse("--com", "two numbers X,Y", text);
  return {*x, *y};
}

// "min_ratio" is typed --min-ratio.
std::string as_typed(const std::string& setting) {
  std::string option = "--" + setting;
  for (char& c : option)
    if (c == '_') c = '-';
  return option;
}

}  // namespace

void SettingOptions::declare(CommandLine& line) {
  line.value(teams, "--teams", "N", "teams asked for, or max: every candidate (default 3)");
  line.value(metric, "--metric", "NAME", "area (default), circle, distance, distributed or random");
  line.value(min_ratio, "--min-ratio", "R", "minimum load ratio, 0 to 1 (default 0.8)");
  line.value(com, "--com", "X,Y", "centre of mass (default the file's, else the centroid)");
  line.value(weight, "--weight", "W", "the object's weight (default 100)");
  line.value(seed, "--seed", "S", "for the metric random (default 1)");
}

void SettingOptions::apply(Document& document) const {
  Settings& settings = document.settings;
  if (teams) settings.teams = teams_option(*teams);
  if (metric) settings.metric = metric_option(*metric);
  if (min_ratio) settings.min_ratio = number_option("--min-ratio", *min_ratio);
  if (com) document.centre_of_mass = com_option(*com);
  if (weight) settings.weight = number_option("--weight", *weight);
  if (seed) {
    const std::optional<std::uint64_t> value = read_whole(*seed);
    if (!value)
      refuse("--seed", "a whole number from 0 to " + std::to_string(~std::uint64_t{0}), *seed);
    settings.seed = *value;
  }
}

Failure SettingOptions::failure(const std::string& source, const InputError& error) const {
  if (error.place.kind == Place::Kind::option)
    return {bad_input_status, as_typed(error.place.option), error.message};
  if (error.place.kind == Place::Kind::centre_of_mass && com)
    return {bad_input_status, "--com", error.message};
  return bad_input(source, error);
}

}  // namespace evenlift::native
