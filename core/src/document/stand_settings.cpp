#include "document/stand_settings.h"

#include <algorithm>
#include <optional>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"

namespace evenlift {
namespace {

struct NamedSize {
  std::string_view name;
  double RobotSize::*value;
};
constexpr NamedSize sizes[] = {{"r", &RobotSize::radius},
                               {"reach", &RobotSize::reach},
                               {"depth", &RobotSize::depth},
                               {"width", &RobotSize::width},
                               {"gap", &RobotSize::gap}};

const NamedSize* size_of_name(std::string_view name) {
  for (const NamedSize& size : sizes)
    if (size.name == name) return &size;
  return nullptr;
}

// The hyphen between two numbers: neither a sign nor part of an exponent.
std::size_t find_hyphen(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i)
    if (text[i] == '-' && text[i - 1] != 'e' && text[i - 1] != 'E') return i;
  return std::string_view::npos;
}

bool is_part(const EdgePart& part) { return part.from >= 0 && part.from < part.to && part.to <= 1; }

std::optional<EdgePart> read_part(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::optional<std::uint64_t> edge = read_whole(text.substr(0, colon));
  if (!edge || *edge < 1 || *edge > max_vertices) return std::nullopt;
  EdgePart part;
  part.edge = static_cast<std::uint32_t>(*edge - 1);
  if (colon == std::string_view::npos) return part;
  text.remove_prefix(colon + 1);
  const std::size_t hyphen = find_hyphen(text);
  if (hyphen == std::string_view::npos) return std::nullopt;
  const std::optional<double> from = read_number(text.substr(0, hyphen)),
                              to = read_number(text.substr(hyphen + 1));
  if (!from || !to) return std::nullopt;
  part.from = *from + 0.0;  // -0 would make a different document
  part.to = *to;
  return is_part(part) ? std::optional(part) : std::nullopt;
}

}  // namespace

bool read_size(std::string_view text, double& size) {
  const std::optional<double> value = read_number(text);
  if (!value || !is_in_range(Setting::apart, *value)) return false;
  size = *value + 0.0;  // -0 would make a different document
  return true;
}

bool read_robot(std::string_view text, RobotSize& robot) {
  RobotSize read;
  unsigned named = 0;
  const bool good = text == "none" || for_each_word(text, [&](std::string_view word) {
                      const std::size_t equals = word.find('=');
                      if (equals == std::string_view::npos) return false;
                      const NamedSize* size = size_of_name(word.substr(0, equals));
                      if (!size || !read_size(word.substr(equals + 1), read.*(size->value)))
                        return false;
                      const unsigned bit = 1u << (size - sizes);
                      if (named & bit) return false;
                      named |= bit;
                      return true;
                    });
  if (good) robot = read;
  return good;
}

bool read_no_go(std::string_view text, std::vector<EdgePart>& no_go) {
  std::vector<EdgePart> read;
  const bool good = text == "none" || for_each_word(text, [&](std::string_view word) {
                      const std::optional<EdgePart> part = read_part(word);
                      if (part) read.push_back(*part);
                      return part && read.size() <= most_no_go;
                    });
  if (good) no_go = std::move(read);
  return good;
}

bool is_quotable(std::string_view part) {
  return part.size() <= 40 &&
         std::all_of(part.begin(), part.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

std::string_view refused_part(std::string_view text) {
  std::string_view refused;
  for_each_word(text, [&](std::string_view word) {
    if (read_part(word)) return true;
    refused = word;
    return false;
  });
  return is_quotable(refused) ? refused : std::string_view();
}

bool is_robot_size(const RobotSize& robot) {
  for (const NamedSize& size : sizes)
    if (!is_in_range(Setting::apart, robot.*(size.value))) return false;
  return true;
}

bool is_no_go(const std::vector<EdgePart>& no_go) {
  if (no_go.size() > most_no_go) return false;
  for (const EdgePart& part : no_go)
    if (!is_part(part)) return false;
  return true;
}

std::string robot_text(const RobotSize& robot) {
  std::string text;
  for (const NamedSize& size : sizes) {
    const double value = robot.*(size.value);
    if (value == 0) continue;
    text += (text.empty() ? "" : ",") + std::string(size.name) + '=' + shortest(value);
  }
  return text.empty() ? "none" : text;
}

std::string no_go_text(const std::vector<EdgePart>& no_go) {
  std::string text;
  for (const EdgePart& part : no_go) {
    text += (text.empty() ? "" : ",") + std::to_string(part.edge + 1);
    if (part.from != 0 || part.to != 1) text += ':' + shortest(part.from) + '-' + shortest(part.to);
  }
  return text.empty() ? "none" : text;
}

}  // namespace evenlift
