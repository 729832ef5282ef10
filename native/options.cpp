#include "options.h"

#include "evenlift/numbers.h"

namespace evenlift::native {
namespace {

// "min_ratio" is typed --min-ratio.
std::string as_typed(const std::string& setting) {
  std::string option = "--" + setting;
  for (char& c : option)
    if (c == '_') c = '-';
  return option;
}

Failure refused(const std::string& option, const std::string& what, const std::string& typed) {
  return {bad_input_status, option, what + ", not \"" + typed + "\""};
}

}  // namespace

std::uint64_t whole_option(const std::string& option, const std::string& text, std::uint64_t most) {
  const std::optional<std::uint64_t> value = read_whole(text);
  if (!value || *value > most) throw refused(option, "expected a whole number", text);
  return *value;
}

void setting_option(Setting setting, const std::string& text, Document& document) {
  if (const auto error = read_setting(setting, text, document))
    throw refused(as_typed(std::string(name(setting))), error->message, text);
}

double capacity_option(const std::string& text) {
  const std::optional<double> capacity = read_capacity(text);
  if (!capacity) throw refused("--capacity", requirement(Setting::capacity), text);
  return *capacity;
}

void SettingOptions::declare(CommandLine& line) {
  line.value(teams, "--teams", "N", "teams asked for, or max: every candidate (default 3)");
  line.value(metric, "--metric", "NAME", "area (default), circle, distance, distributed or random");
  line.value(min_ratio, "--min-ratio", "R", "minimum load ratio, 0 to 1 (default 0.8)");
  line.value(com, "--com", "X,Y", "centre of mass (default the file's, else the centroid)");
  line.value(weight, "--weight", "W", "the object's weight (default 100)");
  line.value(seed, "--seed", "S", "for the metric random (default 1)");
}

void SettingOptions::apply(Document& document) const {
  for (const auto& [setting, typed] :
       {std::pair(Setting::teams, &teams), std::pair(Setting::method, &metric),
        std::pair(Setting::min_ratio, &min_ratio), std::pair(Setting::com, &com),
        std::pair(Setting::weight, &weight), std::pair(Setting::seed, &seed)})
    if (*typed) setting_option(setting, **typed, document);
}

Failure SettingOptions::failure(const std::string& source, const InputError& error) const {
  if (error.place.kind == Place::Kind::option)
    return {bad_input_status, as_typed(error.place.option), error.message};
  if (error.place.kind == Place::Kind::centre_of_mass && com)
    return {bad_input_status, "--com", error.message};
  return bad_input(source, error);
}

}  // namespace evenlift::native
