#include "input/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "evenlift/closest_name.h"
#include "input/files.h"

namespace evenlift::native {
namespace {

std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

}  // namespace

void print_failure(const Failure& failure) {
  if (failure.silent) return;
  const std::string where = failure.where.empty() ? "\"\"" : printable(failure.where);
  std::fprintf(stderr, "evenlift: %s: %s\n", where.c_str(), printable(failure.what).c_str());
  for (const std::string& line : failure.list)
    std::fprintf(stderr, "  %s\n", printable(line).c_str());
}

std::string system_message(const std::error_code& error) {
  std::string text = error.message();
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z')
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

Failure bad_value(const std::string& option, const std::string& expected,
                  const std::string& typed) {
  constexpr std::size_t most_quoted = 200;
  const bool quotes = typed.size() <= most_quoted;
  return {bad_input_status, option, expected + (quotes ? ", not \"" + typed + '"' : "")};
}

Failure bad_input(const std::string& source, const InputError& error) {
  const std::string place = describe(error.place);
  // A place in a link is complete in itself: "link, character 5".
  const bool alone = error.place.kind == Place::Kind::link;
  const std::string where = place.empty() ? source : alone ? place : source + ": " + place;
  return {bad_input_status, where, error.message};
}

namespace {

bool among(const std::vector<std::string>& options, const std::string& option) {
  return std::find(options.begin(), options.end(), option) != options.end();
}

// CLI11's layout, but the usage line lists arguments and options without "REQUIRED".
class Layout : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    std::string usage = "Usage: " + name;
    for (const CLI::Option* option : app->get_options())
      if (option->get_positional()) usage += " " + option->get_name(true);
    return usage + " [options]\n";
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() || option->get_positional()
               ? ""
               : " " + option->get_type_name();
  }
};

}  // namespace

CommandLine::CommandLine(const std::string& command, const std::string& purpose,
                         const std::string& examples)
    : app_(std::make_unique<CLI::App>(purpose, command)) {
  const auto layout = std::make_shared<Layout>();
  layout->column_width(26);
  app_->formatter(layout);
  app_->set_help_flag("-h,--help", "print this help and exit");
  app_->footer(examples);
  app_->allow_extras();
}

CommandLine::~CommandLine() = default;

void CommandLine::positional(std::string& into, const std::string& name, const std::string& help) {
  positionals_.push_back(name);
  app_->add_option(name, into, help)->type_name("");
}

void CommandLine::positionals(std::vector<std::string>& into, const std::string& name,
                              const std::string& help) {
  app_->add_option(name, into, help)->type_name("");
}

void CommandLine::value(std::optional<std::string>& into, const std::string& option,
                        const std::string& name, const std::string& help) {
  value_options_.push_back(option);
  app_->add_option_function<std::string>(
          option, [&into](const std::string& text) { into = text; }, help)
      ->type_name(name);
}

void CommandLine::alias(const std::string& other, const std::string& option) {
  aliases_[other] = option;
}

void CommandLine::flag(bool& into, const std::string& option, const std::string& help) {
  flags_.push_back(option);
  app_->add_flag(option, into, help);
}

// Joins each option and its value, which may begin with a minus (`--com -5,3`).
std::vector<std::string> CommandLine::joined(const std::vector<std::string>& arguments) const {
  std::vector<std::string> out, seen;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--") {  // only names follow, whatever their beginning
      out.insert(out.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i), arguments.end());
      break;
    }
    const std::string written = argument.substr(0, argument.find('='));
    const auto alias = aliases_.find(written);
    const std::string option = alias == aliases_.end() ? written : alias->second;
    const bool has_value = written.size() < argument.size();
    const bool takes_value = among(value_options_, option);
    if (!takes_value && !among(flags_, option)) {
      out.push_back(argument);
      continue;
    }
    if (among(seen, option)) throw Failure{bad_input_status, option, "given twice"};
    seen.push_back(option);
    if (!takes_value && has_value) throw Failure{bad_input_status, option, "takes no value"};
    if (!takes_value || has_value) {
      out.push_back(option + argument.substr(written.size()));
    } else {
      if (i + 1 == arguments.size())
        throw Failure{bad_input_status, option, "its value is missing"};
      out.push_back(option + "=" + arguments[++i]);
    }
    // CLI11 takes `--com=` for an option without a value.
    if (takes_value && out.back().size() == option.size() + 1)
      throw Failure{bad_input_status, option, "its value is empty"};
  }
  return out;
}

std::string CommandLine::advice_for(const std::string& option) const {
  const auto without_dashes = [](std::string_view name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
  };
  std::vector<std::string_view> known;
  for (const auto* options : {&value_options_, &flags_})
    for (const std::string& name : *options) known.push_back(without_dashes(name));
  const std::string typed = option.substr(0, option.find('='));
  const std::string_view similar = closest_name(without_dashes(typed), known);
  if (!similar.empty()) return "did you mean --" + std::string(similar) + "?";
  return "`" + app_->get_name() + " --help` lists them";
}

bool CommandLine::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> reversed = joined(arguments);
  std::reverse(reversed.begin(), reversed.end());
  try {
    app_->parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    write_output(app_->help());
    return false;
  } catch (const CLI::Error& error) {
    throw Failure{bad_input_status, "command line", error.what()};
  }
  for (const std::string& extra : app_->remaining()) {
    if (extra == "--") continue;
    const bool option = extra.size() > 1 && extra[0] == '-';
    throw Failure{bad_input_status, extra.substr(0, option ? extra.find('=') : std::string::npos),
                  option ? "unknown option; " + advice_for(extra) : "unexpected argument"};
  }
  for (const std::string& name : positionals_)
    if (app_->get_option(name)->empty())
      throw Failure{bad_input_status, name, "missing; see `" + app_->get_name() + " --help`"};
  return true;
}

}  // namespace evenlift::native
