#include "set_settings.h"

#include <charconv>
#include <cstdlib>
#include <string>

#include "evenlift/placement.h"

namespace evenlift::view {
namespace {

InputError wrong(std::string_view setting, const char* message) {
  return {ErrorCode::bad_setting, message, {Place::Kind::option, 0, 0, std::string(setting)}};
}

std::optional<double> number(std::string_view text) {
  const std::string digits(text);
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end);
  if (digits.empty() || *end != '\0') return std::nullopt;
  return value;
}

template <class Integer>
std::optional<Integer> whole(std::string_view text) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Each setter reads its value into the document, or returns what it expects instead.
const char* set_teams(Document& document, std::string_view value) {
  const auto teams = whole<std::uint32_t>(value);
  if (!teams && value != "max") return "must be a whole number from 1, or \"max\"";
  document.settings.teams = teams;
  return nullptr;
}

const char* set_metric(Document& document, std::string_view value) {
  const auto metric = metric_from_name(value);
  if (!metric) return "must be area, circle, distance, distributed or random";
  document.settings.metric = *metric;
  return nullptr;
}

const char* set_number(double& target, std::string_view value) {
  const auto read = number(value);
  if (!read) return "must be a number";
  target = *read;
  return nullptr;
}

const char* set_min_ratio(Document& document, std::string_view value) {
  return set_number(document.settings.min_ratio, value);
}

const char* set_weight(Document& document, std::string_view value) {
  return set_number(document.settings.weight, value);
}

const char* set_seed(Document& document, std::string_view value) {
  const auto seed = whole<std::uint64_t>(value);
  if (!seed) return "must be a whole number from 0";
  document.settings.seed = *seed;
  return nullptr;
}

const char* set_com(Document& document, std::string_view value) {
  if (value == "centroid") {
    document.centre_of_mass.reset();
    return nullptr;
  }
  const std::size_t comma = value.find(',');
  const auto x = number(value.substr(0, comma));
  const auto y = comma == std::string_view::npos ? std::nullopt : number(value.substr(comma + 1));
  if (!x || !y) return "must be two numbers, or null for the centroid";
  document.centre_of_mass = Vec2(*x, *y);
  return nullptr;
}

const char* set_step(Document& document, std::string_view value) {
  const auto step = whole<std::uint32_t>(value);
  if (!step && value != "none") return "must be a whole number from 0, or null";
  document.settings.step = step;
  return nullptr;
}

struct Setter {
  std::string_view name;
  const char* (*set)(Document&, std::string_view);
};
constexpr Setter setters[] = {
    {"teams", set_teams},   {"metric", set_metric}, {"min_ratio", set_min_ratio},
    {"weight", set_weight}, {"seed", set_seed},     {"com", set_com},
    {"step", set_step},
};

}  // namespace

Result<Document> with_settings(const Document& document, std::string_view lines) {
  Document changed = document;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    const std::size_t equals = line.find('=');
    const std::string_view name = line.substr(0, equals);
    const Setter* setter = nullptr;
    for (const Setter& known : setters) {
      if (known.name == name) setter = &known;
    }
    if (!setter || equals == std::string_view::npos) return wrong(name, "there is no such setting");
    if (const char* problem = setter->set(changed, line.substr(equals + 1)))
      return wrong(name, problem);
  }
  if (const auto error = check_settings(changed.settings)) return *error;
  return changed;
}

}  // namespace evenlift::view
