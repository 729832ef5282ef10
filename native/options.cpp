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

template <class Value>
Value value_or_refusal(Setting setting, const std::optional<Value>& value,
                       const std::string& text) {
  if (!value) throw bad_value(as_typed(std::string(name(setting))), requirement(setting), text);
  return *value;
}

}  // namespace

std::uint64_t whole_option(const std::string& option, const std::string& text, std::uint64_t most) {
  const std::optional<std::uint64_t> value = read_whole(text);
  if (!value || *value > most) throw bad_value(option, "expected a whole number", text);
  return *value;
}

void setting_option(Setting setting, const std::string& text, Document& document) {
  if (const auto error = read_setting(setting, text, document)) {
    const std::string option = as_typed(std::string(name(setting)));
    // Of a list the error quotes what is wrong in it.
    if (error->message != requirement(setting))
      throw Failure{bad_input_status, option, error->message};
    throw bad_value(option, error->message, text);
  }
}

LoadModel loads_option(const std::string& text) {
  return value_or_refusal(Setting::loads, load_model_from_name(text), text);
}

void SettingOptions::declare(CommandLine& line) {
  line.value(teams, "--teams", "N", "teams asked for, or max: every candidate (default 3)");
  line.value(metric, "--metric", "NAME",
             "area (default), circle, distance, distributed, random or balanced");
  line.value(min_ratio, "--min-ratio", "R", "minimum load ratio, 0 to 1 (default 0.8)");
  line.value(com, "--com", "X,Y", "centre of mass (default the file's, else the centroid)");
  line.value(weight, "--weight", "W", "the object's weight (default 100)");
  line.value(seed, "--seed", "S", "for the metric random (default 1)");
  line.value(robots, "--robots", "M", "number of balanced robots, 2 to 64 (default 6)");
  line.value(goal, "--goal", "GOAL", "cover: the widest base; hold: first of all a firm hold");
  line.value(min_margin, "--min-margin", "F", "the margin of a firm hold (default 0.05)");
  line.value(positions, "--positions", "WHERE",
             "best: one place for two edges; range: anywhere in their range");
  line.value(apart, "--apart", "A",
             "robots nearer than this are too near (default 0.12 of the object's radius)");
  line.value(
      clear, "--clear", "K",
      "distances below are not relied on: of contacts from corners, and of the centre of mass "
      "from the base's edge after a failure (default 0.02 of the object's radius)");
  line.value(
      robot, "--robot", "r=R,reach=G,...",
      "the robots' size: r, reach, and depth and width of the hand, and the gap between robots");
  line.value(no_go, "--no-go", "E[:FROM-TO],...",
             "edges from 1, or parts of them from 0 to 1, that no robot may touch");
  line.value(survive, "--survive", "F", "failures that balanced robots should survive (default 0)");
}

void SettingOptions::apply(Document& document) const {
  for (const auto& [setting, typed] :
       {std::pair(Setting::teams, &teams), std::pair(Setting::method, &metric),
        std::pair(Setting::min_ratio, &min_ratio), std::pair(Setting::com, &com),
        std::pair(Setting::weight, &weight), std::pair(Setting::seed, &seed),
        std::pair(Setting::robots, &robots), std::pair(Setting::goal, &goal),
        std::pair(Setting::min_margin, &min_margin), std::pair(Setting::apart, &apart),
        std::pair(Setting::clear, &clear), std::pair(Setting::survive, &survive),
        std::pair(Setting::positions, &positions), std::pair(Setting::robot, &robot),
        std::pair(Setting::no_go, &no_go)})
    if (*typed) setting_option(setting, **typed, document);
  check_method(document.settings);
}

void SettingOptions::check_method(const Settings& settings) const {
  const Method method = settings.method;
  const bool balanced = method == Method::balanced;
  if (balanced && teams)
    throw Failure{bad_input_status, "--teams", "balanced robots are no teams; give --robots"};
  if (positions && !selects_candidates(method))
    throw Failure{
        bad_input_status, "--positions",
        "it is for --metric area, circle and distance, not for " + std::string(name(method))};
  if (balanced) return;
  for (const auto& [option, typed] : {std::pair("--robots", &robots), std::pair("--apart", &apart),
                                      std::pair("--survive", &survive)})
    if (*typed)
      throw Failure{bad_input_status, option,
                    "it is for --metric balanced, not for " + std::string(name(method))};
  if (min_margin && goal_of(settings) != Goal::hold)
    throw Failure{bad_input_status, "--min-margin", "it is for --goal hold"};
}

void InputOptions::declare(CommandLine& line, const std::string& help) {
  line.positional(file, "FILE", help);
  settings.declare(line);
  shapes.declare(line);
}

Input InputOptions::read() const {
  Input input = read_input(file, shapes);
  settings.apply(input.document);
  return input;
}

void DoubtOptions::declare(CommandLine& line) {
  line.value(capacity, "--capacity", "K",
             "what one robot can carry: who is overloaded, and how many are needed");
  line.value(com_radius, "--com-radius", "E",
             "the centre of mass is known within E only: loads as ranges");
}

void DoubtOptions::apply(Document& document) const {
  if (capacity) setting_option(Setting::capacity, *capacity, document);
  if (com_radius) setting_option(Setting::com_radius, *com_radius, document);
}

void UnitOptions::declare(CommandLine& line) {
  line.value(unit, "--unit", "U", "label of lengths: m, cm, mm or in (default none)");
  line.value(weight_unit, "--weight-unit", "U", "label of weights: kg (default), t, N or lb");
}

void UnitOptions::apply(Document& document) const {
  if (unit) setting_option(Setting::unit, *unit, document);
  if (weight_unit) setting_option(Setting::weight_unit, *weight_unit, document);
}

Failure SettingOptions::failure(const std::string& source, const InputError& error) const {
  if (error.place.kind == Place::Kind::option)
    return {bad_input_status, as_typed(error.place.option), error.message};
  if (error.place.kind == Place::Kind::centre_of_mass && com)
    return {bad_input_status, "--com", error.message};
  return bad_input(source, error);
}

}  // namespace evenlift::native
