#include "input/options.h"

#include "evenlift/numbers.h"

namespace evenlift::native {
namespace {

// "min_ratio" is typed --min-ratio.
std::string as_typed(std::string_view setting) { return "--" + hyphened(setting); }

// Why a setting has no effect with the others; empty if it has one.
std::string why_unused(const SettingRow& row, const Settings& settings) {
  if (row.setting == Setting::teams && settings.method == Method::balanced)
    return "balanced robots do not form teams; give --robots";
  if (counts(row.counts_for, settings)) return {};
  const std::string method(name(settings.method));
  switch (row.counts_for) {
    case CountsFor::all:
      break;
    case CountsFor::candidates:
      return "applies only to --metric area, circle and distance, not to " + method;
    case CountsFor::hold_requirements:
      return "applies only to --goal hold";
    case CountsFor::balanced:
      return "applies only to --metric balanced, not to " + method;
  }
  return {};
}

template <class Value>
Value value_or_refusal(Setting setting, const std::optional<Value>& value,
                       const std::string& text) {
  if (!value) throw bad_value(as_typed(name(setting)), requirement(setting), text);
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
    const std::string option = as_typed(name(setting));
    // For a list, the error quotes the invalid part.
    if (error->message != requirement(setting))
      throw Failure{bad_input_status, option, error->message};
    throw bad_value(option, error->message, text);
  }
}

LoadModel loads_option(const std::string& text) {
  return value_or_refusal(Setting::loads, load_model_from_name(text), text);
}

void SettingOptions::declare(CommandLine& line, OptionGroup group) {
  for (const SettingRow& row : all_settings())
    if (row.option.group == group) {
      line.value(typed_[static_cast<std::size_t>(row.setting)], as_typed(row.name),
                 std::string(row.option.value), std::string(row.option.help));
      if (!row.alias.empty()) line.alias(as_typed(row.alias), as_typed(row.name));
    }
}

void SettingOptions::apply(Document& document) const {
  for (const SettingRow& row : all_settings())
    if (typed(row.setting)) setting_option(row.setting, *typed(row.setting), document);
  for (const SettingRow& row : all_settings())
    if (typed(row.setting))
      if (const std::string why = why_unused(row, document.settings); !why.empty())
        throw Failure{bad_input_status, as_typed(row.name), why};
}

void InputOptions::declare(CommandLine& line, const std::string& help) {
  line.positional(file, "FILE", help);
  settings.declare(line, OptionGroup::placement);
  shapes.declare(line);
}

Input InputOptions::read() const {
  Input input = read_input(file, shapes);
  settings.apply(input.document);
  return input;
}

Failure SettingOptions::failure(const std::string& source, const InputError& error) const {
  if (error.place.kind == Place::Kind::option)
    return {bad_input_status, as_typed(error.place.option), error.message};
  if (error.place.kind == Place::Kind::centre_of_mass && typed(Setting::com))
    return {bad_input_status, "--com", error.message};
  return bad_input(source, error);
}

}  // namespace evenlift::native
